// SPDX-License-Identifier: Apache-2.0
// Lowers the registers of a RoboSim machine or operation, their reads in expressions, and the lengths of cycles
// (docs/robosim.md). Two variables represent a register: one states whether the register is full, and the other holds
// its value.
#include "semantics/lower/registers.hpp"

#include <algorithm>
#include <map>

#include "semantics/ir/query.hpp"
#include "semantics/lower/expression_lowering.hpp"
#include "semantics/lower/types.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

VariableId add_variable(Declarations& declared, const std::string& name, TypeId type, const Origin& origin) {
    declared.variables.push_back({name, type, VariableScope::reg, nullptr, "", origin});
    return {static_cast<std::uint32_t>(declared.variables.size() - 1)};
}

/// Adds the members of one context.
class Registers {
public:
    Registers(Lowering& lowering, const std::string& element, Declarations& declared, std::vector<Input>& inputs)
        : lowering_(lowering), element_(element), declared_(declared), inputs_(inputs) {}

    void add_context(const ast::Context& registers) {
        const bool input = registers.kind == ast::DeclKind::input_context;
        for (const auto& event : registers.events) add_event(*event, input);
        for (const ast::InterfaceClause& clause : registers.interfaces) {
            if (clause.target == nullptr || clause.target->kind != ast::DeclKind::interface) {
                lowering_.report_unresolved("interface '" + clause.name.text() + "'", clause.name.span);
                continue;
            }
            add_interface(static_cast<const ast::Context&>(*clause.target), clause.use, input);
        }
    }

private:
    /// Adds the members of an interface. An input context does not have the events of interfaces that it requires.
    void add_interface(const ast::Context& interface, ast::InterfaceUse use, bool input) {
        if (!input || use == ast::InterfaceUse::uses)
            for (const auto& event : interface.events) add_event(*event, input);
        for (const auto& variable : interface.variables)
            if (variable->kind == ast::DeclKind::variable) add_register(*variable, input);
        if (input) return;
        for (const auto& operation : interface.signatures) add_operation(*operation);
    }

    void add_event(const ast::Event& source, bool input) {
        if (source.broadcast) lowering_.report_unsupported("broadcast event " + source.name, source.span);
        const Origin origin = origin_of(element_ + "::" + source.name, source.span);
        const bool typed = source.type_expr || source.type;
        const TypeId type = typed ? lower_type(lowering_, source.type, source.span) : TypeId{};
        if (input) {
            if (!declared_.names.inputs.try_emplace(&source, inputs_.size()).second) return;
            Input result{source.name, add_variable(declared_, "$" + source.name, boolean_type, origin), {}, origin};
            if (typed) result.content = add_variable(declared_, "$" + source.name + "?", type, origin);
            inputs_.push_back(std::move(result));
            return;
        }
        if (declared_.names.events.contains(&source)) return;
        declared_.names.events[&source] = EventId{static_cast<std::uint32_t>(declared_.events.size())};
        Event event;
        event.name = source.name;
        if (typed) event.type = type;
        event.output = true;
        event.origin = origin;
        declared_.events.push_back(std::move(event));
    }

    /// Adds the register of a variable. A variable in both contexts has only one register.
    void add_register(const ast::Variable& source, bool input) {
        const Origin origin = origin_of(element_ + "::" + source.name, source.span);
        auto& known = declared_.names.registers;
        if (!known.contains(&source))
            known[&source] =
                add_variable(declared_, "$" + source.name, lower_type(lowering_, source.type, source.span), origin);
        const VariableId id = known.at(&source);
        if (!input) declared_.variables[id.index].output = true;
        if (input && declared_.names.inputs.try_emplace(&source, inputs_.size()).second)
            inputs_.push_back({source.name, {}, id, origin});
    }

    void add_operation(const ast::OperationSignature& source) {
        OperationSignature signature;
        signature.name = source.name;
        for (const auto& item : source.parameters) {
            signature.parameter_names.push_back(item->name);
            signature.parameters.push_back(lower_type(lowering_, item->type, item->span));
        }
        signature.output = true;
        signature.origin = origin_of(element_ + "::" + source.name, source.span);
        const auto same = std::ranges::find_if(declared_.operations, [&](const OperationSignature& known) {
            return known.output && known.name == signature.name;
        });
        declared_.names.platform_operations[&source] =
            OperationId{static_cast<std::uint32_t>(same - declared_.operations.begin())};
        if (same == declared_.operations.end()) declared_.operations.push_back(std::move(signature));
    }

    Lowering& lowering_;
    const std::string& element_;
    Declarations& declared_;
    std::vector<Input>& inputs_;
};

const ast::Expr& inside_parentheses(const ast::Expr& expr) {
    const ast::Expr* inner = &expr;
    while (inner->kind == ast::ExprKind::parenthesised && inner->args[0]) inner = inner->args[0].get();
    return *inner;
}

bool is_cycle(const ast::Expr& expr) {
    return inside_parentheses(expr).kind == ast::ExprKind::cycle;
}

/// Returns the length e in `cycle == e`, `(cycle == e)`, `{ cycle == e }` or `e`.
const ast::Expr& length_in(const ast::Expr& written) {
    const ast::Expr& expr = inside_parentheses(written);
    if (expr.kind == ast::ExprKind::set && expr.args.size() == 1) return length_in(*expr.args[0]);
    if (expr.kind != ast::ExprKind::binary || expr.binary != ast::BinaryOp::equal) return expr;
    if (is_cycle(*expr.args[0])) return *expr.args[1];
    return is_cycle(*expr.args[1]) ? *expr.args[0] : expr;
}

/// True for a literal that is a whole number, even if it is written as a decimal such as 2.0.
bool is_whole(const Expr& expr) {
    if (expr.kind == ExprKind::integer) return true;
    if (expr.kind != ExprKind::real) return expr.type == nat_type || expr.type == integer_type;
    std::int64_t unit = 1;
    for (std::uint32_t i = 0; i < expr.decimal.decimals && unit <= INT64_MAX / 10; ++i) unit *= 10;
    return expr.decimal.unscaled % unit == 0;
}

}  // namespace

namespace {

/// Reports two inputs, or two outputs, with the same name, because names identify registers.
void check_register_names(const Lowering& lowering, const std::string& owner, const Declarations& declared,
                          const std::vector<Input>& inputs) {
    std::map<std::string, diagnostics::Span> read, written;
    const auto add = [&](std::map<std::string, diagnostics::Span>& named, const char* kind, const std::string& name,
                         diagnostics::Span span) {
        const auto [first, added] = named.try_emplace(name, span);
        if (!added)
            lowering.diagnostics.report(rules::declared_twice, span, {owner, kind, name})
                .notes.push_back({first->second, "the first one"});
    };
    for (const Input& input : inputs) add(read, "input", input.name, input.origin.span);
    for (const Event& event : declared.events)
        if (event.output) add(written, "output", event.name, event.origin.span);
    for (const Variable& variable : declared.variables)
        if (variable.output) add(written, "output", variable.name.substr(1), variable.origin.span);
    for (const OperationSignature& operation : declared.operations)
        if (operation.output) add(written, "output", operation.name, operation.origin.span);
}

}  // namespace

void add_registers(Lowering& lowering, const ast::Machine& source, const std::string& element, Declarations& declared,
                   std::vector<Input>& inputs) {
    Registers registers(lowering, element, declared, inputs);
    if (source.input) registers.add_context(*source.input);
    if (source.output) registers.add_context(*source.output);
    check_register_names(lowering, element, declared, inputs);
}

ExprPtr lower_cycle_length(Lowering& lowering, const Names& names, const ast::Expr& written) {
    const ast::Expr& source = length_in(written);
    const ExprPtr length = lower_expression(lowering, names, source);
    if (is_whole(*length)) return length;
    lowering.diagnostics.report(rules::robosim_unsupported, source.span,
                                {"a cycle that is not a whole number of time units",
                                 "choose a smaller unit of time, so that the cycle and all times are whole numbers"});
    return length;
}

Constant cycle_constant(Lowering& lowering, const Names& names, const ast::Context& source, bool required) {
    Constant result;
    result.name = cycle_length;
    result.type = nat_type;
    result.required = required;
    result.origin = origin_of(source.name, source.cycle ? source.cycle->span : source.name_span);
    if (source.cycle) result.value = lower_cycle_length(lowering, names, *source.cycle);
    return result;
}

ExprPtr Expressions::read_variable(const ast::Expr& source, VariableId id) const {
    Expr expr;
    expr.kind = ExprKind::variable;
    expr.span = source.span;
    expr.variable = id;
    expr.type = names_.machine->variables[id.index].type;
    expr.text = names_.machine->variables[id.index].name;
    return share_expression(std::move(expr));
}

/// Lowers `$e`, `$e?v`, `$e?v : p` and `$x`. In p, v is the value of the register. Elsewhere in the condition, v is the
/// variable.
ExprPtr Expressions::lower_register(const ast::Expr& source) {
    const auto input = names_.inputs.find(source.target);
    if (names_.machine == nullptr || input == names_.inputs.end()) {
        lowering_.report_unresolved("register '$" + source.name.text() + "'", source.span);
        return make_boolean(true, source.span);
    }
    const Input& read = names_.machine->inputs[input->second];
    if (!read.full.is_valid()) return read_variable(source, read.content);
    ExprPtr result = read_variable(source, read.full);
    if (source.args.empty()) return result;
    if (!read.content.is_valid()) {
        lowering_.report_unresolved("the value of '$" + source.name.text() + "'", source.span);
        return result;
    }
    add_store(source, read.content);
    if (source.args.size() < 2 || !source.args[1]) return result;
    Names received = names_;
    received.variables[source.args[0]->target] = read.content;
    return make_conjunction(result, lower_expression(lowering_, received, *source.args[1], boolean_type));
}

void Expressions::add_store(const ast::Expr& source, VariableId content) {
    if (names_.stores == nullptr) {
        lowering_.diagnostics.report(rules::robosim_unsupported, source.span,
                                     {"a value of a register that is stored outside of the condition of a transition",
                                      "no source defines when the store happens"});
        return;
    }
    const ast::Expr& target = *source.args[0];
    Stmt store;
    store.kind = StmtKind::assign;
    store.point = names_.machine->points++;
    const bool written = target.kind == ast::ExprKind::register_;
    store.variable = look_up(written ? names_.registers : names_.variables, target.target);
    if (!store.variable.is_valid()) return lowering_.report_unresolved("'" + target.name.text() + "'", target.span);
    store.value =
        coerce_to_type(lowering_, read_variable(source, content), names_.machine->variables[store.variable.index].type);
    store.origin = origin_of(names_.machine->path, source.span);
    names_.stores->push_back(std::make_shared<const Stmt>(std::move(store)));
}

/// Lowers `cycle`, which is a constant of the machine.
ExprPtr Expressions::lower_cycle(const ast::Expr& source) {
    Expr expr;
    expr.kind = ExprKind::constant;
    expr.span = source.span;
    expr.type = nat_type;
    expr.text = cycle_length;
    const auto& constants = names_.machine != nullptr ? names_.machine->constants : std::vector<Constant>{};
    const auto found = std::ranges::find(constants, cycle_length, &Constant::name);
    if (found == constants.end()) {
        lowering_.report_unresolved("`cycle`", source.span);
        return make_boolean(true, source.span);
    }
    expr.constant = {static_cast<std::uint32_t>(found - constants.begin())};
    return share_expression(std::move(expr));
}

}  // namespace robochart::ir
