// SPDX-License-Identifier: Apache-2.0
// Encodes statements, with one command per statement (R9, R13, R14).
#include <algorithm>
#include <utility>

#include "prism/emit/machine.hpp"
#include "prism/emit/rules.hpp"
#include "prism/emit/tree.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::prism_emit {
namespace {

using prism::ExprPtr;

std::vector<prism::Assignment> append_assignments(std::vector<prism::Assignment> first,
                                                  std::vector<prism::Assignment> more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

}  // namespace

/// Emits the commands of statements. R9: "One command per statement. Assignment: unlabelled; the last also unlocks and
/// moves."
void MachineEmitter::run_statements(Part& part, std::size_t place, std::string point,
                                    const std::vector<ir::StmtPtr>& statements, const Assignments& then,
                                    const std::string& where) {
    for (std::size_t i = 0; i < statements.size(); ++i) {
        Assignments next = then;
        std::string next_point;
        if (i + 1 < statements.size()) {
            next_point = add_point(region_at(part, place), context_.numbered_name("Action"));
            next = {tree::set(region_at(part, place).pc, next_point)};
        }
        emit_statement(part, place, point, *statements[i], std::move(next), where);
        point = next_point;
    }
}

void MachineEmitter::emit_statement(Part& part, std::size_t place, const std::string& point, const ir::Stmt& stmt,
                                    Assignments then, const std::string& where) {
    if (stmt.kind == ir::StmtKind::communicate)
        return emit_communication(part, place, point, stmt, std::move(then), where);
    if (stmt.kind == ir::StmtKind::call) return emit_call(part, place, point, stmt, std::move(then), where);
    if (stmt.kind == ir::StmtKind::assign) {
        if (!stmt.path.empty())
            context_.diagnostics.report(rules::unsupported_expression, stmt.origin.span,
                                        {"an assignment to a part of a variable", where});
        const ExprPtr value = whole_value(context_, make_scope(part, where), *stmt.value);
        then.insert(then.begin(), tree::set(part.variables[stmt.variable.index], value));
    }
    add_command(tree::command("", at_point(part, place, point), std::move(then)));
}

Channel* MachineEmitter::channel_of(const Part& part, ir::EventId event, Direction direction, diagnostics::Span span) {
    // the events of an operation are those of the machine that calls it
    const std::string& name = part.machine->events[event.index].name;
    const ir::Machine& host = context_.system.machine(instance_.machine);
    const auto found = std::ranges::find_if(host.events, [&](const auto& candidate) { return candidate.name == name; });
    if (found != host.events.end()) return channels_.find_channel(seat_, *found, direction, span);
    context_.diagnostics.report(rules::unsupported_event, span,
                                {name, part.element, "the state machine that calls the operation has no such event"});
    return nullptr;
}

/// Declares the variables of a value. R13: "Sender writes EVT__<label>"; "the receiver keeps" a FIN.
void MachineEmitter::declare_value(const Channel& channel, Direction direction) {
    const bool in = direction == Direction::in;
    const std::string name = in ? channel.ready_at(direction) : channel.value_at(direction);
    if (!declared_.insert(name).second) return;
    module_.variables.push_back(in ? tree::boolean(name, tree::truth(true))
                                   : Context::declare_variable(name, *channel.carrier, nullptr));
}

void MachineEmitter::emit_communication(Part& part, std::size_t place, const std::string& point, const ir::Stmt& stmt,
                                        Assignments then, const std::string& where) {
    const ir::Communication& what = stmt.communication;
    const bool in = what.kind == ir::CommKind::input;
    const Channel* const found = channel_of(part, what.event, in ? Direction::in : Direction::out, stmt.origin.span);
    if (found == nullptr) return;
    bool fits = what.kind == ir::CommKind::simple;
    if (found->carrier) fits = in ? what.variable.is_valid() : what.value != nullptr;
    if (!fits || what.predicate) {
        context_.diagnostics.report(rules::unsupported_construct, stmt.origin.span,
                                    {"a communication of this form", where});
        return;
    }
    if (in)
        emit_receive(part, place, point, *found, what.variable, then);
    else
        emit_send(part, place, point, *found, what.value.get(), std::move(then), where);
}

/// Emits a send. R13: "Sender writes EVT__<label> in the synchronised command; to a buffer it then waits one step for
/// FIN__OUT_...=true."
void MachineEmitter::emit_send(Part& part, std::size_t place, const std::string& point, const Channel& channel,
                               const ir::Expr* value, Assignments then, const std::string& where) {
    if (value == nullptr)
        return add_command(tree::command(channel.out_label(), at_point(part, place, point), std::move(then)));
    declare_value(channel, Direction::out);
    const prism::Assignment written =
        tree::set(channel.value_at(Direction::out), whole_value(context_, make_scope(part, where), *value));
    if (channel.kind != Channel::Kind::buffer)
        return add_command(tree::command(channel.out_label(), at_point(part, place, point),
                                         append_assignments({written}, std::move(then))));
    Region& around = region_at(part, place);
    const std::string stem = channel.name.substr(0, channel.name.rfind('_'));
    const std::string sent = add_point(around, context_.numbered_name(stem));
    add_command(
        tree::command(channel.out_label(), at_point(part, place, point), {written, tree::set(around.pc, sent)}));
    add_command(
        tree::command("", tree::all_of({at_point(part, place, sent), tree::is(channel.ready_at(Direction::out), true)}),
                      std::move(then)));
}

/// Emits a receive. R13: "[IN_...] ... & FIN=true -> FIN'=false & scpc'=e_n, then x'=EVT & FIN'=true."
void MachineEmitter::emit_receive(Part& part, std::size_t place, const std::string& point, const Channel& channel,
                                  ir::VariableId variable, const Assignments& then) {
    declare_value(channel, Direction::in);
    const std::string ready = channel.ready_at(Direction::in);
    Region& around = region_at(part, place);
    const std::string stem = channel.name.substr(0, channel.name.rfind('_'));
    const std::string taken = add_point(around, context_.numbered_name(stem));
    add_command(tree::command(channel.in_label(), tree::all_of({at_point(part, place, point), tree::is(ready, true)}),
                              {tree::set(ready, false), tree::set(around.pc, taken)}));
    add_command(tree::command(
        "", at_point(part, place, taken),
        append_assignments(
            {tree::set(part.variables[variable.index], channel.value_at(Direction::in)), tree::set(ready, true)},
            then)));
}

/// Returns the machine's copy of the called operation. R14: "per machine one copy".
Part* MachineEmitter::called_operation(const Part& caller, const ir::Stmt& stmt) {
    const ir::OperationSignature& signature = caller.machine->operations[stmt.operation.index];
    const auto refuse = [&](const std::string& problem) -> Part* {
        context_.diagnostics.report(rules::unsupported_operation, stmt.origin.span,
                                    {signature.name, caller.element, problem});
        return nullptr;
    };
    const ir::MachineId definition = ir::definition_in(context_.system, controller_, signature);
    if (!definition.is_valid()) return refuse("it belongs to the platform and is not defined in the model");
    if (open_.contains(definition.index)) return refuse("it calls itself");
    const auto known = parts_.find(definition.index);
    if (known != parts_.end()) return known->second.get();
    Part& made = part_of(definition, signature.name, true);
    open_.insert(definition.index);
    emit_part(made);
    open_.erase(definition.index);
    return &made;
}

/// Emits a call. R14: "call [] here & op_scpc=INACTIVE -> op_scpc'=op_i0 & op_arg'=...; wait [] here &
/// op_scpc=TERMINATED -> op_scpc'=INACTIVE & continue".
void MachineEmitter::emit_call(Part& part, std::size_t place, const std::string& point, const ir::Stmt& stmt,
                               Assignments then, const std::string& where) {
    const Part* const operation = called_operation(part, stmt);
    if (operation == nullptr || !operation->machine->initial.is_valid()) return;
    const Region& top = operation->regions.front();
    Assignments begin{tree::set(top.pc, operation->points[operation->machine->initial.index])};
    for (std::size_t i = 0; i < stmt.args.size(); ++i)
        begin.push_back(
            tree::set(operation->variables[i], whole_value(context_, make_scope(part, where), *stmt.args[i])));
    const ExprPtr here = at_point(part, place, point);
    add_command(tree::command("", tree::all_of({here, tree::is(top.pc, top.inactive)}), begin));
    add_command(tree::command("", tree::all_of({here, tree::is(top.pc, operation->terminated)}),
                              append_assignments({tree::set(top.pc, top.inactive)}, std::move(then))));
}

}  // namespace robochart::prism_emit
