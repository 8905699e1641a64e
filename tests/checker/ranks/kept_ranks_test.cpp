// SPDX-License-Identifier: Apache-2.0
// Tests searches by ranks in separate programs whose rows are stored in a folder. Other numbers of ranks, and threads
// of one program, stop and resume the searches. Some ranks cannot write, or see another folder.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <thread>
#include <utility>

#include "base/diagnostics/files.hpp"
#include "checker/machine/compiler.hpp"
#include "checker/process/term_system.hpp"
#include "checker/ranks/served_ranks.hpp"
#include "checker/refine/levels/thread_exchange.hpp"
#include "checker/refine/verdict/check.hpp"
#include "checker/refine/verdict/kept_search.hpp"
#include "checker/storage/file_lock.hpp"
#include "tests/checker/process/scripted.hpp"
#include "tests/checker/processes/verdict_text.hpp"
#include "tests/checker/ranks/faulty_exchange.hpp"
#include "tests/checker/ranks/program.hpp"

namespace robochart::ranks {
namespace {

namespace fs = std::filesystem;
using process::Op;
using process::Scripted;
using process::TermId;
using refine::KeptSearch;
using refine::KeptSettings;
using refine::Outcome;
using ::testing::AllOf;
using ::testing::HasSubstr;

class KeptRanks : public testing::Test {
protected:
    using Answers = std::vector<std::string>;

    KeptRanks() {
        std::vector<TermId> all;
        for (const char* cell : {"0", "1", "2", "3", "4", "5"}) {
            std::vector<std::string> events;
            for (const char* event : {"a", "b", "c", "d"}) events.push_back(std::string(event) + cell);
            all.push_back(s_.cycle("C" + std::string(cell), events));
        }
        cells_ = compiler_.compile(s_.over(Op::parallel, all, {}), diagnostics::unlimited);
        // A specification that forbids an event. Six cells can perform the event after a dozen steps.
        TermId few = s_.stop();
        for (int step = 0; step < 12; ++step) {
            std::vector<std::pair<std::string, TermId>> branches;
            for (const char* cell : {"0", "1", "2", "3", "4", "5"})
                for (const char* event : {"a", "b", "c", "d"}) branches.emplace_back(std::string(event) + cell, few);
            few = s_.menu(branches);
        }
        few_ = std::make_unique<process::TermSystem>(semantics_, few);
    }

    [[nodiscard]] std::string checkpoint_folder() const { return folder_.path() + "/kept"; }
    [[nodiscard]] bool checkpoint_exists() const { return fs::exists(checkpoint_folder() + "/questions"); }
    /// Returns the folder of the current search.
    [[nodiscard]] std::string search() const {
        for (const auto& entry : fs::directory_iterator(checkpoint_folder()))
            if (entry.path().filename().string().starts_with("search-")) return entry.path().string();
        return "";
    }
    [[nodiscard]] KeptSettings settings(bool disk) {
        KeptSettings settings;
        settings.folder = checkpoint_folder();
        settings.resume = checkpoint_exists();
        settings.disk = disk;
        settings.every = std::chrono::milliseconds(0);
        settings.program = "this program";
        settings.say = [this](const std::string& what) { said_ += what + "\n"; };
        settings.most_bytes = 16U << 10U;
        settings.filter_bits = 4;
        settings.reads_a_step = 0;
        return settings;
    }

    Answers decide(refine::LevelStrategy& strategy, std::uint64_t most_states, unsigned threads = 1) {
        refine::Limits limits;
        limits.threads = threads;
        limits.by_levels = &strategy;
        limits.max_states = most_states;
        const std::pair<std::string, std::function<refine::Verdict()>> questions[] = {
            {"deadlock free", [&] { return refine::deadlock_free(*cells_, refine::Model::failures, limits); }},
            {"a dozen steps", [&] { return refine::refines(*few_, *cells_, refine::Model::traces, limits); }},
        };
        Answers answers;
        for (const auto& [text, ask] : questions) {
            diagnostics::Hasher hasher;
            hasher.add(std::string_view(text));
            strategy.begin_question(text);
            strategy.identify_question(hasher.finish());
            const refine::Verdict verdict = ask();
            strategy.end_question(verdict.outcome != Outcome::inconclusive);
            answers.push_back(refine::complete_text(verdict));
        }
        strategy.all_asked();
        return answers;
    }
    Answers in_memory() {
        refine::ThreadRanks strategy(1);
        return decide(strategy, 1'000'000);
    }
    /// Decides the questions with programs that know only what they receive. There are `count` ranks in all.
    Answers by_ranks(unsigned count, bool disk, std::uint64_t most_states = 1'000'000, unsigned threads = 1) {
        Answers answers;
        refine::as_ranks(count, [&](refine::Exchange& exchange) {
            if (exchange.rank() != 0) return serve_searches(exchange, program);
            ServedRanks served(exchange, program);
            KeptSearch search(settings(disk), served);
            answers = decide(search, most_states, threads);
        });
        return answers;
    }
    Answers by_threads(unsigned count, bool disk, std::uint64_t most_states) {
        refine::ThreadRanks threads(count);
        KeptSearch search(settings(disk), threads);
        return decide(search, most_states);
    }

    std::string error_;
    diagnostics::TemporaryFolder folder_{"", error_};
    Scripted s_;
    process::OperationalSemantics semantics_{s_.store};
    machine::Compiler compiler_{semantics_};
    std::unique_ptr<lts::TransitionSystem> cells_, few_;
    std::string said_;
};

TEST_F(KeptRanks, GoOnFromWhatOtherNumbersOfRanksHaveKept) {
    const Answers expected = in_memory();
    ASSERT_EQ(expected[0].front(), '0' + static_cast<int>(Outcome::holds));
    ASSERT_EQ(expected[1].front(), '0' + static_cast<int>(Outcome::fails));
    for (const bool disk : {false, true}) {
        const auto limited = HasSubstr("states was reached");
        EXPECT_THAT(by_ranks(2, disk, 500)[0], limited);
        const storage::Newest first = storage::newest_in(search());
        EXPECT_EQ(first.ranks, 2U);
        EXPECT_THAT(by_ranks(3, !disk, 1500)[0], limited);
        const storage::Newest second = storage::newest_in(search());
        EXPECT_EQ(second.ranks, 3U);
        EXPECT_GT(second.number, first.number);
        EXPECT_THAT(by_threads(2, disk, 2000)[0], limited);
        EXPECT_THAT(by_ranks(2, disk, 3000, 2)[0], limited);
        EXPECT_EQ(storage::newest_in(search()).ranks, 4U);
        EXPECT_EQ(by_ranks(2, disk), expected);
        EXPECT_FALSE(fs::exists(checkpoint_folder())) << "all is decided";
    }
    EXPECT_EQ(said_.find("begins anew"), std::string::npos) << said_;
}

// The path at which a rank wants to write its part of the next checkpoint is already a folder.
TEST_F(KeptRanks, LeaveTheSearchTogetherWhereOneCannotWrite) {
    const Answers expected = in_memory();
    (void)by_ranks(2, false, 500);
    const std::string place =
        search() + "/checkpoint-" + std::to_string(storage::newest_in(search()).greatest + 1) + "-1-of-3.unfinished";
    ASSERT_TRUE(fs::create_directory(place));
    const Answers found = by_ranks(3, false);
    EXPECT_THAT(found[0], AllOf(HasSubstr(std::to_string(static_cast<int>(Outcome::inconclusive)) + "cannot write "),
                                HasSubstr(fs::path(place).filename().string())));
    EXPECT_EQ(found[1], expected[1]) << "the ranks are still there";
    ASSERT_TRUE(fs::remove(place));
    EXPECT_EQ(by_ranks(2, false), expected);
}

/// The exchange of a rank that sees the folder under another name.
class OtherFolder final : public refine::Exchange {
public:
    OtherFolder(refine::Exchange& real, std::string from, std::string to)
        : real_(real), from_(std::move(from)), to_(std::move(to)) {}
    [[nodiscard]] unsigned rank() const override { return real_.rank(); }
    [[nodiscard]] unsigned ranks() const override { return real_.ranks(); }
    void all_to_all(const refine::Messages& out, refine::Messages& in) override { real_.all_to_all(out, in); }
    void sum(std::span<std::uint64_t> values) override { real_.sum(values); }
    [[nodiscard]] std::vector<refine::Words> gather(const refine::Words& own) override { return real_.gather(own); }
    void broadcast(std::string& bytes) override {
        real_.broadcast(bytes);
        if (const std::size_t at = bytes.find(from_); at != std::string::npos) bytes.replace(at, from_.size(), to_);
    }

private:
    refine::Exchange& real_;
    std::string from_, to_;
};

TEST_F(KeptRanks, AreRefusedWhereOneSeesAnotherFolder) {
    const Answers expected = in_memory();
    const std::string other = folder_.path() + "/tepk";
    for (const bool there_too : {false, true}) {
        if (there_too) fs::copy(checkpoint_folder(), other, fs::copy_options::recursive);
        std::string why;
        refine::as_ranks(2, [&](refine::Exchange& exchange) {
            OtherFolder own(exchange, checkpoint_folder(), other);
            if (exchange.rank() != 0) return serve_searches(own, program);
            ServedRanks served(exchange, program);
            KeptSearch search(settings(false), served);
            try {
                (void)decide(search, 1'000'000);
            } catch (const storage::BadFile& refused) {
                why = refused.what();
            }
            EXPECT_FALSE(served.others_wait());
        });
        EXPECT_THAT(why, AllOf(HasSubstr("/tepk/search-"), HasSubstr("/run: rank 1: "),
                               HasSubstr(there_too ? "it is of another run" : "No such file"),
                               HasSubstr("all ranks must see the folder that rank 0 sees")));
        EXPECT_TRUE(checkpoint_exists());
    }
    EXPECT_EQ(by_ranks(2, false), expected);
}

// A rank runs out of memory during an exchange and saves its part alone. The other ranks write nothing more.
TEST_F(KeptRanks, GoOnWhereOneHasFailedAlone) {
    const Answers expected = in_memory();
    for (const unsigned failing : {0U, 1U}) {
        const auto work = [&](refine::Exchange& real) {
            const bool own = real.rank() == failing;
            FaultyExchange faulty(real, own ? 30 : ~std::uint64_t{0}, FaultyExchange::Fault::memory);
            if (real.rank() != 0) return serve_searches(faulty, program);
            ServedRanks served(faulty, program);
            KeptSearch search(settings(false), served);
            EXPECT_THAT(decide(search, 1'000'000)[0], HasSubstr("there is no more memory"));
            EXPECT_TRUE(served.others_wait());
            throw std::runtime_error("the first rank ends");
        };
        EXPECT_ANY_THROW(refine::as_ranks(2, work)) << failing;
        EXPECT_EQ(by_ranks(failing == 0 ? 3 : 2, false), expected) << failing;
    }
    EXPECT_EQ(said_.find("begins anew"), std::string::npos) << said_;
}

// If the first rank of a run is killed, the other ranks may continue to write for a moment.
TEST_F(KeptRanks, AreRefusedWhileRanksOfAnEarlierRunUseTheFolder) {
    const Answers expected = in_memory();
    (void)by_ranks(2, false, 500);
    {
        const diagnostics::Descriptor rank(::open((search() + "/" + refine::run_name).c_str(), O_RDONLY | O_CLOEXEC));
        ASSERT_TRUE(rank.is_open());
        ASSERT_EQ(::flock(rank.get(), LOCK_SH | LOCK_NB), 0);
        try {
            (void)by_ranks(2, false);
            ADD_FAILURE() << "it is not refused";
        } catch (const storage::BadFile& refused) {
            EXPECT_THAT(refused.what(), HasSubstr("ranks of an earlier run are still using this folder"));
        }
    }
    EXPECT_EQ(by_ranks(2, false), expected);
}

// One rank fails alone during the last checkpoint. It knows that the other ranks wait for it.
TEST_F(KeptRanks, KnowWhoWaitsWhereOneFailsInTheLastCheckpoint) {
    const auto stop_at = [&](std::uint64_t call, std::uint64_t& left) {
        bool failed = false;
        const auto work = [&](refine::Exchange& real) {
            if (real.rank() != 0) return serve_searches(real, program);
            FaultyExchange faulty(real, call, FaultyExchange::Fault::memory);
            ServedRanks served(faulty, program);
            KeptSearch search(settings(false), served);
            refine::Limits limits;
            limits.by_levels = &search;
            limits.max_states = 300;
            search.begin_question("deadlock free");
            search.identify_question(diagnostics::Hasher().finish());
            const refine::Verdict verdict = refine::deadlock_free(*cells_, refine::Model::failures, limits);
            EXPECT_EQ(verdict.outcome, Outcome::inconclusive);
            left = faulty.calls_left();
            failed = faulty.has_failed();
            EXPECT_EQ(served.others_wait(), failed) << call;
            if (failed) throw std::runtime_error("the first rank ends");
        };
        try {
            refine::as_ranks(2, work);
        } catch (const std::exception&) {
            EXPECT_TRUE(failed);
        }
        fs::remove_all(checkpoint_folder());
        return failed;
    };
    std::uint64_t left = 0;
    EXPECT_FALSE(stop_at(std::uint64_t{1} << 32U, left));
    const std::uint64_t calls = (std::uint64_t{1} << 32U) - left;
    ASSERT_GT(calls, 20U);
    for (std::uint64_t call = calls - 4; call < calls; ++call) EXPECT_TRUE(stop_at(call, left)) << call;
}

/// The exchange of a rank that returns late from every collective operation.
class LateExchange final : public refine::Exchange {
public:
    /// `late` is called after every operation.
    LateExchange(refine::Exchange& real, std::function<void()> late) : real_(real), late_(std::move(late)) {}
    [[nodiscard]] unsigned rank() const override { return real_.rank(); }
    [[nodiscard]] unsigned ranks() const override { return real_.ranks(); }
    void all_to_all(const refine::Messages& out, refine::Messages& in) override {
        real_.all_to_all(out, in);
        late_();
    }
    void sum(std::span<std::uint64_t> values) override {
        real_.sum(values);
        late_();
    }
    [[nodiscard]] std::vector<refine::Words> gather(const refine::Words& own) override {
        std::vector<refine::Words> all = real_.gather(own);
        late_();
        return all;
    }
    void broadcast(std::string& bytes) override {
        real_.broadcast(bytes);
        late_();
    }

private:
    refine::Exchange& real_;
    std::function<void()> late_;
};

// After a search, the first rank may remove the folder or start another search in it. So all ranks must have released
// the folder.
TEST_F(KeptRanks, HaveLetGoOfTheFolderWhereASearchHasEnded) {
    const auto late = [] { std::this_thread::sleep_for(std::chrono::milliseconds(2)); };
    for (const std::uint64_t most_states : {50U, 300U})
        refine::as_ranks(2, [&](refine::Exchange& real) {
            LateExchange exchange(real, late);
            if (real.rank() != 0) return serve_searches(exchange, program);
            ServedRanks served(real, program);
            KeptSearch kept_search(settings(false), served);
            refine::Limits limits;
            limits.by_levels = &kept_search;
            limits.max_states = most_states;
            kept_search.begin_question("deadlock free");
            kept_search.identify_question(diagnostics::Hasher().finish());
            const refine::Verdict verdict = refine::deadlock_free(*cells_, refine::Model::failures, limits);
            EXPECT_EQ(verdict.outcome, Outcome::inconclusive);
            const std::string run = search() + "/" + refine::run_name;
            const diagnostics::Descriptor file = storage::open_to_lock(run, false);
            ASSERT_TRUE(file.is_open());
            EXPECT_EQ(storage::lock(file, run, storage::Lock::exclusive, "in use"), "");
        });
}

// A limit is reached while the first rank waits for another one. The rank must not be killed before the checkpoint is
// complete.
TEST_F(KeptRanks, AreNotKilledWhileTheyWaitAfterALimit) {
    std::atomic<bool> interrupted{false};
    std::atomic<int> held{0}, disturbed{0};
    const auto undisturbed = [&]() -> std::shared_ptr<void> {
        ++held;
        const auto release = [&](void*) {
            if (--held == 0 && interrupted && storage::newest_in(search()).ranks != 2) ++disturbed;
        };
        return {&held, release};
    };
    refine::as_ranks(2, [&](refine::Exchange& real) {
        int calls = 0;
        // Keeps the other rank busy at a time when all ranks have stored some levels.
        const auto at_work = [&] {
            if (++calls != 30) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(50));  // the first rank leaves the previous call
            const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
            while (held == 0 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
            EXPECT_GT(held, 0) << "the first rank could be ended by force";
            interrupted = true;
        };
        LateExchange exchange(real, at_work);
        if (real.rank() != 0) return serve_searches(exchange, program);
        ServedRanks served(real, program);
        KeptSettings own = settings(false);
        own.every = std::chrono::hours(1);
        KeptSearch search(own, served);
        refine::Limits limits;
        limits.by_levels = &search;
        limits.undisturbed = undisturbed;
        limits.interrupted = [&] { return interrupted.load(); };
        search.begin_question("deadlock free");
        search.identify_question(diagnostics::Hasher().finish());
        const refine::Verdict verdict = refine::deadlock_free(*cells_, refine::Model::failures, limits);
        EXPECT_EQ(verdict.reason, "the run was interrupted");
    });
    EXPECT_TRUE(interrupted);
    EXPECT_EQ(storage::newest_in(search()).ranks, 2U);
    EXPECT_EQ(disturbed, 0);
    EXPECT_EQ(held, 0);
}

}  // namespace
}  // namespace robochart::ranks
