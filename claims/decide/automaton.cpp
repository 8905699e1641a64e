// SPDX-License-Identifier: Apache-2.0
// See automaton.hpp.
#include "claims/decide/automaton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace robochart::claims {
namespace {

constexpr std::size_t most_transitions = 200'000;

/// Explores a monitor, breadth first.
class Explorer {
public:
    explicit Explorer(const CheckedClaim& claim) : monitor_(claim) {}

    Automaton explore(const std::vector<Letter>& letters, diagnostics::Budget* budget) {
        const MonitorState begin = monitor_.begin();
        if (begin.verdict != Verdict::open) throw NotDecided("the start alone decides the claim");
        (void)number_of(begin);
        for (std::size_t at = 0; at < states_.size(); ++at) {
            if (budget != nullptr) budget->poll();
            if ((states_.size() + 1) * (letters.size() + 1) > most_transitions)
                throw NotDecided(
                    fmt::format("the claim has more than {} situations: its numbers are too large", states_.size()));
            automaton_.push_back(successors_of(states_[at], letters));
        }
        return std::move(automaton_);
    }

private:
    std::optional<std::size_t> number_of(const MonitorState& state) {
        if (state.verdict != Verdict::open) return std::nullopt;
        const auto [known, added] = numbers_.try_emplace(state, states_.size());
        if (added) states_.push_back(state);
        return known->second;
    }

    /// A copy of the state, because new states are added meanwhile.
    AutomatonState successors_of(const MonitorState state, const std::vector<Letter>& letters) {
        AutomatonState result;
        for (const Letter& letter : letters) {
            MonitorState next = state;
            if (letter.facts.empty())
                monitor_.observe(next, letter.occurrence);
            else
                monitor_.observe(next, letter.facts);
            result.by_letter.push_back(number_of(next));
            result.serves.push_back(letter.facts.empty() ? monitor_.serves(state, letter.occurrence)
                                                         : monitor_.serves(state, letter.facts));
        }
        MonitorState later = state;
        monitor_.tock(later);
        result.by_tock = number_of(later);
        MonitorState ended = state;
        monitor_.end(ended);
        result.may_end = ended.verdict == Verdict::open;
        result.owes = monitor_.owes(state);
        result.judges = monitor_.judges_facts(state);
        return result;
    }

    Monitor monitor_;
    std::map<MonitorState, std::size_t> numbers_;
    std::vector<MonitorState> states_;
    Automaton automaton_;
};

}  // namespace

bool AutomatonState::asks() const {
    return judges || !may_end || !by_tock || std::ranges::any_of(by_letter, [](const auto& next) { return !next; });
}

Automaton make_automaton(const CheckedClaim& claim, const std::vector<Letter>& letters, diagnostics::Budget* budget) {
    try {
        return Explorer(claim).explore(letters, budget);
    } catch (const NotComputable& error) {
        throw NotDecided(error.what());
    }
}

}  // namespace robochart::claims
