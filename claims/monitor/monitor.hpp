// SPDX-License-Identifier: Apache-2.0
// Defines the meaning of claims (docs/claims.md, "Meaning") by a deterministic monitor. It observes the events of a
// component, the passing of time and the end, and stores the responses that are pending. All code that decides claims
// uses this monitor.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "claims/checks/checked.hpp"

namespace robochart::claims {

/// An event of the component with the values that it carries. The values may be left out if no condition reads them.
struct Occurrence {
    std::size_t channel = 0;
    std::vector<Fraction> values;

    friend auto operator<=>(const Occurrence&, const Occurrence&) = default;
};

/// The truth value of a fact of the claim, as a component shows it.
struct FactValue {
    std::size_t fact = 0;
    bool holds = false;

    friend auto operator<=>(const FactValue&, const FactValue&) = default;
};

enum class Verdict : std::uint8_t {
    open,  ///< not broken so far
    broken,
    satisfied,  ///< `possible E`: E has occurred
};

enum class Phase : std::uint8_t {
    outside,  ///< the scope has not begun, or has ended and may begin again
    inside,
    over,  ///< the scope has ended and cannot begin again
};

/// The state of a monitor during a run. After runs with equal states, the same continuations break the claim.
struct MonitorState {
    Verdict verdict = Verdict::open;
    Phase phase = Phase::outside;
    std::int64_t scope_left = 0;  ///< for_after: time units that the scope still lasts
    bool due = false;             ///< only_after: OTHERS has occurred; leads, leads_before: OTHERS is pending
    std::int64_t left = -1;       ///< remaining time units in which an event is pending, forbidden or allowed; -1: none
    std::int64_t count = 0;       ///< at_most: events in the scope
    std::vector<std::int64_t> ages;             ///< at_most in a duration: time since the last events, youngest first
    std::vector<std::optional<Fraction>> last;  ///< the last values of the remembered channels
    std::vector<std::optional<bool>> facts;     ///< the facts of the claim; no value: not known yet
    std::int64_t stay =
        -1;  ///< for_at_least, for_at_most: remaining time units that the stay must or may last; -1: none

    friend auto operator<=>(const MonitorState&, const MonitorState&) = default;
};

/// The monitor of a claim. Stores a reference to the claim.
class Monitor {
public:
    explicit Monitor(const CheckedClaim& claim) : claim_(claim) {}

    /// Returns the state at the beginning of a run.
    [[nodiscard]] MonitorState begin() const;
    /// Observes an event. Throws NotComputable if a condition cannot be computed.
    void observe(MonitorState& state, const Occurrence& event) const;
    /// Sorts the events that are raised at the beginning of a cycle into the order in which the monitor observes them.
    /// The events are simultaneous. Therefore, an event that ends a scope or is a response comes before an event that
    /// begins a scope or is a trigger.
    [[nodiscard]] std::vector<Occurrence> order_raised(const MonitorState& state, std::vector<Occurrence> raised) const;
    /// Observes the truth values of these facts. Must be called at the beginning, and whenever they may have changed,
    /// before the next event or time unit.
    void observe(MonitorState& state, const std::vector<FactValue>& values) const;
    /// Observes that one time unit passes.
    void tock(MonitorState& state) const;
    /// Observes that the component ends.
    void end(MonitorState& state) const;
    /// True if the claim demands an event that has not occurred yet. The claim is then broken if time stops here.
    [[nodiscard]] bool owes(const MonitorState& state) const;
    /// True if the event, or the change of a fact, is a response or an exception.
    [[nodiscard]] bool serves(const MonitorState& state, const Occurrence& event) const;
    [[nodiscard]] bool serves(const MonitorState& state, const std::vector<FactValue>& values) const;
    /// True if the claim is about states or variables and restricts them in this state.
    [[nodiscard]] bool judges_facts(const MonitorState& state) const;

    /// True if the event belongs to the set. Conditions of the set read the last values of this state.
    [[nodiscard]] static bool matches(const Events& events, const Occurrence& event, const MonitorState& state);

private:
    /// An event, or the beginning or the end of the run.
    struct Seen {
        const Occurrence* event = nullptr;
        Change change = Change::none;
        std::size_t fact = 0;
        bool start = false;
        bool terminate = false;
    };
    [[nodiscard]] static bool matches(const Events& events, const Seen& seen, const MonitorState& state);
    [[nodiscard]] static std::optional<Seen> change_of(const MonitorState& state, const FactValue& value);
    void observe(MonitorState& state, const Seen& seen) const;
    void enter(MonitorState& state) const;
    void leave(MonitorState& state, Phase phase) const;
    void observe_in_scope(MonitorState& state, const Seen& seen) const;
    void observe_response(MonitorState& state, const Seen& seen) const;
    void observe_delay(MonitorState& state, const Seen& seen) const;
    void count(MonitorState& state) const;
    void follow_condition(MonitorState& state, bool before, bool inside) const;
    void pass_in_scope(MonitorState& state) const;

    const CheckedClaim& claim_;
};

}  // namespace robochart::claims
