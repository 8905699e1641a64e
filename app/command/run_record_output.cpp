// SPDX-License-Identifier: Apache-2.0
// Writes the record of a run as JSON, as text and as a part of a page.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "app/command/run_record.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/json_values.hpp"

namespace robochart::app {
namespace {

using diagnostics::Json;
using diagnostics::json_array;
using diagnostics::json_or_null;

constexpr const char* program_name = "robochart-verify";

const char* key_of(ValueSource source) {
    switch (source) {
        case ValueSource::model:
            return "model";
        case ValueSource::by_default:
            return "default";
        case ValueSource::option:
            return "option";
        case ValueSource::preferences:
            return "preferences";
        case ValueSource::scenario:
            return "scenario";
        case ValueSource::swarm:
            return "swarm";
        case ValueSource::log:
            return "log";
        case ValueSource::block:
            return "block";
    }
    return "";
}

/// Writes whole numbers without a decimal point.
Json bound_json(double number) {
    constexpr double exact = 9007199254740992.0;  // 2^53
    if (std::trunc(number) == number && std::abs(number) < exact) return Json(static_cast<std::int64_t>(number));
    return Json(number);
}

/// Returns "16 GiB", "300 MiB", or the number of bytes if it is not a multiple of a mebibyte.
std::string size_text(std::uint64_t bytes) {
    constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20U, gibibyte = std::uint64_t{1} << 30U;
    if (bytes > 0 && bytes % gibibyte == 0) return fmt::format("{} GiB", bytes / gibibyte);
    if (bytes > 0 && bytes % mebibyte == 0) return fmt::format("{} MiB", bytes / mebibyte);
    return fmt::format("{} bytes", bytes);
}

std::string limits_text(const RunRecord& record) {
    std::string text = "memory " + size_text(record.memory_bytes);
    if (record.seconds) text += fmt::format(", {} seconds", *record.seconds);
    if (record.assertion_seconds) text += fmt::format(", {} seconds for each assertion", *record.assertion_seconds);
    if (record.states) text += fmt::format(", {} states", *record.states);
    return text;
}

/// Returns the words of a command line, quoted for a shell where necessary.
std::string command_text(const std::vector<std::string>& words) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:=,+@%";
    std::string text;
    for (const std::string& word : words) {
        if (!text.empty()) text += ' ';
        if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
            text += word;
            continue;
        }
        text += '\'';
        for (const char c : word) {
            if (c == '\'')
                text += "'\\''";
            else
                text += c;
        }
        text += '\'';
    }
    return text;
}

Json input_json(const RecordedInput& input) {
    return {{"path", input.path}, {"sha256", input.sha256}};
}

Json constant_json(const RecordedConstant& constant) {
    return {{"model", constant.model},
            {"name", constant.name},
            {"value", constant.value},
            {"source", key_of(constant.source)}};
}

Json range_json(const RecordedRange& range) {
    return {{"model", range.model},           {"type", range.type},     {"low", bound_json(range.low)},
            {"high", bound_json(range.high)}, {"values", range.values}, {"source", key_of(range.source)}};
}

}  // namespace

Json run_json(const RunRecord& record) {
    return {{"program", program_json(record.version, record.commit)},
            {"command", record.command},
            {"inputs", json_array(record.inputs, input_json)},
            {"constants", json_array(record.constants, constant_json)},
            {"ranges", json_array(record.ranges, range_json)},
            {"seed", json_or_null(record.seed)},
            {"limits",
             {{"memoryBytes", record.memory_bytes},
              {"seconds", json_or_null(record.seconds)},
              {"assertionSeconds", json_or_null(record.assertion_seconds)},
              {"states", json_or_null(record.states)}}},
            {"reduction", json_or_null(record.reduction)},
            {"threads", json_or_null(record.threads)},
            {"peakMemoryBytes", json_or_null(record.peak_memory_bytes)}};
}

std::string with_run(std::string document, const RunRecord& record) {
    const bool indented = document.starts_with("{\n");
    document.erase(document.rfind('}'));
    while (document.ends_with('\n')) document.pop_back();
    std::string run = diagnostics::json_text(run_json(record), indented ? 2 : -1);
    if (!indented) return document + ",\"run\":" + run + "}\n";
    for (std::size_t at = run.find('\n'); at != std::string::npos; at = run.find('\n', at + 1))
        run.insert(at + 1, "  ");
    return document + ",\n  \"run\": " + run + "\n}\n";
}

std::string run_line(RunRecord record) {
    record.peak_memory_bytes.reset();
    return run_json(record).dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::string run_text(const RunRecord& record) {
    using diagnostics::escape_for_display;
    std::string text = fmt::format("{} {} ({})\n", program_name, record.version, commit_text(record.commit));
    const auto add = [&](const char* what, const std::string& value) {
        text += fmt::format("  {:<11} {}\n", what, value);
    };
    add("command", escape_for_display(command_text(record.command)));
    for (const RecordedInput& input : record.inputs)
        add("input", fmt::format("{} sha256 {}", escape_for_display(input.path), input.sha256));
    for (const RecordedConstant& constant : record.constants)
        add("constant",
            fmt::format("{}: {} = {} ({})", escape_for_display(constant.model), escape_for_display(constant.name),
                        escape_for_display(constant.value), key_of(constant.source)));
    for (const RecordedRange& range : record.ranges)
        add("range", fmt::format("{}: {} {}..{}, {} values ({})", escape_for_display(range.model), range.type,
                                 range.low, range.high, range.values, key_of(range.source)));
    if (record.seed) add("seed", fmt::format("{}", *record.seed));
    add("limits", limits_text(record));
    if (record.reduction) add("reduction", *record.reduction ? "on" : "off");
    if (record.threads) add("threads", fmt::format("{}", *record.threads));
    if (record.peak_memory_bytes) add("peak memory", fmt::format("{} MiB", *record.peak_memory_bytes >> 20U));
    return text;
}

std::string run_html(const RunRecord& record) {
    return fmt::format(
        "<section id=\"run\">\n<details>\n<summary>How to repeat this run</summary>\n<pre>{}</pre>\n</details>\n"
        "</section>\n",
        diagnostics::xml_lines(run_text(record)));
}

}  // namespace robochart::app
