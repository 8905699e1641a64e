// Helpers of the generated exploration interface (explore_abi.h): values as numbers, states as text. Delivered with the
// generated code. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_EXPLORE_HPP
#define ROBOCHART_EXPLORE_HPP

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <type_traits>

#include "robochart/explore_abi.h"
#include "robochart/finite.hpp"
#include "robochart/runtime.hpp"

namespace robochart {

/// Returns whether an ascending list contains the value.
template <std::size_t size>
constexpr bool listed(const std::int64_t (&values)[size], std::int64_t value) noexcept {
    std::size_t low = 0;
    std::size_t high = size;
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (values[middle] < value) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low < size && values[low] == value;
}

template <class T>
constexpr std::int64_t to_raw(T value) noexcept {
    if constexpr (std::is_enum_v<T> || std::is_same_v<T, bool>) {
        return static_cast<std::int64_t>(value);
    } else {
        return value.raw();
    }
}

/// Returns the number of a composed value: its index in the list of all values, or -1 if it is not in the list.
template <class T, std::size_t size>
constexpr std::int64_t place_in(const T (&values)[size], const T& value) noexcept {
    for (std::size_t i = 0; i < size; ++i)
        if (values[i] == value) return static_cast<std::int64_t>(i);
    return -1;
}

template <class T>
constexpr T from_raw(std::int64_t raw) noexcept {
    if constexpr (std::is_same_v<T, bool>) {
        return raw != 0;
    } else if constexpr (std::is_enum_v<T>) {
        return static_cast<T>(raw);
    } else {
        return T::from_raw(raw);
    }
}

inline rc_result to_abi(StepResult result) noexcept {
    switch (result) {
        case StepResult::terminated:
            return RC_TERMINATED;
        case StepResult::step_bound:
            return RC_STEP_BOUND;
        case StepResult::precondition:
            return RC_PRECONDITION;
        case StepResult::deadline:
            return RC_DEADLINE;
        case StepResult::capacity:  // impossible: the carriers bound the lists
        case StepResult::quiescent:
            break;
    }
    return RC_QUIESCENT;
}

/// Clears outputs and questions, but not the given answers.
inline void clear(rc_log& log) noexcept {
    log.count = 0;
    log.overflow = 0;
    log.asked = 0;
}

/// Appends a record. If the log is full, only the overflow is noted.
template <class... Values>
void write_record(rc_log& log, std::uint32_t output, Values... values) noexcept {
    static_assert(sizeof...(Values) <= ROBOCHART_MAX_ARGUMENTS);
    if (log.count == log.capacity) {
        log.overflow |= ROBOCHART_OVERFLOW_RECORDS;
        return;
    }
    rc_record record{};
    record.output = output;
    ((record.argument[record.count++] = values), ...);
    log.record[log.count++] = record;
}

/// Returns the alternative that the explorer has chosen. If the log is full, only the overflow is noted.
inline std::size_t recorded_way(rc_log& log, std::size_t count) noexcept {
    if (log.asked == ROBOCHART_MAX_CHOICES) {
        log.overflow |= ROBOCHART_OVERFLOW_CHOICES;
        return 0;
    }
    const std::uint32_t place = log.asked++;
    log.ways[place] = static_cast<std::uint32_t>(count);
    return place < log.given ? log.choice[place] : 0;
}

/// Text in a buffer of fixed size, truncated at its end.
class Text {
public:
    Text(char* buffer, std::size_t size) noexcept : buffer_(buffer), size_(size) {
        if (size_ > 0) buffer_[0] = '\0';
    }
    void add(const char* text) noexcept {
        for (; *text != '\0' && used_ + 1 < size_; ++text) buffer_[used_++] = *text;
        if (size_ > 0) buffer_[used_] = '\0';
    }
    void add(std::int64_t number, std::int64_t scale) noexcept {
        char digits[64];
        const long long whole = static_cast<long long>(number / scale);
        const long long rest = static_cast<long long>(number % scale);
        std::snprintf(digits, sizeof digits, "%s%lld", number < 0 && whole == 0 ? "-" : "", whole);
        add(digits);
        if (rest == 0) return;
        std::snprintf(digits, sizeof digits, "%lld", static_cast<long long>(scale) + (rest < 0 ? -rest : rest));
        digits[0] = '.';
        for (std::size_t end = 0; digits[end] != '\0'; ++end) last_ = end;
        while (digits[last_] == '0') digits[last_--] = '\0';
        add(digits);
    }
    /// Appends `prefix` and `name`, followed by `=`. A blank separates items.
    void item(const char* prefix, const char* name) noexcept {
        if (used_ > 0) add(" ");
        add(prefix);
        add(name);
        add("=");
    }

private:
    char* buffer_;
    std::size_t size_;
    std::size_t used_ = 0;
    std::size_t last_ = 0;
};

}  // namespace robochart

#endif
