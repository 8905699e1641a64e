// SPDX-License-Identifier: Apache-2.0
// Defines the exception for processes that cannot be compiled.
#pragma once

#include <stdexcept>

namespace robochart::machine {

/// Thrown if the process cannot be compiled within the compiler's bounds. It can still be run as a term.
class NotCompiled : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace robochart::machine
