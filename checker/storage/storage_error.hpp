// SPDX-License-Identifier: Apache-2.0
// Defines the exceptions for files of a search that cannot be read or written.
#pragma once

#include <stdexcept>
#include <string>

#include "base/diagnostics/budget.hpp"

namespace robochart::storage {

/// Thrown if a given file is damaged or truncated, or does not belong to this search. The message contains the file,
/// the position in it and the cause.
class BadFile : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Thrown if a file cannot be written, because the disk is full or the folder cannot be used. It is handled like other
/// limits (LimitReached). Data that were written before are unchanged.
class CannotWrite : public diagnostics::LimitReached {
public:
    using diagnostics::LimitReached::LimitReached;
};

/// Throws an exception for a file that cannot be opened for reading. `error` is the error number of the system (errno).
/// Throws LimitReached if too many files are open, because the file itself is not at fault. Throws BadFile otherwise.
[[noreturn]] void cannot_open(const std::string& path, int error);

}  // namespace robochart::storage
