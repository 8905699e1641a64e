// SPDX-License-Identifier: Apache-2.0
// Reads and writes certificates of tuning. A certificate contains constants, the search that found these constants, and
// the decisions about the model with these constants. Anybody can repeat the decisions (`tune --verify-certificate`).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostics/json.hpp"

namespace robochart::driver {

/// Returns the hexadecimal digest of a text; different texts have different digests.
[[nodiscard]] std::string content_digest(std::string_view text);

/// A decided claim and its answer, for example "A1 [timed] S is deadlock-free" and "holds".
struct DecidedItem {
    std::string subject;
    std::string answer;

    friend bool operator==(const DecidedItem&, const DecidedItem&) = default;
};

/// A claim about probabilities, and the trials on which its answer is based. The seeds of the trials start at the
/// scenario's `seed`.
struct DecidedClaim {
    std::string claim;  ///< as written
    std::string answer;
    std::uint64_t trials = 0;
    std::uint64_t successes = 0;
    double low = 0;  ///< the last computed confidence interval
    double high = 1;

    friend bool operator==(const DecidedClaim&, const DecidedClaim&) = default;
};

/// The decisions about a model with certain constants, and the digests of the model's texts.
struct Evidence {
    using Files = std::vector<std::pair<std::string, std::string>>;

    std::string scenario;         ///< its name
    std::string scenario_digest;  ///< digest of the scenario's text
    Files model;                  ///< the files of the model and their digests, sorted
    std::vector<DecidedItem> assertions;
    std::vector<DecidedItem> conformance;
    std::uint64_t seed = 0;  ///< seed of the first trial for the claims
    std::vector<DecidedClaim> claims;
};

/// The search that found the constants.
struct SearchRecord {
    std::vector<std::pair<std::string, std::string>> parameters;  ///< "farRadius", "0.05..0.5"
    std::uint64_t budget = 0;
    std::uint64_t seed = 0;
    std::string test;  ///< "friedman", "t-test"
    std::uint64_t trials = 0;
    std::uint64_t candidates = 0;
    std::uint64_t first_seed = 0;  ///< first seed and number of the trials
    std::uint64_t seeds = 0;
    double cost = 0;  ///< mean cost of the winner's trials in the search; lower than that of fresh trials
};

/// Schema "robochart-verify/certificate/1" (docs/cli.md).
struct Certificate {
    std::string program;     ///< "robochart-verify 0.1.0"
    std::string build;       ///< build ID of the program; "" if unknown
    std::string run = "{}";  ///< record of the run, in JSON; not compared
    /// The constants that the search found, then the constants that the user gave.
    std::vector<std::pair<std::string, std::string>> constants;
    std::vector<std::string> ranges;  ///< `--range`
    SearchRecord search;
    Evidence evidence;
};

/// Returns the certificate as text with a final line end, including a digest of its contents.
[[nodiscard]] std::string certificate_text(const Certificate&);
/// Reads a certificate. If it does not have exactly the required fields with the right types and a correct digest,
/// returns no value, and `error` contains the reason.
[[nodiscard]] std::optional<Certificate> read_certificate(std::string_view text, std::string& error);

/// Returns the differences between the files, verdicts and claims of two certificates, one line for each difference.
/// The result is empty if there is no difference.
[[nodiscard]] std::vector<std::string> evidence_differences(const Evidence& certified, const Evidence& found);

}  // namespace robochart::driver
