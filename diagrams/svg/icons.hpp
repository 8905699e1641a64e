// The signs of diagrams, drawn for this project.
#pragma once

#include <string>

#include "diagrams/notation/picture.hpp"

namespace robochart::diagrams {

/// The inside of an SVG group whose origin is the middle of the sign.
[[nodiscard]] std::string icon_svg(Icon icon);

}  // namespace robochart::diagrams
