// SPDX-License-Identifier: Apache-2.0
// Values that a model computes from values that come from outside, such as q after `q = x / 2` for an input x.
//
// The carrier of a type extends beyond each literal with which values of this type are compared. So every such
// comparison of an input can be true and can be false. This is not so for values that are computed or converted: for x
// in 0..8, `x / 2` is never greater than 7; and for x : nat in 0..2, `q = x` makes q : int never greater than 2, even
// if the model compares q with 5.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Where the values of a place come from.
enum class ValueSource : unsigned char {
    inside,   ///< the machines write the values, and compute them only from values that also come from inside
    outside,  ///< some are copies of inputs, of shared variables, or of parameters of operations
    derived,  ///< some are computed or converted from such values or from clocks, or copied from such results
};

/// The sources of the values of all places of a system.
class DerivedValues {
public:
    DerivedValues(const System& system, const Instantiation& instantiation);

    [[nodiscard]] ValueSource of_variable(MachineId machine, VariableId variable) const {
        return find(variables_, {machine.index, variable.index});
    }
    /// The source of the values that an event of the machine carries.
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
