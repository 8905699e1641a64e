// Files that a verb writes below the output folder, each told to the report once it is there.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "app/rules.hpp"
#include "app/run.hpp"
#include "app/report.hpp"
#include "diagnostics/files.hpp"

namespace robochart::app {

/// Writes files (with a `path` and a `text`) to a folder of the output folder, as "cpp/C/". False, with a diagnostic, if
/// one cannot be written. A file that says `keep` is left as it is where there is one already.
bool write_all(const std::string& below, const auto& files, std::vector<FileReport>& report, const Options& options,
               diagnostics::Diagnostics& diagnostics) {
    for (const auto& file : files) {
        diagnostics.poll();
        const std::string path = fmt::format("{}/{}{}", options.out, below, file.path);
        if constexpr (requires { file.keep; })
            if (file.keep && std::filesystem::exists(path)) continue;
        const std::string error = diagnostics::write_below(options.out, below + file.path, file.text, diagnostics.budget());
        if (!error.empty()) {
            diagnostics.report(rules::unwritable, {}, {error});
            return false;
        }
        const auto edit = options.run->edit();
        report.push_back({path, file.text.size()});
    }
    return true;
}

}  // namespace robochart::app
