// SPDX-License-Identifier: Apache-2.0
// The input of the verb `prism`: a model and properties, parsed and checked, and the values of their constants to try.
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
    std::optional<prism::CheckedModel> model;  ///< a dtmc if an mdp is combined with a scheduler
    bool scheduled = false;                    ///< an mdp was combined with a scheduler
    prism::CheckedProperties properties;
};

/// Reads the model, the property files and those of `--property`; mistakes are added to the findings. Throws UsageError
/// if paths of an mdp are requested without a scheduler.
void load_model(const Options& options, LoadedModel& loaded);

/// The values requested on the command line: for constants of the model, and for those of the properties.
struct Experiment {
    std::vector<prism::Values> of_model, of_properties;
};

/// Throws UsageError.
[[nodiscard]] Experiment make_experiment(const LoadedModel& loaded, const Options& options);

}  // namespace robochart::app
