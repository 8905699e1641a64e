// Pictures as SVG: one file that needs no other, readable in the light and in the dark. docs/diagrams.md shows it.
#pragma once

#include <map>
#include <string>

#include "diagrams/notation/elements.hpp"
#include "diagrams/notation/picture.hpp"

namespace robochart::diagrams {

/// The colours.
enum class Theme {
    automatic,  ///< as the reader prefers (prefers-color-scheme)
    light,
    dark,
};

/// How a picture is written.
struct SvgOptions {
    Theme theme = Theme::automatic;
    std::string id_prefix;  ///< in front of all ids, where several pictures come into one document
    /// By ids of elements: what their groups are besides, for styles around the picture.
    std::map<std::string, std::string> classes = {};
};

/// The picture. A group for every element has the element's id, and a second one of the same element `ID-2`;
/// `data-element` is the id without any of that. Names are text wherever they stand.
[[nodiscard]] std::string svg(const Picture& picture, const Elements& elements, const SvgOptions& options = {});

}  // namespace robochart::diagrams
