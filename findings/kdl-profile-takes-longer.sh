#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Profiles of Orocos KDL take longer than the duration that they are given, and report no error.
#
# Expected: `SetProfileDuration(from, to, 5)` makes a motion of 5 s, or reports by an exception, a result or a state that
#   the limits of velocity and acceleration do not allow it.
# Observed: the function returns nothing and throws nothing. A trapezoidal profile takes its shortest time instead, here
#   11 s, so after 5 s the axis has moved 4.5 of 10 units. The half trapezoid does the same. The spline profile has no
#   limits, and takes 5 s with any acceleration.
# Why it matters: a controller that moves several axes gives each of them the duration of the slowest. If that duration
#   was computed with other limits, one axis arrives late and the tool leaves its path. Only `Duration()` shows it.
# usage: findings/kdl-profile-takes-longer.sh; needs g++ and Debian 12's apt to download packages; exit code 0 if the
# behaviour is as described.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -q liborocos-kdl1.5=1.5.1-2+b4 liborocos-kdl-dev=1.5.1-2+b4 libeigen3-dev=3.4.0-4 >/dev/null 2>&1
for package in ./*.deb; do
  basename "$package"
  dpkg -x "$package" .
done

cat > profiles.cpp <<'END'
#include <cstdio>
#include <kdl/velocityprofile_spline.hpp>
#include <kdl/velocityprofile_trap.hpp>
#include <kdl/velocityprofile_traphalf.hpp>

// Moves from 0 to 10 in this time.
void show(const char* name, KDL::VelocityProfile& profile, double time) {
    try {
        profile.SetProfileDuration(0, 10, time);
        std::printf("%s %g s: duration %g, at 1 s %g, at 5 s %g\n", name, time, profile.Duration(), profile.Pos(1),
                    profile.Pos(5));
    } catch (...) {
        std::printf("%s %g s: exception\n", name, time);
    }
}

int main() {
    KDL::VelocityProfile_Trap trapezoid(1, 1);  // velocity and acceleration at most 1
    KDL::VelocityProfile_TrapHalf half(1, 1, true);
    KDL::VelocityProfile_Spline spline;
    for (const double time : {20.0, 5.0}) {
        show("trapezoid", trapezoid, time);
        show("half", half, time);
        show("spline", spline, time);
    }
}
END
library=$(dirname "$(find . -name 'liborocos-kdl.so')")
g++ -std=c++17 -O1 -I usr/include -I usr/include/eigen3 profiles.cpp -L "$library" -lorocos-kdl \
  -Wl,-rpath,"$folder/$library" -o profiles
./profiles | tee out.txt

grep -q '^trapezoid 20 s: duration 20,' out.txt
grep -q '^trapezoid 5 s: duration 11, .* at 5 s 4.5$' out.txt
grep -q '^half 5 s: duration 10.5, .* at 5 s 4.5$' out.txt
grep -q '^spline 5 s: duration 5, .* at 5 s 10$' out.txt
