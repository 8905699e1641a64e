// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/unsupported.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "cpp_emit/plan/exploration_ports.hpp"
#include "cpp_emit/plan/functions.hpp"
#include "cpp_emit/plan/rules.hpp"
#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/views.hpp"
#include "cpp_emit/plan/walk.hpp"
#include "semantics/evaluate/carrier.hpp"
#include "semantics/evaluate/preconditions.hpp"

namespace robochart::cpp_emit {

namespace {

using diagnostics::Diagnostics;
using diagnostics::Span;
using ir::ExprKind;
using ir::NodeKind;

/// The maximal number of arguments in a record of the exploration interface (runtime/explore_abi.h).
constexpr std::size_t max_arguments = 8;
constexpr std::size_t max_output_values = 65536;
/// The maximal number of numbers and literals in all listed values of one type. A compiler needs seconds for this many.
constexpr std::size_t max_listed = 8 * max_output_values;
constexpr std::size_t max_bound_values = 1024;
/// The largest exact decimal literal. A larger one is not exact in binary floating point after multiplication by the
/// scale.
constexpr std::int64_t max_exact = std::int64_t{1} << 52;

/// Returns whether the operator works on numbers; these operators are also defined for vectors.
bool is_arithmetic(ExprKind kind) {
    return kind == ExprKind::plus || kind == ExprKind::minus || kind == ExprKind::times || kind == ExprKind::divide ||
           kind == ExprKind::modulus || kind == ExprKind::negate;
}

/// Returns whether the operator is defined for vectors and matrices.
bool of_blocks(ExprKind kind) {
    return kind == ExprKind::plus || kind == ExprKind::minus || kind == ExprKind::times || kind == ExprKind::negate;
}

bool has_at_most(const ir::System& system, const ir::Instantiation& inst, ir::TypeId type, std::size_t most) {
    try {
        (void)ir::carrier_values(system, inst, type, most);
    } catch (const std::length_error&) {
        return false;
    }
    return true;
}

/// Returns whether a set of the type may have more members over the carriers than a set can have.
bool exceeds_largest_set(const ir::System& system, const ir::Instantiation& inst, ir::TypeId id) {
    const ir::Type& type = system.type(id);
    if (!(type.kind == ir::TypeKind::set || has_pairs(type)) || !is_supported(system, id)) return false;
    return set_capacity(system, inst, type) > largest_set;
}

class Support {
public:
    Support(const ir::System& system, const ir::Instantiation& inst, const Component& component,
            Diagnostics& diagnostics)
        : system_(system), inst_(inst), component_(component), diagnostics_(diagnostics) {}

    bool check_all() {
        const std::size_t before = diagnostics_.error_count();
        for (const Unit& unit : component_.units)
            has_during_ = has_during_ || std::ranges::any_of(unit.machine->nodes, [](const ir::Node& node) {
                              return node.during != nullptr;
                          });
        check_boundary();
        for (const Unit& unit : component_.units) check_unit(unit);
        return diagnostics_.error_count() == before;
    }

private:
    void check_boundary() {
        for (const EventPort& event : component_.events)
            if (event.type) check_type(*event.type, component_.name + "::" + event.model_name, component_.origin.span);
        for (const StoredVariable& entry : component_.variables)
            check_type(entry.variable->type, entry.variable->origin.element, entry.variable->origin.span);
        for (const PlatformCall& call : component_.calls) check_call(*call.signature);
        for (const FunctionHook& hook : component_.functions) check_function(hook);
        check_preconditions();
        check_carriers();
    }

    void check_call(const ir::OperationSignature& signature) {
        for (const ir::TypeId type : signature.parameters)
            check_type(type, signature.origin.element, signature.origin.span);
        if (signature.parameters.size() > max_arguments)
            diagnostics_.report(rules::too_large, signature.origin.span,
                                {signature.name, "an operation has at most 8 parameters"});
    }

    void check_type(ir::TypeId id, const std::string& element, Span span) {
        const ir::Type& type = system_.type(id);
        if (!is_supported(system_, id)) diagnostics_.report(rules::unsupported_type, span, {element, type.name});
    }

    /// Checks the sets that code for the expression builds.
    void check_sizes(const std::string& where, const ir::Expr& root) {
        visit_values(system_, root, [&](const ir::Expr& expr) { check_size(where, expr.type, expr.span); });
    }

    /// Checks that a set has a place for every possible element. Sets of unbounded types need not have so many places,
    /// because generated code detects their overflow (StepResult::capacity).
    void check_size(const std::string& where, ir::TypeId id, Span span) {
        if (exceeds_largest_set(system_, inst_, id) && !has_lists(system_, id))
            diagnostics_.report(rules::too_large, span,
                                {where, "a " + system_.type(id).name + " may have more than 1024 members"});
    }

    /// Checks carriers, because bound variables range over all values of their types.
    void check_carriers() {
        for (const CarrierUse& use : component_.carriers) {
            check_type(use.type, component_.name, component_.origin.span);
            check_values(use.type, system_.type(use.type).name, "a bound variable has at most 1024 values",
                         max_bound_values);
        }
    }

    void check_values(ir::TypeId id, const std::string& name, const char* limit, std::size_t most) {
        if (is_supported(system_, id) && !has_at_most(system_, inst_, id, most))
            diagnostics_.report(rules::too_large, component_.origin.span, {name, limit});
    }

    void check_function(const FunctionHook& hook) {
        const ir::Function& function = system_.functions[hook.id.index];
        for (const ir::TypeId type : function.parameters) check_type(type, function.name, {});
        check_type(function.result, function.name, {});
    }

    /// Checks the preconditions that generated code has to test. Testing a precondition must not require testing the
    /// same precondition.
    void check_preconditions() {
        for (const FunctionHook& hook : component_.functions) {
            if (!hook.guarded) continue;
            const ir::Function& function = system_.functions[hook.id.index];
            for (const ir::ExprPtr& condition : function.preconditions) check_condition(function.name, condition);
            if (asks_for_itself(hook.id))
                diagnostics_.report(rules::unsupported_expr, function.origin.span,
                                    {"a precondition that uses itself", function.name});
        }
    }

    void check_condition(const std::string& function, const ir::ExprPtr& condition) {
        visit(condition, [&](const ir::Expr& expr) { check_expression(function, expr); });
        if (condition) check_sizes(function, *condition);
    }

    [[nodiscard]] bool asks_for_itself(ir::FunctionId function) const {
        std::vector<ir::FunctionId> reached = {function};
        for (std::size_t i = 0; i < reached.size(); ++i) {
            bool back = false;
            for (const ir::ExprPtr& condition : system_.functions[reached[i].index].preconditions)
                visit(condition, [&](const ir::Expr& expr) {
                    if (!ir::precondition_can_fail(system_, inst_, {}, expr) || !expr.function.is_valid()) return;
                    back = back || expr.function == function;
                    if (std::ranges::find(reached, expr.function) == reached.end()) reached.push_back(expr.function);
                });
            if (back) return true;
        }
        return false;
    }

    void check_unit(const Unit& unit) {
        const ir::Machine& machine = *unit.machine;
        for (const auto& node : machine.nodes) check_node(machine, node);
        for (const auto& transition : machine.transitions) check_transition(machine, transition);
        visit_statements(machine, [&](const ir::Stmt& stmt) { check_output(machine, stmt); });
        visit_expressions(machine, [&](const ir::Expr& expr) { check_expression(machine.name, expr); });
        ir::visit_running(machine, [&](const ir::Expr& root, ir::ExprRole) { check_sizes(machine.name, root); });
        for (const auto& variable : machine.variables)
            if (!unit.root) check_type(variable.type, variable.origin.element, variable.origin.span);
    }

    void check_node(const ir::Machine& machine, const ir::Node& node) {
        if (node.is_composite() && !node.initial.is_valid())
            diagnostics_.report(rules::unsupported_node, node.origin.span,
                                {"a composite state without an initial node", machine.name + "::" + node.path});
    }

    void check_transition(const ir::Machine& machine, const ir::Transition& transition) {
        const ir::Node& source = machine.nodes[transition.source.index];
        const std::string& name = transition.origin.element;
        const Span span = transition.origin.span;
        if (source.parent != machine.nodes[transition.target.index].parent)
            diagnostics_.report(rules::crossing, span, {name});
        if (transition.deadline && ir::preconditions_can_fail(system_, inst_, {}, *transition.deadline))
            diagnostics_.report(rules::unsupported_expr, span, {"a deadline by a function with a precondition", name});
        check_cycle(machine, transition);
        if (!transition.trigger) return;
        const bool settled = source.kind == NodeKind::state;
        if (!settled) diagnostics_.report(rules::unsupported_trigger, span, {name, "its source is not a state"});
        const ir::CommKind kind = transition.trigger->kind;
        if (kind == ir::CommKind::output || kind == ir::CommKind::sync)
            diagnostics_.report(rules::unsupported_trigger, span, {name, "it does not only receive"});
    }

    /// For RoboSim: rejects uses of `exec` that the generated code for the end of a cycle does not support.
    void check_cycle(const ir::Machine& machine, const ir::Transition& transition) {
        const auto refuse = [&](const char* what) {
            diagnostics_.report(rules::unsupported_expr, transition.origin.span, {what, transition.origin.element});
        };
        if (transition.exec && machine.nodes[transition.source.index].kind != NodeKind::state)
            refuse("`exec` of a transition that leaves no state");
        if (transition.exec && !transition.stores.empty() && has_during_)
            refuse("a stored value of an `exec` transition in a machine with during actions");
        for (const ir::StmtPtr& store : transition.stores)
            if (machine.variables[store->variable.index].output)
                refuse("a value of a register that is stored in an output");
    }

    /// For RoboSim: checks an output. Generated code computes the values of an output before the output may have to
    /// wait. In the meantime, a parallel during action could change the variables that these values depend on.
    void check_output(const ir::Machine& machine, const ir::Stmt& stmt) {
        if (!component_.robosim || !has_during_) return;
        const bool call = stmt.kind == ir::StmtKind::call && machine.operations[stmt.operation.index].output;
        const bool assigns = stmt.kind == ir::StmtKind::assign && machine.variables[stmt.variable.index].output;
        if (stmt.kind != ir::StmtKind::communicate && !call && !assigns) return;
        std::vector<ir::ExprPtr> values = stmt.args;
        values.insert(values.end(), {stmt.value, stmt.communication.value});
        const auto is_variable = [](const ir::Expr& expr) { return expr.kind == ExprKind::variable; };
        bool computed = false;
        for (const ir::ExprPtr& value : values)
            visit(value, [&](const ir::Expr& expr) { computed = computed || is_variable(expr); });
        if (computed)
            diagnostics_.report(
                rules::unsupported_expr, stmt.origin.span,
                {"an output with the value of a variable in a machine with during actions", machine.name});
    }

    void check_expression(const std::string& where, const ir::Expr& expr) {
        if (!is_supported(system_, expr.type))
            diagnostics_.report(rules::unsupported_type, expr.span, {where, system_.type(expr.type).name});
        const ir::Type& type = system_.type(expr.type);
        if (is_arithmetic(expr.kind) && !is_numeric(type.kind) && !(is_block_type(type) && of_blocks(expr.kind)))
            diagnostics_.report(rules::unsupported_expr, expr.span,
                                {"arithmetic on values that are not numbers", where});
        if (expr.kind == ExprKind::is_type && !is_numeric(system_.type(expr.bound_types.at(0)).kind))
            diagnostics_.report(rules::unsupported_expr, expr.span, {"`is` with a type other than numbers", where});
        if (expr.kind == ExprKind::real && (expr.decimal.unscaled > max_exact || expr.decimal.unscaled < -max_exact))
            diagnostics_.report(rules::too_large, expr.span, {where, "a decimal has more than 15 digits"});
    }

    const ir::System& system_;
    const ir::Instantiation& inst_;
    const Component& component_;
    Diagnostics& diagnostics_;
    bool has_during_ = false;  ///< RoboSim: true if actions may run in parallel
};

/// Returns the number of numbers and literals in a value.
std::size_t count_leaves(const ir::Value& value) {
    if (value.parts.empty()) return 1;
    std::size_t count = 0;
    for (const ir::Value& part : value.parts) count += count_leaves(part);
    return count;
}

/// Returns whether the listed values of a type contain too many numbers and literals. Precondition: the number of these
/// values is within its own limit.
bool lists_too_much(const ir::System& system, const ir::Instantiation& inst, ir::TypeId type) {
    if (!is_composed(system.type(type))) return false;
    std::size_t count = 0;
    for (const ir::Value& value : ir::carrier_values(system, inst, type)) count += count_leaves(value);
    return count > max_listed;
}

/// Returns the option that bounds the values of a type, "--range real=LOW..HIGH", or "" if no range does.
std::string range_option(const ir::System& system, ir::TypeId id) {
    const ir::Type& type = system.type(id);
    if (is_numeric(type.kind)) return "--range " + type.name + "=LOW..HIGH";
    std::string found;
    const auto look = [&](ir::TypeId part) {
        if (found.empty()) found = range_option(system, part);
    };
    std::ranges::for_each(type.args, look);
    for (const auto& arguments : type.literal_args) std::ranges::for_each(arguments, look);
    if (type.kind != ir::TypeKind::sequence) return found;
    return "--range Seq=0..N" + (found.empty() ? "" : " or " + found);
}

/// Returns " (fewer with --range real=LOW..HIGH)", or "" if no range bounds the values of the type.
std::string remedy_text(const ir::System& system, ir::TypeId type) {
    const std::string option = is_supported(system, type) ? range_option(system, type) : "";
    return option.empty() ? "" : " (fewer with " + option + ")";
}

/// Describes a limit of the exploration interface, with the carrier that exceeds it.
std::string limit_text(const ir::System& system, ir::TypeId type, const std::string& limit) {
    return "`conform` lists the values of " + system.type(type).name + ", and " + limit + remedy_text(system, type);
}

/// Adds the sets of unbounded types that the code builds and that do not fit over the carriers.
void add_large_sets(const ir::System& system, const ir::Instantiation& inst, const Component& component,
                    std::vector<BeyondExploration>& result) {
    std::set<ir::TypeId> seen;
    const auto look = [&](const std::string& name, const ir::Expr& expr) {
        if (!seen.insert(expr.type).second || !exceeds_largest_set(system, inst, expr.type)) return;
        if (!has_lists(system, expr.type)) return;  // check_support rejects it
        result.push_back({name, "over the carriers of `conform`, a " + system.type(expr.type).name +
                                    " may have more than 1024 members" + remedy_text(system, expr.type)});
    };
    for (const Unit& unit : component.units)
        ir::visit_running(*unit.machine, [&](const ir::Expr& root, ir::ExprRole) {
            visit_values(system, root, [&](const ir::Expr& expr) { look(unit.machine->name, expr); });
        });
}

}  // namespace

std::vector<BeyondExploration> beyond_exploration(const ir::System& system, const ir::Instantiation& inst,
                                                  const Component& component) {
    std::vector<BeyondExploration> result;
    const auto look = [&](ir::TypeId type, const std::string& name, std::size_t most, const char* limit) {
        if (!has_at_most(system, inst, type, most))
            result.push_back({name, limit_text(system, type, limit)});
        else if (lists_too_much(system, inst, type))
            result.push_back(
                {name, limit_text(system, type,
                                  "all values of an input or output have at most 524288 numbers and literals")});
    };
    for (const Register& input : exploration_registers(component))
        if (input.type) look(*input.type, input.name, max_input_values, "an input has at most 4096 values");
    for (const Output& output : exploration_outputs(component))
        for (const ir::TypeId type : output.types)
            look(type, output.name, max_output_values, "an output has at most 65536 values");
    add_large_sets(system, inst, component, result);
    for (const FunctionHook& hook : component.functions) {
        try {
            (void)values_of(system, inst, hook.id);
        } catch (const std::length_error& error) {
            result.push_back({system.functions[hook.id.index].name, error.what()});
        }
    }
    return result;
}

bool check_support(const ir::System& system, const ir::Instantiation& inst, const Component& component,
                   Diagnostics& diagnostics) {
    return Support(system, inst, component, diagnostics).check_all();
}

}  // namespace robochart::cpp_emit
