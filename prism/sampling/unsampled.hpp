// SPDX-License-Identifier: Apache-2.0
// Declares the exception for queries that samples cannot answer.
#pragma once

#include <stdexcept>

namespace robochart::prism {

/// The message contains the reason.
class Unsampled : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace robochart::prism
