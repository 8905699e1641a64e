// SPDX-License-Identifier: Apache-2.0
// Tells the recorder of a run what a verb reads, and which constants and ranges it uses.
#pragma once

#include <vector>

#include "app/command/options.hpp"
#include "base/diagnostics/source.hpp"
#include "driver/model/pipeline.hpp"

namespace robochart::app {

/// Records a text that was read.
void record_text(const diagnostics::SourceManager&, diagnostics::SourceId, const Options&);
/// Records all texts that were read.
void record_texts(const diagnostics::SourceManager&, const Options&);
/// Records the files of the projects and, if they are instantiated, their constants and ranges. `used`: the settings
/// with which they were loaded. The options are those of the run.
void record_projects(const std::vector<driver::Part>&, const driver::Settings& used, const Options&);
void record_project(const driver::Project&, const driver::Settings& used, const Options&);
/// Records the values that CSP blocks define in the scripts of the project, in place of the others. If the run also
/// generates code, which does not read the blocks, the others stay.
void record_block_values(const driver::Project&, const Options&);

}  // namespace robochart::app
