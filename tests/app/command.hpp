// SPDX-License-Identifier: Apache-2.0
// Runs the real command as a user would.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/temporary_folder.hpp"

namespace robochart::app::testing {

struct Ran {
    int exit = -1;  ///< exit code; 128+n if killed by signal n
    std::string out;
    std::string err;
};

/// Runs robochart-verify with these arguments and this standard input in an empty temporary folder.
[[nodiscard]] Ran run(const std::vector<std::string>& arguments, const std::string& input = "");

/// Waits before the signal is sent. `ended` returns true once the command has ended.
using Wait = std::function<void(const std::function<bool()>& ended)>;
/// Like `run`, but sends the signal after `wait`, which by default takes 1.5 seconds.
[[nodiscard]] Ran run_and_signal(const std::vector<std::string>& arguments, int signal, const Wait& wait = {});
/// Like `run`, but limits the address space to `bytes` (RLIMIT_AS).
[[nodiscard]] Ran run_with_address_space(const std::vector<std::string>& arguments, std::uint64_t bytes);

/// Runs shell commands in an empty temporary folder. In them, "$verify" is the command.
[[nodiscard]] Ran run_shell(const std::string& commands);

/// A temporary folder with one file.
class TemporaryFile {
public:
    TemporaryFile(const std::string& name, const std::string& text);
    [[nodiscard]] const std::string& path() const { return path_; }

private:
    tests::TemporaryFolder folder_;
    std::string path_;
};

/// A temporary folder with these files.
class Folder {
public:
    explicit Folder(const std::vector<std::pair<std::string, std::string>>& files = {});
    /// Returns the path of a file in the folder (it need not exist), or of the folder itself if `name` is empty.
    [[nodiscard]] std::string path(const std::string& name = "") const {
        return name.empty() ? folder_.path() : folder_.in(name);
    }
    [[nodiscard]] std::string operator/(const std::string& name) const { return path(name); }

private:
    tests::TemporaryFolder folder_;
};

/// Returns the absolute path of a path inside the repository.
[[nodiscard]] std::string repository(const std::string& path);

}  // namespace robochart::app::testing
