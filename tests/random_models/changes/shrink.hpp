// Smaller models that still show a fault: what delta debugging is for random models (Zeller, Hildebrandt: Simplifying
// and isolating failure-inducing input, IEEE TSE 2002; here along the syntax tree).
#pragma once

#include <cstddef>
#include <functional>

#include "tests/random_models/models/project.hpp"

namespace robochart::random_models {

/// A cut: a piece of a file and what to put in its place.
struct Cut {
    std::size_t file = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string replacement;
};

/// Every cut of one step: a file, declaration, member, node, transition or clause goes, a statement becomes `skip` or
/// one of its parts, an expression becomes one of its parts. Largest first. Not all variants are well-formed.
[[nodiscard]] std::vector<Cut> cuts(const Project& project);
[[nodiscard]] Project after(const Project& project, const Cut& cut);

/// Cuts for as long as a variant still fails, judged at most `budget` times. The result fails.
[[nodiscard]] Project shrink(Project failing, const std::function<bool(const Project&)>& fails,
                             std::size_t budget = 3000);

}  // namespace robochart::random_models
