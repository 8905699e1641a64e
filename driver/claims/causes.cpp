// SPDX-License-Identifier: Apache-2.0
// See causes.hpp.
#include "driver/claims/causes.hpp"

#include <string_view>

#include "semantics/instantiate/large_types.hpp"

namespace robochart::driver {
namespace {

/// The evaluator does not enumerate sets with more values than this.
constexpr double most_values = 5'000'000;

}  // namespace

std::string cause_of(const Project& project, const cspm::EvaluationError& error) {
    const std::string_view what = error.what();
    if (!is_about_large_set(what)) return "";
    const std::string type = ir::large_type(project.system, project.instantiation, most_values, project.sources);
    return type.empty() ? "" : "; " + type;
}

bool is_about_large_set(std::string_view reason) {
    return reason.find("more than 5000000") != std::string_view::npos;
}

}  // namespace robochart::driver
