// What the verb `prism` works on: a model and properties, read and checked, and the values to try for their constants.
#pragma once

#include <optional>
#include <vector>

#include "app/command/options.hpp"
#include "checker/prism/checks/checked.hpp"
#include "checker/prism/explore/evaluation.hpp"
#include "diagnostics/diagnostic.hpp"
#include "diagnostics/source.hpp"

namespace robochart::app {

/// The files with the findings about them.
struct LoadedModel {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    std::optional<prism::ModelKind> kind;      ///< as written; nothing where that could not be read
    std::optional<prism::CheckedModel> model;  ///< a dtmc where it is an mdp under a scheduler
    bool scheduled = false;                    ///< it is
    prism::CheckedProperties properties;
};

/// Reads the model, the files of properties and those of `--property`; what is wrong is among the findings. Throws
/// UsageError where paths of an mdp are asked for and nobody makes its choices.
void load(const Options& options, LoadedModel& loaded);

/// Values asked for on the command line: of the model's constants, and of those of the properties.
struct Experiment {
    std::vector<prism::Values> of_model, of_properties;
};

/// Throws UsageError.
[[nodiscard]] Experiment experiment(const LoadedModel& loaded, const Options& options);

}  // namespace robochart::app
