// SPDX-License-Identifier: Apache-2.0
// Writes the files in the project of a target; see project.hpp.
#include "cpp_emit/project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/diagnostics/text.hpp"
#include "cpp_emit/api/python_module.hpp"
#include "cpp_emit/ros2/node_files.hpp"

namespace robochart::cpp_emit {

namespace {

bool only_explored(const std::string& path) {
    const auto ends = [&](std::string_view end) { return path.size() >= end.size() && path.ends_with(end); };
    return ends("_explore.cpp") || path == "robochart/finite.hpp" || path.starts_with("robochart/explore") ||
           path == "main.cpp" || path == "CMakeLists.txt";
}

/// Returns the start of a comment in a file with this name. Returns "" if a line above the file's text would change its
/// meaning.
std::string_view comment_mark(std::string_view path) {
    if (path.ends_with(".hpp") || path.ends_with(".cpp") || path.ends_with(".h")) return "// ";
    if (path.ends_with(".py") || path.ends_with(".cmake") || path.ends_with(".yaml") || path.ends_with(".txt"))
        return "# ";
    return "";
}

class ProjectMaker {
public:
    ProjectMaker(const Generation& generation, const Core& core, const ClassApi& api,
                 const std::vector<OutputFile>& controller, const std::optional<ros2::NodePlan>& node)
        : generation_(generation), core_(core), api_(api), node_(node) {
        for (const OutputFile& file : controller) {
            if (file.path == "main.cpp") console_ = file.text;
            if (only_explored(file.path)) continue;
            eigen_ = eigen_ || file.text.find("#include <Eigen/") != std::string::npos;
            files_.push_back({"controller/" + file.path, file.text});
        }
        keys_["CLASS"] = api.cpp_name;
        keys_["QUALIFIED"] = api.name_space + "::" + api.cpp_name;
        keys_["DEPENDENCIES"] = eigen_ ? "find_package(Eigen3 QUIET)\n" : "";
        const Target target = generation.options.target;
        keys_["TRACE"] = target == Target::library || target == Target::ros2 ? "OFF" : "ON";
        element_ = generation.component.kind + " " + generation.place_text(generation.component.origin);
        keys_["HEADERS"] = node ? node->package + "/controller" : api.cpp_name;
        keys_["CONTROLLER"] = controller_target();
    }

    std::vector<OutputFile> make_files() {
        switch (generation_.options.target) {
            case Target::sources:
                break;
            case Target::library:
                add_file("CMakeLists.txt", "library/CMakeLists.txt");
                add_file(api_.cpp_name + "Config.cmake", "library/config.cmake");
                break;
            case Target::main:
                add_file("CMakeLists.txt", "main/CMakeLists.txt");
                files_.push_back({"main.cpp", console_});
                break;
            case Target::ros2:
                ros2_package();
                break;
            case Target::enki:
                add_enki();
                break;
            case Target::argos:
                add_argos();
                break;
            case Target::python:
                add_file("CMakeLists.txt", "python/CMakeLists.txt");
                add_file("python_values.hpp", "python/python_values.hpp");
                files_.push_back({"module.cpp", python_module(generation_, core_, api_)});
                files_.push_back({"robot.py", python_robot(generation_, api_), true});
                break;
        }
        return std::move(files_);
    }

private:
    /// Adds a file. The name of the element appears in comments and, if the file is XML, in text.
    void add_file(const std::string& path, const std::string& text) {
        const bool xml = text.ends_with(".xml") || text.ends_with(".argos");
        keys_["ELEMENT"] = xml ? diagnostics::xml_text(element_) : diagnostics::comment_text(element_);
        files_.push_back({path, diagnostics::fill_template(project_template(text), keys_)});
    }

    std::string controller_target() {
        std::string text = diagnostics::fill_template(project_template("controller.cmake"), keys_);
        if (eigen_)
            text += fmt::format(
                "# For robochart/eigen.hpp, where the robot's code uses it.\nfind_package(Eigen3 QUIET)\n"
                "if(TARGET Eigen3::Eigen)\n  target_link_libraries({} PUBLIC Eigen3::Eigen)\nendif()\n",
                api_.cpp_name);
        return text;
    }

    /// Defines the texts that depend on the node: its package, its names, its messages.
    void message_keys() {
        keys_["PACKAGE"] = node_->package;
        keys_["NODE"] = node_->node;
        keys_["FILES"] = node_->files;
        const PackageFacts& facts = generation_.options.package;
        keys_["VERSION"] = facts.version;
        keys_["LICENSE"] = diagnostics::xml_text(facts.license.empty() ? "LicenseRef-undeclared" : facts.license);
        keys_["MAINTAINER"] = diagnostics::xml_text(facts.maintainer);
        keys_["EMAIL"] = diagnostics::xml_text(facts.email);
        for (const std::string& name : node_->packages) {
            keys_["MESSAGE_PACKAGES"] += " " + name;
            keys_["FIND_MESSAGES"] += fmt::format("find_package({} REQUIRED)\n", name);
            keys_["MESSAGE_TARGETS"] += fmt::format("\n                      ${{{}_TARGETS}}", name);
            keys_["DEPEND_MESSAGES"] += fmt::format("  <depend>{}</depend>\n", name);
        }
        keys_["CYCLE_TEXT"] = ros2::cycle_text(generation_.options);
        keys_["CYCLE"] = ros2::cycle_seconds(generation_.options);
        keys_["CYCLE_SCALE"] =
            generation_.options.unit
                ? "    # How many times as long as declared the time units of the model last. It must fit to `cycle`.\n"
                  "    cycle_scale: 1.0\n"
                : "";
        keys_["CONSTANTS"] = ros2::constant_lines(generation_, core_);
    }

    void ros2_package() {
        message_keys();
        add_file("CMakeLists.txt", "ros2/CMakeLists.txt");
        add_file("package.xml", "ros2/package.xml");
        add_file("launch/" + node_->files + ".launch.py", "ros2/launch/node.launch.py");
        add_file("config/" + node_->files + ".yaml", "ros2/config/parameters.yaml");
        add_file("test/node_test.cpp", "ros2/test/node_test.cpp");
        add_file("test/launch_test.py", "ros2/test/launch_test.py");
        add_file("own/own.cmake", "ros2/own/own.cmake");
        files_.back().keep = true;
        const std::string headers = "include/" + node_->package + "/";
        add_file(headers + "node_support.hpp", "ros2/node_support.hpp");
        if (node_->calls(ros2::Transport::action)) add_file(headers + "action_support.hpp", "ros2/action_support.hpp");
        files_.push_back(
            {headers + api_.cpp_name + "_messages.hpp", messages_header(generation_, core_, api_, *node_)});
        files_.push_back({headers + api_.cpp_name + "_node.hpp", node_header(generation_, core_, api_, *node_)});
        files_.push_back({"src/" + api_.cpp_name + "_node.cpp", node_source(generation_, core_, api_, *node_)});
        add_license();
    }

    /// Puts the declared licence above each file, as REUSE and ament_copyright expect.
    void add_license() {
        const std::string& license = generation_.options.package.license;
        if (license.empty()) return;
        for (OutputFile& file : files_) {
            const std::string_view mark = comment_mark(file.path);
            if (!mark.empty()) file.text = fmt::format("{}SPDX-License-Identifier: {}\n{}", mark, license, file.text);
        }
    }

    void add_robot() {
        const std::string act = free_member(api_, "act");
        keys_["ACT"] = act;
        files_.push_back(robot_file(generation_, core_, api_, act));
    }

    void add_enki() {
        add_robot();
        std::string titles, states;
        for (const ApiMachine& machine : api_.machines) {
            titles += "," + machine.method;
            states += fmt::format(" << ',' << ::Robot::name(puck.robot().{}())", machine.method);
        }
        keys_["STATE_TITLES"] = titles;
        keys_["STATES"] = states;
        add_file("CMakeLists.txt", "enki/CMakeLists.txt");
        add_file("body.hpp", "enki/body.hpp");
        add_file("main.cpp", "enki/main.cpp");
    }

    void add_argos() {
        add_robot();
        add_file("CMakeLists.txt", "argos/CMakeLists.txt");
        add_file("body.hpp", "argos/body.hpp");
        add_file("controller.cpp", "argos/controller.cpp");
        add_file(api_.cpp_name + ".argos", "argos/experiment.argos");
    }

    const Generation& generation_;
    const Core& core_;
    const ClassApi& api_;
    const std::optional<ros2::NodePlan>& node_;
    std::vector<OutputFile> files_;
    std::map<std::string, std::string> keys_;
    diagnostics::ForeignText element_;
    std::string console_;
    bool eigen_ = false;
};

}  // namespace

std::vector<OutputFile> project_files(const Generation& generation, const Core& core, const ClassApi& api,
                                      const std::vector<OutputFile>& controller,
                                      diagnostics::Diagnostics& diagnostics) {
    std::optional<ros2::NodePlan> node;
    if (generation.options.target == Target::ros2) {
        const std::size_t before = diagnostics.error_count();
        node = ros2::plan_node(generation, api, diagnostics);
        if (diagnostics.error_count() > before) return {};
    }
    return ProjectMaker(generation, core, api, controller, node).make_files();
}

}  // namespace robochart::cpp_emit
