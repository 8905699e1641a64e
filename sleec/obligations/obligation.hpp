// What a trigger asks for, with all conditions decided: a disjunction of demands, each that an event comes in a window
// of time or that it does not. docs/rules-language.md, "What rules mean".
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "sleec/checks/checked.hpp"

namespace robochart::sleec {

/// A question that is not decided, and why.
class NotDecided : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What a response without limit means.
enum class WithoutLimit : std::uint8_t { eventually, now };

/// The end of a window that has none.
inline constexpr std::int64_t forever = std::numeric_limits<std::int64_t>::max();

/// The event comes at a second from `begin` to `end` behind the trigger, or it does not.
struct Demand {
    bool forbids = false;
    std::size_t event = 0;
    std::int64_t begin = 0;
    std::int64_t end = 0;  ///< inclusive
    const Response* written = nullptr;

    friend bool operator==(const Demand&, const Demand&) = default;
};

/// One demand is to be fulfilled, in whatever order they are written: those behind `otherwise` begin where the limit of
/// those before ends.
struct Obligation {
    std::vector<Demand> any;
    std::vector<std::size_t> ended_by;  ///< events that end it while it is open (`unless EVENT`)

    friend bool operator==(const Obligation&, const Obligation&) = default;
};

/// The obligation that a trigger with these values opens. Nothing: the condition is false, or no duty is left. Throws
/// NotDecided where a measure decides a limit.
[[nodiscard]] std::optional<Obligation> obligation_of(const CheckedRule& rule, const Valuation& values, WithoutLimit);
/// The same for a duty alone.
[[nodiscard]] std::optional<Obligation> obligation_of(const DutyPtr& duty, const Valuation& values, WithoutLimit);

/// Whether every history fulfils it: an event comes in a window, or it does not come in a part of it.
[[nodiscard]] bool always_fulfilled(const Obligation& obligation);
/// Whether every history that fulfils one, opened at some instant, fulfils the other, opened at the same instant.
/// Events are taken as independent: where the demanded event is the rule's own trigger, a "no" may be too careful.
[[nodiscard]] bool implies(const Obligation& stronger, const Obligation& weaker);

}  // namespace robochart::sleec
