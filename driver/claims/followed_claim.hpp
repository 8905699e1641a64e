// SPDX-License-Identifier: Apache-2.0
// Monitors a claim in one run outside of the model: a log, or a robot of a simulation. An input counts as soon as it is
// raised.
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
    FollowedClaim(const claims::CheckedClaim& claim, const ir::System& system, durations::Unit unit);

    /// An input or an output with the texts of its values, as in logs. Names that the component does not have are
    /// ignored. `line` is its line in a log.
    void observe(std::string_view name, bool input, const std::vector<std::string>& values, std::uint64_t line = 0);
    void tock(std::uint64_t line = 0);
    void end(std::uint64_t line = 0);
    /// From now on, the verdict is unknown for this reason.
    void give_up(std::string why);

    [[nodiscard]] bool is_broken() const { return !reasons_.empty(); }
    /// The place in a log where the claim was broken, and at most three sentences about it.
    [[nodiscard]] std::uint64_t line() const { return line_; }
    [[nodiscard]] const std::vector<std::string>& reasons() const { return reasons_; }
    /// The reason why the run does not show whether the claim holds; "" if it does.
    [[nodiscard]] const std::string& unknown() const { return unknown_; }
    [[nodiscard]] const claims::CheckedClaim& claim() const { return *claim_; }

private:
    void observe_channel(std::size_t channel, const std::vector<std::string>& values, std::uint64_t line);
    [[nodiscard]] bool reads_values(std::size_t channel) const;
    void note(std::uint64_t line);

    const claims::CheckedClaim* claim_;
    const ir::System* system_;
    claims::Account account_;
    std::uint64_t line_ = 0;
    std::vector<std::string> reasons_;
    std::string unknown_;
};

/// The channels of the component that the claim mentions, ascending.
[[nodiscard]] std::vector<std::size_t> channels_of(const claims::CheckedClaim& claim);

}  // namespace robochart::driver
