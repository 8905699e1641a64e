// The trace hook of generated controllers: what happens in a cycle, as the words of a log (docs/traces.md), and which
// transitions are taken. Included where it is used only. Ships with the generated code. Copyright: see LICENSE
// (Apache-2.0).
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

/// What a log begins with.
struct RunHeader {
    const char* component;
    const char* model;           ///< file
    std::uint32_t cycle_length;  ///< time units of a control cycle
    const char* unobserved;      ///< inputs and outputs whose values have no words, "pose? path!"
    const TransitionName* transitions;
    std::size_t transition_count;
};

/// Is told of everything.
class Tracer {
public:
    virtual ~Tracer() = default;
    /// The controller begins anew.
    virtual void begin() noexcept {}
    /// The next piece of the log.
    virtual void text(const char* piece) noexcept = 0;
    /// A transition was taken: its place in RunHeader::transitions.
    virtual void taken(std::uint32_t /*transition*/) noexcept {}
    /// The cycle is over, and so is its line of the log.
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

/// The shortest decimal that is read as the same number.
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

/// How the cycle ended, in the words of the log.
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

/// Which way the platform takes, for one that stands before it.
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
