// All histories in which a few rules are obeyed as long as they can be, as a transition system. A state in which one
// rule demands, at the latest now, what the others forbid has no successors: the search for deadlocks finds the
// conflict.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "checker/lts/transition_system.hpp"
#include "sleec/obligations/open.hpp"
#include "sleec/obligations/samples.hpp"

namespace robochart::sleec {

/// An event with the values that the measures have at it.
struct Occurrence {
    std::size_t event = 0;
    Sample sample;
};

/// An obligation of one of the rules of a question.
struct OpenObligation {
    std::size_t rule = 0;  ///< its place in the question
    std::size_t kind = 0;  ///< its place among the obligations of the rule
    Progress progress;

    friend auto operator<=>(const OpenObligation&, const OpenObligation&) = default;
};

/// What a question is about: rules, what they can ask for, and the events that matter.
struct Question {
    std::vector<std::size_t> rules;                    ///< of the file: those judged, then assumptions
    std::size_t judged = 0;                            ///< how many are judged
    std::vector<std::vector<Obligation>> obligations;  ///< of each rule, all that some sample gives
    std::vector<Occurrence> occurrences;               ///< of each event that a rule names

    [[nodiscard]] const Obligation& of(const OpenObligation& open) const { return obligations[open.rule][open.kind]; }
    /// The obligation that an occurrence opens; nothing if it opens none.
    [[nodiscard]] std::optional<OpenObligation> opened(const Occurrence& occurrence, std::size_t rule) const;
};
/// About these rules; assumptions of the file are obeyed too. Throws NotDecided.
[[nodiscard]] Question make_question(const CheckedRules& rules, std::vector<std::size_t> judged, WithoutLimit,
                                     diagnostics::Budget* budget);

/// Obligations that cannot all be kept: `due` has to be fulfilled now at the latest, and each of its demands that is
/// left is forbidden by another.
struct Clash {
    OpenObligation due;
    std::vector<std::size_t> events;  ///< of its demands
    std::vector<OpenObligation> by;   ///< what forbids each
};
/// A clash at this instant in which all rules have part that are judged.
[[nodiscard]] std::optional<Clash> clash(const Question& question, const std::vector<OpenObligation>& open);

/// Few occurrences come unasked (`unasked_occurrences`); every other fulfils an open obligation. That loses no
/// conflict: of a history with one, keep the triggers of the obligations that clash, what broke prohibitions among
/// their alternatives, and then, again and again, the occurrence that first fulfilled an obligation of an occurrence
/// that is kept. Every obligation that is left has the fate that it had.
class RuleSystem final : public lts::TransitionSystem {
public:
    explicit RuleSystem(const Question& question);

    [[nodiscard]] std::size_t width() const override;
    void initial(std::span<lts::Word> state) override;
    void successors(lts::StateView state, lts::SuccessorSink& sink) override;
    [[nodiscard]] const lts::EventTable& events() const override { return events_; }
    [[nodiscard]] std::string describe(lts::StateView) const override { return ""; }

    /// Nothing for a tock; else the occurrence.
    [[nodiscard]] std::optional<std::size_t> occurrence(lts::Event event) const;
    [[nodiscard]] bool is_tock(lts::Event event) const { return event == tock_; }
    /// Whether some of the rules clash in this state.
    [[nodiscard]] bool some_clash(lts::StateView state) const;
    /// States were left out because a rule would have had too many obligations open at once: a search that finds no
    /// conflict proves nothing then.
    [[nodiscard]] bool left_out() const { return left_out_; }

private:
    struct State {
        std::uint32_t unasked = 0;  ///< occurrences that may still come unasked
        std::vector<OpenObligation> open;
    };
    [[nodiscard]] State unpack(lts::StateView state) const;
    void add(const State& state, lts::Event event, lts::SuccessorSink& sink);
    void take(const State& state, std::size_t occurrence, lts::SuccessorSink& sink);
    void tock(const State& state, lts::SuccessorSink& sink);
    void simplify(std::vector<OpenObligation>& open) const;
    [[nodiscard]] bool dominated(const OpenObligation& a, const OpenObligation& b) const;

    const Question& question_;
    lts::EventTable events_;
    lts::Event tock_ = 0;
    lts::Event aside_ = 0;
    std::vector<lts::Event> names_;  ///< of each occurrence
    bool left_out_ = false;
};

/// The most events one of which must come at one and the same last instant; at least 1.
[[nodiscard]] std::size_t last_alternatives(const std::vector<Obligation>& obligations);
/// A trigger for the duty that clashes, and one for each of its last alternatives, which forbids it; for each of these
/// duties an occurrence for each prohibition that may be broken because there is another alternative.
[[nodiscard]] std::size_t unasked_occurrences(const Question& question);

}  // namespace robochart::sleec
