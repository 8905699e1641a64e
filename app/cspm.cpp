// The verb `cspm`: any CSPM script's assertions, as FDR's `refines` would decide them.
#include <fmt/format.h>

#include <algorithm>

#include "app/interrupt.hpp"
#include "app/verbs.hpp"
#include "checker/cspm/reader.hpp"
#include "checker/cspm/session.hpp"
#include "diagnostics/render.hpp"

namespace robochart::app {
namespace {

std::string raw_story(const refine::Counterexample& c, const process::EventTable& events) {
    std::vector<std::string> names;
    for (const refine::Step& step : c.steps) names.push_back(events.name(step.event));
    std::string text = fmt::format("                 trace <{}>\n", fmt::join(names, ", "));
    const auto set = [&](const process::EventSet& s) {
        std::vector<std::string> shown;
        for (const process::Event event : s) shown.push_back(events.name(event));
        return fmt::format("{{{}}}", fmt::join(shown, ", "));
    };
    if (c.kind == refine::ViolationKind::refusal) {
        text += fmt::format("                 offers {}; the specification requires one of:", set(c.offered));
        for (const auto& acceptance : c.required) text += " " + set(acceptance);
        text += '\n';
    }
    if (c.kind == refine::ViolationKind::divergence) text += "                 then diverges\n";
    return text;
}

Answer answer(refine::Outcome outcome) {
    if (outcome == refine::Outcome::holds) return Answer::holds;
    return outcome == refine::Outcome::fails ? Answer::fails : Answer::inconclusive;
}

/// The innermost calls; deep recursion shows by their number.
std::string call_stack(const std::vector<std::string>& frames) {
    constexpr std::size_t shown = 8;
    std::string text;
    for (std::size_t i = 0; i < frames.size() && i < shown; ++i) text += fmt::format("\n               in {}", frames[i]);
    if (frames.size() > shown) text += fmt::format("\n               and {} more", frames.size() - shown);
    return text;
}

AssertionReport decide(cspm::Session& session, const cspm::Decl& assertion, const Options& options, const diagnostics::SourceManager& sources) {
    AssertionReport report;
    report.place = sources.place(assertion.span);
    const InterruptScope scope;
    try {
        const cspm::AssertionResult result = session.check(assertion, limits(options));
        report.title = result.text;
        report.answer = answer(result.verdict.outcome);
        report.reason = result.verdict.reason;
        report.statistics = result.verdict.statistics;
        if (result.verdict.counterexample) report.counterexample = raw_story(*result.verdict.counterexample, session.event_table());
    } catch (const cspm::EvaluationError& error) {
        report.title = report.place;
        report.answer = Answer::error;
        report.reason = fmt::format("{}: {}", sources.place(error.span), error.what());
        report.reason += call_stack(error.stack);
    }
    return report;
}

}  // namespace

Exit run_cspm(const Options& options) {
    Report report;
    report.model = fmt::format("{}", fmt::join(options.inputs, " "));
    for (const std::string& path : options.inputs) {
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics diagnostics;
        const cspm::Script script = cspm::read_file(sources, path, diagnostics);
        if (!diagnostics.empty()) fmt::print(stderr, "{}", diagnostics::render_text(sources, diagnostics));
        if (!diagnostics.ok()) return Exit::bad_input;
        try {
            cspm::Session session(script);
            const auto assertions = session.assertions();
            report.summary += fmt::format("{}{} assertions", report.summary.empty() ? "" : ", ", assertions.size());
            for (std::size_t i = 0; i < assertions.size(); ++i) {
                if (options.assertion.empty() || options.assertion == fmt::format("{}", i + 1))
                    report.assertions.push_back(decide(session, *assertions[i], options, sources));
            }
        } catch (const cspm::EvaluationError& error) {
            fmt::print(stderr, "{}: {}\n", sources.place(error.span), error.what());
            return Exit::bad_input;
        }
    }
    fmt::print("{}", options.format == Format::json ? render_json(report) : render_text(report, options));
    return report.exit();
}

}  // namespace robochart::app
