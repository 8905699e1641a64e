// The rules of all regions as rules of the whole: what components have to do together for one transition, and which
// priorities it depends on. For proofs about transitions; successors are made by the rules of the regions.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// One slot's part in a rule of the whole.
struct Part {
    std::uint32_t slot = 0;
    std::optional<std::uint32_t> event;  ///< what the component has to do, by its place in the component's alphabet
    std::optional<Local> assigned;       ///< the state that the rule puts it into, whatever it does
};

/// A rule of a region that a rule of the whole passes through, with the level of its event there.
struct Passage {
    std::uint32_t region = 0;
    std::uint32_t level = no_level;
};

/// "Where these components perform these events, the whole performs this one", unless a priority prevents it.
struct WholeRule {
    Event event = process::tau;
    std::vector<Part> parts;         ///< ascending by slot, one a slot
    std::vector<Passage> prevented;  ///< the regions where it can be prevented: its level is not the first one there
    std::vector<std::uint32_t> preventing;  ///< the regions where it prevents all that is not of the first level

    [[nodiscard]] const Part* part(std::uint32_t slot) const;
};

/// All of them, and which of them a component's part in a transition can belong to.
struct WholeRules {
    std::vector<WholeRule> rules;
    std::vector<std::vector<std::vector<std::uint32_t>>> asking;  ///< by slot and event
    std::vector<std::vector<std::uint32_t>> assigning;            ///< by slot
    /// By slot, the rules that can be prevented by what its component can do: it lies below a region of theirs.
    std::vector<std::vector<std::uint32_t>> preventable;
};

/// None where they are more than they are worth. `poll` may throw to stop.
[[nodiscard]] std::optional<WholeRules> whole_rules(const Supercombinator& combined, const std::function<void()>& poll);

}  // namespace robochart::machine
