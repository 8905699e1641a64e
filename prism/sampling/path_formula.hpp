// SPDX-License-Identifier: Apache-2.0
// Decides a path formula along one path: reads states until they determine whether the formula holds.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "prism/explore/code.hpp"
#include "prism/explore/question_numbers.hpp"

namespace robochart::prism {

/// Supports X, F, G, U, W and R of state formulas, with bounds on the steps and inside any number of X, and !, &, |,
/// =>, <=> over such formulas. All are reduced to `left U right` from some state of the path: F a is true U a, G a is
/// !F !a, a W b is !((a & !b) U (!a & !b)), a R b is !(!a U !b), and a state formula a is F<=0 a.
class PathFormula {
public:
    /// Labels must have been replaced, except for "deadlock" and "init". Throws Unsampled, EvaluationError.
    PathFormula(const ExprPtr& formula, Code& code);

    /// Starts a new path.
    void start_path();
    /// Processes the next state of the path. Throws EvaluationError.
    void observe_state(StateValues state);
    /// Records that the last `period` states of the path repeat forever.
    void end_in_loop(std::uint64_t period);
    /// Returns whether the formula holds, or no value if this is not known yet.
    [[nodiscard]] std::optional<bool> holds() const { return holds(root_); }

private:
    struct Until {
        std::uint64_t begin = 0;  ///< index of the state at which the formula is evaluated
        Code::Root left = 0, right = 0;
        StepRange steps;
        std::optional<bool> holds;
    };
    enum class Kind : std::uint8_t { until, negation, conjunction, equivalence };
    struct Node {
        Kind kind = Kind::until;
        std::size_t a = 0, b = 0;  ///< nodes; for an until its index in `untils_`
    };

    std::size_t node(Kind kind, std::size_t a, std::size_t b = 0);
    std::size_t add_formula(const ExprPtr& expr, std::uint64_t begin);
    std::size_t add_connective(const Expr& expr, std::uint64_t begin);
    std::size_t add_temporal(const Expr& expr, std::uint64_t begin);
    std::size_t add_until(Until until);
    Code::Root state(const ExprPtr& expr);
    void observe_state(Until& until, StateValues values) const;
    [[nodiscard]] std::optional<bool> holds(std::size_t node) const;

    Code& code_;
    std::vector<Until> untils_;
    std::vector<Node> nodes_;
    std::size_t root_ = 0;
    std::uint64_t seen_ = 0;  ///< number of states
};

}  // namespace robochart::prism
