// SPDX-License-Identifier: Apache-2.0
// See dialect.hpp.
#include "frontend/syntax/dialect.hpp"

namespace robochart::frontend {

Dialect dialect_of(std::string_view path) {
    return path.ends_with(".rst") || path.ends_with(".rsa") ? Dialect::robosim : Dialect::robochart;
}

std::string_view to_text(Dialect dialect) {
    return dialect == Dialect::robosim ? "RoboSim" : "RoboChart";
}

bool is_model_path(std::string_view path) {
    return path.ends_with(".rct") || path.ends_with(".rst");
}

bool is_assertion_path(std::string_view path) {
    return path.ends_with(".assertions") || path.ends_with(".rsa");
}

}  // namespace robochart::frontend
