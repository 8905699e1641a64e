// A path formula, decided along one path: state by state, until what has been seen says whether it holds.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "checker/prism/explore/code.hpp"
#include "checker/prism/explore/question_numbers.hpp"

namespace robochart::prism {

/// X, F, G, U, W and R of states, with bounds on the steps, behind any number of X, and !, &, |, =>, <=> over them. All
/// of it is made of `left U right` from some state of the path on: F a is true U a, G a is !F !a, a W b is
/// !((a & !b) U (!a & !b)), a R b is !(!a U !b); a alone is F<=0 a.
class PathFormula {
public:
    /// Labels are replaced, but for "deadlock" and "init". Throws Unsampled, EvaluationError.
    PathFormula(const ExprPtr& formula, Code& code);

    /// Forgets what was seen.
    void restart();
    /// The next state of the path. Throws EvaluationError.
    void observe(StateValues state);
    /// The last states that were seen come again and again: so many.
    void repeats(std::uint64_t period);
    /// Whether it holds, once that is known.
    [[nodiscard]] std::optional<bool> holds() const { return holds(root_); }

private:
    struct Until {
        std::uint64_t begin = 0;  ///< the state that the formula is about
        Code::Root left = 0, right = 0;
        StepRange steps;
        std::optional<bool> holds;
    };
    enum class Kind : std::uint8_t { until, negation, conjunction, equivalence };
    struct Node {
        Kind kind = Kind::until;
        std::size_t a = 0, b = 0;  ///< nodes; of an until its place in `untils_`
    };

    std::size_t node(Kind kind, std::size_t a, std::size_t b = 0);
    std::size_t formula(const ExprPtr& expr, std::uint64_t begin);
    std::size_t connective(const Expr& expr, std::uint64_t begin);
    std::size_t temporal(const Expr& expr, std::uint64_t begin);
    std::size_t until(Until until);
    Code::Root state(const ExprPtr& expr);
    void observe(Until& until, StateValues values) const;
    [[nodiscard]] std::optional<bool> holds(std::size_t node) const;

    Code& code_;
    std::vector<Until> untils_;
    std::vector<Node> nodes_;
    std::size_t root_ = 0;
    std::uint64_t seen_ = 0;  ///< states
};

}  // namespace robochart::prism
