// Names of the model that CSPM could not keep: its keywords, its predefined functions and ours, where the script would
// take the element for them, and names that two elements would share there. Such elements get a number behind their
// name, all over the model alike.
#pragma once

#include "csp_emit/project.hpp"

namespace robochart::csp_emit {

/// The system, and its instantiation, with names that CSPM can keep.
struct SafeNames {
    bool changed = false;  ///< if not, `system` and `instantiation` are empty and the originals serve
    ir::System system;
    ir::Instantiation instantiation;
};

/// Renames what needs to be; each renamed element is reported once (RC-C04, RC-C09).
[[nodiscard]] SafeNames safe_names(const ir::System&, const ir::Instantiation&, diagnostics::Diagnostics&);

}  // namespace robochart::csp_emit
