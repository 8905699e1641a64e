// SPDX-License-Identifier: Apache-2.0
// See wording.hpp.
#include "prism/assertions/robotool/wording.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace robochart::probability {
namespace {

constexpr std::string_view counter = "::scpc_8";
constexpr std::string_view entering = "_entering";

std::string owner_of(const std::string& element) {
    const std::size_t at = element.rfind("::");
    return at == std::string::npos ? "" : element.substr(0, at);
}

std::string last_of(const std::string& element) {
    return element.substr(element.rfind(':') + 1);
}

/// The value of a constant that is defined as a number.
std::optional<std::int32_t> value_of(const prism::ModelFile& model, const std::string& name) {
    const auto found =
        std::ranges::find_if(model.constants, [&](const prism::Constant& each) { return each.name.text == name; });
    if (found == model.constants.end() || !found->value || found->value->op != prism::Op::integer) return std::nullopt;
    const std::string& digits = found->value->text;
    std::int32_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc() && end == digits.data() + digits.size() ? std::optional(value) : std::nullopt;
}

/// R4: the counter of a region is at one of its nodes, or at the beginning of an entry action.
Wording::Variable place_of(const prism_emit::Emission& emission, const std::string& region) {
    Wording::Variable result{region + " at ", {{0, "no state"}}};
    for (const prism_emit::NameOf& each : emission.names) {
        if (each.kind != "node" || owner_of(each.element) != region) continue;
        if (const auto value = value_of(emission.model, each.name)) result.values[*value] = last_of(each.element);
        if (const auto value = value_of(emission.model, each.name + std::string(entering)))
            result.values[*value] = "the entry of " + last_of(each.element);
    }
    return result;
}

}  // namespace

Wording wording_of(const prism_emit::Emission& emission) {
    Wording result;
    for (const prism_emit::NameOf& each : emission.names) {
        if (each.kind == "STM") result.modules[each.name] = each.element;
        if (each.kind == "event") {
            // "M::c::s::e::IN"; a label has an end on both sides.
            const std::string end = owner_of(each.element) + (last_of(each.element) == "IN" ? ".in" : ".out");
            std::string& text = result.actions[each.name];
            text += (text.empty() ? "" : ", ") + end;
            result.variables.try_emplace("EVT__" + each.name, Wording::Variable{end + ".val = ", {}});
        }
        if (each.kind != "variable") continue;
        if (each.element.ends_with(counter)) {
            result.variables[each.name] =
                place_of(emission, each.element.substr(0, each.element.size() - counter.size()));
        } else if (!each.element.ends_with("::exit_9") && !each.element.ends_with("::lock_7")) {
            Wording::Variable variable{each.element + " = ", {}};
            for (std::size_t i = 0; i < each.literals.size(); ++i)
                variable.values[static_cast<std::int32_t>(i)] = each.literals[i];
            result.variables[each.name] = std::move(variable);
        }
    }
    return result;
}

}  // namespace robochart::probability
