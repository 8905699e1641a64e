// SPDX-License-Identifier: Apache-2.0
// Reads the table of a conformance certificate, and its sources: code.txt and implementation.txt (docs/certificates.md,
// "Files of conformance").
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace robochart::replay {

/// Thrown if a certificate or an object cannot be used; the message contains the reason.
class Unusable : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The numbers of tau and tick in every table.
inline constexpr std::uint32_t tau = 0, tick = 1;

struct Source {
    std::string path;
    std::string text;
};

/// An input register, and its values as they are written in events; no values if it carries none.
struct Input {
    std::string name;
    std::vector<std::string> values;

    /// Returns the number of readings: absent, and one for each value, or one for "present".
    [[nodiscard]] std::uint32_t readings() const {
        return 1 + (values.empty() ? 1 : static_cast<std::uint32_t>(values.size()));
    }
};

/// An output. Each argument has the names of its values 0, 1, ...; it has no names if its values are written as
/// numbers.
struct Output {
    std::string name;
    std::vector<std::vector<std::string>> arguments;
};

/// A state of the code in which a cycle begins: its number in the process, and its text.
struct StartState {
    std::uint32_t state = 0;
    std::string text;
};

/// A transition of the process.
struct Edge {
    std::uint32_t event = 0;
    std::uint32_t target = 0;
    friend auto operator<=>(const Edge&, const Edge&) = default;
};

struct Table {
    std::string component;
    std::uint32_t cycle = 1;         ///< tocks in a cycle
    std::vector<std::string> build;  ///< the words of the command; the word OBJECT stands for the object
    std::vector<Source> sources;
    std::vector<Input> inputs;
    std::vector<Output> outputs;
    std::vector<StartState> states;
    std::vector<std::string> events;       ///< names by number; tau and tick have none
    std::vector<std::vector<Edge>> edges;  ///< by state, ascending
    std::uint32_t initial = 0;
};

/// Reads the table of a certificate. Compares the digests of all files. Throws Unusable.
[[nodiscard]] Table read_table(const std::string& folder);

}  // namespace robochart::replay
