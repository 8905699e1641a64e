// SPDX-License-Identifier: Apache-2.0
// The verb `init`: creates a project that verifies without changes. An existing model is never changed.
#include "app/verbs/init.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/command/output.hpp"
#include "app/command/run.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/text.hpp"
#include "checker/cspm/syntax/lexer.hpp"
#include "csp_emit/base/names.hpp"
#include "frontend/syntax/lexer.hpp"

namespace robochart::app {
namespace {

namespace fs = std::filesystem;

/// The longest name of a project. File names contain it, so it is much shorter than the limit of file systems.
constexpr std::size_t longest_name = 64;

/// A file to write. If `keep` is true, an existing file is not replaced.
struct NewFile {
    std::string name;
    std::string text;
    bool keep = false;
};

/// True for an ASCII letter or digit.
bool is_plain(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// True for a reserved word of CSPM. A package must not have such a name, because claims in CSP begin with it.
bool is_word_of_cspm(const std::string& name) {
    diagnostics::Diagnostics ignored;
    return cspm::lex(name, diagnostics::SourceId::none, ignored).front().kind != cspm::Tok::identifier;
}

/// Returns the reason why the text cannot be the name of a package; "" if it can.
std::string reason_unfit(const std::string& name) {
    const auto fits = [](char c) { return is_plain(c) || c == '_'; };
    if (name.size() > longest_name) return fmt::format("it has more than {} characters", longest_name);
    if (name.empty() || !std::ranges::all_of(name, fits) || std::isalpha(static_cast<unsigned char>(name.front())) == 0)
        return "a name is made of letters, digits and _, and begins with a letter";
    if (frontend::is_reserved(name)) return "it is a reserved word of RoboChart";
    if (is_word_of_cspm(name)) return "it is a reserved word of CSPM";
    const std::string block = fmt::format(" csp {} csp-begin", name);
    const bool is_block = template_text("model.assertions").find(block) != std::string_view::npos;
    return is_block ? "the csp block of a new project is called so" : "";
}

/// Returns a valid name made from the given text; "" if no character is left.
std::string made_fit(const std::string& name) {
    const fs::path file(name);
    std::string fit;
    for (const char c : file.extension() == ".rct" ? file.stem().string() : name) {
        if (is_plain(c))
            fit += c;
        else if (!fit.empty() && fit.back() != '_')
            fit += '_';
    }
    constexpr std::string_view added = "robot_";
    fit.resize(std::min(fit.size(), longest_name - added.size()));
    while (!fit.empty() && fit.back() == '_') fit.pop_back();
    if (fit.empty()) return "";
    return reason_unfit(fit).empty() ? fit : std::string(added) + fit;
}

std::vector<NewFile> files_of(const std::string& name, const Options& options) {
    std::string commands;
    if (options.init.simulation)
        commands += fmt::format("robochart-verify simulate {}.scenario  # the controller in a simulated arena\n", name);
    if (options.init.ros2)
        commands +=
            fmt::format("robochart-verify emit cpp . --target ros2 --mapping {}.ros2  # a package for ROS 2\n", name);
    const auto text = [&](std::string_view path) {
        return diagnostics::fill_template(template_text(path), {{"COMMANDS", commands}, {"NAME", name}});
    };
    // If the name of a package has a meaning in CSPM, scripts rename the package, and claims about it are not decided.
    const std::string claims = csp_emit::is_reserved(name) ? "unit 0.1 s\n" : text("model.claims");
    std::vector<NewFile> files{{name + ".rct", text("model.rct")},
                               {name + ".assertions", text("model.assertions")},
                               {name + ".claims", claims}};
    if (options.init.simulation) files.push_back({name + ".scenario", text("model.scenario")});
    if (options.init.ros2) files.push_back({name + ".ros2", text("model.ros2")});
    files.push_back({"README.md", text("README.md"), true});
    files.push_back({".gitignore", text("gitignore"), true});
    return files;
}

/// Returns the existing files in the folder that conflict with a new project; "" if there are none.
std::string in_the_way(const fs::path& folder, const std::vector<NewFile>& files) {
    std::error_code code;
    if (fs::exists(folder, code) && !fs::is_directory(folder, code))
        return fmt::format("{} is there already, and is no folder", folder.string());
    for (const NewFile& file : files)
        if (!file.keep && fs::exists(fs::symlink_status(folder / file.name, code)))
            return fmt::format("{} is there already", (folder / file.name).string());
    for (const std::string& path : diagnostics::files_below(folder.string(), false).files)
        if (fs::path(path).extension() == ".rct") return fmt::format("there is a model already: {}", path);
    return "";
}

Exit report_refusal(const std::string& why) {
    print_error("robochart-verify: {}; nothing is written\n", why);
    return Exit::bad_input;
}

/// Returns false, with a message, if a file cannot be written.
bool write(const fs::path& folder, const std::vector<NewFile>& files, const Options& options) {
    for (const NewFile& file : files) {
        options.run->budget().poll();
        const std::string path = (folder / file.name).string();
        std::error_code code;
        if (file.keep && fs::exists(fs::symlink_status(folder / file.name, code))) {
            print("{} is left as it is\n", path);
            continue;
        }
        const std::string error =
            diagnostics::write_below(folder.string(), file.name, file.text, &options.run->budget());
        if (!error.empty()) {
            print_error("robochart-verify: {}\n", error);
            return false;
        }
        print("{}\n", path);
    }
    return true;
}

/// Returns the project's name: the name on the command line, otherwise a valid name made from the name of the folder.
std::string name_of(const std::string& last, const fs::path& folder, const Options& options) {
    const std::string why = reason_unfit(last);
    if (why.empty()) return last;
    const std::string meant = made_fit(last);
    if (options.load.inputs.empty() && !meant.empty()) return meant;
    const fs::path above = (folder.filename().empty() ? folder.parent_path() : folder).parent_path();
    const std::string instead =
        meant.empty() ? std::string() : fmt::format("; did you mean '{}'?", (above / meant).string());
    throw UsageError(fmt::format("'{}' cannot be the name of a project: {}{}", last, why, instead));
}

}  // namespace

Exit run_init(const Options& options) {
    if (options.load.inputs.size() > 1) throw UsageError("init makes one project, so it takes one NAME");
    const std::string given = options.load.inputs.empty() ? "." : options.load.inputs.front();
    std::error_code code;
    const fs::path whole = fs::absolute(given, code).lexically_normal();
    const std::string last = (whole.filename().empty() ? whole.parent_path() : whole).filename().string();
    const fs::path folder = fs::path(given).lexically_normal();
    const std::string name = name_of(last, folder, options);
    const std::vector<NewFile> files = files_of(name, options);
    if (const std::string why = in_the_way(folder, files); !why.empty()) return report_refusal(why);
    if (!write(folder, files, options)) return Exit::bad_input;
    print("\nnext: robochart-verify {}\n", folder.string());
    return Exit::success;
}

}  // namespace robochart::app
