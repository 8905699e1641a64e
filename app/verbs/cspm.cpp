// SPDX-License-Identifier: Apache-2.0
// The verb `cspm`: decides the assertions of a CSPM script, like FDR's `refines`.
#include <fmt/format.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>

#include "app/base/claim_selection.hpp"
#include "app/command/answer.hpp"
#include "app/command/limits.hpp"
#include "app/command/output.hpp"
#include "app/command/run.hpp"
#include "app/command/script.hpp"
#include "app/report/script_report.hpp"
#include "app/verbs/verbs.hpp"
#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/cspm/syntax/rules.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "diagnostics/escape.hpp"
#include "diagnostics/files.hpp"
#include "diagnostics/json.hpp"
#include "diagnostics/render.hpp"

namespace robochart::app {
namespace {

Answer answer(refine::Outcome outcome) {
    if (outcome == refine::Outcome::holds) return Answer::holds;
    return outcome == refine::Outcome::fails ? Answer::fails : Answer::inconclusive;
}

/// The innermost calls, and the number of calls, which shows a deep recursion.
std::string call_stack(const std::vector<std::string>& frames) {
    constexpr std::size_t shown = 8;
    std::string text;
    for (std::size_t i = 0; i < frames.size() && i < shown; ++i)
        text += fmt::format("\n               in {}", frames[i]);
    if (frames.size() > shown) text += fmt::format("\n               and {} more", frames.size() - shown);
    return text;
}

/// Stores the expressions of an assertion as text.
void name_sides(const cspm::Assertion& assertion, ScriptAssertion& out) {
    const bool refinement = assertion.kind == cspm::AssertionKind::refinement;
    if (refinement) out.specification = cspm::print(assertion.specification);
    out.process = cspm::print(refinement ? assertion.implementation : assertion.specification);
}

std::string without_keyword(const std::string& assertion) {
    constexpr std::string_view keyword = "assert ";
    return assertion.rfind(keyword, 0) == 0 ? assertion.substr(keyword.size()) : assertion;
}

std::string text_of(const cspm::Decl& assertion) {
    return without_keyword(cspm::print(assertion));
}

AssertionReport undecided(const cspm::Decl& assertion) {
    AssertionReport report;
    report.title = text_of(assertion);
    report.reason = undecided_at_limit;
    return report;
}

/// Stores the current knowledge about an assertion while it is decided.
void note_progress(const refine::Progress& progress, AssertionReport& report) {
    if (progress.phase != refine::Progress::Phase::searching) return;
    report.statistics.states = progress.states;
    report.statistics.transitions = progress.transitions;
    report.statistics.depth = progress.depth;
    report.statistics.seconds = progress.seconds;
    report.searched = true;
}

/// Data shared by the assertions of a script while they are decided.
struct Deciding {
    const Options& options;
    const diagnostics::SourceManager& sources;
    std::function<void(const refine::Progress&)> note;  ///< progress of the current assertion
    std::string limit = "";  ///< the first limit that ended an assertion; "" if there is none
};

ScriptAssertion decide(cspm::Session& session, const cspm::Decl& assertion, std::size_t number, Deciding& deciding) {
    const Options& options = deciding.options;
    ScriptAssertion report;
    report.number = number;
    report.place = deciding.sources.place(assertion.span);
    name_sides(assertion.assertion, report);
    report.text = text_of(assertion);
    refine::Limits bounds = limits(options, report.text);
    bounds.progress = [&deciding, shown = bounds.progress](const refine::Progress& progress) {
        if (shown) shown(progress);
        deciding.note(progress);
    };
    try {
        const diagnostics::Budget::Phase phase(options.run->budget(), "deciding " + report.text);
        report.result = session.check(assertion, bounds);
        report.answer = answer(report.result.verdict.outcome);
        if (report.answer == Answer::inconclusive && deciding.limit.empty())
            deciding.limit = options.run->budget().reached();
        if (report.result.verdict.counterexample && !options.brief)
            report.behaviour = session.behaviour_with_values(assertion, *report.result.verdict.counterexample, bounds);
        if (!report.result.verdict.reason.empty()) report.errors.push_back(report.result.verdict.reason);
    } catch (const diagnostics::LimitReached& reached) {  // before the search
        options.run->finish();
        report.answer = Answer::inconclusive;
        report.errors.push_back(fmt::format("not begun: {}", deciding.limit.empty() ? reached.what() : deciding.limit));
    } catch (const cspm::EvaluationError& error) {
        report.answer = Answer::error;
        report.errors.push_back(
            fmt::format("{}: {}{}", deciding.sources.place(error.span), error.what(), call_stack(error.stack)));
    }
    return report;
}

/// The same result in the report over all scripts.
AssertionReport in_report(const ScriptAssertion& assertion, const process::EventTable& events, const Options& options) {
    AssertionReport report;
    report.title = assertion.text;
    report.place = assertion.place;
    report.answer = assertion.answer;
    report.statistics = assertion.result.verdict.statistics;
    report.searched = !assertion.result.verdict.known;
    if (!assertion.errors.empty()) report.reason = assertion.errors.front();
    if (assertion.result.verdict.counterexample && !options.brief)
        report.counterexample = counterexample_text(assertion, events, options);
    return report;
}

/// `limit`: why the types are unknown; "" if they are known.
std::string types_json(const std::string& path, const LoadedScript& loaded, const std::string& limit = "") {
    diagnostics::Json json{{"schema", "robochart-verify/types/1"}, {"script", path}};
    if (!limit.empty()) json["limit"] = limit;
    diagnostics::Json& names = json["names"] = diagnostics::Json::array();
    for (const cspm::NamedType& each : loaded.types)
        names.push_back({{"name", each.name}, {"type", each.type}, {"place", loaded.sources.place(each.span)}});
    return diagnostics::json_text(json) + "\n";
}

/// Prints the answer about a script. If it is the answer of the run, a limit must not print a second document.
void print_answer(const std::string& text, const Options& options) {
    if (options.inputs.size() == 1) options.run->finish();
    const auto edit = options.run->edit();
    print_exact(text);
}

/// Stores the text for the file of --json.
void keep_json(const std::string& text, const Options& options) {
    if (const auto file = options.files.find(Format::json); file != options.files.end())
        options.run->keep_for(file->second, text);
}

void show_types(const std::string& path, const LoadedScript& loaded, const Options& options) {
    keep_json(types_json(path, loaded), options);
    if (options.format == Format::json) {
        print_answer(types_json(path, loaded), options);
    } else if (options.types) {
        for (const cspm::NamedType& each : loaded.types) print("{} :: {}\n", each.name, each.type);
    } else if (!options.quiet) {
        print("{}: the types of {} names are in order\n", diagnostics::shown(path), loaded.types.size());
    }
}

Exit check_types(const Options& options) {
    Exit exit = Exit::success;
    for (const std::string& path : options.inputs) {
        options.run->last_word([path, &options](const std::string& why) {
            keep_json(types_json(path, {}, why), options);
            if (options.format == Format::json) print_exact(types_json(path, {}, why));
            print_error("robochart-verify: {}; the types of {} are not known\n", why, diagnostics::shown(path));
            return Exit::inconclusive;
        });
        LoadedScript loaded;
        loaded.diagnostics.within(&options.run->budget());
        const diagnostics::Budget::Phase phase(options.run->budget(), "checking the types of " + path);
        load_script(path, loaded);
        show_findings(loaded, options);
        if (loaded.diagnostics.ok()) {
            show_types(path, loaded, options);
        } else {
            exit = Exit::bad_input;
        }
    }
    return exit;
}

/// `stopped`: set if a limit left a print statement without a value.
std::vector<ScriptPrint> print_statements(cspm::Session& session, const LoadedScript& loaded, const Options& options,
                                          bool& stopped) {
    const cspm::Script& script = loaded.script;
    const diagnostics::SourceManager& sources = loaded.sources;
    std::vector<ScriptPrint> result;
    for (const cspm::DeclPtr& statement : script.decls) {
        if (statement->kind != cspm::DeclKind::print) continue;
        ScriptPrint& printed = result.emplace_back();
        printed.expression = cspm::print(statement->body);
        try {
            const diagnostics::Budget::Phase phase(options.run->budget(), "printing " + printed.expression);
            printed.value = session.evaluate(statement->body, limits(options, printed.expression));
        } catch (const diagnostics::LimitReached& limit) {
            printed.error = fmt::format("{}: {}", diagnostics::shown(sources.place(statement->span)), limit.what());
            options.run->finish();  // from here on, only known results are printed
            stopped = true;
        } catch (const cspm::EvaluationError& error) {
            printed.error = fmt::format("{}: {}", diagnostics::shown(sources.place(error.span)), error.what());
            printed.failed = true;
        }
    }
    return result;
}

void show_prints(const ScriptReport& script, const Options& options) {
    if (options.quiet || (options.format != Format::text && options.format != Format::plain)) return;
    for (const ScriptPrint& each : script.prints)
        print("{}: {}\n", each.expression, each.error.empty() ? each.value : each.error);
}

/// The findings in the form of FDR's output: one text each.
void take_findings(const LoadedScript& loaded, ScriptReport& report) {
    for (const diagnostics::Diagnostic& each : loaded.diagnostics.sorted()) {
        const std::string text = fmt::format("{}: {}", loaded.sources.place(each.span), each.message());
        (each.rule->severity == diagnostics::Severity::error ? report.errors : report.warnings).push_back(text);
    }
}

/// The script with the assertions about this script, by the file name that `emit csp` uses; "" if there is none.
std::string assertions_beside(const std::string& path) {
    const std::filesystem::path file(path);
    const std::filesystem::path beside = file.parent_path() / (file.stem().string() + "_assertions.csp");
    std::error_code code;
    return std::filesystem::is_regular_file(beside, code) ? beside.string() : "";
}

/// A script without assertions is not an error: its names and types have been checked. An empty script is an error.
void note_no_assertions(const LoadedScript& loaded, const Options& options, ScriptReport& script) {
    const std::string path = diagnostics::shown(script.path);
    if (loaded.script.decls.empty()) {
        script.errors.push_back(fmt::format("{}: nothing to check: it is empty", path));
        return;
    }
    const std::string beside = assertions_beside(script.path);
    script.warnings.push_back(
        fmt::format("{}: there are no assertions; its names and types are right{}", path,
                    beside.empty() ? "" : fmt::format(", and assertions are in {}", diagnostics::shown(beside))));
    const bool text = options.format == Format::text || options.format == Format::plain;
    if (text || options.format == Format::junit) print_error("{}\n", script.warnings.back());
}

/// The indices of the assertions that --assertion selects.
std::vector<std::size_t> chosen_of(const std::vector<cspm::DeclPtr>& assertions, const Options& options,
                                   const std::string& path) {
    std::vector<std::string> texts;
    for (const cspm::DeclPtr& assertion : assertions) texts.push_back(text_of(*assertion));
    ClaimSelection selection = select_claims(options.claims, texts);
    if (!selection.lost.empty())
        throw UsageError(
            fmt::format("--assertion {}: {}", selection.lost.front(), why_lost(selection.lost.front(), texts, path)));
    return selection.chosen;
}

/// In formats that allow it, each answer is printed at once.
void decide_all(const LoadedScript& loaded, cspm::Session& session, const Options& options, ScriptReport& script,
                Report& report) {
    const auto assertions = session.assertions();
    const std::vector<std::size_t> chosen = chosen_of(assertions, options, script.path);
    if (assertions.empty() && script.prints.empty()) note_no_assertions(loaded, options, script);
    std::size_t at = report.assertions.size();
    {
        const auto edit = options.run->edit();
        report.summary += fmt::format("{}{} assertions", report.summary.empty() ? "" : ", ", assertions.size());
        for (const std::size_t i : chosen) report.assertions.push_back(undecided(*assertions[i]));
    }
    const auto note = [&](const refine::Progress& progress) {
        const auto edit = options.run->edit();
        note_progress(progress, report.assertions[at]);
    };
    Deciding deciding{options, loaded.sources, note};
    for (const std::size_t i : chosen) {
        ScriptAssertion decided = decide(session, *assertions[i], i + 1, deciding);
        {
            AssertionReport one = in_report(decided, session.event_table(), options);
            const auto edit = options.run->edit();
            report.assertions[at++] = std::move(one);
        }
        std::string text;
        if (options.format == Format::plain) text = refines_plain(decided, session.event_table(), options);
        if (options.format == Format::framed_json) {
            ScriptReport frame = script;
            frame.assertions = {decided};
            text = refines_json(frame, session.event_table(), options);
        }
        if (options.format != Format::framed_json || is_asked_for(options, Format::json))
            script.assertions.push_back(std::move(decided));
        const auto edit = options.run->edit();  // so that the last word is not printed in between
        if (options.format == Format::plain)
            print_text(text);
        else
            print_exact(text);
        finish_output();
    }
}

Exit worse(Exit a, Exit b) {
    const auto rank = [](Exit exit) {
        constexpr std::array order{Exit::success, Exit::inconclusive, Exit::failed, Exit::bad_input};
        return std::find(order.begin(), order.end(), exit) - order.begin();
    };
    return rank(a) < rank(b) ? b : a;
}

/// The data that the last word of the run may still have to print.
struct Known {
    Report report;
    std::string open;                    ///< script whose object has not been printed; "": none
    bool last = false;                   ///< it is the last script
    bool asks = false;                   ///< some script has assertions or print statements
    std::vector<RefusedReport> refused;  ///< scripts with errors, for JUnit
};

/// The report, extended by a case for each script with errors.
Report with_refused(const Known& known) {
    Report report = known.report;
    report.refused = known.refused;
    return report;
}

/// Stores the contents of the files of --json (per script) and --junit (for the run).
void keep_object(const ScriptReport& script, const process::EventTable& events, const Options& options) {
    if (is_asked_for(options, Format::json)) keep_json(refines_json(script, events, options), options);
}
void keep_cases(const Known& known, const Options& options) {
    if (const auto file = options.files.find(Format::junit); file != options.files.end())
        options.run->keep_for(file->second, render_junit(with_refused(known)));
}

void note_refused(const ScriptReport& script, const Options& options, Known& known) {
    const auto edit = options.run->edit();
    known.refused.push_back({script.path, "", fmt::format("{}", fmt::join(script.errors, "\n"))});
}

/// Prints the report over all scripts.
void print_report(const Known& known, const Options& options) {
    if (options.format == Format::junit)
        print_exact(render_junit(with_refused(known)));
    else
        print_styled(wrapped(render_text(known.report, options), line_width(STDOUT_FILENO)));
}

/// Prints the rest of the output about a script. It is printed completely, and the last word does not print it again.
void print_last(const std::string& text, const Options& options, Known& known) {
    if (known.last) options.run->finish();
    const auto edit = options.run->edit();
    known.open.clear();
    print_exact(text);
    finish_output();
}

/// Prints the object of a script, in the formats that have one.
void print_object(const ScriptReport& script, const process::EventTable& events, const Options& options, Known& known) {
    keep_object(script, events, options);
    {
        const auto edit = options.run->edit();
        known.open.clear();
    }
    const bool json = options.format == Format::json || options.format == Format::framed_json;
    if (json) print_last(refines_json(script, events, options), options, known);
}

/// Decides one script and adds its results to the common report.
Exit decide_script(const std::string& path, const Options& options, Known& known) {
    Report& report = known.report;
    LoadedScript loaded;
    loaded.diagnostics.within(&options.run->budget());
    {
        const diagnostics::Budget::Phase phase(options.run->budget(), "reading " + path);
        load_script(path, loaded);
    }
    show_findings(loaded, options);
    ScriptReport script;
    script.path = path;
    take_findings(loaded, script);
    const bool json = options.format == Format::json || options.format == Format::framed_json;
    const process::EventTable no_events;
    if (!loaded.diagnostics.ok()) {
        print_object(script, no_events, options, known);
        note_refused(script, options, known);
        return Exit::bad_input;
    }
    bool stopped = false;
    try {
        std::optional<diagnostics::Budget::Phase> reading(std::in_place, options.run->budget(), "reading " + path);
        cspm::Session session(loaded.script, &options.run->budget());
        reading.reset();
        if (diagnostics::Cache* const cache = options.run->cache()) session.remember(*cache);
        script.prints = print_statements(session, loaded, options, stopped);
        show_prints(script, options);
        decide_all(loaded, session, options, script, report);
        known.asks = known.asks || !session.assertions().empty() || !script.prints.empty();
        // Frames belong to assertions; a script with only print statements gets one frame.
        const bool frame = options.format == Format::framed_json && session.assertions().empty();
        if (frame || !json || options.format == Format::json) {
            print_object(script, session.event_table(), options, known);
        } else {
            keep_object(script, session.event_table(), options);
            print_last("", options, known);
        }
        if (known.last) options.run->finish();
    } catch (const diagnostics::LimitReached& limit) {
        options.run->finish();
        script.errors.emplace_back(limit.what());
        report.limit = limit.what();
        print_object(script, no_events, options, known);
        return Exit::inconclusive;
    } catch (const cspm::EvaluationError& error) {
        script.errors.push_back(
            fmt::format("{}: {}", diagnostics::shown(loaded.sources.place(error.span)), error.what()));
        print_object(script, no_events, options, known);
    }
    for (const std::string& error : script.errors) print_error("{}\n", error);
    if (!script.errors.empty()) {
        note_refused(script, options, known);
        return Exit::bad_input;
    }
    const bool failed = std::ranges::any_of(script.prints, [](const ScriptPrint& each) { return each.failed; });
    if (failed) return Exit::bad_input;
    return stopped ? Exit::inconclusive : Exit::success;
}

/// Reads standard input; included files are searched for in the current folder.
cspm::Script read_standard_input(LoadedScript& loaded) {
    std::string error;
    std::string text = diagnostics::standard_input(diagnostics::SourceManager::max_bytes, error);
    cspm::Script whole;
    if (!error.empty()) {
        loaded.diagnostics.report(cspm::rules::include_failed, {}, {"standard input", error});
        return whole;
    }
    cspm::Script read =
        cspm::read(loaded.sources, loaded.sources.add("standard input", std::move(text)), loaded.diagnostics);
    for (const cspm::DeclPtr& decl : read.decls) {
        if (decl->kind != cspm::DeclKind::include) {
            whole.decls.push_back(decl);
            continue;
        }
        const cspm::Script included = cspm::read_file(loaded.sources, decl->names.at(0), loaded.diagnostics);
        whole.decls.insert(whole.decls.end(), included.decls.begin(), included.decls.end());
    }
    return whole;
}

}  // namespace

void load_script(const std::string& path, LoadedScript& loaded) {
    loaded.script =
        path == "-" ? read_standard_input(loaded) : cspm::read_file(loaded.sources, path, loaded.diagnostics);
    if (loaded.diagnostics.ok()) loaded.types = cspm::check_types(loaded.script, loaded.diagnostics);
}

void show_findings(const LoadedScript& loaded, const Options& options) {
    if (loaded.diagnostics.empty()) return;
    const bool types_only = options.typecheck || options.types;
    if (types_only && !loaded.diagnostics.ok())
        keep_json(diagnostics::render_json(loaded.sources, loaded.diagnostics), options);
    if (options.format == Format::json && types_only && !loaded.diagnostics.ok()) {
        print_answer(diagnostics::render_json(loaded.sources, loaded.diagnostics), options);
    } else {
        print_error("{}", diagnostics::render_text(loaded.sources, loaded.diagnostics));
    }
}

Exit run_cspm(const Options& options) {
    if ((options.typecheck || options.types) && is_asked_for(options, Format::junit))
        throw UsageError("--format junit is about assertions: of types there are text and json");
    if (options.typecheck || options.types) return check_types(options);
    if (!options.exported.empty()) return export_process(options);
    const auto known = std::make_shared<Known>();
    Report& report = known->report;
    report.model = fmt::format("{}", fmt::join(options.inputs, " "));
    report.subject = "process";
    options.run->last_word([known, &options](const std::string& why) {
        known->report.limit = why;
        for (AssertionReport& each : known->report.assertions)
            if (each.reason == undecided_at_limit) each.reason = fmt::format("not decided: {}", why);
        ScriptReport script;
        script.path = known->open;
        script.errors.push_back(why);
        const process::EventTable no_events;
        const bool json = options.format == Format::json || options.format == Format::framed_json;
        if (!known->open.empty()) keep_object(script, no_events, options);
        keep_cases(*known, options);
        if (options.format == Format::text || options.format == Format::junit)
            print_report(*known, options);
        else if (!json)
            print_error("robochart-verify: {}\n", why);
        else if (!known->open.empty())
            print_exact(refines_json(script, no_events, options));
        return known->report.exit();
    });
    Exit exit = Exit::success;
    for (const std::string& path : options.inputs) {
        {
            const auto edit = options.run->edit();
            known->open = path;
            known->last = &path == &options.inputs.back();
        }
        exit = worse(exit, decide_script(path, options, *known));
        if (!report.limit.empty()) break;
    }
    options.run->finish();
    if (!known->asks && exit == Exit::success) {
        report.unclaimed = "nothing is claimed";
        exit = Exit::inconclusive;
    }
    const bool some = exit != Exit::bad_input || !report.assertions.empty();
    keep_cases(*known, options);
    if (options.format == Format::junit || (options.format == Format::text && some)) print_report(*known, options);
    const Exit all = worse(exit, report.exit());
    if ((all == Exit::success || all == Exit::failed) && report.all_decided()) options.run->all_asked();
    return all;
}

}  // namespace robochart::app
