// Describes the layout of a generated State as data: for printing, hashing, logs and tools. Delivered with the
// generated code; the controller does not need it. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_LAYOUT_HPP
#define ROBOCHART_LAYOUT_HPP

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace robochart {

/// How the bytes of a field are interpreted.
enum class FieldKind : std::uint8_t {
    boolean,
    enumeration,
    whole,     ///< two's complement, or unsigned
    real,      ///< float or double
    composed,  ///< a record, product, sequence, set, vector or matrix, or a carrier of the conformance check
    filler,    ///< always zero
};

/// A member of State or of a frame in it.
struct Field {
    const char* name;  ///< "T", "Turn.degree", "stm0.at"
    std::size_t offset;
    std::size_t size;
    FieldKind kind;
    std::int64_t low;  ///< for booleans, enumerations and whole numbers that fit: the least value of the type
    std::int64_t high;
};

namespace detail {

template <class T>
constexpr FieldKind kind_of() noexcept {
    if (std::is_same<T, bool>::value) return FieldKind::boolean;
    if (std::is_enum<T>::value) return FieldKind::enumeration;
    if (std::is_floating_point<T>::value) return FieldKind::real;
    return std::is_integral<T>::value ? FieldKind::whole : FieldKind::composed;
}

}  // namespace detail

/// Returns a row of the table. `values` is the number of values of an enumeration.
template <class T>
constexpr Field field(const char* name, std::size_t offset, std::int64_t values = 0) noexcept {
    Field row{name, offset, sizeof(T), detail::kind_of<T>(), 0, values - 1};
    if constexpr (std::is_integral<T>::value) {
        constexpr auto least = std::numeric_limits<T>::min();
        constexpr auto most = std::numeric_limits<T>::max();
        row.low = static_cast<std::int64_t>(least);
        row.high = sizeof(T) == 8 && std::is_unsigned<T>::value ? std::numeric_limits<std::int64_t>::max()
                                                                : static_cast<std::int64_t>(most);
    }
    return row;
}
constexpr Field filler(std::size_t offset, std::size_t size) noexcept {
    return Field{"", offset, size, FieldKind::filler, 0, 0};
}

/// Returns whether every byte of a state belongs to exactly one field, so that there is no padding.
template <std::size_t N>
constexpr bool covers(const Field (&fields)[N], std::size_t size) noexcept {
    std::size_t sum = 0;
    for (const Field& one : fields) {
        sum += one.size;
        if (one.offset + one.size > size) return false;
        for (const Field& other : fields)
            if (&one != &other && one.offset < other.offset + other.size && other.offset < one.offset + one.size)
                return false;
    }
    return sum == size;
}

/// Returns the value of a boolean, an enumeration or a whole number in a state.
inline std::int64_t whole_value(const Field& field, const void* state) noexcept {
    const auto* const at = static_cast<const unsigned char*>(state) + field.offset;
    std::uint64_t bits = 0;
    std::memcpy(&bits, at, field.size < sizeof bits ? field.size : sizeof bits);
    // The bytes above the value are filled with its sign.
    if (field.low < 0 && field.size < 8 && (bits >> (8 * field.size - 1)) != 0)
        bits |= ~std::uint64_t{0} << (8 * field.size);
    return static_cast<std::int64_t>(bits);
}
inline double real_value(const Field& field, const void* state) noexcept {
    const auto* const at = static_cast<const unsigned char*>(state) + field.offset;
    if (field.size == sizeof(float)) {
        float value = 0;
        std::memcpy(&value, at, sizeof value);
        return static_cast<double>(value);
    }
    double value = 0;
    std::memcpy(&value, at, sizeof value);
    return value;
}

/// Hashes the bytes of a state (FNV-1a). Equal states have equal bytes.
template <class State>
std::uint64_t hash(const State& state) noexcept {
    static_assert(std::is_trivially_copyable<State>::value, "a value");
    const auto* const bytes = reinterpret_cast<const unsigned char*>(&state);
    std::uint64_t result = 14695981039346656037ULL;
    for (std::size_t i = 0; i < sizeof(State); ++i) result = (result ^ bytes[i]) * 1099511628211ULL;
    return result;
}

}  // namespace robochart

#endif
