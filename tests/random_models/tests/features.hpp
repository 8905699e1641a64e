// SPDX-License-Identifier: Apache-2.0
// Derives the language features that a text uses from the structure of its tree, to measure the coverage of the
// generators.
#pragma once

#include <set>
#include <string>

namespace robochart::random_models {

/// The features of trees, as words.
struct Features {
    /// Kinds of nodes with every mark that they may have (`event: broadcast`), with and without parts (`literal/+`,
    /// `set/0` for `{}`), and with their missing parts (`exists -+` without `|`).
    std::set<std::string> constructs;
    /// Pairs of a kind and a kind directly inside it (`wait > range`), and marks that occur together.
    std::set<std::string> compositions;
};

/// Adds the features of an output of `structure_text`.
void add_features(const std::string& structure, Features& features);

/// Returns the words of the first set that are missing in the second, one per line.
[[nodiscard]] std::string lacking(const std::set<std::string>& expected, const std::set<std::string>& found);

}  // namespace robochart::random_models
