// SPDX-License-Identifier: Apache-2.0
// Syntactic data independence. The component only passes on a kind of numbers if no operator has an operand of this
// kind that depends on a variable (Roscoe UCS 17.2, "data independence", without tests for equality). Unknown uses
// count as dependence.
#include "conformance/model/data_independence.hpp"

#include <algorithm>

namespace robochart::conformance {

namespace {

class Look {
public:
    explicit Look(const ir::System& system) : system_(system) {}

    void machine(const ir::Machine& machine) {
        machine_ = &machine;
        for (const ir::ExprPtr& condition : machine.preconditions) used(condition);
        for (const ir::ExprPtr& condition : machine.postconditions) used(condition);
        for (const ir::Variable& variable : machine.variables) stored(variable.initial, variable.type);
        for (const ir::Node& node : machine.nodes)
            for (const ir::StmtPtr& action : {node.entry, node.during, node.exit}) statement(action);
        for (const ir::Transition& transition : machine.transitions) {
            used(transition.guard);
            used(transition.deadline);
            if (transition.trigger) communication(*transition.trigger);
            statement(transition.action);
        }
    }

    DataIndependence result;

private:
    void tested(ir::TypeId id) {
        if (!id.valid()) return;
        switch (system_.type(id).kind) {
            case ir::TypeKind::nat:
                result.nat = false;
                return;
            case ir::TypeKind::integer:
                result.integer = false;
                return;
            case ir::TypeKind::real:
                result.real = false;
                return;
            case ir::TypeKind::boolean:
            case ir::TypeKind::enumeration:
            case ir::TypeKind::string:
            case ir::TypeKind::given:
            case ir::TypeKind::unit:
                return;
            // a type with parts may contain numbers of any kind
            case ir::TypeKind::sequence:
            case ir::TypeKind::set:
            case ir::TypeKind::product:
            case ir::TypeKind::record:
            case ir::TypeKind::function:
            case ir::TypeKind::relation:
            case ir::TypeKind::vector:
            case ir::TypeKind::matrix:
                looked_into(id);
        }
    }

    void looked_into(ir::TypeId id) {
        result.nat = result.integer = result.real = false;
        result.looked_into.push_back(id);
    }

    /// Marks every value of the type, and of its parts, as used.
    void enumerated(ir::TypeId id) {
        tested(id);
        const ir::Type& type = system_.type(id);
        for (const ir::TypeId part : type.args) enumerated(part);
        for (const auto& arguments : type.literal_args)
            for (const ir::TypeId part : arguments) enumerated(part);
    }

    /// Storing a value as another type is a conversion.
    void stored(const ir::ExprPtr& value, ir::TypeId place) {
        passed(value);
        if (!value || constant(*value) || !value->type.valid() || !place.valid()) return;
        if (same_type(system_, value->type, place)) return;
        tested(value->type);
        tested(place);
    }

    static bool leaf(ir::ExprKind kind) {
        return kind == ir::ExprKind::variable || kind == ir::ExprKind::trigger_value;
    }

    /// Whether the expression depends on no variable. Recursion depth: the depth of the model's expressions, which the
    /// reader limits.
    static bool constant(const ir::Expr& expr) {
        constexpr ir::ExprKind alone[] = {ir::ExprKind::boolean, ir::ExprKind::integer, ir::ExprKind::real,
                                          ir::ExprKind::string, ir::ExprKind::constant};
        if (expr.kind == ir::ExprKind::negate) return constant(*expr.args.front());
        return std::find(std::begin(alone), std::end(alone), expr.kind) != std::end(alone);
    }

    /// Marks a value that is passed on unchanged. If the value is a part of another value, or is built from other
    /// values, examines those.
    void passed(const ir::ExprPtr& expr) {
        if (!expr || leaf(expr->kind) || constant(*expr)) return;
        const ir::ExprKind kind = expr->kind;
        if (kind == ir::ExprKind::record || kind == ir::ExprKind::tuple) return made(*expr);
        if (kind == ir::ExprKind::member) {
            tested(expr->args[0]->type);
            return passed(expr->args[0]);
        }
        if (kind != ir::ExprKind::if_then_else) return used(expr);
        used(expr->args[0]);
        passed(expr->args[1]);
        passed(expr->args[2]);
    }

    void made(const ir::Expr& whole) {
        tested(whole.type);
        const std::vector<ir::TypeId>& parts = system_.type(whole.type).args;
        for (std::size_t i = 0; i < whole.args.size(); ++i)
            stored(whole.args[i], i < parts.size() ? parts[i] : ir::TypeId{});
    }

    /// Marks a value that affects the behaviour.
    void used(const ir::ExprPtr& expr) {
        if (!expr || constant(*expr)) return;
        const bool clock = expr->kind == ir::ExprKind::since || expr->kind == ir::ExprKind::since_entry;
        if (!clock) tested(expr->type);
        for (const ir::TypeId type : expr->bound_types) enumerated(type);
        for (const ir::ExprPtr& part : expr->args) used(part);
    }

    void communication(const ir::Communication& communication) {
        used(communication.predicate);
        if (!communication.event.valid()) return;
        const ir::Event& event = machine_->events[communication.event.index];
        if (communication.value && event.type) stored(communication.value, *event.type);
        if (!communication.variable.valid() || !event.type) return;
        const ir::TypeId variable = machine_->variables[communication.variable.index].type;
        if (same_type(system_, variable, *event.type)) return;
        tested(variable);
        tested(*event.type);
    }

    void statement(const ir::StmtPtr& stmt) {
        if (!stmt) return;
        used(stmt->condition);
        used(stmt->upper);
        for (const ir::ExprPtr& step : stmt->path) used(step);
        if (!stmt->path.empty()) enumerated(machine_->variables[stmt->variable.index].type);
        if (stmt->kind == ir::StmtKind::assign)
            stored(stmt->value, machine_->variables[stmt->variable.index].type);
        else
            used(stmt->value);  // of a wait or a deadline
        const ir::OperationSignature* const call =
            stmt->operation.valid() ? &machine_->operations[stmt->operation.index] : nullptr;
        for (std::size_t i = 0; i < stmt->args.size(); ++i)
            stored(stmt->args[i], call != nullptr && i < call->parameters.size() ? call->parameters[i] : ir::TypeId{});
        communication(stmt->communication);
        for (const ir::StmtPtr& part : stmt->body) statement(part);
    }

    const ir::System& system_;
    const ir::Machine* machine_ = nullptr;
};

}  // namespace

bool same_type(const ir::System& system, ir::TypeId a, ir::TypeId b) {
    const ir::Type& x = system.type(a);
    const ir::Type& y = system.type(b);
    if (x.kind != y.kind || x.sizes != y.sizes) return false;
    const bool by_name =
        x.kind == ir::TypeKind::record || x.kind == ir::TypeKind::enumeration || x.kind == ir::TypeKind::given;
    if (by_name) return x.name == y.name && x.package == y.package;
    bool all = x.args.size() == y.args.size();
    for (std::size_t i = 0; all && i < x.args.size(); ++i) all = same_type(system, x.args[i], y.args[i]);
    return all;
}

bool DataIndependence::of(const ir::System& system, ir::TypeId id) const {
    switch (system.type(id).kind) {
        case ir::TypeKind::boolean:
        case ir::TypeKind::nat:
        case ir::TypeKind::integer:
        case ir::TypeKind::real:
        case ir::TypeKind::enumeration:
        case ir::TypeKind::string:
        case ir::TypeKind::given:
        case ir::TypeKind::unit:
            return false;
        case ir::TypeKind::sequence:
        case ir::TypeKind::set:
        case ir::TypeKind::function:
        case ir::TypeKind::relation:
        case ir::TypeKind::product:
        case ir::TypeKind::record:
        case ir::TypeKind::vector:
        case ir::TypeKind::matrix:
            return std::ranges::none_of(looked_into, [&](ir::TypeId other) { return same_type(system, id, other); });
    }
    return false;
}

bool DataIndependence::of(ir::TypeKind kind) const {
    return (kind == ir::TypeKind::nat && nat) || (kind == ir::TypeKind::integer && integer) ||
           (kind == ir::TypeKind::real && real);
}

DataIndependence data_independence(const ir::System& system, const std::vector<ir::MachineId>& machines) {
    Look look(system);
    for (const ir::MachineId id : machines) look.machine(system.machine(id));
    return look.result;
}

}  // namespace robochart::conformance
