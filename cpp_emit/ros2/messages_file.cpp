// SPDX-License-Identifier: Apache-2.0
// Writes the class that sends the controller's outputs as messages, in the order of its calls.
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
        out_.line("#include <functional>");
        out_.gap();
        std::set<std::string> headers;
        for (const Topic& topic : plan_.topics)
            headers.insert(fmt::format("#include <{}/{}/{}.hpp>", topic.message.package,
                                       interface_folder(topic.transport), header_of_message(topic.message.type)));
        if (plan_.is_stamped()) headers.insert("#include <builtin_interfaces/msg/time.hpp>");
        for (const std::string& header : headers) out_.line(header);
        out_.gap();
        out_.line(fmt::format("#include \"{}.hpp\"", api_.cpp_name));
        out_.line(fmt::format("#include \"{}/node_support.hpp\"", plan_.package));
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
        out_.doc(
            "Where the messages go: one function for each topic. The node sets them. A message is sent when the model "
            "calls its operation or sends its event, so the messages leave in the order of the calls.");
        out_.open(fmt::format("struct {}Outbox {{", api_.cpp_name));
        std::set<std::size_t> topics;
        for (const Outgoing& outgoing : plan_.outgoing)
            if (outgoing.variable == nullptr && !outgoing.cancels) topics.insert(outgoing.topic);
        for (const std::size_t topic : topics)
            out_.line(fmt::format("std::function<void(const {}&)> {};", sent_type(plan_.topics[topic]),
                                  plan_.topics[topic].member));
        for (const std::size_t topic : topics)
            if (plan_.topics[topic].transport == Transport::action)
                out_.line_with_doc(fmt::format("std::function<void()> cancel_{};", plan_.topics[topic].member),
                                   "cancels the last goal");
        out_.line_with_doc("std::function<void(const char*)> unfit;",
                           "called instead if a message cannot hold a value, with the name of the operation or event");
        if (plan_.is_stamped()) out_.line_with_doc("::builtin_interfaces::msg::Time now{};", "of the cycle");
        out_.close("};");
    }

    void write_robot() {
        out_.doc(
            "The controller. It sends a message for each operation and event. To do an operation in C++, inherit this "
            "class, override the operation and give the node an object of yours. The messages of earlier calls have "
            "been published when an operation begins, and cycles wait until it returns.");
        out_.open(fmt::format("class {0}Messages : public {0} {{", api_.cpp_name));
        out_.write_label("public:");
        out_.line(fmt::format("{}Outbox {};", api_.cpp_name, outbox_));
        for (const Outgoing& outgoing : plan_.outgoing)
            if (outgoing.variable == nullptr) write_sending(outgoing);
        out_.close("};");
    }

    void write_sending(const Outgoing& outgoing) {
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
        if (outgoing.cancels) {
            out_.line(fmt::format("if ({0}.cancel_{1}) {0}.cancel_{1}();", outbox_, topic.member));
            return out_.close();
        }
        out_.line(fmt::format("{} {};", sent_type(topic), message_));
        const std::string fits = fill_message(out_, outgoing, message_, outbox_ + ".now");
        const std::string send = fmt::format("::robochart::ros2::send({}.{}, {});", outbox_, topic.member, message_);
        if (fits.empty()) {
            out_.line(send);
        } else {
            out_.open(fmt::format("if ({}) {{", fits));
            out_.line(send);
            out_.reopen_block("} else {");
            out_.line(
                fmt::format("::robochart::ros2::send({}.unfit, {});", outbox_, diagnostics::cpp_string(outgoing.name)));
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

const char* interface_folder(Transport transport) {
    switch (transport) {
        case Transport::service:
            return "srv";
        case Transport::action:
            return "action";
        case Transport::topic:
        case Transport::reply:
        case Transport::cancel:
            break;
    }
    return "msg";
}

std::string interface_type(const Topic& topic) {
    return fmt::format("::{}::{}::{}", topic.message.package, interface_folder(topic.transport), topic.message.type);
}

std::string sent_type(const Topic& topic) {
    if (!topic.is_called()) return interface_type(topic);
    return interface_type(topic) + (topic.transport == Transport::action ? "::Goal" : "::Request");
}

std::string received_type(const Topic& topic, Reply reply) {
    if (!topic.is_called()) return interface_type(topic);
    if (reply == Reply::answer) return interface_type(topic) + "::Response";
    return interface_type(topic) + (reply == Reply::feedback ? "::Feedback" : "::Result");
}

std::string messages_header(const Generation& generation, const Core& core, const ClassApi& api, const NodePlan& plan) {
    return MessagesWriter(generation, core, api, plan).write();
}

}  // namespace robochart::cpp_emit::ros2
