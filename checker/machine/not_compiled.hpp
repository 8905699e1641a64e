// SPDX-License-Identifier: Apache-2.0
// Defines the exception for processes that cannot be compiled.
#pragma once

#include <stdexcept>

namespace robochart::machine {

/// Thrown if a process exceeds the bounds of the compiler. A search can then use the terms of the process.
class NotCompiled : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace robochart::machine
