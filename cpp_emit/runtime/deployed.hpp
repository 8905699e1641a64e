// Stores values of inputs for code over the types of deployment: numbers that the explorer sets (explore_abi.h,
// rc_deployed). Delivered with the generated code. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_DEPLOYED_HPP
#define ROBOCHART_DEPLOYED_HPP

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <type_traits>

#include "robochart/explore.hpp"

namespace robochart {

/// The values of each tracked type, in memory of the explorer.
class SetValues {
public:
    static constexpr std::uint32_t most_types = 16;

    void set(std::uint32_t type, std::uint32_t parts, std::uint32_t count, const std::int64_t* numbers) noexcept {
        if (type < most_types) table_[type] = {numbers, parts, count};
    }
    template <class Number>
    [[nodiscard]] Number part(std::uint32_t type, std::uint32_t place, std::uint32_t part) const noexcept {
        return number<Number>(table_[type].numbers[place * table_[type].parts + part]);
    }
    /// Returns a sequence. Its length is stored first. If it is longer than the capacity, it overflows.
    template <class Sequence>
    [[nodiscard]] Sequence sequence(std::uint32_t type, std::uint32_t place) const noexcept {
        const std::int64_t* at = table_[type].numbers;
        for (std::uint32_t i = 0; i < place; ++i) at += 1 + *at;
        Sequence result;
        for (const std::int64_t* item = at + 1; item <= at + *at; ++item)
            result.append(number<typename Sequence::value_type>(*item));
        return result;
    }
    /// Returns the place of the first value that is equal to these numbers, or -1 if there is none.
    template <class... Parts>
    [[nodiscard]] std::int64_t place(std::uint32_t type, Parts... parts) const noexcept {
        for (std::uint32_t place = 0; place < table_[type].count; ++place) {
            std::uint32_t at = 0;
            bool same = true;
            ((same = equal(part<Parts>(type, place, at++), parts) && same), ...);
            if (same) return place;
        }
        return -1;
    }

private:
    struct Table {
        const std::int64_t* numbers = nullptr;
        std::uint32_t parts = 0, count = 0;
    };

    template <class Number>
    [[nodiscard]] static Number number(std::int64_t bits) noexcept {
        if constexpr (std::is_floating_point_v<Number>) {
            double value = 0.0;
            std::memcpy(&value, &bits, sizeof value);
            return static_cast<Number>(value);
        } else {
            return static_cast<Number>(bits);
        }
    }
    /// Compares numbers. A NaN is equal to every NaN.
    template <class Number>
    [[nodiscard]] static bool equal(Number a, Number b) noexcept {
        return a == b || (a != a && b != b);
    }

    Table table_[most_types] = {};
};

inline void add_number(Text& text, std::int64_t value) noexcept {
    text.add(value, 1);
}
/// Appends the shortest decimal that is read as the same number.
inline void add_number(Text& text, double value) noexcept {
    char digits[40];
    for (int precision = 1; precision <= 17; ++precision) {
        std::snprintf(digits, sizeof digits, "%.*g", precision, value);
        const double read = std::strtod(digits, nullptr);
        if (!(read < value) && !(read > value)) break;
    }
    text.add(digits);
}

namespace {
[[maybe_unused]] SetValues set_values;
}  // namespace

}  // namespace robochart

#endif
