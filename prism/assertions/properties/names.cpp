// SPDX-License-Identifier: Apache-2.0
#include "prism/assertions/properties/names.hpp"

namespace robochart::probability {

std::string owner_of(const std::string& path) {
    const std::size_t at = path.rfind("::");
    return at == std::string::npos ? "" : path.substr(0, at);
}

std::string last_of(const std::string& path) {
    return path.substr(path.rfind(':') + 1);
}

prism::ExprPtr name_expression(const std::string& name) {
    return prism::make_expr(prism::Op::name, {}, {}, name);
}

}  // namespace robochart::probability
