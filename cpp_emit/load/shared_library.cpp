// SPDX-License-Identifier: Apache-2.0
// Compiles and loads code; see shared_library.hpp. The flags separate two loaded controllers: each symbol is local to
// its object (hidden visibility, RTLD_LOCAL), and inline variables are not merged across objects (-fno-gnu-unique).
// Otherwise one controller would use the tables of the other one, and every comparison would succeed.
#include "cpp_emit/load/shared_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "base/diagnostics/programs.hpp"

namespace robochart::cpp_emit {

namespace fs = std::filesystem;

namespace {

std::string read_file(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<std::string> split_words(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> found;
    for (std::string word; in >> word;) found.push_back(word);
    return found;
}

constexpr std::array<const char*, 3> object_options{"-shared", "-fPIC", "-fvisibility=hidden"};

std::vector<std::string> command_line(const BuildOptions& options, const fs::path& folder,
                                      const std::vector<std::string>& sources, const std::string& target) {
    std::vector<std::string> command{options.compiler};
    for (std::string& flag : split_words(options.flags)) command.push_back(std::move(flag));
    command.insert(command.end(), object_options.begin(), object_options.end());
    command.insert(command.end(), {"-I", folder.string(), "-o", target});
    // The paths are absolute, because a compiler does not accept "-x" and "@x" as file names.
    for (const std::string& source : sources) command.push_back(fs::absolute(folder / source).string());
    return command;
}

/// Returns whether the compiler ran out of memory. In that case its failure tells nothing about the code.
bool lacked_memory(const std::string& output) {
    const auto says = [&](const char* words) { return output.find(words) != std::string::npos; };
    return says("memory exhausted") || says("out of memory") || says("annot allocate memory") ||
           says("Killed signal") || says("std::bad_alloc");
}

bool compile_sources(const BuildOptions& options, const fs::path& folder, const std::vector<std::string>& sources,
                     const std::string& target, std::string& error) {
    std::vector<std::string> command = command_line(options, folder, sources, target);
    command.insert(command.begin() + 1, "-fno-gnu-unique");
    const std::string log = target + ".log";
    int status = diagnostics::run_program(command, log, error, options.budget);
    std::string output = read_file(log);
    if (status > 0 && output.find("no-gnu-unique") != std::string::npos) {
        command.erase(command.begin() + 1);  // clang has no unique symbols and does not know this option
        status = diagnostics::run_program(command, log, error, options.budget);
        output = read_file(log);
    }
    std::error_code ignored;
    fs::remove(log, ignored);
    if (status < 0)
        throw NoCompiler(
            fmt::format("{}: a C++ compiler is needed here; on Debian, `apt install g++` installs one", error));
    if (status > 0 && lacked_memory(output))
        throw diagnostics::LimitReached(fmt::format("{} was given no more memory", options.compiler));
    if (status > 0) error = fmt::format("{} failed with status {}:\n{}", options.compiler, status, output);
    return status == 0;
}

/// Returns the inputs of a compilation other than its command line: the identity of the compiler (its version text and
/// its file), and the folders that the environment adds to its search path. Returns no value if the compiler does not
/// answer.
std::optional<std::string> compiler_identity(const BuildOptions& options, const fs::path& folder) {
    std::string error;
    const std::string log = (folder / "version.log").string();
    if (diagnostics::run_program({options.compiler, "--version"}, log, error, options.budget) != 0) return std::nullopt;
    std::string identity = read_file(log);
    std::error_code ignored;
    fs::remove(log, ignored);
    for (const char* variable : {"CPATH", "CPLUS_INCLUDE_PATH", "LIBRARY_PATH", "COMPILER_PATH", "GCC_EXEC_PREFIX"})
        if (const char* const value = std::getenv(variable)) identity += fmt::format("{}={}\n", variable, value);
    return identity;
}

/// Returns a key for the cache. Equal keys mean that files and compilers produce the same object.
std::optional<diagnostics::Digest> key_of(const std::vector<OutputFile>& files, const std::vector<std::string>& sources,
                                          const BuildOptions& options, const fs::path& folder) {
    if (options.cache == nullptr) return std::nullopt;
    const auto identity = compiler_identity(options, folder);
    if (!identity) return std::nullopt;
    diagnostics::Hasher hasher;
    for (const std::string& part : {std::string("object"), options.compiler, options.flags, *identity})
        hasher.add(std::string_view(part));
    hasher.add(sources.size());
    for (const std::string& source : sources) hasher.add(std::string_view(source));
    for (const OutputFile& file : files) {
        hasher.add(std::string_view(file.path));
        hasher.add(std::string_view(file.text));
    }
    return hasher.finish();
}

/// Copies an object that an earlier run has compiled to `path`. Returns false if the cache has no such object.
bool restore_object(const std::optional<diagnostics::Digest>& key, const BuildOptions& options,
                    const std::string& path) {
    if (!key) return false;
    const auto object = options.cache->find(*key);
    if (!object) return false;
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    return out.write(object->data(), static_cast<std::streamsize>(object->size())).flush().good();
}

/// Returns a unique name for each build, because the loader would return a loaded object with the same name.
std::string object_name(const fs::path& folder, std::string& error) {
    std::string name = (folder / "controller-XXXXXX.so").string();
    const int file = mkstemps(name.data(), 3);
    if (file < 0) {
        error = fmt::format("cannot write in {}: {}", folder.string(), std::strerror(errno));
        return "";
    }
    close(file);
    return name;
}

}  // namespace

std::string build_command(const BuildOptions& options, const std::vector<std::string>& sources,
                          const std::string& target) {
    std::vector<std::string> words{options.compiler};
    for (std::string& flag : split_words(options.flags))
        if (!flag.starts_with("-W")) words.push_back(std::move(flag));
    words.insert(words.end(), object_options.begin(), object_options.end());
    words.insert(words.end(), {"-I", ".", "-o", target});
    words.insert(words.end(), sources.begin(), sources.end());
    assert(std::ranges::none_of(words, [](const std::string& word) { return word.find(' ') != std::string::npos; }));
    return fmt::format("{}", fmt::join(words, " "));
}

std::unique_ptr<SharedLibrary> SharedLibrary::build(const std::vector<OutputFile>& files,
                                                    const std::vector<std::string>& sources,
                                                    const BuildOptions& options, std::string& error) {
    std::unique_ptr<SharedLibrary> object(new SharedLibrary);
    std::error_code failed;
    object->folder_ = options.work_dir;
    if (options.work_dir.empty()) {
        object->temporary_ = std::make_unique<diagnostics::TemporaryFolder>("", error, options.budget);
        object->folder_ = object->temporary_->path();
        if (object->folder_.empty()) return nullptr;
    } else {
        fs::create_directories(object->folder_, failed);
    }
    for (const OutputFile& file : files) {
        error = diagnostics::write_below(object->folder_, file.path, file.text);
        if (!error.empty()) return nullptr;
    }
    object->path_ = object_name(object->folder_, error);
    if (object->path_.empty()) return nullptr;
    const auto key = key_of(files, sources, options, object->folder_);
    if (!restore_object(key, options, object->path_)) {
        if (!compile_sources(options, object->folder_, sources, object->path_, error)) return nullptr;
        if (key) options.cache->store_entry(*key, read_file(object->path_));
    }
    if (!object->load_library(error)) return nullptr;
    return object;
}

bool SharedLibrary::load_library(std::string& error) {
    handle_ = dlopen(fs::absolute(path_).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ == nullptr) error = fmt::format("cannot load the generated code: {}", dlerror());
    return handle_ != nullptr;
}

void* SharedLibrary::find_symbol(const char* name) const {
    assert(handle_ != nullptr);
    return dlsym(handle_, name);
}

SharedLibrary::~SharedLibrary() {
    if (handle_ != nullptr) dlclose(handle_);
    std::error_code ignored;
    if (temporary_ == nullptr && !path_.empty()) fs::remove(path_, ignored);
}

}  // namespace robochart::cpp_emit
