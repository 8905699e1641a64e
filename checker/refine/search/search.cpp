// SPDX-License-Identifier: Apache-2.0
// Searches the product level by level. If divergence matters, the search records taus that do not lead forward. The
// search for cycles begins with these taus and computes all other taus again.
#include "checker/refine/search/search.hpp"

#include <algorithm>
#include <stdexcept>

namespace robochart::refine {

using lts::StateIndex;
using lts::StateView;
using process::Event;

Search::Search(lts::TransitionSystem& system, Monitor& monitor, Budget& budget, bool note_taus, Pairs pairs)
    : system_(system),
      monitor_(monitor),
      budget_(budget),
      nodes_(!monitor.watches_states_only()),
      pairs_(system.width() + (nodes_ ? 1 : 0)),
      note_taus_(note_taus),
      expander_(system, monitor, pairs_) {
    if (pairs == Pairs::antichain) antichain_ = std::make_unique<Antichain>(system.width());
}

Search::~Search() {
    budget_.report_by({});
}

void Search::begin() {
    budget_.report_by([this](Progress& progress) {
        progress.states = pairs_.size();
        progress.transitions = transitions_;
        progress.frontier = pairs_.size() - expanded_;
        progress.depth = depth_;
    });
    std::vector<lts::Word> first(pairs_.width());
    if (nodes_) first[0] = monitor_.start();
    const std::uint64_t chased_before = system_.chased_state_count();
    system_.initial(std::span(first).subspan(nodes_ ? 1 : 0));
    chased_ += system_.chased_state_count() - chased_before;
    enter_pair(first, lts::StateStore::hash(first));
    ahead_ = system_.clone_for_thread() != nullptr;
}

void Search::follow_taus_alone() {
    taus_alone_ = true;
    expander_.follow_taus_alone();
    if (wide_) wide_->follow_taus_alone();
}

std::optional<Finding> Search::first_violation(std::uint64_t events_until) {
    begin();
    std::uint64_t level = 0;
    for (StateIndex first = 0; first != pairs_.size(); ++level) {
        if (level == events_until) follow_taus_alone();
        const auto end = static_cast<StateIndex>(pairs_.size());
        if (const std::optional<Finding> finding = search_level(first, end)) return finding;
        if (forbidden_) return forbidden_;
        if (pairs_.size() != end) ++depth_;
        first = end;
    }
    return std::nullopt;
}

std::optional<Finding> Search::search_level(StateIndex first, StateIndex end) {
    if (antichain_) return search_antichain_level(first, end);
    if (end - first >= budget_.wide_level() && several_threads()) return search_wide_level(first, end);
    return search_alone(first, end);
}

std::optional<Finding> Search::search_alone(StateIndex first, StateIndex end) {
    while (first != end) {
        expander_.expand(first, ahead_ ? end : first + 1, rows_at_once, expansion_);
        if (const std::optional<Finding> finding = enter_results(expansion_, first)) return finding;
        first += static_cast<StateIndex>(expansion_.pairs.size());
    }
    return std::nullopt;
}

/// Searches a level with an antichain. It skips pairs that another pair of this level or an earlier level covers. The
/// first pair of each state still adds its tau edges.
std::optional<Finding> Search::search_antichain_level(StateIndex first, StateIndex end) {
    std::vector<bool> needed;
    for (StateIndex pair = first; pair != end; ++pair) {
        const StateIndex number = antichain_->number_state(state(pair));
        needed.push_back(antichain_->first_pair(number) == pair ||
                         !antichain_->is_subsumed(number, node(pair), monitor_));
    }
    for (StateIndex pair = first; pair != end; ++pair) {
        if (!needed[pair - first]) {
            ++expanded_;
            parents_.add_expanded_state(0);
            continue;
        }
        expander_.expand(pair, pair + 1, 1, expansion_);
        if (const std::optional<Finding> finding = enter_results(expansion_, pair)) return finding;
    }
    return std::nullopt;
}

/// Returns true if several threads can be used. Starts them at the first wide level.
bool Search::several_threads() {
    if (!wide_ && !one_thread_ && budget_.threads() > 1)
        wide_ = ParallelLevel::create_if_supported(system_, monitor_, pairs_, budget_.threads());
    if (wide_ && taus_alone_) wide_->follow_taus_alone();
    one_thread_ = !wide_;
    return !one_thread_;
}

std::optional<Finding> Search::search_wide_level(StateIndex first, StateIndex end) {
    while (first != end) {
        const auto entering = note_taus_ ? ParallelLevel::Work::enter_note_taus : ParallelLevel::Work::enter;
        first = wide_->run(first, end, forbidden_ ? ParallelLevel::Work::examine : entering);
        for (std::size_t i = 0; i < wide_->size(); ++i) record_block((*wide_)[i]);
        budget_.states(pairs_.size());
        if (!wide_->has_stopped()) continue;
        const StateIndex next = std::min(end - first, ParallelLevel::pairs_at_once) + first;
        if (const std::optional<Finding> finding = search_alone(first, next)) return finding;
        first = next;
    }
    return std::nullopt;
}

/// Records the results of a block in the same way as those of single expansions.
void Search::record_block(const ParallelLevel::Block& block) {
    budget_.charge(block.pairs);
    budget_.between_states();
    expanded_ += block.pairs;
    transitions_ += block.transitions;
    chased_ += block.chased;
    if (!forbidden_) parents_.append(block.found);
    for (const StateIndex target : block.back_targets) back_taus_.add(target);
}

/// Enters the results of the pairs from `first` on.
std::optional<Finding> Search::enter_results(const Expansion& expansion, StateIndex first) {
    std::size_t row = 0;
    for (const Expansion::Pair& pair : expansion.pairs) {
        budget_.charge();
        budget_.between_states();
        ++expanded_;
        transitions_ += pair.transitions;
        chased_ += pair.chased;
        if (!forbidden_)
            insert(expansion, first, row, pair.end_row);  // after it, only the states of this level are examined
        row = pair.end_row;
        budget_.states(pairs_.size());
        if (pair.fault) return Finding{*pair.fault, first};
        if (pair.forbidden && !forbidden_) forbidden_ = Finding{ViolationKind::trace, first, *pair.forbidden};
        ++first;
    }
    if (expansion.error) std::rethrow_exception(expansion.error);
    return std::nullopt;
}

/// Inserts the targets of one pair. Their lines in the table have been prefetched. Their states are usually in the
/// processor's cache, because they have been found recently.
void Search::insert(const Expansion& expansion, StateIndex pair, std::size_t first, std::size_t end) {
    const std::optional<StateIndex> vertex = note_taus_ ? tau_vertex(pair) : std::nullopt;
    constexpr std::size_t between_counts = 4096;  // one pair may have any number of targets
    std::uint32_t found = 0;
    for (std::size_t i = first; i < end; ++i) {
        if ((i - first) % between_counts == between_counts - 1) budget_.states(pairs_.size());
        const lts::StateStore::Insertion insertion = enter_pair(expansion.row(i), expansion.hash(i));
        if (insertion.fresh) ++found;
        if (vertex && expansion.by_tau(i)) back_taus_.note_tau(*vertex, insertion.index);
    }
    parents_.add_expanded_state(found);
}

/// Looks up a pair, and enters it if it is new. With antichains the result contains the number of the state, because
/// divergence does not depend on the specification node.
lts::StateStore::Insertion Search::enter_pair(StateView row, std::uint64_t hash) {
    if (!antichain_) return pairs_.insert(row, hash);
    const StateIndex state = antichain_->number_state(row.subspan(1));
    if (pairs_.find(row, hash) != lts::no_state || antichain_->is_covered(state, row[0], monitor_))
        return {state, false};
    antichain_->enter_node(state, row[0], pairs_.insert(row, hash).index);
    return {state, true};
}

/// Returns the vertex of a pair in the graph of taus. Without an antichain, the vertex is the pair. With an antichain,
/// it is the state, but only for the first pair of this state.
std::optional<StateIndex> Search::tau_vertex(StateIndex pair) {
    if (!antichain_) return pair;
    const StateIndex number = antichain_->number_state(state(pair));
    return antichain_->first_pair(number) == pair ? std::optional(number) : std::nullopt;
}

namespace {

/// Finds a transition between two given pairs.
class StepFinder final : public lts::SuccessorSink {
public:
    StepFinder(Monitor& monitor, Monitor::Node from, Monitor::Node to, StateView target, bool only_tau)
        : monitor_(monitor), from_(from), to_(to), target_(target), only_tau_(only_tau) {}
    void add(Event event, StateView target, Event revealed) override {
        if (found || !std::equal(target.begin(), target.end(), target_.begin())) return;
        if (event == process::tau ? only_tau_ || from_ == to_ : leads_on(event))
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

/// Collects the rows to which taus lead. Their lines are prefetched before any row is looked up.
class Search::TauRows final : public lts::SuccessorSink {
public:
    TauRows(const lts::StateStore& pairs, std::optional<Monitor::Node> node) : pairs_(pairs), node_(node) {}
    void add(Event event, StateView target, Event /*revealed*/) override {
        if (event != process::tau) return;
        const std::size_t before = words.size();
        if (node_) words.push_back(*node_);
        words.insert(words.end(), target.begin(), target.end());
        hashes.push_back(lts::StateStore::hash(StateView(words).subspan(before)));
        pairs_.prefetch(hashes.back());
    }
    std::vector<lts::Word> words;
    std::vector<std::uint64_t> hashes;

private:
    const lts::StateStore& pairs_;
    std::optional<Monitor::Node> node_;
};

/// Appends the targets of the pair's taus. If the search has visited all pairs, all targets are in the store.
/// Otherwise, targets that are not in the store are left out.
void Search::tau_targets(StateIndex pair, std::vector<StateIndex>& targets) {
    budget_.charge();
    budget_.between_states();
    TauRows rows(pairs_, nodes_ ? std::optional(node(pair)) : std::nullopt);
    (cycle_system_ ? *cycle_system_ : system_).successors(state(pair), rows);
    for (std::size_t i = 0; i < rows.hashes.size(); ++i) {
        const StateView row = StateView(rows.words).subspan(i * pairs_.width(), pairs_.width());
        const StateIndex target =
            antichain_ ? antichain_->number_state(row.subspan(1)) : pairs_.find(row, rows.hashes[i]);
        if (target != lts::no_state) targets.push_back(target);
    }
}

GraphView Search::tau_graph() {
    if (!antichain_)
        return {pairs_.size(),
                [this](StateIndex pair, std::vector<StateIndex>& targets) { tau_targets(pair, targets); }};
    return {antichain_->size(), [this](StateIndex state, std::vector<StateIndex>& targets) {
                tau_targets(antichain_->first_pair(state), targets);
            }};
}

/// Leaves out taus that do not lie on cycles according to the rules of the system.
void Search::leave_out_acyclic_taus() {
    if (!budget_.limits().reduction) return;
    cycle_system_ = system_.make_cycle_system(budget_);
    if (cycle_system_) cycle_system_->set_budget(budget_);
}

std::optional<StateIndex> Search::first_tau_cycle() {
    leave_out_acyclic_taus();
    const std::optional<StateIndex> vertex = least_on_cycle(tau_graph(), back_taus_.list());
    return vertex && antichain_ ? std::optional(antichain_->first_pair(*vertex)) : vertex;
}

std::vector<StateIndex> Search::tau_cycle(StateIndex pair) {
    const GraphView graph = tau_graph();
    if (!antichain_) return shortest_cycle(graph, pair);
    std::vector<StateIndex> cycle = shortest_cycle(graph, antichain_->number_state(state(pair)));
    for (StateIndex& vertex : cycle) vertex = antichain_->first_pair(vertex);
    return cycle;
}

std::vector<StateIndex> Search::path_to(StateIndex pair) const {
    std::vector<StateIndex> path;
    for (; pair != 0; pair = parents_.parent(pair)) path.push_back(pair);
    path.push_back(0);
    std::ranges::reverse(path);
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
