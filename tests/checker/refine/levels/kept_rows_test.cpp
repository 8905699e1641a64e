// SPDX-License-Identifier: Apache-2.0
// Tests that row stores that use files behave like rows in memory: same levels, figures, violations and tau cycles.
// This must also hold if the search is stopped repeatedly and resumed from its checkpoints, in another store or by
// other ranks. It must hold as well if small filters mistake many new rows for old ones.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <random>
#include <string>

#include "base/diagnostics/files.hpp"
#include "checker/lts/graph.hpp"
#include "checker/refine/levels/disk_row_store.hpp"
#include "checker/refine/levels/level_search.hpp"
#include "checker/refine/levels/saved_row_store.hpp"
#include "checker/refine/levels/thread_exchange.hpp"
#include "checker/refine/search/thread_team.hpp"
#include "checker/refine/verdict/monitors.hpp"
#include "tests/file_limit.hpp"

namespace robochart::refine {
namespace {

using lts::Graph;
using process::Event;

/// Returns a random graph with many levels or with wide levels. Edges lead forward, back or to any state.
Graph random_graph(std::mt19937& random, std::size_t states, bool deadlocks, unsigned taus) {
    Graph graph;
    for (std::size_t state = 0; state < states; ++state) {
        const std::size_t least = deadlocks && random() % 100 == 0 ? 0 : 1;
        for (std::size_t i = 0, edges = least == 0 ? 0 : 1 + random() % 3; i < edges; ++i) {
            const std::size_t near = std::min(states - 1, 3 * state + random() % 4);
            const std::size_t target = random() % 4 == 0 ? random() % states : near;
            const bool tau = random() % 100 < taus && (taus > 20 || target > state);
            graph.add_edge({tau ? process::tau : static_cast<Event>(process::tick + random() % 3),
                            static_cast<lts::StateIndex>(target)});
        }
        graph.finish_state();
    }
    return graph;
}

/// Throws LimitReached after a number of polls.
struct BudgetOfPolls final : diagnostics::Pollable {
    explicit BudgetOfPolls(int polls) : left(polls) {}
    void poll() override {
        if (--left == 0) throw LimitReached("no time");
    }
    int left;
};

struct Answer {
    std::optional<ViolationKind> kind;
    std::vector<std::vector<lts::Word>> run, loop;
    std::uint64_t states = 0, transitions = 0, depth = 0;
    bool operator==(const Answer&) const = default;
};

std::vector<std::vector<lts::Word>> states_of(const Run& run) {
    std::vector<std::vector<lts::Word>> states{run.initial};
    for (const RunStep& step : run.steps) states.push_back(step.state);
    return states;
}

using MakeStore = std::function<std::unique_ptr<RowStore>(const Exchange&)>;

/// The levels that all ranks of a search have in common when it starts and when it ends.
struct CommonLevels {
    Level begun = std::numeric_limits<Level>::max(), ended = begun;
    bool differ = false;    ///< at the end the ranks have different numbers of levels
    bool searched = false;  ///< the first rank's search has ended, except for the search for tau cycles
    std::mutex alone;
    void begin(Level levels) {
        const std::lock_guard lock(alone);
        begun = std::min(begun, levels);
    }
    void end(Level levels) {
        const std::lock_guard lock(alone);
        if (ended != std::numeric_limits<Level>::max() && levels != ended) differ = true;
        ended = std::min(ended, levels);
    }
};

Answer answer(const Graph& graph, unsigned ranks, const Limits& limits, const MakeStore& make,
              CommonLevels* levels = nullptr) {
    Answer result;
    CommonLevels ignored;
    CommonLevels& common = levels != nullptr ? *levels : ignored;
    as_ranks(ranks, [&](Exchange& exchange) {
        const process::EventTable table;
        lts::GraphSystem system(graph, table);
        Budget budget(limits);
        StateMonitor monitor(true);
        const std::unique_ptr<RowStore> store = make(exchange);
        common.begin(store->levels());
        const auto note_end = [&common](const RowStore* ended) { common.end(ended->levels()); };
        const std::unique_ptr<const RowStore, decltype(note_end)> at_end(store.get(), note_end);
        LevelSearch search(system, monitor, *store, exchange, budget, true);
        std::optional<LevelFinding> finding = search.first_violation();
        if (exchange.rank() == 0) common.searched = true;
        if (!finding) finding = search.first_divergence();
        if (exchange.rank() != 0) return;
        result = {{}, {}, {}, search.states(), search.transitions(), search.depth()};
        if (!finding) return;
        result.kind = finding->kind;
        result.run = states_of(finding->run);
        if (finding->kind == ViolationKind::divergence) result.loop = states_of(finding->loop);
    });
    return result;
}

class KeptRows : public testing::Test {
protected:
    /// Returns a separate folder for each search.
    [[nodiscard]] KeptWhere folder_for(const Exchange& exchange, std::uint8_t search) const {
        KeptWhere where;
        where.folder = folder_.path();
        where.kind = {1, {}};
        where.kind.search.fill(search);
        where.place = {exchange.rank(), exchange.ranks()};
        where.from = storage::newest_in(where.folder);
        if (exchange.ranks() > 1)
            where.mine = [rank = exchange.rank(), ranks = exchange.ranks()](lts::StateView row) {
                return owner_of(lts::StateStore::hash(row), ranks) == rank;
            };
        return where;
    }
    /// Returns the newest complete checkpoint in the folder.
    [[nodiscard]] std::vector<storage::Checkpoint> newest_checkpoints() const {
        const LoneExchange alone;
        const KeptWhere all = folder_for(alone, 1);
        return storage::read(all.folder, all.kind, all.from);
    }
    void clear() const {
        for (const std::string& file : diagnostics::files_below(folder_.path(), false).files) std::remove(file.c_str());
    }
    std::string error_;
    diagnostics::TemporaryFolder folder_{"", error_};
};

Answer in_memory(const Graph& graph, unsigned ranks = 1) {
    return answer(graph, ranks, {}, [](const Exchange&) { return std::make_unique<MemoryRowStore>(1); });
}

TEST_F(KeptRows, OnDiskAreThoseInMemory) {
    std::mt19937 random(5);
    std::uint64_t rolled_back = 0, settled = 0, violated = 0, cycles = 0;
    for (int round = 0; round < 80; ++round) {
        const Graph graph = random_graph(random, 50 + random() % 400, round % 3 == 0, round % 2 == 0 ? 15 : 30);
        const Answer expected = in_memory(graph);
        const unsigned ranks = round % 4 == 3 ? 3 : 1;
        clear();
        DiskRowStore::Bounds bounds;
        bounds.most_bytes = round % 5 == 0 ? 0 : std::uint64_t{1} << (9 + round % 4);
        bounds.filter_bits = round % 5 == 1 ? 24 : 1;
        bounds.reads_a_step = round % 5 == 2 ? 8 : 0;
        const Answer found = answer(graph, ranks, {}, [&](const Exchange& exchange) -> std::unique_ptr<RowStore> {
            return std::make_unique<DiskRowStore>(folder_for(exchange, 1), bounds);
        });
        ASSERT_EQ(found, expected) << round;
        if (found.kind == ViolationKind::deadlock) ++violated;
        if (found.kind == ViolationKind::divergence) ++cycles;
        if (ranks > 1) continue;
        LoneExchange alone;
        clear();
        const process::EventTable table;
        lts::GraphSystem system(graph, table);
        const Limits limits;
        Budget budget(limits);
        StateMonitor monitor(false);
        DiskRowStore store(folder_for(alone, 1), bounds);
        MemoryRowStore memory(1);
        LevelSearch(system, monitor, store, alone, budget, false).first_violation();
        LevelSearch(system, monitor, memory, alone, budget, false).first_violation();
        ASSERT_EQ(store.levels(), memory.levels());
        for (Level level = 0; level < store.levels(); ++level) {
            std::vector<lts::Word> rows, others;
            store.read(level, 0, 1'000'000, rows);
            memory.read(level, 0, 1'000'000, others);
            std::ranges::sort(others);
            ASSERT_EQ(rows, others) << round << ", level " << level;
        }
        rolled_back += store.figures().rolled_back;
        settled += store.figures().settled;
    }
    EXPECT_GT(rolled_back, 50U);
    EXPECT_GT(settled, 80U);
    EXPECT_GE(violated, 3U);
    EXPECT_GT(cycles, 8U);
}

// A limit stops each search at a random time. The search is resumed as often as needed, with other ranks, in memory or
// on disk.
TEST_F(KeptRows, GoOnFromCheckpoints) {
    std::mt19937 random(6);
    int stops = 0;
    for (int round = 0; round < 40; ++round) {
        const Graph graph = random_graph(random, 100 + random() % 300, round % 3 == 0, round % 2 == 0 ? 15 : 30);
        const Answer expected = in_memory(graph);
        clear();
        Level saved = 0;
        for (int attempt = 0;; ++attempt) {
            ASSERT_LT(attempt, 1000);
            const auto ranks = static_cast<unsigned>(1 + random() % 3);
            const bool disk = random() % 2 == 0;
            DiskRowStore::Bounds bounds;
            bounds.most_bytes = random() % 2 == 0 ? 0 : 1U << 10U;
            bounds.filter_bits = 1;
            bounds.reads_a_step = random() % 2 == 0 ? 0 : 8;
            // The limit grows, so each attempt gets further.
            Limits limits;
            limits.max_states = 10 + static_cast<std::uint64_t>(attempt) * (1 + random() % 20);
            const int every = static_cast<int>(random() % 3);
            CommonLevels levels;
            const auto none_is_lost = [&] {
                ASSERT_GE(levels.begun, saved) << round;
                saved = levels.ended;
            };
            try {
                const Answer found = answer(
                    graph, ranks, limits,
                    [&](const Exchange& exchange) -> std::unique_ptr<RowStore> {
                        KeptWhere place = folder_for(exchange, 1);
                        if (every == 0) place.every = std::chrono::milliseconds(0);
                        if (disk) return std::make_unique<DiskRowStore>(std::move(place), bounds);
                        return std::make_unique<SavedRowStore>(std::move(place));
                    },
                    &levels);
                ASSERT_EQ(found, expected) << round;
                none_is_lost();
                break;
            } catch (const LimitReached&) {
                ++stops;
                none_is_lost();
            }
        }
    }
    EXPECT_GT(stops, 50);
}

/// Returns a graph with a few levels, each about ten times as wide as the previous one. Most of its rows are reached
/// several times.
Graph growing_graph(std::mt19937& random, std::size_t states, bool divergence) {
    Graph graph;
    for (std::size_t state = 0; state < states; ++state) {
        for (std::size_t i = 1; i <= 11; ++i) {
            const bool back = i == 11 || 10 * state + i >= states;
            const std::size_t target = back ? random() % states : 10 * state + i;
            graph.add_edge({process::tick + static_cast<Event>(i % 3), static_cast<lts::StateIndex>(target)});
        }
        if (divergence && state % 300 == 299) graph.add_edge({process::tau, static_cast<lts::StateIndex>(state)});
        graph.finish_state();
    }
    return graph;
}

/// The time at which a limit is reached.
struct Moment {
    bool closing = false;  ///< when a level is closed; otherwise during long work
    int number = 0;        ///< how often the first rank has met this situation so far
};

// Only the first rank reaches the limit. This happens when it closes a level, or while it merges runs, reads the files,
// fills the filter or rolls back. At this time, other ranks have closed one level more, or have discarded some. The
// levels that all ranks have are saved.
TEST_F(KeptRows, GoOnFromLevelsThatAllRanksHaveClosed) {
    std::mt19937 random(9);
    int differed = 0;
    DiskRowStore::Bounds bounds;
    bounds.filter_bits = 1;
    bool stopped = false;
    const auto stop_and_go_on = [&](const Graph& graph, const Answer& expected, unsigned ranks, Moment last) {
        clear();
        stopped = false;
        // Memory is so small that some levels are rolled back before they are closed.
        bounds.most_bytes = last.closing ? 1U << 11U : 0;
        bounds.reads_a_step = last.closing || last.number % 2 == 0 ? 0 : 8;
        CommonLevels before, after;
        BudgetOfPolls budget(last.number);
        const auto stopping = [&](const Exchange& exchange) {
            KeptWhere where = folder_for(exchange, 1);
            if (!last.closing && last.number % 6 == 0) where.every = std::chrono::milliseconds(0);
            if (exchange.rank() == 0 && !last.closing) where.budget = &budget;
            return std::make_unique<DiskRowStore>(std::move(where), bounds);
        };
        try {
            Limits limits;
            if (last.closing)
                limits.undisturbed = [&]() -> std::shared_ptr<void> {
                    if (!before.searched) budget.poll();
                    return nullptr;
                };
            ASSERT_EQ(answer(graph, ranks, limits, stopping, &before), expected);
            return;
        } catch (const LimitReached&) {
            stopped = true;
        }
        if (before.differ) ++differed;
        const auto going_on = [&](const Exchange& exchange) -> std::unique_ptr<RowStore> {
            if (last.number % 5 != 0) return std::make_unique<DiskRowStore>(folder_for(exchange, 1), bounds);
            return std::make_unique<SavedRowStore>(folder_for(exchange, 1));
        };
        const Answer found = answer(graph, last.number % 4 == 0 ? 5 - ranks : ranks, {}, going_on, &after);
        ASSERT_EQ(found, expected);
        ASSERT_EQ(after.begun, before.ended);
    };
    for (const unsigned ranks : {2U, 3U}) {
        for (const bool closing : {false, true}) {
            const Graph graph =
                closing ? random_graph(random, 150, false, 15) : growing_graph(random, 1500, ranks == 2);
            const Answer expected = in_memory(graph);
            stopped = true;
            const auto step_after = [&](int number) {
                if (closing) return 1;
                return number < 10 ? 3 : 5;
            };
            for (int number = 1; stopped; number += step_after(number)) {
                if (number > 40) break;
                SCOPED_TRACE(std::to_string(ranks) + " ranks, moment " + std::to_string(number));
                stop_and_go_on(graph, expected, ranks, {closing, number});
                if (HasFatalFailure()) return;
            }
        }
    }
    EXPECT_GT(differed, 5);
}

// A full disk may stop the closing of a level, the writing of rows or of a checkpoint, or a rollback. As many levels
// are saved as fit, and never fewer than before. Another run continues when there is free space.
TEST_F(KeptRows, GoOnAfterAFullDisk) {
    std::mt19937 random(10);
    int stops = 0, kept_more = 0;
    for (int round = 0; round < 12; ++round) {
        const Graph graph = round % 2 == 0 ? random_graph(random, 400, false, 15) : growing_graph(random, 1500, true);
        const Answer expected = in_memory(graph);
        const unsigned ranks = round % 5 == 4 ? 2 : 1;
        clear();
        Level saved = 0;
        for (int attempt = 0; attempt < 4; ++attempt) {
            const bool disk = random() % 3 > 0;
            DiskRowStore::Bounds bounds;
            bounds.most_bytes = 0;
            bounds.filter_bits = random() % 2 == 0 ? 1 : 16;
            bounds.reads_a_step = random() % 2 == 0 ? 0 : 8;
            const int every = static_cast<int>(random() % 2);
            CommonLevels levels;
            try {
                std::optional<tests::FileLimit> limit;
                if (attempt < 3) limit.emplace(1000 + random() % 3000);
                const Answer found = answer(
                    graph, ranks, {},
                    [&](const Exchange& exchange) -> std::unique_ptr<RowStore> {
                        KeptWhere place = folder_for(exchange, 1);
                        if (every == 0) place.every = std::chrono::milliseconds(0);
                        if (disk) return std::make_unique<DiskRowStore>(std::move(place), bounds);
                        return std::make_unique<SavedRowStore>(std::move(place));
                    },
                    &levels);
                ASSERT_EQ(found, expected) << round << ", attempt " << attempt;
                break;
            } catch (const storage::CannotWrite&) {
                ASSERT_LT(attempt, 3);
                ++stops;
            }
            ASSERT_GE(levels.begun, saved) << round;
            const std::vector<storage::Checkpoint> found = newest_checkpoints();
            ASSERT_FALSE(found.empty()) << "the first level needs less";
            saved = std::ranges::min_element(found, [](const auto& a, const auto& b) {
                        return a.levels < b.levels;
                    })->levels;
            if (every > 0 && saved > 1) ++kept_more;
        }
    }
    EXPECT_GT(stops, 8);
    EXPECT_GE(kept_more, 3) << "what no checkpoint had before the disk was full";
}

/// A system whose initial state takes too long to compute.
class Endless final : public lts::TransitionSystem {
public:
    explicit Endless(const process::EventTable& events) : events_(events) {}
    [[nodiscard]] std::size_t width() const override { return 1; }
    void initial(std::span<lts::Word> /*state*/) override { throw LimitReached("no time"); }
    void successors(lts::StateView /*state*/, lts::SuccessorSink& /*sink*/) override {}
    [[nodiscard]] const process::EventTable& events() const override { return events_; }
    [[nodiscard]] std::string describe(lts::StateView /*state*/) const override { return ""; }

private:
    const process::EventTable& events_;
};

// Without a level, another run could not resume from the checkpoint.
TEST_F(KeptRows, HaveNoCheckpointBeforeTheFirstLevel) {
    const process::EventTable table;
    Endless system(table);
    LoneExchange alone;
    const Limits limits;
    Budget budget(limits);
    StateMonitor monitor(true);
    for (const bool disk : {false, true}) {
        clear();
        std::unique_ptr<RowStore> store;
        if (disk)
            store = std::make_unique<DiskRowStore>(folder_for(alone, 1), DiskRowStore::Bounds{});
        else
            store = std::make_unique<SavedRowStore>(folder_for(alone, 1));
        EXPECT_THROW(LevelSearch(system, monitor, *store, alone, budget, false).first_violation(), LimitReached);
        EXPECT_EQ(storage::newest_in(folder_.path()).greatest, 0U);
    }
}

// The search for cycles after the last level may take long.
TEST_F(KeptRows, HaveACheckpointBeforeCyclesAreLookedFor) {
    std::mt19937 random(8);
    const Graph graph = random_graph(random, 300, false, 15);
    const process::EventTable table;
    lts::GraphSystem system(graph, table);
    LoneExchange alone;
    const Limits limits;
    Budget budget(limits);
    StateMonitor monitor(true);
    SavedRowStore store(folder_for(alone, 1));
    LevelSearch search(system, monitor, store, alone, budget, true);
    ASSERT_FALSE(search.first_violation());
    EXPECT_TRUE(newest_checkpoints().empty());
    (void)search.first_divergence();
    const auto found = newest_checkpoints();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].levels, store.levels());
}

// During a rollback, the levels that are rolled back exist only in files. They must not be lost if the rollback is
// stopped.
TEST_F(KeptRows, AreThereWhereARollBackIsStopped) {
    LoneExchange alone;
    KeptWhere where = this->folder_for(alone, 1);
    storage::LevelFiles files({where.folder, where.kind, where.place});
    for (const std::vector<lts::Word>& rows : {std::vector<lts::Word>{0}, {1, 2}, {5}}) files.add_level(rows);
    files.checkpoint({{}, [](const storage::TakeRows& take) { take(std::vector<lts::Word>{3, 1}); }, {{3, 0}, {4, 0}}});
    where.from = storage::newest_in(where.folder);
    BudgetOfPolls budget(1000);
    where.budget = &budget;
    SavedRowStore store(where);
    ASSERT_EQ(store.settle_unsure_rows(), 1U);
    budget.left = 1;
    EXPECT_THROW(store.roll_back_to(1), LimitReached);
    EXPECT_EQ(store.levels(), 3U);
    store.checkpoint();
    const std::vector<storage::Checkpoint> found = newest_checkpoints();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].number, 2U);
    EXPECT_EQ(found[0].levels, 3U);
    where.from = storage::newest_in(where.folder);
    SavedRowStore again(where);
    ASSERT_EQ(again.settle_unsure_rows(), 1U);
    again.roll_back_to(1);
    EXPECT_EQ(again.levels(), 1U);
    EXPECT_EQ(again.rows(1), 3U);
    EXPECT_FALSE(again.settle_unsure_rows());
}

/// Returns the reason why the checkpoint in the folder is rejected.
std::string refusal(KeptWhere where) {
    where.from = storage::newest_in(where.folder);
    try {
        SavedRowStore store(where);
    } catch (const storage::BadFile& refused) {
        return refused.what();
    }
    return "";
}

TEST_F(KeptRows, AreRefusedWithLevelsThatAreNot) {
    LoneExchange alone;
    const KeptWhere where = this->folder_for(alone, 1);
    storage::LevelFiles files({where.folder, where.kind, where.place});
    files.add_level(std::vector<lts::Word>{0});
    files.checkpoint({});
    EXPECT_EQ(refusal(where), "");
    storage::Checkpoint made = newest_checkpoints().at(0);
    made.levels = 4'000'000'000;
    storage::write(where.folder, where.kind, made);
    EXPECT_NE(refusal(where).find("it has 4000000000 levels, and figures of 0"), std::string::npos);
    clear();
    storage::LevelFiles others({where.folder, where.kind, where.place});
    others.add_level(std::vector<lts::Word>{0});
    others.checkpoint({{}, [](const storage::TakeRows& take) { take(std::vector<lts::Word>{5, 7}); }, {}});
    EXPECT_NE(refusal(where).find("it has rows of level 7, which is not closed"), std::string::npos);
}

// The next checkpoint does not reuse a number that only one rank has used, and incomplete checkpoints are skipped.
TEST_F(KeptRows, RestartAfterIncompleteCheckpoints) {
    LoneExchange alone;
    KeptWhere where = this->folder_for(alone, 1);
    storage::LevelFiles files({where.folder, where.kind, {1, 2}});
    files.number_from(6);
    files.add_level(std::vector<lts::Word>{0});
    files.checkpoint({});
    where.from = storage::newest_in(where.folder);
    SavedRowStore store(where);
    EXPECT_EQ(store.levels(), 0U);
    const lts::Word row = 3;
    store.enter_row({&row, 1}, lts::StateStore::hash({&row, 1}));
    store.close_level();
    store.checkpoint();
    EXPECT_EQ(newest_checkpoints().at(0).number, 8U);
}

// The reported error is that of the rank in which it occurred, for any reports of the other ranks.
TEST(Ranks, ThrowTheErrorOfTheRankThatHasMetIt) {
    const auto work = [](Exchange& exchange) {
        SharedWork shared(exchange);
        shared.execute_part([&] {
            if (exchange.rank() == 1) throw storage::BadFile("damaged");
        });
        EXPECT_FALSE(exchange.left_together());
        try {
            shared.sum({});
        } catch (...) {
            EXPECT_TRUE(exchange.left_together());
            throw;
        }
    };
    EXPECT_THROW(as_ranks(3, work), storage::BadFile);
}

std::uint64_t virtual_pages() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages;
}

/// Runs `work` in a program without memory for the stacks of many threads. Returns its exit code, which is 3 if the
/// program reports a limit with these words.
int end_without_stacks(const std::string& words, const std::function<void()>& work) {
    const pid_t child = fork();
    if (child == 0) {
        rlimit limit{};
        getrlimit(RLIMIT_AS, &limit);
        limit.rlim_cur = virtual_pages() * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) + (64U << 20U);
        setrlimit(RLIMIT_AS, &limit);
        try {
            work();
        } catch (const LimitReached& reached) {
            _exit(std::string(reached.what()).find(words) == 0 ? 3 : 5);
        } catch (...) {
            _exit(4);
        }
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(ThreadTeams, EndWhereAThreadCannotBeStarted) {
    EXPECT_EQ(end_without_stacks("200 threads cannot be started", [] { const ThreadTeam team(200); }), 3);
}

TEST(Ranks, EndWhereAThreadCannotBeStarted) {
    const auto work = [](Exchange& exchange) { exchange.sum({}); };
    EXPECT_EQ(end_without_stacks("200 threads cannot be started", [&] { as_ranks(200, work); }), 3);
}

// The other program is notified, and both programs leave together.
TEST(Ranks, EndTogetherWhereAThreadOfAProgramCannotBeStarted) {
    const auto work = [](Exchange& exchange) { exchange.sum({}); };
    const auto as_two_programs = [&] {
        as_ranks(2, [&](Exchange& programs) {
            try {
                as_ranks(programs, 200, work);
            } catch (const LimitReached&) {
                if (!programs.left_together()) _exit(6);
                throw;
            }
        });
    };
    EXPECT_EQ(end_without_stacks("program ", as_two_programs), 3);
}

TEST(RowFilters, ContainAllRowsAndHaveFewFalsePositives) {
    std::mt19937_64 random(7);
    // A lookup compares the entries of about two buckets. With 4 bits and with 1 bit, it compares 7.6 entries in each
    // bucket (53 entries in seven parts), and with 16 bits 0.8.
    struct Expected {
        unsigned bits;
        int least, most;  ///< false positives
    };
    for (const auto& [bits, least, most] : {Expected{1, 45'000, 50'000}, Expected{4, 10'000, 35'000},
                                            Expected{16, 0, 5}, Expected{24, 0, 1}, Expected{32, 0, 1}}) {
        RowFilter filter(bits, 1U << 20U);
        filter.reset(20'000);
        std::vector<std::uint64_t> hashes;
        while (filter.size() < filter.capacity()) {
            hashes.push_back(random());
            filter.add(hashes.back());
        }
        for (const std::uint64_t hash : hashes) ASSERT_TRUE(filter.may_have(hash));
        int wrong = 0;
        for (int i = 0; i < 50'000; ++i) wrong += filter.may_have(random()) ? 1 : 0;
        EXPECT_GE(wrong, least);
        EXPECT_LE(wrong, most);
        EXPECT_GE(filter.capacity(), 40'000U) << "twice as many";
        EXPECT_LT(filter.bytes(), filter.capacity() * ((bits + 7) / 8 * 10 / 9 + 2));
    }
}

// The number of bits of an entry depends on the number of rows. With 32 bits, 64 bytes store 14 rows in 49 parts, and
// 19 of 20 slots are used. With 24, 16 and 8 bits, they store 18 rows in 45 parts, 28 in 35 and 56 in 7. With 24 bits,
// 11,000 rows cause almost no false positive, and 10 million rows cause half a false positive on average.
TEST(RowFilters, KeepFewerBitsWhereMemoryIsShort) {
    RowFilter filter(32, 64'000);
    const std::tuple<std::uint64_t, double, double> expected[] = {
        {11'000, 24, 45}, {14'000, 24, 45}, {22'000, 16, 35}, {44'000, 8, 7}};
    for (const auto& [rows, bits, parts] : expected) {
        filter.reset(rows);
        EXPECT_LE(filter.bytes(), 64'000U);
        ASSERT_GE(filter.capacity(), rows);
        std::mt19937_64 random(rows);
        for (std::uint64_t i = 0; i < rows; ++i) filter.add(random());
        const double entries = 64.0 * static_cast<double>(rows) / static_cast<double>(filter.bytes());
        const double in_one_bucket = entries / parts / std::exp2(bits);
        EXPECT_GE(filter.error(), in_one_bucket) << rows;
        EXPECT_LE(filter.error(), 2 * in_one_bucket) << rows;
        std::mt19937_64 again(rows);
        for (std::uint64_t i = 0; i < rows; ++i) ASSERT_TRUE(filter.may_have(again()));
    }
    RowFilter large(32, 1U << 26U);
    large.reset(10'000'000);
    EXPECT_EQ(large.capacity(), (1U << 20U) * 14U * 19 / 20);
    filter.reset(60'000);
    EXPECT_EQ(filter.capacity(), 0U);
    EXPECT_EQ(filter.bytes(), 0U);
    EXPECT_EQ(filter.error(), 1);
    EXPECT_TRUE(filter.may_have(1)) << "it may have every row";
}

}  // namespace
}  // namespace robochart::refine
