// Declares the trace hook of generated controllers, which receives the events of a cycle as text of a log
// (docs/traces.md), and the transitions taken. Included only by code that uses it. Delivered with the generated code.
// Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_TRACE_HPP
#define ROBOCHART_TRACE_HPP

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "robochart/runtime.hpp"

namespace robochart {

/// A transition of the model.
struct TransitionName {
    const char* element;  ///< "Door::t1"
    const char* place;    ///< file and line
};

/// The header of a log.
struct RunHeader {
    const char* component;
    const char* model;           ///< file name
    const char* constants;       ///< lines `const NAME=VALUE`, for constants whose values the model does not give
    std::uint32_t cycle_length;  ///< number of time units in a control cycle
    const TransitionName* transitions;
    std::size_t transition_count;
};

/// Receives all reports.
class Tracer {
public:
    virtual ~Tracer() = default;
    /// Called when the controller restarts.
    virtual void begin() noexcept {}
    /// Receives the next piece of text for the log.
    virtual void text(const char* piece) noexcept = 0;
    /// Called when a transition is taken, with its index in RunHeader::transitions.
    virtual void taken(std::uint32_t /*transition*/) noexcept {}
    /// Called at the end of a cycle, which is also the end of its line in the log.
    virtual void end() noexcept {}
};

inline void log_value(Tracer& tracer, bool value) noexcept {
    tracer.text(value ? "true" : "false");
}

inline void log_value(Tracer& tracer, std::int64_t value) noexcept {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%lld", static_cast<long long>(value));
    tracer.text(digits);
}
inline void log_value(Tracer& tracer, std::int32_t value) noexcept {
    log_value(tracer, static_cast<std::int64_t>(value));
}

/// Writes the shortest decimal that is read as the same number.
inline void log_value(Tracer& tracer, double value) noexcept {
    char digits[40];
    for (int precision = 1; precision <= 17; ++precision) {
        std::snprintf(digits, sizeof digits, "%.*g", precision, value);
        const double read = std::strtod(digits, nullptr);
        if (!(read < value) && !(read > value)) break;
    }
    tracer.text(digits);
}
inline void log_value(Tracer& tracer, float value) noexcept {
    log_value(tracer, static_cast<double>(value));
}

// The following functions write values with parts, as in CSP but without blanks, because blanks separate the words of a
// log: <1,2>, {1,2}, (1,2). Their types are declared in the headers that are delivered with models that use them.
template <class T, std::size_t capacity>
class Sequence;
template <class T, std::size_t capacity>
class Set;
template <class T, std::size_t length>
struct Vector;
template <class T, std::size_t height, std::size_t width>
struct Matrix;
template <class A, class B, int shape>
struct Pair;
template <std::size_t longest>
class String;

/// Writes the parts of a value, each with the overload for its type. Several parts are enclosed in `open` and `close`.
template <class T>
void log_parts(Tracer& tracer, const T* part, std::size_t count, const char* open, const char* close) noexcept {
    tracer.text(open);
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) tracer.text(",");
        log_value(tracer, part[i]);
    }
    tracer.text(close);
}

template <class T, std::size_t capacity>
void log_value(Tracer& tracer, const Sequence<T, capacity>& value) noexcept {
    log_parts(tracer, value.begin(), value.size(), "<", ">");
}
template <class T, std::size_t capacity>
void log_value(Tracer& tracer, const Set<T, capacity>& value) noexcept {
    log_parts(tracer, value.begin(), value.size(), "{", "}");
}
template <class T, std::size_t length>
void log_value(Tracer& tracer, const Vector<T, length>& value) noexcept {
    log_parts(tracer, value.data(), length, length > 1 ? "(" : "", length > 1 ? ")" : "");
}
template <class T, std::size_t height, std::size_t width>
void log_value(Tracer& tracer, const Matrix<T, height, width>& value) noexcept {
    if (height > 1) tracer.text("(");
    for (std::size_t row = 0; row < height; ++row) {
        if (row > 0) tracer.text(",");
        log_parts(tracer, value.data() + row * width, width, width > 1 ? "(" : "", width > 1 ? ")" : "");
    }
    if (height > 1) tracer.text(")");
}
template <class A, class B, int shape>
void log_value(Tracer& tracer, const Pair<A, B, shape>& value) noexcept {
    tracer.text("(");
    log_value(tracer, value.item_1);
    tracer.text(",");
    log_value(tracer, value.item_2);
    tracer.text(")");
}

/// Writes a text. Characters that separate words, and invisible ones, are written as octal numbers.
template <std::size_t longest>
void log_value(Tracer& tracer, const String<longest>& value) noexcept {
    tracer.text("\"");
    for (const char* at = value.c_str(); *at != '\0'; ++at) {
        const auto code = static_cast<unsigned char>(*at);
        bool plain = code > 0x20U && code != 0x7fU;
        for (const char* special = "\"\\!?/"; *special != '\0'; ++special) plain = plain && *at != *special;
        char piece[8] = {*at};
        if (!plain) std::snprintf(piece, sizeof piece, "\\%03o", static_cast<unsigned>(code));
        tracer.text(piece);
    }
    tracer.text("\"");
}

/// Writes how the cycle ended, as in logs.
inline void log_end(Tracer& tracer, StepResult result, std::uint32_t cycle_length) noexcept {
    if (result == StepResult::terminated) {
        tracer.text("terminate");
    } else if (result == StepResult::quiescent) {
        for (std::uint32_t unit = 0; unit < cycle_length; ++unit) tracer.text(unit == 0 ? "tock" : " tock");
    } else {
        tracer.text("// the controller stopped here");
    }
    tracer.text("\n");
    tracer.end();
}

/// Returns the alternative that the platform takes, for a platform that forwards its calls.
template <class Platform>
std::size_t passed_choice(Platform& platform, const double* chances, std::size_t count) noexcept {
    if constexpr (Chooses<Platform>::value) {
        return platform.choose(chances, count);
    } else {
        return first_way(chances, count);
    }
}

template <class Platform>
std::size_t passed_pick([[maybe_unused]] Platform& platform, [[maybe_unused]] std::size_t count) noexcept {
    return pick(platform, count);
}

}  // namespace robochart

#endif
