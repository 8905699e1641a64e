// SPDX-License-Identifier: Apache-2.0
// Arithmetic that may leave its type: a divisor that can be 0, and a difference cast to nat that can be negative. The
// analysis uses the guard of the transition, the conditions of enclosing `if`s and boolean operators, and
// preconditions. A fact is dropped when a variable in it is assigned. RoboTool's arithmetic does not fail in these
// cases (semantics 3.13): it silently continues with another value.
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

    void container(const NodeContainer& container) {
        for (const auto& node : container.nodes) {
            for (const Action& action : node->actions)
                if (action.statement) separately([&] { statement(*action.statement); });
            this->container(*node);
        }
        for (const auto& transition : container.transitions) separately([&] { this->transition(*transition); });
    }

private:
    struct Fact {
        const Expr* condition = nullptr;
        bool holds = true;
    };

    template <class Body>
    void separately(Body body) {
        const std::vector<Fact> before = facts_;
        body();
        facts_ = before;
    }

    void transition(const Transition& transition) {
        if (transition.condition) {
            expression(*transition.condition);
            facts_.push_back({transition.condition.get(), true});
        }
        if (transition.action) statement(*transition.action);
    }

    void statement(const Stmt& statement) {
        for_expressions(statement, [&](const Expr& expr) { expression(expr); });
        if (statement.kind == StmtKind::if_then_else && statement.condition) {
            for (std::size_t i = 0; i < statement.body.size(); ++i)
                separately([&] {
                    facts_.push_back({statement.condition.get(), i == 0});
                    this->statement(*statement.body[i]);
                });
        } else {
            for (const StmtPtr& inner : statement.body) this->statement(*inner);
        }
        forget(statement);
    }

    /// Drops the facts about variables that the statement changes.
    void forget(const Stmt& statement) {
        if (facts_.empty()) return;
        Effects effects;
        add_effects(statement, effects);
        std::erase_if(facts_,
                      [&](const Fact& fact) { return effects.calls || mentions(*fact.condition, effects.writes); });
    }

    void expression(const Expr& expr) {
        const bool guarded =
            expr.kind == ExprKind::binary && (expr.binary == BinaryOp::conjunction ||
                                              expr.binary == BinaryOp::disjunction || expr.binary == BinaryOp::implies);
        if (guarded) {
            expression(*expr.args[0]);
            separately([&] {
                facts_.push_back({expr.args[0].get(), expr.binary != BinaryOp::disjunction});
                expression(*expr.args[1]);
            });
            return;
        }
        if (expr.kind == ExprKind::if_then_else) {
            expression(*expr.args[0]);
            for (std::size_t i = 1; i < expr.args.size(); ++i)
                separately([&] {
                    facts_.push_back({expr.args[0].get(), i == 1});
                    expression(*expr.args[i]);
                });
            return;
        }
        for_children(expr, [&](const Expr& part) { expression(part); });
        if (expr.kind == ExprKind::binary && (expr.binary == BinaryOp::divide || expr.binary == BinaryOp::modulus))
            division(expr);
        if (expr.kind == ExprKind::cast) cast(expr);
    }

    [[nodiscard]] logic::Finding decide(const Expr& expr, logic::Relation relation) const {
        logic::Reasoner reasoner(true);
        std::vector<logic::Formula> all{reasoner.compare_to_zero(expr, relation)};
        for (const Fact& fact : facts_) {
            logic::Formula formula = reasoner.read(*fact.condition);
            all.push_back(fact.holds ? std::move(formula) : logic::negation(std::move(formula)));
        }
        return reasoner.decide(logic::all_of(std::move(all)));
    }

    /// True if the value can vary. Whoever instantiates the model chooses the values of open constants, and calls are
    /// specified elsewhere; both are excluded.
    static bool varies(const Expr& expr) {
        bool variable = false;
        bool unknown = false;
        walk(expr, [&](const Expr& part) {
            const auto* named = part.kind == ExprKind::name ? dynamic_cast<const Variable*>(part.target) : nullptr;
            variable = variable || (named != nullptr && named->kind != DeclKind::constant);
            unknown = unknown || part.kind == ExprKind::call;
        });
        return variable && !unknown;
    }

    void division(const Expr& expr) {
        const Expr& divisor = strip(*expr.args[1]);
        if (divisor.type == nullptr ||
            (divisor.type->form != TypeForm::nat && divisor.type->form != TypeForm::integer &&
             divisor.type->form != TypeForm::real))
            return;
        logic::Reasoner reasoner(true);
        const auto not_zero = logic::negation(reasoner.compare_to_zero(divisor, logic::Relation::equal));
        if (reasoner.decide(not_zero).answer == logic::Answer::impossible) {
            out_.report(rules::w_zero, divisor.span, {to_text(divisor)});
            return;
        }
        if (!varies(divisor)) return;
        const logic::Finding zero = decide(divisor, logic::Relation::equal);
        if (zero.answer == logic::Answer::possible) out_.report(rules::w_maybe_zero, divisor.span, {to_text(divisor)});
    }

    void cast(const Expr& expr) {
        const Expr& value = strip(*expr.args[0]);
        const bool to_nat = expr.type != nullptr && expr.type->form == TypeForm::nat;
        if (!to_nat || value.type == nullptr || value.type->form == TypeForm::nat) return;
        const bool difference =
            value.kind == ExprKind::unary || (value.kind == ExprKind::binary && value.binary == BinaryOp::minus);
        if (!difference) return;
        const logic::Finding negative = decide(value, logic::Relation::less);
        if (negative.answer == logic::Answer::possible && negative.trusted)
            out_.report(rules::w_negative, expr.span, {to_text(value), negative.example});
    }

    std::vector<Fact> facts_;
    Diagnostics& out_;
};

}  // namespace

void lint_arithmetic(const Machine& machine, Diagnostics& out) {
    Arithmetic(machine, out).container(machine);
}

}  // namespace robochart::frontend
