// SPDX-License-Identifier: Apache-2.0
// Runs code over the types of deployment side by side with the same code over tracked numbers (docs/conformance.md,
// "Doubles"). The cycles of the tracked code are explored once. A run of the deployed code assigns numbers to the
// explored values, and then makes the same cycles with these numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "conformance/code/code_images.hpp"
#include "conformance/code/cycle_log.hpp"
#include "conformance/code/interface.hpp"
#include "cpp_emit/runtime/explore_abi.h"
#include "semantics/ir/number_parts.hpp"

namespace robochart::conformance {

/// The numbers of a value: the bits of a double, or a whole number.
using NumbersOfValue = std::vector<std::int64_t>;
/// For each tracked type, its values.
using NumberTables = std::vector<std::vector<NumbersOfValue>>;
/// For each tracked type, the number parts that a value consists of; none for sequences.
using PartsOfTypes = std::vector<std::vector<ir::NumberPart>>;
/// For each output and argument, the index of its tracked type; no value for other types.
using OutputTypes = std::vector<std::vector<std::optional<std::uint32_t>>>;
/// A value: the index of its tracked type, and its index among the explored values of this type.
struct ValuePlace {
    std::uint32_t type = 0;
    std::uint32_t value = 0;
};

/// A cycle of the tracked code.
struct TrackedCycle {
    std::uint32_t from = 0;  ///< image
    std::uint32_t next = 0;
    bool first = false;  ///< true: the first cycle that leads to `next`, unless the code begins in `next`
    std::vector<rc_register> registers;
    std::vector<std::uint32_t> choices;  ///< answers at probabilistic junctions
    rc_result outcome = RC_QUIESCENT;
    std::vector<rc_record> writes;
};

/// Cycles in the order of a breadth-first search: the cycles that begin in an image follow the first cycle that leads
/// to this image.
struct TrackedCycles {
    std::vector<TrackedCycle> cycles;
    std::uint32_t images = 0;
    std::uint32_t reset = 0;
    bool all = true;  ///< false if there are more cycles or not all combinations of inputs were tried
};

/// Explores up to `most` cycles. If the inputs have many combinations, at most one register is full in a cycle.
[[nodiscard]] TrackedCycles explore_tracked(const rc_interface& code, const Interface& interface, std::size_t most,
                                            diagnostics::Pollable& budget);

/// A cycle in which the behaviour of the deployed code differs from that of the tracked code.
struct Deviation {
    std::size_t cycle = 0;  ///< index in TrackedCycles::cycles
    std::vector<rc_record> writes;
    std::string state;           ///< after the cycle
    std::string expected_state;  ///< "" if unknown, because no other cycle leads to it
};

class DeployedCode {
public:
    /// The code must have `tracking->deployed`. All arguments must outlive the object.
    DeployedCode(const rc_interface& code, const TrackedCycles& explored, const PartsOfTypes& parts,
                 const OutputTypes& output_types, diagnostics::Pollable& budget);

    /// Makes all cycles with these numbers, up to the first deviation. If there is no deviation, the run becomes the
    /// baseline of `deviations`.
    [[nodiscard]] std::optional<Deviation> first_deviation(const NumberTables& numbers);
    /// Returns the cycles in which the behaviour differs from that of the tracked code if one value gets other numbers
    /// than in the baseline.
    [[nodiscard]] std::vector<std::size_t> deviations(ValuePlace changed, const NumbersOfValue& numbers);
    /// Returns the cycles from the beginning to this one.
    [[nodiscard]] std::vector<std::size_t> path_to(std::size_t cycle) const;
    /// Returns the inputs whose registers contain the value in a cycle.
    [[nodiscard]] std::vector<std::uint32_t> readers(std::size_t cycle, ValuePlace value) const;

private:
    using Bytes = std::vector<unsigned char>;

    void set_values(std::uint32_t type);
    [[nodiscard]] bool make_cycle(const TrackedCycle& cycle);
    [[nodiscard]] bool same_writes(const TrackedCycle& cycle) const;
    [[nodiscard]] bool same_value(std::uint32_t type, std::int64_t expected, std::int64_t found) const;
    [[nodiscard]] bool same_row(std::uint32_t type, std::size_t one, std::size_t other) const;
    [[nodiscard]] Deviation deviation_at(std::size_t cycle);
    [[nodiscard]] bool is_changed(std::uint32_t image) const;
    [[nodiscard]] unsigned char* state(std::uint32_t image) { return states_.data() + image * size_; }

    const rc_interface& code_;
    const rc_deployed& deployed_;
    const TrackedCycles& explored_;
    const PartsOfTypes& parts_;
    const OutputTypes& output_types_;
    diagnostics::Pollable& budget_;
    std::size_t size_;
    NumberTables numbers_;                        ///< numbers of the run; those of the baseline outside `deviations`
    std::vector<std::vector<std::int64_t>> set_;  ///< the same numbers as the code reads them
    NumberTables baseline_;                       ///< numbers of the last run without a deviation
    Bytes states_;                                ///< states of the run, by image
    Bytes baseline_states_;
    std::vector<std::size_t> first_;  ///< by image: the first cycle that leads to it
    std::vector<std::size_t> begin_;  ///< by image: the first cycle that begins in it; then the number of cycles
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> readers_;  ///< by type and value
    Bytes after_;
    CycleLog log_;
};

}  // namespace robochart::conformance
