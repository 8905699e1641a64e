// SPDX-License-Identifier: Apache-2.0
// Converts the rules of all regions to rules of the whole process. Such a rule contains the events of the components in
// one transition, and the priorities on which the transition depends. These rules are used for proofs about
// transitions. Successors are computed with the rules of the regions.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// What a rule of the whole process does with the component in one slot.
struct Part {
    std::uint32_t slot = 0;
    /// The event that the component performs, as an index in its alphabet.
    std::optional<std::uint32_t> event;
    std::optional<Local> assigned;  ///< the state that the rule assigns to the component, independently of its event
};

/// A rule of a region through which a rule of the whole process passes, with the level of its event there.
struct Passage {
    std::uint32_t region = 0;
    std::uint32_t level = no_level;
};

/// A rule of the whole process says: if these components perform these events, the process performs this event, unless
/// a priority prevents it.
struct WholeRule {
    Event event = process::tau;
    std::uint32_t outermost = 0;     ///< the rule of the outermost region through which it passes
    std::uint32_t level = no_level;  ///< the level of its event in the outermost region
    std::vector<Part> parts;         ///< ascending by slot, one for each slot
    /// The regions that can prevent the rule, because its level in them is not the first.
    std::vector<Passage> prevented;
    /// The regions in which the rule prevents all events that do not have the first level.
    std::vector<std::uint32_t> preventing;

    [[nodiscard]] const Part* find_part(std::uint32_t slot) const;
};

/// All rules, with two indexes: the rules in which a component performs an event, and the rules that assign its state.
struct WholeRules {
    std::vector<WholeRule> rules;
    std::vector<std::vector<std::vector<std::uint32_t>>> asking;  ///< by slot and event
    std::vector<std::vector<std::uint32_t>> assigning;            ///< by slot
    /// For each slot, the rules that events of its component can prevent: the component is below a region that can
    /// prevent these rules.
    std::vector<std::vector<std::uint32_t>> preventable;
};

/// Returns the rules of the whole process. Returns no value if there are too many rules to be useful. Polls the budget.
[[nodiscard]] std::optional<WholeRules> whole_rules(const Supercombinator& combined, diagnostics::Pollable& budget);

/// Returns, for each region, its rules in terms of components. The outermost region of such a rule is this region.
/// Returns no value if there are too many rules to be useful. Polls the budget.
[[nodiscard]] std::optional<std::vector<std::vector<WholeRule>>> rules_of_regions(const Supercombinator& combined,
                                                                                  diagnostics::Pollable& budget);

}  // namespace robochart::machine
