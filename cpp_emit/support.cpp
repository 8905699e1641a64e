#include "cpp_emit/support.hpp"

#include "cpp_emit/rules.hpp"
#include "cpp_emit/types.hpp"
#include "cpp_emit/walk.hpp"

namespace robochart::cpp_emit {

namespace {

using diagnostics::Diagnostics;
using diagnostics::Span;
using ir::ExprKind;
using ir::NodeKind;
using ir::StmtKind;

/// Arguments that one record of the exploration interface holds (runtime/explore_abi.h).
constexpr std::size_t max_arguments = 8;
/// Values of one input that the exploration interface lists.
constexpr std::size_t max_values = 4096;
/// Beyond this a decimal literal is not exact in binary floating point times the scale.
constexpr std::int64_t max_exact = std::int64_t{1} << 52;

const char* refused_expression(ExprKind kind) {
    switch (kind) {
        case ExprKind::string:
            return "a string";
        case ExprKind::call:
            return "a function's call (functions are specified by contract only)";
        case ExprKind::tuple:
            return "a tuple";
        case ExprKind::record:
            return "a record";
        case ExprKind::sequence:
            return "a sequence";
        case ExprKind::set:
            return "a set";
        case ExprKind::member:
            return "a member";
        case ExprKind::index:
            return "an index";
        case ExprKind::concat:
            return "a concatenation";
        case ExprKind::is_in:
            return "`in`";
        case ExprKind::set_range:
            return "a range";
        case ExprKind::cast:
            return "a cast";
        case ExprKind::bound:
            return "a bound name";
        case ExprKind::forall:
            return "`forall`";
        case ExprKind::exists:
            return "`exists`";
        case ExprKind::exists_unique:
            return "`exists1`";
        case ExprKind::lambda:
            return "`lambda`";
        case ExprKind::the:
            return "`the`";
        case ExprKind::let:
            return "`let`";
        case ExprKind::set_comprehension:
            return "a set comprehension";
        default:
            return nullptr;
    }
}

class Support {
public:
    Support(const ir::System& system, const ir::Instantiation& inst, const Component& component,
            Diagnostics& diagnostics)
        : system_(system), inst_(inst), component_(component), diagnostics_(diagnostics) {}

    bool check() {
        const std::size_t before = diagnostics_.errors();
        check_boundary();
        for (const Unit& unit : component_.units) check_unit(unit);
        return diagnostics_.errors() == before;
    }

private:
    void check_boundary() {
        for (const EventPort& event : component_.events) {
            if (event.type) check_type(*event.type, component_.name + "::" + event.model_name, component_.origin.span);
            if (event.type && event.received) check_input(*event.type, event.model_name);
        }
        for (const StoredVariable& entry : component_.variables) {
            check_type(entry.variable->type, entry.variable->origin.element, entry.variable->origin.span);
            if (!entry.input.empty()) check_input(entry.variable->type, entry.variable->name);
        }
        for (const PlatformCall& call : component_.calls) check_call(*call.signature);
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
        if (!supported(type)) diagnostics_.report(rules::unsupported_type, span, {element, type.name});
    }

    void check_input(ir::TypeId id, const std::string& name) {
        const ir::Type& type = system_.type(id);
        if (!supported(type)) return;
        const std::size_t values = numeric(type.kind) ? number_values(type.kind) : 1;
        if (values > max_values)
            diagnostics_.report(rules::too_large, component_.origin.span, {name, "an input has at most 4096 values"});
    }

    std::size_t number_values(ir::TypeKind kind) const {
        if (kind == ir::TypeKind::real) return inst_.real.size();
        return kind == ir::TypeKind::nat ? inst_.nat.size() : inst_.integer.size();
    }

    void check_unit(const Unit& unit) {
        const ir::Machine& machine = *unit.machine;
        for (const auto& node : machine.nodes) check_node(machine, node);
        for (const auto& transition : machine.transitions) check_transition(machine, transition);
        visit_statements(machine, [&](const ir::Stmt& stmt) { check_statement(machine, stmt); });
        visit_expressions(machine, [&](const ir::Expr& expr) { check_expression(machine, expr); });
        for (const auto& variable : machine.variables)
            if (!unit.root) check_type(variable.type, variable.origin.element, variable.origin.span);
    }

    void check_node(const ir::Machine& machine, const ir::Node& node) {
        if (node.kind == NodeKind::probabilistic)
            diagnostics_.report(rules::unsupported_node, node.origin.span,
                                {"the probabilistic junction", machine.name + "::" + node.path});
        if (node.composite() && !node.initial.valid())
            diagnostics_.report(rules::unsupported_node, node.origin.span,
                                {"a composite state without an initial node", machine.name + "::" + node.path});
    }

    void check_transition(const ir::Machine& machine, const ir::Transition& transition) {
        const ir::Node& source = machine.nodes[transition.source.index];
        const std::string& name = transition.origin.element;
        const Span span = transition.origin.span;
        if (source.parent != machine.nodes[transition.target.index].parent)
            diagnostics_.report(rules::crossing, span, {name});
        if (transition.deadline) diagnostics_.report(rules::deadline, span, {name});
        if (!transition.trigger) return;
        const bool settled = source.kind == NodeKind::state;
        if (!settled) diagnostics_.report(rules::unsupported_trigger, span, {name, "its source is not a state"});
        const ir::CommKind kind = transition.trigger->kind;
        if (kind == ir::CommKind::output || kind == ir::CommKind::sync)
            diagnostics_.report(rules::unsupported_trigger, span, {name, "it does not only receive"});
    }

    void check_statement(const ir::Machine& machine, const ir::Stmt& stmt) {
        if (stmt.kind == StmtKind::deadline)
            diagnostics_.report(rules::deadline, stmt.origin.span, {stmt.origin.element});
        if (stmt.kind == StmtKind::assign && !stmt.path.empty())
            diagnostics_.report(rules::unsupported_stmt, stmt.origin.span,
                                {"an assignment to a part of a variable", machine.name});
    }

    void check_expression(const ir::Machine& machine, const ir::Expr& expr) {
        if (const char* what = refused_expression(expr.kind)) {
            diagnostics_.report(rules::unsupported_expr, expr.span, {what, machine.name});
            return;
        }
        if (!supported(system_.type(expr.type)))
            diagnostics_.report(rules::unsupported_type, expr.span, {machine.name, system_.type(expr.type).name});
        if (expr.kind == ExprKind::real && (expr.decimal.unscaled > max_exact || expr.decimal.unscaled < -max_exact))
            diagnostics_.report(rules::too_large, expr.span, {machine.name, "a decimal has more than 15 digits"});
    }

    const ir::System& system_;
    const ir::Instantiation& inst_;
    const Component& component_;
    Diagnostics& diagnostics_;
};

}  // namespace

bool check_support(const ir::System& system, const ir::Instantiation& inst, const Component& component,
                   Diagnostics& diagnostics) {
    return Support(system, inst, component, diagnostics).check();
}

}  // namespace robochart::cpp_emit
