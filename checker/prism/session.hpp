// A model explored for one set of constants, and the properties decided over it.
#pragma once

#include <string>
#include <vector>

#include "checker/prism/checks/checked.hpp"
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
    [[nodiscard]] Result check(std::size_t property, const Values& constants);

private:
    [[nodiscard]] Result attempt(const ExprPtr& expr, const Values& constants, double relative, bool exact);
    [[nodiscard]] ExprPtr resolved(const ExprPtr& expr);

    const StateSpace& space_;
    const CheckedProperties& properties_;
    SessionOptions options_;
};

}  // namespace robochart::prism
