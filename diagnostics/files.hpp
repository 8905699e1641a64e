// Finding files, so that none is passed over in silence; and writing files so that nothing else is written, and nothing
// is left half done: under a name that nobody can foresee, then put in its place as a whole. Below a folder that was
// asked for, no symbolic link is followed.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/budget.hpp"

namespace robochart::diagnostics {

/// The files of a folder by path, and the folders in it that cannot be read, each with the cause. What begins with a
/// dot is left out, and no link to a folder is followed.
struct FilesBelow {
    std::vector<std::string> files;
    std::vector<std::pair<std::string, std::string>> unreadable;
};
/// `deep`: with all folders below it.
[[nodiscard]] FilesBelow files_below(const std::string& folder, bool deep);

/// All of standard input; where it cannot be read to its end, or is longer than `most` bytes, `error` has the cause.
[[nodiscard]] std::string standard_input(std::size_t most, std::string& error);

/// Writes a file below `root`, which is made if it is not there, and the folders above it. What stands at the place is
/// replaced, also a link. `relative` leads nowhere else: an absolute path, "..", or a folder that is a link is refused.
/// Returns the cause in words on failure, "" on success.
[[nodiscard]] std::string write_below(const std::string& root, const std::string& relative, std::string_view text,
                                      Budget* budget = nullptr);
/// The same for a path that the user named as a whole: a link to a file stays one, and the file it leads to is
/// replaced. With an existing file's permissions, and on the disk before the old one is gone.
[[nodiscard]] std::string replace_file(const std::string& path, std::string_view text, Budget* budget = nullptr);
/// Whether a file in a folder has the name that both give to what is not yet in its place: where a run was killed, it
/// stays.
[[nodiscard]] bool is_unfinished(const std::string& name);

/// A folder of one's own with an unpredictable name, which nobody else may look into; removed with the object.
class TemporaryFolder {
public:
    /// In `parent`; "": where temporary files go (TMPDIR). Where it cannot be made, `error` has the cause, and `path`
    /// is empty.
    TemporaryFolder(const std::string& parent, std::string& error, Budget* budget = nullptr);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const std::string& path() const { return path_; }

private:
    std::string path_;
    Budget::Held held_;
};

/// A file below a folder that is written bit by bit, and is moved to its place when it is finished.
class GrowingFile {
public:
    GrowingFile(std::string root, std::string relative, Budget* budget = nullptr);
    ~GrowingFile();
    GrowingFile(const GrowingFile&) = delete;
    GrowingFile& operator=(const GrowingFile&) = delete;

    /// Returns the cause in words on failure, "" on success; after a failure nothing more is written.
    [[nodiscard]] std::string append(std::string_view text);
    /// Puts the file in its place.
    [[nodiscard]] std::string finish();

private:
    std::string root_, relative_;
    Budget* budget_;
    std::string temporary_;  ///< path of what is there so far; "" : nothing
    std::unique_ptr<Budget::Held> held_;
    std::string error_;
};

}  // namespace robochart::diagnostics
