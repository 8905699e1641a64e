#include "cpp_emit/thread_code.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cpp_emit/expression.hpp"
#include "cpp_emit/machine_plan.hpp"
#include "cpp_emit/types.hpp"

namespace robochart::cpp_emit {

using ir::CommKind;
using ir::StmtKind;

bool suspends(const Unit& unit, const ir::StmtPtr& stmt) {
    if (!stmt) return false;
    switch (stmt->kind) {
        case StmtKind::wait:
        case StmtKind::wait_interval:
            return true;
        case StmtKind::communicate:
            return stmt->communication.kind == CommKind::input;
        case StmtKind::call:
            return unit.definitions[stmt->operation.index].valid();
        default:
            return std::any_of(stmt->body.begin(), stmt->body.end(),
                               [&](const ir::StmtPtr& part) { return suspends(unit, part); });
    }
}

std::string store(const Generation& generation, const Unit& unit, ir::VariableId id, const std::string& value) {
    const StoredVariable* stored = generation.component.stored(unit, id);
    if (stored != nullptr && stored->visible) return fmt::format("write_{}({});", stored->variable->name, value);
    const std::string place = ExpressionWriter(generation, unit, "f").variable(id);
    return place.empty() ? "" : fmt::format("{} = {};", place, value);
}

std::string receivable(const Generation& generation, const Unit& unit, const ir::Communication& communication) {
    const EventPort& event = generation.component.event(unit, communication.event);
    const std::string input = "inputs_." + event.input;
    ExpressionWriter expressions(generation, unit, "f");
    expressions.set_incoming(input + ".value");
    std::string condition = input + ".present";
    if (communication.predicate) condition += fmt::format(" && ({})", expressions.write(*communication.predicate));
    return condition;
}

ProgramWriter::ProgramWriter(const Generation& generation, const Unit& unit, Thread& thread, ir::NodeId state)
    : generation_(generation), unit_(unit), thread_(thread), state_(state) {}

CodeWriter& ProgramWriter::code() {
    return thread_.places.back().code;
}

void ProgramWriter::begin(const std::string& label, const std::string& comment) {
    thread_.places.push_back({label, comment, state_, CodeWriter(5)});
}

void ProgramWriter::jump(const std::string& label) {
    code().line(thread_.go(label));
    code().line("break;");
}

void ProgramWriter::line(const std::string& text) {
    if (!text.empty()) code().line(text);
}

void ProgramWriter::resume_at(const std::string& label, const std::string& comment) {
    jump(label);
    begin(label, comment);
}

std::string ProgramWriter::fresh(const std::string& stem) {
    return thread_.labels->numbered(stem);
}

void ProgramWriter::statement(const ir::StmtPtr& stmt, const std::string& stem) {
    if (!stmt) return;
    switch (stmt->kind) {
        case StmtKind::sequence:
            for (const auto& part : stmt->body) statement(part, stem);
            return;
        case StmtKind::if_then_else:
            return if_statement(*stmt, stem);
        case StmtKind::assign:
            return assign(*stmt);
        case StmtKind::communicate:
            return communicate(*stmt, stem);
        case StmtKind::call:
            return call(*stmt, stem);
        case StmtKind::wait:
        case StmtKind::wait_interval:
            return wait(*stmt, stem);
        case StmtKind::clock_reset:
            return line(clock_reset(generation_, unit_, stmt->clock));
        case StmtKind::skip:
        case StmtKind::deadline:
            return;  // deadlines are refused before (support.cpp)
    }
}

void ProgramWriter::if_statement(const ir::Stmt& stmt, const std::string& stem) {
    if (suspends(unit_, stmt.body[0]) || (stmt.body.size() > 1 && suspends(unit_, stmt.body[1])))
        return suspending_if(stmt, stem);
    const ExpressionWriter expressions(generation_, unit_, "f");
    code().open(fmt::format("if ({}) {{", expressions.write(*stmt.condition)));
    statement(stmt.body[0], stem);
    if (stmt.body.size() > 1 && stmt.body[1] && stmt.body[1]->kind != StmtKind::skip) {
        code().reopen("} else {");
        statement(stmt.body[1], stem);
    }
    code().close();
}

void ProgramWriter::suspending_if(const ir::Stmt& stmt, const std::string& stem) {
    const ExpressionWriter expressions(generation_, unit_, "f");
    const std::string then_label = fresh(stem);
    const std::string else_label = fresh(stem);
    const std::string end_label = fresh(stem);
    code().line(fmt::format("{} = {} ? {} : {};", thread_.variable, expressions.write(*stmt.condition),
                            thread_.at(then_label), thread_.at(else_label)));
    code().line("break;");
    begin(then_label, "then");
    statement(stmt.body[0], stem);
    jump(end_label);
    begin(else_label, "else");
    if (stmt.body.size() > 1) statement(stmt.body[1], stem);
    resume_at(end_label, "end if");
}

void ProgramWriter::assign(const ir::Stmt& stmt) {
    if (generation_.mutation.hits(Fault::assignment_dropped)) return;
    const ExpressionWriter expressions(generation_, unit_, "f");
    const ir::TypeId type = unit_.machine->variables[stmt.variable.index].type;
    line(store(generation_, unit_, stmt.variable, expressions.write_as(*stmt.value, type)));
}

std::string clock_reset(const Generation& generation, const Unit& unit, ir::ClockId id) {
    const auto [owner, own] = generation.component.clock(unit, id);
    if (!owner->clock_read[own.index] || generation.mutation.hits(Fault::clock_not_reset)) return {};
    const bool off_by_one = generation.mutation.hits(Fault::clock_off_by_one);
    return fmt::format("{} = {};", ExpressionWriter(generation, unit, "f").clock(id), off_by_one ? 1 : 0);
}

void ProgramWriter::communicate(const ir::Stmt& stmt, const std::string& stem) {
    if (stmt.communication.kind == CommKind::input) {
        await_input(stmt, stem);
    } else {
        send(stmt);
    }
}

void ProgramWriter::await_input(const ir::Stmt& stmt, const std::string& stem) {
    const ir::Communication& communication = stmt.communication;
    const EventPort& event = generation_.component.event(unit_, communication.event);
    if (!generation_.mutation.hits(Fault::input_not_awaited)) {
        resume_at(fresh(stem), fmt::format("waits for {}", event.model_name));
        code().open(fmt::format("if (!({})) {{", receivable(generation_, unit_, communication)));
        code().line("return moved;");
        code().close();
    }
    code().line(fmt::format("inputs_.{}.present = false;", event.input));
    if (!communication.variable.valid()) return;
    line(store(generation_, unit_, communication.variable, fmt::format("inputs_.{}.value", event.input)));
}

void ProgramWriter::send(const ir::Stmt& stmt) {
    const EventPort& event = generation_.component.event(unit_, stmt.communication.event);
    if (!event.outside) {
        code().comment(fmt::format("{} is connected to nothing", event.model_name));
        return;
    }
    const ExpressionWriter expressions(generation_, unit_, "f");
    const ir::ExprPtr& value = stmt.communication.value;
    code().line(fmt::format("platform_.{}({});", event.output,
                            value ? expressions.write_as(*value, *event.type) : std::string()));
}

std::vector<std::string> ProgramWriter::arguments(const ir::Stmt& stmt) {
    const ExpressionWriter expressions(generation_, unit_, "f");
    const auto& parameters = unit_.machine->operations[stmt.operation.index].parameters;
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < stmt.args.size(); ++i)
        texts.push_back(expressions.write_as(*stmt.args[i], parameters[i]));
    const bool swappable = texts.size() >= 2 && parameters[0] == parameters[1];
    if (swappable && generation_.mutation.hits(Fault::argument_swapped)) std::swap(texts[0], texts[1]);
    return texts;
}

void ProgramWriter::call(const ir::Stmt& stmt, const std::string& stem) {
    const std::vector<std::string> texts = arguments(stmt);
    if (unit_.definitions[stmt.operation.index].valid()) {
        call_operation(stmt, texts, stem);
    } else {
        call_platform(stmt, texts);
    }
}

void ProgramWriter::call_platform(const ir::Stmt& stmt, const std::vector<std::string>& texts) {
    const PlatformCall& call = generation_.component.call(unit_, stmt.operation);
    code().line(fmt::format("platform_.{}({});", call.method, fmt::join(texts, ", ")));
}

CallFrame& ProgramWriter::call_frame(ir::MachineId operation) {
    for (auto& frame : thread_.calls)
        if (frame.operation == operation) return frame;
    const std::string& name = generation_.component.unit(operation).machine->name;
    thread_.calls.push_back({thread_.fields->unique(thread_.prefix + name), operation, {}});
    return thread_.calls.back();
}

void ProgramWriter::call_operation(const ir::Stmt& stmt, const std::vector<std::string>& texts,
                                   const std::string& stem) {
    const ir::MachineId id = unit_.definitions[stmt.operation.index];
    const Unit& operation = generation_.component.unit(id);
    CallFrame& frame = call_frame(id);
    const std::string place = "f." + frame.field;
    for (std::size_t i = 0; i < texts.size(); ++i)
        code().line(fmt::format("{}.{} = {};", place, operation.variable_fields[i], texts[i]));
    require_preconditions(operation, place);
    offer_to_platform(operation, place);
    if (!operation.machine->initial.valid()) {
        code().line(place + " = {};");
        return;
    }
    const std::string label = fresh(stem);
    frame.live.push_back(label);
    resume_at(label, fmt::format("operation {}", operation.machine->name));
    code().open(fmt::format("if (!run({}, moved)) {{", place));
    code().line("return moved;");
    code().close();
    code().line(place + " = {};");
}

void ProgramWriter::require_preconditions(const Unit& operation, const std::string& frame) {
    const ExpressionWriter expressions(generation_, operation, frame);
    for (const auto& condition : operation.machine->preconditions)
        code().line(fmt::format("ROBOCHART_PRECONDITION({});", expressions.write(*condition)));
}

/// The platform may do an operation itself; then the model's definition counts as finished.
void ProgramWriter::offer_to_platform(const Unit& operation, const std::string& frame) {
    const std::size_t parameters = generation_.component.modelled_call(operation.id).signature->parameters.size();
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < parameters; ++i) texts.push_back(frame + "." + operation.variable_fields[i]);
    const std::string offer = fmt::format("platform_.{}({})", generation_.component.modelled_call(operation.id).method,
                                          fmt::join(texts, ", "));
    const auto& machine = *operation.machine;
    const auto final = std::find_if(machine.top.begin(), machine.top.end(),
                                    [&](ir::NodeId id) { return machine.nodes[id.index].kind == ir::NodeKind::final; });
    if (!machine.initial.valid()) {
        code().line(fmt::format("static_cast<void>({});", offer));
    } else if (final != machine.top.end()) {
        const MachinePlan plan(generation_, operation);
        code().line(fmt::format("if ({}) {}.at = {}::{};", offer, frame, operation.points, plan.label(*final)));
    }
}

void ProgramWriter::wait(const ir::Stmt& stmt, const std::string& stem) {
    if (generation_.mutation.hits(Fault::wait_dropped)) return;
    const ExpressionWriter expressions(generation_, unit_, "f");
    code().line(fmt::format("{} = duration({});", thread_.wait, expressions.write(*stmt.value)));
    thread_.waits = true;
    resume_at(fresh(stem), "waits");
    code().open(fmt::format("if ({} > 0) {{", thread_.wait));
    code().line("return moved;");
    code().close();
}

}  // namespace robochart::cpp_emit
