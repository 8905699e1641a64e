// SPDX-License-Identifier: Apache-2.0
// Converts the rules of all regions to rules of the whole process. A whole rule describes one transition: the events of
// all components, and the priorities that may prevent the transition. Proofs about transitions use whole rules.
// Successors are computed with the rules of the regions.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// The effect of a rule of the whole process on the component in one slot.
struct Part {
    std::uint32_t slot = 0;
    /// The event that the component performs, as an index in its alphabet.
    std::optional<std::uint32_t> event;
    std::optional<Local> assigned;  ///< the state that the rule assigns to the component, independently of its event
};

/// A region's rule that a rule of the whole process uses, and the level of its event in this region.
struct Passage {
    std::uint32_t region = 0;
    std::uint32_t level = no_level;
};

/// A rule of the whole process: if these components perform these events together, the process performs this event,
/// unless a priority prevents it.
struct WholeRule {
    Event event = process::tau;
    std::uint32_t outermost = 0;     ///< the rule of the outermost region that it uses
    std::uint32_t level = no_level;  ///< the level of its event in the outermost region
    std::vector<Part> parts;         ///< ascending by slot, one for each slot
    /// The regions whose priorities can prevent the rule: its event does not have their first level.
    std::vector<Passage> prevented;
    /// The regions in which the rule prevents all events below the first level.
    std::vector<std::uint32_t> preventing;

    [[nodiscard]] const Part* find_part(std::uint32_t slot) const;
};

/// All rules, with two indexes: the rules in which a component performs an event, and the rules that set its state.
struct WholeRules {
    std::vector<WholeRule> rules;
    std::vector<std::vector<std::vector<std::uint32_t>>> asking;  ///< by slot and event
    std::vector<std::vector<std::uint32_t>> assigning;            ///< by slot
    /// For each slot: the rules that an event of its component can prevent. Such a rule passes through a region that
    /// contains the component and whose priorities can prevent the rule.
    std::vector<std::vector<std::uint32_t>> preventable;
};

/// Returns the rules of the whole process. Returns no value if there are too many for proofs. Polls the budget.
[[nodiscard]] std::optional<WholeRules> whole_rules(const Supercombinator& combined, diagnostics::Pollable& budget);

/// Returns the rules of each region in terms of components. For these rules, `outermost` refers to that region. Returns
/// no value if there are too many rules for proofs. Polls the budget.
[[nodiscard]] std::optional<std::vector<std::vector<WholeRule>>> rules_of_regions(const Supercombinator& combined,
                                                                                  diagnostics::Pollable& budget);

}  // namespace robochart::machine
