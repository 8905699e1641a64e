// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/support.hpp"
#include "tests/source_folder.hpp"

#include <fstream>
#include <sstream>

namespace robochart::conformance::test {

namespace {

process::Event event_number(const std::string& event, process::EventTable& events) {
    if (event == "tau") return process::tau;
    if (event == "tick") return process::tick;
    return events.intern(event);
}

std::string text_of(const std::string& path) {
    std::ifstream in(tests::source_folder().string() + "/" + path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

}  // namespace

GraphSystem::GraphSystem(std::vector<Edge> edges, process::EventTable& events) : events_(&events) {
    for (const Edge& edge : edges) edges_.push_back({edge.from, event_number(edge.event, events), edge.to});
}

void GraphSystem::successors(lts::StateView state, lts::SuccessorSink& sink) {
    for (const Numbered& edge : edges_) {
        const lts::Word target = edge.to;
        if (edge.from == state[0]) sink.add(edge.event, {&target, 1}, edge.event);
    }
}

std::string GraphSystem::describe(lts::StateView state) const {
    return "s" + std::to_string(state[0]);
}

std::vector<Edge> turner_model(bool waits) {
    // The states are: 0 start, 1 drove, 2 driving, 3 saw a robot, 4 turned, 5 turning. Operations are urgent, so states
    // 0 and 3 have no tock.
    const unsigned drove = waits ? 1 : 2;
    const unsigned turned = waits ? 4 : 5;
    return {
        {0, "T::DriveCall.2", drove},
        {1, "tock", 2},
        {2, "T::seeRobot.in", 3},
        {2, "tock", 2},
        {3, "T::TurnCall", turned},
        {4, "tock", 5},
        {5, "T::seeWall.in", 6},
        {5, "tock", 5},
        {6, "T::speed.in.-2", 7},
        {6, "T::speed.in.2", 0},
        {6, "tau", 0},
        {7, "T::DriveCall.-2", drove},
    };
}

Interface turner_interface() {
    Interface interface;
    interface.component = "T";
    interface.inputs = {
        {"seeRobot.in", {}, {}, {}}, {"seeWall.in", {}, {}, {}}, {"speed.in", {-2, 2}, {"-2", "2"}, {}}};
    interface.outputs = {{"DriveCall", {Carrier{}}}, {"TurnCall", {}}};
    return interface;
}

std::unique_ptr<SharedObject> hand_made(const std::string& name, int fault, std::string& error) {
    const std::vector<cpp_emit::OutputFile> files{
        {name + ".cpp", text_of("tests/conformance/objects/" + name + ".cpp")},
        {"explore_abi.h", text_of("cpp_emit/runtime/explore_abi.h")}};
    BuildOptions options;
    options.flags = "-std=c++20 -O1 -Wall -Wextra -DFAULT=" + std::to_string(fault);
    return SharedObject::build(files, {name + ".cpp"}, options, error);
}

std::unique_ptr<SharedObject> compile_quietly(const cpp_emit::Emission& code, std::string& error) {
    std::vector<std::string> sources = code.sources;
    sources.push_back(code.shim);
    BuildOptions options;
    options.flags = "-std=c++20 -O0 -w";
    return SharedObject::build(code.files, sources, options, error);
}

}  // namespace robochart::conformance::test
