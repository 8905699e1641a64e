// Claims about probabilities, judged on the answers of trials in the order of their seeds: whichever trial ends first,
// the verdict and the trials that it rests on are the same.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/trial/trial.hpp"
#include "statistics/sequential.hpp"

namespace robochart::simulation {

/// `estimated`: of an estimate after all its trials.
enum class ClaimVerdict { holds, fails, open, estimated };

/// What one trial says of a claim.
struct ClaimOutcome {
    bool holds = false;
    double time = 0;       ///< s, when it was known
    bool stopped = false;  ///< its controller could not go on, and the answer was not known by then
};

/// What the trials say of a claim.
struct ClaimResult {
    ClaimVerdict verdict = ClaimVerdict::open;
    std::uint64_t successes = 0;  ///< trials whose property holds
    double error = 0;             ///< of the interval, or of each answer of the test
    /// By intervals: that of the last look.
    statistics::Interval interval;
    std::uint64_t looked = 0;            ///< trials of the last look
    std::uint64_t steps = 0;             ///< control steps until the property was known, of all its trials
    std::vector<ClaimOutcome> outcomes;  ///< of the trials that it rests on, in the order of seeds

    [[nodiscard]] std::uint64_t trials() const { return outcomes.size(); }
    [[nodiscard]] std::uint64_t stopped() const;
};

/// Takes the trials of a claim one after the other until it is decided.
class ClaimJudge {
public:
    /// `comparisons`: that share the error. Keeps a reference to the claim.
    ClaimJudge(const Claim&, std::uint32_t comparisons);

    /// Needs no more trials: decided, or as many as there may be.
    [[nodiscard]] bool done() const { return done_; }
    /// The next trial, one that gave an answer.
    void add(const ClaimOutcome&, std::uint64_t steps);
    [[nodiscard]] const ClaimResult& result() const { return result_; }

private:
    void look_at_interval();
    void test();
    void estimate();
    void decide(bool above);

    const Claim& claim_;
    ClaimResult result_;
    statistics::Looks looks_;
    statistics::Sprt sprt_;
    bool done_ = false;
};

/// "holds", "fails", "open", "estimated".
[[nodiscard]] std::string verdict_word(ClaimVerdict);
/// What the verdict rests on: "183 of 183 trials; between 95.032 % and 100 %".
[[nodiscard]] std::string evidence_text(const Claim&, const ClaimResult&);
/// A line for each claim: verdict, the claim as written, what it rests on.
[[nodiscard]] std::string claims_text(const Scenario&, const std::vector<ClaimResult>&);
/// The world that probabilities are about, line by line: what a reader has to know to believe or to doubt them.
[[nodiscard]] std::vector<std::string> world_lines(const Scenario&);
/// The same, indented.
[[nodiscard]] std::string world_text(const Scenario&);

}  // namespace robochart::simulation
