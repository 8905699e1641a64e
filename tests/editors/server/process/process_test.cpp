// SPDX-License-Identifier: Apache-2.0
// Runs the program itself over pipes, as an editor starts it.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string>

#include "editors/server/protocol/json.hpp"
#include "tests/editors/server/answer.hpp"
#include "tests/source_folder.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;

/// A running `robochart-verify lsp`.
class Process {
public:
    explicit Process(const char* argument = nullptr) {
        signal(SIGPIPE, SIG_IGN);
        std::array<int, 2> to{};
        std::array<int, 2> from{};
        EXPECT_EQ(pipe(to.data()), 0);
        EXPECT_EQ(pipe(from.data()), 0);
        pid_ = fork();
        if (pid_ == 0) {
            dup2(to[0], STDIN_FILENO);
            dup2(from[1], STDOUT_FILENO);
            for (const int descriptor : {to[0], to[1], from[0], from[1]}) close(descriptor);
            execl(tests::command_path(), tests::command_path(), "lsp", argument, nullptr);
            _exit(127);
        }
        close(to[0]);
        close(from[1]);
        in_ = to[1];
        out_ = from[0];
    }
    ~Process() {
        if (in_ >= 0) close(in_);
        close(out_);
    }

    void say(const std::string& text) {
        const std::string frame = "Content-Length: " + std::to_string(text.size()) + "\r\n\r\n" + text;
        for (std::size_t sent = 0; sent < frame.size();) {
            const ssize_t some = write(in_, frame.data() + sent, frame.size() - sent);
            ASSERT_GT(some, 0);
            sent += static_cast<std::size_t>(some);
        }
    }
    /// Returns the next message, or null at the end of the stream.
    Answer hear() {
        std::string header;
        while (!header.ends_with("\r\n\r\n")) {
            char c = 0;
            if (read(out_, &c, 1) != 1) return {};
            header += c;
        }
        std::size_t length = std::stoul(header.substr(header.find(':') + 1));
        std::string body;
        while (body.size() < length) {
            std::array<char, 4096> buffer{};
            const ssize_t got = read(out_, buffer.data(), std::min(buffer.size(), length - body.size()));
            if (got <= 0) return {};
            body.append(buffer.data(), static_cast<std::size_t>(got));
        }
        std::string error;
        return read_json(body, error);
    }
    void send(int signal) const { kill(pid_, signal); }
    void end_input() {
        close(in_);
        in_ = -1;
    }
    int wait() {
        int status = 0;
        waitpid(pid_, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    pid_t pid_ = 0;
    int in_ = -1;
    int out_ = -1;
};

constexpr const char* initialize = R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}})";

TEST(Program, ServesAnEditorOverPipes) {
    Process process("--stdio");
    process.say(initialize);
    EXPECT_TRUE(process.hear()["result"]["capabilities"].is_object());
    process.say(R"({"jsonrpc":"2.0","method":"initialized","params":{}})");
    process.say(R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":)"
                R"({"uri":"file:///nowhere/a.rct","languageId":"robochart","version":1,)"
                R"("text":"interface I { var x : lost }\n"}}})");
    const Answer published = process.hear();
    EXPECT_EQ(published["method"].text(), "textDocument/publishDiagnostics");
    EXPECT_EQ(published["params"]["diagnostics"][0]["code"].text(), "RC-N01");
    process.say(R"({"jsonrpc":"2.0","id":2,"method":"textDocument/hover","params":{"textDocument":)"
                R"({"uri":"file:///nowhere/a.rct"},"position":{"line":0,"character":18}}})");
    EXPECT_EQ(process.hear()["result"]["contents"]["value"].text(), "var x : lost\nin interface `I`");
    process.say(R"({"jsonrpc":"2.0","id":3,"method":"shutdown"})");
    EXPECT_EQ(process.hear()["id"].number(), 3);
    process.say(R"({"jsonrpc":"2.0","method":"exit"})");
    EXPECT_EQ(process.wait(), 0);
    EXPECT_TRUE(process.hear().is_null()) << "nothing but answers goes to standard output";
}

TEST(Program, ExitsWithOneWithoutShutdown) {
    Process process;
    process.say(initialize);
    process.hear();
    process.say(R"({"jsonrpc":"2.0","method":"exit"})");
    EXPECT_EQ(process.wait(), 1);
}

TEST(Program, EndsWithItsInput) {
    Process process;
    process.say(initialize);
    process.hear();
    process.end_input();
    EXPECT_EQ(process.wait(), 1);
}

/// Returns the notification that opens a text with a long analysis.
std::string large_opening() {
    std::string text;
    for (int i = 0; i < 150'000; ++i)
        text += "stm S" + std::to_string(i) +
                " { var x : nat initial i state A { entry x = x + 1 } transition t { from i to A } }\\n";
    return R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":{"uri":"file:///nowhere/a.rct",)"
           R"("languageId":"robochart","version":1,"text":")" +
           text + R"("}}})";
}

constexpr const char* hover = R"({"jsonrpc":"2.0","id":2,"method":"textDocument/hover","params":{"textDocument":)"
                              R"({"uri":"file:///nowhere/a.rct"},"position":{"line":0,"character":5}}})";

/// A server during a long analysis.
class Busy : public Process {
public:
    Busy() {
        say(initialize);
        hear();
        say(large_opening());
        say(hover);
        usleep(300'000);
    }
};

// The time bounds are generous, because the tests detect an analysis that does not stop.
TEST(BusyProgram, AnswersACancelledRequest) {
    Busy busy;
    busy.say(R"({"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":2}})");
    EXPECT_EQ(busy.hear()["error"]["code"].number(), -32800);
    busy.say(R"({"jsonrpc":"2.0","method":"exit"})");
    EXPECT_EQ(busy.wait(), 1);
}

TEST(BusyProgram, LeavesAtOnce) {
    const auto start = std::chrono::steady_clock::now();
    Busy leaving;
    leaving.say(R"({"jsonrpc":"2.0","id":3,"method":"shutdown"})");
    leaving.say(R"({"jsonrpc":"2.0","method":"exit"})");
    EXPECT_EQ(leaving.wait(), 0);
    Busy gone;
    gone.end_input();
    EXPECT_EQ(gone.wait(), 1);
    Busy ended;
    ended.send(SIGTERM);
    EXPECT_EQ(ended.wait(), -1) << "by the signal";
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

}  // namespace
}  // namespace robochart::lsp
