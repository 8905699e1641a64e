// SPDX-License-Identifier: Apache-2.0
// Finds values that a model computes from values from outside. Example: q after `q = x / 2` for an input x.
//
// A carrier extends beyond each literal with which values of its type are compared. So every comparison of an input
// with a literal is true for some inputs and false for others. A comparison of a computed or converted value may have
// only one answer. Examples: for x in 0..8, `x / 2` is never greater than 7; for x : nat in 0..2 and q : int, q is
// never greater than 2 after `q = x`, even if the model compares q with 5.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Where the values of a place come from.
enum class ValueSource : unsigned char {
    inside,   ///< machines write all values, and compute them only from values from inside
    outside,  ///< some are copies of inputs, shared variables, or parameters of operations
    derived,  ///< some are computed or converted from values from outside or clocks, or are copies of these results
};

/// For all places of a system: where their values come from.
class DerivedValues {
public:
    DerivedValues(const System& system, const Instantiation& instantiation);

    [[nodiscard]] ValueSource of_variable(MachineId machine, VariableId variable) const {
        return find(variables_, {machine.index, variable.index});
    }
    /// Returns the source of the values that an event of the machine carries.
    [[nodiscard]] ValueSource of_event(MachineId machine, EventId event) const {
        return find(events_, {machine.index, event.index});
    }

private:
    using Key = std::pair<std::uint32_t, std::uint32_t>;

    [[nodiscard]] static ValueSource find(const std::map<Key, ValueSource>& sources, const Key& key) {
        const auto found = sources.find(key);
        return found == sources.end() ? ValueSource::inside : found->second;
    }

    std::map<Key, ValueSource> variables_, events_;  ///< places with the source `inside` are omitted
};

}  // namespace robochart::ir
