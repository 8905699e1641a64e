// Which taus of a compiled process are confluent, by its rules (docs/search.md, "Confluent taus", has the statement and
// the proof). Groote and van de Pol, "State space reduction using partial tau-confluence", MFCS 2000; Blom and van de
// Pol, "State space reduction by proving confluence", CAV 2002.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "checker/machine/whole_rules.hpp"

namespace robochart::machine {

/// Proves taus confluent by their rule and the present states of the components that take part in it, and keeps what
/// has been proved. Gives the same answers whatever it was asked before.
class Confluence {
public:
    Confluence(std::shared_ptr<const Supercombinator> combined, std::shared_ptr<const WholeRules> rules);

    /// Takes the first tau of the state, given by the components' states, that is proved to be confluent. False if
    /// there is none.
    bool follow(std::span<Local> state);

private:
    using RuleNumber = std::uint32_t;
    /// States of all components; only those of the parts of the rule at hand matter.
    using Locals = std::vector<Local>;
    /// What is known of one rule, by the states of its parts.
    struct Proved {
        std::vector<std::uint64_t> weights;  ///< of each part's state in keys; empty if these are too large
        std::unordered_map<std::uint64_t, bool> answers;
    };
    class Closure;

    void list_tau_rules();
    const std::vector<RuleNumber>& candidates(std::uint32_t slot, Local local);
    [[nodiscard]] std::vector<RuleNumber> made(std::uint32_t slot, Local local) const;
    [[nodiscard]] bool hopeless(RuleNumber rule, std::uint32_t slot, Local local) const;
    bool confluent(RuleNumber rule, std::span<const Local> state);
    void keep(RuleNumber rule, std::uint64_t key, bool answer);
    [[nodiscard]] std::uint64_t key(RuleNumber rule, std::span<const Local> state) const;

    [[nodiscard]] bool holds_now(RuleNumber rule, const Locals& state, std::vector<Locals>& next) const;
    [[nodiscard]] bool determined(const WholeRule& rule, const Locals& state) const;
    [[nodiscard]] bool cannot_fire_beside(const WholeRule& other, const WholeRule& rule, const Locals& state) const;
    [[nodiscard]] bool commutes(const WholeRule& rule, const WholeRule& other, const Locals& state) const;
    [[nodiscard]] bool commutes(const Part& part, const Part& other, Local local) const;
    void add_outcomes(const WholeRule& rule, const WholeRule& other, std::size_t part, Locals& state,
                      std::vector<Locals>& next) const;
    [[nodiscard]] bool unchanged(const Part& part, Local local) const;
    [[nodiscard]] const Component& component(std::uint32_t slot) const { return *combined_->components[slot]; }

    std::shared_ptr<const Supercombinator> combined_;
    std::shared_ptr<const WholeRules> rules_;
    std::vector<std::vector<std::vector<RuleNumber>>> leading_;  // by slot and event, the tau rules that begin there
    std::vector<std::vector<std::uint32_t>> known_;              // by slot and state, one more than a place in lists_
    std::vector<std::vector<RuleNumber>> lists_;
    std::vector<Proved> proved_;  // by rule
    std::size_t answers_ = 0;
};

}  // namespace robochart::machine
