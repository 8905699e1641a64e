// SPDX-License-Identifier: Apache-2.0
// Writes the class that stores the controller's outputs as messages until the end of a cycle.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "cpp_emit/ros2/field_code.hpp"
#include "cpp_emit/ros2/node_files.hpp"
#include "cpp_emit/ros2/ros_names.hpp"

namespace robochart::cpp_emit::ros2 {

namespace {

class MessagesWriter {
public:
    MessagesWriter(const Generation& generation, const Core& core, const ClassApi& api, const NodePlan& plan)
        : generation_(generation),
          core_(core),
          api_(api),
          plan_(plan),
          outbox_(free_member(api, "outbox")),
          message_(free_member(api, "message")) {}

    std::string write() {
        file_comment(generation_, out_, "Messages");
        out_.line("#pragma once");
        out_.gap();
        out_.line("#include <cstdint>");
        out_.line("#include <vector>");
        out_.gap();
        std::set<std::string> headers;
        for (const Topic& topic : plan_.topics)
            headers.insert(
                fmt::format("#include <{}/msg/{}.hpp>", topic.message.package, header_of_message(topic.message.type)));
        if (plan_.is_stamped()) headers.insert("#include <builtin_interfaces/msg/time.hpp>");
        for (const std::string& header : headers) out_.line(header);
        out_.gap();
        out_.line(fmt::format("#include \"{}.hpp\"", api_.cpp_name));
        out_.line("#include \"node_support.hpp\"");
        out_.gap();
        out_.line(fmt::format("namespace {} {{", api_.name_space));
        out_.gap();
        write_outbox();
        out_.gap();
        write_robot();
        out_.gap();
        out_.line(fmt::format("}}  // namespace {}", api_.name_space));
        return out_.text();
    }

private:
    void write_outbox() {
        out_.doc("What the controller says in a cycle, topic by topic in the order in which it says it.");
        out_.open(fmt::format("struct {}Outbox {{", api_.cpp_name));
        std::set<std::size_t> topics;
        for (const Outgoing& outgoing : plan_.outgoing)
            if (outgoing.variable == nullptr) topics.insert(outgoing.topic);
        for (const std::size_t topic : topics)
            out_.line(fmt::format("std::vector<{}> {};", message_type(plan_.topics[topic].message),
                                  plan_.topics[topic].member));
        out_.line_with_doc("std::vector<const char*> unfit;", "what has a value that its message cannot hold");
        if (plan_.is_stamped()) out_.line_with_doc("::builtin_interfaces::msg::Time now{};", "of the cycle");
        out_.close("};");
    }

    void write_robot() {
        out_.doc(
            "The controller. What it does is kept until the end of the cycle, for a cycle must not fail. To do an "
            "operation in C++, inherit this class, override the operation and give the node an object of yours.");
        out_.open(fmt::format("class {0}Messages : public {0} {{", api_.cpp_name));
        out_.write_label("public:");
        out_.line(fmt::format("{}Outbox {};", api_.cpp_name, outbox_));
        for (const Outgoing& outgoing : plan_.outgoing)
            if (outgoing.variable == nullptr) write_keeping(outgoing);
        out_.close("};");
    }

    void write_keeping(const Outgoing& outgoing) {
        const Topic& topic = plan_.topics[outgoing.topic];
        std::vector<std::string> parameters;
        std::vector<ir::TypeId> types;
        if (outgoing.operation != nullptr)
            types = outgoing.operation->signature->parameters;
        else if (outgoing.event->port->type)
            types = {*outgoing.event->port->type};
        for (std::size_t i = 0; i < types.size(); ++i)
            parameters.push_back(
                fmt::format("[[maybe_unused]] {} a{}", deployed_type(generation_, core_.relative, types[i]), i));
        out_.gap();
        out_.open(fmt::format("void {}({}) override {{",
                              outgoing.operation != nullptr ? outgoing.operation->method : outgoing.event->method,
                              fmt::join(parameters, ", ")));
        out_.line(fmt::format("{} {};", message_type(topic.message), message_));
        const std::string fits = fill_message(out_, outgoing, message_, outbox_ + ".now");
        const std::string keep = fmt::format("{}.{}.push_back({});", outbox_, topic.member, message_);
        if (fits.empty()) {
            out_.line(keep);
        } else {
            out_.open(fmt::format("if ({}) {{", fits));
            out_.line(keep);
            out_.reopen_block("} else {");
            out_.line(fmt::format("{}.unfit.push_back({});", outbox_, diagnostics::cpp_string(outgoing.name)));
            out_.close();
        }
        out_.close();
    }

    const Generation& generation_;
    const Core& core_;
    const ClassApi& api_;
    const NodePlan& plan_;
    std::string outbox_, message_;
    CodeWriter out_;
};

}  // namespace

std::string message_type(const MessageName& message) {
    return fmt::format("::{}::msg::{}", message.package, message.type);
}

std::string messages_header(const Generation& generation, const Core& core, const ClassApi& api, const NodePlan& plan) {
    return MessagesWriter(generation, core, api, plan).write();
}

}  // namespace robochart::cpp_emit::ros2
