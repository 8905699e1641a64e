// SPDX-License-Identifier: Apache-2.0
// Compares vectors and matrices of generated code with Eigen's fixed-size types. Both compute with the same inputs, and
// the test compares the results step by step.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"
#include "tests/needed.hpp"

namespace robochart::cpp_emit::eigen_test {
namespace {

using testing::Folder;

/// The model has sums, products of all kinds, entries that are read and written, and a function that the platform
/// computes.
const char* const text = R"(package p
interface O {
    moved(at : vector(real, 3), turned : vector(real, 3), along : real, second : real)
    mapped(n : matrix(real, 2, 2), hooked : vector(real, 2), wide : matrix(real, 2, 3))
}
function turn(m : matrix(real, 2, 2), v : vector(real, 2)) : vector(real, 2) { }
stm M { requires O event step : vector(real, 3) event set : real
    var at : vector(real, 3) var v : vector(real, 3) var r : real
    var m : matrix(real, 3, 3) var n : matrix(real, 2, 2) var w : matrix(real, 2, 3)
    initial i state A { }
    transition t0 { from i to A action m[1, 2] = 1 ; m[2, 1] = -1 ; m[3, 3] = 1 ; n[1, 2] = 1 ; w[2, 3] = 1 }
    transition t1 { from A to A trigger step?v action at = at + v ; moved(at, m * at, at * v, at[2]) }
    transition t2 { from A to A trigger set?r
        action m[1, 1] = r ; n[2, 1] = m[1, 1] * at[1] ; w[1, 2] = r ; mapped(n * n - r * n, turn(n, [| at[1], r |]), n * w) } }
)";

const char* const program = R"(#include <cstdio>
#include <vector>
#include "M_core.hpp"
#include "robochart/eigen.hpp"
namespace core = p::M_core;
using Types = robochart::Deployment;
using robochart::as_eigen;
using robochart::from_eigen;
using Vector2 = robochart::Vector<double, 2>;
using Vector3 = robochart::Vector<double, 3>;
using Matrix2 = robochart::Matrix<double, 2, 2>;
using Matrix23 = robochart::Matrix<double, 2, 3>;
static_assert(std::is_same_v<robochart::EigenType<Vector3>, Eigen::Vector3d>);
static_assert(std::is_same_v<robochart::EigenType<Matrix23>, Eigen::Matrix<double, 2, 3, Eigen::RowMajor>>);
static_assert(std::is_trivially_copyable_v<core::State<Types>>);

/// What each cycle gave, number by number.
struct Plain {
    std::vector<double> done;

    template <class Block>
    void all(const Block& block) {
        for (std::size_t i = 0; i < Block::rows * Block::columns; ++i) done.push_back(block.data()[i]);
    }
    void moved(Vector3 at, Vector3 turned, double along, double second) noexcept {
        all(at);
        all(turned);
        done.push_back(along);
        done.push_back(second);
    }
    void mapped(Matrix2 n, Vector2 hooked, Matrix23 wide) noexcept {
        all(n);
        all(hooked);
        all(wide);
    }
    Vector2 turn(Matrix2 m, Vector2 v) noexcept { return robochart::product<Vector2>(m, v); }
};

/// The same, where the platform computes with Eigen.
struct WithEigen : Plain {
    Vector2 turn(Matrix2 m, Vector2 v) noexcept { return from_eigen<Vector2>(as_eigen(m) * as_eigen(v)); }
};

/// The model in Eigen alone.
struct Shadow {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
    Eigen::Matrix2d n = Eigen::Matrix2d::Zero();
    Eigen::Matrix<double, 2, 3> w = Eigen::Matrix<double, 2, 3>::Zero();
    std::vector<double> done;

    Shadow() {
        m(0, 1) = 1;
        m(1, 0) = -1;
        m(2, 2) = 1;
        n(0, 1) = 1;
        w(1, 2) = 1;
    }
    template <class Expression>
    void all(const Expression& expression) {
        for (Eigen::Index row = 0; row < expression.rows(); ++row)
            for (Eigen::Index column = 0; column < expression.cols(); ++column) done.push_back(expression(row, column));
    }
    void step(const Eigen::Vector3d& v) {
        at += v;
        all(at);
        all((m * at).eval());
        done.push_back(at.dot(v));
        done.push_back(at(1));
    }
    void set(double r) {
        m(0, 0) = r;
        n(1, 0) = m(0, 0) * at(0);
        w(0, 1) = r;
        all((n * n - r * n).eval());
        all((n * Eigen::Vector2d(at(0), r)).eval());
        all((n * w).eval());
    }
};

/// Equal; nearly, where numbers are rounded, for Eigen's sums may run in any order.
bool same(const std::vector<double>& a, const std::vector<double>& b, bool exactly) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double off = a[i] < b[i] ? b[i] - a[i] : a[i] - b[i];
        const double size = a[i] < 0 ? -a[i] : a[i];
        if (exactly ? off > 0 : off > 1e-12 * (1 + size)) return false;
    }
    return true;
}

/// Inputs are multiples of `unit`.
int run(double unit, bool exactly) {
    core::State<Types> plain_state = core::init<Types>(), eigen_state = plain_state;
    Plain plain;
    WithEigen with_eigen;
    Shadow shadow;
    core::step(plain_state, core::Inputs<Types>{}, plain);
    core::step(eigen_state, core::Inputs<Types>{}, with_eigen);
    std::uint32_t seed = 7;
    const auto next = [&] {
        seed = seed * 1664525U + 1013904223U;
        return unit * (static_cast<double>(seed >> 20U) - 2048.0);
    };
    for (int cycle = 0; cycle < 200; ++cycle) {
        core::Inputs<Types> inputs;
        if (cycle % 3 == 2) {
            inputs.set = {true, next()};
            shadow.set(inputs.set.value);
        } else {
            const Eigen::Vector3d v(next(), next(), next());
            inputs.step = {true, from_eigen<Vector3>(v)};
            shadow.step(v);
        }
        if (core::step(plain_state, inputs, plain) != robochart::StepResult::quiescent) return 1;
        if (core::step(eigen_state, inputs, with_eigen) != robochart::StepResult::quiescent) return 1;
        if (!same(plain.done, shadow.done, exactly) || !same(with_eigen.done, shadow.done, exactly)) {
            std::printf("cycle %d: not the same\n", cycle + 1);
            return 2;
        }
        if (exactly && !(plain_state == eigen_state)) return 3;
    }
    return plain.done.empty() ? 4 : 0;
}

int main() {
    // What is changed in Eigen's view is changed in the value: rows behind each other.
    Matrix23 block = Matrix23::of(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
    as_eigen(block)(1, 0) = 7;
    if (!(block == Matrix23::of(1.0, 2.0, 3.0, 7.0, 5.0, 6.0)) || as_eigen(block)(0, 2) < 3) return 5;
    const int exact = run(0.25, true);
    return exact != 0 ? exact : run(0.1, false);
}
)";

TEST(Eigen, ControllersComputeWhatEigenComputes) {
    Folder folder;
    std::string output;
    ROBOCHART_NEEDS(
        folder.status("echo '#include <Eigen/Core>' | c++ -I/usr/include/eigen3 -fsyntax-only -x c++ -", output) == 0,
        "Eigen (Debian: libeigen3-dev)");
    const ir::System system = testing::load_model(text);
    folder.write(testing::emit_ok(system, testing::component_named(system, "M")));
    std::ofstream(folder.path() + "/main.cpp") << program;
    folder.run(
        "c++ -std=c++17 -O1 -Wall -Wextra -Wpedantic -Wconversion -Werror -isystem /usr/include/eigen3 -I . main.cpp "
        "-o main && ./main");
}

}  // namespace
}  // namespace robochart::cpp_emit::eigen_test
