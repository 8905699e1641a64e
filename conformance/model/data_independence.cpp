// SPDX-License-Identifier: Apache-2.0
// Decides data independence syntactically. The component only passes on a kind of numbers if no operator has an operand
// of this kind that depends on a variable (Roscoe UCS 17.2, "data independence", without tests for equality). Unknown
// uses are treated as dependence.
#include "conformance/model/data_independence.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "semantics/ir/visit.hpp"

namespace robochart::conformance {

namespace {

bool is_leaf(ir::ExprKind kind) {
    return kind == ir::ExprKind::variable || kind == ir::ExprKind::trigger_value;
}

/// Returns whether the expression depends on no variable. Recursion depth: the depth of the model's expressions, which
/// the reader limits.
bool is_constant(const ir::Expr& expr) {
    constexpr ir::ExprKind alone[] = {ir::ExprKind::boolean, ir::ExprKind::integer, ir::ExprKind::real,
                                      ir::ExprKind::string, ir::ExprKind::constant};
    if (expr.kind == ir::ExprKind::negate) return is_constant(*expr.args.front());
    return std::find(std::begin(alone), std::end(alone), expr.kind) != std::end(alone);
}

bool is_number(const ir::System& system, const ir::Expr& expr) {
    if (!expr.type.is_valid()) return false;
    const ir::TypeKind kind = system.type(expr.type).kind;
    return kind == ir::TypeKind::nat || kind == ir::TypeKind::integer || kind == ir::TypeKind::real;
}

/// Removes conversions that preserve the order of numbers. These are all conversions except from reals to whole
/// numbers.
const ir::Expr& without_conversions(const ir::System& system, const ir::Expr& expr) {
    if (expr.kind != ir::ExprKind::cast || !is_number(system, expr) || !is_number(system, *expr.args[0])) return expr;
    const bool rounds =
        system.type(expr.args[0]->type).kind == ir::TypeKind::real && system.type(expr.type).kind != ir::TypeKind::real;
    return rounds ? expr : without_conversions(system, *expr.args[0]);
}

/// Returns whether the expression is a variable or a field of one.
bool is_held(const ir::Expr& expr) {
    return is_leaf(expr.kind) || (expr.kind == ir::ExprKind::member && is_held(*expr.args[0]));
}

/// The operands of a comparison of a variable's number with a literal or constant. The answer depends only on the side
/// of the constant on which the number is.
struct ComparedOperands {
    const ir::Expr* held = nullptr;
    const ir::Expr* constant = nullptr;
};
std::optional<ComparedOperands> compared_operands(const ir::System& system, const ir::Expr& expr) {
    if (!ir::is_comparison(expr.kind) || expr.args.size() != 2) return std::nullopt;
    if (!is_number(system, *expr.args[0]) || !is_number(system, *expr.args[1])) return std::nullopt;
    const ir::Expr &left = without_conversions(system, *expr.args[0]),
                   &right = without_conversions(system, *expr.args[1]);
    if (is_held(left) && is_constant(right)) return ComparedOperands{&left, &right};
    if (is_constant(left) && is_held(right)) return ComparedOperands{&right, &left};
    return std::nullopt;
}

/// Reads comparisons of sums.
class SumReader {
public:
    explicit SumReader(const ir::System& system) : system_(system) {}

    std::optional<SumComparison> read_comparison(const ir::Expr& expr) {
        if (!append_sum(*expr.args[0], result_.left) || !append_sum(*expr.args[1], result_.right)) return std::nullopt;
        result_.relation = expr.kind;
        for (const std::vector<Summand>* side : {&result_.left, &result_.right})
            for (const Summand& summand : *side)
                if (summand.held) held_kinds_.insert(kind_of(*summand.expr));
        if (held_kinds_.size() != 1) return std::nullopt;
        result_.kind = *held_kinds_.begin();
        const auto fits = [&](ir::TypeKind kind) { return kind == result_.kind; };
        const bool natural = result_.kind == ir::TypeKind::nat;
        if (!std::ranges::all_of(sum_kinds_, fits) || (subtracts_ && natural)) return std::nullopt;
        if (real_constant_ && result_.kind != ir::TypeKind::real) return std::nullopt;
        return std::move(result_);
    }

private:
    [[nodiscard]] ir::TypeKind kind_of(const ir::Expr& expr) const { return system_.type(expr.type).kind; }

    /// Appends the summands of a sum such as `a + b - c`. Returns false for other expressions. Recursion depth: the
    /// depth of the expression.
    bool append_sum(const ir::Expr& expr, std::vector<Summand>& sum) {
        const ir::Expr& plain = without_conversions(system_, expr);
        if (!is_number(system_, plain)) return false;
        const bool subtracts = plain.kind == ir::ExprKind::minus;
        if (plain.kind != ir::ExprKind::plus && !subtracts) return append_summand(plain, false, sum);
        sum_kinds_.insert(kind_of(plain));
        subtracts_ = subtracts_ || subtracts;
        return append_sum(*plain.args[0], sum) &&
               append_summand(without_conversions(system_, *plain.args[1]), subtracts, sum);
    }

    bool append_summand(const ir::Expr& plain, bool subtracted, std::vector<Summand>& sum) {
        const bool held = is_held(plain);
        if (!is_number(system_, plain) || (!held && !is_constant(plain))) return false;
        real_constant_ = real_constant_ || (!held && kind_of(plain) == ir::TypeKind::real);
        sum.push_back({&plain, held, subtracted});
        return true;
    }

    const ir::System& system_;
    SumComparison result_;
    std::set<ir::TypeKind> held_kinds_, sum_kinds_;
    bool subtracts_ = false;
    bool real_constant_ = false;
};

class Look {
public:
    Look(const ir::System& system, const std::set<const ir::Expr*>& decided) : system_(system), decided_(decided) {}

    void visit_machine(const ir::Machine& machine) {
        machine_ = &machine;
        for (const ir::ExprPtr& condition : machine.preconditions) mark_used(condition);
        for (const ir::ExprPtr& condition : machine.postconditions) mark_used(condition);
        for (const ir::Variable& variable : machine.variables) mark_stored(variable.initial, variable.type);
        for (const ir::Node& node : machine.nodes)
            for (const ir::StmtPtr& action : {node.entry, node.during, node.exit}) visit_statement(action);
        for (const ir::Transition& transition : machine.transitions) {
            mark_used(transition.guard);
            mark_used(transition.deadline);
            if (transition.trigger) visit_communication(*transition.trigger);
            visit_statement(transition.action);
        }
    }

    DataIndependence result;

private:
    void mark_tested(ir::TypeId id) {
        if (!id.is_valid()) return;
        switch (system_.type(id).kind) {
            case ir::TypeKind::nat:
            case ir::TypeKind::integer:
            case ir::TypeKind::real:
                return raise_use(system_.type(id).kind, NumberUse::computed);
            case ir::TypeKind::boolean:
            case ir::TypeKind::enumeration:
            case ir::TypeKind::string:
            case ir::TypeKind::given:
            case ir::TypeKind::unit:
                return;
            // A type with parts may contain numbers of any kind.
            case ir::TypeKind::sequence:
            case ir::TypeKind::set:
            case ir::TypeKind::product:
            case ir::TypeKind::record:
            case ir::TypeKind::function:
            case ir::TypeKind::relation:
            case ir::TypeKind::vector:
            case ir::TypeKind::matrix:
                mark_inspected(id);
        }
    }

    void mark_inspected(ir::TypeId id) {
        if (system_.type(id).kind == ir::TypeKind::sequence) result.inspects_lists = true;
        for (const ir::TypeKind kind : {ir::TypeKind::nat, ir::TypeKind::integer, ir::TypeKind::real})
            raise_use(kind, NumberUse::computed);
        result.looked_into.push_back(id);
    }

    /// Marks a type whose values are taken apart or built from parts, while the parts keep their values.
    void mark_selected(ir::TypeId id) {
        if (!id.is_valid()) return;
        for (const ir::TypeKind kind : {ir::TypeKind::nat, ir::TypeKind::integer, ir::TypeKind::real})
            raise_use(kind, NumberUse::compared);
        result.looked_into.push_back(id);
    }

    void raise_use(ir::TypeKind kind, NumberUse use) {
        NumberUse* known = nullptr;
        if (kind == ir::TypeKind::nat) known = &result.nat;
        if (kind == ir::TypeKind::integer) known = &result.integer;
        if (kind == ir::TypeKind::real) known = &result.real;
        if (known != nullptr) *known = std::max(*known, use);
    }

    /// Marks every value of the type, and of its parts, as used.
    void mark_enumerated(ir::TypeId id) {
        mark_tested(id);
        const ir::Type& type = system_.type(id);
        for (const ir::TypeId part : type.args) mark_enumerated(part);
        for (const auto& arguments : type.literal_args)
            for (const ir::TypeId part : arguments) mark_enumerated(part);
    }

    /// Marks a value that is stored as another type, because this is a conversion.
    void mark_stored(const ir::ExprPtr& value, ir::TypeId place) {
        mark_passed_on(value);
        if (!value || is_constant(*value) || !value->type.is_valid() || !place.is_valid()) return;
        if (same_type(system_, value->type, place)) return;
        mark_tested(value->type);
        mark_tested(place);
    }

    /// Marks a value that is passed on unchanged. If the value is a part of another value, or is built from other
    /// values, examines the other values.
    void mark_passed_on(const ir::ExprPtr& expr) {
        if (!expr || is_leaf(expr->kind) || is_constant(*expr)) return;
        const ir::ExprKind kind = expr->kind;
        if (kind == ir::ExprKind::record || kind == ir::ExprKind::tuple) return mark_constructed(*expr);
        if (kind == ir::ExprKind::sequence || kind == ir::ExprKind::concat) return mark_list(*expr);
        if (kind == ir::ExprKind::member) {
            mark_selected(expr->args[0]->type);
            return mark_passed_on(expr->args[0]);
        }
        if (kind != ir::ExprKind::if_then_else) return mark_used(expr);
        mark_used(expr->args[0]);
        mark_passed_on(expr->args[1]);
        mark_passed_on(expr->args[2]);
    }

    void mark_constructed(const ir::Expr& whole) {
        mark_selected(whole.type);
        const std::vector<ir::TypeId>& parts = system_.type(whole.type).args;
        for (std::size_t i = 0; i < whole.args.size(); ++i)
            mark_stored(whole.args[i], i < parts.size() ? parts[i] : ir::TypeId{});
    }

    /// Marks a list that is built from values or from other lists, and does not depend on them.
    void mark_list(const ir::Expr& list) {
        mark_selected(list.type);
        for (const ir::ExprPtr& part : list.args) {
            if (list.kind == ir::ExprKind::sequence)
                mark_stored(part, system_.type(list.type).args.at(0));
            else
                mark_stored(part, list.type);
        }
    }

    void mark_compared(const ir::Expr& operand, NumberUse use) {
        raise_use(system_.type(operand.type).kind, use);
        for (const ir::Expr* at = &operand; at->kind == ir::ExprKind::member; at = at->args[0].get())
            mark_selected(at->args[0]->type);
    }

    void mark_related(const SumComparison& comparison) {
        for (const std::vector<Summand>* side : {&comparison.left, &comparison.right})
            for (const Summand& summand : *side)
                if (summand.held) mark_compared(*summand.expr, NumberUse::related);
    }

    /// Marks a value that affects the behaviour.
    void mark_used(const ir::ExprPtr& expr) {
        if (!expr || is_constant(*expr) || decided_.contains(expr.get())) return;
        if (const auto operands = compared_operands(system_, *expr))
            return mark_compared(*operands->held, NumberUse::compared);
        if (const auto comparison = sum_comparison(system_, *expr)) return mark_related(*comparison);
        const bool clock = expr->kind == ir::ExprKind::since || expr->kind == ir::ExprKind::since_entry;
        if (!clock) mark_tested(expr->type);
        for (const ir::TypeId type : expr->bound_types) mark_enumerated(type);
        const bool whole = depends_on_parts(expr->kind);
        for (const ir::ExprPtr& part : expr->args) {
            if (whole && part->type.is_valid()) mark_enumerated(part->type);
            mark_used(part);
        }
    }

    /// Returns whether the value of an expression of this kind may depend on all parts of its operands. For example, `p
    /// == q` compares the fields of p and q. The other kinds only select, build or store values.
    static bool depends_on_parts(ir::ExprKind kind) {
        switch (kind) {
            case ir::ExprKind::boolean:
            case ir::ExprKind::integer:
            case ir::ExprKind::real:
            case ir::ExprKind::string:
            case ir::ExprKind::enum_literal:
            case ir::ExprKind::variable:
            case ir::ExprKind::trigger_value:
            case ir::ExprKind::constant:
            case ir::ExprKind::since:
            case ir::ExprKind::since_entry:
            case ir::ExprKind::bound:
            case ir::ExprKind::function_value:
            case ir::ExprKind::if_then_else:
            case ir::ExprKind::tuple:
            case ir::ExprKind::record:
            case ir::ExprKind::sequence:
            case ir::ExprKind::matrix:
            case ir::ExprKind::member:
            case ir::ExprKind::index:
            case ir::ExprKind::concat:
            case ir::ExprKind::transpose:
                return false;
            case ir::ExprKind::negate:
            case ir::ExprKind::logical_not:
            case ir::ExprKind::iff:
            case ir::ExprKind::implies:
            case ir::ExprKind::disjunction:
            case ir::ExprKind::conjunction:
            case ir::ExprKind::equal:
            case ir::ExprKind::not_equal:
            case ir::ExprKind::greater:
            case ir::ExprKind::greater_equal:
            case ir::ExprKind::less:
            case ir::ExprKind::less_equal:
            case ir::ExprKind::plus:
            case ir::ExprKind::minus:
            case ir::ExprKind::times:
            case ir::ExprKind::divide:
            case ir::ExprKind::modulus:
            case ir::ExprKind::call:
            case ir::ExprKind::apply:
            case ir::ExprKind::set:
            case ir::ExprKind::is_in:
            case ir::ExprKind::set_range:
            case ir::ExprKind::cast:
            case ir::ExprKind::forall:
            case ir::ExprKind::exists:
            case ir::ExprKind::exists_unique:
            case ir::ExprKind::lambda:
            case ir::ExprKind::the:
            case ir::ExprKind::set_comprehension:
            case ir::ExprKind::let:
            case ir::ExprKind::toolkit:
            case ir::ExprKind::is_type:
            case ir::ExprKind::range:
                return true;
        }
        return true;
    }

    void visit_communication(const ir::Communication& communication) {
        mark_used(communication.predicate);
        if (!communication.event.is_valid()) return;
        const ir::Event& event = machine_->events[communication.event.index];
        if (communication.value && event.type) mark_stored(communication.value, *event.type);
        if (!communication.variable.is_valid() || !event.type) return;
        const ir::TypeId variable = machine_->variables[communication.variable.index].type;
        if (same_type(system_, variable, *event.type)) return;
        mark_tested(variable);
        mark_tested(*event.type);
    }

    void visit_statement(const ir::StmtPtr& stmt) {
        if (!stmt) return;
        mark_used(stmt->condition);
        mark_used(stmt->upper);
        for (const ir::ExprPtr& step : stmt->path) mark_used(step);
        if (!stmt->path.empty()) mark_enumerated(machine_->variables[stmt->variable.index].type);
        if (stmt->kind == ir::StmtKind::assign)
            mark_stored(stmt->value, machine_->variables[stmt->variable.index].type);
        else
            mark_used(stmt->value);  // the duration of a wait or a deadline
        const ir::OperationSignature* const call =
            stmt->operation.is_valid() ? &machine_->operations[stmt->operation.index] : nullptr;
        for (std::size_t i = 0; i < stmt->args.size(); ++i)
            mark_stored(stmt->args[i],
                        call != nullptr && i < call->parameters.size() ? call->parameters[i] : ir::TypeId{});
        visit_communication(stmt->communication);
        for (const ir::StmtPtr& part : stmt->body) visit_statement(part);
    }

    const ir::System& system_;
    const std::set<const ir::Expr*>& decided_;
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

bool DataIndependence::is_independent(const ir::System& system, ir::TypeId id) const {
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

std::optional<ConstantComparison> constant_comparison(const ir::System& system, const ir::Expr& expr) {
    const auto operands = compared_operands(system, expr);
    if (!operands) return std::nullopt;
    return ConstantComparison{system.type(operands->held->type).kind, operands->constant,
                              expr.kind != ir::ExprKind::equal && expr.kind != ir::ExprKind::not_equal};
}

std::optional<SumComparison> sum_comparison(const ir::System& system, const ir::Expr& expr) {
    if (!ir::is_comparison(expr.kind) || expr.args.size() != 2 || compared_operands(system, expr)) return std::nullopt;
    return SumReader(system).read_comparison(expr);
}

NumberUse DataIndependence::use_of(ir::TypeKind kind) const {
    if (kind == ir::TypeKind::nat) return nat;
    if (kind == ir::TypeKind::integer) return integer;
    return kind == ir::TypeKind::real ? real : NumberUse::computed;
}

DataIndependence data_independence(const ir::System& system, const std::vector<ir::MachineId>& machines,
                                   const std::set<const ir::Expr*>& decided) {
    Look look(system, decided);
    for (const ir::MachineId id : machines) look.visit_machine(system.machine(id));
    return look.result;
}

}  // namespace robochart::conformance
