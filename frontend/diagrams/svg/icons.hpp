// SPDX-License-Identifier: Apache-2.0
// The icons of diagrams, drawn for this project.
#pragma once

#include <string>

#include "frontend/diagrams/notation/picture.hpp"

namespace robochart::diagrams {

/// The contents of an SVG group whose origin is the centre of the icon.
[[nodiscard]] std::string icon_svg(Icon icon);

}  // namespace robochart::diagrams
