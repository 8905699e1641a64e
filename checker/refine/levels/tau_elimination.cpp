// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/levels/tau_elimination.hpp"

#include <algorithm>
#include <stdexcept>

#include "checker/lts/strong_components.hpp"
#include "checker/refine/search/steps.hpp"
#include "checker/refine/search/tau_cycle.hpp"

namespace robochart::refine {

using lts::StateIndex;
using lts::StateView;
using process::Event;

/// Collects the rows to which the taus of one row lead.
class TauElimination::Targets final : public lts::SuccessorSink {
public:
    Targets(const OnRow& on_row, bool nodes) : on_row_(on_row), nodes_(nodes) {}
    void begin(StateView row) { row_.assign(row.begin(), row.end()); }
    void add(Event event, StateView target, Event /*revealed*/) override {
        if (event != process::tau) return;
        std::ranges::copy(target, row_.begin() + (nodes_ ? 1 : 0));
        on_row_(row_, lts::StateStore::hash(row_));
    }

private:
    const OnRow& on_row_;
    bool nodes_;
    Words row_;
};

TauElimination::TauElimination(lts::TransitionSystem& system, RowStore& store, Exchange& exchange, Budget& budget,
                               SharedWork& work, bool nodes)
    : system_(system),
      store_(store),
      exchange_(exchange),
      budget_(budget),
      work_(work),
      nodes_(nodes),
      batches_(exchange.ranks(), store.width()),
      reached_(store.width()) {}

std::optional<TauCycle> TauElimination::least_cycle() {
    find_reached_rows();
    eliminate();
    if (left_everywhere() == 0) return std::nullopt;
    std::vector<Words> rows = at_first_rank();
    // The words contain the level, the length of the loop, the row, and then, for each step of the loop, the revealed
    // event and the state.
    Words answer;
    work_.execute_part([&] {
        if (exchange_.rank() != 0) return;
        const TauCycle cycle = decide(std::move(rows));
        answer = {cycle.level, static_cast<lts::Word>(cycle.loop.steps.size())};
        answer.insert(answer.end(), cycle.row.begin(), cycle.row.end());
        for (const RunStep& step : cycle.loop.steps) {
            answer.push_back(step.revealed);
            answer.insert(answer.end(), step.state.begin(), step.state.end());
        }
    });
    work_.sum({});
    answer = exchange_.gather(answer).front();
    auto at = answer.begin() + 2;
    const auto take = [&at](std::size_t words) {
        at += static_cast<std::ptrdiff_t>(words);
        return Words(at - static_cast<std::ptrdiff_t>(words), at);
    };
    TauCycle cycle{take(store_.width()), answer[0], {}};
    const StateView first = state(cycle.row);
    cycle.loop.initial.assign(first.begin(), first.end());
    for (lts::Word step = 0; step < answer[1]; ++step) {
        const Event revealed = take(1).front();
        cycle.loop.steps.push_back({process::tau, revealed, take(system_.width())});
    }
    return cycle;
}

/// Repeats rounds until no rank has a waiting row. In a round, the taus of waiting rows are sent to the ranks that own
/// their targets.
void TauElimination::repeat_rounds(const Waiting& waiting, const OnRow& on_target) {
    constexpr std::size_t rows_a_round = std::size_t{1} << 16U;
    constexpr std::uint64_t most_waiting = std::uint64_t{1} << 22U;
    const unsigned ranks = exchange_.ranks();
    const OnRow route = [&](StateView row, std::uint64_t hash) {
        const unsigned owner = owner_of(hash, ranks);
        if (owner == exchange_.rank())
            on_target(row, hash);
        else
            batches_.add(owner, row, true);
    };
    Targets targets(route, nodes_);
    std::uint64_t left[1] = {0};
    do {
        left[0] = 0;
        work_.execute_part([&] {
            std::size_t done = 0;
            for (; done < rows_a_round && !batches_.is_full(most_waiting); ++done) {
                const std::optional<StateIndex> next = waiting();
                if (!next) break;
                budget_.charge();
                const Words row(reached_[*next].begin(), reached_[*next].end());
                targets.begin(row);
                system_.successors(state(row), targets);
            }
            left[0] = done;  // the processed rows may have added waiting rows
        });
        batches_.exchange(exchange_);
        work_.execute_part([&] {
            batches_.receive([](std::uint64_t) {},
                             [&](StateView row, std::uint64_t hash, bool) {
                                 on_target(row, hash);
                                 left[0] = 1;
                             });
            budget_.states(reached_.size());
        });
        work_.sum(left);
    } while (left[0] > 0);
}

/// Finds the rows that taus reach from the marks, and counts the taus that lead to each.
void TauElimination::find_reached_rows() {
    work_.execute_part([this] {
        const lts::StateStore& marks = store_.record().marks;
        for (StateIndex mark = 0; mark < marks.size(); ++mark) reached_.insert(marks[mark]);
        taus_to_.resize(reached_.size(), 0);
    });
    StateIndex next = 0;
    repeat_rounds(
        [&]() -> std::optional<StateIndex> { return next < reached_.size() ? std::optional(next++) : std::nullopt; },
        [&](StateView row, std::uint64_t hash) {
            const StateIndex target = reached_.insert(row, hash).index;
            if (target == taus_to_.size()) taus_to_.push_back(0);
            ++taus_to_[target];
        });
}

/// Removes rows to which no tau of a remaining row leads, until no such row is left.
void TauElimination::eliminate() {
    for (StateIndex row = 0; row < taus_to_.size(); ++row)
        if (taus_to_[row] == 0) dropped_.push_back(row);
    repeat_rounds(
        [&]() -> std::optional<StateIndex> {
            if (dropped_.empty()) return std::nullopt;
            const StateIndex row = dropped_.back();
            dropped_.pop_back();
            return row;
        },
        [&](StateView row, std::uint64_t hash) {
            const StateIndex target = reached_.find(row, hash);
            if (--taus_to_[target] == 0) dropped_.push_back(target);
        });
}

std::uint64_t TauElimination::left_everywhere() {
    std::uint64_t left[1] = {
        static_cast<std::uint64_t>(std::ranges::count_if(taus_to_, [](std::uint32_t taus) { return taus > 0; }))};
    work_.sum(left);
    return left[0];
}

/// Returns the remaining rows of all ranks, each preceded by its level. The result is empty at all ranks except the
/// first.
std::vector<Words> TauElimination::at_first_rank() {
    constexpr std::size_t rows_a_message = 1U << 14U;
    const std::size_t width = store_.width();
    std::vector<Words> all;
    Messages out(exchange_.ranks()), in(exchange_.ranks());
    Level level = 0;
    std::uint64_t next = 0;
    std::uint64_t more[1] = {1};
    while (more[0] > 0) {
        more[0] = 0;
        out.words.clear();
        work_.execute_part([&] {
            Words block;
            while (level < store_.levels() && out.words.size() < rows_a_message * width) {
                block.clear();
                const std::size_t count = store_.read(level, next, 1024, block);
                next += count;
                if (count == 0) {
                    ++level;
                    next = 0;
                }
                for (std::size_t i = 0; i < count; ++i) {
                    const StateView row = StateView(block).subspan(i * width, width);
                    const StateIndex found = reached_.find(row);
                    if (found == lts::no_state || taus_to_[found] == 0) continue;
                    out.words.push_back(level);
                    out.words.insert(out.words.end(), row.begin(), row.end());
                }
            }
            more[0] = level < store_.levels() ? 1 : 0;
        });
        out.sizes[0] = out.words.size();
        exchange_.all_to_all(out, in);
        work_.execute_part([&] {
            for (std::size_t at = 0; at < in.words.size(); at += width + 1)
                all.emplace_back(in.words.begin() + static_cast<std::ptrdiff_t>(at),
                                 in.words.begin() + static_cast<std::ptrdiff_t>(at + width + 1));
            budget_.charge(all.size() / 1024 + 1);
        });
        work_.sum(more);
    }
    return all;
}

/// Decides about cycles among the remaining rows. Numbers the rows by level and words, so that the cycle does not
/// depend on the distribution of the rows.
TauCycle TauElimination::decide(std::vector<Words> rows) {
    std::ranges::sort(rows);
    lts::StateStore store(store_.width());
    for (const Words& row : rows) store.insert(StateView(row).subspan(1));
    const lts::GraphView graph{store.size(), [&](StateIndex row, std::vector<StateIndex>& out) {
                                   budget_.charge();
                                   const OnRow on_row = [&](StateView target, std::uint64_t hash) {
                                       const StateIndex found = store.find(target, hash);
                                       if (found != lts::no_state) out.push_back(found);
                                   };
                                   Targets targets(on_row, nodes_);
                                   targets.begin(store[row]);
                                   system_.successors(state(store[row]), targets);
                               }};
    std::vector<StateIndex> all;
    for (StateIndex row = 0; row < store.size(); ++row) all.push_back(row);
    StateIndex least = lts::no_state;
    lts::strong_components(graph, all, [&](std::span<const StateIndex> members, bool cyclic) {
        if (cyclic) least = std::min(least, *std::ranges::min_element(members));
    });
    if (least == lts::no_state) throw std::logic_error("rows that taus lead to without end have no cycle");
    const StateView row = store[least];
    TauCycle cycle{{row.begin(), row.end()}, rows[least].front(), {}};
    const StateView first = state(row);
    cycle.loop.initial.assign(first.begin(), first.end());
    StateView at = first;
    for (const StateIndex next : shortest_cycle(graph, least)) {
        const StateView target = state(store[next]);
        for (RunStep& step : steps_from(system_, at)) {
            if (step.event != process::tau || !std::ranges::equal(step.state, target)) continue;
            cycle.loop.steps.push_back(std::move(step));
            break;
        }
        at = target;
    }
    return cycle;
}

}  // namespace robochart::refine
