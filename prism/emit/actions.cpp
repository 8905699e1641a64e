// SPDX-License-Identifier: Apache-2.0
// Statements: one command per statement (R9, R13, R14).
#include <algorithm>
#include <utility>

#include "prism/emit/machine.hpp"
#include "prism/emit/rules.hpp"
#include "prism/emit/tree.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::prism_emit {
namespace {

using prism::ExprPtr;

std::vector<prism::Assignment> with(std::vector<prism::Assignment> first, std::vector<prism::Assignment> more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

}  // namespace

/// R9: "One command per statement. Assignment: unlabelled; the last also unlocks and moves."
void MachineEmitter::run(Part& part, std::size_t place, std::string point, const std::vector<ir::StmtPtr>& statements,
                         const Assignments& then, const std::string& where) {
    for (std::size_t i = 0; i < statements.size(); ++i) {
        Assignments next = then;
        std::string next_point;
        if (i + 1 < statements.size()) {
            next_point = add_point(region(part, place), context_.numbered("Action"));
            next = {tree::set(region(part, place).pc, next_point)};
        }
        statement(part, place, point, *statements[i], std::move(next), where);
        point = next_point;
    }
}

void MachineEmitter::statement(Part& part, std::size_t place, const std::string& point, const ir::Stmt& stmt,
                               Assignments then, const std::string& where) {
    if (stmt.kind == ir::StmtKind::communicate) return communicate(part, place, point, stmt, std::move(then), where);
    if (stmt.kind == ir::StmtKind::call) return call(part, place, point, stmt, std::move(then), where);
    if (stmt.kind == ir::StmtKind::assign) {
        if (!stmt.path.empty())
            context_.diagnostics.report(rules::unsupported_expression, stmt.origin.span,
                                        {"an assignment to a part of a variable", where});
        const ExprPtr value = whole_value(context_, scope(part, where), *stmt.value);
        then.insert(then.begin(), tree::set(part.variables[stmt.variable.index], value));
    }
    add(tree::command("", at(part, place, point), std::move(then)));
}

Channel* MachineEmitter::channel(const Part& part, ir::EventId event, Direction direction, diagnostics::Span span) {
    // the events of an operation are those of the machine that runs it
    const std::string& name = part.machine->events[event.index].name;
    const ir::Machine& host = context_.system.machine(instance_.machine);
    const auto found = std::ranges::find_if(host.events, [&](const auto& each) { return each.name == name; });
    if (found != host.events.end()) return channels_.find(seat_, *found, direction, span);
    context_.diagnostics.report(rules::unsupported_event, span,
                                {name, part.element, "the state machine that calls the operation has no such event"});
    return nullptr;
}

/// R13: "Sender writes EVT__<label>"; "the receiver keeps" a FIN.
void MachineEmitter::declare_value(const Channel& channel, Direction direction) {
    const bool in = direction == Direction::in;
    const std::string name = in ? channel.ready_at(direction) : channel.value_at(direction);
    if (!declared_.insert(name).second) return;
    module_.variables.push_back(in ? tree::boolean(name, tree::truth(true))
                                   : Context::variable(name, *channel.carrier, nullptr));
}

void MachineEmitter::communicate(Part& part, std::size_t place, const std::string& point, const ir::Stmt& stmt,
                                 Assignments then, const std::string& where) {
    const ir::Communication& what = stmt.communication;
    const bool in = what.kind == ir::CommKind::input;
    const Channel* const found = channel(part, what.event, in ? Direction::in : Direction::out, stmt.origin.span);
    if (found == nullptr) return;
    const bool typed = found->carrier.has_value();
    const bool fits = typed ? (in ? what.variable.valid() : what.value != nullptr) : what.kind == ir::CommKind::simple;
    if (!fits || what.predicate) {
        context_.diagnostics.report(rules::unsupported_construct, stmt.origin.span,
                                    {"a communication of this form", where});
        return;
    }
    if (in)
        receive(part, place, point, *found, what.variable, then);
    else
        send(part, place, point, *found, what.value.get(), std::move(then), where);
}

/// R13: "Sender writes EVT__<label> in the synchronised command; to a buffer it then waits one step for
/// FIN__OUT_...=true."
void MachineEmitter::send(Part& part, std::size_t place, const std::string& point, const Channel& channel,
                          const ir::Expr* value, Assignments then, const std::string& where) {
    if (value == nullptr) return add(tree::command(channel.out_label(), at(part, place, point), std::move(then)));
    declare_value(channel, Direction::out);
    const prism::Assignment written =
        tree::set(channel.value_at(Direction::out), whole_value(context_, scope(part, where), *value));
    if (channel.kind != Channel::Kind::buffer)
        return add(tree::command(channel.out_label(), at(part, place, point), with({written}, std::move(then))));
    Region& around = region(part, place);
    const std::string stem = channel.name.substr(0, channel.name.rfind('_'));
    const std::string sent = add_point(around, context_.numbered(stem));
    add(tree::command(channel.out_label(), at(part, place, point), {written, tree::set(around.pc, sent)}));
    add(tree::command("", tree::all_of({at(part, place, sent), tree::is(channel.ready_at(Direction::out), true)}),
                      std::move(then)));
}

/// R13: "[IN_...] ... & FIN=true -> FIN'=false & scpc'=e_n, then x'=EVT & FIN'=true."
void MachineEmitter::receive(Part& part, std::size_t place, const std::string& point, const Channel& channel,
                             ir::VariableId variable, const Assignments& then) {
    declare_value(channel, Direction::in);
    const std::string ready = channel.ready_at(Direction::in);
    Region& around = region(part, place);
    const std::string stem = channel.name.substr(0, channel.name.rfind('_'));
    const std::string taken = add_point(around, context_.numbered(stem));
    add(tree::command(channel.in_label(), tree::all_of({at(part, place, point), tree::is(ready, true)}),
                      {tree::set(ready, false), tree::set(around.pc, taken)}));
    add(tree::command(
        "", at(part, place, taken),
        with({tree::set(part.variables[variable.index], channel.value_at(Direction::in)), tree::set(ready, true)},
             then)));
}

/// R14: "per machine one copy".
Part* MachineEmitter::called(const Part& caller, const ir::Stmt& stmt) {
    const ir::OperationSignature& signature = caller.machine->operations[stmt.operation.index];
    const auto refuse = [&](const std::string& problem) -> Part* {
        context_.diagnostics.report(rules::unsupported_operation, stmt.origin.span,
                                    {signature.name, caller.element, problem});
        return nullptr;
    };
    const ir::MachineId definition = ir::definition_in(context_.system, controller_, signature);
    if (!definition.valid()) return refuse("it is the platform's, not defined in the model");
    if (open_.contains(definition.index)) return refuse("it calls itself");
    const auto known = parts_.find(definition.index);
    if (known != parts_.end()) return known->second.get();
    Part& made = part_of(definition, signature.name, true);
    open_.insert(definition.index);
    emit(made);
    open_.erase(definition.index);
    return &made;
}

/// R14: "call [] here & op_scpc=INACTIVE -> op_scpc'=op_i0 & op_arg'=...; wait [] here & op_scpc=TERMINATED ->
/// op_scpc'=INACTIVE & continue".
void MachineEmitter::call(Part& part, std::size_t place, const std::string& point, const ir::Stmt& stmt,
                          Assignments then, const std::string& where) {
    const Part* const operation = called(part, stmt);
    if (operation == nullptr || !operation->machine->initial.valid()) return;
    const Region& top = operation->regions.front();
    Assignments begin{tree::set(top.pc, operation->points[operation->machine->initial.index])};
    for (std::size_t i = 0; i < stmt.args.size(); ++i)
        begin.push_back(tree::set(operation->variables[i], whole_value(context_, scope(part, where), *stmt.args[i])));
    const ExprPtr here = at(part, place, point);
    add(tree::command("", tree::all_of({here, tree::is(top.pc, top.inactive)}), begin));
    add(tree::command("", tree::all_of({here, tree::is(top.pc, operation->terminated)}),
                      with({tree::set(top.pc, top.inactive)}, std::move(then))));
}

}  // namespace robochart::prism_emit
