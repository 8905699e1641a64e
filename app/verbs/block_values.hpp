// Where csp blocks replace the instantiation, generated code and its comparison have other values than the assertions.
#pragma once

#include <string>

#include "app/command/pipeline.hpp"
#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::app {

/// The constants and functions that the timed blocks define, and that are something else in these definitions, which
/// were made without blocks: "RC = 0 (there 1), ms(...)". "": there are none.
[[nodiscard]] std::string values_unlike_blocks(const Project&, const cspm::Script& without_blocks);

}  // namespace robochart::app
