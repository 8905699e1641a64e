// Declares vectors and matrices of fixed size. They are trivially copyable, and equal values have equal bytes.
// Arithmetic is that of the model, entry by entry. Products are row times column, and sums are computed from the left.
// Delivered with the generated code; robochart/eigen.hpp converts them to Eigen's fixed-size types. Copyright: see
// LICENSE (Apache-2.0).
#ifndef ROBOCHART_MATRIX_HPP
#define ROBOCHART_MATRIX_HPP

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "robochart/runtime.hpp"

namespace robochart {

namespace detail {

/// The common part of vectors and matrices: `entries` numbers in row-major order.
template <class T, std::size_t entries>
struct Block {
    T entry_[entries]{};

    friend constexpr bool operator==(const Block& a, const Block& b) noexcept {
        for (std::size_t i = 0; i < entries; ++i)
            if (!(a.entry_[i] == b.entry_[i])) return false;
        return true;
    }
    friend constexpr bool operator!=(const Block& a, const Block& b) noexcept { return !(a == b); }
    friend constexpr bool operator<(const Block& a, const Block& b) noexcept {
        for (std::size_t i = 0; i < entries; ++i)
            if (!(a.entry_[i] == b.entry_[i])) return a.entry_[i] < b.entry_[i];
        return false;
    }
};

constexpr bool within(std::int64_t place, std::size_t length) noexcept {
    return place >= 1 && static_cast<std::uint64_t>(place) <= length;
}

}  // namespace detail

/// A column of `length` entries, which are counted from 1 as in the model.
template <class T, std::size_t length>
struct Vector : detail::Block<T, length> {
    using value_type = T;
    static constexpr std::size_t rows = length;
    static constexpr std::size_t columns = 1;

    template <class... Items>
    [[nodiscard]] static constexpr Vector of(Items... items) noexcept {
        static_assert(sizeof...(Items) == length, "one value for each component");
        Vector result;
        std::size_t place = 0;
        ((result.entry_[place++] = T(items)), ...);
        return result;
    }
    /// Returns an entry. Outside the vector, returns a default-constructed value.
    [[nodiscard]] constexpr T at(std::int64_t place) const noexcept {
        return detail::within(place, length) ? this->entry_[place - 1] : T{};
    }
    constexpr void put(std::int64_t place, T item) noexcept {
        if (detail::within(place, length)) this->entry_[place - 1] = item;
    }
    [[nodiscard]] constexpr const T* data() const noexcept { return this->entry_; }
    [[nodiscard]] constexpr T* data() noexcept { return this->entry_; }
};

/// Rows of equal length, which are counted from 1 as in the model.
template <class T, std::size_t height, std::size_t width>
struct Matrix : detail::Block<T, height * width> {
    using value_type = T;
    static constexpr std::size_t rows = height;
    static constexpr std::size_t columns = width;

    template <class... Items>
    [[nodiscard]] static constexpr Matrix of(Items... items) noexcept {
        static_assert(sizeof...(Items) == height * width, "one value for each entry");
        Matrix result;
        std::size_t place = 0;
        ((result.entry_[place++] = T(items)), ...);
        return result;
    }
    /// Returns a row.
    [[nodiscard]] constexpr Vector<T, width> at(std::int64_t row) const noexcept {
        Vector<T, width> result;
        for (std::size_t i = 0; i < width && detail::within(row, height); ++i)
            result.entry_[i] = this->entry_[static_cast<std::size_t>(row - 1) * width + i];
        return result;
    }
    constexpr void put(std::int64_t row, const Vector<T, width>& items) noexcept {
        for (std::size_t i = 0; i < width && detail::within(row, height); ++i)
            this->entry_[static_cast<std::size_t>(row - 1) * width + i] = items.entry_[i];
    }
    [[nodiscard]] constexpr const T* data() const noexcept { return this->entry_; }
    [[nodiscard]] constexpr T* data() noexcept { return this->entry_; }
};

template <class T>
struct IsBlock : std::false_type {};
template <class T, std::size_t length>
struct IsBlock<Vector<T, length>> : std::true_type {};
template <class T, std::size_t height, std::size_t width>
struct IsBlock<Matrix<T, height, width>> : std::true_type {};
template <class T>
inline constexpr bool is_block = IsBlock<T>::value;

template <class B, std::enable_if_t<is_block<B>, int> = 0>
constexpr B operator+(B a, const B& b) noexcept {
    for (std::size_t i = 0; i < B::rows * B::columns; ++i) a.entry_[i] = plus(a.entry_[i], b.entry_[i]);
    return a;
}
template <class B, std::enable_if_t<is_block<B>, int> = 0>
constexpr B operator-(B a, const B& b) noexcept {
    for (std::size_t i = 0; i < B::rows * B::columns; ++i) a.entry_[i] = minus(a.entry_[i], b.entry_[i]);
    return a;
}
template <class B, std::enable_if_t<is_block<B>, int> = 0>
constexpr B operator-(B a) noexcept {
    for (std::size_t i = 0; i < B::rows * B::columns; ++i) a.entry_[i] = negative(a.entry_[i]);
    return a;
}
/// Multiplies every entry by a number, with the operands in the order written.
template <class B, std::enable_if_t<is_block<B>, int> = 0>
constexpr B operator*(B a, typename B::value_type factor) noexcept {
    for (std::size_t i = 0; i < B::rows * B::columns; ++i) a.entry_[i] = times(a.entry_[i], factor);
    return a;
}
template <class B, std::enable_if_t<is_block<B>, int> = 0>
constexpr B operator*(typename B::value_type factor, B a) noexcept {
    for (std::size_t i = 0; i < B::rows * B::columns; ++i) a.entry_[i] = times(factor, a.entry_[i]);
    return a;
}

/// Computes the matrix product: rows times columns.
template <class Result, class A, class B>
constexpr Result product(const A& a, const B& b) noexcept {
    static_assert(A::columns == B::rows && Result::rows == A::rows && Result::columns == B::columns);
    Result result;
    for (std::size_t row = 0; row < A::rows; ++row) {
        for (std::size_t column = 0; column < B::columns; ++column) {
            auto sum = times(a.entry_[row * A::columns], b.entry_[column]);
            for (std::size_t i = 1; i < A::columns; ++i)
                sum = plus(sum, times(a.entry_[row * A::columns + i], b.entry_[i * B::columns + column]));
            result.entry_[row * B::columns + column] = sum;
        }
    }
    return result;
}
/// Computes the dot product.
template <class T, std::size_t length>
constexpr T dot(const Vector<T, length>& a, const Vector<T, length>& b) noexcept {
    T sum = times(a.entry_[0], b.entry_[0]);
    for (std::size_t i = 1; i < length; ++i) sum = plus(sum, times(a.entry_[i], b.entry_[i]));
    return sum;
}
template <class Result, class A>
constexpr Result transposed(const A& a) noexcept {
    static_assert(Result::rows * Result::columns == A::rows * A::columns);
    Result result;
    for (std::size_t row = 0; row < A::rows; ++row)
        for (std::size_t column = 0; column < A::columns; ++column)
            result.entry_[column * A::rows + row] = a.entry_[row * A::columns + column];
    return result;
}

}  // namespace robochart

#endif
