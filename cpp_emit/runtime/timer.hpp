// Declares the timer of a clock, which counts the time since its reset, in time units. Delivered with the generated
// code. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_TIMER_HPP
#define ROBOCHART_TIMER_HPP

#include <cstdint>

namespace robochart {

/// A member of a machine's class. The control cycle advances the counter, and resets it when the model does. The
/// counter stops one unit above the largest value that the model compares it with.
class Timer {
public:
    std::uint32_t counter = 0;

    void StartTimer() noexcept { counter = 0; }
    void ResetTimer() noexcept { counter = 0; }
};

}  // namespace robochart

#endif
