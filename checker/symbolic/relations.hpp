// SPDX-License-Identifier: Apache-2.0
// Represents the rules of a compiled process as relations on sets of states. Each variable represents the state of one
// component. Most rules change few variables, so a rule is represented by a list of links, one for each component that
// takes part in it. Each rule has a guard: the set of states in which the priorities do not prevent the rule
// (docs/search.md, "Decision diagrams").
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "checker/machine/whole_rules.hpp"
#include "checker/symbolic/diagrams.hpp"

namespace robochart::symbolic {

using RegionRules = std::vector<std::vector<machine::WholeRule>>;

/// A relation on the values of one variable.
class LocalRelation {
public:
    explicit LocalRelation(std::vector<std::pair<Value, Value>> pairs);
    [[nodiscard]] std::span<const Value> targets(Value value) const;
    /// Returns the values that have targets, ascending.
    [[nodiscard]] const std::vector<Value>& sources() const { return sources_; }
    /// Returns true if the relation leads from each value below `domain` to this value alone.
    [[nodiscard]] bool is_identity(Value domain) const;
    /// Returns all pairs, ascending.
    [[nodiscard]] std::vector<std::pair<Value, Value>> pairs() const;

private:
    std::vector<Value> sources_, targets_;
    std::vector<std::size_t> first_;  // by source: index of its first target; one more at the end
};

/// The number of the first link of a list of links. `no_link` represents the empty list. Equal lists have equal
/// numbers.
using Chain = std::uint32_t;
inline constexpr Chain no_link = 0xffffffffU;

/// How one rule changes one variable. The links of a list are in descending order of their levels.
struct Link {
    Level level = 0;
    std::uint32_t relation = 0;
    Chain next = no_link;
};

/// The step of a rule. It is possible only in states of the guard. Each link of the chain changes one variable.
struct Step {
    Chain chain = no_link;
    Node guard = everything;  ///< its level may be lower than that of the states
    friend bool operator==(const Step&, const Step&) = default;
    friend auto operator<=>(const Step&, const Step&) = default;
};

/// The assignment of variables to components.
struct Variables {
    std::vector<Level> level_of;         ///< by slot
    std::vector<std::uint32_t> slot_at;  ///< by level; the first element is unused
    std::vector<Value> domains;          ///< by level; the first element is unused
};

/// Returns the variables in the order of order_variables. Polls the budget.
[[nodiscard]] Variables make_variables(const machine::Supercombinator& combined, const RegionRules& rules,
                                       diagnostics::Pollable& budget);
/// Returns variables for the slots in the given order. The first slot gets the lowest level.
[[nodiscard]] Variables make_variables(const machine::Supercombinator& combined,
                                       const std::vector<std::uint32_t>& order);

class Relations {
public:
    /// `diagrams` may have more levels than there are variables. The additional levels must be the highest. Polls the
    /// budget.
    Relations(const machine::Supercombinator& combined, const RegionRules& rules, const Variables& variables,
              Diagrams& diagrams, diagnostics::Pollable& budget);

    /// Returns the steps of the rules of the whole process, in the order of the rules.
    [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
    [[nodiscard]] const Link& link(Chain chain) const { return links_[chain]; }
    [[nodiscard]] const LocalRelation& relation(std::uint32_t number) const { return relations_[number]; }
    /// Returns the level of the first link, or 0 if the list is empty.
    [[nodiscard]] Level level_of(Chain chain) const { return chain == no_link ? 0 : links_[chain].level; }
    /// Returns the highest level on which the step depends.
    [[nodiscard]] Level level_of(const Step& step) const;
    /// Returns the part of a guard below one value of a variable.
    [[nodiscard]] Node guard_below(Node guard, Level level, Value value) const {
        if (guard <= everything || diagrams_.level_of(guard) < level) return guard;
        return diagrams_.child(guard, value);
    }
    /// Returns a step that does the same as the given step and also changes the variable of `level` by `relation`. This
    /// level must be above all variables that the given step changes.
    [[nodiscard]] Step extend(const Step& step, Level level, const LocalRelation& relation);
    /// Returns the set of states in which none of the steps is possible. The level of the set is the highest level on
    /// which it depends.
    [[nodiscard]] Node none_possible(std::vector<Step> steps);
    /// Returns the states from which the step can lead into the set.
    [[nodiscard]] Node before(Node states, const Step& step) {
        assert(level_of(step) <= diagrams_.levels());
        return precede(diagrams_.levels(), states, step.chain, step.guard);
    }
    /// Returns the value that represents a state of a component: the same number, but at most the last value of the
    /// variable.
    [[nodiscard]] Value value_of(std::uint32_t slot, machine::Local local) const;

private:
    [[nodiscard]] std::uint32_t relation_of(const machine::Part& part);
    [[nodiscard]] Chain chain_of(const machine::WholeRule& rule);
    [[nodiscard]] Chain chain_from(const Link& link);
    [[nodiscard]] Node guard_of(const machine::WholeRule& rule, std::optional<std::uint32_t> except);
    [[nodiscard]] Node region_guard(std::uint32_t region, std::uint32_t level);
    [[nodiscard]] Level highest_level(Node set) const;
    [[nodiscard]] Node strip(Node guard) const;
    [[nodiscard]] Node disable(Level level, Node states, Chain chain, Node guard);
    [[nodiscard]] Node precede(Level level, Node states, Chain chain, Node guard);

    const machine::Supercombinator& combined_;
    const RegionRules& rules_;
    const Variables& variables_;
    Diagrams& diagrams_;
    diagnostics::Pollable& budget_;
    std::vector<LocalRelation> relations_;
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::uint32_t> relation_numbers_;
    std::vector<Link> links_;
    std::map<std::tuple<Level, std::uint32_t, Chain>, Chain> chain_numbers_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Node> guards_;  // by region and level
    std::vector<Step> steps_;
};

}  // namespace robochart::symbolic
