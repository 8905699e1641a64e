// SPDX-License-Identifier: Apache-2.0
// Tests checks whose searches are stored in a folder. They have the same answers, figures and counterexamples as level
// searches in memory, even after kills at any time. They reject folders of other runs.
#include "checker/refine/verdict/kept_search.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include "base/diagnostics/files.hpp"
#include "checker/lts/graph.hpp"
#include "checker/refine/verdict/check.hpp"
#include "checker/storage/file_lock.hpp"
#include "tests/file_limit.hpp"

namespace {

/// True if the file system supports locks.
bool has_locks = true;

}  // namespace

/// Replaces flock, and locks files as NFS does (flock(2), "NFS details"): an exclusive lock needs a file that is open
/// for writing, and other machines do not see locks of folders.
extern "C" int flock(int file, int operation) noexcept {
    struct stat found {};
    (void)::fstat(file, &found);
    if (S_ISDIR(found.st_mode)) return 0;
    const bool writable = (::fcntl(file, F_GETFL) & O_ACCMODE) != O_RDONLY;
    if (!has_locks || ((operation & LOCK_EX) != 0 && !writable)) {
        errno = has_locks ? EBADF : ENOLCK;
        return -1;
    }
    return static_cast<int>(::syscall(SYS_flock, file, operation));
}

namespace robochart::refine {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// Returns a graph with levels of thousands of states, and with a deadlock at the end, a tau cycle, or neither.
lts::Graph wide_graph(unsigned seed, bool deadlock, bool divergence) {
    std::mt19937 random(seed);
    lts::Graph graph;
    constexpr std::size_t states = 6000;
    for (std::size_t state = 0; state < states; ++state) {
        const bool last = state + 1 == states;
        for (int i = 0; i < 3 && !(last && deadlock); ++i) {
            const bool back = state > 0 && i > 0 && random() % 3 == 0;
            const std::size_t forward = std::min<std::size_t>(states - 1, 1 + state + random() % (30 + state / 2));
            const auto target = static_cast<lts::StateIndex>(back ? random() % (state + 1) : forward);
            const bool tau = random() % 5 == 0 && (divergence || target > state);
            graph.add_edge(
                {tau ? process::tau : static_cast<process::Event>(process::tick + 1 + random() % 3), target});
        }
        if (divergence && state % 50 == 49) graph.add_edge({process::tau, static_cast<lts::StateIndex>(state)});
        graph.finish_state();
    }
    return graph;
}

struct Asked {
    std::string text;
    lts::Graph graph;
};

class KeptSearches : public ::testing::Test {
protected:
    KeptSearches() {
        asked_.push_back({"holds", wide_graph(1, false, false)});
        asked_.push_back({"deadlocks", wide_graph(2, true, false)});
        asked_.push_back({"diverges", wide_graph(3, false, true)});
    }

    [[nodiscard]] KeptSettings settings(bool resume, bool disk) const {
        KeptSettings settings;
        settings.folder = checkpoint_folder();
        settings.resume = resume;
        settings.disk = disk;
        settings.every = std::chrono::milliseconds(0);
        settings.program = "this program";
        settings.most_bytes = 16U << 10U;
        settings.filter_bits = 1;
        settings.reads_a_step = 0;
        return settings;
    }
    [[nodiscard]] std::string checkpoint_folder() const { return folder_.path() + "/kept"; }
    [[nodiscard]] bool checkpoint_exists() const { return fs::exists(checkpoint_folder() + "/questions"); }

    static diagnostics::Digest digest(const std::string& text) {
        diagnostics::Hasher hasher;
        hasher.add(std::string_view(text));
        return hasher.finish();
    }
    /// Returns the answers, figures and runs.
    std::string decide(LevelStrategy& strategy, std::uint64_t most_states = 1'000'000) {
        std::string all;
        for (const Asked& question : asked_) {
            Limits limits;
            limits.by_levels = &strategy;
            limits.max_states = most_states;
            const process::EventTable table;
            lts::GraphSystem system(question.graph, table);
            strategy.begin_question(question.text);
            strategy.identify_question(digest(question.text));
            const Verdict verdict = deadlock_free(system, Model::failures_divergences, limits);
            strategy.end_question(verdict.outcome != Outcome::inconclusive);
            rolled_back_ += verdict.statistics.rolled_back;
            all += question.text + " " + std::to_string(static_cast<int>(verdict.outcome)) + " " + verdict.reason +
                   " " + std::to_string(verdict.statistics.states) + " " +
                   std::to_string(verdict.statistics.transitions) + " " + std::to_string(verdict.statistics.depth);
            if (verdict.counterexample) {
                for (const Step& step : verdict.counterexample->steps) all += " " + step.state;
                for (const Step& step : verdict.counterexample->loop) all += " / " + step.state;
            }
            all += "\n";
        }
        strategy.all_asked();
        return all;
    }
    std::string in_memory() {
        ThreadRanks strategy(1);
        return decide(strategy);
    }

    std::string error_;
    diagnostics::TemporaryFolder folder_{"", error_};
    std::vector<Asked> asked_;
    ThreadRanks threads_{1};
    std::uint64_t rolled_back_ = 0;  ///< of all searches
};

TEST_F(KeptSearches, HaveTheAnswersOfThoseInMemory) {
    const std::string expected = in_memory();
    EXPECT_THAT(expected, HasSubstr("deadlocks 1 "));
    EXPECT_THAT(expected, HasSubstr("diverges 1 "));
    for (const bool disk : {false, true}) {
        rolled_back_ = 0;
        {
            KeptSearch search(settings(false, disk), threads_);
            EXPECT_EQ(decide(search), expected);
        }
        EXPECT_EQ(rolled_back_ > 0, disk);
        EXPECT_FALSE(fs::exists(checkpoint_folder())) << "all is decided";
    }
}

TEST_F(KeptSearches, GoOnAfterKillsAtAnyMoment) {
    const std::string expected = in_memory();
    std::mt19937 random(4);
    int killed = 0;
    for (int round = 0; round < 3; ++round) {
        for (int kill = 0; kill < 10; ++kill) {
            const bool disk = random() % 2 == 0;
            const unsigned ranks = static_cast<unsigned>(1 + random() % 3);
            const pid_t child = fork();
            ASSERT_GE(child, 0);
            if (child == 0) {
                try {
                    ThreadRanks threads(ranks);
                    KeptSearch search(settings(checkpoint_exists(), disk), threads);
                    (void)decide(search);
                } catch (const std::exception& wrong) {
                    std::fprintf(stderr, "%s\n", wrong.what());
                    _exit(1);
                }
                _exit(0);
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1 + random() % 400));
            ::kill(child, SIGKILL);
            int status = 0;
            waitpid(child, &status, 0);
            ASSERT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) != 0);
            if (WIFSIGNALED(status)) ++killed;
        }
        KeptSearch search(settings(checkpoint_exists(), false), threads_);
        ASSERT_EQ(decide(search), expected);
    }
    EXPECT_GE(killed, 5);
}

TEST_F(KeptSearches, GoOnAfterALimit) {
    const std::string expected = in_memory();
    {
        KeptSearch search(settings(false, true), threads_);
        EXPECT_THAT(decide(search, 2000), HasSubstr("the limit of 2000 states was reached"));
    }
    ASSERT_TRUE(checkpoint_exists());
    KeptSearch search(settings(true, false), threads_);
    EXPECT_EQ(decide(search), expected);
}

TEST_F(KeptSearches, KeepTheLastCheckpointWhereTheDiskIsFull) {
    const std::string expected = in_memory();
    std::string found;
    {
        const tests::FileLimit limit(1000);
        KeptSettings own = settings(false, true);
        own.every = std::chrono::hours(1);
        KeptSearch search(std::move(own), threads_);
        found = decide(search);
    }
    EXPECT_THAT(found, HasSubstr("holds 2 cannot write "));
    KeptSearch search(settings(true, false), threads_);
    EXPECT_EQ(decide(search), expected);
}

TEST_F(KeptSearches, RefuseTheFolderOfAnother) {
    {
        KeptSearch search(settings(false, false), threads_);
        (void)decide(search, 2000);
    }
    const auto why = [](const auto& act) -> std::string {
        try {
            act();
        } catch (const storage::BadFile& refused) {
            return refused.what();
        }
        return "";
    };
    EXPECT_THAT(why([&] { KeptSearch again(settings(false, false), threads_); }),
                HasSubstr("--resume goes on from there"));
    KeptSettings newer = settings(true, false);
    newer.program = "another program";
    EXPECT_THAT(why([&] { KeptSearch other(newer, threads_); }),
                HasSubstr("questions: line 2: another version of the program"));
    KeptSettings absent = settings(true, false);
    absent.folder = folder_.path();
    EXPECT_THAT(why([&] { KeptSearch nothing(absent, threads_); }), HasSubstr("there is no checkpoint in this folder"));
    {
        KeptSearch search(settings(true, false), threads_);
        EXPECT_THAT(why([&] { KeptSearch second(settings(true, false), threads_); }),
                    HasSubstr("another run is using"));
        EXPECT_THAT(why([&] { search.begin_question("other"); }), HasSubstr("this run asks `other`"));
        search.begin_question("holds");
        EXPECT_THAT(why([&] { search.identify_question(digest("otherwise")); }),
                    HasSubstr("written for question 1, `holds`, about other processes or with other options"));
    }
    std::ofstream(checkpoint_folder() + "/questions") << "x";
    EXPECT_THAT(why([&] { KeptSearch other(settings(true, false), threads_); }), HasSubstr("questions: line 1"));
}

std::string refusal(const std::function<void()>& act) {
    try {
        act();
    } catch (const storage::BadFile& refused) {
        return refused.what();
    }
    return "";
}

TEST_F(KeptSearches, NeedTheIdentityOfTheProgram) {
    KeptSettings own = settings(false, false);
    own.program.clear();
    EXPECT_THAT(refusal([&] { KeptSearch search(own, threads_); }), HasSubstr("without a build ID"));
    EXPECT_FALSE(fs::exists(checkpoint_folder()));
}

TEST_F(KeptSearches, LeaveTheFilesOfOthersAlone) {
    fs::create_directories(checkpoint_folder() + "/finished-work");
    std::ofstream(checkpoint_folder() + "/finished-work/notes") << "mine";
    EXPECT_THAT(refusal([&] { KeptSearch search(settings(false, false), threads_); }),
                HasSubstr("there are other files"));
    EXPECT_TRUE(fs::exists(checkpoint_folder() + "/finished-work/notes"));
    EXPECT_FALSE(checkpoint_exists());
    fs::remove_all(checkpoint_folder());
    {
        KeptSearch search(settings(false, false), threads_);
        search.begin_question("holds");
    }
    const std::vector<std::string> others{"finished-work", "finished-search-", "finished-search-0123456789abcdeg",
                                          "finished-search-0123456789abcdef0"};
    for (const std::string& name : others) fs::create_directory(checkpoint_folder() + "/" + name);
    fs::create_directory(checkpoint_folder() + "/finished-search-0123456789abcdef");
    KeptSearch search(settings(true, false), threads_);
    for (const std::string& name : others) EXPECT_TRUE(fs::exists(checkpoint_folder() + "/" + name)) << name;
    EXPECT_FALSE(fs::exists(checkpoint_folder() + "/finished-search-0123456789abcdef"));
}

// If a run is killed before it has renamed the first file of the folder, this file still has its temporary name.
TEST_F(KeptSearches, TakeAFolderThatAKilledRunHasBegun) {
    const std::string left = checkpoint_folder() + "/.robochart-0123456789abcdef";
    fs::create_directories(checkpoint_folder());
    std::ofstream(left) << "half";
    std::ofstream(checkpoint_folder() + "/.robochart-notes") << "mine";
    EXPECT_THAT(refusal([&] { KeptSearch search(settings(false, false), threads_); }),
                HasSubstr("there are other files"));
    EXPECT_TRUE(fs::exists(left)) << "nothing is removed from a folder of others";
    fs::remove(checkpoint_folder() + "/.robochart-notes");
    KeptSearch search(settings(false, false), threads_);
    EXPECT_TRUE(checkpoint_exists());
    EXPECT_FALSE(fs::exists(left));
}

TEST_F(KeptSearches, LeaveNothingWhereNothingWasAsked) {
    { KeptSearch search(settings(false, false), threads_); }
    EXPECT_FALSE(fs::exists(checkpoint_folder()));
}

// The folder keeps answers until the verb reports that all questions are decided.
TEST_F(KeptSearches, KeepAnswersWhereAQuestionIsOpen) {
    const auto decided = [&](KeptSearch& search) {
        search.begin_question("holds");
        search.identify_question(digest("holds"));
        search.answers()->store_entry(digest("holds"), "yes");
        search.end_question(true);
    };
    {
        KeptSearch search(settings(false, false), threads_);
        decided(search);
    }
    {
        KeptSearch search(settings(true, false), threads_);
        EXPECT_EQ(search.answers()->find(digest("holds")), "yes");
        decided(search);
        search.begin_question("other");  // which never gets a digest
        search.all_asked();
    }
    KeptSearch search(settings(true, false), threads_);
    EXPECT_EQ(search.answers()->find(digest("holds")), "yes");
    EXPECT_THAT(refusal([&] { search.begin_question("other"); }), HasSubstr("written for question 1, `holds`"));
    decided(search);
    search.all_asked();
    EXPECT_TRUE(checkpoint_exists()) << "one more was asked before";
    search.begin_question("other");
    search.identify_question(digest("other"));
    search.end_question(true);
    search.all_asked();
    EXPECT_FALSE(fs::exists(checkpoint_folder()));
}

// If an answer was not saved, only its search remains. The check begins again with wider rows, and identifies its
// assertion again.
TEST_F(KeptSearches, IdentifyAQuestionAgainAfterARunThatNeverDid) {
    {
        KeptSearch search(settings(false, false), threads_);
        search.begin_question("holds");
    }
    KeptSearch search(settings(true, false), threads_);
    search.begin_question("holds");
    search.identify_question(digest("holds"));
    EXPECT_EQ(refusal([&] { search.identify_question(digest("holds")); }), "");
}

TEST_F(KeptSearches, KeepTheSearchOfAnAnswerThatIsNot) {
    const auto searches = [&] {
        std::size_t count = 0;
        for (const auto& entry : fs::directory_iterator(checkpoint_folder()))
            if (entry.path().filename().string().starts_with("search-")) ++count;
        return count;
    };
    for (const bool answered : {false, true}) {
        KeptSearch search(settings(false, false), threads_);
        Limits limits;
        limits.by_levels = &search;
        const process::EventTable table;
        lts::GraphSystem system(asked_[0].graph, table);
        search.begin_question("holds");
        search.identify_question(digest("holds"));
        EXPECT_EQ(deadlock_free(system, Model::failures, limits).outcome, Outcome::holds);
        EXPECT_EQ(searches(), 1U);
        if (answered) search.answers()->store_entry(digest("holds"), "yes");
        search.end_question(true);
        EXPECT_EQ(searches(), answered ? 0U : 1U);
        search.all_asked();
        EXPECT_FALSE(fs::exists(checkpoint_folder()));
    }
}

TEST_F(KeptSearches, RefuseQuestionsThatAreNoList) {
    {
        KeptSearch search(settings(false, false), threads_);
        search.begin_question("holds");
    }
    const auto why = [&] { return refusal([&] { KeptSearch search(settings(true, false), threads_); }); };
    EXPECT_EQ(why(), "");
    std::ofstream(checkpoint_folder() + "/questions", std::ios::app) << digest("x").size() << std::string(10'000, 'a');
    EXPECT_THAT(why(), HasSubstr("questions: line 4: it cannot be read, or is too long"));
    fs::remove(checkpoint_folder() + "/questions");
    fs::create_directory(checkpoint_folder() + "/questions");
    EXPECT_THAT(why(), HasSubstr("questions: this is no file"));
    fs::remove(checkpoint_folder() + "/questions");
    fs::create_symlink("/dev/zero", checkpoint_folder() + "/questions");
    EXPECT_THAT(why(), HasSubstr("questions: this is no file"));
}

TEST_F(KeptSearches, SayWhereTheFileSystemHasNoLocks) {
    {
        KeptSearch search(settings(false, false), threads_);
        (void)decide(search, 2000);
    }
    has_locks = false;
    const std::string why = refusal([&] { KeptSearch search(settings(true, false), threads_); });
    has_locks = true;
    EXPECT_THAT(why, HasSubstr("kept: it cannot be locked: No locks available: the file system must have locks"));
    KeptSearch search(settings(true, false), threads_);
    EXPECT_EQ(decide(search), in_memory());
}

// A lock on a removed file is ignored, because a run that has removed the lock file of the folder has ended.
TEST_F(KeptSearches, LockTheFileThatIsThere) {
    const std::string path = folder_.path() + "/lock";
    const diagnostics::Descriptor before = storage::open_to_lock(path, true);
    ASSERT_TRUE(before.is_open());
    fs::remove(path);
    EXPECT_EQ(storage::lock(before, path, storage::Lock::exclusive, "in use"), "in use");
    const diagnostics::Descriptor after = storage::open_to_lock(path, true);
    EXPECT_EQ(storage::lock(before, path, storage::Lock::shared, "in use"), "in use");
    EXPECT_EQ(storage::lock(after, path, storage::Lock::shared, "in use"), "");
    EXPECT_EQ(storage::lock(after, path, storage::Lock::exclusive, "in use"), "");
    fs::remove(path);
    fs::create_symlink("elsewhere", path);
    EXPECT_FALSE(storage::open_to_lock(path, true).is_open());
}

}  // namespace
}  // namespace robochart::refine
