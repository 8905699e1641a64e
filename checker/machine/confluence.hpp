// Which taus of a compiled process are confluent, by its rules (docs/search.md, "Confluent taus", has the statement and
// the proof). Groote and van de Pol, "State space reduction using partial tau-confluence", MFCS 2000; Blom and van de
// Pol, "State space reduction by proving confluence", CAV 2002.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <unordered_set>
#include <utility>
#include <vector>

#include "checker/machine/answer_table.hpp"
#include "checker/machine/whole_rules.hpp"

namespace robochart::machine {

/// Places of components, ascending.
using Slots = std::vector<std::uint32_t>;
/// What proofs need not look at, because it seldom decides: by the slots of the rule's parts and of the components that
/// are looked at, the slots to look at in place of them. Empty: the proof is taken to fail.
using ProofPlan = std::map<std::pair<Slots, Slots>, Slots>;

/// What proofs have taken and given, those for rules of the same components together: of a channel each value has a
/// rule.
class ProofRecord {
public:
    /// What one proof looked at, and whether it succeeded. `next`: what was tracked in its place afterwards.
    struct Sum {
        std::uint64_t proofs = 0;  ///< that succeeded
        std::uint64_t looked = 0;  ///< states that proofs looked at
        std::uint64_t rules = 0;   ///< that were looked at in these states
        std::uint64_t used = 0;    ///< taus that were followed because of such a proof
        std::map<Slots, std::uint64_t> next;
    };

    [[nodiscard]] Sum& of(const Slots& parts, const Slots& tracked) { return sums_[{parts, tracked}]; }
    /// What proofs need not look at, where the successors of a state take so much work. Proofs are not tried that have
    /// not succeeded, nor those that took more work than the states did that they left out.
    [[nodiscard]] ProofPlan plan(double work_of_a_state) const;

private:
    using Key = std::pair<Slots, Slots>;
    [[nodiscard]] bool leads_to_proofs(const Key& key, double work_of_a_state) const;

    std::map<Key, Sum> sums_;
};

/// Proves taus confluent by their rule and the present states of the components that take part in it, and keeps what
/// has been proved. Gives the same answers whatever it was asked before.
class Confluence {
public:
    /// `plan`: of a system with the same rules. What is proved depends on it.
    Confluence(std::shared_ptr<const Supercombinator> combined, std::shared_ptr<const WholeRules> rules,
               ProofPlan plan);
    Confluence(const Confluence&) = delete;
    Confluence& operator=(const Confluence&) = delete;
    ~Confluence();

    /// Takes the first tau of the state, given by the components' states, that is proved to be confluent. False if
    /// there is none.
    bool follow(std::span<Local> state);
    /// Adds what the proofs so far have taken and given.
    void add_to(ProofRecord&) const;
    /// All of the work so far, in the unit of `work_of_a_state`.
    [[nodiscard]] double work() const;

private:
    using RuleNumber = std::uint32_t;
    /// States of all components; only those of the tracked ones matter.
    using Locals = std::span<const Local>;
    /// Rules that ask a component for an event.
    struct ByEvent {
        std::uint32_t event = 0;
        std::vector<RuleNumber> rules;
    };
    /// The rules that ask some of a few components for an event, each once: with one that it asks, by the component's
    /// place among them and by the event, ascending. It can fire only where that component can do the event.
    using Asking = std::vector<std::vector<ByEvent>>;
    /// A rule with the components whose present states its proofs look at, and what these proofs gave.
    struct Tracked {
        RuleNumber rule = 0;
        Slots slots;                         ///< ascending: the rule's parts, and components beside them
        std::vector<std::uint64_t> weights;  ///< of each one's state in keys
        std::vector<char> has;               ///< by slot, whether it is one of them
        const Asking* asking = nullptr;      ///< of the slots, once a proof is tried
        std::uint64_t proofs = 0, looked = 0, rules = 0, used = 0;  ///< as in ProofRecord
        std::map<std::uint32_t, std::uint64_t> next;  ///< how often which other one was asked after a proof that failed
    };
    /// What rules other than the tracked one lead to, and the rule that leads to each.
    struct Outcomes {
        std::vector<Local> states;  ///< of all components, one after the other
        std::vector<RuleNumber> by;
        std::uint64_t rules = 0;  ///< looked at, in all
    };
    class Closure;

    void count_offers();
    void list_tau_rules();
    const std::vector<RuleNumber>& candidates(std::uint32_t slot, Local local);
    [[nodiscard]] std::vector<RuleNumber> made(std::uint32_t slot, Local local) const;
    [[nodiscard]] bool hopeless(RuleNumber rule, std::uint32_t slot, Local local) const;
    bool confluent(RuleNumber rule, Locals state);
    std::uint32_t answer(std::uint32_t number, Locals state);
    std::uint32_t decide(std::uint32_t number, std::uint64_t here, Locals state);
    void keep(std::uint32_t number, std::uint64_t key, std::uint32_t answer);
    std::uint32_t tracking(RuleNumber rule, Slots slots);
    std::uint32_t made(RuleNumber rule, Slots slots);
    /// What is asked after a proof that failed, and how many of the rules were looked at to find it.
    struct Next {
        std::uint32_t number;
        std::size_t rules;
    };
    Next tracking_more(std::uint32_t number, const std::vector<RuleNumber>& others);
    [[nodiscard]] Slots parts_of(RuleNumber rule) const;
    const Asking& asking(const Tracked& tracked);
    [[nodiscard]] std::uint32_t listed_at(const WholeRule& rule, const std::vector<char>& has) const;
    [[nodiscard]] static std::uint64_t key(const Tracked& tracked, Locals state);

    [[nodiscard]] bool holds_now(const Tracked& tracked, std::span<Local> state, Outcomes& next,
                                 std::optional<RuleNumber>& disturbing) const;
    [[nodiscard]] bool determined(const WholeRule& rule, Locals state) const;
    [[nodiscard]] bool cannot_fire(const WholeRule& other, const Tracked& tracked, Locals state) const;
    [[nodiscard]] bool commutes(const WholeRule& rule, const WholeRule& other, Locals state) const;
    [[nodiscard]] bool commutes(const Part& part, const Part& other, Local local) const;
    void add_outcomes(const Tracked& tracked, RuleNumber other, std::size_t place, std::span<Local> state,
                      Outcomes& next) const;
    [[nodiscard]] bool unchanged(const Part& part, Local local) const;
    [[nodiscard]] const Component& component(std::uint32_t slot) const { return *combined_->components[slot]; }

    std::shared_ptr<const Supercombinator> combined_;
    std::shared_ptr<const WholeRules> rules_;
    ProofPlan plan_;
    std::vector<std::vector<double>> share_;  // by slot and event, of the component's states that can do it
    std::vector<std::vector<std::vector<RuleNumber>>> leading_;  // by slot and event, the tau rules that begin there
    std::vector<std::vector<std::uint32_t>> known_;              // by slot and state, one more than a place in lists_
    std::vector<std::vector<RuleNumber>> lists_;
    std::deque<Tracked> tracked_;
    std::map<Slots, Asking> asking_;                                 // by slots
    std::vector<std::uint32_t> first_;                               // by rule, what its proofs begin with
    std::map<std::pair<RuleNumber, Slots>, std::uint32_t> numbers_;  // of what tracks these
    std::uint64_t states_asked_ = 0, answers_asked_ = 0;
    AnswerTable answers_;  // by number of what is tracked, and key: `no`, `yes`, or the number of what to ask
    std::unique_ptr<Closure> closure_;  // its memory is used again
};

}  // namespace robochart::machine
