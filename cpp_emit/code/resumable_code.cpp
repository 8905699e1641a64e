// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/code/resumable_code.hpp"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cpp_emit/code/assignment.hpp"
#include "cpp_emit/code/cycles.hpp"
#include "cpp_emit/code/machine_plan.hpp"
#include "cpp_emit/code/reception.hpp"
#include "cpp_emit/code/suspension.hpp"
#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit {

using ir::CommKind;
using ir::StmtKind;

namespace {

/// Returns the statement that runs if the condition does not hold, or null if there is none.
ir::StmtPtr else_branch(const ir::Stmt& stmt) {
    return stmt.body.size() > 1 ? stmt.body[1] : nullptr;
}

}  // namespace

ProgramWriter::ProgramWriter(const Generation& generation, const Unit& unit, Thread& thread, ir::NodeId state)
    : generation_(generation), unit_(unit), thread_(thread), state_(state) {}

CodeWriter& ProgramWriter::current_code() {
    resumed_.reset();
    assert(!thread_.places.empty());
    return thread_.places.back().code;
}

void ProgramWriter::begin_place(const std::string& label, const diagnostics::ForeignText& comment) {
    resumed_.reset();
    thread_.places.push_back({label, comment, state_, CodeWriter(5)});
}

void ProgramWriter::goes_on_from_here(const std::string& condition) {
    if (!calls_hold_up_writes(generation_, unit_)) return;
    const std::string place = thread_.qualified_label(thread_.places.back().label);
    resumed_ = {fmt::format("{} == {}{}", thread_.variable, place, condition), {}};
}

void ProgramWriter::write_jump(const std::string& label) {
    current_code().line(thread_.go_statement(label));
    current_code().line("break;");
}

/// Writes a statement that returns if the condition holds.
void ProgramWriter::return_if(const std::string& condition) {
    current_code().open(fmt::format("if ({}) {{", condition));
    current_code().line("return moved;");
    current_code().close();
}

void ProgramWriter::write_line(const std::string& text) {
    if (!text.empty()) current_code().line(text);
}

void ProgramWriter::resume_at(const std::string& label, const diagnostics::ForeignText& comment) {
    write_jump(label);
    begin_place(label, comment);
}

/// Returns a place where the program can resume: the current place if it is still empty, otherwise a new one.
std::string ProgramWriter::resume_here(const std::string& stem, const diagnostics::ForeignText& comment) {
    if (current_code().empty()) return thread_.places.back().label;
    std::string label = fresh_label(stem);
    resume_at(label, comment);
    return label;
}

std::string ProgramWriter::fresh_label(const std::string& stem) {
    if (generation_.mutation.hits(Fault::name_collision)) return thread_.places.back().label;
    return thread_.labels->numbered_name(stem);
}

/// Writes the test of the precondition in `pre & statement` (semantics 3.5). A false precondition blocks the
/// thread.
void ProgramWriter::test_preconditions(const ir::Stmt& stmt) {
    const ExpressionWriter expressions(generation_, unit_);
    CppExpr conditions;
    for (const ir::Expr* expr : evaluated_first(stmt))
        conditions = conjunction(conditions, expressions.precondition_test(*expr));
    if (conditions.empty()) return;
    const std::string stays = thread_.go_statement(stuck_place());
    current_code().open(fmt::format("if (!({})) {{", conditions.whole_text()));
    current_code().line(stays);
    current_code().line("break;");
    current_code().close();
}

/// Returns the place in which a thread stays after a false precondition. This place comes before the one that is being
/// written.
const std::string& ProgramWriter::stuck_place() {
    assert(!thread_.places.empty() && thread_.labels != nullptr);
    const auto found = thread_.stuck.find(state_.index);
    if (found != thread_.stuck.end()) return found->second;
    const std::string& label = thread_.stuck[state_.index] = thread_.labels->numbered_name("stuck");
    CodeWriter stays(5);
    stays.line("return moved;");
    thread_.places.insert(thread_.places.end() - 1, {label, "outside the precondition of a function", state_, stays});
    return label;
}

void ProgramWriter::write_statement(const ir::StmtPtr& stmt, const std::string& stem) {
    if (!stmt) return;
    test_preconditions(*stmt);
    await_cycle(*stmt, stem);
    switch (stmt->kind) {
        case StmtKind::sequence:
            return write_sequence(stmt->body, stem);
        case StmtKind::if_then_else:
            return if_statement(*stmt, stem);
        case StmtKind::assign:
            return write_assignment(*stmt, stem);
        case StmtKind::communicate:
            return write_communication(*stmt, stem);
        case StmtKind::call:
            return write_call(*stmt, stem);
        case StmtKind::wait:
        case StmtKind::wait_interval:
            return write_wait(*stmt, stem);
        case StmtKind::clock_reset:
            return write_line(clock_reset(generation_, unit_, stmt->clock));
        case StmtKind::deadline:
            return write_deadline(*stmt, stem);
        case StmtKind::exec:
            return end_cycle(stem);
        case StmtKind::skip:
        case StmtKind::choose:  // only in models for the CSP checker
            return;
    }
}

/// For RoboSim: a statement that uses registers waits if the cycle has ended. A write also waits if the cycle has
/// already written its output.
void ProgramWriter::await_cycle(const ir::Stmt& stmt, const std::string& stem) {
    const std::string waits = awaits_cycle(generation_, unit_, stmt);
    if (!waits.empty()) {
        resume_here(stem, "needs the registers of a cycle");
        return_if(waits);
    }
    const std::string written = written_member(generation_, unit_, stmt);
    if (!written.empty() && !generation_.mutation.hits(Fault::cycle_output_again))
        current_code().line(written + " = true;");
}

/// For RoboSim: `exec` ends the cycle, and the thread continues in the next cycle.
void ProgramWriter::end_cycle(const std::string& stem) {
    if (generation_.mutation.hits(Fault::cycle_exec_dropped)) return;
    const std::string ended = ended_member(generation_.component, unit_);
    current_code().line(ended + " = true;");
    resume_at(fresh_label(stem), "waits for the next cycle");
    return_if(ended);
}

void ProgramWriter::write_sequence(const std::vector<ir::StmtPtr>& parts, const std::string& stem) {
    for (const ir::StmtPtr& part : parts) write_statement(part, stem);
}

void ProgramWriter::if_statement(const ir::Stmt& stmt, const std::string& stem) {
    if (may_suspend(generation_, unit_, stmt.body[0]) ||
        (stmt.body.size() > 1 && may_suspend(generation_, unit_, stmt.body[1])))
        return suspending_if(stmt, stem);
    const ExpressionWriter expressions(generation_, unit_);
    current_code().open(fmt::format("if ({}) {{", expressions.write(*stmt.condition)));
    write_statement(stmt.body[0], stem);
    if (else_branch(stmt) && else_branch(stmt)->kind != StmtKind::skip) {
        current_code().reopen_block("} else {");
        write_statement(else_branch(stmt), stem);
    }
    current_code().close();
}

void ProgramWriter::suspending_if(const ir::Stmt& stmt, const std::string& stem) {
    const ExpressionWriter expressions(generation_, unit_);
    const std::string then_label = fresh_label(stem);
    const std::string else_label = fresh_label(stem);
    const std::string end_label = fresh_label(stem);
    current_code().line(fmt::format("{} = {} ? {} : {};", thread_.variable, expressions.write_operand(*stmt.condition),
                                    thread_.qualified_label(then_label), thread_.qualified_label(else_label)));
    current_code().line("break;");
    begin_place(then_label, "then");
    write_statement(stmt.body[0], stem);
    write_jump(end_label);
    begin_place(else_label, "else");
    write_statement(else_branch(stmt), stem);
    resume_at(end_label, "end if");
}

/// Returns the call that must come before any effect that others can observe. Empty if no deadline depends on a guard.
std::string ProgramWriter::look_at_deadlines() const {
    if (!guards_deadlines(*unit_.machine)) return {};
    return fmt::format("watch({});", frame_arguments(generation_.component, unit_));
}

/// Waits until the last write of the variable has reached all readers. Before that, the variable accepts no other write
/// (semantics 3.7).
void ProgramWriter::await_propagation(const ir::Stmt& assignment, const std::string& stem) {
    const CppExpr free = may_write(generation_, unit_, assignment.variable);
    if (free.empty()) return;
    const std::string label = fresh_label(stem);
    resume_at(label, fmt::format("writes {}", unit_.machine->variables[assignment.variable.index].name));
    thread_.held_up.push_back(label);
    return_if(negation(free).whole_text());
}

void ProgramWriter::write_assignment(const ir::Stmt& stmt, const std::string& stem) {
    const ir::Variable& variable = unit_.machine->variables[stmt.variable.index];
    await_propagation(stmt, stem);
    if (variable.scope == ir::VariableScope::required) write_line(look_at_deadlines());
    const ExpressionWriter expressions(generation_, unit_);
    const ir::TypeId type = variable.type;
    if (!stmt.path.empty()) return assign_part(stmt, type);
    write_line(store_statement(generation_, unit_, stmt.variable, expressions.write_as(*stmt.value, type)));
}

/// Writes an assignment to a part of a variable. As the semantics requires, the code changes a copy and then stores the
/// whole copy.
void ProgramWriter::assign_part(const ir::Stmt& stmt, ir::TypeId whole) {
    const ExpressionWriter expressions(generation_, unit_);
    const std::string place = expressions.variable_member(stmt.variable);
    if (place.empty()) return;
    current_code().open("{");
    std::string part = "changed";
    current_code().line(fmt::format("auto changed = {};", place));
    ir::TypeId type = whole;
    bool in_row = false;  // the first index of a matrix selects a row
    std::vector<std::string> back;
    for (std::size_t step = 0; step < stmt.path.size(); ++step) {
        const ir::Type& outer = generation_.system.type(type);
        if (is_struct(outer)) {
            const std::int64_t number = stmt.path[step]->number;
            const std::int64_t first = outer.kind == ir::TypeKind::product ? 1 : 0;
            part += "." + member_name(outer, number);
            type = outer.args.at(static_cast<std::size_t>(number - first));
            continue;
        }
        const std::string index = fmt::format("place_{}", step);
        current_code().line(
            fmt::format("const std::int64_t {} = {};", index, expressions.item_index(*stmt.path[step])));
        current_code().line(fmt::format("auto item_{} = {}.at({});", step, part, index));
        back.push_back(fmt::format("{}.put({}, item_{});", part, index, step));
        part = fmt::format("item_{}", step);
        in_row = outer.kind == ir::TypeKind::matrix && !in_row;
        if (!in_row) type = outer.args.at(0);
    }
    current_code().line(fmt::format("{} = {};", part, expressions.write_as(*stmt.value, type)));
    for (auto change = back.rbegin(); change != back.rend(); ++change) current_code().line(*change);
    write_line(store_statement(generation_, unit_, stmt.variable, "changed"));
    current_code().close();
}

void ProgramWriter::write_communication(const ir::Stmt& stmt, const std::string& stem) {
    waiting_.clear();
    write_line(look_at_deadlines());
    if (stmt.communication.kind == CommKind::input) {
        await_input(stmt, stem);
    } else {
        write_send(stmt, stem);
    }
}

void ProgramWriter::await_input(const ir::Stmt& stmt, const std::string& stem) {
    const ir::Communication& communication = stmt.communication;
    const EventUse& use = generation_.component.find_event(unit_, communication.event);
    if (!from_register(use)) {
        return await_any(stmt, use, stem);
    }
    const EventPort& port = generation_.component.events[use.ports.front()];
    const std::string value = "inputs_." + port.input + ".get()";
    waiting_ = fresh_label(stem);
    resume_at(waiting_, fmt::format("waits for {}", use.name));
    const CppExpr there("inputs_." + port.input + ".present");
    const CppExpr free = conjunction(there, may_write(generation_, unit_, communication.variable));
    const CppExpr ready = conjunction(free, value_predicate(generation_, unit_, communication, value));
    return_if(fmt::format("!({})", ready.whole_text()));
    write_line(consume_statement(port));
    write_line(store_received(generation_, unit_, communication, value));
}

/// Awaits an event from several sources, or from another machine. The written code tries the sources in a function.
void ProgramWriter::await_any(const ir::Stmt& stmt, const EventUse& use, const std::string& stem) {
    const std::string at = fresh_label(stem);
    const std::string next = fresh_label(stem);
    const std::string name = "await_" + thread_.prefix + at;
    waiting_ = at;
    resume_at(at, fmt::format("waits for {}", use.name));
    return_if(fmt::format("!{}({})", name, frame_arguments(generation_.component, unit_)));
    current_code().line("break;");
    begin_place(next, fmt::format("has {}", use.name));
    CodeWriter& helper = thread_.helpers;
    helper.open_declaration(
        fmt::format("Takes {} if it is there.", use.name),
        fmt::format("bool {}({}) noexcept {{", name, frame_parameters(generation_.component, unit_)));
    const bool always = write_reception(
        generation_, unit_, stmt.communication, helper, [](const std::string&) { return CppExpr(); },
        [&] {
            helper.line(thread_.go_statement(next));
            helper.line("return true;");
        });
    if (!always) helper.line("return false;");
    helper.close();
}

void ProgramWriter::write_send(const ir::Stmt& stmt, const std::string& stem) {
    const EventUse& use = generation_.component.find_event(unit_, stmt.communication.event);
    const ExpressionWriter expressions(generation_, unit_);
    const ir::ExprPtr& expr = stmt.communication.value;
    const std::string value = expr ? expressions.write_as(*expr, *use.type) : "";
    if (generation_.component.robosim) return write_registers(use, value);
    if (!use.filled.empty()) return fill_buffers(use, value);
    if (!use.ports.empty()) return send_out(use, value);
    if (use.peers.empty()) return current_code().comment(fmt::format("{} is connected to nothing", use.name));
    const std::string at = resume_here(stem, fmt::format("sends {}", use.name));
    write_offer(use, value, at, fresh_label(stem));
}

/// For RoboSim: writes the value for the machines that read the event in the next cycle, and to the platform.
void ProgramWriter::write_registers(const EventUse& use, const std::string& value) {
    fill_buffers(use, value);
    for (const std::size_t outlet : use.outlets)
        current_code().line(fmt::format("platform_.{}({});", generation_.component.events[outlet].output, value));
}

/// Fills buffers. The writer never waits, and the newest value replaces the older value (semantics 3.9).
void ProgramWriter::fill_buffers(const EventUse& use, const std::string& value) {
    for (const std::size_t index : use.filled) {
        const std::string place = "state_." + generation_.component.buffers[index].field;
        current_code().line(fmt::format("{}.fill({});", place, value));
    }
}

/// Sends an event. Outputs are made at once and in order (docs/conformance.md, A2). If both the platform and a machine
/// could receive it, the platform does, because it is always ready.
void ProgramWriter::send_out(const EventUse& use, const std::string& value) {
    assert(!use.ports.empty());
    const EventPort& port = generation_.component.events[use.ports.front()];
    current_code().line(fmt::format("platform_.{}({});", port.output, value));
}

/// Waits until the machine that receives the event advances this thread.
void ProgramWriter::write_offer(const EventUse& use, const std::string& value, const std::string& at,
                                const std::string& next) {
    waiting_ = at;
    thread_.sites.push_back(
        {use.channel, thread_.variable, thread_.qualified_label(at), thread_.qualified_label(next), value});
    if (generation_.mutation.hits(Fault::send_not_awaited)) {
        write_jump(next);
    } else {
        current_code().line("return moved;");
    }
    begin_place(next, fmt::format("has sent {}", use.name));
    goes_on_from_here();
}

std::vector<std::string> ProgramWriter::write_arguments(const ir::Stmt& stmt) {
    const ExpressionWriter expressions(generation_, unit_);
    const auto& parameters = unit_.machine->operations[stmt.operation.index].parameters;
    assert(stmt.args.size() <= parameters.size());
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < stmt.args.size(); ++i)
        texts.push_back(expressions.write_as(*stmt.args[i], parameters[i]));
    return texts;
}

void ProgramWriter::write_call(const ir::Stmt& stmt, const std::string& stem) {
    const std::vector<std::string> texts = write_arguments(stmt);
    if (unit_.definitions[stmt.operation.index].is_valid()) {
        call_operation(stmt, texts, stem);
    } else {
        call_platform(stmt, texts, stem);
    }
}

/// Writes a call of the platform. If the thread resumes here, writes of other machines may have to wait for this call
/// (semantics 3.7). The call is then one of the thread's prompt steps, and the place ends after it.
void ProgramWriter::call_platform(const ir::Stmt& stmt, const std::vector<std::string>& texts,
                                  const std::string& stem) {
    std::optional<PromptStep> prompt = reads_variables(stmt) ? std::nullopt : std::move(resumed_);
    std::vector<std::string> lines;
    if (const std::string watch = look_at_deadlines(); !watch.empty()) lines.push_back(watch);
    const PlatformCall& call = generation_.component.find_platform_call(unit_, stmt.operation);
    lines.push_back(fmt::format("platform_.{}({});", call.method, fmt::join(texts, ", ")));
    for (const std::string& text : lines) current_code().line(text);
    if (!prompt) return;
    const std::string next = fresh_label(stem);
    prompt->lines.insert(prompt->lines.end(), lines.begin(), lines.end());
    prompt->lines.push_back(thread_.go_statement(next));
    thread_.prompt_steps.push_back(std::move(*prompt));
    resume_at(next, fmt::format("has called {}", call.method));
    goes_on_from_here();
}

CallFrame& ProgramWriter::call_frame(const Unit& operation) {
    for (auto& frame : thread_.calls)
        if (frame.operation == operation.number) return frame;
    assert(thread_.fields != nullptr);
    const std::string& name = operation.machine->name;
    thread_.calls.push_back({thread_.fields->unique_name(thread_.prefix + name), operation.number, {}});
    return thread_.calls.back();
}

void ProgramWriter::call_operation(const ir::Stmt& stmt, const std::vector<std::string>& texts,
                                   const std::string& stem) {
    const Unit& operation = generation_.component.called_unit(unit_, stmt.operation);
    CallFrame& frame = call_frame(operation);
    assert(texts.size() <= operation.variable_fields.size());
    const std::string place = "f." + frame.field;
    for (std::size_t i = 0; i < texts.size(); ++i)
        current_code().line(fmt::format("{}.{} = {};", place, operation.variable_fields[i], texts[i]));
    require_preconditions(stmt, operation, place);
    offer_to_platform(operation, place);
    if (!operation.machine->initial.is_valid()) {
        current_code().line(place + " = {};");
        return;
    }
    const std::string label = fresh_label(stem);
    frame.live.push_back(label);
    resume_at(label, fmt::format("operation {}", operation.machine->name));
    const std::string run =
        fmt::format("run({}, moved)", frame_arguments(generation_.component, operation, unit_, place));
    return_if(fmt::format("!{}", run));
    current_code().line(place + " = {};");
}

/// Writes the test of an operation's preconditions. If one is false, nothing after the call happens, as in the
/// model.
void ProgramWriter::require_preconditions(const ir::Stmt& call, const Unit& operation, const std::string& frame) {
    const ExpressionWriter expressions(generation_, operation, unit_, frame);
    for (const auto& condition : operation.machine->preconditions) {
        const CppExpr holds = expressions.expression_asked(*condition);
        const std::string place = outside_place(call, operation, *condition);
        current_code().line(fmt::format("ROBOCHART_PRECONDITION({});", holds.whole_text()));
        current_code().open("if (violated()) {");
        current_code().line(thread_.go_statement(place));
        current_code().line("return true;");
        current_code().close();
    }
}

/// Returns the place in which a thread stays after a false precondition of an operation. This place comes before the
/// one that is being written. Later cycles end there too.
std::string ProgramWriter::outside_place(const ir::Stmt& call, const Unit& operation, const ir::Expr& condition) {
    const std::string& name = operation.machine->name;
    const std::string label = thread_.labels->numbered_name("outside_" + to_identifier(name));
    CodeWriter stays(5);
    stays.line("require(false);");
    stays.line("return true;");
    thread_.places.insert(thread_.places.end() - 1, {label, "outside the precondition of " + name, state_, stays});
    thread_.violations.push_back({label, name, condition.span, call.origin.span});
    return label;
}

/// Writes code that offers the operation to the platform. If the platform performs it, the definition in the model need
/// not run: its frame moves to the final state.
void ProgramWriter::offer_to_platform(const Unit& operation, const std::string& frame) {
    const std::size_t parameters = generation_.component.modelled_call(operation.id).signature->parameters.size();
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < parameters; ++i) texts.push_back(frame + "." + operation.variable_fields[i]);
    const std::string offer = fmt::format("platform_.{}({})", generation_.component.modelled_call(operation.id).method,
                                          fmt::join(texts, ", "));
    const auto& machine = *operation.machine;
    const auto final = std::ranges::find_if(
        machine.top, [&](ir::NodeId id) { return machine.nodes[id.index].kind == ir::NodeKind::final; });
    if (!machine.initial.is_valid()) {
        current_code().line(fmt::format("static_cast<void>({});", offer));
    } else if (final != machine.top.end()) {
        const MachinePlan plan(generation_, operation);
        current_code().line(
            fmt::format("if ({}) {}.at = {}::{};", offer, frame, operation.points, plan.label_of(*final)));
    }
}

/// Writes `S <{d}` (semantics 3.10). If S may have to wait, a counter measures for how long. If a thread continues with
/// a communication, it holds up writes at once.
void ProgramWriter::write_deadline(const ir::Stmt& stmt, const std::string& stem) {
    assert(stmt.body.size() == 1 && stmt.value != nullptr);
    if (!may_suspend(generation_, unit_, stmt.body[0])) return write_statement(stmt.body[0], stem);
    const std::string field = thread_.fields->unique_name(fmt::format("deadline_{}{}", thread_.prefix, stmt.point));
    thread_.deadlines.push_back(field);
    const bool holds = stmt.body[0]->kind == StmtKind::communicate;
    std::optional<PromptStep> prompt = holds ? std::move(resumed_) : std::nullopt;
    std::vector<std::string> lines{watch_from(generation_, unit_, field, *stmt.value)};
    if (holds) begin_to_hold(lines);
    for (const std::string& text : lines) write_line(text);
    write_statement(stmt.body[0], stem);
    if (holds && !waiting_.empty()) thread_.holding.push_back(waiting_);
    if (prompt && !waiting_.empty()) {
        prompt->lines.insert(prompt->lines.end(), lines.begin(), lines.end());
        prompt->lines.push_back(thread_.go_statement(waiting_));
        thread_.prompt_steps.push_back(std::move(*prompt));
    }
    std::optional<PromptStep> resumed = std::move(resumed_);
    const std::string ended = fmt::format("f.{} = 0;", field);
    current_code().line(ended);
    if (resumed) resumed->lines.push_back(ended);
    resumed_ = std::move(resumed);
}

/// Writes the code with which a thread starts to hold up writes. The counter is reset: unless another thread holds up
/// writes, no earlier write is waiting.
void ProgramWriter::begin_to_hold(std::vector<std::string>& lines) const {
    const Part& part = generation_.component.part_of(unit_);
    for (const StoredVariable& variable : generation_.component.variables)
        for (const PropagationHolder& holder : variable.holders)
            if (holder.part == unit_.part)
                lines.push_back(
                    fmt::format("if (!holds_up({})) state_.{} = 0;", part.frame_expression(), holder.field));
}

void ProgramWriter::write_wait(const ir::Stmt& stmt, const std::string& stem) {
    const ExpressionWriter expressions(generation_, unit_);
    assert(stmt.value != nullptr);
    std::string length = fmt::format("duration({})", expressions.write(*stmt.value));
    if (generation_.options.choices && stmt.kind == StmtKind::wait_interval && stmt.upper)
        length =
            fmt::format("robochart::pick_between(platform_, {}, duration({}))", length, expressions.write(*stmt.upper));
    current_code().line(fmt::format("{} = {};", thread_.wait, length));
    thread_.waits = true;
    resume_at(fresh_label(stem), "waits");
    return_if(fmt::format("{} > 0", thread_.wait));
    goes_on_from_here(fmt::format(" && {} == 0", thread_.wait));
}

}  // namespace robochart::cpp_emit
