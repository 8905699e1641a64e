// SPDX-License-Identifier: Apache-2.0
// Defines the error for settings that contradict each other, or that name something that does not exist.
#pragma once

#include <stdexcept>

namespace robochart::driver {

/// Thrown if the settings are invalid. The message contains the reason.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace robochart::driver
