// The product search. One pass over the successors of each pair inserts the targets, gathers the offer for the
// monitor, and, where divergence matters, keeps the tau edges for the cycle search afterwards.
#include "checker/refine/search.hpp"

#include <algorithm>
#include <stdexcept>

#include "checker/refine/tau_cycle.hpp"

namespace robochart::refine {

using lts::StateIndex;
using lts::StateView;
using process::Event;

Search::Search(lts::TransitionSystem& system, Monitor& monitor, Budget& budget, bool keep_taus)
    : system_(system),
      monitor_(monitor),
      budget_(budget),
      pairs_(system.width() + 1),
      keep_taus_(keep_taus),
      buffer_(system.width() + 1) {}

void Search::begin() {
    buffer_[0] = monitor_.start();
    system_.initial(std::span(buffer_).subspan(1));
    pairs_.insert(buffer_);
    parents_.push_back(lts::no_state);
}

std::optional<Finding> Search::first_violation() {
    begin();
    std::size_t level_end = pairs_.size();
    for (StateIndex pair = 0; pair < pairs_.size(); ++pair) {
        if (pair == level_end) {
            if (forbidden_) return forbidden_;
            level_end = pairs_.size();
            ++depth_;
        }
        if (const std::optional<Finding> finding = expand(pair)) return finding;
    }
    if (keep_taus_) first_tau_.push_back(tau_targets_.size());
    return forbidden_;
}

std::optional<Finding> Search::expand(StateIndex pair) {
    budget_.charge();
    current_ = pair;
    offer_.tau = false;
    offer_.events.clear();
    if (keep_taus_) first_tau_.push_back(tau_targets_.size());
    system_.successors(state(pair), *this);
    budget_.states(pairs_.size());
    std::sort(offer_.events.begin(), offer_.events.end());
    offer_.events.erase(std::unique(offer_.events.begin(), offer_.events.end()), offer_.events.end());
    if (const std::optional<ViolationKind> kind = monitor_.examine(node(pair), offer_)) return Finding{*kind, pair};
    return std::nullopt;
}

void Search::add(Event event, StateView target, Event /*revealed*/) {
    ++transitions_;
    if (event == process::tau) {
        offer_.tau = true;
        visit(node(current_), target, event);
        return;
    }
    if (offer_.events.empty() || offer_.events.back() != event) offer_.events.push_back(event);
    if (forbidden_) return;
    const Monitor::Advance next = monitor_.advance(node(current_), event);
    if (next.effect == Monitor::Effect::violation) forbidden_ = Finding{ViolationKind::trace, current_, event};
    if (next.effect == Monitor::Effect::follow) visit(next.node, target, event);
}

void Search::visit(Monitor::Node node, StateView target, Event event) {
    if (forbidden_) return;  // only this level's states are still examined
    buffer_[0] = node;
    std::copy(target.begin(), target.end(), buffer_.begin() + 1);
    const lts::StateStore::Insertion insertion = pairs_.insert(buffer_);
    if (insertion.fresh) parents_.push_back(current_);
    if (keep_taus_ && event == process::tau) tau_targets_.push_back(insertion.index);
}

namespace {

GraphView tau_graph(const lts::ChunkedVector<std::uint64_t>& first, const lts::ChunkedVector<StateIndex>& targets) {
    return {first.size() - 1, [&](StateIndex vertex, std::size_t i) {
                const std::uint64_t place = first[vertex] + i;
                return place < first[vertex + 1U] ? targets[place] : lts::no_state;
            }};
}

/// Finds the transition between two given pairs.
class StepFinder final : public lts::SuccessorSink {
public:
    StepFinder(Monitor& monitor, Monitor::Node from, Monitor::Node to, StateView target, bool only_tau)
        : monitor_(monitor), from_(from), to_(to), target_(target), only_tau_(only_tau) {}
    void add(Event event, StateView target, Event revealed) override {
        if (found || !std::equal(target.begin(), target.end(), target_.begin())) return;
        if (event == process::tau ? from_ == to_ : leads_on(event))
            found = RunStep{event, revealed, {target.begin(), target.end()}};
    }
    std::optional<RunStep> found;

private:
    bool leads_on(Event event) {
        if (only_tau_) return false;
        const Monitor::Advance next = monitor_.advance(from_, event);
        return next.effect == Monitor::Effect::follow && next.node == to_;
    }
    Monitor& monitor_;
    Monitor::Node from_;
    Monitor::Node to_;
    StateView target_;
    bool only_tau_;
};

}  // namespace

std::optional<StateIndex> Search::first_tau_cycle() {
    return least_on_cycle(tau_graph(first_tau_, tau_targets_));
}

std::vector<StateIndex> Search::tau_cycle(StateIndex pair) {
    return shortest_cycle(tau_graph(first_tau_, tau_targets_), pair);
}

std::vector<StateIndex> Search::path_to(StateIndex pair) const {
    std::vector<StateIndex> path;
    for (; pair != lts::no_state; pair = parents_[pair]) path.push_back(pair);
    std::reverse(path.begin(), path.end());
    return path;
}

Run Search::run_along(const std::vector<StateIndex>& pairs, bool by_taus_alone) {
    const StateView first = state(pairs.front());
    Run run{{first.begin(), first.end()}, {}};
    for (std::size_t i = 1; i < pairs.size(); ++i) {
        StepFinder finder(monitor_, node(pairs[i - 1]), node(pairs[i]), state(pairs[i]), by_taus_alone);
        system_.successors(state(pairs[i - 1]), finder);
        if (!finder.found) throw std::logic_error("a step of the search cannot be taken again");
        run.steps.push_back(std::move(*finder.found));
    }
    return run;
}

}  // namespace robochart::refine
