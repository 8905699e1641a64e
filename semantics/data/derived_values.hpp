// SPDX-License-Identifier: Apache-2.0
// Values that a model computes from values that come from outside, such as q after `q = x / 2` for an input x.
//
// A carrier reaches beyond each literal with which values of its type are compared, so every such comparison of an
// input has both answers. This is not true of values that are computed or converted: for x in 0..8, `x / 2` is never
// greater than 7; and for x : nat in 0..2, `q = x` makes q : int never greater than 2, whatever q is compared with.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Where the values of a place come from.
enum class ValueSource : unsigned char {
    inside,   ///< the machines write them, and compute them only from such values
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

    std::map<Key, ValueSource> variables_, events_;  ///< without those from inside
};

}  // namespace robochart::ir
