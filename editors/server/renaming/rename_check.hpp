// SPDX-License-Identifier: Apache-2.0
// Checks on a copy of the project, before the editor gets the answer, whether a renaming preserves the meaning of every
// name.
#pragma once

#include <string>
#include <vector>

#include "editors/server/workspace/workspace.hpp"

namespace robochart::lsp {

/// A replacement of a piece of text.
struct Edit {
    Span span;
    std::string text;
};

/// Returns a problem that these edits of names would cause. Returns "" if every name would have the same meaning as
/// before and the rules would report the same findings.
[[nodiscard]] std::string harm_of(Project&, const std::vector<Edit>& edits);

}  // namespace robochart::lsp
