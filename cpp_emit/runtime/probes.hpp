// Declares inputs that notice when the code reads them. With them, the exploration need not try the values of a
// register that a cycle does not read. They replace Signal and Message of runtime.hpp if ROBOCHART_PROBES is defined.
// They have their own namespace, so that other sources of the same program keep theirs. Delivered with the generated
// code. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_PROBES_HPP
#define ROBOCHART_PROBES_HPP

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "robochart/explore_abi.h"

namespace robochart {
inline namespace probed {

/// The cycle in progress, and the bytes on which the rest of it depends.
struct Probing {
    const rc_probe* probe = nullptr;
    const void* step = nullptr;
    std::size_t step_size = 0;
    const void* state = nullptr;
};

namespace {
/// Null while registers are read before the cycle.
[[maybe_unused]] thread_local const Probing* probing = nullptr;
}  // namespace

/// Reports the beginning of a round of transitions.
inline void report_round(std::uint32_t steps_left) noexcept {
    if (probing == nullptr) return;
    const rc_probe& probe = *probing->probe;
    probe.round(probe.context, probing->step, static_cast<std::uint32_t>(probing->step_size), probing->state,
                steps_left);
}

/// Whether an input is present: a boolean, or the contents of the register with this number. The register is read when
/// the code asks.
class Presence {
public:
    constexpr Presence() noexcept = default;
    constexpr Presence(bool present) noexcept : known_(present ? here : absent) {}
    [[nodiscard]] static constexpr Presence in_register(std::uint16_t number) noexcept {
        Presence unread;
        unread.number_ = number;
        unread.known_ = unread_yet;
        return unread;
    }
    constexpr Presence(const Presence&) noexcept = default;
    constexpr Presence& operator=(const Presence&) noexcept = default;
    Presence& operator=(bool present) noexcept {
        if (probing != nullptr) probing->probe->assigned(probing->probe->context, number_);
        known_ = present ? here : absent;
        return *this;
    }
    operator bool() noexcept {
        if (known_ == unread_yet) known_ = read() != 0 ? here : absent;
        return known_ == here;
    }
    operator bool() const noexcept { return known_ == unread_yet ? read() != 0 : known_ == here; }

private:
    enum : std::uint16_t { absent, here, unread_yet };

    [[nodiscard]] std::uint32_t read() const noexcept { return probing->probe->read(probing->probe->context, number_); }

    std::uint16_t number_ = 0;
    std::uint16_t known_ = absent;
};

/// The value of an input: a value, or the contents of the register with this number. The register is read when the code
/// asks.
template <class T>
class Content {
public:
    using Values = T (*)(std::uint32_t index) noexcept;

    constexpr Content() noexcept = default;
    /// Copies member by member, because bytes between the members are compared too and must not change.
    constexpr Content(const Content& other) noexcept
        : own_(other.own_), values_(other.values_), number_(other.number_) {}
    constexpr Content& operator=(const Content& other) noexcept {
        own_ = other.own_;
        values_ = other.values_;
        number_ = other.number_;
        return *this;
    }
    [[nodiscard]] static constexpr Content in_register(std::uint16_t number, Values values) noexcept {
        Content unread;
        unread.number_ = number;
        unread.values_ = values;
        return unread;
    }
    constexpr Content& operator=(const T& value) noexcept {
        own_ = value;
        values_ = nullptr;
        return *this;
    }
    [[nodiscard]] T get() const noexcept {
        if (values_ == nullptr) return own_;
        return values_(probing->probe->value(probing->probe->context, static_cast<std::uint32_t>(number_)));
    }

private:
    T own_{};
    Values values_ = nullptr;
    std::uint64_t number_ = 0;
};

/// An input without a value.
struct Signal {
    Presence present{};
};

/// An input with a value.
template <class T>
struct Message {
    Presence present{};
    Content<T> value{};

    [[nodiscard]] T get() const noexcept { return value.get(); }
};

}  // namespace probed
}  // namespace robochart

#endif
