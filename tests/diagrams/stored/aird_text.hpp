// Files of RoboTool's form, written piece by piece.
#pragma once

#include <string>

namespace robochart::diagrams {

/// A file with these diagrams.
[[nodiscard]] std::string aird_text(const std::string& diagrams);
/// A diagram: what is drawn, where it is, and its lines.
[[nodiscard]] std::string aird_diagram(const std::string& elements, const std::string& shapes,
                                       const std::string& lines = "");

/// What is drawn: an id, the text shown, the reference, the mapping, and what is in it.
[[nodiscard]] std::string element(const std::string& id, const std::string& name, const std::string& href,
                                  const std::string& mapping, const std::string& inner = "");
/// The same for a line between two elements.
[[nodiscard]] std::string line_element(const std::string& id, const std::string& name, const std::string& href,
                                       const std::string& mapping, const std::string& source,
                                       const std::string& target);

/// A shape of a type with its bounds, as attributes, and what is in it.
[[nodiscard]] std::string shape(int type, const std::string& id, const std::string& bounds,
                                const std::string& inner = "");
/// What the shapes of containers have: a title and a compartment.
[[nodiscard]] std::string container(const std::string& inner, bool title = true);
/// A line with right angles; anchors in the middle of both ends.
[[nodiscard]] std::string line(const std::string& id, const std::string& points, const std::string& more = "");

}  // namespace robochart::diagrams
