// How long an editor waits after a keystroke in a project of 20 files: from `didChange` to the diagnostics, and for a
// completion after that. Prints the median and the 95th percentile of both.
//   benchmark_lsp [FILES] [KEYSTROKES]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

#include "lsp/server.hpp"

namespace {

using robochart::lsp::Json;
using Clock = std::chrono::steady_clock;

constexpr int machines = 4;  // a file of about 540 lines

std::string interface(int file) {
    return fmt::format(
        "interface Vars{0} {{ var x{0} : nat var y{0} : real var flag{0} : boolean const limit{0} : nat = {0} }}\n"
        "interface Ops{0} {{ move{0}(speed : real, turn : real) stop{0}() }}\n"
        "interface Evs{0} {{ event go{0} event value{0} : nat event done{0} }}\n"
        "enumeration Mode{0} {{ Idle{0} Busy{0} Lost{0} }}\n"
        "function scale{0}(a : real, b : real) : real {{ precondition b > 0 postcondition result == a * b }}\n",
        file);
}

/// A machine of ten states that uses its own file and the one before.
std::string machine(int file, int before, int number) {
    std::string out = fmt::format(
        "\nstm M{0}_{2} {{\n  requires Vars{0} requires Ops{0} uses Evs{0}\n  var mode : Mode{1}\n  var n : nat = 0\n"
        "  clock T\n  initial i\n  final f\n",
        file, before, number);
    for (int s = 0; s < 10; ++s)
        out += fmt::format(
            "  state S{1} {{\n    entry n = n + {1}; move{0}(scale{2}(y{0}, 2.0), 1.0)\n    exit stop{0}()\n  }}\n",
            file, s, before);
    out += "  transition t0 { from i to S0 }\n";
    for (int s = 0; s < 10; ++s)
        out += fmt::format(
            "  transition go{1} {{\n    from S{1}\n    to S{2}\n    trigger value{0}?x{0}\n    #T\n"
            "    condition since(T) > {1} /\\ (n < limit{0} \\/ mode == Mode{3}::Idle{3})\n    action send done{0}\n  "
            "}}\n",
            file, s, (s + 1) % 10, before);
    return out + "  transition end { from S9 to f condition flag" + std::to_string(file) + " }\n}\n";
}

std::string text_of(int file, int files) {
    const int before = (file + files - 1) % files;
    std::string out = fmt::format("package p{}\nimport p{}::*\n", file, before) + interface(file);
    for (int m = 0; m < machines; ++m) out += machine(file, before, m);
    return out;
}

std::string uri(int file) {
    return fmt::format("file:///bench/f{}.rct", file);
}

/// One conversation; answers are only counted.
class Editor {
public:
    Editor() : server_([this](const std::string& text) { bytes_ += text.size(); }) {
        call("initialize", Json::object({{"capabilities", Json::object({})}}));
        say("initialized", Json::object({}));
    }
    void call(const std::string& method, Json params) {
        receive(Json::object({{"jsonrpc", "2.0"}, {"id", ++id_}, {"method", method}, {"params", std::move(params)}}));
    }
    void say(const std::string& method, Json params) {
        receive(Json::object({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}}));
    }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

private:
    void receive(const Json& message) {
        server_.receive(message.write());
        while (server_.has_work()) server_.step();
        server_.idle();
    }

    std::size_t bytes_ = 0;
    std::int64_t id_ = 0;
    robochart::lsp::Server server_;
};

double milliseconds_since(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

void report(const char* what, std::vector<double> times) {
    std::sort(times.begin(), times.end());
    fmt::print("{:<44} median {:6.2f} ms   p95 {:6.2f} ms   worst {:6.2f} ms\n", what, times[times.size() / 2],
               times[times.size() * 95 / 100], times.back());
}

Json place(std::int64_t line, std::int64_t column) {
    return Json::object({{"line", line}, {"character", column}});
}

}  // namespace

int main(int argc, char** argv) {
    const int files = argc > 1 ? std::max(2, std::atoi(argv[1])) : 20;
    const int keystrokes = argc > 2 ? std::max(20, std::atoi(argv[2])) : 400;
    Editor editor;
    std::size_t lines = 0;
    for (int f = 0; f < files; ++f) {
        const std::string text = text_of(f, files);
        lines += static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
        editor.say("textDocument/didOpen",
                   Json::object({{"textDocument", Json::object({{"uri", uri(f)}, {"version", 1}, {"text", text}})}}));
    }
    fmt::print("{} files, {} lines; {} keystrokes\n", files, lines, keystrokes);

    // A line is typed letter by letter into machines of all files, and taken out again.
    const std::string typed = "    condition n > limit \n";
    std::vector<double> diagnostics;
    std::vector<double> completions;
    constexpr std::int64_t line = 15;
    for (int k = 0; k < keystrokes; ++k) {
        const int file = k / static_cast<int>(typed.size()) % files;
        const std::int64_t column = k % static_cast<std::int64_t>(typed.size());
        const Json document = Json::object({{"uri", uri(file)}, {"version", k + 2}});
        const bool last = column + 1 == static_cast<std::int64_t>(typed.size());
        const Json range = Json::object({{"start", place(line, last ? 0 : column)}, {"end", place(line, column)}});
        const std::string letter = last ? "" : std::string(1, typed[static_cast<std::size_t>(column)]);
        const Json change = Json::object({{"range", range}, {"text", letter}});
        const Clock::time_point begin = Clock::now();
        editor.say("textDocument/didChange",
                   Json::object({{"textDocument", document}, {"contentChanges", Json::array({change})}}));
        diagnostics.push_back(milliseconds_since(begin));
        const Clock::time_point asked = Clock::now();
        editor.call("textDocument/completion",
                    Json::object({{"textDocument", document}, {"position", place(line, last ? 0 : column + 1)}}));
        completions.push_back(milliseconds_since(asked));
    }
    report("keystroke to diagnostics", diagnostics);
    report("completion after it", completions);
    return 0;
}
