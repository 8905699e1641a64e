// SPDX-License-Identifier: Apache-2.0
// See rule_duties.hpp.
#include "app/rules/rule_duties.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/command/run.hpp"
#include "app/rules/record_rules.hpp"
#include "app/rules/show_findings.hpp"
#include "base/diagnostics/escape.hpp"
#include "cpp_emit/files/trace_names.hpp"
#include "driver/model/claim_files.hpp"

namespace robochart::app {
namespace {

/// Returns the value of a measure as in the rules; no value if the rules cannot express it.
std::optional<std::int64_t> value_of(const sleec::Measure& measure, const cpp_emit::Port& port, rc_value value) {
    const bool boolean = measure.type == sleec::MeasureType::boolean;
    const bool scale = measure.type == sleec::MeasureType::scale;
    switch (port.arguments.front()) {
        case cpp_emit::Carried::boolean:
            return boolean ? std::optional(value.whole) : std::nullopt;
        case cpp_emit::Carried::whole:
            return !boolean && !scale ? std::optional(value.whole) : std::nullopt;
        case cpp_emit::Carried::real: {
            constexpr double exact = 9e15;
            const bool whole = std::abs(value.real) < exact && std::trunc(value.real) == value.real;
            return !boolean && !scale && whole ? std::optional(static_cast<std::int64_t>(value.real)) : std::nullopt;
        }
        case cpp_emit::Carried::enumeration:
            break;
    }
    const auto& literals = port.literals.front();
    if (!scale || value.whole < 0 || static_cast<std::size_t>(value.whole) >= literals.size()) return std::nullopt;
    const std::string& literal = literals[static_cast<std::size_t>(value.whole)];
    for (std::size_t i = 0; i < measure.literals.size(); ++i)
        if (measure.literals[i].text == literal) return static_cast<std::int64_t>(i);
    return std::nullopt;
}

/// Collects the events of a response, including those after `otherwise` and `unless`.
void events_of(const sleec::DutyPtr& duty, std::vector<std::size_t>& events) {
    if (duty == nullptr) return;
    events.insert(events.end(), duty->event.begin(), duty->event.end());
    events_of(duty->otherwise, events);
    for (const sleec::CheckedDefeater& defeater : duty->defeaters) events_of(defeater.duty, events);
}

}  // namespace

/// Follows the rules for one robot.
class RuleDuties::Robot final : public Follower {
public:
    explicit Robot(RuleDuties& all)
        : all_(all), run_({all.rules_, all.loaded_->sources}, sleec::WithoutLimit::eventually) {}

    [[nodiscard]] std::vector<BrokenDuty> observe_cycle(const rc_signal* inputs, const rc_actions& outputs,
                                                        rc_drive_result /*result*/) override {
        if (run_.is_broken() || !given_up_.empty()) return {};
        try {
            follow_cycle(inputs, outputs);
        } catch (const sleec::NotDecided& error) {
            given_up_ = error.what();
            return {};
        }
        if (!run_.is_broken()) return {};
        BrokenDuty broken;
        broken.reasons = fmt::format("{}", fmt::join(run_.violation_text(), "; "));
        broken.cause = broken.reasons;
        broken.place = all_.loaded_->sources.path_and_line(run_.violation_place());
        return {broken};
    }
    [[nodiscard]] bool is_conclusive() const override { return given_up_.empty() && run_.open_triggers().empty(); }
    void end() override {
        if (!given_up_.empty()) all_.given_up_ = given_up_;
        for (const std::size_t rule : run_.open_triggers()) ++all_.open_[rule];
    }

private:
    void follow_cycle(const rc_signal* inputs, const rc_actions& outputs) {
        const auto& emission = all_.emission_;
        for (std::size_t i = 0; i < all_.inputs_.size(); ++i)
            if (inputs[i].present != 0) take_port(all_.inputs_[i], emission.inputs[i], &inputs[i].value);
        for (std::uint32_t a = 0; a < outputs.count; ++a) {
            const rc_action& action = outputs.action[a];
            take_port(all_.outputs_[action.output], emission.outputs[action.output], action.argument);
        }
        for (std::uint32_t t = 0; t < all_.units_ && !run_.is_broken(); ++t) run_.end_second();
    }

    void take_port(const Linked& linked, const cpp_emit::Port& port, const rc_value* values) {
        for (const std::size_t measure : linked.measures)
            run_.read(measure, port.arguments.size() == 1 ? value_of(all_.rules_.measure(measure), port, *values)
                                                          : std::nullopt);
        for (const std::size_t declared : linked.events) {
            std::vector<std::string> texts;
            if (!all_.rules_.arguments[declared].empty()) texts = carried_texts(port, values);
            if (const auto event = all_.rules_.case_of(declared, texts)) run_.add_event(*event);
        }
    }

    RuleDuties& all_;
    driver::RuleRun run_;
    std::string given_up_;  ///< the rules demand more than a monitor can follow: the reason
};

RuleDuties::RuleDuties(std::unique_ptr<driver::LoadedRules> loaded, const cpp_emit::DriveEmission& emission,
                       std::uint32_t units)
    : loaded_(std::move(loaded)),
      emission_(emission),
      units_(units),
      rules_(*loaded_->rules),
      has_(rules_.file->events.size(), false) {
    inputs_ = link_ports(emission.inputs);
    outputs_ = link_ports(emission.outputs);
    leave_out();
}

std::vector<RuleDuties::Linked> RuleDuties::link_ports(const std::vector<cpp_emit::Port>& ports) {
    const driver::RuleWords words(*loaded_->rules);
    std::vector<std::string> exported;
    for (const cpp_emit::Port& port : ports) exported.push_back(port.exported);
    std::vector<Linked> result;
    for (const std::string& name : cpp_emit::trace_names(exported)) {
        const cpp_emit::Port& port = ports[result.size()];
        result.push_back({words.declared_by_word(name), words.measures_of_word(name)});
        for (const std::size_t declared : result.back().events) {
            const std::size_t count = rules_.arguments[declared].size();
            if (count == 0 || count == port.arguments.size()) has_[declared] = true;
        }
    }
    return result;
}

/// Removes rules about events that the controller does not have.
void RuleDuties::leave_out() {
    std::vector<sleec::CheckedRule> followed;
    for (std::size_t i = 0; i < rules_.rules.size(); ++i) {
        const sleec::CheckedRule& rule = rules_.rules[i];
        if (rule.assumed) continue;
        std::vector<std::size_t> events(rule.trigger.begin(), rule.trigger.end());
        events_of(rule.duty, events);
        const auto missing =
            std::ranges::find_if(events, [&](std::size_t event) { return !has_[rules_.events[event].declared]; });
        if (missing != events.end())
            left_out_.push_back(fmt::format("{}: the controller has no event and no operation '{}'", rules_.name(i),
                                            rules_.event_name(*missing)));
        else if (sleec::reads_states(rules_, i))
            left_out_.push_back(fmt::format("{}: events do not show states", rules_.name(i)));
        else
            followed.push_back(rule);
    }
    rules_.rules = std::move(followed);
}

std::unique_ptr<Follower> RuleDuties::make_follower(std::size_t /*robot*/) {
    return std::make_unique<Robot>(*this);
}

std::string RuleDuties::summary_lines(std::uint64_t robots) const {
    std::string text = fmt::format("  rules of {}: {} followed; robots watched: {}; {}\n",
                                   diagnostics::escape_for_display(loaded_->path), followed_count(), robots,
                                   rules_.unit ? durations::second_text(rules_.unit) : "a time unit is a second");
    for (const std::string& reason : left_out_) text += fmt::format("  not followed: {}\n", reason);
    if (!given_up_.empty()) text += fmt::format("  robots were not followed to the end: {}\n", given_up_);
    for (const auto& [rule, count] : open_)
        text += fmt::format(
            "  {}: of {} robots some triggers were not followed: a measure that decides what it asks for is not read\n",
            rules_.name(rule), count);
    return text;
}

namespace {

/// Why the rules cannot be followed with these times; "" if they can.
std::string refuse_unit(const std::optional<claims::DeclaredUnit>& declared, const RuleDuties& duties,
                        const GuardedTimes& times, const diagnostics::SourceManager& sources) {
    using durations::duration_text;
    if (!times.unit) return "";
    if (declared && declared->nanoseconds != *times.unit)
        return fmt::format("one time unit is {} in the scenario, and {} in {}", duration_text(*times.unit),
                           duration_text(declared->nanoseconds), sources.path_and_line(declared->span));
    if (!duties.counts_seconds() || *times.unit == durations::second) return "";
    return fmt::format(
        "one time unit is {0} in the scenario, and the rules have limits in seconds: declare `unit {0}` in a .claims "
        "file beside the rules or the model; without it, a second of the rules would be one time unit",
        duration_text(*times.unit));
}

}  // namespace

std::unique_ptr<RuleDuties> find_rule_duties(const std::string& file, const cpp_emit::DriveEmission& emission,
                                             const GuardedTimes& times, const Options& options, std::string& error) {
    auto loaded = std::make_unique<driver::LoadedRules>();
    loaded->diagnostics.set_budget(&options.run->budget());
    for (const std::string& code : options.load.allowed) loaded->diagnostics.allow_code(code);
    const auto declared = driver::unit_beside({file, times.scenario}, loaded->sources, loaded->diagnostics);
    load_rules(file, *loaded, declared ? durations::Unit(declared->nanoseconds) : std::nullopt);
    record_rules(*loaded, options);
    show_rule_findings(*loaded, options);
    if (!loaded->rules) {
        error = "the file has errors";
        return nullptr;
    }
    const diagnostics::SourceManager& sources = loaded->sources;
    auto duties = std::make_unique<RuleDuties>(std::move(loaded), emission, times.units);
    error = duties->followed_count() > 0 ? refuse_unit(declared, *duties, times, sources)
                                         : "the controller has the events of none of its rules";
    return error.empty() ? std::move(duties) : nullptr;
}

}  // namespace robochart::app
