#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Eigen's `minCoeff` can skip valid readings of a laser scan because another reading is NaN.
#
# Expected: the minimum of numbers with one NaN among them is NaN, or it is the minimum of the other numbers.
# Observed: with the compiler's default options it is, for some places of the NaN, a third value: some valid readings
#   are left out, among them the nearest. The lanes of a vector are reduced one by one, and a NaN in a lane takes the
#   place of what this lane has found before. Which places these are depends on the length of the scan and on the
#   compiler's options: with -march=native or EIGEN_DONT_VECTORIZE they are others, or there are none. The documentation
#   calls the result undefined. `minCoeff<Eigen::PropagateNumbers>()` is right in all places.
# Why it matters: drivers of laser scanners report a direction without echo as NaN. A stop distance that is compared with
#   `scan.minCoeff()` then misses the nearest obstacle in one direction out of a hundred, on one computer and not on the
#   other, and a unit test with another length of the scan passes.
# usage: findings/eigen-nan-hides-the-nearest-reading.sh; needs g++ and Debian 12's apt to download a package; exit code
# 0 if the behaviour is as described.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -q libeigen3-dev=3.4.0-4 >/dev/null 2>&1
dpkg -x libeigen3-dev_*.deb .

cat > scan.cpp <<'END'
#include <Eigen/Core>

#include <cmath>
#include <iostream>
#include <limits>

// Scans whose distances fall from `size` to 1, with a NaN in each place in turn. Prints in how many of them the minimum
// is NaN, is the least of the other readings, and is neither.
void print_minima(int size) {
    int undefined = 0, right = 0, wrong = 0, right_numbers = 0;
    for (int place = 0; place < size; ++place) {
        Eigen::VectorXf scan = Eigen::VectorXf::LinSpaced(size, float(size), 1.F);
        const float least = place == size - 1 ? scan[size - 2] : scan[size - 1];
        scan[place] = std::numeric_limits<float>::quiet_NaN();
        const float found = scan.minCoeff();
        if (std::isnan(found)) ++undefined;
        else if (found == least) ++right;
        else ++wrong;
        if (scan.minCoeff<Eigen::PropagateNumbers>() == least) ++right_numbers;
    }
    std::cout << size << " readings: NaN " << undefined << ", least of the others " << right << ", neither " << wrong
              << "; with PropagateNumbers right " << right_numbers << "\n";
}

int main() {
    std::cout << "Eigen " << EIGEN_WORLD_VERSION << "." << EIGEN_MAJOR_VERSION << "." << EIGEN_MINOR_VERSION << "\n";
    for (const int size : {8, 16, 360}) print_minima(size);
}
END
g++ -O2 -Iusr/include/eigen3 scan.cpp -o default
g++ -O2 -Iusr/include/eigen3 -DEIGEN_DONT_VECTORIZE scan.cpp -o scalar
echo "g++ -O2:"
./default | tee default.txt
echo "g++ -O2 -DEIGEN_DONT_VECTORIZE:"
./scalar | tee scalar.txt
grep -q '^360 readings: NaN 1, least of the others 35[0-8], neither [1-9]' default.txt
grep -q '^360 readings: NaN 1, least of the others 359, neither 0' scalar.txt
[ "$(grep -c 'right 360$' default.txt)" -eq 1 ]
