// Files that a verb writes below the output folder, each in the report once it is there.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "app/command/pipeline.hpp"
#include "app/command/run.hpp"
#include "app/report/report.hpp"

namespace robochart::app {

/// Writes files (with a `path` and a `text`) to a folder of the output folder, as "cpp/C/". False, with a diagnostic,
/// if one cannot be written. A file that says `keep` is left as it is where there is one already.
bool write_all(const std::string& below, const auto& files, std::vector<FileReport>& report, const Options& options,
               Project& project) {
    for (const auto& file : files) {
        project.diagnostics.poll();
        const std::string path = fmt::format("{}/{}{}", options.out, below, file.path);
        if constexpr (requires { file.keep; })
            if (file.keep && std::filesystem::exists(path)) continue;
        if (!write_output(project, options, below + file.path, file.text)) return false;
        const auto edit = options.run->edit();
        report.push_back({path, file.text.size()});
    }
    return true;
}

}  // namespace robochart::app
