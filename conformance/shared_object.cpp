// Compiling and loading; see shared_object.hpp. The flags keep two loaded controllers apart: each symbol stays in
// its own object (hidden visibility, RTLD_LOCAL), and inline variables are not made unique across objects
// (-fno-gnu-unique): otherwise one controller would run with the other's tables and every comparison would agree.
#include "conformance/shared_object.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

extern char** environ;

namespace robochart::conformance {

namespace fs = std::filesystem;

namespace {

/// Words of an interface larger than this are taken for garbage.
constexpr std::uint32_t sane_count = 1U << 20U;

std::string make_folder(const std::string& parent, std::string& error) {
    std::string name = (fs::path(parent) / "robochart-conform-XXXXXX").string();
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

bool write_file(const fs::path& folder, const cpp_emit::OutputFile& file, std::string& error) {
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

/// Runs a program with output and errors going to `log`. Returns its exit status, or -1 with `error` set.
int run(const std::vector<std::string>& command, const std::string& log, std::string& error) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    pid_t child = 0;
    const int spawned = posix_spawnp(&child, arguments.front(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (spawned != 0) {
        error = fmt::format("cannot run {}: {}", command.front(), std::strerror(spawned));
        return -1;
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno == EINTR) continue;
        error = fmt::format("lost {}: {}", command.front(), std::strerror(errno));
        return -1;
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::vector<std::string> command_line(const BuildOptions& options, const fs::path& folder,
                                      const std::vector<std::string>& sources, const std::string& target) {
    std::vector<std::string> command{options.compiler};
    for (std::string& flag : words(options.flags)) command.push_back(std::move(flag));
    command.insert(command.end(), {"-shared", "-fPIC", "-fvisibility=hidden", "-I", folder.string(), "-o", target});
    for (const std::string& source : sources) command.push_back((folder / source).string());
    return command;
}

bool compile(const BuildOptions& options, const fs::path& folder, const std::vector<std::string>& sources,
             const std::string& target, std::string& error) {
    std::vector<std::string> command = command_line(options, folder, sources, target);
    command.insert(command.begin() + 1, "-fno-gnu-unique");
    const std::string log = target + ".log";
    int status = run(command, log, error);
    std::string said = read_file(log);
    if (status > 0 && said.find("no-gnu-unique") != std::string::npos) {
        command.erase(command.begin() + 1);  // clang knows no unique symbols and no such option
        status = run(command, log, error);
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

std::string input_fault(const rc_input& input) {
    if (input.name == nullptr) return "an input has no name";
    if (input.values > sane_count) return fmt::format("input {} has too many values", input.name);
    if (input.values == 0) return "";
    if (input.value == nullptr || input.text == nullptr) return fmt::format("input {} has no values", input.name);
    for (std::uint32_t v = 0; v < input.values; ++v) {
        if (input.text[v] == nullptr) return fmt::format("input {} has a value without text", input.name);
    }
    return "";
}

std::string output_fault(const rc_output& output) {
    if (output.name == nullptr) return "an output has no name";
    if (output.arguments > ROBOCHART_MAX_ARGUMENTS) return fmt::format("output {} has too many arguments", output.name);
    return "";
}

}  // namespace

std::string interface_fault(const rc_interface& interface) {
    if (interface.abi_version != ROBOCHART_ABI_VERSION)
        return fmt::format("interface version {} where {} is needed", interface.abi_version, ROBOCHART_ABI_VERSION);
    if (interface.initial == nullptr || interface.step == nullptr || interface.print == nullptr)
        return "a function of the interface is missing";
    if (interface.state_size > sane_count) return fmt::format("a state of {} bytes", interface.state_size);
    if (interface.inputs > sane_count || (interface.inputs > 0 && interface.input == nullptr))
        return "the inputs are missing";
    if (interface.outputs > sane_count || (interface.outputs > 0 && interface.output == nullptr))
        return "the outputs are missing";
    if (interface.scale < 1) return fmt::format("a scale of {}", interface.scale);
    std::string fault;
    for (std::uint32_t i = 0; fault.empty() && i < interface.inputs; ++i) fault = input_fault(interface.input[i]);
    for (std::uint32_t o = 0; fault.empty() && o < interface.outputs; ++o) fault = output_fault(interface.output[o]);
    return fault;
}

std::unique_ptr<SharedObject> SharedObject::build(const std::vector<cpp_emit::OutputFile>& files,
                                                  const std::vector<std::string>& sources, const BuildOptions& options,
                                                  std::string& error) {
    std::unique_ptr<SharedObject> object(new SharedObject);
    std::error_code failed;
    object->temporary_ = options.work_dir.empty();
    if (object->temporary_) {
        object->folder_ = make_folder(fs::temp_directory_path(failed).string(), error);
        if (object->folder_.empty()) return nullptr;
    } else {
        object->folder_ = options.work_dir;
        fs::create_directories(object->folder_, failed);
    }
    for (const cpp_emit::OutputFile& file : files) {
        if (!write_file(object->folder_, file, error)) return nullptr;
    }
    object->path_ = object_name(object->folder_, error);
    if (object->path_.empty() || !compile(options, object->folder_, sources, object->path_, error) ||
        !object->load(error))
        return nullptr;
    return object;
}

bool SharedObject::load(std::string& error) {
    handle_ = dlopen(fs::absolute(path_).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ == nullptr) {
        error = fmt::format("cannot load the generated code: {}", dlerror());
        return false;
    }
    void* const symbol = dlsym(handle_, "robochart_explore");
    if (symbol == nullptr) {
        error = fmt::format("the generated code has no exploration interface: {}", dlerror());
        return false;
    }
    interface_ = reinterpret_cast<const rc_interface* (*)()>(symbol)();
    error = interface_ == nullptr ? "it is null" : interface_fault(*interface_);
    if (error.empty()) return true;
    error = "the exploration interface cannot be used: " + error;
    return false;
}

SharedObject::~SharedObject() {
    if (handle_ != nullptr) dlclose(handle_);
    std::error_code ignored;
    if (temporary_)
        fs::remove_all(folder_, ignored);
    else if (!path_.empty())
        fs::remove(path_, ignored);
}

}  // namespace robochart::conformance
