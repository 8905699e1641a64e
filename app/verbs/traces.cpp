// SPDX-License-Identifier: Apache-2.0
// Implements `conform MODEL --traces FILE`, which checks logs of runs against the model (docs/traces.md).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <tuple>

#include "app/base/numbers.hpp"
#include "app/claims/event_order.hpp"
#include "app/command/answer.hpp"
#include "app/command/findings.hpp"
#include "app/command/output.hpp"
#include "app/command/recording.hpp"
#include "app/command/rules.hpp"
#include "app/command/run.hpp"
#include "app/step/trace_page.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/json_values.hpp"
#include "conformance/model/rules.hpp"
#include "conformance/traces/mcap.hpp"
#include "conformance/traces/more_numbers.hpp"
#include "conformance/traces/trace_check.hpp"
#include "counterexample/evaluation_failure.hpp"
#include "driver/model/places.hpp"
#include "driver/settings/rules.hpp"
#include "frontend/syntax/syntax_rules.hpp"
#include "semantics/ir/element_at.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::app {
namespace fs = std::filesystem;
namespace {

using conformance::RunVerdict;

/// A run to report, and its log.
struct ReportedRun {
    std::string path;
    conformance::RunReport run;
};

struct Totals {
    std::size_t logs = 0;
    std::uint64_t runs = 0, accepted = 0, rejected = 0, inconclusive = 0, cycles = 0, replaced = 0;
    std::vector<ReportedRun> reported;  ///< the first runs that are not accepted
    std::vector<ComparedLog> compared;  ///< logs for the page of `--html`
    std::string limit;                  ///< reason why not everything was checked
    double seconds = 0;
};
constexpr std::size_t max_reported = 100;

/// Returns the files, and the logs in the folders, in order.
std::vector<std::string> logs_to_check(const Options& options, diagnostics::Diagnostics& diagnostics) {
    std::vector<std::string> result;
    for (const std::string& given : options.conform.traces) {
        std::error_code error;
        if (!fs::is_directory(given, error)) {
            result.push_back(given);
            continue;
        }
        std::vector<std::string> inside;
        const diagnostics::FilesBelow found = diagnostics::files_below(given, true);
        for (const auto& [path, cause] : found.unreadable)
            diagnostics.report(frontend::syntax::unreadable, {}, {path, cause});
        for (const std::string& path : found.files)
            if (conformance::is_log_path(path)) inside.push_back(path);
        if (inside.empty() && found.unreadable.empty())
            diagnostics.report(driver::rules::bad_option, {},
                               {fmt::format("--traces {}: there are no .trace or .mcap files in the folder", given)});
        result.insert(result.end(), inside.begin(), inside.end());
    }
    return result;
}

/// The checkers by component and cycle length, made when the first log needs one.
class Checkers {
public:
    Checkers(const std::vector<driver::Part>& parts, const Options& options)
        : parts_(parts), options_(options), limits_(limits(options, "traces")) {}

    /// A component and the checker that compares logs with it.
    struct Entry {
        ir::Instantiation instantiation;
        std::unique_ptr<conformance::CyclicModel> model;
        std::unique_ptr<conformance::TraceChecker> checker;
        std::string error;
    };
    struct Found {
        driver::Project* project = nullptr;
        ir::ComponentRef component;
        std::uint32_t cycle = 1;
        const Entry* entry = nullptr;
    };

    [[nodiscard]] diagnostics::Budget& budget() const { return options_.run->budget(); }

    /// Finds the checker for the component of a log. If there is no such component, reports a finding and returns no
    /// value.
    std::optional<Found> find_checker(const conformance::TraceHeader& header) {
        const std::string component_name =
            !options_.load.component.empty() ? options_.load.component : header.component;
        const std::vector<driver::Part>* const parts = model_with(header.constants);
        if (parts == nullptr) return std::nullopt;
        std::vector<Candidate> all = first_components(*parts, component_name);
        if (all.empty()) all = first_components(*parts, "");
        if (all.empty())
            return report_refusal(parts_.front(), rules::no_component,
                                  {component_name.empty() ? "the model" : component_name},
                                  model_place(*parts_.front().project));
        const auto& [part, component] = all.front();
        if (!component_name.empty() && all.size() > 1 && all[1].first != part)
            return report_refusal(
                parts_.front(), driver::rules::bad_option,
                {fmt::format("--traces: {} and {} both have a component {}; compare the log with one of them",
                             part->project->name, all[1].first->project->name, component_name)});
        if (!component_name.empty() && all.size() > 1)
            return report_refusal(parts_.front(), driver::rules::bad_option,
                                  {fmt::format("--traces: {} is a component of RoboChart and one of RoboSim; "
                                               "--component {} or --component {} selects one",
                                               component_name, driver::component_name(part->project->system, component),
                                               driver::component_name(part->project->system, all[1].second))});
        const std::uint32_t cycle = options_.code.cycle_given ? options_.code.cycle : header.cycle;
        Entry& entry = entries_[{part, ir::qualified_name(component), cycle}];
        if (entry.checker == nullptr && entry.error.empty()) {
            driver::Project& project = *part->project;
            entry.instantiation = conformance::with_more_numbers(project.system, project.instantiation, component);
            load_model(entry, project, component, cycle);
            if (entry.model != nullptr)
                entry.checker = std::make_unique<conformance::TraceChecker>(*entry.model, names_of(component), limits_,
                                                                            project.sources, project.unit);
        }
        if (!entry.error.empty())
            return report_refusal(parts_.front(), rules::no_monitor, {ir::qualified_name(component), entry.error},
                                  driver::declared_at(part->project->system, component));
        return Found{part->project.get(), component, cycle, &entry};
    }

    /// A checker for one log whose numbers the component compares with each other. Returns null and sets `cause` if
    /// there is none.
    std::unique_ptr<Entry> exact_checker(const Found& found, const conformance::LoggedNumbers& numbers,
                                         std::string& cause) {
        const driver::Project& project = *found.project;
        const conformance::CyclicModel& model = *found.entry->model;
        auto exact =
            conformance::with_logged_numbers(project.system, model.instantiation(), model.boundary(), numbers, cause);
        if (!exact) return nullptr;
        auto entry = std::make_unique<Entry>();
        entry->instantiation = exact->instantiation;
        load_model(*entry, *found.project, found.component, found.cycle);
        cause = entry->error;
        if (entry->model == nullptr) return nullptr;
        entry->checker = std::make_unique<conformance::TraceChecker>(*entry->model, names_of(found.component), limits_,
                                                                     project.sources, project.unit, *exact);
        return entry;
    }

private:
    using Candidate = std::pair<const driver::Part*, ir::ComponentRef>;

    /// Returns the model with the constants of the log. `--const`, `--component` and `--cycle` have priority over the
    /// log. If the model cannot be read with these constants, reports a finding and returns null.
    const std::vector<driver::Part>* model_with(const std::vector<std::string>& constants) {
        if (constants.empty()) return &parts_;
        auto [known, fresh] = others_.try_emplace(constants);
        std::vector<driver::Part>& parts = known->second;
        if (fresh) {
            driver::Settings settings = options_;
            settings.instantiation.weaker_constants = constants;
            parts = driver::load_parts(settings, options_.run->budget());
            record_projects(parts, settings, options_);
        }
        for (const driver::Part& part : parts)
            for (const diagnostics::Diagnostic& finding : part.project->diagnostics.sorted_findings())
                if (finding.rule->severity == diagnostics::Severity::error) {
                    (void)report_refusal(parts_.front(), conformance::rules::log_of_other,
                                         {fmt::format("a model with {}", fmt::join(constants, ", ")),
                                          fmt::format("one that has no such constants: {}", finding.message())});
                    return nullptr;
                }
        return &parts;
    }
    /// Returns the first component with this name in each part, and the first component of the other notation with the
    /// same name.
    [[nodiscard]] static std::vector<Candidate> first_components(const std::vector<driver::Part>& parts,
                                                                 const std::string& component_name) {
        std::vector<Candidate> result;
        for (const driver::Part& part : parts) {
            const ir::System& system = part.project->system;
            const auto components = driver::code_components(system, component_name, true);
            if (part.again || components.empty()) continue;
            result.emplace_back(&part, components.front());
            const auto other = std::ranges::find_if(components, [&](const ir::ComponentRef& component) {
                return !component_name.empty() &&
                       ir::is_robosim(system, component) != ir::is_robosim(system, components.front());
            });
            if (other != components.end()) result.emplace_back(&part, *other);
        }
        return result;
    }
    static std::nullopt_t report_refusal(const driver::Part& part, const diagnostics::Rule& rule,
                                         std::vector<std::string> arguments, diagnostics::Span place = {}) {
        part.project->diagnostics.report(rule, place, std::move(arguments));
        return std::nullopt;
    }
    /// Loads the component with the instantiation of the entry.
    void load_model(Entry& entry, driver::Project& project, const ir::ComponentRef& component, std::uint32_t cycle) {
        const cpp_emit::EventOrder order = event_order(project, component);
        if (!project.diagnostics.ok()) {
            entry.error = "its order of events is wrong";
            return;
        }
        entry.model = conformance::CyclicModel::load(project.system, entry.instantiation, component, cycle, limits_,
                                                     project.sources, project.diagnostics, entry.error, order);
    }
    /// The names that logs may use for the component.
    static std::vector<std::string> names_of(const ir::ComponentRef& component) {
        return {ir::qualified_name(component), component.path};
    }

    const std::vector<driver::Part>& parts_;
    const Options& options_;
    refine::Limits limits_;
    std::map<std::vector<std::string>, std::vector<driver::Part>> others_;  ///< the models, by constants of logs
    std::map<std::tuple<const driver::Part*, std::string, std::uint32_t>, Entry> entries_;
};

/// Reads only the header of a log, which names the component and the constants, up to the first error. Throws
/// diagnostics::LimitReached.
conformance::TraceHeader peek_header(std::istream& in, diagnostics::Budget& budget) {
    conformance::LineReader lines(in);
    conformance::TraceHeader header;
    std::vector<conformance::TraceToken> tokens;
    try {
        while (lines.read_line()) {
            budget.poll();
            conformance::split_line(lines.line_text(), tokens);
            if (tokens.empty()) continue;
            if (tokens.front().text == "run") break;
            (void)conformance::read_header_line(tokens, header, lines.line_number());
        }
    } catch (const conformance::TraceFault&) {
        // The main reader finds and reports the error.
    }
    return header;
}

/// Reports an error in a line of a log. The sources contain only this line, at its line number.
void report_fault(driver::Project& project, const std::string& path, const conformance::LogFault& found) {
    const std::uint64_t above = std::min<std::uint64_t>(found.line > 0 ? found.line - 1 : 0, 50'000'000);
    const auto source = project.sources.add(path, std::string(above, '\n') + found.text + "\n");
    const auto begin = static_cast<std::uint32_t>(above + std::min<std::size_t>(found.fault.column, found.text.size()));
    const auto end =
        static_cast<std::uint32_t>(std::min<std::size_t>(begin + found.fault.length, above + found.text.size()));
    project.diagnostics.report(*found.fault.rule, {source, begin, std::max(begin, end)}, found.fault.arguments);
}

/// A log that has been compared, and its first runs that are not accepted.
struct CheckedLog {
    conformance::LogReport report;
    std::vector<conformance::RunReport> runs;
};

/// Compares the log from its beginning. A log is read several times, which is possible only for regular files.
CheckedLog check_with(conformance::TraceChecker& checker, std::istream& in, const conformance::TraceHeader& header) {
    in.clear();
    in.seekg(0);
    CheckedLog result;
    result.report = checker.check_log(in, header.constants, [&](const conformance::RunReport& run) {
        if (result.runs.size() < max_reported) result.runs.push_back(run);
    });
    return result;
}

/// Compares the runs of a log. If the component compares numbers of the log with each other, these numbers are added to
/// the model.
CheckedLog check_runs(std::istream& in, const conformance::TraceHeader& header, const Checkers::Found& found,
                      Checkers& checkers) {
    CheckedLog first = check_with(*found.entry->checker, in, header);
    if (!first.report.related_numbers || first.report.fault) return first;
    std::string cause;
    const auto exact = checkers.exact_checker(found, first.report.numbers, cause);
    if (exact != nullptr) return check_with(*exact->checker, in, header);
    for (conformance::RunReport& run : first.runs)
        if (run.related_numbers) run.reason += fmt::format("; {}", cause);
    return first;
}

void check_log(const std::string& path, driver::Project& project, Checkers& checkers, Totals& totals) {
    std::unique_ptr<std::istream> in;
    try {
        in = conformance::open_log(path, checkers.budget());
    } catch (const conformance::McapFault& fault) {
        project.diagnostics.report(frontend::syntax::unreadable, {}, {path, fault.what()});
        return;
    }
    if (in == nullptr) {
        std::error_code error;
        (void)fs::is_regular_file(path, error);
        project.diagnostics.report(frontend::syntax::unreadable, {},
                                   {path, error ? error.message() : "it is not a regular file that may be read"});
        return;
    }
    const conformance::TraceHeader header = peek_header(*in, checkers.budget());
    const auto found = checkers.find_checker(header);
    if (!found) return;
    ++totals.logs;
    const CheckedLog checked = check_runs(*in, header, *found, checkers);
    const conformance::LogReport& report = checked.report;
    ComparedLog compared{path, found->project, ir::qualified_name(found->component), report, std::nullopt};
    if (!checked.runs.empty()) compared.wrong = checked.runs.front();
    for (const conformance::RunReport& run : checked.runs)
        if (totals.reported.size() < max_reported) totals.reported.push_back({path, run});
    totals.runs += report.runs;
    totals.accepted += report.accepted;
    totals.rejected += report.rejected;
    totals.inconclusive += report.inconclusive;
    totals.cycles += report.cycles;
    totals.replaced += report.replaced;
    if (report.fault) report_fault(project, path, *report.fault);
    totals.compared.push_back(std::move(compared));
}

void print_run(const ReportedRun& reported, bool quiet) {
    const conformance::RunReport& run = reported.run;
    const bool rejected = run.verdict == RunVerdict::rejected;
    print("{}{}  {}:{}: run {}, cycle {}\n", quiet ? "" : "\n", rejected ? "rejected    " : "inconclusive",
          diagnostics::escape_for_display(reported.path), run.at_line,
          run.name.empty() ? "without a name" : diagnostics::escape_for_display(run.name), run.cycle);
    const auto line = [](const char* title, const std::string& text) {
        print("    {:<10} {}\n", title, diagnostics::escape_for_display(text));
    };
    std::uint64_t number = run.at_line - run.before.size();
    for (const std::string& before : run.before) line(fmt::format("line {}", number++).c_str(), before);
    if (!run.cycle_so_far.empty()) line("then", fmt::format("{}", fmt::join(run.cycle_so_far, " ")));
    line(rejected ? "logged" : "met", run.what);
    if (!rejected) return line("reason", run.reason);
    constexpr std::size_t shown = 12;
    std::vector<std::string> allowed(
        run.allowed.begin(), run.allowed.begin() + static_cast<std::ptrdiff_t>(std::min(shown, run.allowed.size())));
    if (run.allowed.size() > shown) allowed.push_back(fmt::format("{} more", run.allowed.size() - shown));
    line("allowed", allowed.empty() ? "nothing" : fmt::format("{}", fmt::join(allowed, ", or ")));
    if (!run.elements.empty()) line("began", fmt::format("{}", fmt::join(run.elements, ", ")));
}

Exit exit_of(const Totals& totals) {
    if (totals.rejected > 0) return Exit::failed;
    return totals.inconclusive > 0 || !totals.limit.empty() ? Exit::inconclusive : Exit::success;
}

void print_totals(const Totals& totals, const Options& options) {
    for (const ReportedRun& reported : totals.reported) print_run(reported, options.output.quiet);
    if (!totals.reported.empty() && !options.output.quiet) print("\n");
    if (totals.replaced > 0 && !options.output.quiet)
        print(
            "{} outside the finite instantiation replaced, as the model only passes such values on or compares them "
            "with "
            "constants (docs/traces.md)\n",
            count_text(totals.replaced, "value"));
    if (!totals.limit.empty()) print("inconclusive: {}\n", totals.limit);
    print("{} in {}, {}: {} accepted, {} rejected, {} inconclusive ({:.1f} s)\n", count_text(totals.runs, "run"),
          count_text(totals.logs, "log"), count_text(totals.cycles, "cycle"), with_commas(totals.accepted),
          with_commas(totals.rejected), with_commas(totals.inconclusive), totals.seconds);
}

diagnostics::Json reported_json(const ReportedRun& reported) {
    const conformance::RunReport& run = reported.run;
    return {{"log", reported.path},    {"line", run.at_line},
            {"run", run.name},         {"verdict", run.verdict == RunVerdict::rejected ? "rejected" : "inconclusive"},
            {"cycle", run.cycle},      {"logged", run.what},
            {"reason", run.reason},    {"cycleSoFar", run.cycle_so_far},
            {"before", run.before},    {"allowed", run.allowed},
            {"elements", run.elements}};
}

std::string totals_json(const Totals& totals, Exit exit) {
    const diagnostics::Json json{{"schema", "robochart-verify/traces/1"},
                                 {"logs", totals.logs},
                                 {"runs", totals.runs},
                                 {"cycles", totals.cycles},
                                 {"accepted", totals.accepted},
                                 {"rejected", totals.rejected},
                                 {"inconclusive", totals.inconclusive},
                                 {"replacedValues", totals.replaced},
                                 {"limit", totals.limit},
                                 {"seconds", diagnostics::round_to_places(totals.seconds, 3)},
                                 {"exit", static_cast<int>(exit)},
                                 {"reported", diagnostics::json_array(totals.reported, reported_json)}};
    return diagnostics::json_text(json) + "\n";
}

}  // namespace

namespace {

/// Returns the subject of the report: the component that --component names, otherwise "the model".
std::string subject_text(const Options& options) {
    return options.load.component.empty() ? "the model" : options.load.component;
}

/// Returns the part that contains a place; the first part if the place is unknown.
const driver::Project& part_at(const std::vector<driver::Part>& parts, diagnostics::Span place) {
    for (const driver::Part& part : parts)
        if (!ir::element_at(part.project->system, place).empty()) return *part.project;
    return *parts.front().project;
}

}  // namespace

Exit conform_traces(const std::vector<driver::Part>& parts, const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    driver::Project& project =
        *parts.front().project;  // receives the findings about logs; the texts are shared by all parts
    Totals totals;
    options.run->last_word([options](const std::string& why) {
        Totals none;
        none.limit = why;
        output_document(options, [&](Format) { return totals_json(none, Exit::inconclusive); });
        if (options.output.format == Format::text) print_totals(none, options);
        return Exit::inconclusive;
    });
    const std::vector<std::string> paths = logs_to_check(options, project.diagnostics);
    std::optional<std::string> page;
    try {
        Checkers checkers(parts, options);
        for (const std::string& path : paths) {
            options.run->recorder().add_input_file(path);
            check_log(path, project, checkers, totals);
        }
        if (!options.output.html.empty()) page = trace_page(totals.compared, parts, options, "");
    } catch (const process::Interrupted& limit) {
        totals.limit = limit.what();
    } catch (const cspm::EvaluationError& failed) {
        const std::string why = runs::failure_text(failed, part_at(parts, failed.span).system);
        project.diagnostics.report(rules::no_monitor, failed.span, {subject_text(options), why});
    } catch (const conformance::AlphabetError& mismatch) {
        project.diagnostics.report(rules::no_monitor, {}, {subject_text(options), mismatch.what()});
    }
    const auto in_order = [](const driver::Part& part) { return part.project->diagnostics.ok(); };
    if (totals.runs == 0 && totals.limit.empty() && std::ranges::all_of(parts, in_order))
        project.diagnostics.report(driver::rules::bad_option, {},
                                   {"--traces: there is nothing to compare, the logs have no runs"});
    totals.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    options.run->finish();
    const driver::Project* wrong = nullptr;
    for (const driver::Part& part : parts)
        if ((options.output.format == Format::text || wrong == nullptr) && !show_diagnostics(*part.project, options) &&
            wrong == nullptr)
            wrong = part.project.get();
    if (options.output.format == Format::json && wrong != nullptr) return refusal_code(*wrong);
    const Exit exit = wrong == nullptr ? exit_of(totals) : refusal_code(*wrong);
    if (!options.output.html.empty() && !page) page = trace_page(totals.compared, parts, options, totals.limit);
    if (page && wrong == nullptr) options.run->keep_for(options.output.html, *page);
    if (wrong == nullptr) output_document(options, [&](Format) { return totals_json(totals, exit); });
    if (options.output.format == Format::text) print_totals(totals, options);
    return exit;
}

}  // namespace robochart::app
