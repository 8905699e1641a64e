// SPDX-License-Identifier: Apache-2.0
// Decides claims about probabilities from the answers of trials, in the order of the trials' seeds. Therefore the
// verdict does not depend on which trial ends first, and neither do the trials that it is based on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/statistics/sequential.hpp"
#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

/// The verdict on a claim. `estimated` is the result of an estimate after all its trials.
enum class ClaimVerdict { holds, fails, open, estimated };

/// The answer of one trial to a claim.
struct ClaimOutcome {
    bool holds = false;
    double time = 0;       ///< the time at which the answer was known, in s
    bool stopped = false;  ///< a controller stopped before the answer was known
};

/// The answers of the trials to a claim.
struct ClaimResult {
    ClaimVerdict verdict = ClaimVerdict::open;
    std::uint64_t successes = 0;  ///< trials in which the property is true
    double error = 0;             ///< the error of the interval, or of each answer of the test
    /// For claims decided by intervals: the interval when the trials were last evaluated.
    statistics::Interval interval;
    std::uint64_t looked = 0;            ///< number of trials at the last evaluation
    std::uint64_t steps = 0;             ///< number of control steps until the property was known, over all trials
    std::vector<ClaimOutcome> outcomes;  ///< the trials that the verdict is based on, in the order of seeds

    [[nodiscard]] std::uint64_t trial_count() const { return outcomes.size(); }
    [[nodiscard]] std::uint64_t stopped_count() const;
};

/// Receives the trials of a claim one after another until it is decided.
class ClaimJudge {
public:
    /// `comparisons` is the number of tests that share the error. Stores a reference to the claim.
    ClaimJudge(const Claim&, std::uint32_t comparisons);

    /// True if no more trials are needed, because the claim is decided or the maximum is reached.
    [[nodiscard]] bool is_done() const { return done_; }
    /// Adds the next trial, which must have an answer.
    void add(const ClaimOutcome&, std::uint64_t steps);
    [[nodiscard]] const ClaimResult& result() const { return result_; }

private:
    void update_interval();
    void run_test();
    void update_estimate();
    void set_verdict(bool above);

    const Claim& claim_;
    ClaimResult result_;
    statistics::Looks looks_;
    statistics::Sprt sprt_;
    bool done_ = false;
};

/// Returns "holds", "fails", "open" or "estimated".
[[nodiscard]] std::string verdict_word(ClaimVerdict);
/// Returns the basis of the verdict: "183 of 183 trials; between 95.032 % and 100 %".
[[nodiscard]] std::string evidence_text(const Claim&, const ClaimResult&);
/// Returns one line per claim: the verdict, the claim as written, and its basis.
[[nodiscard]] std::string claims_text(const Scenario&, const std::vector<ClaimResult>&);
/// Describes the world that the probabilities refer to, line by line.
[[nodiscard]] std::vector<std::string> world_lines(const Scenario&);
/// Returns the same description as one indented text.
[[nodiscard]] std::string world_text(const Scenario&);

}  // namespace robochart::simulation
