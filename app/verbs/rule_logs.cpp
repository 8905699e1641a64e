// `conform RULES.sleec --traces LOG`: logs of runs against rules in SLEEC (docs/traces.md, "Logs and rules").
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/command/numbers.hpp"
#include "app/command/output.hpp"
#include "app/command/run.hpp"
#include "app/rules/rule_claims.hpp"
#include "app/verbs/verbs.hpp"
#include "conformance/traces/trace_text.hpp"
#include "diagnostics/escape.hpp"
#include "diagnostics/files.hpp"
#include "diagnostics/json.hpp"
#include "diagnostics/render.hpp"
#include "sleec/analysis/explain.hpp"
#include "sleec/monitor/rule_monitor.hpp"
#include "sleec/obligations/samples.hpp"
#include "sleec/syntax/rules.hpp"

namespace robochart::app {
namespace {

using conformance::TraceToken;

/// A run in which a rule is broken, or of which it is not known.
struct LoggedRun {
    std::string log, run;
    std::uint64_t line = 0;
    bool broken = false;
    std::vector<std::string> lines;
};

struct RuleLogReport {
    std::uint64_t logs = 0, runs = 0, seconds = 0, accepted = 0, broken = 0, open = 0;
    std::vector<LoggedRun> reported;  ///< the first of those that are not accepted
    std::vector<std::string> errors;
};
constexpr std::size_t most_reported = 100;

/// Words of a log as events and measures of a file of rules. Equal names are linked, unless `map` says otherwise.
class RuleWords {
public:
    explicit RuleWords(const sleec::CheckedRules& rules) : rules_(rules) {
        for (std::size_t i = 0; i < rules.file->events.size(); ++i) events_.emplace(model_name(rules.event(i)), i);
        for (std::size_t i = 0; i < rules.file->measures.size(); ++i)
            measures_.emplace(model_name(rules.measure(i).name.text), i);
    }

    /// The name in front of `?` or `!`.
    static std::string_view name(std::string_view word) { return word.substr(0, word.find_first_of("?!")); }
    [[nodiscard]] std::vector<std::size_t> events(std::string_view word) const {
        return all(events_, std::string(name(word)));
    }
    [[nodiscard]] std::vector<std::size_t> measures(std::string_view word) const {
        return all(measures_, std::string(name(word)));
    }

    /// The value in the word; nothing where the rules cannot say it: a fraction, a literal that they do not have.
    [[nodiscard]] std::optional<std::int64_t> value(std::size_t measure, std::string_view word) const {
        const std::size_t mark = word.find_first_of("?!");
        const std::string_view text = mark == std::string_view::npos ? std::string_view() : word.substr(mark + 1);
        const sleec::Measure& of = rules_.measure(measure);
        if (of.type == sleec::MeasureType::boolean)
            return text == "true"    ? std::optional<std::int64_t>(1)
                   : text == "false" ? std::optional<std::int64_t>(0)
                                     : std::nullopt;
        if (of.type == sleec::MeasureType::scale) {
            for (std::size_t i = 0; i < of.literals.size(); ++i)
                if (of.literals[i].text == text) return static_cast<std::int64_t>(i);
            return std::nullopt;
        }
        std::int64_t number = 0;
        const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
        const bool whole = code == std::errc() && end == text.data() + text.size() && !text.empty();
        return whole ? std::optional(number) : std::nullopt;
    }

private:
    using Names = std::multimap<std::string, std::size_t>;
    static std::vector<std::size_t> all(const Names& names, const std::string& name) {
        std::vector<std::size_t> result;
        const auto [from, to] = names.equal_range(name);
        for (auto at = from; at != to; ++at) result.push_back(at->second);
        return result;
    }
    [[nodiscard]] std::string model_name(const std::string& name) const {
        for (const sleec::Mapping& each : rules_.file->mappings)
            if (each.name.text == name) return each.element.text.substr(each.element.text.rfind(':') + 1);
        return name;
    }

    const sleec::CheckedRules& rules_;
    Names events_, measures_;
};

/// One run: the words of an instant are taken together, since a measure may be read behind a trigger.
class RuleRun {
public:
    RuleRun(const LoadedRules& of, const RuleWords& words, sleec::WithoutLimit without)
        : of_(of), words_(words), monitor_(*of.rules, without) {}

    void word(std::string_view word, std::uint64_t line) {
        if (word != "tock") {
            instant_.emplace_back(word);
            lines_.push_back(line);
            return;
        }
        end_instant();
        monitor_.second();
        note(line);
    }
    void forget() {
        instant_.clear();
        lines_.clear();
        monitor_.forget();
    }
    /// The log ends here, which may be in the middle of an instant.
    void end() { end_instant(); }

    [[nodiscard]] bool broken() const { return !text_.empty(); }
    [[nodiscard]] std::uint64_t line() const { return line_; }
    [[nodiscard]] const std::vector<std::string>& text() const { return text_; }
    [[nodiscard]] const std::vector<std::size_t>& open() const { return monitor_.open_triggers(); }
    [[nodiscard]] std::int64_t seconds() const { return monitor_.now(); }

private:
    void end_instant() {
        sleec::MeasureReadings readings(of_.rules->file->measures.size());
        std::vector<bool> read(readings.size(), false);
        for (const std::string& each : instant_)
            for (const std::size_t measure : words_.measures(each)) {
                const auto value = words_.value(measure, each);
                readings[measure] = read[measure] && readings[measure] != value ? std::nullopt : value;
                read[measure] = true;
            }
        for (std::size_t i = 0; i < instant_.size(); ++i)
            for (const std::size_t event : words_.events(instant_[i])) {
                monitor_.event(event, readings);
                note(lines_[i]);
            }
        instant_.clear();
        lines_.clear();
    }

    /// The first violation is shown.
    void note(std::uint64_t line) {
        for (const sleec::Violation& each : monitor_.take()) {
            if (broken()) return;
            line_ = line;
            for (const sleec::Demand& demand : each.obligation.any)
                text_.push_back(
                    sleec::side_text({each.rule, each.began, each.values, demand}, *of_.rules, of_.sources));
            text_.push_back(each.event
                                ? fmt::format("{} comes at second {}", of_.rules->event(*each.event), each.second)
                                : fmt::format("second {} ends without it", each.second));
        }
    }

    const LoadedRules& of_;
    const RuleWords& words_;
    sleec::RuleMonitor monitor_;
    std::vector<std::string> instant_;
    std::vector<std::uint64_t> lines_;
    std::vector<std::string> text_;
    std::uint64_t line_ = 0;
};

/// One log and one file of rules.
class RuleLog {
public:
    RuleLog(const LoadedRules& of, std::string path, RuleLogReport& report, const Options& options)
        : of_(of), words_(*of.rules), path_(std::move(path)), report_(report), options_(options) {}

    void read(std::istream& in) {
        conformance::LineReader lines(in);
        conformance::TraceHeader header;
        std::vector<TraceToken> tokens;
        bool version = false;
        while (lines.next()) {
            options_.run->budget().poll();
            conformance::split_line(lines.text(), tokens);
            if (tokens.empty()) continue;
            if (!std::exchange(version, true)) {
                expect_version(tokens);
                continue;
            }
            if (tokens.front().text == "run")
                begin(tokens, lines.number(), header);
            else if (!run_ && !conformance::read_header_line(tokens, header, lines.number()))
                throw conformance::TraceFault{nullptr,
                                              {"a line of the header, or `run`", fmt::format("`{}`", tokens[0].text)}};
            else if (!run_)
                continue;
            else
                take(tokens, lines.number());
        }
        end();
    }

private:
    static void expect_version(const std::vector<TraceToken>& tokens) {
        if (tokens.size() == 2 && tokens[0].text == "robochart-trace" && tokens[1].text == "1") return;
        throw conformance::TraceFault{nullptr,
                                      {"`robochart-trace 1` in the first line", fmt::format("`{}`", tokens[0].text)}};
    }

    void begin(const std::vector<TraceToken>& tokens, std::uint64_t line, const conformance::TraceHeader& header) {
        end();
        hidden_.clear();
        for (const std::string& each : header.unobserved)
            if (!words_.events(each).empty()) hidden_ = each;
        name_.clear();
        for (std::size_t i = 1; i < tokens.size(); ++i) name_ += fmt::format("{}{}", i > 1 ? " " : "", tokens[i].text);
        begun_ = line;
        run_.emplace(of_, words_,
                     options_.without_limit == "now" ? sleec::WithoutLimit::now : sleec::WithoutLimit::eventually);
    }

    void take(const std::vector<TraceToken>& tokens, std::uint64_t line) {
        if (tokens.size() == 1 && (tokens[0].text == "late" || tokens[0].text == "lost")) return run_->forget();
        for (const TraceToken& each : tokens) run_->word(each.text, line);
    }

    void end() {
        if (!run_) return;
        run_->end();
        ++report_.runs;
        report_.seconds += static_cast<std::uint64_t>(run_->seconds());
        const bool broken = run_->broken() && hidden_.empty();
        const bool open = !broken && (!run_->open().empty() || !hidden_.empty());
        ++(broken ? report_.broken : open ? report_.open : report_.accepted);
        if ((broken || open) && report_.reported.size() < most_reported) {
            LoggedRun entry{path_, name_, broken ? run_->line() : begun_, broken, {}};
            if (broken) entry.lines = run_->text();
            if (!hidden_.empty())
                entry.lines.push_back(fmt::format("the log does not show {}", diagnostics::shown(hidden_)));
            for (const std::size_t rule : run_->open())
                if (open)
                    entry.lines.push_back(fmt::format(
                        "{} begins while a measure that decides what it asks for is not read", of_.rules->name(rule)));
            report_.reported.push_back(std::move(entry));
        }
        run_.reset();
    }

    const LoadedRules& of_;
    RuleWords words_;
    std::string path_;
    RuleLogReport& report_;
    const Options& options_;
    std::optional<RuleRun> run_;
    std::string name_;
    std::uint64_t begun_ = 0;
    std::string hidden_;  ///< an event of the rules that the log does not show; "": it shows all
};

std::vector<std::string> log_files(const Options& options, RuleLogReport& report) {
    std::vector<std::string> result;
    for (const std::string& given : options.traces) {
        std::error_code error;
        if (!std::filesystem::is_directory(given, error)) {
            result.push_back(given);
            continue;
        }
        for (const std::string& path : diagnostics::files_below(given, true).files)
            if (std::filesystem::path(path).extension() == ".trace") result.push_back(path);
    }
    if (result.empty()) report.errors.emplace_back("--traces: there are no .trace files in the folder");
    return result;
}

void read_log(const LoadedRules& of, const std::string& path, RuleLogReport& report, const Options& options) {
    std::error_code error;
    std::ifstream in;
    if (std::filesystem::is_regular_file(path, error)) in.open(path, std::ios::binary);
    if (!in.is_open()) {
        report.errors.push_back(fmt::format("{}: it is not a regular file that may be read", diagnostics::shown(path)));
        return;
    }
    ++report.logs;
    try {
        RuleLog(of, path, report, options).read(in);
    } catch (const conformance::TraceFault& fault) {
        const std::string found = fault.arguments.size() > 1 ? fault.arguments[1] : "something else";
        report.errors.push_back(fmt::format("{}: expected {}, found {}", diagnostics::shown(path),
                                            fault.arguments.empty() ? "a log" : fault.arguments[0],
                                            diagnostics::shown(found)));
    }
}

Exit exit_of(const RuleLogReport& report) {
    if (!report.errors.empty()) return Exit::bad_input;
    return report.broken > 0 ? Exit::failed : report.open > 0 ? Exit::inconclusive : Exit::success;
}

void print_logs(const RuleLogReport& report) {
    for (const LoggedRun& each : report.reported) {
        print("{} {}:{}: run {}\n", each.broken ? "broken      " : "inconclusive", diagnostics::shown(each.log),
              each.line, each.run.empty() ? "without a name" : diagnostics::shown(each.run));
        for (const std::string& line : each.lines) print("  {}\n", line);
    }
    for (const std::string& each : report.errors) print_error("robochart-verify: {}\n", each);
    print("{} in {}, {}: {} obey the rules, {} do not, {} inconclusive\n", counted(report.runs, "run"),
          counted(report.logs, "log"), counted(report.seconds, "second"), with_commas(report.accepted),
          with_commas(report.broken), with_commas(report.open));
}

void print_logs_json(const RuleLogReport& report) {
    diagnostics::Json json{{"schema", "robochart-verify/rule-traces/1"},
                           {"logs", report.logs},
                           {"runs", report.runs},
                           {"seconds", report.seconds},
                           {"accepted", report.accepted},
                           {"broken", report.broken},
                           {"inconclusive", report.open},
                           {"errors", report.errors},
                           {"exit", static_cast<int>(exit_of(report))}};
    diagnostics::Json& reported = json["reported"] = diagnostics::Json::array();
    for (const LoggedRun& each : report.reported)
        reported.push_back({{"log", each.log},
                            {"line", each.line},
                            {"run", each.run},
                            {"verdict", each.broken ? "broken" : "inconclusive"},
                            {"lines", each.lines}});
    print_exact(diagnostics::json_text(json) + "\n");
}

}  // namespace

Exit conform_rules(const Options& options) {
    RuleLogReport report;
    const std::vector<std::string> logs = log_files(options, report);
    for (const std::string& file : options.inputs) {
        LoadedRules loaded;
        loaded.diagnostics.within(&options.run->budget());
        load_rules(file, loaded);
        diagnostics::TextStyle style;
        print_error_styled(diagnostics::render_text(loaded.sources, loaded.diagnostics, style));
        if (!loaded.rules) {
            report.errors.push_back(fmt::format("{} cannot be read", diagnostics::shown(file)));
            continue;
        }
        try {
            for (const std::string& log : logs) read_log(loaded, log, report, options);
        } catch (const sleec::NotDecided& error) {
            report.errors.push_back(fmt::format("{}: {}", diagnostics::shown(file), error.what()));
        }
    }
    options.run->finish();
    if (options.format == Format::json)
        print_logs_json(report);
    else
        print_logs(report);
    return exit_of(report);
}

}  // namespace robochart::app
