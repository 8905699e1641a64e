// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/levels/level_search.hpp"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cassert>
#include <new>
#include <stdexcept>

#include "checker/refine/levels/tau_elimination.hpp"
#include "checker/refine/search/steps.hpp"

namespace robochart::refine {

using lts::StateView;
using process::Event;

namespace {

constexpr std::size_t rows_a_round = std::size_t{1} << 16U;
constexpr std::size_t rows_a_block = 256;

/// Adds the processor time that this thread uses during the object's lifetime.
class Timed {
public:
    explicit Timed(double& seconds) : seconds_(seconds), start_(thread_seconds()) {}
    Timed(const Timed&) = delete;
    Timed& operator=(const Timed&) = delete;
    ~Timed() { seconds_ += thread_seconds() - start_; }

private:
    static double thread_seconds() {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }
    double& seconds_;
    double start_;
};

}  // namespace

LevelSearch::LevelSearch(lts::TransitionSystem& system, Monitor& monitor, RowStore& store, Exchange& exchange,
                         Budget& budget, bool note_taus)
    : system_(system),
      monitor_(monitor),
      store_(store),
      exchange_(exchange),
      budget_(budget),
      nodes_(!monitor.watches_states_only()),
      note_taus_(note_taus),
      work_(exchange),
      batches_(exchange.ranks(), store.width()),
      sent_(store.width()),
      no_rows_(store.width()) {}

LevelSearch::~LevelSearch() {
    budget_.report_by({});
}

std::optional<LevelFinding> LevelSearch::first_violation(std::uint64_t events_until) {
    budget_.report_by([this](Progress& progress) {
        progress.states = agreed_.known;
        progress.transitions = agreed_.transitions;
        progress.frontier = agreed_.waiting + agreed_.open;
        progress.depth = depth_;
    });
    try {
        begin();
        for (;;) {
            const Level level = store_.levels() - 1;
            use_expander(level >= events_until);
            depth_ = level;
            expand_level(level);
            const bool violated = agreed_.faults + agreed_.forbidden > 0;
            if (violated || agreed_.open == 0 || agreed_.wants_to_settle > 0) {
                const std::optional<Level> wrong = settle_unsure_rows();
                if (wrong && *wrong <= level + (violated ? 0 : 1)) {
                    roll_back_to(*wrong);
                    continue;
                }
                if (violated || agreed_.open == 0) {
                    count_levels(level);
                    if (!violated) return std::nullopt;
                    return finding_of(least_fault().value(), level);
                }
            }
            close_level();
        }
    } catch (const diagnostics::LimitReached&) {
        count_levels(depth_ > 0 ? static_cast<Level>(depth_) : 0);
        write_last_checkpoint();
        throw;
    } catch (const std::bad_alloc&) {
        write_last_checkpoint();
        throw;
    }
}

/// Writes a checkpoint: together with all ranks if they leave the search together, otherwise only for this rank. If no
/// level is closed, writes nothing.
void LevelSearch::write_last_checkpoint() {
    if (!exchange_.left_together()) {
        if (store_.levels() > 0) store_.checkpoint();
        return;
    }
    exchange_.begin_together();  // if a rank alone fails from here on, the others do not know of it
    SharedWork last(exchange_);
    checkpoint(last);
    exchange_.leave_together();
}

/// Writes a checkpoint. The program is not killed before all ranks have written theirs.
void LevelSearch::checkpoint(SharedWork& work) {
    std::shared_ptr<void> held;
    work.execute_part([&] {
        held = hold_undisturbed();
        if (store_.levels() > 0) store_.checkpoint();
    });
    work.sum({});
}

/// Holds Limits::undisturbed at the first rank; returns null at other ranks. Only the program of the first rank is
/// killed if it continues after a limit has been reached.
std::shared_ptr<void> LevelSearch::hold_undisturbed() const {
    const auto& hold = budget_.limits().undisturbed;
    return hold && exchange_.rank() == 0 ? hold() : nullptr;
}

void LevelSearch::close_level_of_store() {
    const std::shared_ptr<void> held = hold_undisturbed();
    store_.close_level();
}

/// Creates an expander unless the current one follows the required events. A rollback may have changed what is
/// required: an earlier level is expanded with all events although a later level was already expanded with taus alone.
void LevelSearch::use_expander(bool taus_alone) {
    if (expander_ && taus_alone_ == taus_alone) return;
    taus_alone_ = taus_alone;
    expander_.emplace(system_, monitor_, no_rows_);
    if (taus_alone) expander_->follow_taus_alone();
}

/// Enters the initial row. If the store continues an earlier run, reads the statistics so far instead.
void LevelSearch::begin() {
    work_.execute_part([this] {
        if (store_.levels() > 0) return;
        Words first(store_.width());
        if (nodes_) first[0] = monitor_.start();
        const std::uint64_t chased_before = system_.chased_state_count();
        system_.initial(std::span(first).subspan(nodes_ ? 1 : 0));
        const std::uint64_t hash = lts::StateStore::hash(first);
        if (owner_of(hash, exchange_.ranks()) != exchange_.rank()) return;
        figures_.chased = system_.chased_state_count() - chased_before;
        store_.enter_row(first, hash);
    });
    before_ = figures_until(store_.record().expanded.size());
    agree_on_totals(0);
    work_.execute_part([this] {
        if (agreed_.known == 0) throw std::logic_error("no rank has the initial state");
        const std::optional<std::uint64_t> before = store_.rows_before();
        if (before && *before != agreed_.known)
            throw std::logic_error(
                fmt::format("of {} states of the checkpoint the ranks have {}", *before, agreed_.known));
        if (store_.levels() == 0) close_level_of_store();
    });
    work_.sum({});
}

/// Expands a level in rounds. At the end of each round all ranks know how much work remains. The statistics are added
/// to those of earlier levels. The statistics of the initial state belong to its level.
void LevelSearch::expand_level(Level level) {
    assert(level + std::size_t{1} == store_.levels());
    fault_.reset();
    forbidden_.reset();
    level_seconds_.resize(level + std::size_t{1});
    if (exchange_.ranks() > 1) work_.execute_part([this] { sent_.resize_to_fit(store_.bytes() / 64); });
    std::uint64_t next = 0;
    do {
        {
            const Timed timed(level_seconds_[level]);
            work_.execute_part([&] {
                budget_.check();  // after the rank has waited for the others
                expand_some(level, next);
            });
        }
        if (exchange_.ranks() > 1) batches_.exchange(exchange_);
        {
            const Timed timed(level_seconds_[level]);
            work_.execute_part([&] {
                if (exchange_.ranks() > 1)
                    batches_.receive(
                        [this](std::uint64_t hash) { store_.prefetch(hash); },
                        [this](StateView row, std::uint64_t hash, bool by_tau) { enter_row(row, hash, by_tau); });
                budget_.states(store_.size());
            });
        }
        assert(next <= store_.rows(level));
        agree_on_totals(store_.rows(level) - next);
        const std::uint64_t most = budget_.limits().max_states;
        if (agreed_.known > most) {
            exchange_.leave_together();  // all ranks compute this from the same sums
            throw LimitReached(fmt::format("the limit of {} states was reached", most));
        }
    } while (agreed_.waiting > 0);
    peak_bytes_ = std::max(peak_bytes_, bytes());
}

void LevelSearch::expand_some(Level level, std::uint64_t& next) {
    const std::size_t width = store_.width();
    // The rows that wait to be sent should take little memory compared with the store. In addition, the waiting rows of
    // all threads of a program must fit into one message.
    const std::uint64_t most_waiting =
        std::clamp(store_.bytes() / 32, std::uint64_t{1} << 13U, std::uint64_t{1} << 26U);
    for (std::size_t done = 0; done < rows_a_round && !batches_.is_full(most_waiting);) {
        block_.clear();
        const std::size_t count = store_.read(level, next, rows_a_block, block_);
        if (count == 0) return;
        assert(block_.size() == count * width);
        expansion_.clear(width);
        for (std::size_t i = 0; i < count; ++i) {
            if (expansion_.size() >= rows_at_once) distribute_rows();
            if (batches_.is_full(most_waiting)) {
                next += i;
                return;
            }
            try {
                expand(StateView(block_).subspan(i * width, width));
            } catch (const LimitReached&) {
                throw;
            } catch (const std::bad_alloc&) {
                throw;
            } catch (const std::exception&) {
                // The process is run as a term, and its evaluation has failed. Results that were found before the error
                // take precedence.
                if (!fault_) throw;
                next = store_.rows(level);
                return;
            }
        }
        distribute_rows();
        next += count;
        done += count;
    }
}

void LevelSearch::expand(StateView row) {
    budget_.charge();
    expander_->expand(row, expansion_);
    const Expansion::Pair& pair = expansion_.pairs.back();
    figures_.transitions += pair.transitions;
    figures_.chased += pair.chased;
    if (pair.fault) keep_least(fault_, {{row.begin(), row.end()}, *pair.fault, process::tau});
    if (pair.forbidden) keep_least(forbidden_, {{row.begin(), row.end()}, ViolationKind::trace, *pair.forbidden});
}

/// Collects the rows of other ranks for sending and enters the rows of this rank. The target of a tau is sent again
/// even if it was sent before, because the current level determines whether the tau leads back.
void LevelSearch::distribute_rows() {
    const unsigned ranks = exchange_.ranks();
    const unsigned self = exchange_.rank();
    own_.clear();
    for (std::uint32_t i = 0; i < expansion_.size(); ++i) {
        const std::uint64_t hash = expansion_.hash(i);
        const unsigned owner = ranks == 1 ? 0 : owner_of(hash, ranks);
        assert(owner < ranks);
        if (owner == self) {
            store_.prefetch(hash);
            own_.push_back(i);
            continue;
        }
        const bool by_tau = note_taus_ && expansion_.by_tau(i);
        if (by_tau || !sent_.sent_recently(expansion_.row(i), hash)) batches_.add(owner, expansion_.row(i), by_tau);
    }
    for (const std::uint32_t i : own_)
        enter_row(expansion_.row(i), expansion_.hash(i), note_taus_ && expansion_.by_tau(i));
    expansion_.clear(store_.width());
}

/// Enters a row. Marks it if it is the target of a tau that leads back, which means to a row of the same level or an
/// earlier one. Every cycle of taus contains such a tau.
void LevelSearch::enter_row(StateView row, std::uint64_t hash, bool by_tau) {
    assert(row.size() == no_rows_.width());
    const RowStore::Found found = store_.enter_row(row, hash);
    if (by_tau && (found == RowStore::Found::earlier || found == RowStore::Found::unsure))
        store_.record().marks.insert(row, hash);
}

void LevelSearch::agree_on_totals(std::uint64_t waiting) {
    const LevelFigures so_far{before_.transitions + figures_.transitions, before_.chased + figures_.chased};
    std::uint64_t values[] = {waiting,
                              store_.size(),
                              store_.rows(store_.levels()),
                              so_far.transitions,
                              so_far.chased,
                              store_.wants_to_settle() ? 1U : 0U,
                              store_.wants_checkpoint() ? 1U : 0U,
                              fault_ ? 1U : 0U,
                              forbidden_ ? 1U : 0U};
    work_.sum(values);
    agreed_ = {values[0], values[1], values[2], values[3], values[4], values[5], values[6], values[7], values[8]};
}

/// Settles the unsure rows of all ranks. Returns the least level of a row that some rank has missed.
std::optional<Level> LevelSearch::settle_unsure_rows() {
    std::optional<Level> wrong;
    work_.execute_part([&] { wrong = store_.settle_unsure_rows(); });
    work_.sum({});
    std::optional<Level> least;
    for (const Words& of_rank : exchange_.gather(wrong ? Words{*wrong} : Words{}))
        if (!of_rank.empty() && (!least || of_rank[0] < *least)) least = of_rank[0];
    return least;
}

void LevelSearch::roll_back_to(Level level) {
    work_.execute_part([&] { store_.roll_back_to(level); });
    sent_.clear();
    work_.sum({});
    std::vector<LevelFigures>& expanded = store_.record().expanded;
    if (level <= expanded.size()) {
        expanded.resize(level);
        figures_ = {};
    }
    before_ = figures_until(expanded.size());
    if (expanded.size() < level)
        close_level();
    else
        work_.execute_part([this] { close_level_of_store(); });
}

/// Closes the open level. The expanded level and the open level must be complete.
void LevelSearch::close_level() {
    work_.execute_part([this] {
        // All closed levels except the last one have been expanded before.
        assert(store_.record().expanded.size() + 1 == store_.levels());
        store_.record().expanded.push_back(figures_);
        before_ = figures_until(store_.record().expanded.size());
        figures_ = {};
        close_level_of_store();
    });
    if (agreed_.wants_checkpoint > 0) checkpoint(work_);
}

std::uint64_t LevelSearch::bytes() const {
    const lts::StateStore& marks = store_.record().marks;
    return store_.bytes() + batches_.bytes() + exchange_.bytes() + sent_.bytes() +
           marks.size() * marks.width() * sizeof(lts::Word);
}

LevelFigures LevelSearch::figures_until(std::size_t levels) const {
    LevelFigures sum;
    assert(levels <= store_.record().expanded.size());
    for (std::size_t level = 0; level < levels; ++level) {
        sum.transitions += store_.record().expanded[level].transitions;
        sum.chased += store_.record().expanded[level].chased;
    }
    return sum;
}

/// Sets the statistics to the sums over all levels up to this one, which has been expanded.
void LevelSearch::count_levels(Level last) {
    transitions_ = agreed_.transitions;
    chased_ = agreed_.chased;
    assert(agreed_.open <= agreed_.known);
    states_ = agreed_.known - agreed_.open;
    depth_ = last;
}

void LevelSearch::keep_least(std::optional<Fault>& least, Fault found) {
    if (!least || found.row < least->row) least = std::move(found);
}

/// Returns the least fault of all ranks.
std::optional<LevelSearch::Fault> LevelSearch::least_fault() {
    const std::optional<Fault>& own = agreed_.faults > 0 ? fault_ : forbidden_;
    Words words;
    if (own) {
        words = {static_cast<lts::Word>(own->kind), own->event};
        words.insert(words.end(), own->row.begin(), own->row.end());
    }
    std::optional<Fault> least;
    for (const Words& of_rank : exchange_.gather(words))
        if (!of_rank.empty())
            keep_least(least,
                       {{of_rank.begin() + 2, of_rank.end()}, static_cast<ViolationKind>(of_rank[0]), of_rank[1]});
    return least;
}

LevelFinding LevelSearch::finding_of(const Fault& fault, Level level) {
    LevelFinding finding{fault.kind, run_to(fault.row, level), {}};
    if (fault.kind == ViolationKind::trace) forbidden_step(fault, finding.run);
    return finding;
}

/// Adds the step of the forbidden event to the run. Every rank can compute this step. If several steps are possible,
/// uses the step to the least state.
void LevelSearch::forbidden_step(const Fault& fault, Run& run) {
    std::optional<RunStep> least;
    for (RunStep& step : steps_from(system_, state(fault.row)))
        if (step.event == fault.event && (!least || step.state < least->state)) least = std::move(step);
    if (!least) throw std::logic_error("a forbidden event cannot be taken again");
    run.steps.push_back(std::move(*least));
}

/// A row of the previous level, and the events of the step from it.
struct LevelSearch::Step {
    Words row;
    Event event = process::tau;
    Event revealed = process::tau;
    [[nodiscard]] bool operator<(const Step& other) const {
        return std::tie(row, event, revealed) < std::tie(other.row, other.event, other.revealed);
    }
};

namespace {

/// Finds the least transition from one row to another.
class StepTo final : public lts::SuccessorSink {
public:
    StepTo(Monitor& monitor, bool nodes, StateView goal) : monitor_(monitor), nodes_(nodes), goal_(goal) {}
    void begin(StateView row) {
        row_ = row;
        found = false;
    }
    void add(Event event, StateView target, Event revealed) override {
        const StateView goal_state = nodes_ ? goal_.subspan(1) : goal_;
        if (found && std::pair(least_event, least_revealed) <= std::pair(event, revealed)) return;
        if (!std::equal(target.begin(), target.end(), goal_state.begin()) || !leads_on(event)) return;
        found = true;
        least_event = event;
        least_revealed = revealed;
    }
    bool found = false;
    Event least_event = process::tau;
    Event least_revealed = process::tau;

private:
    bool leads_on(Event event) {
        if (event == process::tau) return !nodes_ || row_[0] == goal_[0];
        if (!nodes_) return true;
        const Monitor::Advance next = monitor_.advance(row_[0], event);
        return next.effect == Monitor::Effect::follow && next.node == goal_[0];
    }
    Monitor& monitor_;
    bool nodes_;
    StateView goal_;
    StateView row_;
};

}  // namespace

Run LevelSearch::run_to(const Words& row, Level level) {
    std::vector<Step> back;
    const Words* at = &row;
    back.reserve(level);
    for (Level before = level; before > 0; --before) {
        back.push_back(last_step(*at, before - 1));
        at = &back.back().row;
    }
    assert(back.size() == level);
    const auto state_of = [this](const Words& words) {
        const StateView view = state(words);
        return Words(view.begin(), view.end());
    };
    Run run{state_of(*at), {}};
    for (std::size_t i = back.size(); i-- > 0;)
        run.steps.push_back({back[i].event, back[i].revealed, state_of(i == 0 ? row : back[i - 1].row)});
    return run;
}

/// Finds the step that leads to this row from the level before it. Every rank searches its part of the level.
LevelSearch::Step LevelSearch::last_step(const Words& row, Level level) {
    std::optional<Step> least;
    work_.execute_part([&] {
        StepTo finder(monitor_, nodes_, row);
        const std::size_t width = store_.width();
        for (std::uint64_t next = 0;;) {
            block_.clear();
            const std::size_t count = store_.read(level, next, rows_a_block, block_);
            if (count == 0) break;
            for (std::size_t i = 0; i < count; ++i) {
                budget_.charge();
                const StateView from = StateView(block_).subspan(i * width, width);
                finder.begin(from);
                system_.successors(state(from), finder);
                if (!finder.found) continue;
                Step step{{from.begin(), from.end()}, finder.least_event, finder.least_revealed};
                if (!least || step < *least) least = std::move(step);
            }
            next += count;
        }
    });
    work_.sum({});
    Words words;
    if (least) {
        words = {least->event, least->revealed};
        words.insert(words.end(), least->row.begin(), least->row.end());
    }
    std::optional<Step> first;
    for (const Words& of_rank : exchange_.gather(words)) {
        if (of_rank.empty()) continue;
        Step step{{of_rank.begin() + 2, of_rank.end()}, of_rank[0], of_rank[1]};
        if (!first || step < *first) first = std::move(step);
    }
    if (!first) throw std::logic_error("a row of the search has no predecessor");
    return std::move(*first);
}

std::optional<LevelFinding> LevelSearch::first_divergence() {
    checkpoint(work_);  // written before a limit leaves no time for it
    TauElimination elimination(system_, store_, exchange_, budget_, work_, nodes_);
    const std::optional<TauCycle> cycle = elimination.least_cycle();
    if (!cycle) return std::nullopt;
    return LevelFinding{ViolationKind::divergence, run_to(cycle->row, cycle->level), cycle->loop};
}

}  // namespace robochart::refine
