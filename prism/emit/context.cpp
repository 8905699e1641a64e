// SPDX-License-Identifier: Apache-2.0
#include "prism/emit/context.hpp"

#include <algorithm>

#include "prism/emit/rules.hpp"
#include "prism/emit/tree.hpp"
#include "prism/syntax/lexer.hpp"

namespace robochart::prism_emit {

std::string Context::unique_name(const std::string& preferred) {
    const bool of_channels =
        preferred.starts_with("EVT__") || preferred.starts_with("FIN__");  // prefixes of channels.hpp
    std::string name = of_channels ? "_" + preferred : preferred;
    while (prism::is_reserved(name) || !taken_.insert(name).second) name += "_";
    return name;
}

void Context::record_name(const ir::Variable& variable, const std::string& element, const std::string& name) {
    const ir::Type& type = system.type(variable.type);
    const bool named = type.kind == ir::TypeKind::enumeration;
    emission.names.push_back({"variable", element, name, named ? type.labels : std::vector<std::string>{}});
}

void Context::record_name(const std::string& kind, const std::string& element, const std::string& name) {
    emission.names.push_back({kind, element, name});
}

std::optional<Carrier> Context::find_carrier(ir::TypeId type, const std::string& element,
                                             const diagnostics::Span& span) {
    // R3: "int INT_MIN..INT_MAX, nat NAT_*, real REAL_* as an integer range, enumerations 0..n-1, boolean."
    const ir::Type& found = system.type(type);
    const auto range = [](const Range& bounds) { return Carrier{false, bounds.low, bounds.high}; };
    std::optional<Carrier> result;
    if (found.kind == ir::TypeKind::boolean) result = Carrier{true};
    if (found.kind == ir::TypeKind::nat) result = range(preferences_.nat);
    if (found.kind == ir::TypeKind::integer) result = range(preferences_.integer);
    if (found.kind == ir::TypeKind::real) result = range(preferences_.real);
    const bool plain = std::ranges::all_of(found.literal_args, [](const auto& arguments) { return arguments.empty(); });
    if (found.kind == ir::TypeKind::enumeration && plain && !found.labels.empty()) {
        (void)literal_name(type, 0);
        result = Carrier{false, 0, static_cast<std::int64_t>(found.labels.size()) - 1};
    }
    if (!result) diagnostics.report(rules::unsupported_type, span, {element, found.name});
    return result;
}

prism::Variable Context::declare_variable(const std::string& name, const Carrier& carrier, prism::ExprPtr initial) {
    return carrier.boolean ? tree::boolean(name, std::move(initial))
                           : tree::range(name, carrier.low, carrier.high, std::move(initial));
}

const std::string& Context::literal_name(ir::TypeId type, std::int64_t index) {
    const auto found = literals_.find({type.index, index});
    if (found != literals_.end()) return found->second;
    const ir::Type& enumeration = system.type(type);
    for (std::size_t i = 0; i < enumeration.labels.size(); ++i) {
        const std::string name = unique_name(enumeration.name + "_" + enumeration.labels[i]);
        emission.model.constants.push_back(tree::constant(name, static_cast<std::int64_t>(i)));
        literals_[{type.index, static_cast<std::int64_t>(i)}] = name;
    }
    return literals_.at({type.index, index});
}

}  // namespace robochart::prism_emit
