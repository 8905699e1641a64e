// SPDX-License-Identifier: Apache-2.0
// See linking.hpp.
#include "claims/sleec/model/linking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/diagnostics/spelling.hpp"
#include "claims/checks/resolve_facts.hpp"
#include "claims/decide/letters.hpp"
#include "csp_emit/base/types.hpp"

namespace robochart::sleec {
namespace {

using csp_emit::EventMeaning;
using csp_emit::MeaningKind;

void events_of(const DutyPtr& duty, std::set<EventCases>& events) {
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
        for (const claims::Component& component : claims::components_of(system_))
            if (component.path == component_) visible_.component = component;
        result_.missing_events.resize(rules_.events.size());
        result_.linking.events.resize(rules_.events.size());
        for (std::size_t i = 0; i < rules_.file->events.size(); ++i) link_event(i);
        for (std::size_t i = 0; i < rules_.measures.size(); ++i)
            if (rules_.is_state(i))
                link_state(rules_.measure(i));
            else
                link_measure(rules_.measure(i));
        count_facts();
        result_.exact = visible_.component.machines.size() == 1;
        return std::move(result_);
    }

private:
    /// Returns the name in the model, which `map` may give. The component in this name is removed.
    [[nodiscard]] std::string model_name(const std::string& name) const {
        for (const Mapping& mapping : rules_.file->mappings)
            if (mapping.name.text == name) return mapping.element.text.substr(mapping.element.text.rfind(':') + 1);
        return name;
    }

    [[nodiscard]] const EventMeaning* find_meaning(const std::string& channel) const {
        const auto found = emission_.provenance.events.find(component_ + "::" + channel);
        return found == emission_.provenance.events.end() ? nullptr : &found->second;
    }

    void link_event(std::size_t declared) {
        const std::string model = model_name(rules_.file->events[declared].name.text);
        const std::vector<std::string>& defined = visible_.component.defined;
        const bool inside = std::ranges::find(defined, model) != defined.end();
        std::string why = inside ? fmt::format(
                                       "the model defines the operation '{}' of {}: its calls are not visible "
                                       "from outside; write a rule about the calls that it makes",
                                       model, component_)
                                 : fmt::format("{} has no event and no operation '{}'", component_, model);
        for (const char* end : {".in", ".out", "Call"}) {
            const EventMeaning* found = find_meaning(model + end);
            if (found == nullptr) continue;
            why = arguments_mismatch(declared, model, found->types);
            if (why.empty()) return link_cases(declared, component_ + "::" + model + (*end == 'C' ? end : ""), model);
            break;
        }
        for (std::size_t i = 0; i < rules_.events.size(); ++i)
            if (rules_.events[i].declared == declared) result_.missing_events[i] = why;
    }

    /// Returns the reason why the arguments in the rules do not fit the event; "" if they do.
    [[nodiscard]] std::string arguments_mismatch(std::size_t declared, const std::string& model,
                                                 const std::vector<ir::TypeId>& types) const {
        const std::vector<Argument>& arguments = rules_.arguments[declared];
        if (arguments.empty()) return "";  // any values
        if (arguments.size() != types.size())
            return fmt::format("'{0}' of {1} carries {2} value{3}, and `{4}` has {5}: write `{4}` without arguments",
                               model, component_, types.size(), types.size() == 1 ? "" : "s",
                               rules_.file->events[declared].name.text, arguments.size());
        for (std::size_t i = 0; i < types.size(); ++i) {
            const ir::Type& type = system_.type(types[i]);
            const bool fits = arguments[i].kind == ArgumentKind::any ||
                              (arguments[i].kind == ArgumentKind::truth && type.kind == ir::TypeKind::boolean) ||
                              (arguments[i].kind == ArgumentKind::number && csp_emit::is_numeric(type)) ||
                              (arguments[i].kind == ArgumentKind::literal && type.kind == ir::TypeKind::enumeration);
            if (!fits)
                return fmt::format("'{}' of {} carries values of the type {}, not `{}`", model, component_, type.name,
                                   arguments[i].values.front());
            for (const std::string& value : arguments[i].values)
                if (type.kind == ir::TypeKind::enumeration &&
                    std::ranges::find(type.labels, value) == type.labels.end())
                    return fmt::format("'{}' is no literal of the type {}{}", value, type.name,
                                       meant_by(value, type.labels));
        }
        return "";
    }
    static std::string meant_by(const std::string& name, const std::vector<std::string>& names) {
        const std::string meant = diagnostics::nearest_spelling(name, names);
        return meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant);
    }

    /// Links an event. If no rule names values of the event, it is linked to its whole channel. Otherwise, each case is
    /// linked to the letters with its values.
    void link_cases(std::size_t declared, const std::string& channel, const std::string& model) {
        const bool whole = std::ranges::all_of(rules_.arguments[declared],
                                               [](const Argument& argument) { return argument.values.empty(); });
        std::map<std::size_t, LinkedEvent> found;
        std::string why;
        try {
            if (!whole)
                for (const claims::Letter& letter : letters_of(model)) {
                    const auto event = rules_.case_of(declared, texts_of(letter));
                    LinkedEvent& linked = found.try_emplace(event.value(), LinkedEvent({}, {})).first->second;
                    linked.events.insert(linked.events.end(), letter.events.begin(), letter.events.end());
                    linked.prefixes.insert(linked.prefixes.end(), letter.prefixes.begin(), letter.prefixes.end());
                }
        } catch (const claims::NotDecided& error) {
            why = error.what();
        }
        for (std::size_t i = 0; i < rules_.events.size(); ++i) {
            if (rules_.events[i].declared != declared) continue;
            result_.missing_events[i] = why;
            const auto event = found.find(i);
            const LinkedEvent never({}, {});
            if (whole)
                result_.linking.events[i] = LinkedEvent(channel);
            else if (why.empty())
                result_.linking.events[i] = event == found.end() ? never : event->second;
        }
    }

    /// Returns the events of the script with this name, one for each combination of values.
    [[nodiscard]] std::vector<claims::Letter> letters_of(const std::string& model) {
        visible_.remembered.clear();
        for (std::size_t i = 0; i < visible_.component.channels.size(); ++i)
            if (visible_.component.channels[i].name == model) visible_.remembered.push_back(i);
        return claims::letters_of(visible_, system_, instantiation_, {});
    }

    /// Returns the values of the letter as texts.
    [[nodiscard]] std::vector<std::string> texts_of(const claims::Letter& letter) const {
        const claims::Channel& channel = visible_.component.channels[letter.occurrence.channel];
        std::vector<std::string> result;
        for (std::size_t i = 0; i < channel.types.size(); ++i) {
            const ir::Type& type = system_.type(channel.types[i]);
            const claims::Fraction& value = letter.occurrence.values[i];
            if (type.kind == ir::TypeKind::boolean)
                result.emplace_back(value == claims::Fraction(0) ? "false" : "true");
            else if (type.kind == ir::TypeKind::enumeration)
                result.push_back(type.labels[static_cast<std::size_t>(value.numerator())]);
            else
                result.push_back(value.is_whole() ? fmt::format("{}", value.numerator()) : "");
        }
        return result;
    }

    /// Finds the state in the machines of the component, as claims do.
    void link_state(const Measure& measure) {
        constexpr std::size_t word = 3;  // "in "
        const diagnostics::SourceManager sources;
        diagnostics::Diagnostics findings;
        std::string why;
        std::optional<LinkedMeasure> linked;
        try {
            claims::FactResolver resolver(system_, visible_, sources, findings);
            const std::size_t fact = resolver.fact_of_state({measure.name.text.substr(word), measure.name.span});
            linked = show(visible_.facts[fact]);
        } catch (const claims::ClaimError&) {
            why = findings.sorted_findings().front().message();
        }
        result_.missing_measures.push_back(std::move(why));
        result_.linking.measures.push_back(std::move(linked));
    }
    LinkedMeasure show(const claims::Fact& fact) {
        std::vector<claims::Fact>& facts = result_.shown[fact.machine];
        const auto known = std::ranges::find(facts, fact);
        const auto place = static_cast<std::size_t>(known - facts.begin());
        if (known == facts.end()) facts.push_back(fact);
        return {claims::shown_channel(fact.machine), {}, place, 0};
    }
    /// Sets the number of facts that the machine of each linked state shows. Must be called after all states are
    /// linked.
    void count_facts() {
        for (auto& linked : result_.linking.measures)
            for (const auto& [machine, facts] : result_.shown)
                if (linked && linked->channel == claims::shown_channel(machine)) linked->facts = facts.size();
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

    /// Returns the reason why the model's type does not fit; "" if it does.
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
    claims::CheckedClaim visible_;  ///< a claim about the component without a body, for the functions of claims
    ComponentLinking result_;
};

}  // namespace

ComponentLinking link_rules(const CheckedRules& rules, const csp_emit::Emission& emission, const std::string& component,
                            const ir::System& system, const ir::Instantiation& instantiation) {
    return Linker(rules, emission, component, system, instantiation).link_all();
}

std::string not_applicable(const CheckedRules& rules, std::size_t rule, const ComponentLinking& linking) {
    std::set<EventCases> events{rules.rules[rule].trigger};
    events_of(rules.rules[rule].duty, events);
    for (const EventCases& cases : events) {
        for (const std::size_t event : cases)
            if (!linking.missing_events[event].empty()) return linking.missing_events[event];
        const bool possible = std::ranges::any_of(
            cases, [&](std::size_t event) { return !linking.linking.events[event]->events.empty(); });
        if (!possible) return fmt::format("no value of the instantiation is meant by {}", rules.event_name(cases));
    }
    for (const std::size_t measure : measures_of(rules.rules[rule]))
        if (!linking.missing_measures[measure].empty()) return linking.missing_measures[measure];
    return "";
}

}  // namespace robochart::sleec
