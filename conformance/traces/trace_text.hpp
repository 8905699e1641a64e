// SPDX-License-Identifier: Apache-2.0
// Parses the text of logs (docs/traces.md): lines, tokens, the header, errors with their places. Reads line by line, so
// a log may be larger than memory.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "base/durations/time_unit.hpp"

namespace robochart::conformance {

/// A word of a line and its position in bytes, counted from 0.
struct TraceToken {
    std::string_view text;
    std::uint32_t column = 0;
};

/// Thrown if a log cannot be parsed. The reader adds the line's number and text.
struct TraceFault {
    const diagnostics::Rule* rule = nullptr;
    std::vector<std::string> arguments;
    std::uint32_t column = 0;
    std::uint32_t length = 1;
};

/// Returns the message of a fault, such as "expected `run`, found `tock`".
[[nodiscard]] std::string fault_text(const TraceFault& fault);

/// Splits `line` into words and drops its comment. Blanks inside brackets and quotes do not separate words.
void split_line(std::string_view line, std::vector<TraceToken>& tokens);

struct TraceHeader {
    std::string model;
    std::string component;
    std::string robot;
    std::vector<std::string> constants;          ///< "pace=3": constants of the model in the recorded runs
    std::uint32_t cycle = 1;                     ///< number of time units in a control cycle
    durations::Unit unit;                        ///< `unit 0.1 s`; other texts after `unit` are for readers
    std::vector<std::string> unobserved;         ///< kinds of events that the log does not record: "seeRobot?", "Move!"
    std::vector<std::uint32_t> unobserved_line;  ///< for each of them, its line, for errors
};

/// Reads one line of the header. Returns false if the line does not belong to the header. Throws TraceFault.
[[nodiscard]] bool read_header_line(const std::vector<TraceToken>&, TraceHeader&, std::uint64_t line);

/// Throws TraceFault if the log has time units of another length than the declared one.
void compare_units(const TraceHeader& header, durations::Unit declared);

/// Reads the lines of a stream, without its byte order mark. A line has at most `longest` bytes.
class LineReader {
public:
    static constexpr std::size_t longest = 1U << 20U;

    explicit LineReader(std::istream& in) : in_(in) {}
    /// Reads the next line. Returns false at the end. Throws TraceFault for lines that are too long or contain zero
    /// bytes.
    [[nodiscard]] bool read_line();
    [[nodiscard]] std::string_view line_text() const { return line_; }
    [[nodiscard]] std::uint64_t line_number() const { return number_; }

private:
    [[nodiscard]] bool fill_buffer();

    std::istream& in_;
    std::string buffer_;
    std::size_t at_ = 0;
    bool begun_ = false;
    std::string line_;
    std::uint64_t number_ = 0;
};

}  // namespace robochart::conformance
