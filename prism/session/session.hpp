// SPDX-License-Identifier: Apache-2.0
// Decides properties of a model that was explored for one set of constants.
#pragma once

#include <string>
#include <vector>

#include "prism/checks/checked.hpp"
#include "prism/explore/state_space.hpp"
#include "prism/session/counterexample.hpp"
#include "prism/session/result.hpp"

namespace robochart::prism {

struct SessionOptions {
    double relative = 1e-6;  ///< width of the enclosures relative to their value
    bool exact = false;      ///< compute with fractions
    diagnostics::Budget* budget = nullptr;
};

class Session {
public:
    /// All arguments must outlive the object.
    Session(const StateSpace& space, const CheckedProperties& properties, const SessionOptions& options);

    /// Decides a property, with values for the constants that the properties do not define. If the enclosures do not
    /// decide a comparison, it is repeated with narrower enclosures, and then with fractions if the model is small.
    /// Throws EvaluationError, LimitReached.
    [[nodiscard]] Result check(std::size_t property, const Values& constants) const;

    /// Returns the counterexample for a bound that is violated according to `check`, if there is one. Throws the
    /// exceptions of `check`.
    [[nodiscard]] std::optional<Counterexample> counterexample(std::size_t property, const Values& constants) const;

    /// Returns the choices of a scheduler that attains the value of a property (counterexample.hpp). Throws the
    /// exceptions of `check`, and Undecided.
    [[nodiscard]] std::vector<std::uint32_t> best_choices(std::size_t property, const Values& constants) const;

private:
    /// A property with the data for its evaluation.
    struct Question {
        ExprPtr expr;  ///< labels have been replaced
        Values constants;
    };
    [[nodiscard]] Question question(std::size_t property, const Values& constants) const;
    [[nodiscard]] Result answer_with_precision(const Question& question, double relative, bool exact) const;

    const StateSpace& space_;
    const CheckedProperties& properties_;
    SessionOptions options_;
};

}  // namespace robochart::prism
