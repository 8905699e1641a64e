// SPDX-License-Identifier: Apache-2.0
// See linking.hpp.
#include "claims/sleec/model/linking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "csp_emit/base/types.hpp"

namespace robochart::sleec {
namespace {

using csp_emit::EventMeaning;
using csp_emit::MeaningKind;

void events_of(const DutyPtr& duty, std::set<std::size_t>& events) {
    if (!duty) return;
    events.insert(duty->event);
    events_of(duty->otherwise, events);
    for (const CheckedDefeater& defeater : duty->defeaters) {
        if (defeater.event) events.insert(*defeater.event);
        events_of(defeater.duty, events);
    }
}

class Linker {
public:
    Linker(const CheckedRules& rules, const csp_emit::Emission& emission, std::string component,
           const ir::System& system, const ir::Instantiation& instantiation)
        : rules_(rules),
          emission_(emission),
          component_(std::move(component)),
          system_(system),
          instantiation_(instantiation) {}

    ComponentLinking link_all() {
        for (std::size_t i = 0; i < rules_.file->events.size(); ++i) link_event(rules_.event_name(i));
        for (std::size_t i = 0; i < rules_.file->measures.size(); ++i) link_measure(rules_.measure(i));
        return std::move(result_);
    }

private:
    /// The name in the model: the one given by `map`, without the component.
    [[nodiscard]] std::string model_name(const std::string& name) const {
        for (const Mapping& mapping : rules_.file->mappings)
            if (mapping.name.text == name) return mapping.element.text.substr(mapping.element.text.rfind(':') + 1);
        return name;
    }

    [[nodiscard]] const EventMeaning* find_meaning(const std::string& channel) const {
        const auto found = emission_.provenance.events.find(component_ + "::" + channel);
        return found == emission_.provenance.events.end() ? nullptr : &found->second;
    }

    void link_event(const std::string& name) {
        const std::string model = model_name(name);
        std::string why = fmt::format("{} has no event and no operation '{}'", component_, model);
        std::optional<std::string> channel;
        for (const char* end : {".in", ".out", "Call"}) {
            const EventMeaning* found = find_meaning(model + end);
            if (found == nullptr) continue;
            if (found->types.empty())
                channel = component_ + "::" + model + (*end == 'C' ? end : "");
            else
                why = fmt::format("'{}' of {} has data, but events of rules have none", model, component_);
            break;
        }
        result_.missing_events.push_back(channel ? "" : why);
        result_.linking.events.push_back(std::move(channel));
    }

    void link_measure(const Measure& measure) {
        const std::string model = model_name(measure.name.text);
        const EventMeaning* found = find_meaning(model + ".in");
        if (found == nullptr) found = find_meaning(model + ".out");
        std::optional<LinkedMeasure> linked;
        std::string why;
        if (found != nullptr && found->types.size() == 1) {
            linked = LinkedMeasure{component_ + "::" + model, {}};
            why = type_mismatch(measure, system_.types[found->types[0].index], *linked);
        } else if (found != nullptr) {
            why = fmt::format("'{}' of {} has no data", model, component_);
        }
        if (!why.empty()) linked.reset();
        result_.missing_measures.push_back(why);
        result_.linking.measures.push_back(std::move(linked));
    }

    /// The reason why the model's type does not fit; "" if it does.
    [[nodiscard]] std::string type_mismatch(const Measure& measure, const ir::Type& type, LinkedMeasure& linked) const {
        const std::string wrong = fmt::format("'{}' has the type {} in the model", measure.name.text, type.name);
        if (measure.type == MeasureType::boolean) return type.kind == ir::TypeKind::boolean ? "" : wrong;
        if (measure.type == MeasureType::numeric) {
            if (type.kind == ir::TypeKind::real && instantiation_.scale != 1)
                return fmt::format("'{}' is a real number, and the model has decimal fractions", measure.name.text);
            const bool number =
                type.kind == ir::TypeKind::nat || type.kind == ir::TypeKind::integer || type.kind == ir::TypeKind::real;
            return number ? "" : wrong;
        }
        if (type.kind != ir::TypeKind::enumeration) return wrong;
        for (const Name& literal : measure.literals) {
            const auto found = std::ranges::find(type.labels, literal.text);
            if (found == type.labels.end() || type.labels.size() != measure.literals.size())
                return fmt::format("the values of '{}' are not those of {}", measure.name.text, type.name);
            linked.literals.push_back(
                csp_emit::literal_name(type, static_cast<std::size_t>(found - type.labels.begin())));
        }
        return "";
    }

    const CheckedRules& rules_;
    const csp_emit::Emission& emission_;
    std::string component_;
    const ir::System& system_;
    const ir::Instantiation& instantiation_;
    ComponentLinking result_;
};

}  // namespace

ComponentLinking link_rules(const CheckedRules& rules, const csp_emit::Emission& emission, const std::string& component,
                            const ir::System& system, const ir::Instantiation& instantiation) {
    return Linker(rules, emission, component, system, instantiation).link_all();
}

std::string not_applicable(const CheckedRules& rules, std::size_t rule, const ComponentLinking& linking) {
    std::set<std::size_t> events{rules.rules[rule].trigger};
    events_of(rules.rules[rule].duty, events);
    for (const std::size_t event : events)
        if (!linking.missing_events[event].empty()) return linking.missing_events[event];
    for (const std::size_t measure : measures_of(rules.rules[rule]))
        if (!linking.missing_measures[measure].empty()) return linking.missing_measures[measure];
    return "";
}

}  // namespace robochart::sleec
