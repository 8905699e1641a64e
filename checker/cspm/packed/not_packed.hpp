// SPDX-License-Identifier: Apache-2.0
// Defines the exception for processes that cannot be searched as packed states.
#pragma once

namespace robochart::cspm {

/// Thrown if a term or a value has no packed form. The caller then searches the process as terms. This type does not
/// derive from std::exception, so handlers of errors in processes do not catch it.
struct NotPacked {
    const char* why;
};

}  // namespace robochart::cspm
