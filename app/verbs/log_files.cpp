// SPDX-License-Identifier: Apache-2.0
#include "app/verbs/log_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <utility>

#include "app/command/output.hpp"
#include "app/command/run.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "conformance/traces/mcap.hpp"

namespace robochart::app {

std::vector<std::string> log_files(const Options& options, std::vector<std::string>& errors) {
    std::vector<std::string> result;
    for (const std::string& given : options.conform.traces) {
        std::error_code error;
        if (!std::filesystem::is_directory(given, error)) {
            result.push_back(given);
            continue;
        }
        for (const std::string& path : diagnostics::files_below(given, true).files)
            if (conformance::is_log_path(path)) result.push_back(path);
    }
    if (result.empty()) errors.emplace_back("--traces: there are no .trace or .mcap files in the folder");
    return result;
}

void read_log(const std::string& path, const Options& options, std::vector<std::string>& errors, std::uint64_t& logs,
              const std::function<void(std::istream&)>& read) {
    const std::string shown = diagnostics::escape_for_display(path);
    try {
        const std::unique_ptr<std::istream> in = conformance::open_log(path, options.run->budget());
        if (in == nullptr) {
            errors.push_back(fmt::format("{}: it is not a regular file that may be read", shown));
            return;
        }
        ++logs;
        options.run->recorder().add_input_file(path);
        read(*in);
    } catch (const conformance::McapFault& fault) {
        errors.push_back(fmt::format("{}: {}", shown, fault.what()));
    } catch (const conformance::TraceFault& fault) {
        errors.push_back(fmt::format("{}: {}", shown, conformance::fault_text(fault)));
    }
}

void LogReport::add(LoggedRun entry) {
    constexpr std::size_t most_reported = 100;
    if (reported.size() < most_reported) reported.push_back(std::move(entry));
}

void print_reported(const LogReport& report) {
    for (const LoggedRun& logged : report.reported) {
        print("{} {}:{}: {}run {}\n", logged.broken ? "broken      " : "inconclusive",
              diagnostics::escape_for_display(logged.log), logged.line,
              logged.claim.empty() ? "" : fmt::format("{} in ", logged.claim),
              logged.run.empty() ? "without a name" : diagnostics::escape_for_display(logged.run));
        for (const std::string& line : logged.lines) print("  {}\n", diagnostics::escape_for_display(line));
    }
    for (const std::string& error : report.errors) print_error("robochart-verify: {}\n", error);
}

namespace {
diagnostics::Json logged_json(const LoggedRun& logged) {
    diagnostics::Json json{{"log", logged.log},
                           {"line", logged.line},
                           {"run", logged.run},
                           {"verdict", logged.broken ? "broken" : "inconclusive"},
                           {"lines", logged.lines}};
    if (!logged.claim.empty()) json["claim"] = logged.claim;
    return json;
}

using Tokens = std::vector<conformance::TraceToken>;

[[noreturn]] void fail_at(const char* expected, const Tokens& tokens) {
    throw conformance::TraceFault{nullptr, {expected, fmt::format("`{}`", tokens[0].text)}};
}

bool is_version(const Tokens& tokens) {
    return tokens.size() == 2 && tokens[0].text == "robochart-trace" && tokens[1].text == "1";
}
}  // namespace

diagnostics::Json log_report_json(const LogReport& report, const char* schema, const char* units, const char* kept,
                                  Exit exit) {
    return {{"schema", schema},
            {"logs", report.logs},
            {"runs", report.runs},
            {units, report.units},
            {kept, report.kept},
            {"broken", report.broken},
            {"inconclusive", report.open},
            {"inputsCount", "raised"},
            {"errors", report.errors},
            {"exit", static_cast<int>(exit)},
            {"reported", diagnostics::json_array(report.reported, logged_json)}};
}

void RunReader::read(std::istream& in) {
    conformance::LineReader lines(in);
    conformance::TraceHeader header;
    Tokens tokens;
    bool version = false, running = false;
    const auto end = [&] {
        if (!running) return;
        ++report_.runs;
        end_run();
    };
    while (lines.read_line()) {
        options_.run->budget().poll();
        conformance::split_line(lines.line_text(), tokens);
        if (tokens.empty()) continue;
        if (!std::exchange(version, true)) {
            if (!is_version(tokens)) fail_at("`robochart-trace 1` in the first line", tokens);
        } else if (tokens.front().text == "run") {
            end();
            running = true;
            name_.clear();
            for (std::size_t i = 1; i < tokens.size(); ++i)
                name_ += fmt::format("{}{}", i > 1 ? " " : "", tokens[i].text);
            begun_ = lines.line_number();
            begin_run(header);
        } else if (running) {
            follow(tokens, lines.line_number());
        } else if (!conformance::read_header_line(tokens, header, lines.line_number())) {
            fail_at("a line of the header, or `run`", tokens);
        }
    }
    end();
}

}  // namespace robochart::app
