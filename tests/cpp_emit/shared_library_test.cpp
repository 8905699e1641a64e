// SPDX-License-Identifier: Apache-2.0
// Tests programs that the toolkit runs: their exit status, their output, and how they end.
#include "cpp_emit/load/shared_library.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/diagnostics/programs.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::cpp_emit::shared_library_test {
namespace {

class Programs : public ::testing::Test {
protected:
    [[nodiscard]] std::string log() const { return folder_.in("log"); }

    std::string error_;

    tests::TemporaryFolder folder_;
};

TEST_F(Programs, ReturnTheirExitStatus) {
    EXPECT_EQ(diagnostics::run_program({"sh", "-c", "exit 3"}, log(), error_), 3);
    diagnostics::Budget budget;
    EXPECT_EQ(diagnostics::run_program({"sh", "-c", "exit 0"}, log(), error_, &budget), 0);
    EXPECT_EQ(diagnostics::run_program({"sh", "-c", "kill -9 $$"}, log(), error_), 128 + 9);
    EXPECT_EQ(error_, "");
    EXPECT_EQ(diagnostics::run_program({"no-such-program-here"}, log(), error_), -1);
    EXPECT_NE(error_.find("cannot run no-such-program-here"), std::string::npos) << error_;
}

// A killed program leaves its temporary files in the folder that the caller removes.
TEST_F(Programs, HaveTheirTemporaryFilesBesideTheirLog) {
    EXPECT_EQ(diagnostics::run_program({"sh", "-c", "printf %s \"$TMPDIR\"; test -n \"$PATH\""}, log(), error_), 0);
    std::string reported;
    std::ifstream(log()) >> reported;
    EXPECT_EQ(std::filesystem::path(reported), std::filesystem::path(log()).parent_path());
}

TEST_F(Programs, EndWithAllTheyStartedWhenInterrupted) {
    const auto reported = [this] {
        pid_t process = 0;
        std::ifstream(log()) >> process;
        return process;
    };
    const std::string endless = "sh -c 'echo $$; while :; do sleep 1; done'; exit 0";
    diagnostics::Limits limits;
    limits.interrupted = [&] { return reported() > 0; };
    diagnostics::Budget budget(limits);
    EXPECT_THROW(diagnostics::run_program({"sh", "-c", endless}, log(), error_, &budget), diagnostics::LimitReached);
    // The test does not wait for the orphan process. If the process is gone or a zombie, it is not running.
    const auto runs = [&] {
        std::string skipped;
        std::string state;
        std::ifstream("/proc/" + std::to_string(reported()) + "/stat") >> skipped >> skipped >> state;
        return !state.empty() && state != "Z";
    };
    for (int i = 0; i < 500 && runs(); ++i) usleep(20'000);
    EXPECT_FALSE(runs());
}

TEST_F(Programs, CompilersEndWithoutAnObjectWhenInterrupted) {
    diagnostics::Budget budget;
    budget.interrupt();
    BuildOptions options;
    options.budget = &budget;
    const std::vector<OutputFile> files{{"a.cpp", "int a() { return 0; }\n"}};
    EXPECT_THROW((void)SharedLibrary::build(files, {"a.cpp"}, options, error_), diagnostics::LimitReached);
}

TEST_F(Programs, CountWithTheMemoryOfTheRun) {
    diagnostics::Limits limits;
    limits.memory_bytes = diagnostics::resident_bytes() + (100ULL << 20U);
    diagnostics::Budget budget(limits);
    // A grandchild fills 200 MB and then waits. The program itself stays small.
    const std::string large = "sh -c 'x=$(head -c 200000000 /dev/zero | tr \"\\0\" x); sleep 100'; exit 0";
    EXPECT_THROW(diagnostics::run_program({"sh", "-c", large}, log(), error_, &budget), diagnostics::LimitReached);
}

TEST_F(Programs, HaveTheSignalsOfAnyProgram) {
    sigset_t interrupt;
    sigemptyset(&interrupt);
    sigaddset(&interrupt, SIGTERM);
    sigset_t before;
    pthread_sigmask(SIG_BLOCK, &interrupt, &before);
    EXPECT_EQ(diagnostics::run_program({"sh", "-c", "kill -TERM $$; exit 0"}, log(), error_), 128 + SIGTERM);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

TEST_F(Programs, LeaveNoFolderBehind) {
    const std::string own = folder_.in("tmp");
    std::filesystem::create_directory(own);
    const auto folders = [&] {
        std::size_t count = 0;
        for (const auto& entry : std::filesystem::directory_iterator(own))
            count += entry.path().filename().string().starts_with("robochart-") ? 1U : 0U;
        return count;
    };
    setenv("TMPDIR", own.c_str(), 1);
    BuildOptions options;
    const std::vector<OutputFile> wrong{{"a.cpp", "this is no program\n"}};
    EXPECT_EQ(SharedLibrary::build(wrong, {"a.cpp"}, options, error_), nullptr);
    EXPECT_EQ(folders(), 0U);
    unsetenv("TMPDIR");
}

}  // namespace
}  // namespace robochart::cpp_emit::shared_library_test
