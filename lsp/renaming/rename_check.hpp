// Does a renaming keep the meaning of every name? Tried out on a copy before an editor hears of it.
#pragma once

#include <string>
#include <vector>

#include "lsp/workspace/workspace.hpp"

namespace robochart::lsp {

/// A piece of text to put in place of another.
struct Edit {
    Span span;
    std::string text;
};

/// What would be wrong with the project after these edits of names: "" if every name stands for the same as before and
/// the rules find what they found before.
[[nodiscard]] std::string harm_of(Project&, const std::vector<Edit>& edits);

}  // namespace robochart::lsp
