// SPDX-License-Identifier: Apache-2.0
// Collects the claims in CSP blocks, which are assert lines. Reports errors in claims about processes of blocks if they
// can be found without a search.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "csp_emit/base/component.hpp"
#include "csp_emit/base/emission.hpp"
#include "csp_emit/base/project.hpp"

namespace robochart::csp_emit {

/// Returns one obligation for each assert line in these declarations, without changing the lines. The declarations must
/// contain no other assertions.
[[nodiscard]] std::vector<Obligation> block_obligations(const Project&, const std::vector<cspm::DeclPtr>& decls);

/// The declarations of the blocks of each assertion file, by its path.
using DeclsOfFiles = std::map<std::string, std::vector<cspm::DeclPtr>>;

/// Reports three kinds of claims. (1) A claim about a block of the other semantics (RC-C14). (2) A claim about a block
/// that defines no process with its own name (RC-C11). (3) A claim in a semantic model with refusals about a process
/// that hides inputs of a component (RC-C12). Claims (3) are reported because hidden events happen spontaneously and at
/// once (Roscoe, Understanding Concurrent Systems, 5.1). A state with a hidden event is unstable and has no refusals,
/// so the claim says nothing about this state.
void check_block_claims(const Project&, const DeclsOfFiles&, const Provenance&);

}  // namespace robochart::csp_emit
