// SPDX-License-Identifier: Apache-2.0
// Reads logs line by line: the header first, then the tokens of runs.
#include "conformance/traces/trace_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <istream>
#include <utility>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/utf8.hpp"
#include "conformance/model/rules.hpp"
#include "cpp_emit/files/trace_names.hpp"

namespace robochart::conformance {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

/// Returns the end of the word that begins at `begin`.
std::size_t end_of_word(std::string_view line, std::size_t begin) {
    int depth = 0;
    bool quoted = false;
    std::size_t end = begin;
    for (; end < line.size(); ++end) {
        const char c = line[end];
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        if (c == '(' || c == '{' || c == '<') ++depth;
        if (c == ')' || c == '}' || c == '>') --depth;
        if (is_blank(c) && depth <= 0) break;
    }
    return end;
}

std::string rest_of(const std::vector<TraceToken>& tokens) {
    if (tokens.size() < 2) return "";
    const char* const end = tokens.back().text.data() + tokens.back().text.size();
    return {tokens[1].text.data(), static_cast<std::size_t>(end - tokens[1].text.data())};
}

std::uint32_t cycle_of(const std::vector<TraceToken>& tokens) {
    std::uint32_t value = 0;
    const std::string_view text = tokens.size() == 2 ? tokens[1].text : std::string_view();
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code == std::errc() && end == text.data() + text.size() && value >= 1 && value <= 1000) return value;
    throw TraceFault{&rules::log_syntax,
                     {"`cycle` and a number of time units from 1 to 1000", fmt::format("`cycle {}`", rest_of(tokens))},
                     tokens[0].column,
                     5};
}

std::string constant_of(const std::vector<TraceToken>& tokens) {
    std::string text = rest_of(tokens);
    const std::size_t equals = text.find('=');
    if (tokens.size() == 2 && equals != std::string::npos && equals > 0 && equals + 1 < text.size()) return text;
    throw TraceFault{&rules::log_syntax, {"`const NAME=VALUE`", fmt::format("`const {}`", text)}, tokens[0].column, 5};
}

/// Returns the length in `unit 0.1 s`, or no value for other texts.
durations::Unit unit_of(const std::vector<TraceToken>& tokens) {
    if (tokens.size() != 3 || tokens[2].text != "s") return std::nullopt;
    return durations::nanoseconds_of_seconds(tokens[1].text);
}

}  // namespace

std::string fault_text(const TraceFault& fault) {
    diagnostics::Diagnostic finding{fault.rule == nullptr ? &rules::log_syntax : fault.rule, {}, {}, {}, {}};
    for (const std::string& argument : fault.arguments)
        finding.arguments.push_back(diagnostics::escape_for_display(argument));
    finding.arguments.resize(std::max<std::size_t>(finding.arguments.size(), 2), "something else");
    return finding.message();
}

void compare_units(const TraceHeader& header, durations::Unit declared) {
    if (!header.unit || !declared || *header.unit == *declared) return;
    throw TraceFault{
        &rules::log_of_other,
        {fmt::format("time units of {}", durations::duration_text(*header.unit)),
         fmt::format("time units of {}, as the claims file declares", durations::duration_text(*declared))}};
}

void split_line(std::string_view line, std::vector<TraceToken>& tokens) {
    tokens.clear();
    for (std::size_t at = 0; at < line.size();) {
        if (is_blank(line[at])) {
            ++at;
            continue;
        }
        if (line.substr(at, 2) == "//") return;
        const std::size_t end = end_of_word(line, at);
        tokens.push_back({line.substr(at, end - at), static_cast<std::uint32_t>(at)});
        at = end;
    }
}

bool read_header_line(const std::vector<TraceToken>& tokens, TraceHeader& header, std::uint64_t line) {
    const std::string_view key = tokens.front().text;
    if (key == "model") {
        header.model = rest_of(tokens);
    } else if (key == "component") {
        header.component = rest_of(tokens);
    } else if (key == "robot") {
        header.robot = rest_of(tokens);
    } else if (key == "const") {
        header.constants.push_back(constant_of(tokens));
    } else if (key == "cycle") {
        header.cycle = cycle_of(tokens);
    } else if (key == "unobserved") {
        for (std::size_t i = 1; i < tokens.size(); ++i) {
            header.unobserved.emplace_back(tokens[i].text);
            header.unobserved_line.push_back(static_cast<std::uint32_t>(line));
        }
    } else if (key == "unit") {
        header.unit = unit_of(tokens);
    } else {
        return key == "seed" || key == "scenario";  // information for readers
    }
    return true;
}

bool LineReader::fill_buffer() {
    constexpr std::size_t chunk = 1U << 18U;
    buffer_.resize(chunk);
    in_.read(buffer_.data(), static_cast<std::streamsize>(chunk));
    buffer_.resize(static_cast<std::size_t>(in_.gcount()));
    at_ = std::exchange(begun_, true) || !buffer_.starts_with(diagnostics::byte_order_mark)
              ? 0
              : diagnostics::byte_order_mark.size();
    return at_ < buffer_.size();
}

bool LineReader::read_line() {
    line_.clear();
    ++number_;
    bool any = false;
    while (at_ < buffer_.size() || fill_buffer()) {
        any = true;
        const std::size_t end = buffer_.find('\n', at_);
        line_.append(buffer_, at_, end == std::string::npos ? end : end - at_);
        at_ = end == std::string::npos ? buffer_.size() : end + 1;
        if (line_.size() > longest) {
            line_.resize(80);
            throw TraceFault{&rules::log_syntax, {"lines of at most a megabyte", "a longer one"}};
        }
        if (end != std::string::npos) break;
    }
    const std::size_t zero = line_.find('\0');
    if (zero != std::string::npos)
        throw TraceFault{&rules::log_syntax, {"text", "a zero byte"}, static_cast<std::uint32_t>(zero)};
    return any;
}

}  // namespace robochart::conformance
