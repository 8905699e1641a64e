// SPDX-License-Identifier: Apache-2.0
// Computes the probabilities of the branches of probabilistic junctions exactly, as fractions. Unlike in the CSP
// semantics, values are not clipped or rounded: a probability is the number in the model.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "csp_emit/base/emission.hpp"
#include "prism/assertions/process/seats.hpp"
#include "prism/markov/model/model.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::probability {

using markov::Rational;

/// Returns the value of a variable in the units of the CSP semantics. Throws if the value is unknown.
using ValueOf = std::function<std::int64_t(const std::string& name)>;

class Weights {
public:
    Weights(const ir::System& system, const ir::Instantiation& instantiation)
        : system_(system), instantiation_(instantiation) {}

    /// Returns the probability of a branch and its equivalent branches together, for the machine with this seat. Throws
    /// Wrong if the probability is not a computable fraction from 0 to 1.
    [[nodiscard]] Rational branch_probability(const csp_emit::Draw& draw, const Seat& seat,
                                              const ValueOf& value_of) const;
    /// Returns the value of a constant of a machine with this seat.
    [[nodiscard]] Rational constant_value(const ir::Machine& machine, ir::ConstantId id, const Seat& seat) const;

private:
    struct Scope {
        const ir::Machine& machine;
        const Seat& seat;
        const csp_emit::Draw* draw;
        const ValueOf* value_of;
        unsigned depth = 0;
    };
    [[nodiscard]] Rational expression_value(const Scope& scope, const ir::Expr& expr) const;
    [[nodiscard]] Rational constant_value(const Scope& scope, ir::ConstantId id) const;

    const ir::System& system_;
    const ir::Instantiation& instantiation_;
};

/// Returns the branches that no step distinguishes from this branch, including the branch itself. They connect the same
/// junction with the same target, without actions and resets.
[[nodiscard]] std::vector<std::uint32_t> equivalent_branches(const ir::System& system, const csp_emit::Draw& draw);

}  // namespace robochart::probability
