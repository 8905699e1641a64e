// SPDX-License-Identifier: Apache-2.0
// Defines points, sizes and rectangles in pixels. The y axis points downwards.
#pragma once

namespace robochart::diagrams::layout {

/// A point.
struct Point {
    double x = 0, y = 0;
    friend bool operator==(const Point&, const Point&) = default;
};

/// A size.
struct Size {
    double width = 0, height = 0;
    [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
    friend bool operator==(const Size&, const Size&) = default;
};

/// An axis-parallel rectangle.
struct Rectangle {
    double x = 0, y = 0, width = 0, height = 0;

    [[nodiscard]] double right() const { return x + width; }
    [[nodiscard]] double bottom() const { return y + height; }
    [[nodiscard]] Point centre() const { return {x + width / 2, y + height / 2}; }
    [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
    friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

/// A side of a rectangle.
enum class Side { left, right, top, bottom };

/// True if the rectangles overlap by more than `apart` in both directions.
[[nodiscard]] inline bool rectangles_overlap(const Rectangle& a, const Rectangle& b, double apart = 0) {
    return a.x + apart < b.right() && b.x + apart < a.right() && a.y + apart < b.bottom() && b.y + apart < a.bottom();
}

}  // namespace robochart::diagrams::layout
