// Programs that are run for the toolkit: their status, their words, and their end.
#include "cpp_emit/shared_library.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace robochart::cpp_emit {
namespace {

class Programs : public ::testing::Test {
protected:
    void SetUp() override { ASSERT_NE(mkdtemp(folder_.data()), nullptr); }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    [[nodiscard]] std::string log() const { return folder_ + "/log"; }

    std::string error_;

private:
    std::string folder_ = testing::TempDir() + "programs-XXXXXX";
};

TEST_F(Programs, TellHowTheyEnded) {
    EXPECT_EQ(run_program({"sh", "-c", "exit 3"}, log(), error_), 3);
    EXPECT_EQ(run_program({"sh", "-c", "exit 0"}, log(), error_, [] { return false; }), 0);
    EXPECT_EQ(run_program({"sh", "-c", "kill -9 $$"}, log(), error_), 128 + 9);
    EXPECT_EQ(error_, "");
    EXPECT_EQ(run_program({"no-such-program-here"}, log(), error_), -1);
    EXPECT_NE(error_.find("cannot run no-such-program-here"), std::string::npos) << error_;
}

TEST_F(Programs, EndWithAllTheyStartedWhenInterrupted) {
    const auto told = [this] {
        pid_t process = 0;
        std::ifstream(log()) >> process;
        return process;
    };
    const std::string endless = "sh -c 'echo $$; while :; do sleep 1; done'; exit 0";
    const int status = run_program({"sh", "-c", endless}, log(), error_, [&] { return told() > 0; });
    EXPECT_EQ(status, -1);
    EXPECT_EQ(error_, "sh was interrupted");
    // Nobody waits for the orphan here; gone or not yet collected, it does not run.
    const auto runs = [&] {
        std::string skipped;
        std::string state;
        std::ifstream("/proc/" + std::to_string(told()) + "/stat") >> skipped >> skipped >> state;
        return !state.empty() && state != "Z";
    };
    for (int i = 0; i < 500 && runs(); ++i) usleep(20'000);
    EXPECT_FALSE(runs());
}

TEST_F(Programs, CompilersEndWithoutAnObjectWhenInterrupted) {
    BuildOptions options;
    options.interrupted = [] { return true; };
    const auto library = SharedLibrary::build({{"a.cpp", "int a() { return 0; }\n"}}, {"a.cpp"}, options, error_);
    EXPECT_EQ(library, nullptr);
    EXPECT_EQ(error_, "c++ was interrupted");
}

}  // namespace
}  // namespace robochart::cpp_emit
