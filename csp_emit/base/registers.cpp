// SPDX-License-Identifier: Apache-2.0
#include "csp_emit/base/registers.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/names.hpp"
#include "csp_emit/base/types.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::DeclPtr;
using cspm::ExprPtr;

namespace {

const char* const reading = "registerRead";
const char* const writing = "registerWrite";

ExprPtr qualified_event(const std::string& path, const std::string& channel, const std::string& constructor) {
    const std::string prefix = path.empty() ? "" : path + "::";
    return b::dot({b::name(prefix + channel), b::name(prefix + constructor)});
}

cspm::Constructor constructor_of(const Project& project, const std::string& prefix, const Register& one) {
    b::Exprs fields;
    for (const ir::TypeId type : one.types) fields.push_back(type_set(project, type));
    return b::constructor(prefix + one.name, fields.empty() ? nullptr : b::dot(fields));
}

/// Declares the type, the set and the channel of the inputs or outputs.
void declare_side(const Project& project, const std::vector<Register>& used, const std::vector<Register>& named,
                  bool input, std::vector<DeclPtr>& decls) {
    const std::string prefix = input ? "i_" : "o_";
    const std::string type = input ? "RegisterDataInput" : "RegisterDataOutput";
    std::vector<cspm::Constructor> constructors;
    b::Exprs events;
    for (const Register& one : named) constructors.push_back(constructor_of(project, prefix, one));
    for (const Register& one : used) events.push_back(b::name(prefix + one.name));
    if (constructors.empty()) return;
    decls.push_back(b::datatype(type, constructors));
    decls.push_back(b::nametype(input ? "RegisterInputs" : "RegisterOutputs", b::productions(events)));
    decls.push_back(b::channel({input ? reading : writing}, b::name(type)));
}

}  // namespace

Register input_event(const std::string& name, ir::TypeId type, const ir::Origin& origin) {
    Register result{name, {ir::boolean_type}, MeaningKind::trigger, origin, true};
    if (type.is_valid()) result.types.push_back(type);
    return result;
}

Register input_variable(const std::string& name, ir::TypeId type, const ir::Origin& origin) {
    return {name, {type}, MeaningKind::trigger, origin};
}

Register output_event(const ir::Event& event) {
    Register result{event.name, {}, MeaningKind::output, event.origin, true};
    if (event.type) result.types.push_back(*event.type);
    return result;
}

Register output_variable(const std::string& name, ir::TypeId type, const ir::Origin& origin) {
    return {name, {type}, MeaningKind::assignment, origin};
}

Register output_call(const ir::OperationSignature& operation) {
    return {operation.name, operation.parameters, MeaningKind::call, operation.origin};
}

void add_register(std::vector<Register>& list, Register added) {
    if (std::ranges::find(list, added.name, &Register::name) == list.end()) list.push_back(std::move(added));
}

Registers registers_of(const ir::Machine& machine) {
    Registers result;
    const auto type_of = [&](ir::VariableId id) {
        return id.is_valid() ? machine.variables[id.index].type : ir::TypeId{};
    };
    for (const ir::Input& input : machine.inputs)
        add_register(result.inputs, input.full.is_valid()
                                        ? input_event(input.name, type_of(input.content), input.origin)
                                        : input_variable(input.name, type_of(input.content), input.origin));
    for (const ir::Event& event : machine.events)
        if (event.output) add_register(result.outputs, output_event(event));
    for (const ir::Variable& variable : machine.variables)
        if (variable.output)
            add_register(result.outputs, output_variable(variable.name.substr(1), variable.type, variable.origin));
    for (const ir::OperationSignature& operation : machine.operations)
        if (operation.output) add_register(result.outputs, output_call(operation));
    return result;
}

ExprPtr register_read(const std::string& name, const std::string& part) {
    return qualified_event(part, reading, name);
}

ExprPtr register_write(const std::string& name, const std::string& part) {
    return qualified_event(part, writing, name);
}

void declare_registers(const Project& project, const std::string& owner, const Registers& registers,
                       const std::vector<Register>& also_named, Provenance& provenance, std::vector<DeclPtr>& decls) {
    std::vector<Register> outputs = registers.outputs;
    for (const Register& one : also_named) add_register(outputs, one);
    declare_side(project, registers.inputs, registers.inputs, true, decls);
    declare_side(project, registers.outputs, outputs, false, decls);
    std::vector<Register> all = registers.inputs;
    all.insert(all.end(), outputs.begin(), outputs.end());
    for (const Register& one : all)
        if (!is_identifier("o_" + one.name))
            project.report_unsupported("the register " + one.name + ", whose name CSPM cannot write,", one.origin.span);
    for (const Register& one : registers.inputs)
        mean(provenance, owner, std::string(reading) + "." + owner + "::i_" + one.name,
             {one.event ? MeaningKind::event_read : MeaningKind::variable_read, "input " + one.name, one.types,
              one.origin});
    for (const Register& one : outputs) {
        const std::string word = one.kind == MeaningKind::call ? "call " : "output ";
        mean(provenance, owner, std::string(writing) + "." + owner + "::o_" + one.name,
             {one.kind, (one.kind == MeaningKind::assignment ? "write " : word) + one.name, one.types, one.origin});
    }
}

std::vector<std::string> visible_registers(const Registers& registers) {
    std::vector<std::string> result;
    for (const Register& one : registers.inputs) result.push_back(std::string(reading) + ".i_" + one.name);
    for (const Register& one : registers.outputs) result.push_back(std::string(writing) + ".o_" + one.name);
    return result;
}

ExprPtr visible_event(const std::string& path, const std::string& visible) {
    const std::size_t dot = visible.find('.');
    if (dot == std::string::npos) return b::name(path + "::" + visible);
    return qualified_event(path, visible.substr(0, dot), visible.substr(dot + 1));
}

ExprPtr writes_of_cycle(const std::vector<std::vector<ExprPtr>>& events_of_outputs) {
    b::Exprs once;
    for (const auto& events : events_of_outputs) {
        b::Exprs ways;
        for (const ExprPtr& event : events)
            ways.push_back(b::replicated(cspm::ExprKind::replicated_external,
                                         {b::generator("x__", b::productions({event}))},
                                         b::prefix(b::name("x__"), b::stop())));
        once.push_back(b::choice(ways));
    }
    return b::interrupt(once.empty() ? b::stop() : b::interleave(once), b::prefix(b::name("endexec"), b::skip()));
}

DeclPtr cycle_definition(const std::string& name, const std::string& length, const ExprPtr& reads,
                         const ExprPtr& execution) {
    const ExprPtr rest = b::call("wait", {b::binary(cspm::ExprKind::minus, b::name(length), b::number(1))});
    const ExprPtr next = b::sequential({rest, b::call(name, {b::name(length)})});
    const ExprPtr end = b::choice({b::prefix(b::name("terminate"), b::skip()), b::prefix(b::name("tock"), next)});
    return b::function_decl(name, {b::variable(length)}, b::sequential({reads, execution, end}),
                            "a cycle: reads, execution, time");
}

}  // namespace robochart::csp_emit
