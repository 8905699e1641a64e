// SPDX-License-Identifier: Apache-2.0
// Measures the waiting time of an editor after a keystroke in a project of 20 files: from `didChange` to the
// diagnostics, and then for a completion. Prints medians and percentiles of wall time and, for shared machines, of CPU
// time.
//   benchmark_lsp [FILES] [KEYSTROKES] [MACHINES]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "editors/server/server.hpp"

namespace {

using robochart::lsp::Json;
using Clock = std::chrono::steady_clock;

std::string interface(int file) {
    return fmt::format(
        "interface Vars{0} {{ var x{0} : nat var y{0} : real var flag{0} : boolean const limit{0} : nat = {0} }}\n"
        "interface Ops{0} {{ move{0}(speed : real, turn : real) stop{0}() }}\n"
        "interface Evs{0} {{ event go{0} event value{0} : nat event done{0} }}\n"
        "enumeration Mode{0} {{ Idle{0} Busy{0} Lost{0} }}\n"
        "function scale{0}(a : real, b : real) : real {{ precondition b > 0 postcondition result == a * b }}\n",
        file);
}

/// Returns a machine of ten states that uses declarations of the same file and of the previous file.
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

/// Returns the text of a file. With two machines, it has about 270 lines.
std::string text_of(int file, int files, int machines) {
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
        server_.receive_message(robochart::diagnostics::json_text(message));
        while (server_.has_work()) server_.handle_next();
        server_.use_idle_time();
    }

    std::size_t bytes_ = 0;
    std::int64_t id_ = 0;
    robochart::lsp::Server server_;
};

/// Milliseconds of wall time and of CPU time.
struct Times {
    std::vector<double> wall, cpu;

    template <class Work>
    void measure(const Work& work) {
        const Clock::time_point begin = Clock::now();
        const std::clock_t cpu_begin = std::clock();
        work();
        cpu.push_back(1000.0 * static_cast<double>(std::clock() - cpu_begin) / CLOCKS_PER_SEC);
        wall.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    }
};

void report(const char* what, const char* unit, std::vector<double> times) {
    std::ranges::sort(times);
    fmt::print("{:<32} {:<5} median {:7.2f} ms   p95 {:7.2f} ms   worst {:7.2f} ms\n", what, unit,
               times[times.size() / 2], times[times.size() * 95 / 100], times.back());
}

void report(const char* what, const Times& times) {
    report(what, "clock", times.wall);
    report(what, "CPU", times.cpu);
}

Json place(std::int64_t line, std::int64_t column) {
    return Json::object({{"line", line}, {"character", column}});
}

/// A text that is typed letter by letter at the end of the line that begins with the given text, and then deleted
/// again. This is done in one file after the other.
struct Typing {
    std::string line_begin;
    std::string typed;
};

struct Project {
    std::vector<std::string> texts;
    Editor editor;
    std::int64_t version = 1;
};

void type(Project& project, const Typing& typing, std::size_t keystrokes, Times& diagnostics, Times& completions) {
    const std::size_t letters = typing.typed.size();
    for (std::size_t k = 0; k < keystrokes; ++k) {
        const std::size_t file = k / (letters + 1) % project.texts.size();
        const std::size_t column = k % (letters + 1);
        const std::string& text = project.texts[file];
        const std::size_t found = text.find(typing.line_begin);
        const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(found), '\n');
        const std::size_t begin = text.rfind('\n', found) + 1;
        const std::size_t end = text.find('\n', found) - begin;
        const bool back = column == letters;
        const Json document = Json::object({{"uri", uri(static_cast<int>(file))}, {"version", ++project.version}});
        const auto at = [&](std::size_t offset) { return place(line, static_cast<std::int64_t>(end + offset)); };
        const Json range = Json::object({{"start", at(back ? 0 : column)}, {"end", at(column)}});
        const Json change = Json::object({{"range", range}, {"text", back ? "" : typing.typed.substr(column, 1)}});
        diagnostics.measure([&] {
            project.editor.say("textDocument/didChange",
                               Json::object({{"textDocument", document}, {"contentChanges", Json::array({change})}}));
        });
        completions.measure([&] {
            project.editor.call("textDocument/completion",
                                Json::object({{"textDocument", document}, {"position", at(back ? 0 : column + 1)}}));
        });
    }
}

}  // namespace

int main(int argc, char** argv) {
    const int files = argc > 1 ? std::max(2, std::atoi(argv[1])) : 20;
    const int keystrokes = argc > 2 ? std::max(20, std::atoi(argv[2])) : 400;
    const int machines = argc > 3 ? std::max(1, std::atoi(argv[3])) : 4;
    Project project;
    std::int64_t lines = 0;
    for (int f = 0; f < files; ++f) {
        const std::string& text = project.texts.emplace_back(text_of(f, files, machines));
        lines += std::ranges::count(text, '\n');
        project.editor.say(
            "textDocument/didOpen",
            Json::object({{"textDocument", Json::object({{"uri", uri(f)}, {"version", 1}, {"text", text}})}}));
    }
    fmt::print("{} files, {} lines; {} keystrokes each\n", files, lines, keystrokes);

    Times completions;
    for (const auto& [where, typing] :
         {std::pair{"typing in a transition", Typing{"    condition ", " /\\ n < limit"}},
          std::pair{"typing in an interface", Typing{"interface Ops", " interface More { var speed : nat }"}}}) {
        Times diagnostics;
        type(project, typing, static_cast<std::size_t>(keystrokes), diagnostics, completions);
        report(where, diagnostics);
    }
    report("completion after it", completions);
    return 0;
}
