// SPDX-License-Identifier: Apache-2.0
// Writes the functions with which the exploration interface prints a state. They print the name and value of each
// field.
#pragma once

#include <string>

#include "cpp_emit/files/files.hpp"

namespace robochart::cpp_emit {

/// The types of numbers over which the core is written.
enum class Numbers { finite, tracked, deployed };

class StatePrinters {
public:
    StatePrinters(const Generation& generation, const Core& core) : generation_(generation), core_(core) {}

    /// Returns whether some field has parts. Such values are printed as in logs (robochart/explore_values.hpp,
    /// NAME_trace.hpp).
    [[nodiscard]] bool words_of_logs() const;
    /// Writes the functions `print`; the last one prints the whole state.
    void write(CodeWriter&, Numbers numbers);

private:
    void name_functions(CodeWriter&) const;
    void print_unit(CodeWriter&, std::size_t unit) const;
    void print_composed(CodeWriter&) const;
    void print_field(CodeWriter&, const Field&) const;
    void print_frame(CodeWriter&, const Field&) const;
    [[nodiscard]] std::string value_printer(const std::string& type, const std::string& value) const;
    [[nodiscard]] bool is_frame_type(const std::string& type) const;
    [[nodiscard]] bool is_named_type(const std::string& type) const;

    const Generation& generation_;
    const Core& core_;
    Numbers numbers_ = Numbers::finite;
};

}  // namespace robochart::cpp_emit
