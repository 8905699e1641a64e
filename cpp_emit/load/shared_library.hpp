// Generated sources, compiled by the system's compiler and loaded into this process.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cpp_emit/plan/options.hpp"
#include "diagnostics/cache/cache.hpp"
#include "diagnostics/files.hpp"

namespace robochart::cpp_emit {

struct BuildOptions {
    std::string compiler = "c++";           ///< found through PATH; must accept g++'s options
    std::string flags;                      ///< separated by blanks
    std::string work_dir;                   ///< "": a fresh temporary folder, removed with the object
    diagnostics::Budget* budget = nullptr;  ///< of the run; the compiler is ended where a limit is reached
    diagnostics::Cache* cache = nullptr;    ///< of objects that earlier runs have compiled from the same files
};

/// Runs a program found through PATH, its output and errors going to the file `log`. Returns its exit status; -1 with
/// `error` set where it cannot be run. Where the budget, polled 50 times a second, has a limit reached, the program
/// and all that it has started are ended, and diagnostics::LimitReached is thrown.
int run_program(const std::vector<std::string>& command, const std::string& log, std::string& error,
                diagnostics::Budget* budget = nullptr);

/// There is no compiler to run: that says nothing about the code.
class NoCompiler : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A loaded shared object. Its code runs in this process: load only what this toolkit generated or tests wrote.
class SharedLibrary {
public:
    /// Writes `files` below the work folder, compiles `sources` (paths as in `files`) into one shared object and
    /// loads it. On failure returns nothing and sets `error` to the cause, with the compiler's words if it spoke.
    /// Throws diagnostics::LimitReached, and NoCompiler.
    static std::unique_ptr<SharedLibrary> build(const std::vector<OutputFile>& files,
                                                const std::vector<std::string>& sources, const BuildOptions&,
                                                std::string& error);
    ~SharedLibrary();
    SharedLibrary(const SharedLibrary&) = delete;
    SharedLibrary& operator=(const SharedLibrary&) = delete;

    /// The address of an exported function; null if there is none of the name.
    [[nodiscard]] void* symbol(const char* name) const;

private:
    SharedLibrary() = default;
    [[nodiscard]] bool load(std::string& error);

    std::unique_ptr<diagnostics::TemporaryFolder> temporary_;
    std::string folder_;
    std::string path_;
    void* handle_ = nullptr;
};

}  // namespace robochart::cpp_emit
