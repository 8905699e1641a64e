// Points, sizes and rectangles, in pixels; y grows downwards.
#pragma once

namespace robochart::diagrams::layout {

/// A place.
struct Point {
    double x = 0, y = 0;
    friend bool operator==(const Point&, const Point&) = default;
};

/// How large something is.
struct Size {
    double width = 0, height = 0;
    [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
    friend bool operator==(const Size&, const Size&) = default;
};

/// A rectangle with sides along the axes.
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

/// Do they share more than a border? `apart`: how far they may reach into each other.
[[nodiscard]] inline bool overlap(const Rectangle& a, const Rectangle& b, double apart = 0) {
    return a.x + apart < b.right() && b.x + apart < a.right() && a.y + apart < b.bottom() && b.y + apart < a.bottom();
}

}  // namespace robochart::diagrams::layout
