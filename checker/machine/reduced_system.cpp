// SPDX-License-Identifier: Apache-2.0
#include "checker/machine/reduced_system.hpp"

#include <algorithm>
#include <cassert>

#include "checker/lts/sink_in_use.hpp"
#include "checker/lts/state_store.hpp"

namespace robochart::machine {

namespace {

/// Returns how many steps are followed at most. The last state then represents all states before it, so stopping
/// anywhere is correct. If steps with any event are followed, it should be possible to reach a cycle that contains
/// steps of all components: no deadlock can be reached from such a cycle. So the limit grows with the number of
/// components.
std::size_t most_steps(lts::Followed followed, std::size_t components) {
    constexpr std::size_t enough = 1000, for_each_component = 16;
    return followed == lts::Followed::taus ? enough : enough + for_each_component * components;
}
/// How many states each round of a pilot search expands. A round measures what the proofs save. The rounds after it
/// omit the least useful proofs.
constexpr std::size_t pilot_states[] = {200, 600, 2200};  // numbers of expanded states
constexpr std::size_t pilot_found = 200'000;              // maximal number of found states
/// No further round begins when steps have been followed from this many states: the measurement is then good enough. A
/// round with long sequences of steps could take longer than the search, which often ends early at a violation near the
/// initial state.
constexpr std::size_t pilot_followed = 20'000;
/// Limits the work of the proofs in a round: `round`, plus `step` for each state from which they follow a step. A round
/// that exceeds this ends early. Proofs about locks and schedulers often examine thousands of states before they fail.
struct Allowance {
    double round, step;
};
constexpr Allowance large_allowance{60'000, 2'000};  // the maximum for a pilot search
/// If the first pilot search saves nothing, a second one with the large allowance follows for processes of this size.
constexpr std::size_t states_for_large_allowance = 10'000;

/// Returns the allowance of the first pilot search. It is small compared with the search of a small process, and with
/// the compilation of large components.
Allowance first_allowance(const Supercombinator& combined) {
    constexpr double least_of_a_round = 8'000, of_an_edge = 0.5, of_a_step = 200;
    double edges = 0;
    for (const ComponentPtr& component : combined.components) edges += static_cast<double>(component->edge_count());
    return {std::clamp(of_an_edge * edges, least_of_a_round, large_allowance.round), of_a_step};
}
/// A reduced search saves memory, so it may take this many times the work of a full search. The first round after which
/// enough states have been expanded decides whether it does.
constexpr double most_work = 1.5;
constexpr std::size_t enough_to_judge = 1000;

/// Searches a sample of the states. Expands the last found state first (depth first), because breadth first would only
/// visit states near the initial state. Takes the successors of different states in different orders, which are the
/// same in every run.
class Pilot final : private lts::SuccessorSink {
public:
    explicit Pilot(std::size_t width) : found_(width), followed_(width) {}

    /// Expands up to this many further states. Returns false if the proofs took too much work, so that it ended early.
    bool expand_states(ReducedSystem& system, std::size_t states, const Allowance& allowance,
                       diagnostics::Pollable& budget) {
        if (found_.size() == 0) {
            std::vector<lts::Word> initial(system.width());
            system.initial(initial);
            open_.push_back(found_.insert(initial).index);
        }
        system.store_followed_states(followed_);
        const double proofs_before = system.work_of_proofs();
        const std::size_t followed_before = followed_.size();
        for (std::size_t i = 0; i < states && !open_.empty() && found_.size() + followed_.size() < pilot_found; ++i) {
            budget.poll();
            const auto followed = static_cast<double>(followed_.size() - followed_before);
            const double most = allowance.round + allowance.step * followed;
            if (system.work_of_proofs() - proofs_before > most) return false;
            const lts::StateIndex state = open_.back();
            open_.pop_back();
            const std::size_t before = open_.size();
            system.successors(found_[state], *this);
            const std::size_t fresh = open_.size() - before;
            const auto first = open_.begin() + static_cast<std::ptrdiff_t>(before);
            if (fresh != 0) std::rotate(first, first + static_cast<std::ptrdiff_t>(expanded_ * 7 % fresh), open_.end());
            ++expanded_;
        }
        return true;
    }
    [[nodiscard]] std::size_t expanded_count() const { return expanded_; }
    /// Returns from how many states a step was followed. Sequences of steps often meet, so more steps may have been
    /// followed.
    [[nodiscard]] std::size_t followed_count() const { return followed_.size(); }

private:
    void add(Event /*event*/, lts::StateView target, Event /*revealed*/) override {
        if (const auto [index, fresh] = found_.insert(target); fresh) open_.push_back(index);
    }

    lts::StateStore found_;
    lts::StateStore followed_;
    std::vector<lts::StateIndex> open_;
    std::size_t expanded_ = 0;
};

/// The rounds of a pilot search. Each round uses the plan that the earlier rounds have produced.
class PilotRounds {
public:
    PilotRounds(const std::shared_ptr<const Supercombinator>& combined, const process::TermStore& terms,
                const std::shared_ptr<const WholeRules>& rules, lts::Followed followed, const Allowance& allowance,
                diagnostics::Pollable& budget)
        : combined_(combined),
          terms_(terms),
          rules_(rules),
          followed_(followed),
          allowance_(allowance),
          budget_(budget),
          pilot_(combined->words) {}

    /// Returns the plan for a search. Returns no value if following steps takes more work than it saves.
    std::optional<ProofPlan> run() {
        for (const std::size_t states : pilot_states)
            if (pilot_.followed_count() >= pilot_followed || !run_round(states)) break;
        return worth_it_ ? std::optional(plan_) : std::nullopt;
    }

private:
    /// Runs a round that expands this many states. Returns false if there are no more states.
    bool run_round(std::size_t states) {
        constexpr double of_a_state = 5;  // in addition to the work for the steps of components
        begin_round();
        const std::size_t expanded_before = pilot_.expanded_count();
        const double proofs_before = reduced_->work_of_proofs();
        const std::size_t followed_before = pilot_.followed_count();
        const bool whole_round = pilot_.expand_states(*reduced_, states, allowance_, budget_);
        const std::size_t expanded = pilot_.expanded_count() - expanded_before;
        if (expanded == 0) return false;
        const double work = work_before_ + static_cast<double>(whole_->examined_step_count());
        const double work_of_a_state = of_a_state + work / static_cast<double>(pilot_.expanded_count());
        // Every followed step removes one state at most, namely its source.
        const auto remaining = static_cast<double>(expanded);
        const auto removed = static_cast<double>(pilot_.followed_count() - followed_before);
        const double without = (remaining + removed) * work_of_a_state;
        const double proofs = reduced_->work_of_proofs() - proofs_before;
        worth_it_ =
            (whole_round && expanded < enough_to_judge) || remaining * work_of_a_state + proofs <= most_work * without;
        ProofRecord record = record_;
        reduced_->add_to(record);
        ProofPlan plan = record.plan(work_of_a_state);
        if (plan == plan_) return true;
        record_ = std::move(record);
        work_before_ = work;
        plan_ = std::move(plan);
        reduced_ = nullptr;
        return true;
    }

    /// Prepares a round. If the plan has not changed since the previous round, the round reuses the cached answers.
    void begin_round() {
        if (reduced_) return;
        auto whole = std::make_unique<SupercombinatorSystem>(combined_, terms_);
        whole_ = whole.get();
        reduced_ = std::make_unique<ReducedSystem>(std::move(whole), combined_, rules_, followed_, plan_);
        reduced_->set_budget(budget_);
    }

    const std::shared_ptr<const Supercombinator>& combined_;
    const process::TermStore& terms_;
    const std::shared_ptr<const WholeRules>& rules_;
    lts::Followed followed_;
    Allowance allowance_;
    diagnostics::Pollable& budget_;
    Pilot pilot_;
    ProofRecord record_;      // sums of the rounds with earlier plans
    double work_before_ = 0;  // work that a full search would have needed in those rounds
    ProofPlan plan_;
    std::unique_ptr<ReducedSystem> reduced_;        // uses this plan; null if not yet made
    const SupercombinatorSystem* whole_ = nullptr;  // owned by `reduced_`
    bool worth_it_ = true;
};

/// Returns true if the process has at least this many reachable states.
bool has_states(lts::TransitionSystem& system, std::size_t states, diagnostics::Pollable& budget) {
    struct Found final : lts::SuccessorSink {
        explicit Found(std::size_t width) : store(width) {}
        void add(Event /*event*/, lts::StateView target, Event /*revealed*/) override { (void)store.insert(target); }
        lts::StateStore store;
    };
    Found found(system.width());
    std::vector<lts::Word> initial(system.width());
    system.initial(initial);
    (void)found.store.insert(initial);
    for (lts::StateIndex next = 0; next < found.store.size() && found.store.size() < states; ++next) {
        budget.poll();
        system.successors(found.store[next], found);
    }
    return found.store.size() >= states;
}

}  // namespace

/// Makes a plan by a pilot search. If the first pilot search saves nothing, a larger one follows, but not for small
/// processes: searching all their states takes less work.
std::optional<ProofPlan> SupercombinatorSystem::make_plan(lts::Followed followed, diagnostics::Pollable& budget) const {
    const auto plan_with = [&](const Allowance& allowance) {
        return PilotRounds(combined_, terms_, facts_.whole, followed, allowance, budget).run();
    };
    std::optional<ProofPlan> plan = plan_with(first_allowance(*combined_));
    if (plan) return plan;
    const std::unique_ptr<SupercombinatorSystem> copy = make_copy();
    return has_states(*copy, states_for_large_allowance, budget) ? plan_with(large_allowance) : std::nullopt;
}

std::unique_ptr<lts::ReducedSystem> SupercombinatorSystem::make_reduced_system(lts::Followed followed,
                                                                               diagnostics::Pollable& budget) const {
    const WholeRules* const rules = find_whole_rules(budget);
    const auto may_be_followed = [&](const WholeRule& rule) { return is_candidate(rule, followed); };
    if (rules == nullptr || std::ranges::none_of(rules->rules, may_be_followed)) return nullptr;
    std::optional<std::optional<ProofPlan>>& plan =
        followed == lts::Followed::taus ? facts_.plan_of_taus : facts_.plan_of_steps;
    if (!plan) plan = make_plan(followed, budget);
    if (!*plan) return nullptr;
    return std::make_unique<ReducedSystem>(clone_for_thread(), combined_, facts_.whole, followed, **plan);
}

ReducedSystem::ReducedSystem(std::unique_ptr<lts::TransitionSystem> whole,
                             std::shared_ptr<const Supercombinator> combined, std::shared_ptr<const WholeRules> rules,
                             lts::Followed followed, ProofPlan plan)
    : whole_(std::move(whole)),
      combined_(std::move(combined)),
      rules_(std::move(rules)),
      followed_(followed),
      plan_(std::move(plan)),
      most_steps_(most_steps(followed, combined_->components.size())),
      confluence_(combined_, rules_, followed, plan_),
      locals_(combined_->components.size()),
      target_(combined_->words) {}

void ReducedSystem::set_budget(diagnostics::Pollable& budget) {
    budget_ = &budget;
    whole_->set_budget(budget);
}

void ReducedSystem::unpack_locals(lts::StateView state) {
    assert(state.size() == combined_->words);
    for (std::size_t slot = 0; slot < locals_.size(); ++slot) locals_[slot] = combined_->fields[slot].get(state);
}

void ReducedSystem::pack_locals(std::span<lts::Word> state) const {
    assert(state.size() == combined_->words);
    std::ranges::fill(state, 0);
    for (std::size_t slot = 0; slot < locals_.size(); ++slot) combined_->fields[slot].put(state, locals_[slot]);
}

void ReducedSystem::initial(std::span<lts::Word> state) {
    whole_->initial(state);
    unpack_locals(state);
    chased_ += follow_all_steps();
    pack_locals(state);
}

void ReducedSystem::successors(lts::StateView state, lts::SuccessorSink& sink) {
    // The sink may ask for successors in the middle of this call, as in SupercombinatorSystem.
    if (sink_ != nullptr) {
        const auto other = clone_for_thread();
        other->set_budget(*budget_);
        return other->successors(state, sink);
    }
    const lts::SinkInUse in_use(sink_, sink);
    if (followed_ == lts::Followed::steps && pass_followed_step(state)) return;
    whole_->successors(state, *this);
}

/// If a step can be followed from the state, passes it as the only transition and returns true. Such a state is on a
/// cycle of followed steps, or a sequence ended at it because it became too long.
bool ReducedSystem::pass_followed_step(lts::StateView state) {
    unpack_locals(state);
    if (!follow_step()) return false;
    chased_ += follow_all_steps();
    pack_locals(target_);
    sink_->add(process::tau, target_, process::tau);
    return true;
}

/// Reduces the cycle system of the whole process. Each of its cycles is a cycle of the process without the followed
/// taus.
std::unique_ptr<lts::TransitionSystem> ReducedSystem::make_cycle_system(diagnostics::Pollable& budget) const {
    std::unique_ptr<lts::TransitionSystem> whole = whole_->make_cycle_system(budget);
    if (!whole || followed_ != lts::Followed::taus) return nullptr;
    return std::make_unique<ReducedSystem>(std::move(whole), combined_, rules_, followed_, plan_);
}

void ReducedSystem::add(Event event, lts::StateView target, Event revealed) {
    assert(sink_ != nullptr);
    unpack_locals(target);
    const std::size_t steps = follow_all_steps();
    if (steps == 0) return sink_->add(event, target, revealed);
    chased_ += steps;
    pack_locals(target_);
    sink_->add(event, target_, revealed);
}

bool ReducedSystem::follow_step() {
    if (followed_states_ == nullptr) return confluence_.follow_step(locals_);
    pack_locals(target_);
    if (!confluence_.follow_step(locals_)) return false;
    (void)followed_states_->insert(target_);
    return true;
}

/// Follows confluent steps until there is none, or until the sequence reaches a cycle; then stops at the least state of
/// the cycle. Returns the number of steps. (Cycles are found as in Brent, BIT 20, 1980.)
std::size_t ReducedSystem::follow_all_steps() {
    budget_->poll();
    begin_ = seen_ = locals_;
    std::size_t length = 0;  // length of the cycle, if a cycle is found
    std::size_t next_look = 1;
    for (std::size_t steps = 0; steps < most_steps_; ++steps) {
        if (!follow_step()) return steps;
        ++length;
        if (locals_ == seen_) return enter_cycle(length);
        if (length != next_look) continue;
        seen_ = locals_;
        next_look *= 2;
        length = 0;
    }
    return most_steps_;
}

/// Moves to the least state of the cycle that contains the current state. To count the steps, follows the sequence
/// again from its beginning to this state. Returns the number of steps.
std::size_t ReducedSystem::enter_cycle(std::size_t length) {
    least_ = locals_;
    for (std::size_t i = 0; i < length; ++i) {
        follow_step();
        least_ = std::min(least_, locals_);
    }
    assert(locals_ == seen_);  // now the whole cycle has been followed
    locals_ = begin_;
    std::size_t steps = 0;
    for (; locals_ != least_; ++steps) {
        assert(steps < most_steps_);  // the first pass reached this state within the limit
        follow_step();
    }
    return steps;
}

std::vector<std::vector<lts::Word>> ReducedSystem::followed_path(lts::StateView state) {
    unpack_locals(state);
    const std::size_t steps = follow_all_steps();
    std::vector<std::vector<lts::Word>> row;
    unpack_locals(state);
    for (std::size_t i = 0; i < steps; ++i) {
        follow_step();
        pack_locals(row.emplace_back(width()));
    }
    return row;
}

}  // namespace robochart::machine
