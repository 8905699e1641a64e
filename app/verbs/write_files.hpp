// SPDX-License-Identifier: Apache-2.0
// Writes the files of a verb below the output folder and lists each in the report.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "app/command/findings.hpp"
#include "app/command/run.hpp"
#include "app/report/report.hpp"
#include "driver/model/pipeline.hpp"

namespace robochart::app {

/// Writes files (with a `path` and a `text`) to a folder below the output folder, such as "cpp/C/". If one cannot be
/// written, reports a diagnostic and returns false. Existing files are not overwritten if `keep` is set.
bool write_all(const std::string& below, const auto& files, std::vector<FileReport>& report, const Options& options,
               driver::Project& project) {
    for (const auto& file : files) {
        project.diagnostics.poll();
        const std::string path = fmt::format("{}/{}{}", options.output.folder, below, file.path);
        if constexpr (requires { file.keep; })
            if (file.keep && std::filesystem::exists(path)) continue;
        if (!write_output(project, options, below + file.path, file.text)) return false;
        const auto edit = options.run->edit();
        report.push_back({path, file.text.size()});
    }
    return true;
}

}  // namespace robochart::app
