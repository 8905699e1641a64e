// What a text of the language uses, read off the structure of its tree: the measure for what the generators reach.
#pragma once

#include <set>
#include <string>

namespace robochart::random_models {

/// Features of trees, as words: each is there or not.
struct Features {
    /// Kinds of nodes, each with every mark that it may bear (`event: broadcast`), with parts and without
    /// (`literal/+`, `set/0` for `{}`), and with the parts that it lacks (`exists -+` without `|`).
    std::set<std::string> constructs;
    /// Which kind stands directly in which (`wait > range`), and marks that come together.
    std::set<std::string> compositions;
};

/// Adds the features of what `structure` wrote.
void add_features(const std::string& structure, Features& features);

/// The words of the first set that the second lacks, a line each.
[[nodiscard]] std::string lacking(const std::set<std::string>& wanted, const std::set<std::string>& found);

}  // namespace robochart::random_models
