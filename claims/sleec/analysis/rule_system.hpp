// SPDX-License-Identifier: Apache-2.0
// Defines a transition system of all histories in which some rules are obeyed until they are in conflict. A state has
// no successors if one rule demands an event now at the latest, and the other rules forbid this event. Therefore, the
// search for deadlocks finds conflicts.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "checker/lts/transition_system.hpp"
#include "claims/sleec/obligations/open.hpp"
#include "claims/sleec/obligations/samples.hpp"

namespace robochart::sleec {

/// An event with the values of the measures.
struct Occurrence {
    std::size_t event = 0;
    Sample sample;
};

/// An open obligation of one of the rules of a question.
struct OpenObligation {
    std::size_t rule = 0;  ///< index in the question
    std::size_t kind = 0;  ///< index among the obligations of the rule
    Progress progress;

    friend auto operator<=>(const OpenObligation&, const OpenObligation&) = default;
};

/// The subject of a question: rules, their possible obligations, and the relevant events.
struct Question {
    std::vector<std::size_t> rules;  ///< numbers in the file: judged rules, then assumptions
    std::size_t judged = 0;          ///< number of rules that are judged, that is, must take part in a conflict
    std::vector<std::vector<Obligation>> obligations;  ///< for each rule, the obligations of all samples
    std::vector<Occurrence> occurrences;               ///< one or more for each event that a rule names

    [[nodiscard]] const Obligation& find_obligation(const OpenObligation& open) const {
        return obligations[open.rule][open.kind];
    }
    /// Returns the obligation that an occurrence opens; no value if it opens none.
    [[nodiscard]] std::optional<OpenObligation> opened_by(const Occurrence& occurrence, std::size_t rule) const;
};
/// Makes the question about these rules. The assumptions of the file must be obeyed, too. Throws NotDecided.
[[nodiscard]] Question make_question(const CheckedRules& rules, std::vector<std::size_t> judged, WithoutLimit,
                                     diagnostics::Budget* budget);

/// Obligations that cannot all be fulfilled: `due` must be fulfilled now at the latest, and each of its remaining
/// demands is forbidden by another obligation.
struct Clash {
    OpenObligation due;
    std::vector<std::size_t> events;  ///< the events of its demands
    std::vector<OpenObligation> by;   ///< the obligation that forbids each event
};
/// Returns a clash at this instant in which all judged rules take part; no value if there is none.
[[nodiscard]] std::optional<Clash> find_clash(const Question& question, const std::vector<OpenObligation>& open);

/// The transition system of a question. Only a few occurrences are spontaneous (`unasked_occurrences`); every other
/// occurrence fulfils an open obligation. All conflicts are still found, for the following reason. From a history with
/// a conflict, select the triggers of the clashing obligations, and the events that broke prohibitions among their
/// alternatives. Then repeatedly select the occurrence that first fulfilled an obligation of a selected occurrence. In
/// the history of the selected occurrences, every obligation has the same outcome as before.
class RuleSystem final : public lts::TransitionSystem {
public:
    explicit RuleSystem(const Question& question);

    [[nodiscard]] std::size_t width() const override;
    void initial(std::span<lts::Word> state) override;
    void successors(lts::StateView state, lts::SuccessorSink& sink) override;
    [[nodiscard]] const lts::EventTable& events() const override { return events_; }
    [[nodiscard]] std::string describe(lts::StateView) const override { return ""; }

    /// Returns the occurrence of an event; no value for a tock.
    [[nodiscard]] std::optional<std::size_t> occurrence_of(lts::Event event) const;
    [[nodiscard]] bool is_tock(lts::Event event) const { return event == tock_; }
    /// True if some of the rules clash in this state.
    [[nodiscard]] bool some_clash(lts::StateView state) const;
    /// True if states were omitted because a rule would have too many open obligations. A search that finds no conflict
    /// is then not a proof.
    [[nodiscard]] bool left_out() const { return left_out_; }

private:
    struct State {
        std::uint32_t unasked = 0;  ///< remaining spontaneous occurrences
        std::vector<OpenObligation> open;
    };
    [[nodiscard]] State unpack_state(lts::StateView state) const;
    void add(const State& state, lts::Event event, lts::SuccessorSink& sink);
    void add_event_successor(const State& state, std::size_t occurrence, lts::SuccessorSink& sink);
    void add_tock_successor(const State& state, lts::SuccessorSink& sink);
    void remove_dominated(std::vector<OpenObligation>& open) const;
    [[nodiscard]] bool is_dominated(const OpenObligation& a, const OpenObligation& b) const;

    const Question& question_;
    lts::EventTable events_;
    lts::Event tock_ = 0;
    lts::Event aside_ = 0;
    std::vector<lts::Event> names_;  ///< the event of each occurrence
    bool left_out_ = false;
};

/// Returns the largest number of alternative events in an obligation whose windows end at the same instant; at least 1.
[[nodiscard]] std::size_t last_alternatives(const std::vector<Obligation>& obligations);
/// Returns the number of spontaneous occurrences. One occurrence triggers the clashing duty. For each of the last
/// alternatives of this duty, another occurrence triggers a duty that forbids the alternative. For each of these
/// duties, one occurrence is added for each prohibition that may be broken because there is another alternative.
[[nodiscard]] std::size_t unasked_occurrences(const Question& question);

}  // namespace robochart::sleec
