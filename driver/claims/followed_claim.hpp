// SPDX-License-Identifier: Apache-2.0
// Monitors a claim along a run: a log, or the run of a robot in a simulation. For the claim, an input occurs when it is
// raised, and all inputs of one cycle are simultaneous (docs/claims.md, "Claims about one cycle"). So the monitor
// collects inputs until an output or a time unit follows, and ignores inputs that a declared order drops.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "claims/monitor/account.hpp"

namespace robochart::driver {

/// Stores references to the claim and the system.
class FollowedClaim {
public:
    /// Pairs of inputs of the component: if `event` is raised in the same cycle, `dropped` is ignored.
    using Drops = std::vector<claims::CheckedOrder::Drop>;
    FollowedClaim(const claims::CheckedClaim& claim, const ir::System& system, durations::Unit unit, Drops drops = {});

    /// Observes an input or an output. `values` are texts as in logs. The function ignores names that the component
    /// does not have. `line` is the event's line in a log.
    void observe(std::string_view name, bool input, const std::vector<std::string>& values, std::uint64_t line = 0);
    void tock(std::uint64_t line = 0);
    void end(std::uint64_t line = 0);
    /// After this call, the verdict is unknown for the reason `why`.
    void give_up(std::string why);

    /// Ends the run, and observes its last inputs if it ends within a cycle.
    void finish() { observe_inputs(); }

    [[nodiscard]] bool is_broken() const { return !reasons_.empty(); }
    /// Returns the line of the log at which the claim was violated. reasons() returns at most three sentences that
    /// explain the violation.
    [[nodiscard]] std::uint64_t line() const { return line_; }
    [[nodiscard]] const std::vector<std::string>& reasons() const { return reasons_; }
    /// Returns the reason why the run does not decide the claim. Returns "" if the run decides the claim.
    [[nodiscard]] const std::string& unknown() const { return unknown_; }
    [[nodiscard]] const claims::CheckedClaim& claim() const { return *claim_; }

private:
    /// An event, and the text that describes the event in reports.
    struct Named {
        claims::Occurrence occurrence;
        std::string text;
        std::uint64_t line = 0;
    };
    /// Returns the event with its values. Returns no value if a condition of the claim cannot read these values.
    [[nodiscard]] std::optional<Named> named(std::size_t channel, const std::vector<std::string>& values,
                                             std::uint64_t line);
    void observe_inputs();
    void observe_event(const Named& event);
    [[nodiscard]] bool reads_values(std::size_t channel) const;
    void note(std::uint64_t line);

    const claims::CheckedClaim* claim_;
    const ir::System* system_;
    claims::Account account_;
    Drops drops_;
    std::vector<Named> raised_;  ///< the inputs of this cycle that have not been observed yet
    std::uint64_t line_ = 0;
    std::vector<std::string> reasons_;
    std::string unknown_;
};

/// Returns the channels of the component that the claim mentions, in ascending order.
[[nodiscard]] std::vector<std::size_t> channels_of(const claims::CheckedClaim& claim);

}  // namespace robochart::driver
