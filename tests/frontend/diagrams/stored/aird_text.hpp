// SPDX-License-Identifier: Apache-2.0
// Generates files in RoboTool's format, piece by piece.
#pragma once

#include <string>

namespace robochart::diagrams {

/// Returns a file with these diagrams.
[[nodiscard]] std::string aird_text(const std::string& diagrams);
/// Returns a diagram with its elements, their shapes, and its lines.
[[nodiscard]] std::string aird_diagram(const std::string& elements, const std::string& shapes,
                                       const std::string& lines = "");

/// Returns an element with an id, its displayed text, the reference, the mapping, and the nested elements.
[[nodiscard]] std::string element(const std::string& id, const std::string& name, const std::string& href,
                                  const std::string& mapping, const std::string& inner = "");
/// Returns a line between two elements. The parameters are those of `element`.
[[nodiscard]] std::string line_element(const std::string& id, const std::string& name, const std::string& href,
                                       const std::string& mapping, const std::string& source,
                                       const std::string& target);

/// Returns a shape with a type, its bounds as attributes, and the nested shapes.
[[nodiscard]] std::string shape(int type, const std::string& id, const std::string& bounds,
                                const std::string& inner = "");
/// Returns the shapes inside a container: a title and a compartment.
[[nodiscard]] std::string container(const std::string& inner, bool title = true);
/// Returns a rectilinear line, whose anchors are in the middle of both ends.
[[nodiscard]] std::string line(const std::string& id, const std::string& points, const std::string& more = "");

}  // namespace robochart::diagrams
