// SPDX-License-Identifier: Apache-2.0
// Shrinks random models that show a fault. This is delta debugging (Zeller, Hildebrandt: Simplifying and isolating
// failure-inducing input, IEEE TSE 2002), here along the syntax tree.
#pragma once

#include <cstddef>
#include <functional>

#include "tests/random_models/models/project.hpp"

namespace robochart::random_models {

/// A piece of a file, and the text that replaces it.
struct Cut {
    std::size_t file = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string replacement;
};

/// Returns all cuts of one step, the largest first: removal of a file, declaration, member, node, transition or clause;
/// replacement of a statement by `skip` or one of its parts; replacement of an expression by one of its parts. Some
/// variants are not well-formed.
[[nodiscard]] std::vector<Cut> find_cuts(const Project& project);
[[nodiscard]] Project apply_cut(const Project& project, const Cut& cut);

/// Makes cuts as long as a variant still fails, with at most `budget` calls of `fails`. The returned project fails.
[[nodiscard]] Project shrink(Project failing, const std::function<bool(const Project&)>& fails,
                             std::size_t budget = 3000);

}  // namespace robochart::random_models
