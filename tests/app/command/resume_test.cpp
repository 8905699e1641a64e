// SPDX-License-Identifier: Apache-2.0
// Tests runs that SIGKILL, another signal or a full disk ends during a search, and that are then resumed. They must
// have the answers, figures and counterexamples of an uninterrupted run.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "tests/app/command.hpp"

namespace robochart::app::testing::resume_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Two parallel compositions of eight processes. The first has 4^8 states. The second also has the state after `last`,
/// which all processes perform together after 24 steps.
constexpr const char* script = R"(
channel a : {0..7}.{0..3}
channel last
ROUND(i, n) = a.i.n -> ROUND(i, (n + 1) % 4)
ONCE(i, n) = if n == 3 then last -> STOP else a.i.n -> ONCE(i, n + 1)
assert ||| i : {0..7} @ ROUND(i, 0) :[deadlock free [F]]
assert [| {last} |] i : {0..7} @ ONCE(i, 0) :[deadlock free [F]]
)";

/// Sequential processes, which the checker does not split into components. ROUND has 31^3 states, and its last state
/// leads back to the first. ONCE is the same without the step back, so it stops after 90 steps. GROW stores sequences
/// of up to 12 elements, so later states need wider rows than the first ones.
constexpr const char* sequential = R"(
channel a : {0..2}
ROUND(x, y, z) = UP(x, y, z) [] x + y + z == 90 & a.0 -> ROUND(0, 0, 0)
UP(x, y, z) = x < 30 & a.0 -> ROUND(x + 1, y, z) [] y < 30 & a.1 -> ROUND(x, y + 1, z) [] z < 30 & a.2 -> ROUND(x, y, z + 1)
ONCE(x, y, z) = x < 30 & a.0 -> ONCE(x + 1, y, z) [] y < 30 & a.1 -> ONCE(x, y + 1, z) [] z < 30 & a.2 -> ONCE(x, y, z + 1)
GROW(s) = #s < 12 & a?x:{0, 1} -> GROW(s ^ <x>) [] #s == 12 & a.2 -> GROW(<>)
assert ROUND(0, 0, 0) :[deadlock free [F]]
assert GROW(<>) :[deadlock free [F]]
assert ONCE(0, 0, 0) :[deadlock free [F]]
)";

class Resumed : public ::testing::Test {
protected:
    explicit Resumed(const char* text = script) : folder_{{{"script.csp", text}}} {}

    /// Returns the command that decides the script. It resumes from a checkpoint in the folder, if there is one.
    std::vector<std::string> command(const std::vector<std::string>& options) const {
        const bool again = std::filesystem::exists(folder_ / "kept/questions");
        std::vector<std::string> all{"cspm",           folder_ / "script.csp",
                                     "--no-reduction", "--format",
                                     "json",           again ? "--resume" : "--checkpoint",
                                     folder_ / "kept"};
        all.insert(all.end(), options.begin(), options.end());
        return all;
    }
    Ran decide(const std::vector<std::string>& options) const { return run(command(options)); }
    /// Sends SIGKILL or another signal at a random moment. If `later`, the signal comes only after the first
    /// checkpoint.
    Ran decide_until(std::chrono::milliseconds moment, bool later, int signal,
                     const std::vector<std::string>& options) const {
        return run_and_signal(command(options), signal, [&](const std::function<bool()>& ended) {
            while (later && !has_checkpoint() && !ended()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
            std::this_thread::sleep_for(moment);
        });
    }
    /// Returns the part of the output that must not depend on interruptions.
    static std::string results(const Ran& ran) {
        const nlohmann::json report = nlohmann::json::parse(ran.out, nullptr, false);
        if (report.is_discarded() || !report.contains("results")) return ran.out + ran.err;
        std::string text = fmt::format("exit {}", ran.exit);
        for (const nlohmann::json& result : report["results"])
            text += fmt::format("\n{} {} {} {} {}", result["answer"].dump(), result["visited_states"].dump(),
                                result["visited_transitions"].dump(), result["visited_plys"].dump(),
                                result["counterexamples"].dump());
        return text;
    }
    [[nodiscard]] std::string uninterrupted() const {
        const Ran ran = run({"cspm", folder_ / "script.csp", "--no-reduction", "--format", "json", "--checkpoint",
                             folder_ / "uninterrupted"});
        EXPECT_THAT(results(ran), HasSubstr(expected_));
        return results(ran);
    }

    /// Returns true if a run that ends now leaves a checkpoint to which all threads have written their part.
    [[nodiscard]] bool has_checkpoint() const {
        std::map<std::string, unsigned> written;  // files by checkpoint number and number of threads
        std::error_code ignored;
        for (std::filesystem::recursive_directory_iterator at(folder_ / "kept", ignored), end; !ignored && at != end;
             at.increment(ignored)) {
            unsigned number = 0, rank = 0, ranks = 0;
            const std::string name = at->path().filename();
            if (std::sscanf(name.c_str(), "checkpoint-%u-%u-of-%u", &number, &rank, &ranks) != 3) continue;
            const std::string of_all = fmt::format("{} {} {}", at->path().parent_path().string(), number, ranks);
            if (name == fmt::format("checkpoint-{}-{}-of-{}", number, rank, ranks) && ++written[of_all] == ranks)
                return true;
        }
        return false;
    }

    void survive_kills();
    void survive_a_full_disk();

    Folder folder_;
    std::string expected_ = "exit 1\n\"holds\" 65536 524288 24 []\n\"fails\" 65537 ";
};

class ResumedSequential : public Resumed {
protected:
    ResumedSequential() : Resumed(sequential) {
        expected_ = "exit 1\n\"holds\" 29791 86491 90 []\n\"holds\" 8191 12286 12 []\n\"fails\" 29791 86490 90 ";
    }
};

void Resumed::survive_kills() {
    const std::string expected = uninterrupted();
    const unsigned seed = std::random_device()();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937 random(seed);
    int ended = 0, gone_on = 0;
    // If the machine is busy, the test needs more and longer rounds.
    for (int round = 0; round < 8 || (gone_on == 0 && round < 40); ++round) {
        const std::chrono::milliseconds moment(20 + random() % 80 * (1 + static_cast<unsigned>(round) / 8));
        const bool has_saved = has_checkpoint();
        std::vector<std::string> options{"--every", "0.0002", "--threads", std::to_string(1 + random() % 3)};
        if (random() % 2 == 0) options.insert(options.end(), {"--disk", folder_ / "kept"});
        const Ran ran = decide_until(moment, round % 4 != 0, round % 2 == 0 ? SIGKILL : SIGTERM, options);
        ASSERT_NE(ran.exit, 2) << ran.err;
        if (ran.exit > 2) ++ended;
        if (!has_saved) continue;
        EXPECT_THAT(ran.err, Not(HasSubstr("begins anew")));
        ++gone_on;
    }
    EXPECT_GT(ended, 0);
    EXPECT_GT(gone_on, 0) << "no run has left a checkpoint";
    EXPECT_EQ(results(decide({"--threads", "2"})), expected);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "kept")) << "all is decided";
}

void Resumed::survive_a_full_disk() {
    const std::string expected = uninterrupted();
    const std::vector<std::string> disk{"--disk", folder_ / "kept"};
    for (const std::vector<std::string>& options : {std::vector<std::string>(), disk}) {
        const Ran full = run_shell(fmt::format("trap '' XFSZ; ulimit -f 8; exec \"$verify\" {} --every 0.000001",
                                               fmt::join(command(options), " ")));
        EXPECT_EQ(full.exit, 3) << full.err;
        EXPECT_THAT(full.out, HasSubstr("cannot write"));
        EXPECT_TRUE(std::filesystem::exists(folder_ / "kept/questions"));
        EXPECT_TRUE(has_checkpoint());
        const Ran again = decide(options);
        EXPECT_EQ(results(again), expected);
        EXPECT_THAT(again.err, Not(HasSubstr("begins anew")));
    }
}

TEST_F(Resumed, AfterKillsAtRandomMoments) {
    survive_kills();
}
TEST_F(Resumed, AfterAFullDisk) {
    survive_a_full_disk();
}
TEST_F(ResumedSequential, AfterKillsAtRandomMoments) {
    survive_kills();
}
TEST_F(ResumedSequential, AfterAFullDisk) {
    survive_a_full_disk();
}

// In each round the process is renamed once more, so later states contain renamings that the initial state does not
// contain.
TEST_F(ResumedSequential, PartsThatAppearLaterAreSearchedWithoutCheckpoints) {
    const Folder folder{{{"s.csp", R"(
channel a, b : {0..3}
P(n) = a.n -> (if n < 3 then P(n + 1)[[a.n <- b.n]] else STOP)
assert P(0) :[deadlock free [F]]
)"}}};
    const Ran ran = run({"cspm", folder / "s.csp", "--checkpoint", folder / "kept"});
    EXPECT_EQ(ran.exit, 1) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("nothing is kept of the search"));
}

}  // namespace
}  // namespace robochart::app::testing::resume_test
