// What `prism` found, as data, and its output: text, JSON (robochart-verify/prism/1), CSV.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/command/options.hpp"
#include "checker/prism/result.hpp"
#include "diagnostics/json.hpp"

namespace robochart::app {

/// Names of constants with their values, as text.
using NamedValues = std::vector<std::pair<std::string, std::string>>;

/// One property, for one set of constants.
struct PrismAnswer {
    std::size_t property = 0;
    NamedValues constants;
    prism::Result result;
    std::string error;  ///< why it could not be evaluated; "" if it could
};

/// The model with values for its constants.
struct PrismRun {
    NamedValues constants;
    std::uint64_t states = 0, choices = 0, transitions = 0, initial = 0, deadlocks = 0;
    double seconds = 0;  ///< to explore
    bool explored = false;
    std::vector<PrismAnswer> answers;
};

struct PrismProperty {
    std::string name, text;
};

struct PrismReport {
    std::string model;  ///< path
    bool mdp = false;
    std::vector<PrismProperty> properties;
    std::vector<PrismRun> runs;
    std::vector<std::string> errors;
    std::string limit;  ///< what ended the run; "" if nothing did
};

/// "0.5", "1/3", "0.333333 (from 0.3333331 to 0.3333335)".
[[nodiscard]] std::string value_text(const prism::Real& value);
/// {"value", "low", "high"}, and "exact" where it is a fraction.
[[nodiscard]] diagnostics::Json real_json(const prism::Real& value);

/// 2 where something is wrong, else 1 where a property is false, else 3 where one is not decided.
[[nodiscard]] Exit exit_of(const PrismReport& report);
[[nodiscard]] std::string prism_text(const PrismReport& report, const Options& options);
[[nodiscard]] std::string prism_json(const PrismReport& report);
[[nodiscard]] std::string prism_csv(const PrismReport& report);

}  // namespace robochart::app
