// SPDX-License-Identifier: Apache-2.0
// Defines the results of `prism` as data, and writes them as text, JSON (robochart-verify/prism/1) and CSV.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/command/options.hpp"
#include "base/diagnostics/json.hpp"
#include "base/diagnostics/source.hpp"
#include "prism/session/counterexample.hpp"
#include "prism/session/result.hpp"

namespace robochart::app {

/// Names of constants with their values as text.
using NamedValues = std::vector<std::pair<std::string, std::string>>;

/// The answer to one property, for one set of constants.
struct PrismAnswer {
    std::size_t property = 0;
    NamedValues constants;
    prism::Result result;
    std::string error;  ///< why the property could not be evaluated; "" if it was
    std::optional<prism::Counterexample> counterexample;
};

/// The answers about the model for one set of constants.
struct PrismRun {
    NamedValues constants;
    std::uint64_t states = 0, choices = 0, transitions = 0, initial = 0, deadlocks = 0;
    double seconds = 0;  ///< time to explore the states
    bool explored = false;
    std::vector<PrismAnswer> answers;
};

struct PrismProperty {
    std::string name, text;
};

struct PrismReport {
    std::string model;                                    ///< path of the model
    const diagnostics::SourceManager* sources = nullptr;  ///< for the commands in counterexamples
    std::optional<prism::ModelKind> kind;                 ///< as written; no value if it could not be read
    std::string scheduler;                                ///< for an mdp: how choices are resolved; "": any scheduler
    std::vector<PrismProperty> properties;
    std::vector<PrismRun> runs;
    std::vector<std::string> errors;
    std::string limit;  ///< the limit that ended the run; "" if none did
};

/// Returns the interval around a number. For a computed number, it is the enclosure. For an estimate, it is the
/// interval with the best coverage, which is that of Clopper and Pearson if the samples are successes and failures.
[[nodiscard]] prism::Enclosure interval_of(const prism::Result& result);
/// Returns "0.384 +- 0.04 at 99 % (ci, 1000 paths of 4.6 steps, 1 to 31)", or "true (sprt, ...)".
[[nodiscard]] std::string sampled_text(const prism::Result& result);
/// Returns "Clopper-Pearson: from 0.34 to 0.42"; "" if the samples are not successes and failures.
[[nodiscard]] std::string binomial_text(const prism::Result& result);
/// Returns an estimated number as {"value", "low", "high"}: the mean and the bounds of `interval_of`.
[[nodiscard]] diagnostics::Json interval_json(const prism::Result& result);
/// Returns the method, the samples and the intervals.
[[nodiscard]] diagnostics::Json estimate_json(const prism::Estimate& estimate);
/// Returns "0.5", "1/3" or "0.333333 (from 0.3333331 to 0.3333335)".
[[nodiscard]] std::string value_text(const prism::Real& value);
/// Returns {"value", "low", "high"}, and "exact" if the number is a fraction.
[[nodiscard]] diagnostics::Json real_json(const prism::Real& value);

/// Returns 2 if there is an error, otherwise 1 if a property is false, otherwise 3 if one is not decided, otherwise 0.
[[nodiscard]] Exit exit_of(const PrismReport& report);
[[nodiscard]] std::string prism_text(const PrismReport& report, const Options& options);
[[nodiscard]] std::string prism_json(const PrismReport& report);
[[nodiscard]] std::string prism_csv(const PrismReport& report);

}  // namespace robochart::app
