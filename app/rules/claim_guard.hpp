// SPDX-License-Identifier: Apache-2.0
// Follows claims (docs/claims.md) along the runs of simulated robots. These are the claims of `simulate --monitor
// MODEL.claims`, and the claims that a scenario accepts. An input occurs for a claim when it is raised.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/command/options.hpp"
#include "cpp_emit/simulator_api.hpp"
#include "driver/claims/followed_claim.hpp"
#include "driver/model/pipeline.hpp"
#include "simulation/trial/trial.hpp"

namespace robochart::app {

/// The model and the controller of a kind of robots.
struct FollowedKind {
    const driver::Project* project = nullptr;
    const cpp_emit::DriveEmission* emission = nullptr;
};

/// Stores a reference to the scenario.
class ClaimGuard final : public simulation::Guard {
public:
    /// A claim about the controller of a kind of robots.
    struct Watched {
        const claims::CheckedClaim* claim = nullptr;
        std::size_t kind = 0;
        bool stops = false;                  ///< true if a robot that breaks the claim stops its trial
        std::optional<std::size_t> measure;  ///< the measure that counts the robots that obey it
        driver::FollowedClaim::Drops drops;  ///< drops in the declared order of the controller
    };

    ClaimGuard(const simulation::Scenario& scenario, std::vector<FollowedKind> kinds, std::vector<Watched> watched);

    [[nodiscard]] Maker make_observer(Maker other) override;
    [[nodiscard]] std::string summary_lines() const override;
    /// Adds a line to the part of the summary about claims that are not followed.
    void add_left_out(std::string reason) { left_out_.push_back(std::move(reason)); }

private:
    class Watch;
    /// A violation with the number of its trial. The report selects the violation of the first trial by number, so that
    /// it does not depend on the order in which trials run.
    struct Broken {
        std::uint32_t trial = 0;
        std::size_t robot = 0;
        std::string text;
    };

    const simulation::Scenario& scenario_;
    std::vector<FollowedKind> kinds_;
    std::vector<Watched> watched_;
    std::vector<std::string> left_out_;
    std::mutex mutex_;
    std::map<std::size_t, Broken> broken_;  ///< key: the number of the claim; the violation of the first trial
    std::map<std::size_t, std::string> given_up_;
    std::atomic<std::uint64_t> robots_ = 0;
};

/// True if the scenario has claims of its models, or `--monitor` names a file of claims.
[[nodiscard]] bool follows_claims(const simulation::Scenario& scenario, const Options& options);

/// Returns the guard for these claims; null if there are no claims. `kinds` are the kinds of the scenario. Errors are
/// reported in `reports`, whose sources contain the scenario.
[[nodiscard]] std::unique_ptr<ClaimGuard> make_claim_guard(const simulation::Scenario& scenario,
                                                           std::vector<FollowedKind> kinds, driver::Project& reports,
                                                           const Options& options);

/// Reports an error for the claims of a scenario, because chains and `tune` do not follow claims.
void refuse_followed_claims(const simulation::Scenario& scenario, driver::Project& project);

}  // namespace robochart::app
