// SPDX-License-Identifier: Apache-2.0
// Looks up names in csp_emit::Provenance, which records their meaning when the script is created.
#include "counterexample/meanings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "counterexample/values.hpp"

namespace robochart::runs {
namespace {

using csp_emit::DefinitionMeaning;
using csp_emit::EventMeaning;
using csp_emit::MeaningKind;
using csp_emit::OfferMeaning;
using csp_emit::ParameterKind;

Kind kind_of(MeaningKind kind) {
    switch (kind) {
        case MeaningKind::transition:
            return Kind::transition;
        case MeaningKind::trigger:
            return Kind::input;
        case MeaningKind::output:
            return Kind::output;
        case MeaningKind::call:
            return Kind::call;
        case MeaningKind::entered:
            return Kind::entered;
        case MeaningKind::exited:
            return Kind::exited;
        case MeaningKind::assignment:
            return Kind::assignment;
        case MeaningKind::external_write:
            return Kind::external_write;
        case MeaningKind::terminate:
            return Kind::terminate;
        case MeaningKind::tock:
            return Kind::tock;
        case MeaningKind::refusal:
            return Kind::refusal;
        case MeaningKind::event_read:
        case MeaningKind::variable_read:
            return Kind::read;
        case MeaningKind::cycle_end:
            return Kind::cycle_end;
        case MeaningKind::step:
        case MeaningKind::memory:
            break;
    }
    return Kind::internal;
}

VariableKind kind_of(ParameterKind kind) {
    switch (kind) {
        case ParameterKind::variable:
            return VariableKind::variable;
        case ParameterKind::clock:
            return VariableKind::clock;
        case ParameterKind::constant:
            return VariableKind::constant;
        case ParameterKind::countdown:
            return VariableKind::countdown;
        case ParameterKind::temporary:
            break;
    }
    return VariableKind::temporary;
}

/// Describes the content of the register of an event: whether it is full, and its value. The value is arbitrary if the
/// register is empty.
std::string register_text(const EventMeaning& event, const std::vector<Value>& values) {
    const bool full = values.front().text == "true";
    if (values.size() == 1) return (full ? "" : "no ") + event.text;
    return full ? fmt::format("{} with {}", event.text, values.back().text)
                : fmt::format("no {}, its register contains {}", event.text, values.back().text);
}

std::string with_values(const EventMeaning& event, const std::vector<Value>& values) {
    if (values.empty()) return event.text;
    std::vector<std::string> shown;
    for (const Value& value : values) shown.push_back(value.text);
    const std::string joined = fmt::format("{}", fmt::join(shown, ", "));
    switch (event.kind) {
        case MeaningKind::assignment:
        case MeaningKind::external_write:
            return fmt::format("{} = {}", event.text, joined);
        case MeaningKind::call:
            return fmt::format("{}({})", event.text, joined);
        case MeaningKind::variable_read:
            return fmt::format("{} = {}", event.text, joined);
        case MeaningKind::event_read:
            return register_text(event, values);
        case MeaningKind::cycle_end:
        case MeaningKind::transition:
        case MeaningKind::trigger:
        case MeaningKind::output:
        case MeaningKind::entered:
        case MeaningKind::exited:
        case MeaningKind::terminate:
        case MeaningKind::step:
        case MeaningKind::memory:
        case MeaningKind::tock:
        case MeaningKind::refusal:
            break;
    }
    return fmt::format("{} with {}", event.text, joined);
}

/// Returns true if the parameter is no longer read. The evaluator then stores no value for it.
bool is_unread(const std::string& value) {
    return value == "_" || value == "'_'";
}

/// Returns the text, states and values that all alternatives have in common.
Call common_meaning(const std::vector<Call>& alternatives) {
    Call result = alternatives.front();
    if (alternatives.size() == 1) return result;
    auto merged = std::make_shared<DefinitionMeaning>(*result.definition);
    std::vector<std::string> texts;
    for (const Call& alternative : alternatives) {
        if (std::ranges::find(texts, alternative.definition->text) == texts.end())
            texts.push_back(alternative.definition->text);
        const auto& others = alternative.definition->active;
        // It is not known which alternative applies, so transitions to states of all alternatives are included.
        const auto& ahead = alternative.definition->ahead;
        merged->ahead.insert(merged->ahead.end(), ahead.begin(), ahead.end());
        for (const ir::Origin& state : others) merged->ahead.push_back(state.element);
        std::erase_if(merged->active, [&](const ir::Origin& state) {
            return std::ranges::none_of(others,
                                        [&](const ir::Origin& other) { return other.element == state.element; });
        });
        for (std::size_t i = 0; i < merged->parameters.size() && i < result.arguments.size(); ++i) {
            const auto& names = alternative.definition->parameters;
            const auto same = static_cast<std::size_t>(std::ranges::find(names, merged->parameters[i]) - names.begin());
            const bool equal =
                same < alternative.arguments.size() && alternative.arguments[same] == result.arguments[i];
            if (!equal) merged->parameters[i].clear();
        }
    }
    std::erase_if(merged->remembered, [&](const std::string& name) {
        return std::ranges::any_of(alternatives, [&](const Call& alternative) {
            const auto& others = alternative.definition->remembered;
            return std::ranges::find(others, name) == others.end();
        });
    });
    merged->text = fmt::format("{}", fmt::join(texts, " or "));
    merged->offers.clear();
    result.definition = std::move(merged);
    return result;
}

/// Returns true if a part of `text`, possibly after an operation's name, is `words` followed by its details.
bool has_part(const std::string& text, const std::string& words) {
    for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
        const std::string_view before(text.data(), at);
        const std::size_t end = at + words.size();
        const bool begins = before.empty() || before.ends_with(": ") || before.ends_with(" or ");
        if (begins && (end == text.size() || text[end] == ',' || text[end] == ' ')) return true;
    }
    return false;
}

/// Returns true if a definition with this text is inside the transition.
bool is_in_transition(const std::string& text, const std::string& name) {
    return has_part(text, "transition " + name) || has_part(text, "action of " + name);
}

/// Returns true if this transition or statement may have led the process to one of these definitions.
bool leads_to(const OfferMeaning& offer, const std::vector<Call>& after) {
    if (offer.target.empty()) return true;
    return std::ranges::any_of(after, [&](const Call& call) {
        const auto& active = call.definition->active;
        const bool there =
            std::ranges::any_of(active, [&](const ir::Origin& state) { return state.element == offer.target; });
        const bool ahead = std::ranges::find(call.definition->ahead, offer.target) != call.definition->ahead.end();
        return there || ahead || is_in_transition(call.definition->text, offer.name);
    });
}

}  // namespace

const EventMeaning* Meanings::meaning_of(const std::string& name, std::string& arguments) const {
    std::string prefix = name;
    while (true) {
        if (const auto found = provenance_.events.find(prefix); found != provenance_.events.end()) {
            arguments = name.substr(std::min(name.size(), prefix.size() + 1));
            return &found->second;
        }
        const auto dot = prefix.rfind('.');
        if (dot == std::string::npos) return nullptr;
        prefix.resize(dot);
    }
}

bool Meanings::knows_event(const std::string& name) const {
    std::string arguments;
    return meaning_of(name, arguments) != nullptr;
}

bool Meanings::is_memory(const std::string& name) const {
    std::string arguments;
    const EventMeaning* found = meaning_of(name, arguments);
    return found != nullptr && found->kind == MeaningKind::memory;
}

Event Meanings::event_of(const std::string& name) const {
    Event result;
    std::string arguments;
    const EventMeaning* found = meaning_of(name, arguments);
    if (found == nullptr) {
        if (name == "✓") {
            result.kind = Kind::terminate;
            result.text = "termination";
        } else if (name == "τ") {
            result.kind = Kind::internal;
            result.text = "an internal step";
        } else {
            result.kind = Kind::event;
            result.text = name;
        }
        return result;
    }
    result.kind = kind_of(found->kind);
    result.component = found->component;
    result.element = found->origin.element;
    result.place = place_of(found->origin.span);
    if (found->kind == MeaningKind::refusal) {
        const Event refused = event_of(arguments);
        result.text = found->text + " " + (refused.kind == Kind::tock ? "the passing of time" : refused.text);
        result.component = refused.component;
        result.element = refused.element;
        result.values = refused.values;
        result.place = refused.place;
        return result;
    }
    result.values = values_of_event(system_, instantiation_, found->types, arguments);
    result.text = with_values(*found, result.values);
    const bool empty =
        found->kind == MeaningKind::event_read && !result.values.empty() && result.values.front().text != "true";
    if (empty) result.kind = Kind::empty_read;
    return result;
}

Meanings::Offers Meanings::possible_offers(const std::string& name, const Call& before,
                                           const std::vector<Call>& after) {
    const std::string owner = before.definition->component + "::";
    if (!name.starts_with(owner)) return {};
    const std::string relative = name.substr(owner.size());
    Offers offers;
    for (const auto& offer : before.definition->offers)
        if (relative == offer->event || relative.starts_with(offer->event + ".")) offers.push_back(offer.get());
    const auto leads_here = [&](const csp_emit::OfferMeaning* offer) { return leads_to(*offer, after); };
    if (offers.size() > 1 && std::ranges::any_of(offers, leads_here)) std::erase_if(offers, std::not_fn(leads_here));
    return offers;
}

Event Meanings::event_of(const std::string& name, const Call& before, const std::vector<Call>& after) const {
    Event result = event_of(name);
    const Offers offers = possible_offers(name, before, after);
    if (offers.size() != 1) return result;
    result.via = offers.front()->text;
    result.element = offers.front()->origin.element;
    if (const auto at = place_of(offers.front()->origin.span)) result.place = at;
    return result;
}

std::vector<std::string> Meanings::elements_of(const std::string& name, const Call& before,
                                               const std::vector<Call>& after) const {
    std::vector<std::string> result;
    for (const csp_emit::OfferMeaning* offer : possible_offers(name, before, after))
        result.push_back(offer->origin.element);
    if (const Event whole = event_of(name); result.empty() && !whole.element.empty()) result.push_back(whole.element);
    return result;
}

std::optional<Call> Meanings::call_of(std::string_view text) const {
    const auto bracket = text.find('(');
    const auto found = provenance_.definitions.find(std::string(text.substr(0, bracket)));
    if (found == provenance_.definitions.end()) return std::nullopt;
    // This pointer does not own the meaning, because the provenance outlives the result.
    Call known{{std::shared_ptr<void>(), &found->second}, {}};
    if (bracket != std::string_view::npos && text.back() == ')')
        for (const std::string& argument :
             split_outside_brackets(text.substr(bracket + 1, text.size() - bracket - 2), ","))
            known.arguments.emplace_back(trim_blanks(argument));
    return known;
}

std::vector<Call> Meanings::calls_in(const std::string& description) const {
    std::vector<Call> result;
    for (const std::string& part : split_outside_brackets(description, "‖")) {
        std::string_view text = trim_blanks(part);
        const bool grouped = text.size() > 1 && text.front() == '(' && text.back() == ')';
        if (grouped) text = text.substr(1, text.size() - 2);
        std::vector<Call> alternatives;
        for (const std::string& alternative : split_outside_brackets(text, "⊓"))
            if (auto known = call_of(trim_blanks(alternative))) alternatives.push_back(std::move(*known));
        if (!alternatives.empty()) result.push_back(common_meaning(alternatives));
    }
    return result;
}

std::vector<Variable> Meanings::variables_of(const Call& call) const {
    const DefinitionMeaning& definition = *call.definition;
    std::vector<Variable> result;
    for (std::size_t i = 0; i < call.arguments.size() && i < definition.parameters.size(); ++i) {
        if (definition.parameters[i].empty()) continue;
        Variable variable;
        variable.name = definition.parameters[i];
        if (i < definition.kinds.size()) variable.kind = kind_of(definition.kinds[i]);
        const ir::TypeId type = i < definition.types.size() ? definition.types[i] : ir::TypeId{};
        if (type.is_valid()) variable.type = system_.type(type).name;
        if (!is_unread(call.arguments[i]))
            variable.value = value_text(system_, instantiation_, type, call.arguments[i]);
        if (i < definition.deadlines.size() && definition.deadlines[i].span.is_known()) {
            variable.deadline = definition.deadlines[i].element;
            variable.place = place_of(definition.deadlines[i].span);
        }
        result.push_back(std::move(variable));
    }
    return result;
}

Machine Meanings::machine_of(const Call& call) const {
    const DefinitionMeaning& definition = *call.definition;
    Machine result;
    result.component = definition.component;
    result.machine = definition.machine;
    result.text = definition.text;
    for (const ir::Origin& state : definition.active) result.active.push_back(state.element);
    result.variables = variables_of(call);
    result.place = place_of(definition.origin.span);
    return result;
}

std::optional<Place> Meanings::place_of(diagnostics::Span span) const {
    if (!span.is_known()) return std::nullopt;
    const auto begin = sources_.position(span.source, span.begin);
    const auto end = sources_.position(span.source, span.end);
    return Place{sources_.path(span.source), begin.line, begin.column, end.line, end.column};
}

}  // namespace robochart::runs
