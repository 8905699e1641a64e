// SPDX-License-Identifier: Apache-2.0
// Compiles generated sources with the system's compiler and loads them into this process.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/cache/cache.hpp"
#include "base/diagnostics/files.hpp"
#include "cpp_emit/plan/options.hpp"

namespace robochart::cpp_emit {

struct BuildOptions {
    std::string compiler = "c++";           ///< found through PATH; must accept g++'s options
    std::string flags;                      ///< separated by blanks
    std::string work_dir;                   ///< "": a new temporary folder, deleted with the object
    diagnostics::Budget* budget = nullptr;  ///< budget of the run; the compiler is killed if a limit is reached
    diagnostics::Cache* cache = nullptr;    ///< cache of objects that earlier runs have compiled from the same files
};

/// Thrown if no compiler can be run. In this case, the failure tells nothing about the code.
class NoCompiler : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Returns the command that compiles these sources into the shared object `target`, if it is run in the folder of the
/// files. It omits options that only concern warnings. Its words are separated by blanks; no name may contain a blank.
[[nodiscard]] std::string build_command(const BuildOptions&, const std::vector<std::string>& sources,
                                        const std::string& target);

/// A loaded shared object. Its code runs in this process, so only code that this toolkit or its tests wrote may be
/// loaded.
class SharedLibrary {
public:
    /// Writes `files` below the work folder, compiles `sources` (paths as in `files`) into one shared object and loads
    /// it. If this fails, returns null, and `error` contains the cause and the compiler's output if there is any.
    /// Throws diagnostics::LimitReached and NoCompiler.
    static std::unique_ptr<SharedLibrary> build(const std::vector<OutputFile>& files,
                                                const std::vector<std::string>& sources, const BuildOptions&,
                                                std::string& error);
    ~SharedLibrary();
    SharedLibrary(const SharedLibrary&) = delete;
    SharedLibrary& operator=(const SharedLibrary&) = delete;

    /// Returns the address of an exported function, or null if there is none with this name.
    [[nodiscard]] void* find_symbol(const char* name) const;

private:
    SharedLibrary() = default;
    [[nodiscard]] bool load_library(std::string& error);

    std::unique_ptr<diagnostics::TemporaryFolder> temporary_;
    std::string folder_;
    std::string path_;
    void* handle_ = nullptr;
};

}  // namespace robochart::cpp_emit
