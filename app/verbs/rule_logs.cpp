// SPDX-License-Identifier: Apache-2.0
// Implements `conform RULES.sleec --traces LOG`, which checks logs of runs against SLEEC rules (docs/traces.md, "Logs
// and rules").
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "app/base/numbers.hpp"
#include "app/command/answer.hpp"
#include "app/command/output.hpp"
#include "app/command/run.hpp"
#include "app/rules/record_rules.hpp"
#include "app/rules/show_findings.hpp"
#include "app/verbs/log_files.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/json_values.hpp"
#include "claims/sleec/obligations/samples.hpp"
#include "claims/sleec/syntax/rules.hpp"
#include "conformance/traces/trace_text.hpp"
#include "driver/model/claim_files.hpp"
#include "driver/rules/rule_claims.hpp"
#include "driver/rules/rule_run.hpp"

namespace robochart::app {
namespace {

using conformance::TraceToken;

struct RuleLogReport : LogReport {
    durations::Unit unit;         ///< the length of a `tock`, if declared
    bool counts_seconds = false;  ///< true if a limit is in seconds and no unit is declared
};

/// One log and one rule file.
class RuleLog final : public RunReader {
public:
    RuleLog(const driver::LoadedRules& of, std::string path, RuleLogReport& report, const Options& options)
        : RunReader(std::move(path), report, options), of_{*of.rules, of.sources}, words_(*of.rules), report_(report) {}

private:
    void begin_run(const conformance::TraceHeader& header) override {
        conformance::compare_units(header, of_.rules.unit);
        if (of_.rules.unit) report_.unit = of_.rules.unit;
        if (driver::counts_seconds(of_.rules)) report_.counts_seconds = true;
        hidden_.clear();
        for (const std::string& word : header.unobserved)
            if (!words_.declared_by_word(word).empty()) hidden_ = word;
        run_.emplace(of_, options().rules.without_limit);
    }

    void follow(const std::vector<TraceToken>& tokens, std::uint64_t line) override {
        if (tokens.size() == 1 && (tokens[0].text == "late" || tokens[0].text == "lost"))
            return run_->drop_obligations();
        for (const TraceToken& token : tokens) follow_word(token.text, line);
    }

    void follow_word(std::string_view word, std::uint64_t line) {
        if (word == "tock") return run_->end_second(line);
        for (const std::size_t measure : words_.measures_of_word(word))
            run_->read(measure, words_.value_in(measure, word));
        const std::vector<std::size_t> events = words_.events_of_word(word);
        if (events.size() < words_.declared_by_word(word).size()) hidden_ = fmt::format("the values in {}", word);
        for (const std::size_t event : events) run_->add_event(event, line);
    }

    void end_run() override {
        run_->end();
        report_.units += static_cast<std::uint64_t>(run_->elapsed_seconds());
        const bool broken = run_->is_broken() && hidden_.empty();
        const bool open = !broken && (!run_->open_triggers().empty() || !hidden_.empty());
        if (broken)
            ++report_.broken;
        else
            ++(open ? report_.open : report_.kept);
        if (!broken && !open) return;
        LoggedRun logged = entry(broken, broken ? run_->violation_line() : first_line());
        if (broken) logged.lines = run_->violation_text();
        if (!hidden_.empty()) logged.lines.push_back(fmt::format("the log does not show {}", hidden_));
        for (const std::size_t rule : run_->open_triggers())
            if (open)
                logged.lines.push_back(fmt::format(
                    "{} begins while a measure that decides what it asks for is not {}", of_.rules.name(rule),
                    sleec::reads_states(of_.rules, rule) ? "known: events do not show states" : "read"));
        report_.add(std::move(logged));
    }

    driver::RulesOf of_;
    driver::RuleWords words_;
    RuleLogReport& report_;
    std::optional<driver::RuleRun> run_;
    std::string hidden_;  ///< an event of the rules that is not in the log; "" if there is none
};

Exit exit_of(const RuleLogReport& report) {
    if (!report.errors.empty()) return Exit::bad_input;
    if (report.broken > 0) return Exit::failed;
    return report.open > 0 ? Exit::inconclusive : Exit::success;
}

void print_logs(const RuleLogReport& report) {
    print_reported(report);
    print("an input counts as an event of the rules when it is raised, also if the controller misses it\n");
    if (report.unit || report.counts_seconds) print("{}\n", durations::second_text(report.unit));
    const std::string time = count_text(report.units, report.unit ? "time unit" : "second");
    print("{} in {}, {}: {} obey the rules, {} do not, {} inconclusive\n", count_text(report.runs, "run"),
          count_text(report.logs, "log"), time, with_commas(report.kept), with_commas(report.broken),
          with_commas(report.open));
}

std::string logs_json(const RuleLogReport& report) {
    diagnostics::Json json = log_report_json(report, "robochart-verify/rule-traces/1",
                                             report.unit ? "timeUnits" : "seconds", "accepted", exit_of(report));
    json["unitNanoseconds"] = diagnostics::json_or_null(report.unit);
    return diagnostics::json_text(json) + "\n";
}

}  // namespace

Exit conform_rules(const Options& options) {
    RuleLogReport report;
    const std::vector<std::string> logs = log_files(options, report.errors);
    for (const std::string& file : options.load.inputs) {
        driver::LoadedRules loaded;
        loaded.diagnostics.set_budget(&options.run->budget());
        const auto unit = driver::unit_beside({file}, loaded.sources, loaded.diagnostics);
        load_rules(file, loaded, unit ? durations::Unit(unit->nanoseconds) : std::nullopt);
        record_rules(loaded, options);
        show_rule_findings(loaded, options);
        if (!loaded.rules) {
            report.errors.push_back(fmt::format("{} cannot be read", diagnostics::escape_for_display(file)));
            continue;
        }
        try {
            for (const std::string& log : logs)
                read_log(log, options, report.errors, report.logs,
                         [&](std::istream& in) { RuleLog(loaded, log, report, options).read(in); });
        } catch (const sleec::NotDecided& error) {
            report.errors.push_back(fmt::format("{}: {}", diagnostics::escape_for_display(file), error.what()));
        }
    }
    options.run->finish();
    output_document(options, [&](Format) { return logs_json(report); });
    if (options.output.format == Format::text) print_logs(report);
    return exit_of(report);
}

}  // namespace robochart::app
