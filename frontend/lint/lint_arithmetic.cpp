// SPDX-License-Identifier: Apache-2.0
// Reports divisors that can be 0, and differences that are cast to nat although they can be negative. The analysis uses
// the guard of the transition, the conditions of enclosing `if`s and boolean operators, and preconditions. A fact is
// dropped when a variable in it is assigned. RoboTool's arithmetic does not fail in these cases (semantics 3.13): it
// silently continues with another value.
#include <fmt/format.h>

#include "frontend/lint/lint_logic.hpp"
#include "frontend/lint/lints.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/typer.hpp"
#include "frontend/types/types.hpp"

namespace robochart::frontend {

namespace {

class Arithmetic {
public:
    Arithmetic(const Machine& machine, Diagnostics& out) : out_(out) {
        for (const ExprPtr& condition : machine.preconditions) facts_.push_back({condition.get(), true});
    }

    void check_container(const NodeContainer& container) {
        for (const auto& node : container.nodes) {
            for (const Action& action : node->actions)
                if (action.statement) with_saved_facts([&] { check_statement(*action.statement); });
            this->check_container(*node);
        }
        for (const auto& transition : container.transitions)
            with_saved_facts([&] { this->check_transition(*transition); });
    }

private:
    struct Fact {
        const Expr* condition = nullptr;
        bool holds = true;
    };

    template <class Body>
    void with_saved_facts(Body body) {
        const std::vector<Fact> before = facts_;
        body();
        facts_ = before;
    }

    void check_transition(const Transition& transition) {
        if (transition.condition) {
            check_expression(*transition.condition);
            facts_.push_back({transition.condition.get(), true});
        }
        if (transition.action) check_statement(*transition.action);
    }

    void check_statement(const Stmt& statement) {
        for_expressions(statement, [&](const Expr& expr) { check_expression(expr); });
        if (statement.kind == StmtKind::if_then_else && statement.condition) {
            for (std::size_t i = 0; i < statement.body.size(); ++i)
                with_saved_facts([&] {
                    facts_.push_back({statement.condition.get(), i == 0});
                    this->check_statement(*statement.body[i]);
                });
        } else {
            for (const StmtPtr& inner : statement.body) this->check_statement(*inner);
        }
        drop_changed_facts(statement);
    }

    /// Drops the facts about variables that the statement changes.
    void drop_changed_facts(const Stmt& statement) {
        if (facts_.empty()) return;
        Effects effects;
        add_effects(statement, effects);
        std::erase_if(facts_,
                      [&](const Fact& fact) { return effects.calls || mentions_any(*fact.condition, effects.writes); });
    }

    void check_expression(const Expr& expr) {
        const bool guarded =
            expr.kind == ExprKind::binary && (expr.binary == BinaryOp::conjunction ||
                                              expr.binary == BinaryOp::disjunction || expr.binary == BinaryOp::implies);
        if (guarded) {
            check_expression(*expr.args[0]);
            with_saved_facts([&] {
                facts_.push_back({expr.args[0].get(), expr.binary != BinaryOp::disjunction});
                check_expression(*expr.args[1]);
            });
            return;
        }
        if (expr.kind == ExprKind::if_then_else) {
            check_expression(*expr.args[0]);
            for (std::size_t i = 1; i < expr.args.size(); ++i)
                with_saved_facts([&] {
                    facts_.push_back({expr.args[0].get(), i == 1});
                    check_expression(*expr.args[i]);
                });
            return;
        }
        for_children(expr, [&](const Expr& part) { check_expression(part); });
        if (expr.kind == ExprKind::binary && (expr.binary == BinaryOp::divide || expr.binary == BinaryOp::modulus))
            check_division(expr);
        if (expr.kind == ExprKind::cast) check_cast(expr);
    }

    [[nodiscard]] logic::Finding decide_relation(const Expr& expr, logic::Relation relation) const {
        logic::Reasoner reasoner(true);
        std::vector<logic::Formula> all{reasoner.compare_to_zero(expr, relation)};
        for (const Fact& fact : facts_) {
            logic::Formula formula = reasoner.read(*fact.condition);
            all.push_back(fact.holds ? std::move(formula) : logic::negate_formula(std::move(formula)));
        }
        return reasoner.decide(logic::all_of(std::move(all)));
    }

    /// True if the value can vary. Open constants are excluded, because the instantiation chooses their values, and
    /// calls are excluded, because functions are specified elsewhere.
    static bool can_vary(const Expr& expr) {
        bool variable = false;
        bool unknown = false;
        walk_tree(expr, [&](const Expr& part) {
            const auto* named = part.kind == ExprKind::name ? dynamic_cast<const Variable*>(part.target) : nullptr;
            variable = variable || (named != nullptr && named->kind != DeclKind::constant);
            unknown = unknown || part.kind == ExprKind::call;
        });
        return variable && !unknown;
    }

    void check_division(const Expr& expr) {
        const Expr& divisor = strip_parentheses(*expr.args[1]);
        if (divisor.type == nullptr ||
            (divisor.type->form != TypeForm::nat && divisor.type->form != TypeForm::integer &&
             divisor.type->form != TypeForm::real))
            return;
        logic::Reasoner reasoner(true);
        const auto not_zero = logic::negate_formula(reasoner.compare_to_zero(divisor, logic::Relation::equal));
        if (reasoner.decide(not_zero).answer == logic::Answer::impossible) {
            out_.report(rules::w_zero, divisor.span, {to_text(divisor)});
            return;
        }
        if (!can_vary(divisor)) return;
        const logic::Finding zero = decide_relation(divisor, logic::Relation::equal);
        if (zero.answer == logic::Answer::possible) out_.report(rules::w_maybe_zero, divisor.span, {to_text(divisor)});
    }

    void check_cast(const Expr& expr) {
        const Expr& value = strip_parentheses(*expr.args[0]);
        const bool to_nat = expr.type != nullptr && expr.type->form == TypeForm::nat;
        if (!to_nat || value.type == nullptr || value.type->form == TypeForm::nat) return;
        const bool difference =
            value.kind == ExprKind::unary || (value.kind == ExprKind::binary && value.binary == BinaryOp::minus);
        if (!difference) return;
        const logic::Finding negative = decide_relation(value, logic::Relation::less);
        if (negative.answer == logic::Answer::possible && negative.trusted)
            out_.report(rules::w_negative, expr.span, {to_text(value), negative.example});
    }

    std::vector<Fact> facts_;
    Diagnostics& out_;
};

}  // namespace

void lint_arithmetic(const Machine& machine, Diagnostics& out) {
    Arithmetic(machine, out).check_container(machine);
}

}  // namespace robochart::frontend
