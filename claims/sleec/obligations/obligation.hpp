// SPDX-License-Identifier: Apache-2.0
// Defines the obligation that a trigger opens after all conditions are decided. It is a disjunction of demands that an
// event occurs, or does not occur, in a window of time (docs/rules-language.md, "What rules mean").
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "claims/sleec/checks/checked.hpp"

namespace robochart::sleec {

/// Thrown if a question is not decided; the message contains the reason.
class NotDecided : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The meaning of a response without limit.
enum class WithoutLimit : std::uint8_t { eventually, now };

/// The end of an unbounded window.
inline constexpr std::int64_t forever = std::numeric_limits<std::int64_t>::max();

/// The event occurs, or does not occur, at a second from `begin` to `end` after the trigger.
struct Demand {
    bool forbids = false;
    EventCases event;
    std::int64_t begin = 0;
    std::int64_t end = 0;  ///< inclusive
    const Response* written = nullptr;

    friend bool operator==(const Demand&, const Demand&) = default;
};

/// At least one demand must be fulfilled; their order does not matter. Demands after `otherwise` begin when the limit
/// of the earlier ones ends.
struct Obligation {
    std::vector<Demand> any;
    std::vector<std::size_t> ended_by;  ///< events that end it while it is open (`unless EVENT`)

    friend bool operator==(const Obligation&, const Obligation&) = default;
};

/// Returns the obligation that a trigger with these values opens. Returns no value if the condition is false or no duty
/// is left. Throws NotDecided if a measure determines a limit.
[[nodiscard]] std::optional<Obligation> obligation_of(const CheckedRule& rule, const Valuation& values, WithoutLimit);
/// Returns the obligation that a single duty opens.
[[nodiscard]] std::optional<Obligation> obligation_of(const DutyPtr& duty, const Valuation& values, WithoutLimit);

/// Returns true if every history fulfils the obligation: it demands that an event occurs in a window, or that the event
/// does not occur in a part of this window.
[[nodiscard]] bool always_fulfilled(const Obligation& obligation);
/// True if every history that fulfils `stronger`, opened at some instant, fulfils `weaker`, opened at the same instant.
/// Events are considered independent. So the answer may be false instead of true if the demanded event is the rule's
/// own trigger.
[[nodiscard]] bool implies(const Obligation& stronger, const Obligation& weaker);

}  // namespace robochart::sleec
