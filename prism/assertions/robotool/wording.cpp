// SPDX-License-Identifier: Apache-2.0
// See wording.hpp.
#include "prism/assertions/robotool/wording.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include "prism/assertions/properties/names.hpp"

namespace robochart::probability {
namespace {

constexpr std::string_view counter = "::scpc_8";
constexpr std::string_view entering = "_entering";

/// Returns the value of a constant that is defined as a whole number.
std::optional<std::int32_t> value_of(const prism::ModelFile& model, const std::string& name) {
    const auto found = std::ranges::find_if(
        model.constants, [&](const prism::Constant& constant) { return constant.name.text == name; });
    if (found == model.constants.end() || !found->value || found->value->op != prism::Op::integer) return std::nullopt;
    const std::string& digits = found->value->text;
    std::int32_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc() && end == digits.data() + digits.size() ? std::optional(value) : std::nullopt;
}

/// Returns the names of the positions in a region. By R4, the counter of a region is at one of its nodes, or at the
/// beginning of an entry action.
Wording::Variable place_of(const prism_emit::Emission& emission, const std::string& region) {
    Wording::Variable result{region + " at ", {{0, "no state"}}};
    for (const prism_emit::NameOf& renaming : emission.names) {
        if (renaming.kind != "node" || owner_of(renaming.element) != region) continue;
        if (const auto value = value_of(emission.model, renaming.name))
            result.values[*value] = last_of(renaming.element);
        if (const auto value = value_of(emission.model, renaming.name + std::string(entering)))
            result.values[*value] = "the entry of " + last_of(renaming.element);
    }
    return result;
}

}  // namespace

Wording wording_of(const prism_emit::Emission& emission) {
    Wording result;
    for (const prism_emit::NameOf& renaming : emission.names) {
        if (renaming.kind == "STM") result.modules[renaming.name] = renaming.element;
        if (renaming.kind == "event") {
            // For example "M::c::s::e::IN". A label stands for both ends of a connection.
            const std::string end = owner_of(renaming.element) + (last_of(renaming.element) == "IN" ? ".in" : ".out");
            std::string& text = result.actions[renaming.name];
            text += (text.empty() ? "" : ", ") + end;
            result.variables.try_emplace("EVT__" + renaming.name, Wording::Variable{end + ".val = ", {}});
        }
        if (renaming.kind != "variable") continue;
        if (renaming.element.ends_with(counter)) {
            result.variables[renaming.name] =
                place_of(emission, renaming.element.substr(0, renaming.element.size() - counter.size()));
        } else if (!renaming.element.ends_with("::exit_9") && !renaming.element.ends_with("::lock_7")) {
            Wording::Variable variable{renaming.element + " = ", {}};
            for (std::size_t i = 0; i < renaming.literals.size(); ++i)
                variable.values[static_cast<std::int32_t>(i)] = renaming.literals[i];
            result.variables[renaming.name] = std::move(variable);
        }
    }
    return result;
}

}  // namespace robochart::probability
