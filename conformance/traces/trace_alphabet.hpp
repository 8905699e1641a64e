// SPDX-License-Identifier: Apache-2.0
// Maps words of a log to events of NF_c(M): `e?v` is a reading, `o!a!b` a write (docs/traces.md). Distinguishes values
// inside and outside the finite instantiation.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "conformance/model/cyclic_model.hpp"
#include "conformance/model/logged_value.hpp"
#include "conformance/traces/trace_text.hpp"

namespace robochart::conformance {

struct LoggedEvent {
    enum class Kind { read, write };
    Kind kind = Kind::read;
    std::uint32_t index = 0;              ///< index of the register or output
    std::vector<LoggedValue> values;      ///< empty for events without values
    process::Event event = process::tau;  ///< valid if all values are in their carriers
    /// For a write with values close to numbers of their carriers: the event with these numbers. Otherwise tau. The
    /// component may have computed such a value with a rounding error, or may have passed on a number that it has read.
    process::Event rounded = process::tau;

    [[nodiscard]] bool is_inside() const;
};

class TraceAlphabet {
public:
    /// `codes` contains the numbers of a log that the model's instantiation was extended by.
    explicit TraceAlphabet(const CyclicModel&, const NumberCodes& codes = {});

    /// Returns the event for a word. Throws TraceFault. The reference is valid until the next call.
    [[nodiscard]] const LoggedEvent& read_event(const TraceToken&);
    /// Returns the kind of event for a name with `?` or `!`. Throws TraceFault.
    [[nodiscard]] LoggedEvent parse_kind(const TraceToken&) const;
    /// Returns the event with representatives in place of values outside their carriers.
    [[nodiscard]] process::Event replacement_event(const LoggedEvent&, std::uint64_t salt) const;
    [[nodiscard]] const std::vector<std::string>& inputs() const { return inputs_; }
    [[nodiscard]] const std::vector<std::string>& outputs() const { return outputs_; }

private:
    [[nodiscard]] LoggedEvent parse_event(const TraceToken&, NumberReading) const;
    [[nodiscard]] static LoggedValue parse_value(const ValueReader&, std::string_view text, const TraceToken& token,
                                                 std::string_view name);

    const CyclicModel* model_;
    std::vector<std::string> inputs_, outputs_;
    std::unordered_map<std::string, std::uint32_t> input_ids_, output_ids_;  ///< never iterated
    std::vector<std::optional<ValueReader>> input_values_;
    std::vector<std::vector<ValueReader>> output_values_, rounded_values_;
    std::unordered_map<std::string, LoggedEvent> known_;  ///< by token; never iterated
    LoggedEvent last_;
};

}  // namespace robochart::conformance
