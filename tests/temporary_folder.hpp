// SPDX-License-Identifier: Apache-2.0
// Provides temporary folders for tests. Tests run at the same time, so several of them would use a file with a fixed
// path.
#pragma once

#include <string>

namespace robochart::tests {

/// A new folder below the system's temporary folder. No other test has the same folder.
class TemporaryFolder {
public:
    /// Makes an empty folder. Throws std::runtime_error with the name of the folder if this fails.
    TemporaryFolder();
    /// Removes the folder and everything in it. Errors are ignored: a process that the test started may still write
    /// there.
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }
    /// Returns the path of a file below the folder. The file need not exist.
    [[nodiscard]] std::string in(const std::string& name) const;
    /// Writes a file below the folder and returns its path. Folders in between are created. An existing file is
    /// replaced. Throws std::runtime_error with the path of the file if this fails.
    std::string write(const std::string& name, const std::string& text) const;

private:
    std::string path_;
};

}  // namespace robochart::tests
