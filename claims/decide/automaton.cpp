// SPDX-License-Identifier: Apache-2.0
// See automaton.hpp.
#include "claims/decide/automaton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace robochart::claims {
namespace {

constexpr std::size_t most_transitions = 200'000;

/// A state of the monitor, and the inputs of this cycle that it has not observed yet, as numbers of letters.
struct Situation {
    MonitorState monitor;
    std::vector<std::size_t> raised;

    friend auto operator<=>(const Situation&, const Situation&) = default;
};

/// Explores a monitor, breadth first.
class Explorer {
public:
    Explorer(const CheckedClaim& claim, const std::vector<Letter>& letters) : monitor_(claim), letters_(letters) {}

    /// Makes the explorer collect the inputs of each cycle.
    void collect_inputs(const CheckedClaim& claim, const std::vector<DroppedChannel>& drops) {
        for (const Letter& letter : letters_)
            collected_.push_back(letter.facts.empty() &&
                                 claim.component.channels[letter.occurrence.channel].kind == ChannelKind::input);
        drops_ = drops;
    }

    Automaton explore(diagnostics::Budget* budget) {
        const MonitorState begin = monitor_.begin();
        if (begin.verdict != Verdict::open) throw NotDecided("the start alone decides the claim");
        (void)number_of({begin, {}});
        for (std::size_t at = 0; at < states_.size(); ++at) {
            if (budget != nullptr) budget->poll();
            if ((states_.size() + 1) * (letters_.size() + 1) > most_transitions)
                throw NotDecided(
                    fmt::format("the claim has more than {} situations: its numbers are too large", states_.size()));
            automaton_.push_back(successors_of(states_[at]));
        }
        return std::move(automaton_);
    }

private:
    std::optional<std::size_t> number_of(const Situation& state) {
        if (state.monitor.verdict != Verdict::open) return std::nullopt;
        const auto [known, added] = numbers_.try_emplace(state, states_.size());
        if (added) states_.push_back(state);
        return known->second;
    }

    /// Returns the state of the automaton with its successors. `state` is a copy, because new states are added
    /// meanwhile.
    AutomatonState successors_of(const Situation state) {
        AutomatonState result;
        const MonitorState now = after_inputs(state);
        for (std::size_t number = 0; number < letters_.size(); ++number) {
            const Letter& letter = letters_[number];
            result.by_letter.push_back(number_of(after_letter(state, now, number)));
            result.serves.push_back(letter.facts.empty() ? monitor_.serves(now, letter.occurrence)
                                                         : monitor_.serves(now, letter.facts));
        }
        MonitorState later = now;
        monitor_.tock(later);
        result.by_tock = number_of({later, {}});
        MonitorState ended = now;
        monitor_.end(ended);
        result.may_end = ended.verdict == Verdict::open;
        result.owes = monitor_.owes(now);
        result.judges = monitor_.judges_facts(now);
        return result;
    }

    /// Returns the situation after a letter. `now` is the state of the monitor after it has observed the collected
    /// inputs.
    [[nodiscard]] Situation after_letter(const Situation& state, const MonitorState& now, std::size_t number) const {
        if (!collected_.empty() && collected_[number]) {
            Situation next = state;
            const auto place = std::ranges::lower_bound(next.raised, number);
            if (place == next.raised.end() || *place != number) next.raised.insert(place, number);
            return next;
        }
        MonitorState next = now;
        if (letters_[number].facts.empty())
            monitor_.observe(next, letters_[number].occurrence);
        else
            monitor_.observe(next, letters_[number].facts);
        return {next, {}};
    }

    /// Returns the state of the monitor after it has observed the inputs of a cycle. Inputs that a raised input drops
    /// are left out.
    [[nodiscard]] MonitorState after_inputs(const Situation& state) const {
        std::vector<Occurrence> raised;
        for (const std::size_t number : state.raised) raised.push_back(letters_[number].occurrence);
        for (const DroppedChannel& drop : drops_)
            if (std::ranges::find(raised, drop.event, &Occurrence::channel) != raised.end())
                std::erase_if(raised, [&](const Occurrence& event) { return event.channel == drop.dropped; });
        MonitorState result = state.monitor;
        for (const Occurrence& event : monitor_.order_raised(result, raised)) monitor_.observe(result, event);
        return result;
    }

    Monitor monitor_;
    const std::vector<Letter>& letters_;
    std::vector<bool> collected_;  ///< index: the letter; empty if inputs are not collected
    std::vector<DroppedChannel> drops_;
    std::map<Situation, std::size_t> numbers_;
    std::vector<Situation> states_;
    Automaton automaton_;
};

Automaton explore(Explorer& explorer, diagnostics::Budget* budget) {
    try {
        return explorer.explore(budget);
    } catch (const NotComputable& error) {
        throw NotDecided(error.what());
    }
}

}  // namespace

bool AutomatonState::asks() const {
    return judges || !may_end || !by_tock || std::ranges::any_of(by_letter, [](const auto& next) { return !next; });
}

Automaton make_automaton(const CheckedClaim& claim, const std::vector<Letter>& letters, diagnostics::Budget* budget) {
    Explorer explorer(claim, letters);
    return explore(explorer, budget);
}

Automaton make_cycle_automaton(const CheckedClaim& claim, const std::vector<Letter>& letters,
                               const std::vector<DroppedChannel>& drops, diagnostics::Budget* budget) {
    Explorer explorer(claim, letters);
    explorer.collect_inputs(claim, drops);
    return explore(explorer, budget);
}

}  // namespace robochart::claims
