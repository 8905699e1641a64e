// SPDX-License-Identifier: Apache-2.0
// The logs that `--traces` names, for comparisons with rules and with claims.
#pragma once

#include <cstdint>
#include <functional>
#include <istream>
#include <string>
#include <vector>

#include "app/command/options.hpp"

namespace robochart::app {

/// The files, and the logs in folders, in order. Adds an error if there are none.
[[nodiscard]] std::vector<std::string> log_files(const Options& options, std::vector<std::string>& errors);

/// Opens the log, records it as an input, counts it in `logs` and passes it to `read`. Adds an error if the file cannot
/// be read, or if `read` throws conformance::TraceFault.
void read_log(const std::string& path, const Options& options, std::vector<std::string>& errors, std::uint64_t& logs,
              const std::function<void(std::istream&)>& read);

}  // namespace robochart::app
