// Converts vectors and matrices of the model to Eigen's fixed-size types and back, without copies for read access.
// Include it if the robot's code computes with Eigen 3.4 (Debian: libeigen3-dev); nothing else needs Eigen. Delivered
// with the generated code. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_EIGEN_HPP
#define ROBOCHART_EIGEN_HPP

#include <Eigen/Core>

#include "robochart/matrix.hpp"

namespace robochart {

/// The type Eigen::Matrix<T, rows, columns>. Entries in the model are stored in row-major order, which for a column
/// vector makes no difference.
template <class Block>
using EigenType =
    Eigen::Matrix<typename Block::value_type, static_cast<int>(Block::rows), static_cast<int>(Block::columns),
                  Block::columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

/// Returns the entries as an Eigen object that refers to the same memory.
template <class Block, std::enable_if_t<is_block<Block>, int> = 0>
[[nodiscard]] Eigen::Map<EigenType<Block>> as_eigen(Block& block) noexcept {
    return Eigen::Map<EigenType<Block>>(block.data());
}
template <class Block, std::enable_if_t<is_block<Block>, int> = 0>
[[nodiscard]] Eigen::Map<const EigenType<Block>> as_eigen(const Block& block) noexcept {
    return Eigen::Map<const EigenType<Block>>(block.data());
}

/// Returns the value of an Eigen expression as a vector or matrix of the model: `from_eigen<Vector<double, 2>>(a * b)`.
template <class Block, class Expression, std::enable_if_t<is_block<Block>, int> = 0>
[[nodiscard]] Block from_eigen(const Eigen::MatrixBase<Expression>& expression) {
    Block result;
    as_eigen(result) = expression;
    return result;
}

}  // namespace robochart

#endif
