// SPDX-License-Identifier: Apache-2.0
// Follows claims (docs/claims.md) along the runs of simulated robots: `simulate --monitor MODEL.claims`, and the claims
// that a scenario accepts. An input counts when it is raised.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/command/options.hpp"
#include "app/rules/follow_guard.hpp"
#include "cpp_emit/simulator_api.hpp"
#include "driver/claims/followed_claim.hpp"
#include "driver/model/pipeline.hpp"
#include "simulation/scenario/scenario.hpp"

namespace robochart::app {

/// The model and the controller of a kind of robots.
struct FollowedKind {
    const driver::Project* project = nullptr;
    const cpp_emit::DriveEmission* emission = nullptr;
};

/// A claim about the controller of a kind of robots.
struct WatchedClaim {
    const claims::CheckedClaim* claim = nullptr;
    std::size_t kind = 0;
    bool stops = false;                  ///< a robot that breaks it stops its trial
    std::optional<std::size_t> measure;  ///< the measure that counts the robots that obey it
    driver::FollowedClaim::Drops drops;  ///< by the declared order of the controller
};

/// The claims of a scenario and of `--monitor`. Stores a reference to the scenario.
class ClaimDuties final : public Duties {
public:
    /// `left_out`: why other claims are not followed.
    ClaimDuties(const simulation::Scenario& scenario, std::vector<FollowedKind> kinds, std::vector<WatchedClaim> claims,
                std::vector<std::string> left_out);

    [[nodiscard]] std::unique_ptr<Follower> make_follower(std::size_t robot) override;
    void note_broken(std::uint32_t trial, std::size_t robot, const BrokenDuty& broken) override;
    [[nodiscard]] std::optional<double> kept_share(std::size_t measure,
                                                   const std::map<std::size_t, std::size_t>& broken) const override;
    [[nodiscard]] std::string summary_lines(std::uint64_t robots) const override;

private:
    class Robot;
    /// A violation with the number of its trial. The report selects the violation of the first trial by number, so that
    /// it does not depend on the order in which trials run.
    struct Broken {
        std::uint32_t trial = 0;
        std::size_t robot = 0;
        std::string text;
    };

    const simulation::Scenario& scenario_;
    std::vector<FollowedKind> kinds_;
    std::vector<WatchedClaim> claims_;
    std::vector<std::string> left_out_;
    std::vector<std::size_t> first_;        ///< the first robot of each kind, and the number of robots
    std::map<std::size_t, Broken> broken_;  ///< by the number of the claim: in the first trial
    std::map<std::size_t, std::string> given_up_;
};

/// True if the scenario has claims of its models, or `--monitor` names a file of claims.
[[nodiscard]] bool follows_claims(const simulation::Scenario& scenario, const Options& options);

/// These claims; null if there are none. `kinds` are those of the scenario. Errors are reported in `reports`, whose
/// sources contain the scenario.
[[nodiscard]] std::unique_ptr<ClaimDuties> find_claim_duties(const simulation::Scenario& scenario,
                                                             std::vector<FollowedKind> kinds, driver::Project& reports,
                                                             const Options& options);

/// Reports the claims of a scenario that a study of many kinds of trials does not follow.
void refuse_followed_claims(const simulation::Scenario& scenario, driver::Project& project);

}  // namespace robochart::app
