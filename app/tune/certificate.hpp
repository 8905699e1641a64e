// What tuning leaves behind: constants, how they were found, and what was decided of the model with them, so that
// anybody can have it decided again (`tune --verify-certificate`).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/json.hpp"

namespace robochart::app {

/// Hexadecimal, of content: equal for equal content alone.
[[nodiscard]] std::string content_digest(std::string_view text);

/// Something that was decided, and the answer: "A1 [timed] S is deadlock-free", "holds".
struct DecidedItem {
    std::string subject;
    std::string answer;

    friend bool operator==(const DecidedItem&, const DecidedItem&) = default;
};

/// A claim about probabilities with what it rests on. Its trials have the seeds from the scenario's `seed` on.
struct DecidedClaim {
    std::string claim;  ///< as written
    std::string answer;
    std::uint64_t trials = 0;
    std::uint64_t successes = 0;
    double low = 0;  ///< of the interval of the last look
    double high = 1;

    friend bool operator==(const DecidedClaim&, const DecidedClaim&) = default;
};

/// What is decided of a model with certain constants, and of which texts.
struct Evidence {
    using Files = std::vector<std::pair<std::string, std::string>>;

    std::string scenario;         ///< its name
    std::string scenario_digest;  ///< of its text
    Files model;                  ///< the files of the model and their digests, sorted
    std::vector<DecidedItem> assertions;
    std::vector<DecidedItem> conformance;
    std::uint64_t seed = 0;  ///< of the first trial of the claims
    std::vector<DecidedClaim> claims;
};

/// How the constants were found.
struct SearchRecord {
    std::vector<std::pair<std::string, std::string>> parameters;  ///< "farRadius", "0.05..0.5"
    std::uint64_t budget = 0;
    std::uint64_t seed = 0;
    std::string test;  ///< "friedman", "t-test"
    std::uint64_t trials = 0;
    std::uint64_t candidates = 0;
    std::uint64_t first_seed = 0;  ///< of the trials, and how many
    std::uint64_t seeds = 0;
    double cost = 0;  ///< the mean of the winner's trials in the search: lower than what fresh trials give
};

/// Schema "robochart-verify/certificate/1" (docs/cli.md).
struct Certificate {
    std::string program;                                         ///< "robochart-verify 0.1.0"
    std::string build;                                           ///< which build of it; "" where it is not known
    std::vector<std::pair<std::string, std::string>> constants;  ///< those found, then those that were given
    std::vector<std::string> ranges;                             ///< `--range`
    SearchRecord search;
    Evidence evidence;
};

/// The certificate as a text that ends with a line end, with a digest of all that is in it.
[[nodiscard]] std::string certificate_text(const Certificate&);
/// Reads one, strictly: every field and no other, of the right kinds, and its digest. Nothing on failure, and `error`
/// says why.
[[nodiscard]] std::optional<Certificate> read_certificate(std::string_view text, std::string& error);

/// What differs, a line for each: files, verdicts, claims. Empty where both say the same.
[[nodiscard]] std::vector<std::string> differences(const Evidence& certified, const Evidence& found);

}  // namespace robochart::app
