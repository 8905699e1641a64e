// SPDX-License-Identifier: Apache-2.0
// Performs the phases of a machine's emission: explores its configurations, gives parameters to functions, chooses
// memories, and declares the module.
#include "csp_emit/machine/machine_module.hpp"

#include <algorithm>
#include <stdexcept>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/machine/declarations.hpp"
#include "csp_emit/machine/meanings.hpp"
#include "csp_emit/machine/memories.hpp"
#include "csp_emit/machine/processes.hpp"
#include "csp_emit/machine/rules/shared_variables.hpp"
#include "csp_emit/passes/choice_factoring.hpp"
#include "semantics/ir/query.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

namespace {

/// Adds the names of the parameters that the probabilities of transitions from a junction read.
void add_weights(const Frame& frame, ir::NodeId junction, const ParameterTable& cells, std::vector<std::string>& read) {
    for (const ir::Transition& way : frame.machine->transitions) {
        if (way.source != junction || !way.probability) continue;
        ir::visit_operands(*way.probability, [&](const ir::Expr& expr) {
            if (expr.kind == ir::ExprKind::variable) read.push_back(cells[frame.variables[expr.variable.index]].name);
        });
    }
}

/// Returns, for each point, the parameters that it must have because a machine or operation is at a probabilistic
/// junction.
std::vector<std::vector<std::string>> weights_read(const MachineTables& tables) {
    std::vector<std::vector<std::string>> result;
    for (const Point& point : tables.points.all()) {
        std::vector<std::string>& read = result.emplace_back();
        for (const RunningMachine& running : view_of(point.config).machines) {
            const Frame& frame = tables.frames[running.activation->frame];
            const ir::NodeId at = running.activation->at;
            if (at.is_valid() && frame.machine->nodes[at.index].kind == ir::NodeKind::probabilistic)
                add_weights(frame, at, tables.cells, read);
        }
    }
    return result;
}

/// Returns all possible parameters of points: the constants, then the cells in order of creation.
Candidates parameter_candidates(const MachineTables& tables) {
    Candidates result;
    result.names = tables.calls.constants_inside();
    for (const Cell& cell : tables.cells.all()) {
        result.names.push_back(cell.name);
        if (cell.kind == CellKind::clock && cell.reading.empty())
            result.ticking[cell.name] = b::call("clock_step", {b::name(cell.name), cell.limit});
    }
    if (tables.project().options.whole_states) {
        for (const CellId cell : tables.frames.root_frame().variables) result.fixed.push_back(tables.cells[cell].name);
        result.read = weights_read(tables);
    }
    tables.sharing.describe_stack(result);
    return result;
}

/// Returns values for arguments that are never read. They are chosen so that the process has few states.
std::map<std::string, ExprPtr> placeholder_values(MachineTables& tables) {
    std::map<std::string, ExprPtr> result;
    for (const ConstantParameter& constant : tables.calls.constants())
        result[constant.inside] = default_literal(tables.project(), constant.type);
    for (const Cell& cell : tables.cells.all()) {
        if (cell.kind == CellKind::clock)  // a clock at its limit no longer changes; a limit that depends on constants
                                           // may be unknown at this point
            result[cell.name] = cell.limit->kind == cspm::ExprKind::integer ? cell.limit : b::number(0);
        else if (cell.kind == CellKind::variable && cell.type.is_valid())
            result[cell.name] = tables.defaults.value_of(cell.type);
        else
            result[cell.name] = b::number(0);
    }
    if (const auto& watch = tables.watch.reset_cell()) result[tables.cells[*watch].name] = b::boolean(false);
    return result;
}

/// Checks that the initial process has values for everything except constants and an operation's parameters.
void check_initial(const std::vector<std::string>& needed, const std::vector<std::string>& known) {
    for (const std::string& name : needed)
        if (std::ranges::find(known, name) == known.end())
            throw std::logic_error("csp_emit: parameter " + name + " has no value");
}

/// The parameters of each function.
using Parameters = std::vector<std::vector<std::string>>;

Parameters parameters_of(const std::vector<Function>& functions) {
    Parameters result;
    for (const Function& function : functions) result.push_back(function.parameters);
    return result;
}

/// Returns the definitions of the points and of the memories, return points and sets of events that they use. `needed`
/// contains, for each function, the variables that it reads or passes on, whether they are parameters or in memories.
std::vector<cspm::DeclPtr> make_definitions(MachineTables& tables, std::vector<Function>& functions,
                                            const std::vector<Remembered>& remembered, const Parameters& needed) {
    std::vector<cspm::DeclPtr> result = memory_definitions(remembered, tables.timed());
    tables.sharing.declare_functions(result);
    std::vector<NamedSet> sets{{"shared_variable_events", b::productions(external_write_events(tables))}};
    gather_alike_branches(functions, tables.context.names, sets);
    for (std::size_t i = 1; i < sets.size(); ++i)
        result.push_back(b::value(sets[i].name, sets[i].events, "events after which some point goes on alike"));
    DefinitionMeanings meanings(tables);
    for (std::size_t i = 0; i < functions.size(); ++i) {
        const Point& point = tables.points.all()[i];
        const Function& function = functions[i];
        DefinitionMeaning meaning = meanings.meaning_of(point, function);
        for (const Remembered& variable : remembered)
            if (std::ranges::find(needed[i], variable.parameter) != needed[i].end())
                meaning.remembered.push_back(variable.meaning);
        result.push_back(
            b::function_decl(function.name, b::variables(function.parameters), function.body, meaning.text));
        tables.provenance.definitions[tables.context.path + "::" + point.name] = std::move(meaning);
    }
    return result;
}

/// Returns the parameters of an operation that is checked separately. Their names in assertions are like those of
/// constants, but with another prefix (ir::Property::constants).
std::vector<ArgumentParameter> arguments_of(const ir::Machine& machine) {
    std::vector<ArgumentParameter> result;
    for (const ir::Variable& variable : machine.variables) {
        if (variable.scope != ir::VariableScope::parameter) continue;
        const std::string name = ir::constant_name(machine.package, machine.path, variable.name);
        result.push_back({"param_" + name.substr(std::string("const_").size()), variable.type});
    }
    return result;
}

}  // namespace

ComponentEmission machine_module(MachineContext context, Emitted& emitted) {
    MachineTables tables(std::move(context), emitted.provenance);
    Processes processes(tables);
    ExprPtr initial = processes.initial_process();
    std::vector<Function> functions = processes.make_functions();
    check_initial(find_parameters(functions, initial, tables.family_calls, parameter_candidates(tables)),
                  parameters_with(tables, tables.calls.constants_inside()));
    inline_continuations(functions, tables.points.all().size());
    const std::vector<Remembered> remembered = choose_memories(tables, functions);
    const Parameters needed = parameters_of(functions);
    move_to_memories(functions, initial, tables.family_calls, remembered);
    fill_unneeded(functions, tables.family_calls, placeholder_values(tables));
    const std::vector<cspm::DeclPtr> points = make_definitions(tables, functions, remembered, needed);
    std::vector<cspm::DeclPtr> all = tables.defaults.declarations();
    all.insert(all.end(), tables.limits.declarations().begin(), tables.limits.declarations().end());
    all.insert(all.end(), points.begin(), points.end());

    ModuleDeclarations declarations(tables, remembered);
    ComponentEmission result;
    result.module = declarations.make_module(all, initial);
    result.constants = tables.calls.constants();
    result.arguments = arguments_of(tables.machine());
    result.visible = declarations.visible_channels();
    result.machine = &tables.machine();
    result.definitions = tables.context.definitions;
    result.reads_of_watched = tables.watch.read_count();
    result.large = !remembered.empty();
    return emitted.components[tables.context.path] = result;
}

}  // namespace robochart::csp_emit
