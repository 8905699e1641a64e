// SPDX-License-Identifier: Apache-2.0
// Runs the rows of a table: a row is a state of the code and a reading of each register (docs/certificates.md,
// "Replaying a table").
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "conformance/replay/table.hpp"
#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::replay {

/// The row that runs. It is in memory that the program shares with the process that runs the rows, so that it survives
/// a crash of the code.
struct Progress {
    volatile std::uint64_t rows = 0;   ///< rows begun
    volatile std::uint32_t state = 0;  ///< index of Table::states
    rc_register* registers = nullptr;  ///< one for each input
};

/// Returns the current row in words: "row 7, in state=S1 with {seeRobot}".
[[nodiscard]] std::string row_words(const Table&, const Progress&);

/// Runs each row once. Returns the first difference between table and code in words, or no value if there is none.
/// Throws Unusable if the object has another interface version or belongs to another component.
[[nodiscard]] std::optional<std::string> first_difference(const Table&, const rc_interface& code, Progress&);

}  // namespace robochart::replay
