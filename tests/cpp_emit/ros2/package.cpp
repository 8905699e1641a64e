// SPDX-License-Identifier: Apache-2.0
#include "tests/cpp_emit/ros2/package.hpp"

#include <fmt/format.h>

#include <fstream>

#include "cpp_emit/ros2/read_mapping.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "tests/source_folder.hpp"

namespace robochart::cpp_emit::ros2 {

Planned emit_package(const ir::System& system, const std::string& component, const std::string& text,
                     const ir::InstantiationOptions& values, const Options& given) {
    diagnostics::SourceManager sources;
    const diagnostics::SourceId source = sources.add("robot.ros2", text);
    diagnostics::Diagnostics diagnostics;
    Mapping mapping;
    if (!text.empty()) mapping = read_mapping(sources, source, diagnostics);
    Options options = given;
    options.target = Target::ros2;
    options.mapping = text.empty() ? nullptr : &mapping;
    Planned planned;
    if (diagnostics.ok()) {
        const ir::Instantiation inst = ir::instantiate_system(system, values, diagnostics);
        planned.emission =
            cpp_emit::emit(system, inst, testing::component_named(system, component), options, diagnostics);
    }
    for (const auto& finding : diagnostics.sorted_findings()) {
        const bool here = finding.span.is_known() && !text.empty() && finding.rule->code != "RC-R10";
        const diagnostics::Position at = here ? sources.position(source, finding.span.begin) : diagnostics::Position{};
        planned.findings += fmt::format("{} {}{}\n", finding.rule->code,
                                        here ? fmt::format("{}:{} ", at.line, at.column) : "", finding.message());
    }
    return planned;
}

void Package::emit(const ir::System& system, const std::string& component, const std::string& mapping,
                   const ir::InstantiationOptions& values, const Options& options) {
    const Planned planned = emit_package(system, component, mapping, values, options);
    ASSERT_FALSE(planned.emission.files.empty()) << planned.findings;
    folder_.write(planned.emission);
}

void Package::write(const std::string& path, const std::string& text) const {
    std::ofstream(folder_.path() + "/" + path) << text;
}

std::string Package::stub() {
    return tests::source_folder().string() + "/tests/cpp_emit/ros2_stub";
}

void Package::build(const std::string& options) const {
    folder_.run(
        "cmake -S . -B build -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS='-O0 -Wall -Wextra -Wpedantic "
        "-Wconversion -Wshadow -Werror' -DCMAKE_PREFIX_PATH=" +
        stub() + "/cmake " + options + " && cmake --build build");
}

void Package::drive(const std::string& node_header, const std::string& text, bool traced) const {
    write("drive.cpp",
          "#include \"" + node_header +
              "\"\n#define EXPECT(x) if (!(x)) return __LINE__\n"
              "using rclcpp::Network;\n"
              "template <class M> std::vector<M> taken(const std::string& topic) {\n"
              "    std::vector<M> all;\n"
              "    for (const std::any& each : Network::get().published[topic])\n"
              "        all.push_back(std::any_cast<M>(each));\n"
              "    Network::get().published[topic].clear();\n"
              "    return all;\n}\n"
              "template <class Node> bool started(Node& node) {\n"
              "    return node.configure().label() == \"inactive\" && node.activate().label() == \"active\";\n}\n"
              "bool logged(const std::string& text) {\n"
              "    std::size_t lines = 0;\n"
              "    for (const std::string& line : Network::get().log) lines += line.find(text) != std::string::npos;\n"
              "    Network::get().log.clear();\n"
              "    return lines == 1;\n}\n" +
              text);
    folder_.run(
        "for f in controller/*.cpp src/*_node.cpp drive.cpp; do echo \"#include \\\"$PWD/$f\\\"\"; done > whole.cpp; "
        "c++ -std=c++17 -O0 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -DROBOCHART_TRACE=" +
        std::to_string(traced) + " -I " + stub() +
        "/include -I include $(printf ' -I %s' include/*) -I controller whole.cpp -o drive");
    folder_.run("./drive; code=$?; test $code = 0 || { sed -n ${code}p drive.cpp; exit 1; }");
}

}  // namespace robochart::cpp_emit::ros2
