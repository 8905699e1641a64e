// SPDX-License-Identifier: Apache-2.0
// Loads the input of the verb `prism`: a model and properties, parsed and checked, and the values of their constants.
#pragma once

#include <optional>
#include <vector>

#include "app/command/options.hpp"
#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/source.hpp"
#include "prism/checks/checked.hpp"
#include "prism/explore/evaluation.hpp"

namespace robochart::app {

/// The files with their findings.
struct LoadedModel {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    std::optional<prism::ModelKind> kind;      ///< as written; no value if it could not be read
    std::optional<prism::CheckedModel> model;  ///< a dtmc if a scheduler was applied to an mdp
    bool scheduled = false;                    ///< true if a scheduler was applied to an mdp
    prism::CheckedProperties properties;
};

/// Reads the model, the property files and the properties of `--property`. Errors in them are added to the findings.
/// Throws UsageError if the options request random paths of an mdp without a scheduler.
void load_model(const Options& options, LoadedModel& loaded);

/// The values that the command line gives to constants of the model and of the properties.
struct Experiment {
    std::vector<prism::Values> of_model, of_properties;
};

/// Parses the values that the command line gives. Throws UsageError if they are wrong.
[[nodiscard]] Experiment make_experiment(const LoadedModel& loaded, const Options& options);

}  // namespace robochart::app
