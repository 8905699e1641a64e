// SPDX-License-Identifier: Apache-2.0
// Defines the verdict about a SLEEC rule and a component of a model.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace robochart::driver {

/// The verdict about a rule and a component of a model.
struct RuleVerdict {
    enum class Kind { obeyed, broken, never_asked, not_applicable, not_decided, error };
    std::string component;
    std::size_t rule = 0;
    Kind kind = Kind::not_decided;
    std::string reason;              ///< set for not applicable, not decided and error
    std::vector<std::string> lines;  ///< describes the violation of a broken rule
    std::uint64_t states = 0;
};

}  // namespace robochart::driver
