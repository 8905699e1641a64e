// SPDX-License-Identifier: Apache-2.0
// Writes pictures as self-contained SVG files for light and dark themes (docs/diagrams.md).
#pragma once

#include <map>
#include <string>

#include "frontend/diagrams/notation/elements.hpp"
#include "frontend/diagrams/notation/picture.hpp"

namespace robochart::diagrams {

/// The colour theme.
enum class Theme {
    automatic,  ///< follows the reader's preference (prefers-color-scheme)
    light,
    dark,
};

/// Options for writing a picture.
struct SvgOptions {
    Theme theme = Theme::automatic;
    std::string id_prefix;  ///< prefix of all ids, if one document contains several pictures
    /// Additional classes for groups, by element id, for style sheets of the enclosing document.
    std::map<std::string, std::string> classes = {};
};

/// Returns the picture as SVG. The group of an element has the element's id, and a second group of the same element has
/// `ID-2`. The attribute `data-element` is the id without prefix or number. Names are always escaped.
[[nodiscard]] std::string render_svg(const Picture& picture, const Elements& elements, const SvgOptions& options = {});

}  // namespace robochart::diagrams
