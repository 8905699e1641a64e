// The verb `cspm`: any CSPM script's assertions, as FDR's `refines` would decide them.
#include <fmt/format.h>

#include <algorithm>

#include "app/interrupt.hpp"
#include "app/verbs.hpp"
#include "checker/cspm/reader.hpp"
#include "checker/cspm/session.hpp"
#include "checker/cspm/types.hpp"
#include "diagnostics/json.hpp"
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

// A script with its findings and the types of its names; every script is type checked before it is evaluated.
struct Loaded {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    cspm::Script script;
    std::vector<cspm::NamedType> types;
};

void load(const std::string& path, Loaded& loaded) {
    loaded.script = cspm::read_file(loaded.sources, path, loaded.diagnostics);
    if (loaded.diagnostics.ok()) loaded.types = cspm::check_types(loaded.script, loaded.diagnostics);
}

void show_findings(const Loaded& loaded, const Options& options) {
    if (loaded.diagnostics.empty()) return;
    if (options.format == Format::json && !loaded.diagnostics.ok()) {
        fmt::print("{}", diagnostics::render_json(loaded.sources, loaded.diagnostics));
    } else {
        fmt::print(stderr, "{}", diagnostics::render_text(loaded.sources, loaded.diagnostics));
    }
}

std::string types_json(const std::string& path, const Loaded& loaded) {
    std::vector<std::string> rows;
    for (const cspm::NamedType& each : loaded.types) {
        rows.push_back(fmt::format("{{\"name\":{},\"type\":{},\"place\":{}}}", diagnostics::json_string(each.name),
                                   diagnostics::json_string(each.type), diagnostics::json_string(loaded.sources.place(each.span))));
    }
    return fmt::format("{{\"schema\":\"robochart-verify/types/1\",\"script\":{},\"names\":[{}]}}\n", diagnostics::json_string(path),
                       fmt::join(rows, ","));
}

void show_types(const std::string& path, const Loaded& loaded, const Options& options) {
    if (options.format == Format::json) {
        fmt::print("{}", types_json(path, loaded));
    } else if (options.types) {
        for (const cspm::NamedType& each : loaded.types) fmt::print("{} :: {}\n", each.name, each.type);
    } else if (!options.quiet) {
        fmt::print("{}: the types of {} names are in order\n", path, loaded.types.size());
    }
}

Exit check_types(const Options& options) {
    Exit exit = Exit::success;
    for (const std::string& path : options.inputs) {
        Loaded loaded;
        load(path, loaded);
        show_findings(loaded, options);
        if (loaded.diagnostics.ok()) {
            show_types(path, loaded, options);
        } else {
            exit = Exit::bad_input;
        }
    }
    return exit;
}

void decide_all(const Loaded& loaded, const Options& options, Report& report) {
    cspm::Session session(loaded.script);
    const auto assertions = session.assertions();
    report.summary += fmt::format("{}{} assertions", report.summary.empty() ? "" : ", ", assertions.size());
    for (std::size_t i = 0; i < assertions.size(); ++i) {
        if (!options.assertion.empty() && options.assertion != fmt::format("{}", i + 1)) continue;
        report.assertions.push_back(decide(session, *assertions[i], options, loaded.sources));
        if (options.brief) report.assertions.back().counterexample.clear();
    }
}

}  // namespace

Exit run_cspm(const Options& options) {
    if (options.typecheck || options.types) return check_types(options);
    Report report;
    report.model = fmt::format("{}", fmt::join(options.inputs, " "));
    for (const std::string& path : options.inputs) {
        Loaded loaded;
        load(path, loaded);
        show_findings(loaded, options);
        if (!loaded.diagnostics.ok()) return Exit::bad_input;
        try {
            decide_all(loaded, options, report);
        } catch (const cspm::EvaluationError& error) {
            fmt::print(stderr, "{}: {}\n", loaded.sources.place(error.span), error.what());
            return Exit::bad_input;
        }
    }
    fmt::print("{}", options.format == Format::json ? render_json(report) : render_text(report, options));
    return report.exit();
}

}  // namespace robochart::app
