// SPDX-License-Identifier: Apache-2.0
// Explains why a run breaks a claim: which event began the scope or was the trigger, what the claim demands, and what
// broke the claim (docs/claims.md, "Answers").
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/durations/time_unit.hpp"
#include "claims/monitor/monitor.hpp"

namespace robochart::claims {

/// Follows a run of a component along with the monitor. Stores a reference to the claim.
class Account {
public:
    Account(const CheckedClaim& claim, durations::Unit unit);

    /// Observes an event. `text` is its readable form, such as "goTo(3)".
    void observe(const Occurrence& event, const std::string& text);
    /// Observes that a machine shows these facts.
    void observe(const std::vector<FactValue>& values);
    void tock();
    void end();

    [[nodiscard]] const MonitorState& state() const { return state_; }
    [[nodiscard]] bool is_broken() const { return state_.verdict == Verdict::broken; }
    /// Returns at most three sentences that explain how the claim was broken.
    [[nodiscard]] std::vector<std::string> reasons() const;
    /// Returns the sentences for the case that time stops here while a response is pending.
    [[nodiscard]] std::vector<std::string> reasons_of_standstill() const;
    /// Returns the sentences for the case that time passes forever from here on while a response is pending.
    [[nodiscard]] std::vector<std::string> reasons_of_waiting() const;
    /// Returns the time as "t=30 (3.0 s)".
    [[nodiscard]] std::string time_text(std::int64_t time) const;

private:
    /// An event with its time.
    struct Moment {
        std::int64_t time = 0;
        std::string text;
    };
    enum class Breaker : std::uint8_t { event, time, end };
    void note_changes(const MonitorState& before, const Occurrence& observed);
    void note_begun(const MonitorState& before, bool begins);
    [[nodiscard]] std::string change_text(const MonitorState& before, const std::vector<FactValue>& values) const;
    [[nodiscard]] std::string moment_text(const Moment& moment) const;
    [[nodiscard]] std::string breaker_text() const;
    [[nodiscard]] std::vector<std::string> reasons_of_body() const;
    [[nodiscard]] std::vector<std::string> reasons_of_debt(std::string event) const;
    [[nodiscard]] std::string demand_text() const;
    [[nodiscard]] std::string units(std::int64_t count) const;

    const CheckedClaim& claim_;
    Monitor monitor_;
    durations::Unit unit_;
    MonitorState state_;
    std::int64_t now_ = 0;
    Moment current_;                    ///< the event that is being observed
    std::optional<Moment> scope_;       ///< the event that began the scope
    std::optional<Moment> trigger_;     ///< start of the limit: the oldest open trigger or the latest OTHERS
    std::optional<std::int64_t> stay_;  ///< for_at_least, for_at_most: when the stay began
    std::vector<Moment> counted_;       ///< at_most: the counted events of the scope
    Breaker breaker_ = Breaker::event;
};

}  // namespace robochart::claims
