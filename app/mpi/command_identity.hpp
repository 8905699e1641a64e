// Which robochart-verify this program was built with.
#pragma once

#include <string>

namespace robochart::app {

/// The build ID of the robochart-verify of the same build (diagnostics::program_identity at run time there); "" where
/// it has none. All that evaluates, compiles and searches comes from the same libraries, so that both have the same
/// rows.
[[nodiscard]] std::string command_identity();

}  // namespace robochart::app
