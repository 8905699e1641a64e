// SPDX-License-Identifier: Apache-2.0
// Why a process is not searched as packed states.
#pragma once

namespace robochart::cspm {

/// Thrown where a term or a value has no packed form: the process is searched as terms. It is no std::exception, so
/// that nothing takes it for a fault of the process.
struct NotPacked {
    const char* why;
};

}  // namespace robochart::cspm
