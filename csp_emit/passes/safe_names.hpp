// SPDX-License-Identifier: Apache-2.0
// Renames elements of the model whose names CSPM cannot use: its keywords, predefined and library functions that the
// script would confuse with the element, and names that two elements would share in the script. Such an element gets a
// number after its name, everywhere in the model.
#pragma once

#include "checker/cspm/syntax/rename.hpp"
#include "csp_emit/base/project.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// The names that CSP blocks use for renamed elements, and their names in the script.
struct NamesForBlocks {
    cspm::NewNames data;    ///< types, literals, functions, constants
    cspm::NewNames first;   ///< components and packages: the first part of a qualified name
    cspm::NewNames inside;  ///< states and parts of components: the parts between the first and the last
    cspm::NewNames last;    ///< events: the last part
};

/// The system and its instantiation, with names that CSPM can use.
struct SafeNames {
    bool changed = false;  ///< if false, `system` and `instantiation` are empty and the originals are valid
    ir::System system;
    ir::Instantiation instantiation;
    NamesForBlocks for_blocks;
};

/// Renames elements where necessary, and reports each renamed element once (RC-C04, RC-C09). Two elements that would
/// share a name and cannot be renamed are rejected (RC-C10).
[[nodiscard]] SafeNames safe_names(const ir::System&, const ir::Instantiation&, diagnostics::Diagnostics&);

}  // namespace robochart::csp_emit
