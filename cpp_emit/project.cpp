// Which files make up the project of a target; see project.hpp.
#include "cpp_emit/project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace robochart::cpp_emit {

namespace {

/// "SwarmTaxis" as the name of a ROS package (REP 144): small letters, digits, underscores; at least two.
std::string package_name(const std::string& name) {
    std::string result;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto c = static_cast<unsigned char>(name[i]);
        const bool word = std::isupper(c) != 0 && i > 0 && std::islower(static_cast<unsigned char>(name[i - 1])) != 0;
        if (word && result.back() != '_') result += '_';
        if (c == '_' && (result.empty() || result.back() == '_')) continue;
        result += static_cast<char>(std::tolower(c));
    }
    while (!result.empty() && result.back() == '_') result.pop_back();
    return result.size() < 2 || std::isalpha(static_cast<unsigned char>(result.front())) == 0 ? "robot_" + result
                                                                                              : result;
}

bool only_explored(const std::string& path) {
    const auto ends = [&](std::string_view end) { return path.size() >= end.size() && path.ends_with(end); };
    return ends("_explore.cpp") || path == "robochart/finite.hpp" || path.starts_with("robochart/explore") ||
           path == "main.cpp" || path == "CMakeLists.txt";
}

class ProjectMaker {
public:
    ProjectMaker(const Generation& generation, const Core& core, const ClassApi& api,
                 const std::vector<OutputFile>& controller)
        : generation_(generation), core_(core), api_(api) {
        for (const OutputFile& file : controller) {
            if (file.path == "main.cpp") console_ = file.text;
            if (only_explored(file.path)) continue;
            eigen_ = eigen_ || file.text.find("#include <Eigen/") != std::string::npos;
            files_.push_back({"controller/" + file.path, file.text});
        }
        keys_["CLASS"] = api.cpp_name;
        keys_["QUALIFIED"] = api.name_space + "::" + api.cpp_name;
        keys_["PACKAGE"] = package_name(generation.component.name);
        keys_["DEPENDENCIES"] = eigen_ ? "find_package(Eigen3 QUIET)\n" : "";
        const Target target = generation.options.target;
        keys_["TRACE"] = target == Target::library || target == Target::ros2 ? "OFF" : "ON";
        element_ = generation.component.kind + " " + generation.place(generation.component.origin);
        keys_["CONTROLLER"] = controller_target();
    }

    std::vector<OutputFile> make() {
        switch (generation_.options.target) {
            case Target::sources:
                break;
            case Target::library:
                add("CMakeLists.txt", "library/CMakeLists.txt");
                add(api_.cpp_name + "Config.cmake", "library/config.cmake");
                break;
            case Target::main:
                add("CMakeLists.txt", "main/CMakeLists.txt");
                files_.push_back({"main.cpp", console_});
                break;
            case Target::ros2:
                ros2();
                break;
            case Target::enki:
                enki();
                break;
            case Target::argos:
                argos();
                break;
        }
        return std::move(files_);
    }

private:
    /// The element stands in comments, and in text where the file is of XML.
    void add(const std::string& path, const std::string& text) {
        const bool xml = text.ends_with(".xml") || text.ends_with(".argos");
        keys_["ELEMENT"] = xml ? diagnostics::xml_text(element_) : diagnostics::comment_text(element_);
        files_.push_back({path, filled(project_template(text), keys_)});
    }

    std::string controller_target() {
        std::string text = filled(project_template("controller.cmake"), keys_);
        if (eigen_)
            text += fmt::format(
                "# For robochart/eigen.hpp, where the robot's code uses it.\nfind_package(Eigen3 QUIET)\n"
                "if(TARGET Eigen3::Eigen)\n  target_link_libraries({} PUBLIC Eigen3::Eigen)\nendif()\n",
                api_.cpp_name);
        return text;
    }

    void ros2() {
        add("CMakeLists.txt", "ros2/CMakeLists.txt");
        add("package.xml", "ros2/package.xml");
        files_.push_back({"src/" + api_.cpp_name + "_node.hpp", node_header(generation_, core_, api_)});
        files_.push_back({"src/" + api_.cpp_name + "_node.cpp", node_source(generation_, core_, api_)});
    }

    void robot() {
        const std::string act = free_member(api_, "act");
        keys_["ACT"] = act;
        files_.push_back(robot_file(generation_, core_, api_, act));
    }

    void enki() {
        robot();
        std::string titles, states;
        for (const ApiMachine& machine : api_.machines) {
            titles += "," + machine.method;
            states += fmt::format(" << ',' << ::Robot::name(puck.robot().{}())", machine.method);
        }
        keys_["STATE_TITLES"] = titles;
        keys_["STATES"] = states;
        add("CMakeLists.txt", "enki/CMakeLists.txt");
        add("body.hpp", "enki/body.hpp");
        add("main.cpp", "enki/main.cpp");
    }

    void argos() {
        robot();
        add("CMakeLists.txt", "argos/CMakeLists.txt");
        add("body.hpp", "argos/body.hpp");
        add("controller.cpp", "argos/controller.cpp");
        add(api_.cpp_name + ".argos", "argos/experiment.argos");
    }

    const Generation& generation_;
    const Core& core_;
    const ClassApi& api_;
    std::vector<OutputFile> files_;
    std::map<std::string, std::string> keys_;
    diagnostics::ForeignText element_;
    std::string console_;
    bool eigen_ = false;
};

}  // namespace

std::string filled(const std::string& text, const std::map<std::string, std::string>& keys) {
    std::string result;
    std::size_t from = 0;
    for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@', at + 1)) {
        const std::size_t end = text.find('@', at + 1);
        if (end == std::string::npos) break;
        const auto key = keys.find(text.substr(at + 1, end - at - 1));
        if (key == keys.end()) continue;
        result.append(text, from, at - from) += key->second;
        from = end + 1;
        at = end;
    }
    return result.append(text, from);
}

std::string free_member(const ClassApi& api, std::string name) {
    const auto taken = [&] {
        bool found = false;
        each_class(api, [&](const ApiClass& part) {
            for (const ApiVariable& variable : part.variables) found = found || variable.member == name;
            for (const ApiEvent& event : part.events) found = found || event.flag == name || event.value == name;
            for (const ApiOperation& operation : part.operations) found = found || operation.method == name;
        });
        return found;
    };
    while (taken()) name += "_robot";
    return name;
}

std::vector<OutputFile> project_files(const Generation& generation, const Core& core, const ClassApi& api,
                                      const std::vector<OutputFile>& controller,
                                      diagnostics::Diagnostics& diagnostics) {
    if (generation.options.target == Target::ros2 && !has_messages(generation, api, diagnostics)) return {};
    return ProjectMaker(generation, core, api, controller).make();
}

}  // namespace robochart::cpp_emit
