// SPDX-License-Identifier: Apache-2.0
// See rule_claims.hpp.
#include "driver/rules/rule_claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/spelling.hpp"
#include "claims/sleec/checks/check.hpp"
#include "claims/sleec/syntax/reader.hpp"
#include "claims/sleec/syntax/rules.hpp"
#include "driver/rules/model_rules.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {
namespace {

/// Returns the message about a rule file with errors.
std::string first_error(const LoadedRules& file) {
    for (const diagnostics::Diagnostic& finding : file.diagnostics.sorted_findings())
        if (finding.rule->severity == diagnostics::Severity::error)
            return fmt::format("{}{}{}", file.sources.path_and_line(finding.span), finding.span.is_known() ? ": " : "",
                               finding.message());
    return "";
}

std::vector<std::string> sleec_files(const std::string& folder) {
    std::vector<std::string> result;
    for (const std::string& path : diagnostics::files_below(folder, false).files)
        if (path.ends_with(".sleec")) result.push_back(path);
    return result;
}

}  // namespace

namespace {

/// True if a limit of the response, or of the responses after it, is above 0.
bool has_limit(const sleec::DutyPtr& duty) {
    if (duty == nullptr) return false;
    if (duty->measured || duty->from > 0 || duty->to.value_or(0) > 0 || has_limit(duty->otherwise)) return true;
    return std::ranges::any_of(duty->defeaters,
                               [](const sleec::CheckedDefeater& defeater) { return has_limit(defeater.duty); });
}

}  // namespace

bool counts_seconds(const sleec::CheckedRules& rules) {
    return !rules.unit && std::ranges::any_of(rules.rules, [](const sleec::CheckedRule& rule) {
        const bool delay = rule.written->form == sleec::RuleForm::at_least && rule.duty->to.value_or(0) >= 0;
        return delay || has_limit(rule.duty);
    });
}

void load_rules(const std::string& path, LoadedRules& loaded, durations::Unit unit) {
    loaded.path = path;
    std::string error;
    const std::optional<diagnostics::SourceId> source = load_input(loaded.sources, path, error);
    if (!source) {
        loaded.diagnostics.report(sleec::rules::unreadable, {},
                                  {diagnostics::escape_for_display(path), error + files_inside(path, ".sleec")});
        return;
    }
    const sleec::RuleFile file = sleec::read(loaded.sources, *source, loaded.diagnostics);
    if (loaded.diagnostics.ok()) loaded.rules = sleec::check_rules(file, loaded.diagnostics, unit);
}

RuleClaims::RuleClaims(const Project& project, const csp_emit::Emission& emission, const SearchContext& search)
    : project_(project), emission_(emission), search_(search) {}

RuleClaims::~RuleClaims() = default;

const std::vector<std::unique_ptr<LoadedRules>>& RuleClaims::rule_files_for(const std::string& assertions) {
    const std::filesystem::path path(assertions);
    const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
    if (const auto known = folders_.find(folder); known != folders_.end()) return known->second;
    std::vector<std::unique_ptr<LoadedRules>> files;  // stored only after all are read, because a limit may end the
                                                      // reading
    for (const std::string& rule_path : sleec_files(folder)) {
        auto loaded = std::make_unique<LoadedRules>();
        loaded->diagnostics.set_budget(&search_.services.budget());
        load_rules(std::filesystem::path(rule_path).lexically_normal().string(), *loaded, project_.unit);
        files.push_back(std::move(loaded));
    }
    return folders_.emplace(folder, std::move(files)).first->second;
}

/// Throws sleec::NotDecided with the reason if there is not exactly one rule of this name.
RuleClaims::Found RuleClaims::find(const ir::Property& property) {
    std::vector<Found> found;
    std::vector<std::string> names;
    std::string wrong;
    const auto& files = rule_files_for(property.file);
    for (const auto& file : files) {
        if (!file->rules && wrong.empty()) wrong = first_error(*file);
        for (std::size_t i = 0; file->rules && i < file->rules->rules.size(); ++i) {
            names.push_back(file->rules->name(i));
            if (names.back() == property.rule) found.push_back({file.get(), i});
        }
    }
    if (found.size() == 1) return found.front();
    if (found.size() > 1)
        throw sleec::NotDecided(fmt::format("`{}` is in several files: {} and {}", property.rule,
                                            diagnostics::escape_for_display(found[0].file->path),
                                            diagnostics::escape_for_display(found[1].file->path)));
    if (files.empty()) throw sleec::NotDecided("no file of rules (.sleec) lies beside the assertions");
    const std::string meant = diagnostics::nearest_spelling(property.rule, names);
    throw sleec::NotDecided(fmt::format("no rule is called `{}`{}{}", property.rule,
                                        meant.empty() ? "" : fmt::format("; did you mean `{}`?", meant),
                                        wrong.empty() ? "" : fmt::format("; a file of rules is wrong: {}", wrong)));
}

const csp_emit::ComponentProcesses* RuleClaims::find_component(const ir::Property& property) const {
    const std::string& path = property.subject.path;
    for (const csp_emit::ComponentProcesses& component : emission_.components)
        if (component.path == path || component.path == property.subject.package + "::" + path) return &component;
    return nullptr;
}

TimeStops RuleClaims::time_stops(const csp_emit::ComponentProcesses& component, const LoadedRules& file,
                                 const SearchContext& search) {
    if (const auto known = time_stops_.find(component.path); known != time_stops_.end()) return known->second;
    TimeStops stops = ModelRules({*file.rules, file.sources}, project_, emission_, component, search).time_stops();
    if (stops.unknown.empty()) time_stops_.emplace(component.path, stops);
    return stops;
}

void RuleClaims::decide_property(const ir::Property& property, const SearchContext& search, AssertionReport& report) {
    report.answer = Answer::error;
    try {
        const Found found = find(property);
        const csp_emit::ComponentProcesses* const component = find_component(property);
        if (component == nullptr) throw sleec::NotDecided(property.subject.path + " was not emitted");
        JudgedRule judged =
            ModelRules({*found.file->rules, found.file->sources}, project_, emission_, *component, search)
                .judge_rule(found.rule);
        report.statistics.states = judged.verdict.states;
        report.searched = true;
        report.reason = judged.verdict.reason;
        switch (judged.verdict.kind) {
            case RuleVerdict::Kind::not_applicable:
            case RuleVerdict::Kind::error:
                return;
            case RuleVerdict::Kind::not_decided:
                report.answer = Answer::inconclusive;
                return;
            case RuleVerdict::Kind::broken:
                report.answer = property.negated ? Answer::holds : Answer::fails;
                report.reason = fmt::format("{}", fmt::join(judged.verdict.lines, "; "));
                if (!property.negated) report.run = std::move(judged.run);
                return;
            case RuleVerdict::Kind::never_asked:
                add(report.basis,
                    {GroundKind::never_asked, "no run ever brings the rule to ask for anything", {}, {}, {}, {}});
                break;
            case RuleVerdict::Kind::obeyed:
                break;
        }
        report.answer = property.negated ? Answer::fails : Answer::holds;
        if (property.negated && report.reason.empty()) report.reason = "every run obeys the rule";
        const TimeStops time = time_stops(*component, *found.file, search);
        if (time.stops)
            add(report.basis, {GroundKind::time_stops,
                               fmt::format("time can stop in {}, which breaks no rule", component->path),
                               {},
                               {},
                               {},
                               "`is timelock-free` shows a run to where time stops"});
        const std::string behind = report.reason.empty() ? "" : "; ";
        if (!time.unknown.empty())
            report.reason +=
                fmt::format("{}not decided whether time can stop in {}: {}", behind, component->path, time.unknown);
    } catch (const sleec::NotDecided& error) {
        report.reason = error.what();
    }
}

}  // namespace robochart::driver
