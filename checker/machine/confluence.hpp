// SPDX-License-Identifier: Apache-2.0
// Decides which taus of a compiled process are confluent, by examining its rules (docs/search.md, "Confluent taus",
// contains the statement and the proof). If only deadlocks matter, steps with any event may be confluent
// (docs/search.md, "Deadlocks"). Sources: Groote and van de Pol, "State space reduction using partial tau-confluence",
// MFCS 2000; Blom and van de Pol, "State space reduction by proving confluence", CAV 2002.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "checker/lts/transition_system.hpp"
#include "checker/machine/answer_table.hpp"
#include "checker/machine/whole_rules.hpp"

namespace robochart::machine {

/// Indices of components, ascending.
using Slots = std::vector<std::uint32_t>;
/// A plan contains the queries to skip because their proofs seldom succeed. The key consists of the slots of the rule's
/// parts and the slots that the skipped query tracks. The value contains the slots to track instead. If the value is
/// empty, no proof is tried, and the step is not followed.
using ProofPlan = std::map<std::pair<Slots, Slots>, Slots>;

/// Records the work of proofs and the steps that were followed because of them. Rules with the same components share an
/// entry, because a channel has one such rule for each value.
class ProofRecord {
public:
    /// The sums for all proofs that track the same components. `next` counts, for each other set of components, how
    /// often it was tracked after a failed proof.
    struct Sum {
        std::uint64_t proofs = 0;  ///< number of successful proofs
        std::uint64_t looked = 0;  ///< number of states examined by proofs
        std::uint64_t rules = 0;   ///< number of rules examined in these states
        std::uint64_t used = 0;    ///< number of steps followed because of these proofs
        std::map<Slots, std::uint64_t> next;
    };

    [[nodiscard]] Sum& sum_of(const Slots& parts, const Slots& tracked) { return sums_[{parts, tracked}]; }
    /// Returns the queries to skip: their proofs never succeeded, or took more work than they saved. `work_of_a_state`
    /// is the work of computing the successors of one state.
    [[nodiscard]] ProofPlan plan(double work_of_a_state) const;

private:
    using Key = std::pair<Slots, Slots>;
    [[nodiscard]] bool leads_to_proofs(const Key& key, double work_of_a_state) const;

    std::map<Key, Sum> sums_;
};

/// Returns true if the event of the rule permits following its steps: in all regions of the rule, the event must have
/// the first level or no level (condition 1).
[[nodiscard]] bool is_candidate(const WholeRule& rule, lts::Followed followed);

/// Proves that steps are confluent, and caches the results. A proof only uses the rule of the step and the states of
/// the components that its query tracks. So the order of queries does not change an answer.
class Confluence {
public:
    /// `plan` must come from a system with the same rules. The plan affects which steps are followed.
    Confluence(std::shared_ptr<const Supercombinator> combined, std::shared_ptr<const WholeRules> rules,
               lts::Followed followed, ProofPlan plan);
    Confluence(const Confluence&) = delete;
    Confluence& operator=(const Confluence&) = delete;
    ~Confluence();

    /// Performs the first step from `state` that is proved to be confluent. `state` contains the states of all
    /// components. Returns false if there is no such step.
    bool follow_step(std::span<Local> state);
    /// Adds the work and the results of all proofs so far to the record.
    void add_to(ProofRecord&) const;
    /// Returns the work so far. The unit is the same as for `work_of_a_state`.
    [[nodiscard]] double total_work() const;

private:
    using RuleNumber = std::uint32_t;
    /// The states of all components. Only the states of tracked components are read.
    using Locals = std::span<const Local>;
    /// For a set of tracked components: the rules in which they perform an event. Each rule is listed once, for
    /// one of these components and for its event in the rule. So a proof examines a rule only if that component
    /// can perform that event. The list for an event is computed when a proof first finds this event in a
    /// state.
    using Asking = std::vector<std::unordered_map<std::uint32_t, std::vector<RuleNumber>>>;
    /// A query (is the rule confluent if only these components are known?), with the statistics of its proofs.
    struct Tracked {
        RuleNumber rule = 0;
        Slots slots;                         ///< ascending: the rule's parts, and further components
        std::vector<std::uint64_t> weights;  ///< weight of each component's state in keys
        std::vector<char> has;               ///< for each slot of the process: whether it is tracked
        Asking* asking = nullptr;            ///< the rules for these slots; null before the first proof
        std::uint64_t proofs = 0, looked = 0, rules = 0, used = 0;  ///< as in ProofRecord
        std::map<std::uint32_t, std::uint64_t> next;  ///< how often each other query followed a failed proof
    };
    /// The states to which other rules lead, and the rule for each of these states.
    struct Outcomes {
        std::vector<Local> states;  ///< states of all components, one after the other
        std::vector<RuleNumber> by;
        std::uint64_t rules = 0;  ///< number of rules examined
    };
    class Closure;

    void count_offers();
    void list_candidates(lts::Followed followed);
    const std::vector<RuleNumber>& candidates(std::uint32_t slot, Local local);
    [[nodiscard]] std::vector<RuleNumber> make_entry(std::uint32_t slot, Local local) const;
    [[nodiscard]] bool never_commutes(RuleNumber rule, std::uint32_t slot, Local local) const;
    bool is_confluent(RuleNumber rule, Locals state);
    std::uint32_t find_answer(std::uint32_t number, Locals state);
    std::uint32_t prove_answer(std::uint32_t number, std::uint64_t here, Locals state);
    void store_answer(std::uint32_t number, std::uint64_t key, std::uint32_t answer);
    std::uint32_t find_tracked_set(RuleNumber rule, Slots slots);
    std::uint32_t make_entry(RuleNumber rule, Slots slots);
    /// The next query after a failed proof, and how many rules were examined to find it.
    struct Next {
        std::uint32_t number;
        std::size_t rules;
    };
    Next find_larger_tracked_set(std::uint32_t number, const std::vector<RuleNumber>& others);
    [[nodiscard]] Slots parts_of(RuleNumber rule) const;
    const std::vector<RuleNumber>& rules_asking(const Tracked& tracked, std::size_t place, std::uint32_t event) const;
    [[nodiscard]] std::uint32_t rarest_component(const WholeRule& rule, const std::vector<char>& has) const;
    [[nodiscard]] static std::uint64_t state_key(const Tracked& tracked, Locals state);

    [[nodiscard]] bool holds_now(const Tracked& tracked, std::span<Local> state, Outcomes& next,
                                 std::optional<RuleNumber>& disturbing) const;
    [[nodiscard]] bool is_deterministic(const WholeRule& rule, Locals state) const;
    [[nodiscard]] bool cannot_fire(const WholeRule& other, const Tracked& tracked, Locals state) const;
    [[nodiscard]] bool commutes_with(const WholeRule& rule, const WholeRule& other, Locals state) const;
    [[nodiscard]] bool commutes_with(const Part& part, const Part& other, Local local) const;
    void add_outcomes(const Tracked& tracked, RuleNumber other, std::size_t place, std::span<Local> state,
                      Outcomes& next) const;
    [[nodiscard]] bool stays_unchanged(const Part& part, Local local) const;
    [[nodiscard]] const Component& component(std::uint32_t slot) const { return *combined_->components[slot]; }

    std::shared_ptr<const Supercombinator> combined_;
    std::shared_ptr<const WholeRules> rules_;
    ProofPlan plan_;
    // By slot and event: the fraction of the component's states in which the event is possible.
    std::vector<std::vector<double>> share_;
    std::vector<std::vector<std::vector<RuleNumber>>> leading_;  // by slot and event: the candidates listed for them
    // By slot and state: the index of the list in lists_, plus one. 0 if the list has not been made yet.
    std::vector<std::vector<std::uint32_t>> known_;
    std::vector<std::vector<RuleNumber>> lists_;
    std::deque<Tracked> tracked_;
    std::map<Slots, Asking> asking_;                                 // by slots
    std::vector<std::uint32_t> first_;                               // by rule: the query with which its proofs begin
    std::map<std::pair<RuleNumber, Slots>, std::uint32_t> numbers_;  // the number of a query
    std::uint64_t states_asked_ = 0, answers_asked_ = 0;
    AnswerTable answers_;               // by query number and key: `no`, `yes`, or the number of the next query
    std::unique_ptr<Closure> closure_;  // kept to reuse its memory
};

}  // namespace robochart::machine
