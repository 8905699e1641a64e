// SPDX-License-Identifier: Apache-2.0
// The verb `cspm`: decides the assertions of a CSPM script, like FDR's `refines`.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>

#include "app/claims/script_claims.hpp"
#include "app/command/answer.hpp"
#include "app/command/output.hpp"
#include "app/command/recording.hpp"
#include "app/command/run.hpp"
#include "app/command/script.hpp"
#include "app/report/script_report.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/json_values.hpp"
#include "base/diagnostics/render.hpp"
#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/cspm/syntax/rules.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "driver/settings/claim_selection.hpp"

namespace robochart::app {
namespace {

/// Returns the types of the script's names in JSON. `limit` is the reason why they are unknown, or "".
std::string types_json(const std::string& path, const LoadedScript& loaded, const std::string& limit = "") {
    diagnostics::Json json{{"schema", "robochart-verify/types/1"}, {"script", path}};
    if (!limit.empty()) json["limit"] = limit;
    json["names"] = diagnostics::json_array(loaded.types, [&](const cspm::NamedType& named) -> diagnostics::Json {
        return {{"name", named.name}, {"type", named.type}, {"place", loaded.sources.path_and_line(named.span)}};
    });
    return diagnostics::json_text(json) + "\n";
}

/// Prints the result for a script in JSON. If there is only one script, this document is the result of the run, so no
/// second document must be printed at a limit.
void print_answer(const std::string& text, const Options& options) {
    if (options.load.inputs.size() == 1) options.run->finish();
    const auto edit = options.run->edit();
    print_exact(text);
}

/// Stores the text for the file of --json.
void keep_json(const std::string& text, const Options& options) {
    if (const auto file = options.output.files.find(Format::json); file != options.output.files.end())
        options.run->keep_for(file->second, text);
}

void show_types(const std::string& path, const LoadedScript& loaded, const Options& options) {
    const std::string answer = with_run(types_json(path, loaded), record_of(options));
    keep_json(answer, options);
    if (options.output.format == Format::json) {
        print_answer(answer, options);
    } else if (options.script.types) {
        for (const cspm::NamedType& named_type : loaded.types) print("{} :: {}\n", named_type.name, named_type.type);
    } else if (!options.output.quiet) {
        print("{}: the types of {} names are in order\n", diagnostics::escape_for_display(path), loaded.types.size());
    }
}

Exit check_types(const Options& options) {
    Exit exit = Exit::success;
    for (const std::string& path : options.load.inputs) {
        options.run->last_word([path, &options](const std::string& why) {
            const std::string answer = with_run(types_json(path, {}, why), record_of(options));
            keep_json(answer, options);
            if (options.output.format == Format::json) print_exact(answer);
            print_error("robochart-verify: {}; the types of {} are not known\n", why,
                        diagnostics::escape_for_display(path));
            return Exit::inconclusive;
        });
        LoadedScript loaded;
        loaded.diagnostics.set_budget(&options.run->budget());
        const diagnostics::Budget::Phase phase(options.run->budget(), "checking the types of " + path);
        load_script(path, loaded);
        record_texts(loaded.sources, options);
        show_findings(loaded, options);
        if (loaded.diagnostics.ok()) {
            show_types(path, loaded, options);
        } else {
            exit = Exit::bad_input;
        }
    }
    return exit;
}

/// Evaluates the print statements. Sets `stopped` if a limit ended the evaluation of one.
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
            printed.error = fmt::format(
                "{}: {}", diagnostics::escape_for_display(sources.path_and_line(statement->span)), limit.what());
            options.run->finish();  // no further results are computed from here on
            stopped = true;
        } catch (const cspm::EvaluationError& error) {
            printed.error =
                fmt::format("{}: {}", diagnostics::escape_for_display(sources.path_and_line(error.span)), error.what());
            printed.failed = true;
        }
    }
    return result;
}

void show_prints(const ScriptReport& script, const Options& options) {
    if (options.output.quiet || (options.output.format != Format::text && options.output.format != Format::plain))
        return;
    for (const ScriptPrint& statement : script.prints)
        print("{}: {}\n", statement.expression, statement.error.empty() ? statement.value : statement.error);
}

/// Adds the findings to the report as texts, as in FDR's output.
void take_findings(const LoadedScript& loaded, ScriptReport& report) {
    for (const diagnostics::Diagnostic& finding : loaded.diagnostics.sorted_findings()) {
        const std::string text = fmt::format("{}: {}", loaded.sources.path_and_line(finding.span), finding.message());
        (finding.rule->severity == diagnostics::Severity::error ? report.errors : report.warnings).push_back(text);
    }
}

/// Returns the path of the script with the assertions about this script, according to the file names of `emit csp`; ""
/// if there is none.
std::string script_with_assertions(const std::string& path) {
    const std::filesystem::path file(path);
    const std::filesystem::path beside = file.parent_path() / (file.stem().string() + "_assertions.csp");
    std::error_code code;
    return std::filesystem::is_regular_file(beside, code) ? beside.string() : "";
}

/// Adds a note about a script without assertions. It is not an error, because the names and types have been checked. An
/// empty script is an error.
void note_no_assertions(const LoadedScript& loaded, const Options& options, ScriptReport& script) {
    const std::string path = diagnostics::escape_for_display(script.path);
    if (loaded.script.decls.empty()) {
        script.errors.push_back(fmt::format("{}: nothing to check: it is empty", path));
        return;
    }
    const std::string beside = script_with_assertions(script.path);
    script.warnings.push_back(fmt::format(
        "{}: there are no assertions; its names and types are right{}", path,
        beside.empty() ? "" : fmt::format(", and assertions are in {}", diagnostics::escape_for_display(beside))));
    const bool text = options.output.format == Format::text || options.output.format == Format::plain;
    if (text || options.output.format == Format::junit) print_error("{}\n", script.warnings.back());
}

/// Returns the indices of the assertions that --assertion selects.
std::vector<std::size_t> chosen_of(const std::vector<cspm::DeclPtr>& assertions, const Options& options,
                                   const std::string& path) {
    std::vector<std::string> texts;
    for (const cspm::DeclPtr& assertion : assertions) texts.push_back(text_of(*assertion));
    driver::ClaimSelection selection = driver::select_claims(options.claims.names, texts);
    if (!selection.lost.empty())
        throw UsageError(fmt::format("--assertion {}: {}", selection.lost.front(),
                                     driver::why_lost(selection.lost.front(), texts, path)));
    return selection.chosen;
}

/// The data for the partial result, which is printed if the run ends early.
struct Known {
    Report report;
    ScriptReport script;  ///< script whose JSON object has not been printed; its path is empty if there is none
    bool last = false;    ///< true for the last script
    bool asks = false;    ///< true if some script has assertions or print statements
    std::vector<RefusedReport> refused;  ///< scripts with errors, for JUnit
};

/// Prints one assertion at once, in the formats that allow it.
void print_decided(const ScriptAssertion& decided, const process::EventTable& events, const Options& options,
                   const ScriptReport& script) {
    if (options.output.format != Format::plain && options.output.format != Format::framed_json) return;
    const auto edit = options.run->edit();  // so that no partial result is printed in between
    if (options.output.format == Format::plain) {
        print_text(refines_plain(decided, events, options));
    } else {
        ScriptReport frame = script;
        frame.assertions = {decided};
        print_exact(with_run(refines_json(frame, options), record_of(options)));
    }
    finish_output();
}

void decide_all(const LoadedScript& loaded, OpenScript& open, const Options& options, Known& known) {
    const auto assertions = open.open_session().assertions();
    ScriptReport& script = known.script;
    const std::vector<std::size_t> chosen = chosen_of(assertions, options, script.path);
    {
        const auto edit = options.run->edit();
        if (assertions.empty() && script.prints.empty()) note_no_assertions(loaded, options, script);
        std::string& summary = known.report.summary;
        summary += fmt::format("{}{} assertions", summary.empty() ? "" : ", ", assertions.size());
    }
    ScriptClaims claims(open, loaded, options, chosen, script, known.report);
    claims.decide_all([&](const ScriptAssertion& decided, const process::EventTable& events) {
        print_decided(decided, events, options, script);
    });
}

Exit worse_exit(Exit a, Exit b) {
    const auto rank = [](Exit exit) {
        constexpr std::array order{Exit::success, Exit::inconclusive, Exit::failed, Exit::bad_input};
        return std::ranges::find(order, exit) - order.begin();
    };
    return rank(a) < rank(b) ? b : a;
}

/// Returns the report, extended by an entry for each script with errors.
Report with_refused(const Known& known) {
    Report report = known.report;
    report.refused = known.refused;
    return report;
}

/// Stores the JSON of a script for the file of --json.
void keep_object(const ScriptReport& script, const RunRecord& record, const Options& options) {
    if (options.output.files.contains(Format::json))
        keep_json(with_run(refines_json(script, options), record), options);
}
void keep_cases(const Known& known, const Options& options) {
    if (const auto file = options.output.files.find(Format::junit); file != options.output.files.end())
        options.run->keep_for(file->second, render_junit(with_refused(known)));
}

void note_refused(const ScriptReport& script, const Options& options, Known& known) {
    const auto edit = options.run->edit();
    known.refused.push_back({script.path, "", fmt::format("{}", fmt::join(script.errors, "\n"))});
}

/// Prints the report over all scripts.
void print_report(const Known& known, const Options& options) {
    if (options.output.format == Format::junit)
        print_exact(render_junit(with_refused(known)));
    else
        print_styled(wrap_lines(render_text(known.report, options), line_width(STDOUT_FILENO)));
}

/// Prints the rest of the output about a script, and marks the script as printed, so that a partial result does not
/// repeat it.
void print_last(const std::string& text, const Options& options, Known& known) {
    if (known.last) options.run->finish();
    const auto edit = options.run->edit();
    known.script = {};
    print_exact(text);
    finish_output();
}

/// Prints the JSON object of a script, if the format is JSON.
void print_object(const Options& options, Known& known) {
    const bool json = options.output.format == Format::json || options.output.format == Format::framed_json;
    const auto edit = options.run->edit();
    const RunRecord record = record_of(options);
    keep_object(known.script, record, options);
    print_last(json ? with_run(refines_json(known.script, options), record) : "", options, known);
}

/// Reports a script with errors as rejected.
Exit refuse_script(const Options& options, Known& known) {
    note_refused(known.script, options, known);
    print_object(options, known);
    return Exit::bad_input;
}

/// Evaluates the print statements and decides the assertions of a script. Throws LimitReached if a limit is reached
/// before the first of them.
Exit decide_loaded(const LoadedScript& loaded, const Options& options, Known& known) {
    ScriptReport& script = known.script;
    bool stopped = false;
    std::optional<diagnostics::Budget::Phase> reading(std::in_place, options.run->budget(), "reading " + script.path);
    OpenScript open(loaded, options);
    reading.reset();
    std::vector<ScriptPrint> prints = print_statements(open.open_session(), loaded, options, stopped);
    const bool failed = std::ranges::any_of(prints, [](const ScriptPrint& statement) { return statement.failed; });
    {
        const auto edit = options.run->edit();
        script.prints = std::move(prints);
    }
    show_prints(script, options);
    const bool asserts = !open.open_session().assertions().empty();
    decide_all(loaded, open, options, known);
    known.asks = known.asks || asserts || !script.prints.empty();
    for (const std::string& error : script.errors) print_error("{}\n", error);
    if (!script.errors.empty()) return refuse_script(options, known);
    // The format has one frame per assertion. A script that has only print statements gets one frame.
    if (options.output.format == Format::framed_json && asserts) {
        const auto edit = options.run->edit();
        keep_object(script, record_of(options), options);
        print_last("", options, known);
    } else {
        print_object(options, known);
    }
    if (known.last) options.run->finish();
    if (failed) return Exit::bad_input;
    return stopped ? Exit::inconclusive : Exit::success;
}

/// Decides one script and adds its results to the common report.
Exit decide_script(const Options& options, Known& known) {
    LoadedScript loaded;
    loaded.diagnostics.set_budget(&options.run->budget());
    {
        const diagnostics::Budget::Phase phase(options.run->budget(), "reading " + known.script.path);
        load_script(known.script.path, loaded);
        record_texts(loaded.sources, options);
    }
    show_findings(loaded, options);
    {
        const auto edit = options.run->edit();
        take_findings(loaded, known.script);
    }
    if (!loaded.diagnostics.ok()) return refuse_script(options, known);
    try {
        return decide_loaded(loaded, options, known);
    } catch (const diagnostics::LimitReached& limit) {
        options.run->finish();
        known.script.errors.emplace_back(limit.what());
        known.report.limit = limit.what();
        print_object(options, known);
        return Exit::inconclusive;
    } catch (const cspm::EvaluationError& error) {
        const auto edit = options.run->edit();
        known.script.errors.push_back(fmt::format(
            "{}: {}", diagnostics::escape_for_display(loaded.sources.path_and_line(error.span)), error.what()));
        print_error("{}\n", known.script.errors.back());
        return refuse_script(options, known);
    }
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

/// Prints the partial result. The object of the current script contains the decided assertions, and the reason for each
/// undecided one. Frames of decided assertions have been printed before.
Exit print_partial_result(const std::string& why, const Options& options, Known& known) {
    Report& report = known.report;
    report.limit = why;
    for (driver::AssertionReport& assertion : report.assertions)
        if (assertion.reason == driver::undecided_at_limit) assertion.reason = fmt::format("not decided: {}", why);
    ScriptReport& script = known.script;
    for (ScriptAssertion& assertion : script.assertions)
        if (assertion.errors == std::vector<std::string>{driver::undecided_at_limit})
            assertion.errors = {"not decided: " + why};
    script.errors.push_back(why);
    const bool is_open = !script.path.empty();
    const RunRecord record = record_of(options);
    if (is_open) keep_object(script, record, options);
    keep_cases(known, options);
    if (options.output.format == Format::text || options.output.format == Format::junit) {
        print_report(known, options);
    } else if (options.output.format == Format::plain) {
        print_error("robochart-verify: {}\n", why);
    } else if (is_open) {
        if (options.output.format == Format::framed_json)
            std::erase_if(script.assertions, [](const ScriptAssertion& assertion) {
                return assertion.answer != driver::Answer::inconclusive;
            });
        print_exact(with_run(refines_json(script, options), record));
    }
    return report.exit_code();
}

}  // namespace

void load_script(const std::string& path, LoadedScript& loaded) {
    loaded.script =
        path == "-" ? read_standard_input(loaded) : cspm::read_file(loaded.sources, path, loaded.diagnostics);
    if (loaded.diagnostics.ok()) loaded.types = cspm::check_types(loaded.script, loaded.diagnostics);
}

void show_findings(const LoadedScript& loaded, const Options& options) {
    if (loaded.diagnostics.empty()) return;
    const bool types_only = options.script.typecheck || options.script.types;
    std::string answer;  // the findings in JSON, if they are the result of the run
    if (types_only && !loaded.diagnostics.ok())
        answer = with_run(diagnostics::render_json(loaded.sources, loaded.diagnostics), record_of(options));
    if (!answer.empty()) keep_json(answer, options);
    if (options.output.format == Format::json && !answer.empty()) {
        print_answer(answer, options);
    } else {
        print_error("{}", diagnostics::render_text(loaded.sources, loaded.diagnostics));
    }
}

Exit run_cspm(const Options& options) {
    if ((options.script.typecheck || options.script.types) && is_requested(options, Format::junit))
        throw UsageError("--format junit does not support types; use text or json");
    if (options.script.typecheck || options.script.types) return check_types(options);
    if (options.script.exported) return export_process(options);
    require_empty_certificates(options);
    const auto known = std::make_shared<Known>();
    Report& report = known->report;
    report.model = fmt::format("{}", fmt::join(options.load.inputs, " "));
    report.subject = "process";
    options.run->last_word(
        [known, &options](const std::string& why) { return print_partial_result(why, options, *known); });
    Exit exit = Exit::success;
    for (const std::string& path : options.load.inputs) {
        {
            const auto edit = options.run->edit();
            known->script = {};
            known->script.path = path;
            known->last = &path == &options.load.inputs.back();
        }
        exit = worse_exit(exit, decide_script(options, *known));
        if (!report.limit.empty()) break;
    }
    options.run->finish();
    if (!known->asks && exit == Exit::success) {
        report.unclaimed = "nothing is claimed";
        exit = Exit::inconclusive;
    }
    const bool some = exit != Exit::bad_input || !report.assertions.empty();
    keep_cases(*known, options);
    if (options.output.format == Format::junit || (options.output.format == Format::text && some))
        print_report(*known, options);
    const Exit all = worse_exit(exit, report.exit_code());
    if ((all == Exit::success || all == Exit::failed) && report.all_decided()) options.run->end_questions();
    return all;
}

}  // namespace robochart::app
