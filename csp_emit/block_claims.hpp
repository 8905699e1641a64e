// The claims that CSP blocks make as assert lines, and what is wrong with claims about processes of blocks and can be
// seen without deciding them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "csp_emit/base/component.hpp"
#include "csp_emit/base/emission.hpp"
#include "csp_emit/base/project.hpp"

namespace robochart::csp_emit {

/// The assert lines of blocks, the only ones among these declarations, as they stand.
[[nodiscard]] std::vector<Obligation> block_obligations(const Project&, const std::vector<cspm::DeclPtr>& decls);

/// The declarations of the blocks of each assertion file, by its path.
using DeclsOfFiles = std::map<std::string, std::vector<cspm::DeclPtr>>;

/// Reports claims about blocks of another time (RC-C14), blocks that define no process of their own name (RC-C11), and
/// claims in a model with refusals about a process that hides inputs of a component (RC-C12). Hidden events happen by
/// themselves and at once (Roscoe, Understanding Concurrent Systems, 5.1), a state that can do one is unstable and has
/// no refusals, so such a claim demands nothing of it.
void check_block_claims(const Project&, const DeclsOfFiles&, const Provenance&);

}  // namespace robochart::csp_emit
