// SPDX-License-Identifier: Apache-2.0
#include "app/verbs/log_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/command/run.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "conformance/traces/mcap.hpp"
#include "conformance/traces/trace_text.hpp"

namespace robochart::app {

std::vector<std::string> log_files(const Options& options, std::vector<std::string>& errors) {
    std::vector<std::string> result;
    for (const std::string& given : options.conform.traces) {
        std::error_code error;
        if (!std::filesystem::is_directory(given, error)) {
            result.push_back(given);
            continue;
        }
        for (const std::string& path : diagnostics::files_below(given, true).files)
            if (conformance::is_log_path(path)) result.push_back(path);
    }
    if (result.empty()) errors.emplace_back("--traces: there are no .trace or .mcap files in the folder");
    return result;
}

void read_log(const std::string& path, const Options& options, std::vector<std::string>& errors, std::uint64_t& logs,
              const std::function<void(std::istream&)>& read) {
    const std::string shown = diagnostics::escape_for_display(path);
    try {
        const std::unique_ptr<std::istream> in = conformance::open_log(path, options.run->budget());
        if (in == nullptr) {
            errors.push_back(fmt::format("{}: it is not a regular file that may be read", shown));
            return;
        }
        ++logs;
        options.run->recorder().add_input_file(path);
        read(*in);
    } catch (const conformance::McapFault& fault) {
        errors.push_back(fmt::format("{}: {}", shown, fault.what()));
    } catch (const conformance::TraceFault& fault) {
        errors.push_back(fmt::format("{}: {}", shown, conformance::fault_text(fault)));
    }
}

}  // namespace robochart::app
