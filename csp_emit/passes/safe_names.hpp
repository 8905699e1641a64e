// Names of the model that CSPM could not keep: its keywords, its predefined functions and ours, where the script would
// take the element for them, and names that two elements would share there. Such elements get a number behind their
// name, all over the model alike.
#pragma once

#include "checker/cspm/syntax/rename.hpp"
#include "csp_emit/base/project.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// What csp blocks call the renamed elements, and what these are called in the script.
struct NamesForBlocks {
    cspm::NewNames data;    ///< types, literals, functions, constants
    cspm::NewNames first;   ///< components and packages: the first part of a qualified name
    cspm::NewNames inside;  ///< states and parts of components: the parts between the first and the last
    cspm::NewNames last;    ///< events: the last part
};

/// The system, and its instantiation, with names that CSPM can keep.
struct SafeNames {
    bool changed = false;  ///< if not, `system` and `instantiation` are empty and the originals serve
    ir::System system;
    ir::Instantiation instantiation;
    NamesForBlocks for_blocks;
};

/// Renames what needs to be; each renamed element is reported once (RC-C04, RC-C09). Two elements that would share a
/// name and cannot be renamed are refused (RC-C10).
[[nodiscard]] SafeNames safe_names(const ir::System&, const ir::Instantiation&, diagnostics::Diagnostics&);

}  // namespace robochart::csp_emit
