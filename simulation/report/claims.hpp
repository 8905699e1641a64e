// SPDX-License-Identifier: Apache-2.0
// Judges claims about probabilities on the answers of trials, in the order of their seeds. Therefore the verdict, and
// the trials that a verdict is based on, do not depend on which trial ends first.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/statistics/sequential.hpp"
#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

/// `estimated` is the result of an estimate after all its trials.
enum class ClaimVerdict { holds, fails, open, estimated };

/// The answer of one trial to a claim.
struct ClaimOutcome {
    bool holds = false;
    double time = 0;       ///< s, at which the answer was known
    bool stopped = false;  ///< a controller stopped before the answer was known
};

/// The answers of the trials to a claim.
struct ClaimResult {
    ClaimVerdict verdict = ClaimVerdict::open;
    std::uint64_t successes = 0;  ///< trials in which the property is true
    double error = 0;             ///< the error of the interval, or of each answer of the test
    /// For claims decided by intervals: the interval of the last look.
    statistics::Interval interval;
    std::uint64_t looked = 0;            ///< number of trials at the last look
    std::uint64_t steps = 0;             ///< control steps until the property was known, over all its trials
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

/// "holds", "fails", "open", "estimated".
[[nodiscard]] std::string verdict_word(ClaimVerdict);
/// The basis of the verdict: "183 of 183 trials; between 95.032 % and 100 %".
[[nodiscard]] std::string evidence_text(const Claim&, const ClaimResult&);
/// One line per claim: verdict, the claim as written, and its basis.
[[nodiscard]] std::string claims_text(const Scenario&, const std::vector<ClaimResult>&);
/// Describes the world that the probabilities refer to, line by line, so that a reader can judge the results.
[[nodiscard]] std::vector<std::string> world_lines(const Scenario&);
/// Returns the lines of the description, indented.
[[nodiscard]] std::string world_text(const Scenario&);

}  // namespace robochart::simulation
