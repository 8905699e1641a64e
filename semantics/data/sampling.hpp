// SPDX-License-Identifier: Apache-2.0
// Evaluates expressions in the ideal semantics. Numbers have no bounds. Reals have more decimals than the literals of
// the model, so that there are numbers between any two neighbouring literals. Private to this component.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "semantics/evaluate/environment.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"
#include "semantics/ir/number_parts.hpp"

namespace robochart::ir {

/// Returns true if a call may be undefined, because a precondition is false or no result satisfies the postconditions.
/// This matters only for calls that inline_calls() does not replace.
[[nodiscard]] bool may_have_no_value(const Function& function);

/// Returns the default value of the type, with its components replaced by the numbers with the same indices, in units.
[[nodiscard]] Value value_at(const System& system, const Instantiation& instantiation, TypeId type,
                             const std::vector<NumberPart>& components, const std::vector<std::int64_t>& numbers);

/// Evaluates expressions of a system without bounds.
class Sampling {
public:
    /// The arguments must outlive the object.
    Sampling(const System& system, const Instantiation& instantiation);

    [[nodiscard]] const Instantiation& instantiation() const { return ideal_; }
    /// Returns the value of an expression that reads no variable, trigger or clock. Returns no value if it reads one,
    /// if it is undefined, or if the contexts in which the machine runs give it different values.
    [[nodiscard]] std::optional<Value> closed_value(MachineId machine, const Expr& expr) const;
    /// Evaluates a condition for this value of the only place that it reads. Returns 1 if it is true, 0 if it is false,
    /// and -1 if a precondition of a function makes it undefined. Returns no value if the answers differ in the
    /// contexts in which the machine runs, or if the evaluation is an error, such as a division by zero.
    [[nodiscard]] std::optional<int> truth(MachineId machine, const Expr& condition, const Value& value) const;

    /// Returns true if a call, a division or a conversion in the expression may be undefined. Example: a negative
    /// number has no conversion to nat.
    [[nodiscard]] bool may_be_undefined(MachineId machine, const ExprPtr& expr) const;

    /// True if the machine's constants have the same values here and in the finite instantiation.
    [[nodiscard]] bool has_finite_constants(MachineId machine) const;

private:
    [[nodiscard]] bool is_set_by_property(MachineId machine, const Expr& expr) const;
    [[nodiscard]] Value rescaled(TypeId type, const Value& value) const;

    const System& system_;
    const Instantiation& finite_;
    Instantiation ideal_;
    std::int64_t factor_ = 1;
    std::set<std::string> set_by_properties_;                 ///< names of constants, as scripts write them
    std::vector<std::vector<std::vector<Value>>> constants_;  ///< the constants of each machine in each context
};

}  // namespace robochart::ir
