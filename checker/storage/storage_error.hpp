// SPDX-License-Identifier: Apache-2.0
// The exceptions for files of a search that cannot be read or written.
#pragma once

#include <stdexcept>
#include <string>

#include "base/diagnostics/budget.hpp"

namespace robochart::storage {

/// Thrown if a given file is damaged, truncated, or belongs to something else. The message contains the file, the place
/// in it and the cause.
class BadFile : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Thrown if a file cannot be written, because the disk is full or the folder cannot be used. It is a LimitReached and
/// is handled like other limits. Data that were written before are unchanged.
class CannotWrite : public diagnostics::LimitReached {
public:
    using diagnostics::LimitReached::LimitReached;
};

/// Throws the error for a file that cannot be opened for reading. `error` is the system's error (errno). Throws
/// LimitReached if too many files are open, because this is not an error of the file; otherwise BadFile.
[[noreturn]] void cannot_open(const std::string& path, int error);

}  // namespace robochart::storage
