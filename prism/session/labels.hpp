// SPDX-License-Identifier: Apache-2.0
// Resolves labels in the expressions of properties.
#pragma once

#include <map>
#include <string>
#include <unordered_map>

#include "prism/checks/checked.hpp"

namespace robochart::prism {

/// Replaces labels by their definitions, and names of properties by the properties. "deadlock" and "init" are not
/// replaced.
class LabelResolver {
public:
    LabelResolver(const CheckedModel& model, const CheckedProperties& properties);
    [[nodiscard]] ExprPtr operator()(const ExprPtr& expr);

private:
    ExprPtr replace_labels(const ExprPtr& expr);

    std::map<std::string, ExprPtr, std::less<>> bodies_;
    std::unordered_map<const Expr*, ExprPtr> done_;
};

}  // namespace robochart::prism
