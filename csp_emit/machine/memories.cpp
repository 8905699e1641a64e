// SPDX-License-Identifier: Apache-2.0
// Estimates the number of states from the sizes of the carriers and searches for the least number of memories.
#include "csp_emit/machine/memories.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/machine/rules/statements.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::csp_emit {
namespace {

/// Returns the number of values that a cell may have. If the type is unknown, a small number is assumed.
double values_of(const MachineTables& tables, const Cell& cell) {
    const Project& project = tables.project();
    constexpr std::size_t many = 1'000;
    constexpr double unknown = 4;
    const auto bound = static_cast<double>(project.instantiation.clock_bound);
    if (cell.kind == CellKind::clock && cell.limit && cell.limit->kind == cspm::ExprKind::integer)
        return static_cast<double>(cell.limit->number) + 1;
    if (cell.kind != CellKind::variable) return cell.kind == CellKind::frozen ? unknown : bound;
    if (!cell.type.is_valid()) return unknown;
    if (project.system.type(cell.type).kind == ir::TypeKind::given && project.instantiations_replaced()) return many;
    try {
        return static_cast<double>(ir::carrier_values(project.system, project.instantiation, cell.type, many).size());
    } catch (const std::length_error&) {
        return many;
    }
}

/// Returns an upper bound on the number of states of the machine's process if these variables are in memories, computed
/// from the sizes of the carriers.
double estimate_states(const std::vector<Function>& functions, const Evaluations& evaluations,
                       const std::map<std::string, double>& sizes, const std::vector<Remembered>& remembered) {
    const auto held = evaluations.held_variables(remembered);
    std::set<std::string> outside;
    for (const Remembered& variable : remembered) outside.insert(variable.parameter);
    double sum = 0;
    for (std::size_t i = 0; i < functions.size(); ++i) {
        double product = 1;
        for (const std::string& parameter : functions[i].parameters) {
            const auto found = sizes.find(parameter);
            const bool counts = outside.count(parameter) == 0 || held[i].count(parameter) != 0;
            if (found != sizes.end() && counts) product *= found->second;
        }
        sum += product;
    }
    return sum;
}

/// Returns the machine's variables, own and shared, sorted by the size of their types, largest first.
std::vector<CellId> by_size(const MachineTables& tables) {
    const ParameterTable& cells = tables.cells;
    std::vector<CellId> result;
    for (const CellId cell : tables.frames.root_frame().variables)
        if (!cells[cell].parameter) result.push_back(cell);
    std::ranges::stable_sort(
        result, [&](CellId a, CellId c) { return values_of(tables, cells[a]) > values_of(tables, cells[c]); });
    return result;
}

Remembered memory_of(MachineTables& tables, CellId id) {
    const Cell& cell = tables.cells[id];
    const ir::Machine& machine = tables.machine();
    const auto& variables = tables.frames.root_frame().variables;
    const auto number = static_cast<std::size_t>(std::ranges::find(variables, id) - variables.begin());
    Remembered result;
    result.parameter = cell.name;
    result.meaning = cell.meaning;
    result.channel = cell.channel;
    if (cell.shared) result.shared = cell.channel;
    result.type = type_set(tables.project(), cell.type);
    result.initial = initial_value(tables, 0, machine.variables.at(number));
    result.memory = tables.context.names.unique_name("Memory_" + cell.channel);
    tables.record_meaning("get_" + cell.channel,
                          {MeaningKind::memory, "read " + cell.meaning, {cell.type}, machine.origin});
    tables.record_meaning("setL_" + cell.channel,
                          {MeaningKind::memory, "store " + cell.meaning, {cell.type}, machine.origin});
    tables.record_meaning("end__", {MeaningKind::step, "the memories of " + machine.name + " end", {}, machine.origin});
    DefinitionMeaning meaning{"the memory of " + cell.meaning, {cell.meaning}, {cell.type}, machine.origin};
    meaning.kinds = {ParameterKind::variable};
    meaning.component = tables.context.path;
    meaning.memory = true;
    tables.provenance.definitions[tables.context.path + "::" + result.memory] = std::move(meaning);
    return result;
}

}  // namespace

std::vector<Remembered> choose_memories(MachineTables& tables, const std::vector<Function>& functions) {
    const std::vector<CellId> candidates = by_size(tables);
    std::map<std::string, double> sizes;
    for (const Cell& cell : tables.cells.all()) sizes[cell.name] = values_of(tables, cell);
    std::set<std::string> names;
    for (const CellId cell : candidates) names.insert(tables.cells[cell].name);
    const Evaluations evaluations(functions, names);
    const auto small_with = [&](std::size_t count) {
        std::vector<Remembered> first(count);
        for (std::size_t i = 0; i < count; ++i) {
            const Cell& cell = tables.cells[candidates[i]];
            first[i].parameter = cell.name;
            if (cell.shared) first[i].shared = cell.channel;
        }
        const Options& options = tables.project().options;
        return options.whole_states ||
               estimate_states(functions, evaluations, sizes, first) <= options.states_of_a_process;
    };
    // The estimate decreases with every variable that is moved to a memory. The variable then counts only in functions
    // that lock its memory, and fewer other variables are locked together with it. Because the estimate is monotone, a
    // binary search is possible.
    std::size_t least = 0;
    std::size_t most = candidates.size();
    while (least < most) {
        const std::size_t middle = (least + most) / 2;
        if (small_with(middle))
            most = middle;
        else
            least = middle + 1;
    }
    std::vector<Remembered> result;
    for (std::size_t i = 0; i < least; ++i) result.push_back(memory_of(tables, candidates[i]));
    return result;
}

}  // namespace robochart::csp_emit
