// SPDX-License-Identifier: Apache-2.0
// Checks on a copy of the project whether a renaming preserves the meaning of every name, before the editor gets the
// answer.
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

/// The problem that these edits of names would cause. "" if every name has the same meaning as before and the rules
/// report the same findings.
[[nodiscard]] std::string harm_of(Project&, const std::vector<Edit>& edits);

}  // namespace robochart::lsp
