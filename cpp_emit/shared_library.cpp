// Compiling and loading; see shared_library.hpp. The flags keep two loaded controllers apart: each symbol stays in
// its own object (hidden visibility, RTLD_LOCAL), and inline variables are not made unique across objects
// (-fno-gnu-unique): otherwise one controller would run with the other's tables and every comparison would agree.
#include "cpp_emit/shared_library.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

extern char** environ;

namespace robochart::cpp_emit {

namespace fs = std::filesystem;

namespace {

/// Starts the program, as the leader of a process group if it may have to be ended with all that it starts. Returns 0
/// with `error` set where it cannot.
pid_t start(const std::vector<std::string>& command, const std::string& log, bool leader, std::string& error) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    if (leader) posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    pid_t child = 0;
    const int spawned = posix_spawnp(&child, arguments.front(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (spawned == 0) return child;
    error = fmt::format("cannot run {}: {}", command.front(), std::strerror(spawned));
    return 0;
}

/// Ends the program's process group as soon as `interrupted` says so; true if it did.
bool ended_early(pid_t child, const std::function<bool()>& interrupted) {
    siginfo_t ended{};
    const auto running = [&] {
        return waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == 0;
    };
    for (; running(); std::this_thread::sleep_for(std::chrono::milliseconds(20))) {
        if (!interrupted()) continue;
        kill(-child, SIGTERM);
        return true;
    }
    return false;
}

}  // namespace

int run_program(const std::vector<std::string>& command, const std::string& log, std::string& error,
                const std::function<bool()>& interrupted) {
    const pid_t child = start(command, log, interrupted != nullptr, error);
    if (child == 0) return -1;
    const bool early = interrupted && ended_early(child, interrupted);
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno == EINTR) continue;
        error = fmt::format("lost {}: {}", command.front(), std::strerror(errno));
        return -1;
    }
    if (early) error = fmt::format("{} was interrupted", command.front());
    if (early) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

namespace {

std::string make_folder(const std::string& parent, std::string& error) {
    std::string name = (fs::path(parent) / "robochart-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) return name;
    error = fmt::format("cannot make a folder in {}: {}", parent, std::strerror(errno));
    return "";
}

bool inside(const fs::path& relative) {
    if (relative.empty() || relative.is_absolute()) return false;
    for (const fs::path& part : relative) {
        if (part == "..") return false;
    }
    return true;
}

bool write_file(const fs::path& folder, const OutputFile& file, std::string& error) {
    if (!inside(file.path)) {
        error = fmt::format("refusing to write outside the work folder: {}", file.path);
        return false;
    }
    const fs::path path = folder / file.path;
    std::error_code failed;
    fs::create_directories(path.parent_path(), failed);
    std::ofstream out(path, std::ios::binary);
    out << file.text;
    out.close();
    if (out) return true;
    error = fmt::format("cannot write {}: {}", path.string(), std::strerror(errno));
    return false;
}

std::string read_file(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<std::string> words(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> found;
    for (std::string word; in >> word;) found.push_back(word);
    return found;
}

std::vector<std::string> command_line(const BuildOptions& options, const fs::path& folder,
                                      const std::vector<std::string>& sources, const std::string& target) {
    std::vector<std::string> command{options.compiler};
    for (std::string& flag : words(options.flags)) command.push_back(std::move(flag));
    command.insert(command.end(), {"-shared", "-fPIC", "-fvisibility=hidden", "-I", folder.string(), "-o", target});
    // Absolute: a compiler takes "-x" and "@x" for something else than a file.
    for (const std::string& source : sources) command.push_back(fs::absolute(folder / source).string());
    return command;
}

bool compile(const BuildOptions& options, const fs::path& folder, const std::vector<std::string>& sources,
             const std::string& target, std::string& error) {
    std::vector<std::string> command = command_line(options, folder, sources, target);
    command.insert(command.begin() + 1, "-fno-gnu-unique");
    const std::string log = target + ".log";
    int status = run_program(command, log, error, options.interrupted);
    std::string said = read_file(log);
    if (status > 0 && said.find("no-gnu-unique") != std::string::npos) {
        command.erase(command.begin() + 1);  // clang knows no unique symbols and no such option
        status = run_program(command, log, error, options.interrupted);
        said = read_file(log);
    }
    std::error_code ignored;
    fs::remove(log, ignored);
    if (status > 0) error = fmt::format("{} failed with status {}:\n{}", options.compiler, status, said);
    return status == 0;
}

/// Each build gets a name of its own: the loader would take a loaded object of the same name for the new one.
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

std::unique_ptr<SharedLibrary> SharedLibrary::build(const std::vector<OutputFile>& files,
                                                    const std::vector<std::string>& sources,
                                                    const BuildOptions& options, std::string& error) {
    std::unique_ptr<SharedLibrary> object(new SharedLibrary);
    std::error_code failed;
    object->temporary_ = options.work_dir.empty();
    if (object->temporary_) {
        object->folder_ = make_folder(fs::temp_directory_path(failed).string(), error);
        if (object->folder_.empty()) return nullptr;
    } else {
        object->folder_ = options.work_dir;
        fs::create_directories(object->folder_, failed);
    }
    for (const OutputFile& file : files) {
        if (!write_file(object->folder_, file, error)) return nullptr;
    }
    object->path_ = object_name(object->folder_, error);
    if (object->path_.empty() || !compile(options, object->folder_, sources, object->path_, error) ||
        !object->load(error))
        return nullptr;
    return object;
}

bool SharedLibrary::load(std::string& error) {
    handle_ = dlopen(fs::absolute(path_).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ == nullptr) error = fmt::format("cannot load the generated code: {}", dlerror());
    return handle_ != nullptr;
}

void* SharedLibrary::symbol(const char* name) const {
    return dlsym(handle_, name);
}

SharedLibrary::~SharedLibrary() {
    if (handle_ != nullptr) dlclose(handle_);
    std::error_code ignored;
    if (temporary_)
        fs::remove_all(folder_, ignored);
    else if (!path_.empty())
        fs::remove(path_, ignored);
}

}  // namespace robochart::cpp_emit
