// SPDX-License-Identifier: Apache-2.0
#include "runs/evaluation_failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <vector>

#include "diagnostics/escape.hpp"
#include "semantics/ir/element_at.hpp"
#include "semantics/ir/open_constants.hpp"

namespace robochart::runs {
namespace {

/// "; the constant speed has no value in the model and is 0 (--const speed=1 gives it one)" if a divisor contains it;
/// otherwise "".
std::string open_constants(const cspm::EvaluationError& error, const ir::System& system) {
    if (std::string_view(error.what()).find("by zero") == std::string_view::npos) return "";
    const std::vector<std::string> names = ir::open_divisors(system, error.span);
    if (names.empty()) return "";
    std::vector<std::string> options;
    for (const std::string& name : names) options.push_back(fmt::format("--const {}=1", name));
    const bool one = names.size() == 1;
    return fmt::format("; the constant{} {} {} no value in the model and {} 0 ({} gives {})", one ? "" : "s",
                       fmt::join(names, ", "), one ? "has" : "have", one ? "is" : "are", fmt::join(options, " "),
                       one ? "it one" : "them one");
}

}  // namespace

std::string failure(const cspm::EvaluationError& error, const ir::System& system) {
    const std::string element = ir::element_at(system, error.span);
    return error.what() + (element.empty() ? "" : ", in " + element) + open_constants(error, system);
}

std::string placed_failure(const cspm::EvaluationError& error, const ir::System& system,
                           const diagnostics::SourceManager& sources) {
    const std::string place = sources.place(error.span);
    return (place.empty() ? "" : diagnostics::shown(place) + ": ") + failure(error, system);
}

}  // namespace robochart::runs
