// SPDX-License-Identifier: Apache-2.0
// Finds files and reports those that cannot be read. Also writes files safely: a file first gets an unpredictable name
// and is moved to its place when it is complete. Below a given folder, no symbolic link is followed.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostics/budget.hpp"

namespace robochart::diagnostics {

/// The files below a folder, by path, and the subfolders that cannot be read, with the reasons. Skips names that begin
/// with a dot. Does not follow links to folders.
struct FilesBelow {
    std::vector<std::string> files;
    std::vector<std::pair<std::string, std::string>> unreadable;
};
/// Lists the files of a folder. `deep`: whether all subfolders are included.
[[nodiscard]] FilesBelow files_below(const std::string& folder, bool deep);

/// Returns all of standard input. If it cannot be read to its end, or is longer than `most` bytes, `error` contains the
/// cause.
[[nodiscard]] std::string standard_input(std::size_t most, std::string& error);

/// Writes a file below `root`, and creates `root` and the folders in between if they do not exist. An existing file or
/// link is replaced. `relative` must stay below `root`: an absolute path, "..", or a folder that is a link is rejected.
/// Returns "" on success, and the cause of the failure otherwise.
[[nodiscard]] std::string write_below(const std::string& root, const std::string& relative, std::string_view text,
                                      Budget* budget = nullptr);
/// Writes a file at a path given by the user. If the path is a link to a file, the link is not changed, and the file to
/// which it points is replaced. The new file has the permissions of the existing file. It is on the disk before the old
/// file is removed.
[[nodiscard]] std::string replace_file(const std::string& path, std::string_view text, Budget* budget = nullptr);
/// Returns true if the name has the form that these two functions use for incomplete files. Such a file remains if the
/// run is killed.
[[nodiscard]] bool is_unfinished(const std::string& name);

/// A temporary folder with an unpredictable name, which only this user can access. The destructor removes it.
class TemporaryFolder {
public:
    /// Creates the folder in `parent`, or in the folder for temporary files (TMPDIR) if `parent` is "". On failure,
    /// `error` contains the cause and `path` is empty.
    TemporaryFolder(const std::string& parent, std::string& error, Budget* budget = nullptr);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const std::string& path() const { return path_; }

private:
    std::string path_;
    Budget::Held held_;
};

/// Writes a file below a folder piece by piece, and moves it to its place when it is complete.
class GrowingFile {
public:
    GrowingFile(std::string root, std::string relative, Budget* budget = nullptr);
    ~GrowingFile();
    GrowingFile(const GrowingFile&) = delete;
    GrowingFile& operator=(const GrowingFile&) = delete;

    /// Appends text. Returns "" on success, and the cause of the failure otherwise. After a failure, later calls write
    /// no data.
    [[nodiscard]] std::string append(std::string_view text);
    /// Moves the file to its place.
    [[nodiscard]] std::string finish();

private:
    std::string root_, relative_;
    Budget* budget_;
    std::string temporary_;  ///< path of the incomplete file, or ""
    std::unique_ptr<Budget::Held> held_;
    std::string error_;
};

}  // namespace robochart::diagnostics
