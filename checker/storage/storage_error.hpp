// What goes wrong with files of a search.
#pragma once

#include <stdexcept>
#include <string>

#include "diagnostics/budget.hpp"

namespace robochart::storage {

/// A file that was given is not what it should be: damaged, cut off, or of something else. The message has the file,
/// the place in it, and the cause.
class BadFile : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A file cannot be written: the disk is full, or the folder cannot be used. A limit as others: what was written before
/// stays as it was.
class CannotWrite : public diagnostics::LimitReached {
public:
    using diagnostics::LimitReached::LimitReached;
};

/// Of a file that cannot be opened for reading, with the error of the system (errno). Throws LimitReached where too
/// many files are open, which says nothing of the file, and else BadFile.
[[noreturn]] void cannot_open(const std::string& path, int error);

}  // namespace robochart::storage
