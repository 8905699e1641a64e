// The verb `check`: assertions to verdicts.
#include <fmt/format.h>

#include <new>

#include "app/bounds.hpp"
#include "app/interrupt.hpp"
#include "app/sizes.hpp"
#include "app/verbs.hpp"
#include "checker/cspm/session.hpp"

namespace robochart::app {
namespace {

using csp_emit::Time;

struct Context {
    Project& project;
    const Options& options;
    const csp_emit::Emission& emission;
    cspm::Session& session;
};

void add(refine::Statistics& sum, const refine::Statistics& one) {
    sum.states += one.states;
    sum.transitions += one.transitions;
    sum.depth = std::max(sum.depth, one.depth);
    sum.spec_nodes += one.spec_nodes;
    sum.seconds += one.seconds;
}

std::vector<std::string> raw_events(const refine::Counterexample& c, const process::EventTable& events) {
    std::vector<std::string> names;
    for (const refine::Step& step : c.steps) {
        const bool hidden = step.event == process::tau && step.revealed != process::tau;
        names.push_back(hidden ? fmt::format("τ({})", events.name(step.revealed)) : events.name(step.event));
    }
    return names;
}

/// Whether the loop of a divergence lets time pass: behind it stands the check for deadlocks in time.
bool time_passes(const Context& context, const refine::Counterexample& c) {
    return std::any_of(c.loop.begin(), c.loop.end(),
                       [&](const refine::Step& step) { return context.session.event_table().name(step.revealed) == "tock"; });
}

/// What is wrong in the claim's words; "" where the checker's are right.
std::string violation(const Context& context, const csp_emit::Obligation& obligation, const refine::Counterexample& c,
                      const StoryTeller& teller) {
    switch (obligation.kind) {
        case ir::PropertyKind::reachable: return "the state has been reached";
        case ir::PropertyKind::deadlock_free:
            return time_passes(context, c) ? "nothing is possible any more but that time passes" : "";
        case ir::PropertyKind::timelock_free: return teller.why_time_stops(c);
        case ir::PropertyKind::terminates: return obligation.negated ? "it has terminated" : "";
        case ir::PropertyKind::clock_initialised: return obligation.one_suffices ? obligation.reason : "the clock is read before its first reset";
        default: return "";
    }
}

std::string told(const Context& context, const csp_emit::Obligation& obligation, const refine::Counterexample& c) {
    const StoryTeller teller(context.emission.provenance, context.project.system, context.project.instantiation,
                             context.project.sources, context.session.event_table());
    Story story = teller.tell(c);
    if (const std::string why = violation(context, obligation, c, teller); !why.empty()) story.why = why;
    return render(story, "                 ");
}

void take(const Context& context, const csp_emit::Obligation& obligation, const refine::Verdict& verdict, AssertionReport& report) {
    add(report.statistics, verdict.statistics);
    if (verdict.outcome == refine::Outcome::inconclusive) {
        report.answer = Answer::inconclusive;
        report.reason = verdict.reason;
    } else if (verdict.outcome == refine::Outcome::fails) {
        report.answer = Answer::fails;
        if (verdict.counterexample) {
            report.counterexample = told(context, obligation, *verdict.counterexample);
            report.raw = raw_events(*verdict.counterexample, context.session.event_table());
        }
    }
}

/// The element of the model that a call of the script stands for: `S::A__(0,1)` for the place of S in A.
const csp_emit::DefinitionMeaning* meaning_of(const csp_emit::Emission& emission, const std::string& call) {
    const auto found = emission.provenance.definitions.find(call.substr(0, call.find('(')));
    return found == emission.provenance.definitions.end() ? nullptr : &found->second;
}

/// What cannot be evaluated, with its place; where the place is not the model's or a block's, with that of the element in
/// whose definition it is.
std::string said(const Project& project, const csp_emit::Emission& emission, const cspm::EvaluationError& error) {
    const std::string place = project.sources.place(error.span);
    std::string text = place.empty() ? error.what() : fmt::format("{}: {}", place, error.what());
    for (const std::string& call : error.stack)
        if (const csp_emit::DefinitionMeaning* meaning = meaning_of(emission, call)) {
            const std::string element = meaning->origin.element.empty() ? meaning->text : meaning->origin.element;
            const std::string at = project.sources.place(meaning->origin.span);
            return fmt::format("{} ({}, {}{}{})", text, element, meaning->text, at.empty() ? "" : ", ", at);
        }
    return text;
}

/// One assertion of an obligation: its answer, with its counterexample where it fails.
void decide_one(const Context& context, const csp_emit::Obligation& obligation, const cspm::Decl& assertion, AssertionReport& report) {
    report.answer = Answer::holds;
    try {
        take(context, obligation, context.session.check(assertion, limits(context.options)).verdict, report);
    } catch (const cspm::EvaluationError& error) {
        report.answer = Answer::error;
        report.reason = said(context.project, context.emission, error);
    } catch (const std::bad_alloc&) {
        report.answer = Answer::inconclusive;
        report.reason = "out of memory";
    }
}

/// All assertions must hold: the first that does not ends it. Or one suffices: the first that holds does, and only if
/// each of them fails the claim does.
void decide(const Context& context, const csp_emit::Obligation& obligation, AssertionReport& report) {
    const InterruptScope scope;
    for (const cspm::DeclPtr& assertion : obligation.assertions) {
        const bool unknown = report.answer == Answer::inconclusive && !report.reason.empty();
        const std::string reason = report.reason;
        decide_one(context, obligation, *assertion, report);
        if (report.answer == Answer::error || (report.answer == Answer::holds) == obligation.one_suffices) break;
        if (unknown) {
            report.answer = Answer::inconclusive;
            report.reason = reason;
        }
    }
    if (report.answer == Answer::holds) report.reason.clear();
    if (report.answer == Answer::fails && report.counterexample.empty()) report.reason = obligation.reason;
}

bool wanted(const Context& context, const csp_emit::Obligation& obligation) {
    if (context.options.assertion.empty()) return true;
    return obligation.property != ir::no_id && context.project.system.properties[obligation.property].name == context.options.assertion;
}

/// A script that names what does not exist is bad input: reported once for all its claims.
std::unique_ptr<cspm::Session> open(const Project& project, const csp_emit::Emission& emission, Time time, Report& report) {
    try {
        return std::make_unique<cspm::Session>(emission.script);
    } catch (const cspm::EvaluationError& error) {
        AssertionReport one;
        one.title = fmt::format("the {} script", time == Time::timed ? "timed" : "untimed");
        one.answer = Answer::error;
        one.reason = said(project, emission, error);
        report.assertions.push_back(std::move(one));
        return nullptr;
    }
}

void check_time(Project& project, const Options& options, Time time, Report& report) {
    const csp_emit::Emission emission = emit_csp(project, options, time);
    if (!project.diagnostics.ok() || (emission.obligations.empty() && !options.sizes)) return;
    const std::unique_ptr<cspm::Session> session = open(project, emission, time, report);
    if (!session) return;
    BoundWatch bounds(project, emission, time, report.bounds);
    session->observe(bounds.observer());
    const Context context{project, options, emission, *session};
    for (const csp_emit::Obligation& obligation : emission.obligations) {
        if (!wanted(context, obligation)) continue;
        AssertionReport one;
        one.title = obligation.title;
        if (obligation.property != ir::no_id) one.place = project.sources.place(project.system.properties[obligation.property].origin.span);
        if (obligation.assertions.empty()) {
            one.answer = Answer::no_check;
            one.reason = obligation.reason;
        } else {
            decide(context, obligation, one);
        }
        report.assertions.push_back(std::move(one));
    }
    if (options.sizes) measure_sizes(*session, emission, time, options, report);
}

/// Assertions of other tools (RC-P33): said, and no success.
void report_foreign(const Project& project, const Options& options, Report& report) {
    for (const diagnostics::Diagnostic& finding : project.diagnostics.sorted()) {
        if (finding.rule->code != "RC-P33") continue;
        if (!options.assertion.empty() && finding.arguments.front() != options.assertion) continue;
        AssertionReport one;
        one.title = finding.arguments.front();
        one.place = project.sources.place(finding.span);
        one.answer = Answer::error;
        one.reason = fmt::format("{}: {}", one.place, finding.message());
        report.assertions.push_back(std::move(one));
    }
}

}  // namespace

void check_assertions(Project& project, const Options& options, Report& report) {
    report_foreign(project, options, report);
    if (options.times != Times::timed) check_time(project, options, Time::untimed, report);
    if (options.times != Times::untimed && project.diagnostics.ok()) check_time(project, options, Time::timed, report);
}

}  // namespace robochart::app
