// SPDX-License-Identifier: Apache-2.0
// Stores the initial values of variables that have none in the model (semantics 3.6).
#pragma once

#include <map>
#include <vector>

#include "csp_emit/base/project.hpp"

namespace robochart::csp_emit {

/// Owns the default value of each type that the machine uses. A large value, such as a matrix, is written once and
/// named.
class DefaultValues {
public:
    explicit DefaultValues(const Project& project) : project_(project) {}

    [[nodiscard]] cspm::ExprPtr value_of(ir::TypeId);
    /// Returns the definitions of the large default values.
    [[nodiscard]] const std::vector<cspm::DeclPtr>& declarations() const { return declarations_; }

private:
    const Project& project_;
    std::map<std::uint32_t, cspm::ExprPtr> known_;  ///< by TypeId: the value
    std::vector<cspm::DeclPtr> declarations_;
};

}  // namespace robochart::csp_emit
