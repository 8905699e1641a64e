// Monitors of rules as C++ (`emit monitor RULES.sleec`): of the same meaning as sleec/monitor, but without heap. Of
// duties that ask for the same, one stands for all whose fate it decides (cpp_emit/runtime/rules.hpp, `stands_for`),
// and so many others may be open at once as can differ, or at most `most_open` of a rule: where more would be, the
// monitor counts those that it does not follow.
#pragma once

#include <string>
#include <vector>

#include "cpp_emit/plan/options.hpp"
#include "diagnostics/source.hpp"
#include "sleec/obligations/obligation.hpp"

namespace robochart::sleec {

/// Most duties of one rule, and of one file, that a generated monitor keeps at once.
inline constexpr std::size_t most_open = 256;
inline constexpr std::size_t most_open_of_file = 4096;

/// A header with all rules but assumptions, and robochart/rules.hpp, which it needs. `path` is the file of the rules;
/// the header is called by its name without folder and extension. Throws NotDecided where a rule has more responses
/// behind each other than a monitor follows.
[[nodiscard]] std::vector<cpp_emit::OutputFile> monitor_files(const CheckedRules& rules, const std::string& path,
                                                              const diagnostics::SourceManager& sources, WithoutLimit);
/// "care" of "rules/care.sleec", made an identifier.
[[nodiscard]] std::string monitor_name(const std::string& path);

}  // namespace robochart::sleec
