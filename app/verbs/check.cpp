// The verb `check`: assertions to verdicts.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <new>
#include <optional>

#include "app/command/limits.hpp"
#include "app/command/run.hpp"
#include "app/report/bounds.hpp"
#include "app/report/element_at.hpp"
#include "app/report/sizes.hpp"
#include "app/verbs/verbs.hpp"
#include "checker/cspm/session.hpp"
#include "diagnostics/escape.hpp"
#include "frontend/syntax/syntax_rules.hpp"
#include "runs/exercised.hpp"
#include "runs/interpreter.hpp"

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

void take(const Context& context, const csp_emit::Obligation& obligation, const refine::Verdict& verdict,
          AssertionReport& report) {
    add(report.statistics, verdict.statistics);
    report.searched = report.searched || !verdict.known;
    if (verdict.outcome == refine::Outcome::inconclusive) {
        report.answer = Answer::inconclusive;
        report.reason = verdict.reason;
    } else if (verdict.outcome == refine::Outcome::fails) {
        report.answer = Answer::fails;
        const runs::Context reading{context.emission.provenance, context.project.system, context.project.instantiation,
                                    context.project.sources, context.session};
        if (verdict.counterexample) report.run = runs::interpret(reading, obligation, *verdict.counterexample);
    }
}

/// What cannot be evaluated, with its place and the element of the model that it is in.
std::string said(const Project& project, const cspm::EvaluationError& error) {
    const std::string place = project.sources.place(error.span);
    if (place.empty()) return error.what();
    const std::string element = element_at(project.system, error.span);
    return fmt::format("{}: {}{}{}", diagnostics::shown(place), error.what(), element.empty() ? "" : ", in ", element);
}

/// One assertion of an obligation: its answer, with its counterexample where it fails.
void decide_one(const Context& context, const csp_emit::Obligation& obligation, const cspm::Decl& assertion,
                AssertionReport& report) {
    report.answer = Answer::holds;
    try {
        take(context, obligation, context.session.check(assertion, limits(context.options)).verdict, report);
    } catch (const cspm::EvaluationError& error) {
        report.answer = Answer::error;
        report.reason = said(context.project, error);
    } catch (const std::bad_alloc&) {
        report.answer = Answer::inconclusive;
        report.reason = "out of memory";
    }
}

/// A state of a term takes long beside one of a compiled machine.
constexpr std::uint64_t most_states_for_firing = 20'000;

/// Which transitions fire, by a visit of all states.
void decide_firing(const Context& context, const csp_emit::FiringQuestion& question, AssertionReport& report) {
    const runs::Context reading{context.emission.provenance, context.project.system, context.project.instantiation,
                                context.project.sources, context.session};
    runs::StepReader reader(reading);
    try {
        const auto found = runs::exercised(reader, context.session.process(question.process), most_states_for_firing,
                                           [&] { context.options.run->budget().poll(); });
        report.statistics.states = found.states;
        report.searched = true;
        std::vector<std::string> never;
        for (const csp_emit::TransitionInside& each : question.transitions)
            if (!found.elements.contains(runs::exercised_element(each.component, each.origin.element)))
                never.push_back(fmt::format("{} ({})", each.text, context.project.sources.place(each.origin.span)));
        report.answer = never.empty() ? Answer::holds : found.all ? Answer::fails : Answer::inconclusive;
        if (!never.empty()) report.reason = fmt::format("never taken: {}", fmt::join(never, ", "));
        if (report.answer == Answer::inconclusive)
            report.reason = fmt::format("{} has not been taken in the first {} states", never.front(), found.states);
    } catch (const cspm::EvaluationError& error) {
        report.answer = Answer::error;
        report.reason = said(context.project, error);
    } catch (const process::SemanticsError& error) {
        report.answer = Answer::error;
        report.reason = error.what();
    }
}

/// All assertions must hold: the first that does not ends it. Or one suffices: the first that holds does, and only if
/// each of them fails the claim does; where one of them is not known and none holds, nothing is known of the claim.
void decide(const Context& context, const csp_emit::Obligation& obligation, AssertionReport& report) {
    std::optional<std::string> unknown;  // why the first that is not known is not
    for (const cspm::DeclPtr& assertion : obligation.assertions) {
        decide_one(context, obligation, *assertion, report);
        if (report.answer == Answer::inconclusive && !unknown) unknown = report.reason;
        if (report.answer == Answer::error || (report.answer == Answer::holds) == obligation.one_suffices) break;
    }
    if (report.answer == Answer::holds) {
        report.reason.clear();
        report.run.reset();
    } else if (unknown) {
        report.answer = Answer::inconclusive;
        report.reason = *unknown;
        report.run.reset();
    }
    if (report.answer == Answer::fails && !report.run) report.reason = obligation.reason;
}

bool wanted(const Context& context, const csp_emit::Obligation& obligation) {
    if (context.options.assertion.empty()) return true;
    return obligation.property != ir::no_id &&
           context.project.system.properties[obligation.property].name == context.options.assertion;
}

void set_place(const Project& project, diagnostics::Span span, AssertionReport& report) {
    report.place = project.sources.place(span);
    if (!span.known()) return;
    const diagnostics::Position begin = project.sources.position(span.source, span.begin);
    const diagnostics::Position end = project.sources.position(span.source, span.end);
    report.region = runs::Place{project.sources.path(span.source), begin.line, begin.column, end.line, end.column};
}

/// The report lists everything to be decided from the beginning, as not decided.
void announce(const Context& context, Report& report) {
    const auto edit = context.options.run->edit();
    for (const csp_emit::Obligation& obligation : context.emission.obligations) {
        if (!wanted(context, obligation)) continue;
        AssertionReport one;
        one.title = context.project.label + obligation.title;
        if (obligation.property != ir::no_id)
            set_place(context.project, context.project.system.properties[obligation.property].origin.span, one);
        if (!obligation.component.empty()) {
            one.core = CoreReport{context.project.label + obligation.component, obligation.property_text,
                                  obligation.information};
            if (obligation.origin.span.known()) set_place(context.project, obligation.origin.span, one);
        }
        const bool decidable = obligation.firing || !obligation.assertions.empty();
        one.answer = decidable ? Answer::inconclusive : Answer::no_check;
        one.reason = decidable ? not_decided : obligation.reason;
        report.assertions.push_back(std::move(one));
    }
}

/// A script that names what does not exist is bad input: reported once for all its claims.
std::unique_ptr<cspm::Session> open(const Project& project, const csp_emit::Emission& emission, Time time,
                                    const Options& options, Report& report) {
    try {
        auto session = std::make_unique<cspm::Session>(emission.script, &options.run->budget());
        if (diagnostics::Cache* const cache = options.run->cache()) session->remember(*cache);
        return session;
    } catch (const cspm::EvaluationError& error) {
        AssertionReport one;
        one.title = fmt::format("{}the {} script", project.label, time == Time::timed ? "timed" : "untimed");
        one.answer = Answer::error;
        one.reason = said(project, error);
        const auto edit = options.run->edit();
        report.assertions.push_back(std::move(one));
        return nullptr;
    }
}

/// Assertions that csp blocks have as text are the script's, and not decided here: that is said.
void note_assertions_of_blocks(const Context& context, Time time, Report& report) {
    std::size_t ours = 0;
    for (const csp_emit::Obligation& each : context.emission.obligations) ours += each.assertions.size();
    const std::size_t all = context.session.assertions().size();
    if (all <= ours) return;
    const auto edit = context.options.run->edit();
    report.notes.push_back(fmt::format(
        "{}not decided here: {} assert line{} in csp blocks [{}]; `emit csp` writes them, and `cspm` decides them",
        context.project.label, all - ours, all - ours == 1 ? "" : "s", time == Time::timed ? "timed" : "untimed"));
}

void check_time(Project& project, const Options& options, Time time, Report& report) {
    const csp_emit::Emission& emission = emit_csp(project, options, time);
    if (!project.diagnostics.ok() || (emission.obligations.empty() && !options.sizes)) return;
    const std::unique_ptr<cspm::Session> session = open(project, emission, time, options, report);
    if (!session) return;
    std::vector<BoundReport> bounds_met = report.bounds;
    BoundWatch bounds(project, emission, time, bounds_met);
    session->observe(bounds.observer());
    const Context context{project, options, emission, *session};
    note_assertions_of_blocks(context, time, report);
    std::size_t at = report.assertions.size();
    announce(context, report);
    for (const csp_emit::Obligation& obligation : emission.obligations) {
        if (!wanted(context, obligation)) continue;
        const diagnostics::Budget::Phase phase(options.run->budget(), "deciding " + obligation.title);
        AssertionReport one = report.assertions[at];
        if (obligation.firing) {
            one.reason.clear();
            decide_firing(context, *obligation.firing, one);
        } else if (!obligation.assertions.empty()) {
            one.reason.clear();
            decide(context, obligation, one);
        }
        const auto edit = options.run->edit();
        report.assertions[at++] = std::move(one);
        report.bounds = bounds_met;
    }
    if (options.sizes) measure_sizes(project, *session, emission, time, options, report);
}

/// Claims of kinds that nothing here decides: each is said, and none of them is a success.
void report_unchecked(const Project& project, const Options& options, Report& report) {
    for (const auto& file : project.model->files)
        for (const frontend::KeptPart& part : file->kept) {
            if (!part.claims || (!options.assertion.empty() && part.name != options.assertion)) continue;
            AssertionReport one;
            one.title = project.label + part.name;
            set_place(project, part.span, one);
            one.answer = Answer::unchecked;
            one.reason =
                fmt::format("{}: not checked: {}", diagnostics::shown(one.place),
                            part.probabilistic ? "probabilistic" : fmt::format("`{}` is of another tool", part.form));
            const auto edit = options.run->edit();
            report.assertions.push_back(std::move(one));
        }
}

}  // namespace

void check_assertions(Project& project, const Options& options, Report& report) {
    report_unchecked(project, options, report);
    if (options.times != Times::timed) check_time(project, options, Time::untimed, report);
    if (options.times != Times::untimed && project.diagnostics.ok()) check_time(project, options, Time::timed, report);
}

}  // namespace robochart::app
