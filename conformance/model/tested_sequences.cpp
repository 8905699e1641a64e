// SPDX-License-Identifier: Apache-2.0
#include "conformance/model/tested_sequences.hpp"

#include <algorithm>

#include "cpp_emit/plan/exploration_ports.hpp"
#include "semantics/ir/number_parts.hpp"

namespace robochart::conformance {

namespace {

int sign_of(double number, double threshold) {
    return static_cast<int>(number > threshold) - static_cast<int>(number < threshold);
}

bool has_real_items(const ir::System& system, ir::TypeId sequence) {
    return system.type(system.type(sequence).args.at(0)).kind == ir::TypeKind::real;
}

bool has_representatives(const ir::System& system, const ir::Instantiation& instantiation) {
    return std::ranges::any_of(instantiation.representatives, [&](const auto& entry) {
        return ir::is_number_sequence(system, ir::TypeId{entry.first});
    });
}

SequenceTests tests_of(const ir::System& system, const ir::ValueModel& model, ir::TypeId type) {
    SequenceTests result;
    const bool real = has_real_items(system, type);
    for (const ir::Cut& cut : model.cuts) {
        if (cut.type != type) continue;
        const std::int64_t unit = cut.window && real ? model.scale : 1;
        result.tests.push_back(
            {cut.window, -static_cast<double>(cut.constant) / static_cast<double>(cut.coefficients.at(0) * unit)});
    }
    return result;
}

}  // namespace

std::vector<int> SequenceTests::signs_at(std::span<const double> items) const {
    std::vector<int> signs;
    for (const SequenceTest& test : tests) {
        std::optional<double> number = static_cast<double>(items.size());
        if (test.window)
            number = ir::extremum_in(*test.window, test.window->greatest, items.size(),
                                     [&](std::size_t i) { return items[i]; });
        signs.push_back(number ? sign_of(*number, test.threshold) : 2);
    }
    return signs;
}

std::optional<ir::ValueModel> model_of_sequences(const ir::System& system, const ir::Instantiation& instantiation,
                                                 const cpp_emit::Component& component) {
    const auto is_sequence = [&](ir::TypeId type) { return ir::is_number_sequence(system, type); };
    const auto registers = cpp_emit::exploration_registers(component);
    if (std::ranges::none_of(registers, [&](const auto& input) { return input.type && is_sequence(*input.type); }))
        return std::nullopt;
    for (const cpp_emit::Output& output : cpp_emit::exploration_outputs(component))
        if (std::ranges::any_of(output.types, is_sequence)) return std::nullopt;
    std::vector<ir::MachineId> machines;
    for (const cpp_emit::Unit& unit : component.units) machines.push_back(unit.id);
    return ir::value_model(system, instantiation, machines, {});
}

TestedSequences tested_sequences(const ir::System& system, const ir::Instantiation& instantiation,
                                 const cpp_emit::Component& component) {
    TestedSequences result;
    if (!has_representatives(system, instantiation)) return result;
    const auto model = model_of_sequences(system, instantiation, component);
    if (!model) return result;
    for (const ir::ModelComparison& comparison : model->comparisons)
        if (ir::is_number_sequence(system, comparison.type)) result.comparisons.insert(comparison.expr);
    for (const auto& [index, values] : instantiation.representatives) {
        const ir::TypeId type{index};
        if (!ir::is_number_sequence(system, type)) continue;
        SequenceTests& tests = result.types.emplace(index, tests_of(system, *model, type)).first->second;
        const bool real = has_real_items(system, type);
        for (const ir::Value& value : values) {
            std::vector<double> items;
            for (const ir::Value& item : value.parts)
                items.push_back(static_cast<double>(item.number) / static_cast<double>(real ? instantiation.scale : 1));
            tests.sequences.emplace(tests.signs_at(items), value);
        }
    }
    return result;
}

}  // namespace robochart::conformance
