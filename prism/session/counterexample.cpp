// SPDX-License-Identifier: Apache-2.0
// Explains violated bounds. See counterexample.hpp. An upper bound is violated if the formula is too likely, and a
// lower bound if its negation is too likely. Both are reachability probabilities (docs/probability.md,
// "Counterexamples"): `left U right` is too unlikely if paths to states from which it has probability 0 are too likely.
#include "prism/session/counterexample.hpp"

#include <algorithm>

#include "prism/explore/question_numbers.hpp"
#include "prism/markov/graph/qualitative.hpp"
#include "prism/markov/operators/unbounded.hpp"
#include "prism/markov/paths/probable_paths.hpp"

namespace robochart::prism {
namespace {

constexpr std::uint64_t most_sweeps = 1'000'000;

markov::Precision with_strategy(const EvaluatorOptions& options) {
    return {options.relative, most_sweeps, options.budget, true};
}

/// Returns the chain in which every state takes its choice of a strategy.
markov::Model induced_chain(const markov::Model& model, const std::vector<std::uint32_t>& strategy) {
    markov::Model chain;
    chain.initial = model.initial;
    chain.numbers = model.numbers;
    chain.first_choice.push_back(0);
    chain.first_branch.push_back(0);
    for (const std::uint32_t choice : strategy) {
        for (std::uint64_t i = model.first_branch[choice]; i < model.first_branch[choice + 1]; ++i) {
            chain.target.push_back(model.target[i]);
            chain.number.push_back(model.number[i]);
        }
        chain.first_branch.push_back(chain.target.size());
        chain.first_choice.push_back(static_cast<std::uint32_t>(chain.choices()));
    }
    return chain;
}

/// Describes paths with the names of the model.
class PathDescriber {
public:
    PathDescriber(const StateSpace& space, const std::vector<std::uint32_t>& strategy)
        : space_(space), strategy_(strategy), reader_(space) {}

    ProbablePath operator()(const markov::Path& path) {
        ProbablePath result;
        result.from = space_.state_text(path.states.front());
        result.probability = path.probability;
        for (std::size_t i = 1; i < path.states.size(); ++i) {
            const markov::State before = path.states[i - 1];
            const markov::State after = path.states[i];
            result.steps.push_back(
                {reader_.list_moves(before, strategy_[before], after),
                 space_.layout().changes_text(state_values(before).data(), state_values(after).data()),
                 space_.state_text(after)});
        }
        return result;
    }

private:
    [[nodiscard]] std::vector<std::int32_t> state_values(markov::State state) const {
        std::vector<std::int32_t> result(space_.layout().fields().size());
        space_.unpack(state, result.data());
        return result;
    }

    const StateSpace& space_;
    const std::vector<std::uint32_t>& strategy_;
    MoveReader reader_;
};

/// The event that is too likely: `left U right` within the steps.
struct Event {
    markov::StateSet left, right;
    std::optional<std::uint64_t> steps;
    Real bound;
    bool strict = true;
};

class Explainer {
public:
    Explainer(const StateSpace& space, Code& code, const EvaluatorOptions& options)
        : space_(space), code_(code), options_(options), evaluator_(space, code, options) {}

    std::optional<Counterexample> operator()(const Expr& question) {
        if (question.op != Op::probability || !question.query->bound) return std::nullopt;
        const Expr& body = *question.parts[0];
        const bool formula = is_temporal(body.op) && body.op != Op::next &&
                             std::ranges::none_of(body.parts, [](const auto& p) { return is_path(*p); });
        if (!formula) return std::nullopt;
        const Op relation = question.query->relation;
        const bool upper = relation == Op::less || relation == Op::less_equal;
        Reachability reach = evaluator_.reachability(body);
        Counterexample result;
        result.holds = upper;
        result.never = upper == reach.negated;
        result.scheduled = space_.chain().kind == markov::Kind::mdp;
        const StepRange steps = body.steps ? step_range(*body.steps, code_) : StepRange{};
        if (steps.from > 0 || (steps.to && (result.never || result.scheduled))) return std::nullopt;
        choose_strategy(reach, result);
        const Real bound = bound_of(question, code_);
        Event event{std::move(reach.left), std::move(reach.right), steps.to,
                    upper ? bound : Real(std::int64_t{1}) - bound,
                    relation == Op::less_equal || relation == Op::greater_equal};
        if (result.never) replace_by_avoidance(event);
        search(event, result);
        return result.count == 0 ? std::nullopt : std::optional(std::move(result));
    }

    /// Returns a scheduler that attains the value of a query.
    std::vector<std::uint32_t> best_strategy(const Expr& question) {
        constexpr const char* supported =
            "a strategy exists for P [ F, G, U, W, R ], R [ F ] and R [ C ] without steps";
        if (question.op != Op::probability && question.op != Op::reward) throw Undecided(supported);
        const Expr& body = *question.parts[0];
        const markov::Direction direction = direction_of(*question.query);
        if (question.op == Op::probability && !body.steps && is_path(body)) {
            const Reachability reach = evaluator_.reachability(body);
            return until_strategy(reach, (direction == markov::Direction::minimum) == reach.negated);
        }
        if (question.op == Op::reward && (body.op == Op::total || (body.op == Op::eventually && !body.steps))) {
            const markov::Rewards rewards = space_.rewards(reward_index(*question.query, space_.model(), code_), false);
            return body.op == Op::total
                       ? total_reward(space_.chain(), rewards, direction, with_strategy(options_)).strategy
                       : reachability_reward(space_.chain(), rewards, evaluator_.states_satisfying(body.parts[0]),
                                             direction, with_strategy(options_))
                             .strategy;
        }
        throw Undecided(supported);
    }

private:
    std::vector<std::uint32_t> until_strategy(const Reachability& reach, bool greatest) {
        return markov::until(space_.chain(), reach.left, reach.right,
                             greatest ? markov::Direction::maximum : markov::Direction::minimum,
                             with_strategy(options_))
            .strategy;
    }

    /// Chooses the scheduler under which the event is most likely.
    void choose_strategy(const Reachability& reach, const Counterexample& result) {
        const auto& first = space_.chain().first_choice;
        strategy_.assign(first.begin(), first.end() - 1);
        if (result.scheduled) strategy_ = until_strategy(reach, !result.never);
    }

    /// Replaces the event by its opposite: to reach states in which the event has become impossible.
    void replace_by_avoidance(Event& event) const {
        const markov::Model chain = induced_chain(space_.chain(), strategy_);
        markov::StateSet never = prob0a(markov::Graph(chain), event.left, event.right);
        event.left = std::move(event.right);
        event.left.flip();
        event.right = std::move(never);
    }

    void search(const Event& event, Counterexample& result) const {
        const markov::Graph graph(space_.chain());
        PathDescriber describe(space_, strategy_);
        result.bound = event.bound;
        result.strict = event.strict;
        for (const markov::State initial : space_.chain().initial) {
            const markov::PathSet found =
                markov::probable_paths({graph, strategy_, event.left, event.right, initial, event.steps,
                                        event.bound.bounds().high, event.strict, most_paths, options_.budget});
            if (result.count > 0 && !found.enough) continue;
            result.count = found.paths.size();
            result.total = found.total;
            result.enough = found.enough;
            result.paths.clear();
            for (const markov::Path& path : found.paths)
                if (result.paths.size() < Counterexample::most_kept) result.paths.push_back(describe(path));
            if (result.enough) return;
        }
    }

    static constexpr std::size_t most_paths = 10'000;
    const StateSpace& space_;
    Code& code_;
    const EvaluatorOptions& options_;
    Evaluator evaluator_;
    std::vector<std::uint32_t> strategy_;
};

}  // namespace

std::optional<Counterexample> counterexample(const StateSpace& space, Code& code, const ExprPtr& question,
                                             const EvaluatorOptions& options) {
    return Explainer(space, code, options)(*question);
}

std::vector<std::uint32_t> best_choices(const StateSpace& space, Code& code, const ExprPtr& question,
                                        const EvaluatorOptions& options) {
    return Explainer(space, code, options).best_strategy(*question);
}

}  // namespace robochart::prism
