// Declares the common parts of all generated controllers: results, input registers, the types of deployment, time. They
// use no heap, no exceptions and no statics. Delivered with the generated code. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_RUNTIME_HPP
#define ROBOCHART_RUNTIME_HPP

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#ifdef ROBOCHART_PROBES
#include "robochart/probes.hpp"
#endif

/// What happens if a precondition of an operation is violated. Define the macro before including generated code to
/// change it.
#ifndef RC_REQUIRE
#include <cassert>
#define RC_REQUIRE(condition) assert(condition)
#endif

/// Used in generated code; reports to RC_REQUIRE. If the condition is false, `violated()` is true afterwards, and the
/// cycle ends there with StepResult::precondition.
#define ROBOCHART_PRECONDITION(...) \
    do {                            \
        RC_REQUIRE((__VA_ARGS__));  \
        this->require(__VA_ARGS__); \
    } while (false)

/// These macros enclose code computed from the model. They disable warnings about comparisons that are always true or
/// always false, and about variables that are assigned to themselves, because such code comes from the model.
#if defined(__clang__)
#define ROBOCHART_MODEL_BEGIN                                       \
    _Pragma("clang diagnostic push")                                \
    _Pragma("clang diagnostic ignored \"-Wunknown-warning-option\"") \
    _Pragma("clang diagnostic ignored \"-Wtautological-compare\"")   \
    _Pragma("clang diagnostic ignored \"-Wtype-limits\"")            \
    _Pragma("clang diagnostic ignored \"-Wself-assign\"")
#define ROBOCHART_MODEL_END _Pragma("clang diagnostic pop")
#elif defined(__GNUC__)
#define ROBOCHART_MODEL_BEGIN                                     \
    _Pragma("GCC diagnostic push")                                \
    _Pragma("GCC diagnostic ignored \"-Wpragmas\"")                \
    _Pragma("GCC diagnostic ignored \"-Wtautological-compare\"")   \
    _Pragma("GCC diagnostic ignored \"-Wbool-compare\"")           \
    _Pragma("GCC diagnostic ignored \"-Wtype-limits\"")
#define ROBOCHART_MODEL_END _Pragma("GCC diagnostic pop")
#else
#define ROBOCHART_MODEL_BEGIN
#define ROBOCHART_MODEL_END
#endif

/// If 1, the generated classes report what they do to a tracer (robochart/trace.hpp). The macro must have the same
/// value wherever the headers of the classes are included.
#ifndef ROBOCHART_TRACE
#define ROBOCHART_TRACE 0
#endif

/// Marks code that runs once, so that compilers place other code first.
#if __cplusplus >= 202002L || (defined(__GNUC__) && !defined(__clang__))
#define ROBOCHART_UNLIKELY [[unlikely]]
#else
#define ROBOCHART_UNLIKELY
#endif

namespace robochart {

/// How a control cycle ended.
enum class StepResult : std::uint8_t {
    quiescent,     ///< nothing more can happen before time passes or an input arrives
    terminated,    ///< the final node has been reached
    step_bound,    ///< a loop that takes no time: the model diverges
    precondition,  ///< an operation was called outside its precondition
    deadline,      ///< a deadline was missed
    capacity,      ///< a list had more items than its capacity: an input, and then nothing happened, or a computed list
};

#ifndef ROBOCHART_PROBES
/// An input without a value, which is raised or not.
struct Signal {
    bool present = false;
};

/// An input with a value.
template <class T>
struct Message {
    bool present = false;
    T value{};

    [[nodiscard]] constexpr const T& get() const noexcept { return value; }
};
#endif

/// Returns the value in an input register, or `empty` if the register is empty.
template <class Input, class T>
[[nodiscard]] constexpr T content(const Input& input, const T& empty) noexcept {
    return input.present ? T(input.get()) : empty;
}

/// A one-place buffer between controllers. The writer overwrites it, and the reader empties it. `mark` is as wide as
/// the value, so that there is no padding.
template <class T>
struct Buffer {
    T value{};
    std::conditional_t<(alignof(T) > 1), std::uint64_t, std::uint8_t> mark = 0;

    [[nodiscard]] constexpr bool full() const noexcept { return mark != 0; }
    constexpr void fill(T newest) noexcept {
        value = newest;
        mark = 1;
    }
    friend constexpr bool operator==(const Buffer& a, const Buffer& b) noexcept {
        return a.mark == b.mark && a.value == b.value;
    }
};

/// A buffer for an event without a value.
struct Flag {
    std::uint8_t mark = 0;

    [[nodiscard]] constexpr bool full() const noexcept { return mark != 0; }
    constexpr void fill() noexcept { mark = 1; }
    friend constexpr bool operator==(Flag a, Flag b) noexcept { return a.mark == b.mark; }
};

/// A variable that no later cycle reads.
template <class T>
struct Local {
    T value{};
    bool written = false;  ///< whether this cycle has written it

    constexpr void write(const T& newest) noexcept {
        value = newest;
        written = true;
    }
};

/// Tells whether values of the type contain lists, and whether these have overflowed.
template <class T, class = void>
struct HoldsLists : std::false_type {
    static constexpr bool overflowed(const T&) noexcept { return false; }
    static constexpr bool drop(T&) noexcept { return false; }
};
template <class T>
struct HoldsLists<T, std::void_t<decltype(std::declval<const T&>().overflowed())>> : std::true_type {
    static constexpr bool overflowed(const T& value) noexcept { return value.overflowed(); }
    static constexpr bool drop(T& value) noexcept { return value.drop_overflow(); }
};

/// Returns whether a list in the value was given more items than its capacity.
template <class T>
[[nodiscard]] constexpr bool overflowed(const T& value) noexcept {
    return HoldsLists<T>::overflowed(value);
}
/// Resets the overflow of the lists in the value, which keep the items that fit. Returns whether a list had overflowed.
template <class T>
constexpr bool drop_overflow(T& value) noexcept {
    return HoldsLists<T>::drop(value);
}

/// The model's basic types on the robot.
struct Deployment {
    using Real = double;
    using Nat = std::int64_t;
    using Int = std::int64_t;
    /// The usual capacity of sequences, and of sets of numbers, in items.
    static constexpr std::size_t longest = 64;
};

/// Whether the types are the finite carriers of the conformance check, which have `static constexpr bool finite`.
template <class Types, class = void>
struct HasCarriers : std::false_type {};
template <class Types>
struct HasCarriers<Types, std::enable_if_t<Types::finite>> : std::true_type {};

/// Returns the capacity of a list for which `emit cpp --capacity` gives one. Over finite carriers all lists have the
/// same capacity.
template <class Types>
constexpr std::size_t capacity(std::size_t given) noexcept {
    if constexpr (HasCarriers<Types>::value) {
        return Types::longest;
    } else {
        return given;
    }
}
/// Returns the capacity of lists of lists. It is smaller, because their sizes multiply.
template <class Types>
constexpr std::size_t outer_capacity() noexcept {
    return capacity<Types>(Types::longest < 16 ? Types::longest : 16);
}

/// Returns a real as a whole number, rounded down. Returns the nearest number of the type if the result is out of
/// range, and 0 for NaN.
template <class Whole>
constexpr Whole rounded_down(double value) noexcept {
    constexpr Whole least = std::numeric_limits<Whole>::min();
    constexpr Whole greatest = std::numeric_limits<Whole>::max();
    if (value != value) return Whole{0};
    if (value <= static_cast<double>(least)) return least;
    if (value >= static_cast<double>(greatest)) return greatest;
    const auto cut = static_cast<Whole>(value);
    return static_cast<double>(cut) > value ? static_cast<Whole>(cut - 1) : cut;
}
constexpr std::int64_t place_of(std::int64_t index) noexcept {
    return index;
}

template <class T>
using IfWhole = std::enable_if_t<std::is_integral_v<T>, int>;
template <class T>
using IfFloating = std::enable_if_t<std::is_floating_point_v<T>, int>;

/// The following functions are the arithmetic of whole numbers in the model's semantics. If the type cannot represent a
/// result, the result is the first operand. So a counter at its limit keeps its value, and no operation is undefined.
template <class T, IfWhole<T> = 0>
constexpr T plus(T a, T b) noexcept {
    using Limits = std::numeric_limits<T>;
    return (b > 0 ? a > Limits::max() - b : a < Limits::min() - b) ? a : static_cast<T>(a + b);
}
template <class T, IfWhole<T> = 0>
constexpr T minus(T a, T b) noexcept {
    using Limits = std::numeric_limits<T>;
    return (b > 0 ? a < Limits::min() + b : a > Limits::max() + b) ? a : static_cast<T>(a - b);
}
template <class T, IfWhole<T> = 0>
constexpr T times(T a, T b) noexcept {
    using Limits = std::numeric_limits<T>;
    // Quotients are truncated, so they are the exact bounds of the other factor. The least number is never divided by
    // -1.
    bool fits = true;
    if (a > 0) fits = b > 0 ? a <= Limits::max() / b : b >= Limits::min() / a;
    if (a < 0) fits = b > 0 ? a >= Limits::min() / b : b >= Limits::max() / a;
    return fits ? static_cast<T>(a * b) : a;
}
template <class T, IfWhole<T> = 0>
constexpr T negative(T a) noexcept {
    return a == std::numeric_limits<T>::min() ? a : static_cast<T>(-a);
}
/// For reals, the same names are used, so that vectors and matrices can compute with entries of all types.
template <class T, IfFloating<T> = 0>
constexpr T plus(T a, T b) noexcept {
    return a + b;
}
template <class T, IfFloating<T> = 0>
constexpr T minus(T a, T b) noexcept {
    return a - b;
}
template <class T, IfFloating<T> = 0>
constexpr T times(T a, T b) noexcept {
    return a * b;
}
template <class T, IfFloating<T> = 0>
constexpr T negative(T a) noexcept {
    return -a;
}

/// Division and remainder in the model's semantics. Division by zero is division by one, and for whole numbers the
/// quotient is rounded down. The least number divided by -1 has no quotient in the type, so the result is the least
/// number; its remainder is 0.
template <class T, IfFloating<T> = 0>
constexpr T divide(T a, T b) noexcept {
    return a / (b < 0 || b > 0 ? b : T{1});
}
template <class T, IfWhole<T> = 0>
constexpr T divide(T a, T b) noexcept {
    if (b == 0) return a;
    if (b == -1) return negative(a);
    const T quotient = static_cast<T>(a / b);
    return a % b != 0 && (a < 0) != (b < 0) ? static_cast<T>(quotient - 1) : quotient;
}
template <class T, IfWhole<T> = 0>
constexpr T modulus(T a, T b) noexcept {
    if (b == 0 || b == -1) return T{0};
    const T rest = static_cast<T>(a % b);
    return rest != 0 && (rest < 0) != (b < 0) ? static_cast<T>(rest + b) : rest;
}

/// Returns the condition itself.
constexpr bool holds(bool condition) noexcept {
    return condition;
}

/// Returns a duration in time units. Negative numbers give zero.
constexpr std::uint32_t duration(std::int64_t units) noexcept {
    if (units < 0) return 0;
    return units > INT32_MAX ? static_cast<std::uint32_t>(INT32_MAX) : static_cast<std::uint32_t>(units);
}

/// Returns the probability of an alternative as a number.
template <class Number>
constexpr double chance(Number probability) noexcept {
    return static_cast<double>(probability);
}

/// Returns the default alternative of a probabilistic junction: the first one with a positive probability.
constexpr std::size_t first_way(const double* chances, std::size_t count) noexcept {
    for (std::size_t way = 0; way < count; ++way)
        if (chances[way] > 0.0) return way;
    return 0;
}

/// Draws alternatives of probabilistic junctions with SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom
/// number generators, OOPSLA 2014). The same seed draws the same alternatives on every platform. A copy continues
/// identically.
class Draws {
public:
    constexpr explicit Draws(std::uint64_t seed = 1) noexcept : state_(seed) {}

    /// Draws an alternative with a probability proportional to its chance. An alternative with chance zero is never
    /// drawn. If all chances are zero, returns the first alternative.
    constexpr std::size_t way(const double* chances, std::size_t count) noexcept {
        double all = 0.0;
        for (std::size_t way = 0; way < count; ++way)
            if (chances[way] > 0.0) all += chances[way];
        double left = uniform() * all;
        std::size_t last = 0;
        for (std::size_t way = 0; way < count; ++way) {
            if (!(chances[way] > 0.0)) continue;
            if (left < chances[way]) return way;
            left -= chances[way];
            last = way;
        }
        return last;
    }

private:
    /// Draws a multiple of 2^-53 in [0, 1).
    constexpr double uniform() noexcept {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1.0p-53;
    }

    std::uint64_t state_;
};

template <class Controller, class = void>
struct Seeded : std::false_type {};
template <class Controller>
struct Seeded<Controller, std::void_t<decltype(std::declval<Controller&>().SetSeed(std::uint64_t{}))>>
    : std::true_type {};

/// Sets the seed of a controller's random choices, if it has any.
template <class Controller>
void set_seed([[maybe_unused]] Controller& controller, [[maybe_unused]] std::uint64_t seed) noexcept {
    if constexpr (Seeded<Controller>::value) controller.SetSeed(seed);
}

template <class Platform, class = void>
struct Chooses : std::false_type {};
template <class Platform>
struct Chooses<Platform, std::void_t<decltype(std::declval<Platform&>().choose(static_cast<const double*>(nullptr),
                                                                               std::size_t{}))>> : std::true_type {};

/// Returns the alternative that a probabilistic junction takes. This is `platform.choose(chances, count)` if there is
/// such a method, which may use random numbers; otherwise the first alternative with a positive probability. The model
/// allows any alternative.
template <class Platform, std::size_t count>
constexpr std::size_t choose([[maybe_unused]] Platform& platform, const double (&chances)[count]) noexcept {
    std::size_t way = 0;
    if constexpr (Chooses<Platform>::value) {
        way = platform.choose(static_cast<const double*>(chances), count);
    } else {
        way = first_way(chances, count);
    }
    return way < count ? way : count - 1;
}

template <class Platform, class = void>
struct Picks : std::false_type {};
template <class Platform>
struct Picks<Platform, std::void_t<decltype(std::declval<Platform&>().pick(std::size_t{}))>> : std::true_type {};

/// Returns the alternative that is taken in code that asks (`emit cpp --choices`). This is `platform.pick(count)` if
/// there is such a method, otherwise the first alternative. The model allows any answer.
template <class Platform>
constexpr std::size_t pick([[maybe_unused]] Platform& platform, std::size_t count) noexcept {
    if constexpr (Picks<Platform>::value) {
        if (count < 2) return 0;
        const std::size_t picked = platform.pick(count);
        return picked < count ? picked : count - 1;
    } else {
        return 0;
    }
}

/// Picks one of the open alternatives. Returns `count` if none is open.
template <class Platform, std::size_t count>
constexpr std::size_t pick_open(Platform& platform, const bool (&open)[count]) noexcept {
    std::size_t all = 0;
    for (const bool each : open) all += each ? 1U : 0U;
    std::size_t left = all == 0 ? 0 : pick(platform, all);
    for (std::size_t way = 0; way < count; ++way)
        if (open[way] && left-- == 0) return way;
    return count;
}

template <class Platform>
constexpr std::uint32_t pick_between(Platform& platform, std::uint32_t least, std::uint32_t most) noexcept {
    return most <= least ? least : least + static_cast<std::uint32_t>(pick(platform, std::size_t{most} - least + 1));
}

/// Visits the enabled transitions twice: first to count them, then to take the picked one.
class Turn {
public:
    constexpr void count() noexcept { *this = Turn(); }
    [[nodiscard]] constexpr std::size_t counted() const noexcept { return seen_; }
    constexpr void take(std::size_t picked) noexcept {
        wanted_ = picked;
        seen_ = 0;
        counting_ = false;
    }
    constexpr bool come() noexcept { return seen_++ == wanted_ && !counting_; }

private:
    std::size_t seen_ = 0;
    std::size_t wanted_ = 0;
    bool counting_ = true;
};

/// Recorded answers, for platforms that repeat a run. After the last answer, the first alternative is taken.
class RecordedChoices {
public:
    constexpr RecordedChoices(const std::size_t* answers, std::size_t count) noexcept
        : answers_(answers), left_(count) {}
    constexpr std::size_t next() noexcept {
        if (left_ == 0) return 0;
        --left_;
        return *answers_++;
    }

private:
    const std::size_t* answers_;
    std::size_t left_;
};

template <class Platform, class = void>
struct Listens : std::false_type {};
template <class Platform>
struct Listens<Platform, std::void_t<decltype(std::declval<Platform&>().taken(std::uint32_t{}))>> : std::true_type {};

/// Advances a clock, up to its saturation. Guards cannot distinguish values above the saturation.
constexpr void advance_clock(std::uint32_t& clock, std::uint32_t units, std::uint32_t saturation) noexcept {
    if (clock >= saturation) return;
    const std::uint32_t left = saturation - clock;
    clock += units < left ? units : left;
}

/// Decreases the remaining time of a wait.
constexpr void advance_wait(std::uint32_t& left, std::uint32_t units) noexcept {
    left = units < left ? left - units : 0;
}

#ifdef ROBOCHART_PROBES
inline namespace probed {
#endif

/// Counts the steps of one cycle, and records violations.
class Cycle {
public:
    explicit constexpr Cycle(std::uint32_t bound) noexcept : budget_(bound) {}

    /// Uses one step of the machine. Returns false when the bound of the cycle is reached.
    constexpr bool spend() noexcept {
        if (budget_ == 0) return false;
        --budget_;
        return true;
    }
    /// Decreases the remaining time of a deadline, which is stored plus one (0 if no deadline runs).
    constexpr void advance_deadline(std::uint32_t& left, std::uint32_t units) noexcept {
        if (left == 0) return;
        late_ = late_ || left <= units;
        left = left > units ? left - units : 1;
    }
    /// Records that time was due to pass before an urgent action was performed.
    constexpr void stop_time() noexcept { late_ = true; }
    [[nodiscard]] constexpr bool late() const noexcept { return late_; }
    /// Records a violation if the precondition is false. Also uses up the steps of the cycle, so that no other machine
    /// continues.
    constexpr void require(bool precondition) noexcept {
        if (precondition) return;
        violated_ = true;
        budget_ = 0;
    }
    [[nodiscard]] constexpr bool violated() const noexcept { return violated_; }
    /// Returns a list that the code has built, without the items beyond its capacity. If there were any, the cycle ends
    /// with StepResult::capacity, unless the lists are bounded by finite carriers.
    template <class Types, class T>
    [[nodiscard]] constexpr T fit(T value) noexcept {
        if (drop_overflow(value) && !HasCarriers<Types>::value) {
            overflowed_ = true;
            budget_ = 0;
        }
        return value;
    }
    /// Returns whether every list that this cycle has built fits.
    [[nodiscard]] constexpr bool lists_fit() const noexcept { return !overflowed_; }
    [[nodiscard]] constexpr bool exhausted() const noexcept { return budget_ == 0; }
    /// Returns whether another round of transitions may begin. Only this object and the state are kept between rounds.
    [[nodiscard]] bool next_round() noexcept {
#ifdef ROBOCHART_PROBES
        const std::uint32_t left = budget_;
        budget_ = 0;  // rounds are compared without their number
        report_round(left);
        budget_ = left;
#endif
        return budget_ != 0;
    }
    [[nodiscard]] constexpr StepResult result(bool terminated) const noexcept {
        if (overflowed_) return StepResult::capacity;
        if (violated_) return StepResult::precondition;
        if (budget_ == 0) return StepResult::step_bound;
        return terminated ? StepResult::terminated : StepResult::quiescent;
    }

private:
    std::uint32_t budget_;
    bool violated_ = false;
    bool overflowed_ = false;
    bool late_ = false;
};

#ifdef ROBOCHART_PROBES
}  // namespace probed
#endif

}  // namespace robochart

#endif
