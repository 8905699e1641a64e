// SPDX-License-Identifier: Apache-2.0
// Records the files that a verb reads, and the constants and ranges that it uses.
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
/// Records the files of the projects and, if they are instantiated, their constants and ranges. `used` are the settings
/// with which the projects were loaded; the options are those of the run.
void record_projects(const std::vector<driver::Part>&, const driver::Settings& used, const Options&);
void record_project(const driver::Project&, const driver::Settings& used, const Options&);
/// Records the values that CSP blocks define in the scripts of the project. These values replace the values that were
/// recorded before, unless the run also generates code, because code generation does not read the blocks.
void record_block_values(const driver::Project&, const Options&);

}  // namespace robochart::app
