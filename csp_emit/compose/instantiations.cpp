// SPDX-License-Identifier: Apache-2.0
// Writes the instantiations. Defaults follow semantics 3.13, and semantics/instantiate determines the finite sets.
#include "csp_emit/compose/instantiations.hpp"

#include <set>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/names.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/expressions/expressions.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/function_result.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::DeclPtr;
using cspm::ExprPtr;
using Op = cspm::ExprKind;

namespace {

/// Returns `{a..b}` if the values are consecutive, and `{a,c,...}` otherwise.
ExprPtr number_set(const std::vector<std::int64_t>& values) {
    const bool range =
        !values.empty() && values.back() - values.front() == static_cast<std::int64_t>(values.size()) - 1;
    if (range) return b::set_range(b::number(values.front()), b::number(values.back()));
    b::Exprs items;
    for (const std::int64_t value : values) items.push_back(b::number(value));
    return b::set(items);
}

/// Returns `F(e1__,e2__,T__) = if member(v,T__) then v else e1__`, which is RoboTool's clipping.
DeclPtr clipped_function(const std::string& name, const ExprPtr& value, bool unary = false) {
    const std::vector<std::string> parameters =
        unary ? std::vector<std::string>{"e1__", "t__"} : std::vector<std::string>{"e1__", "e2__", "t__"};
    return b::function_decl(name, b::variables(parameters),
                            b::if_(b::call("member", {value, b::name("t__")}), value, b::name("e1__")));
}

void add_arithmetic(const Project& project, std::vector<DeclPtr>& decls) {
    const ExprPtr left = b::name("e1__");
    const ExprPtr right = b::name("e2__");
    const ExprPtr scale = b::number(project.instantiation.scale);
    decls.push_back(clipped_function("Plus", b::binary(Op::plus, left, right)));
    decls.push_back(clipped_function("Minus", b::binary(Op::minus, left, right)));
    decls.push_back(clipped_function("Mult", b::binary(Op::times, left, right)));
    decls.push_back(clipped_function("Div", b::binary(Op::divide, left, right)));
    decls.push_back(clipped_function("Modulus", b::binary(Op::modulus, left, right)));
    decls.push_back(clipped_function("Neg", b::negate(left), true));
    if (project.instantiation.scale == 1) return;
    decls.push_back(clipped_function("RealMult", b::binary(Op::divide, b::binary(Op::times, left, right), scale)));
    decls.push_back(clipped_function("RealDiv", b::binary(Op::divide, b::binary(Op::times, left, scale), right)));
}

void add_carriers(const Project& project, std::vector<DeclPtr>& decls) {
    const ir::Instantiation& finite = project.instantiation;
    decls.push_back(
        b::value("real_scale", b::number(finite.scale), "a real r of the model is the whole number r * real_scale"));
    decls.push_back(b::nametype("core_nat", number_set(finite.nat)));
    decls.push_back(b::nametype("core_int", number_set(finite.integer)));
    decls.push_back(b::nametype("core_real", number_set(finite.real)));
    decls.push_back(b::nametype("core_boolean", b::name("Bool")));
    b::Exprs strings;
    for (const diagnostics::ForeignText& text : finite.strings) strings.push_back(b::string(text.unescaped()));
    decls.push_back(b::nametype("core_string", b::set(strings)));
    decls.push_back(b::nametype("core_clock_type", b::set_range(b::number(0), b::number(finite.clock_bound))));
    for (const ir::Type& type : project.system.types)
        if (type.kind == ir::TypeKind::given)
            decls.push_back(b::nametype(type_name(type), b::set_range(b::number(0), b::number(finite.given_size - 1))));
}

/// Defines every constant once, with the value of the instantiation or of the model.
class Constants {
public:
    Constants(const Project& project, std::vector<DeclPtr>& decls) : project_(project), decls_(decls) {}

    void add_constant(const std::string& name, const ir::Constant& constant, const ir::Machine* machine) {
        if (!seen_.insert(name).second) return;
        decls_.push_back(b::value(name, value_of(name, constant, machine)));
    }
    /// Defines a machine's constant in a controller. It has the value of the machine's own constant, unless the
    /// instantiation gives it another value.
    void add_part(const std::string& name, const std::string& own, const ir::Constant& constant,
                  const ir::Machine& machine) {
        if (!seen_.insert(name).second) return;
        const bool same = default_constant(project_, own, name) == own;
        decls_.push_back(b::value(name, same ? b::name(own) : value_of(name, constant, &machine)));
    }

private:
    ExprPtr value_of(const std::string& name, const ir::Constant& constant, const ir::Machine* machine) const {
        const auto& given = project_.instantiation.constants;
        if (const auto found = given.find(name); found != given.end())
            return value_literal(project_, constant.type, found->second);
        if (!constant.value) return default_literal(project_, constant.type);
        if (has_part(*constant.value, calls_function)) return computed_value(constant, machine);
        const auto known = ir::evaluate_constant(project_.system, project_.instantiation, machine, *constant.value);
        if (known) return value_literal(project_, constant.type, *known);
        project_.report_unsupported("the value of constant " + constant.name + ", which is not constant",
                                    constant.origin.span);
        return b::number(0);
    }

    static bool calls_function(const ir::Expr& part) {
        return part.kind == ir::ExprKind::call || part.kind == ir::ExprKind::function_value;
    }
    /// Returns the value of a constant. The script computes results of functions, because the user may define the
    /// functions there.
    ExprPtr computed_value(const ir::Constant& constant, const ir::Machine* machine) const {
        Scope scope;
        scope.constant = [machine](ir::ConstantId id) {
            return b::name(ir::constant_name(machine->package, machine->path, machine->constants.at(id.index).name));
        };
        const auto names_constant = [](const ir::Expr& part) { return part.kind == ir::ExprKind::constant; };
        if (machine != nullptr || !has_part(*constant.value, names_constant))
            return expression_as(project_, scope, *constant.value, constant.type);
        project_.report_unsupported("the value of constant " + constant.name + ", which is not constant",
                                    constant.origin.span);
        return b::number(0);
    }

    const Project& project_;
    std::vector<DeclPtr>& decls_;
    std::set<std::string> seen_;
};

void add_parts(const ir::System& system, const ir::Controller& controller, Constants& constants) {
    const auto part = [&](const std::string& name, const ir::Machine& machine) {
        for (const ir::Constant& constant : machine.constants)
            constants.add_part(ir::constant_name(controller.package, controller.path + "::" + name, constant.name),
                               ir::constant_name(machine.package, machine.path, constant.name), constant, machine);
    };
    for (const auto& instance : controller.machines) part(instance.name, system.machine(instance.machine));
    for (std::size_t i = 0; i < controller.definitions.size(); ++i)
        part(controller.definition_names.at(i), system.machine(controller.definitions[i]));
}

void add_constants(const Project& project, std::vector<DeclPtr>& decls) {
    Constants constants(project, decls);
    const ir::System& system = project.system;
    for (const ir::Machine& machine : system.machines)
        for (const ir::Constant& constant : machine.constants)
            constants.add_constant(ir::constant_name(machine.package, machine.path, constant.name), constant, &machine);
    for (const ir::Controller& controller : system.controllers) {
        for (const ir::Constant& constant : controller.constants)
            constants.add_constant(ir::constant_name(controller.package, controller.path, constant.name), constant,
                                   nullptr);
        add_parts(system, controller, constants);
    }
    for (const ir::Module& module : system.modules)
        for (const ir::Constant& constant : module.platform.constants)
            constants.add_constant(ir::constant_name(module.package, module.name, constant.name), constant, nullptr);
    for (const ir::Simulation& simulation : system.simulations)
        constants.add_constant(ir::constant_name("", simulation.name, ir::cycle_length), simulation.cycle, nullptr);
}

/// Returns the preconditions of the functions that the condition calls, followed by the condition.
b::Exprs with_preconditions(const Project& project, const ir::Expr& condition) {
    b::Exprs result = translate_preconditions(project, {}, condition);
    result.push_back(translate_expression(project, {}, condition));
    return result;
}

b::Patterns parameters_of(const ir::Function& function) {
    b::Patterns result;
    for (const std::string& name : function.parameter_names) result.push_back(b::variable(bound_name(name)));
    return result;
}

/// Returns `f(x) = body` or, without parameters, `f() = body`, as in RoboTool's instantiations.
DeclPtr function_definition(const std::string& name, const ir::Function& function, const ExprPtr& body,
                            const std::string& comment = "") {
    cspm::Decl decl = *b::function_decl(name, {b::wildcard()}, body, comment);
    decl.patterns = {parameters_of(function)};
    return std::make_shared<const cspm::Decl>(std::move(decl));
}

/// Returns the expression for the default value if it satisfies the postconditions, and otherwise for the first value
/// that does.
ExprPtr search_result(const Project& project, const ir::Function& function) {
    b::Exprs conditions;
    for (const auto& condition : function.postconditions)
        for (ExprPtr& part : with_preconditions(project, *condition)) conditions.push_back(part);
    const ExprPtr constant = default_literal(project, function.result);
    const ExprPtr candidates =
        b::set_comprehension({b::name("elem__")}, {b::generator("elem__", type_set(project, function.result)),
                                                   b::condition(b::call("ok__", {b::name("elem__")}))});
    const ExprPtr none = b::call("error", {b::string("no value satisfies the postcondition of " + function.name)});
    const ExprPtr first =
        b::if_(b::call("empty", {b::name("found__")}), none, b::call("head", {b::call("seq", {b::name("found__")})}));
    return b::let_({b::function_decl("ok__", {b::variable(bound_name("result"))}, b::all_of(conditions))},
                   b::if_(b::call("ok__", {constant}), constant, b::let_({b::value("found__", candidates)}, first)));
}

/// The value of the result's expression. A search would compute this expression for each value of the result's type,
/// and each of its calls would search again.
ExprPtr named_result(const Project& project, const ir::Function& function, const ir::Expr& expression) {
    const ExprPtr none = b::call("error", {b::string("no value satisfies the postcondition of " + function.name)});
    const ExprPtr value = b::name("value__");
    const ExprPtr result = b::let_({b::value("value__", translate_expression(project, {}, expression))},
                                   b::if_(b::call("member", {value, type_set(project, function.result)}), value, none));
    const b::Exprs conditions = translate_preconditions(project, {}, expression);
    return conditions.empty() ? result : b::if_(b::all_of(conditions), result, none);
}

/// The body of a function with postconditions.
ExprPtr specified_result(const Project& project, const ir::Function& function) {
    const ir::ExprPtr expression = ir::result_expression(function);
    if (expression && ir::is_recursive(project.system, function)) return named_result(project, function, *expression);
    return search_result(project, function);
}

/// Adds the functions. In RoboChart, functions have contracts and no bodies. The generated body returns a value that
/// satisfies the postcondition. Without a postcondition it returns 0 or the first literal, as RoboTool's body does. The
/// user may override it.
void add_functions(const Project& project, std::vector<DeclPtr>& decls) {
    for (const ir::Function& function : project.system.functions) {
        const bool specified = !function.postconditions.empty();
        decls.push_back(function_definition(
            function_name(function), function,
            specified ? specified_result(project, function) : default_literal(project, function.result),
            specified ? "function by its postcondition" : "function without body: default value"));
    }
}

}  // namespace

std::string default_constant(const Project& project, const std::string& own, const std::string& part) {
    const auto& given = project.instantiation.constants;
    const auto of_part = given.find(part);
    const auto of_own = given.find(own);
    const bool differs = of_part != given.end() && (of_own == given.end() || of_own->second != of_part->second);
    return differs ? part : own;
}

std::vector<DeclPtr> data_definitions(const Project& project) {
    std::vector<DeclPtr> decls;
    for (const ir::Type& type : project.system.types) {
        if (type.kind != ir::TypeKind::enumeration) continue;
        std::vector<cspm::Constructor> constructors;
        for (std::size_t i = 0; i < type.labels.size(); ++i) {
            b::Exprs fields;
            if (i < type.literal_args.size())
                for (const ir::TypeId argument : type.literal_args[i]) fields.push_back(type_set(project, argument));
            constructors.push_back(b::constructor(literal_name(type, i), fields.empty() ? nullptr : b::dot(fields)));
        }
        decls.push_back(b::datatype(type_name(type), constructors));
    }
    for (const ir::Function& function : project.system.functions) {
        if (function.preconditions.empty()) continue;
        b::Exprs conditions;
        for (const auto& condition : function.preconditions)
            for (ExprPtr& part : with_preconditions(project, *condition)) conditions.push_back(part);
        decls.push_back(function_definition("pre_" + function_name(function), function, b::all_of(conditions)));
    }
    return decls;
}

namespace {

/// Returns the names that the script declares at top level, except those for records.
std::set<std::string> names_at_top(const ir::System& system) {
    std::set<std::string> names;
    const auto add_component = [&](const auto& component) {
        names.insert(component.package.empty() ? component.name : flatten_name(component.package));
    };
    for (const ir::Machine& machine : system.machines) add_component(machine);
    for (const ir::Controller& controller : system.controllers) add_component(controller);
    for (const ir::Module& module : system.modules) add_component(module);
    for (const ir::Simulation& simulation : system.simulations) names.insert(simulation.name);
    for (const ir::Function& function : system.functions) names.insert(function_name(function));
    for (const ir::NamedConstant& constant : ir::named_constants(system)) names.insert(constant.name);
    for (const ir::Type& type : system.types) {
        if (type.kind == ir::TypeKind::enumeration || type.kind == ir::TypeKind::given) names.insert(type_name(type));
        if (type.kind == ir::TypeKind::enumeration)
            for (std::size_t i = 0; i < type.labels.size(); ++i) names.insert(literal_name(type, i));
    }
    return names;
}

}  // namespace

std::vector<DeclPtr> record_definitions(const Project& project, const std::set<std::string>& declared) {
    std::vector<DeclPtr> decls;
    std::set<std::string> taken = declared;
    taken.merge(names_at_top(project.system));
    const auto add = [&](const std::string& name, const b::Patterns& parameters, const ExprPtr& body) {
        if (!project.blocks_mention(name) || !taken.insert(name).second) return;
        decls.push_back(b::function_decl(name, parameters, body));
    };
    for (const ir::Type& type : project.system.types) {
        if (type.kind != ir::TypeKind::record) continue;
        const std::string carrier = type_name(type);
        if (project.blocks_mention(carrier) && !is_reserved(carrier) && taken.insert(carrier).second)
            decls.push_back(b::nametype(
                carrier, type_set(project, {static_cast<std::uint32_t>(&type - project.system.types.data())})));
        b::Patterns variables;
        b::Exprs values;
        for (std::size_t i = 0; i < type.labels.size(); ++i) {
            variables.push_back(b::variable("x" + std::to_string(i + 1) + "__"));
            values.push_back(b::name("x" + std::to_string(i + 1) + "__"));
        }
        const cspm::PatternPtr whole = variables.size() == 1 ? variables.front() : b::tuple_pattern(variables);
        for (std::size_t i = 0; i < type.labels.size(); ++i) {
            const std::string name = type_name(type) + "_" + type.labels[i];
            b::Exprs changed = values;
            changed[i] = b::name("v__");
            add(name, {whole}, values[i]);
            add("update_" + name, {whole, b::variable("v__")},
                changed.size() == 1 ? changed.front() : b::tuple(changed));
        }
    }
    return decls;
}

std::vector<DeclPtr> instantiation_definitions(const Project& project) {
    std::vector<DeclPtr> decls;
    add_carriers(project, decls);
    add_arithmetic(project, decls);
    add_constants(project, decls);
    add_functions(project, decls);
    return decls;
}

}  // namespace robochart::csp_emit
