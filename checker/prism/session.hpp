// A model explored for one set of constants, and the properties decided over it.
#pragma once

#include <string>
#include <vector>

#include "checker/prism/checks/checked.hpp"
#include "checker/prism/counterexample.hpp"
#include "checker/prism/explore/state_space.hpp"
#include "checker/prism/result.hpp"

namespace robochart::prism {

struct SessionOptions {
    double relative = 1e-6;  ///< the width of enclosures, relative to their value
    bool exact = false;      ///< fractions
    diagnostics::Budget* budget = nullptr;
};

class Session {
public:
    /// All of them outlive it.
    Session(const StateSpace& space, const CheckedProperties& properties, const SessionOptions& options);

    /// Decides a property, with values for the constants that the properties leave open. Throws EvaluationError,
    /// LimitReached. A comparison that the enclosures do not decide is tried again, narrower, then with fractions where
    /// the model is small.
    [[nodiscard]] Result check(std::size_t property, const Values& constants) const;

    /// Evidence of a bound that `check` has found violated, where there is some. Throws as `check`.
    [[nodiscard]] std::optional<Counterexample> counterexample(std::size_t property, const Values& constants) const;

    /// The choices of a scheduler that attains the value of a property (counterexample.hpp). Throws as `check`, and
    /// Undecided.
    [[nodiscard]] std::vector<std::uint32_t> best_choices(std::size_t property, const Values& constants) const;

private:
    /// A property with everything that it needs.
    struct Question {
        ExprPtr expr;  ///< labels are replaced
        Values constants;
    };
    [[nodiscard]] Question question(std::size_t property, const Values& constants) const;
    [[nodiscard]] Result attempt(const Question& question, double relative, bool exact) const;

    const StateSpace& space_;
    const CheckedProperties& properties_;
    SessionOptions options_;
};

}  // namespace robochart::prism
