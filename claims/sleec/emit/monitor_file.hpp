// SPDX-License-Identifier: Apache-2.0
// Generates monitors of rules as C++ (`emit monitor RULES.sleec`). The monitors have the same meaning as
// claims/sleec/monitor, but do not allocate memory. If several duties have the same demands, the monitor stores only
// the duty that decides the outcome of the others (cpp_emit/runtime/rules.hpp, `stands_for`). The number of duties
// stored at once is at most the number of different ones, and at most `most_open` per rule. The monitor counts duties
// beyond this limit, but does not follow them.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"
#include "claims/sleec/obligations/obligation.hpp"
#include "cpp_emit/plan/options.hpp"

namespace robochart::sleec {

/// The largest number of duties, per rule and per file, that a generated monitor stores at once.
inline constexpr std::size_t most_open = 256;
inline constexpr std::size_t most_open_of_file = 4096;

/// Returns a header with all rules except assumptions, and robochart/rules.hpp, which the header needs. `path` is the
/// path of the rule file. The name of the header is the name of this file without folder and extension. Throws
/// NotDecided if a rule has more consecutive responses than a monitor can follow.
[[nodiscard]] std::vector<cpp_emit::OutputFile> monitor_files(const CheckedRules& rules, const std::string& path,
                                                              const diagnostics::SourceManager& sources, WithoutLimit);
/// Returns the name of the file as an identifier: "care" for "rules/care.sleec".
[[nodiscard]] std::string monitor_name(const std::string& path);

}  // namespace robochart::sleec
