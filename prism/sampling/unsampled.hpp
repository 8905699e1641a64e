// SPDX-License-Identifier: Apache-2.0
// Why samples cannot answer a query.
#pragma once

#include <stdexcept>

namespace robochart::prism {

/// The message contains the reason.
class Unsampled : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace robochart::prism
