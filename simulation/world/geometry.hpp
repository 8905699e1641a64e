// SPDX-License-Identifier: Apache-2.0
// Computes with points, segments and rays in the plane. Lengths are centimetres, angles radians, counter-clockwise from
// the x axis.
#pragma once

#include <optional>
#include <vector>

namespace robochart::simulation {

struct Vector {
    double x = 0;
    double y = 0;

    friend bool operator==(const Vector&, const Vector&) = default;
};

inline Vector operator+(Vector a, Vector b) {
    return {a.x + b.x, a.y + b.y};
}
inline Vector operator-(Vector a, Vector b) {
    return {a.x - b.x, a.y - b.y};
}
inline Vector operator*(double k, Vector a) {
    return {k * a.x, k * a.y};
}
inline double dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y;
}
inline double cross(Vector a, Vector b) {
    return a.x * b.y - a.y * b.x;
}
[[nodiscard]] double length(Vector);

/// A straight wall without thickness.
struct Segment {
    Vector from, to;
};

struct Pose {
    Vector at;
    double heading = 0;
};

/// Returns the distance at which a ray from `origin` along the unit vector `direction` enters a disk; 0 if it starts
/// inside.
[[nodiscard]] std::optional<double> hit_disk(Vector origin, Vector direction, Vector centre, double radius);
/// Returns the distance at which the ray meets a wall.
[[nodiscard]] std::optional<double> hit_segment(Vector origin, Vector direction, const Segment&);
/// Returns the nearest point of a wall.
[[nodiscard]] Vector nearest_point(const Segment&, Vector);
/// True if a point is in a polygon, which is given by its corners in order. A ray from such a point crosses the border
/// an odd number of times.
[[nodiscard]] bool is_inside(const std::vector<Vector>& polygon, Vector);
/// Returns the equivalent angle in (-pi, pi].
[[nodiscard]] double normal_angle(double);

}  // namespace robochart::simulation
