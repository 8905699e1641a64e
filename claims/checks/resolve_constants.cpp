// SPDX-License-Identifier: Apache-2.0
// See resolve_constants.hpp.
#include "claims/checks/resolve_constants.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/spelling.hpp"
#include "claims/checks/conditions.hpp"
#include "claims/checks/duration.hpp"
#include "claims/checks/rules.hpp"
#include "semantics/ir/literals.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::claims {
namespace {

bool is_number(ir::TypeKind kind) {
    return kind == ir::TypeKind::nat || kind == ir::TypeKind::integer || kind == ir::TypeKind::real;
}

/// The path of a constant for options: "p::Patrol::patience".
std::string path_of(const ir::System& system, const std::string& source) {
    const std::vector<ir::NamedConstant> constants = ir::named_constants(system);
    const auto found = std::ranges::find(constants, source, &ir::NamedConstant::name);
    return found == constants.end() ? source : found->path;
}

}  // namespace

void ConstantResolver::refuse(const diagnostics::Rule& rule, Span span, std::string text) const {
    diagnostics_.report(rule, span, {std::move(text)});
    throw ClaimError{};
}

void ConstantResolver::add(const SetConstant& setting, const Component& of, CheckedClaim& claim) const {
    const ComponentConstant& constant = find_constant(setting.name, of);
    require_effect(setting, constant, of, claim);
    const auto same = [&](const auto& other) { return other.first == constant.source; };
    if (std::ranges::any_of(claim.constants, same))
        refuse(rules::wrong_form, setting.name.span, fmt::format("`{}` is set twice", constant.name));
    std::string text;
    claim.constants.emplace_back(constant.source, value_of(setting, constant, text));
    const std::string option = fmt::format("{}={}", path_of(system_, constant.source), text);
    claim.settings.insert(std::ranges::lower_bound(claim.settings, option), option);
}

const ComponentConstant& ConstantResolver::find_constant(const Name& name, const Component& of) const {
    const auto found = std::ranges::find(of.constants, name.text, &ComponentConstant::name);
    if (found != of.constants.end()) return *found;
    std::vector<std::string> names;
    for (const ComponentConstant& constant : of.constants) names.push_back(constant.name);
    const std::string meant = diagnostics::nearest_spelling(name.text, names);
    auto& finding = diagnostics_.report(rules::unknown_constant, name.span,
                                        {fmt::format("{} has no constant `{}`{}", of.path, name.text,
                                                     meant.empty() ? "" : fmt::format("; did you mean `{}`?", meant))});
    if (!meant.empty()) finding.fixes.push_back({name.span, meant, fmt::format("write `{}`", meant)});
    throw ClaimError{};
}

void ConstantResolver::require_effect(const SetConstant& setting, const ComponentConstant& constant,
                                      const Component& of, const CheckedClaim& claim) const {
    const std::set<std::string>& sources = claim.component.sources;
    if (sources.contains(constant.source)) return;
    std::string meant;
    for (const Component& other : components_)
        for (const ComponentConstant& known : other.constants)
            if (meant.empty() && known.name == constant.name && sources.contains(known.source)) meant = other.path;
    refuse(rules::unknown_constant, setting.component.span,
           fmt::format("the constant `{}` of {} does not affect {}{}", constant.name, of.path, claim.component.path,
                       meant.empty() ? "" : fmt::format("; did you mean `{}` of {}?", constant.name, meant)));
}

ir::ExprPtr ConstantResolver::value_of(const SetConstant& setting, const ComponentConstant& constant,
                                       std::string& text) const {
    text = setting.duration ? time_text(setting, constant) : setting.value;
    const ir::ExprPtr literal = ir::parse_literal(system_, constant.type, text);
    if (literal == nullptr)
        refuse(rules::wrong_value, setting.value_span,
               fmt::format("`{}` is not a literal of type {}, which `{}` has", text, system_.type(constant.type).name,
                           constant.name));
    ir::Expr placed = *literal;
    placed.span = setting.value_span;
    return std::make_shared<const ir::Expr>(std::move(placed));
}

/// The number of time units as a literal.
std::string ConstantResolver::time_text(const SetConstant& setting, const ComponentConstant& constant) const {
    const ir::Type& type = system_.type(constant.type);
    if (!is_number(type.kind))
        refuse(rules::wrong_value, setting.value_span,
               fmt::format("`{}` has the type {}, and no time", constant.name, type.name));
    if (!ir::constants_read_as_times(system_).contains(constant.name))
        refuse(rules::wrong_value, setting.value_span,
               fmt::format("`{}` is no time: no `wait`, no deadline and no comparison with a clock contains it; set it "
                           "to a number",
                           constant.name));
    const durations::UnitCount count = units_of(*setting.duration, unit_);
    if (!count.error.empty()) refuse(rules::wrong_duration, setting.value_span, count.error);
    return std::to_string(count.units);
}

}  // namespace robochart::claims
