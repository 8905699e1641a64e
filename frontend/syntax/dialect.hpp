// SPDX-License-Identifier: Apache-2.0
// Distinguishes the two dialects of model and assertion files. RoboSim extends RoboChart: in each cycle, its machines
// read registers, run, write registers, and wait for the end of the cycle. The extension of a file determines its
// dialect.
#pragma once

#include <cstdint>
#include <string_view>

namespace robochart::frontend {

enum class Dialect : std::uint8_t {
    robochart,  ///< `.rct`, `.assertions`
    robosim,    ///< `.rst`, `.rsa`
};

/// Returns the dialect of a file: RoboSim for `.rst` and `.rsa`, RoboChart for every other name.
[[nodiscard]] Dialect dialect_of(std::string_view path);
/// Returns the name of the dialect in messages.
[[nodiscard]] std::string_view to_text(Dialect dialect);

/// True for `.rct` and `.rst`.
[[nodiscard]] bool is_model_path(std::string_view path);
/// True for `.assertions` and `.rsa`.
[[nodiscard]] bool is_assertion_path(std::string_view path);

}  // namespace robochart::frontend
