// SPDX-License-Identifier: Apache-2.0
// Adds numbers between the constants with which reals are compared.
#include "conformance/traces/more_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "base/diagnostics/containers.hpp"
#include "conformance/model/model_interface.hpp"
#include "conformance/model/tested_sequences.hpp"
#include "cpp_emit/plan/resolve_component.hpp"
#include "semantics/ir/number_parts.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::conformance {

namespace {

/// The number of finer units in one unit of the model.
constexpr std::int64_t fineness = 1000;
/// The number of further numbers between two neighbours.
constexpr std::int64_t further = 7;
/// The limit for numbers. With it, numbers stay exact in double, and their products by small factors stay in 64 bits.
constexpr double greatest = 1e14;

/// The same value in units that are finer by a factor. Recursion depth: the depth of the type.
ir::Value value_in_finer_units(const ir::System& system, ir::TypeId id, ir::Value value, std::int64_t factor) {
    const ir::Type& type = system.type(id);
    if (type.kind == ir::TypeKind::real) value.number *= factor;
    const bool pairs = type.kind == ir::TypeKind::function || type.kind == ir::TypeKind::relation;
    for (std::size_t i = 0; i < value.parts.size(); ++i) {
        ir::Value& part = value.parts[i];
        if (type.kind == ir::TypeKind::enumeration) {
            const auto& arguments = type.literal_args.at(static_cast<std::size_t>(value.number));
            part = value_in_finer_units(system, arguments.at(i), std::move(part), factor);
        } else if (type.kind == ir::TypeKind::record || type.kind == ir::TypeKind::product) {
            part = value_in_finer_units(system, type.args.at(i), std::move(part), factor);
        } else if (pairs || type.kind == ir::TypeKind::matrix) {
            for (std::size_t j = 0; j < part.parts.size(); ++j)
                part.parts[j] =
                    value_in_finer_units(system, type.args.at(pairs ? j : 0), std::move(part.parts[j]), factor);
        } else if (!type.args.empty()) {
            part = value_in_finer_units(system, type.args[0], std::move(part), factor);
        }
    }
    return value;
}

/// The instantiation with one sequence of each class, if the component only stores and tests the sequences that it
/// receives (conformance/model/tested_sequences.hpp).
ir::Instantiation with_sequences(const ir::System& system, const ir::Instantiation& instantiation,
                                 const ir::ComponentRef& ref) {
    diagnostics::Diagnostics quiet;
    const auto component = cpp_emit::resolve_component(system, instantiation, ref, quiet);
    if (!component) return instantiation;
    const auto model = model_of_sequences(system, instantiation, *component);
    if (!model || model->scale % instantiation.scale != 0) return instantiation;
    ir::Instantiation result = in_finer_units(system, instantiation, model->scale / instantiation.scale);
    for (const ir::ExploredValues& type : model->types) {
        if (!ir::is_number_sequence(system, type.type)) continue;
        std::vector<ir::Value> values;
        for (const auto& numbers : type.values) {
            ir::Value& value = values.emplace_back();
            for (const std::int64_t number : numbers) value.parts.push_back({number, {}});
        }
        diagnostics::sort_unique(values);
        for (std::uint32_t other = 0; other < system.types.size(); ++other)
            if (same_type(system, type.type, ir::TypeId{other})) result.representatives[other] = values;
    }
    return result;
}

/// Returns numbers between each two neighbours of `ends`, and beyond the first and the last.
std::vector<std::int64_t> numbers_among(const std::vector<std::int64_t>& ends, std::int64_t unit) {
    std::vector<std::int64_t> result;
    for (std::int64_t j = 1; j <= further; ++j) {
        result.push_back(ends.front() - j * unit);
        result.push_back(ends.back() + j * unit);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            result.push_back(ends[i] + (ends[i + 1] - ends[i]) * j / (further + 1));
    }
    return result;
}

/// The instantiation with more numbers (more_numbers.hpp), for these numbers of the component.
ir::Instantiation between_constants(const ir::System& system, const ir::Instantiation& instantiation,
                                    const TestedNumbers& numbers) {
    if (numbers.uses.real != NumberUse::compared || instantiation.real.empty()) return instantiation;
    const auto found = numbers.constants.find(ir::TypeKind::real);
    if (found == numbers.constants.end()) return instantiation;
    const double units = static_cast<double>(instantiation.scale) * static_cast<double>(fineness);
    const auto fits = [&](double number) { return std::abs(number * units) < greatest; };
    const double last = static_cast<double>(std::max(std::abs(instantiation.real.front()), instantiation.real.back()));
    if (!std::ranges::all_of(found->second.all, fits) || !fits(last / static_cast<double>(instantiation.scale)))
        return instantiation;
    ir::Instantiation result = in_finer_units(system, instantiation, fineness);
    std::vector<std::int64_t> ends;
    for (const double constant : found->second.all) ends.push_back(std::llround(constant * units));
    diagnostics::sort_unique(ends);
    for (const std::int64_t number : numbers_among(ends, result.scale)) result.real.push_back(number);
    diagnostics::sort_unique(result.real);
    return result;
}

}  // namespace

ir::Instantiation in_finer_units(const ir::System& system, const ir::Instantiation& instantiation,
                                 std::int64_t factor) {
    ir::Instantiation result = instantiation;
    result.scale *= factor;
    for (std::int64_t& number : result.real) number *= factor;
    for (const ir::NamedConstant& constant : ir::named_constants(system)) {
        const auto value = result.constants.find(constant.name);
        if (value != result.constants.end())
            value->second = value_in_finer_units(system, constant.type, value->second, factor);
    }
    for (auto& [type, values] : result.representatives)
        for (ir::Value& value : values)
            value = value_in_finer_units(system, ir::TypeId{type}, std::move(value), factor);
    return result;
}

ir::Instantiation with_more_numbers(const ir::System& system, const ir::Instantiation& instantiation,
                                    const ir::ComponentRef& component) {
    const ir::Instantiation sequences = with_sequences(system, instantiation, component);
    const auto numbers = tested_numbers(system, sequences, component);
    if (!numbers) return instantiation;
    ir::Instantiation result = between_constants(system, sequences, *numbers);
    const auto adds = [](const ComparedSums& sums) { return sums.left.size() > 1 || sums.right.size() > 1; };
    const DataIndependence& uses = numbers->uses;
    const bool computes = std::ranges::max({uses.nat, uses.integer, uses.real}) == NumberUse::computed;
    result.unbounded = computes || std::ranges::any_of(numbers->sums, adds);
    return result;
}

}  // namespace robochart::conformance
