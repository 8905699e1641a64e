// SPDX-License-Identifier: Apache-2.0
#include "tests/checker/refine/by_definition.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "tests/checker/processes/random_process.hpp"

namespace robochart::refine {
namespace {

using naive::Behaviour;
using naive::Letter;
using naive::Semantics;
using States = Behaviour::States;

unsigned bit_of(Letter letter) {
    return letter == naive::tick ? 1U : 1U << static_cast<unsigned>(letter + 1);
}

class RunByDefinition {
public:
    RunByDefinition(const Counterexample& counterexample, const Question& question, const Graphs& graphs, bool exactly,
                    const std::function<Letter(process::Event)>& letter)
        : counterexample_(counterexample),
          question_(question),
          exactly_(exactly),
          specification_(graphs.graphs[question.left], naive::letters_used),
          process_(graphs.graphs[question.right], naive::letters_used),
          letter_(letter) {}

    std::optional<std::string> wrong() {
        allowed_ = specification_.initially();
        at_ = exactly_ ? States{0} : process_.initially();
        for (const Step& step : counterexample_.steps)
            if (!take_letter(letter_(step.event))) return "has a run that the process does not have";
        if (!violates_specification()) return "has a run at whose end nothing is wrong";
        if (!counterexample_.shortest) return "has a run that is not a shortest one, without a limit";
        if (exactly_ && is_longer()) return "has no shortest run";
        return std::nullopt;
    }

private:
    bool refines() const { return question_.kind == Question::Kind::refinement; }

    bool take_letter(Letter letter) {
        before_ = allowed_;
        if (letter != naive::tau) {
            allowed_ = specification_.after(allowed_, letter);
            trace_.push_back(letter);
        }
        if (letter != naive::tau || exactly_) at_ = exactly_ ? targets(at_, letter) : process_.after(at_, letter);
        return !at_.empty();
    }

    States targets(const States& from, Letter letter) const {
        States result;
        for (const int state : from)
            for (const naive::Graph::Edge& edge : process_.graph().edges[static_cast<std::size_t>(state)])
                if (edge.letter == letter) result.insert(edge.target);
        return result;
    }

    bool violates_specification() const {
        const auto somewhere = [&](const auto& wrong) { return std::ranges::any_of(at_, wrong); };
        switch (counterexample_.kind) {
            case ViolationKind::trace:
                return refines() && allowed_.empty() && !before_.empty();
            case ViolationKind::refusal:
                return refines() && somewhere([&](int state) { return refuses_too_much(state); });
            case ViolationKind::divergence:
                return !(refines() && specification_.diverges(allowed_)) &&
                       somewhere([&](int state) { return process_.diverges({state}); });
            case ViolationKind::deadlock:
                return somewhere([&](int state) { return is_deadlocked(state); });
            case ViolationKind::nondeterminism:
                return is_nondeterministic();
            case ViolationKind::no_return:
            case ViolationKind::no_trace:
                return true;  // `expected` has already checked this violation
        }
        return false;
    }

    bool refuses_too_much(int state) const {
        for (unsigned set = 0; set < process_.refusal_sets(); ++set)
            if (process_.state_refuses(state, set) && !specification_.can_refuse(allowed_, set)) return true;
        return false;
    }
    bool is_deadlocked(int state) const { return process_.state_refuses(state, process_.refusal_sets() - 1); }

    bool is_on_loop(int state) const {
        States reached = targets({state}, naive::tau);
        for (std::size_t size = 0; size != reached.size();) {
            size = reached.size();
            const States more = targets(reached, naive::tau);
            reached.insert(more.begin(), more.end());
        }
        return reached.contains(state);
    }

    bool is_nondeterministic() const {
        if (!counterexample_.event) return false;
        const Letter letter = letter_(*counterexample_.event);
        States states = process_.initially();
        for (const Letter earlier : trace_) states = process_.after(states, earlier);
        return !process_.after(states, letter).empty() && process_.can_refuse(states, bit_of(letter));
    }

    /// Returns whether a shortest run is promised and this run is longer. A run to a tau loop may be shorter than in
    /// the naive graph. There, one state of the process may correspond to two states, one before the loop and one on
    /// it.
    bool is_longer() const {
        const std::size_t steps = counterexample_.steps.size();
        if (refines() && question_.semantics != Semantics::FD)
            return steps != naive::shortest_violation(specification_, process_, question_.semantics);
        if (question_.kind == Question::Kind::deadlock_free && question_.semantics == Semantics::F)
            return steps != distance([&](int state) { return is_deadlocked(state); });
        if (question_.kind == Question::Kind::divergence_free)
            return steps > distance([&](int state) { return is_on_loop(state); });
        return false;
    }

    std::optional<std::size_t> distance(const std::function<bool(int)>& is_goal) const {
        States level{0};
        States seen = level;
        for (std::size_t steps = 0; !level.empty(); ++steps) {
            if (std::ranges::any_of(level, is_goal)) return steps;
            States next;
            for (const int state : level)
                for (const naive::Graph::Edge& edge : process_.graph().edges[static_cast<std::size_t>(state)])
                    if (seen.insert(edge.target).second) next.insert(edge.target);
            level.swap(next);
        }
        return std::nullopt;
    }

    const Counterexample& counterexample_;
    const Question& question_;
    bool exactly_;
    Behaviour specification_, process_;
    const std::function<Letter(process::Event)>& letter_;
    States allowed_, before_;  // states of the specification, after the run and before its last step
    States at_;                // states of the process
    std::vector<Letter> trace_;
};

}  // namespace

std::optional<std::string> wrong_by_definition(const Counterexample& counterexample, const Question& question,
                                               const Graphs& graphs, bool exactly,
                                               const std::function<naive::Letter(process::Event)>& letter) {
    return RunByDefinition(counterexample, question, graphs, exactly, letter).wrong();
}

}  // namespace robochart::refine
