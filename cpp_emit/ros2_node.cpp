// The node of a ROS 2 package: received events are subscriptions, operations of the platform, sent events and shared
// variables are publishers, a timer on the node's clock makes the control cycles. Messages are those of std_msgs.
#include <fmt/format.h>

#include <optional>

#include "cpp_emit/plan/rules.hpp"
#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/project.hpp"

namespace robochart::cpp_emit {

namespace {

using ir::TypeKind;

/// The message of std_msgs that carries a value; "" if there is none.
std::string message_of(const ir::Type& type) {
    switch (type.kind) {
        case TypeKind::boolean:
            return "Bool";
        case TypeKind::nat:
        case TypeKind::integer:
            return "Int64";
        case TypeKind::real:
            return "Float64";
        case TypeKind::enumeration:
            return is_struct(type) ? "" : "Int64";
        case TypeKind::string:
        case TypeKind::given:
        case TypeKind::sequence:
        case TypeKind::set:
        case TypeKind::product:
        case TypeKind::record:
        case TypeKind::function:
        case TypeKind::relation:
        case TypeKind::vector:
        case TypeKind::matrix:
        case TypeKind::unit:
            break;
    }
    return "";
}

std::string message_of(const Generation& generation, const std::optional<ir::TypeId>& type) {
    return type ? message_of(generation.system.type(*type)) : "Empty";
}

/// Of an operation: none, one value, or several numbers in their order.
std::string message_of(const Generation& generation, const ir::OperationSignature& signature) {
    if (signature.parameters.empty()) return "Empty";
    for (const ir::TypeId type : signature.parameters)
        if (message_of(generation.system.type(type)).empty()) return "";
    return signature.parameters.size() == 1 ? message_of(generation.system.type(signature.parameters.front()))
                                            : "Float64MultiArray";
}

/// A topic and what passes it.
struct Topic {
    std::string name;     ///< in the model
    std::string member;   ///< of the node, without prefix
    std::string message;  ///< "Float64"; "" if there is none
    std::optional<ir::TypeId> type;
    diagnostics::Span span;
};

struct Topics {
    std::vector<std::pair<Topic, const ApiEvent*>> received, sent;
    std::vector<std::pair<Topic, const ApiOperation*>> operations;
    std::vector<std::pair<Topic, const ApiVariable*>> variables;
    std::vector<std::pair<Topic, const ApiVariable*>> written;  ///< from outside
};

Topics topics_of(const Generation& generation, const ClassApi& api) {
    Topics topics;
    const diagnostics::Span whole = generation.component.origin.span;
    each_class(api, [&](const ApiClass& part) {
        for (const ApiEvent& event : part.events) {
            const Topic topic{event.port->model_name, event.flag, message_of(generation, event.port->type),
                              event.port->type, whole};
            (event.sent ? topics.sent : topics.received).push_back({topic, &event});
        }
        for (const ApiOperation& operation : part.operations)
            if (!operation.modelled)
                topics.operations.push_back({{operation.signature->name,
                                              operation.method,
                                              message_of(generation, *operation.signature),
                                              {},
                                              operation.signature->origin.span},
                                             &operation});
        for (const ApiVariable& variable : part.variables) {
            const ir::Variable& declared = *variable.stored->variable;
            const Topic topic{declared.name, variable.member, message_of(generation, declared.type), declared.type,
                              declared.origin.span};
            if (variable.stored->visible) topics.variables.push_back({topic, &variable});
            if (variable.stored->external && variable.stored->stored()) topics.written.push_back({topic, &variable});
        }
    });
    return topics;
}

template <class Visit>
void each_topic(const Topics& topics, const Visit& visit) {
    for (const auto& [topic, event] : topics.received) visit("event", topic);
    for (const auto& [topic, event] : topics.sent) visit("event", topic);
    for (const auto& [topic, operation] : topics.operations) visit("operation", topic);
    for (const auto& [topic, variable] : topics.variables) visit("variable", topic);
    for (const auto& [topic, variable] : topics.written) visit("variable", topic);
}

class NodeWriter {
public:
    NodeWriter(const Generation& generation, const Core& core, const ClassApi& api)
        : generation_(generation),
          core_(core),
          api_(api),
          topics_(topics_of(generation, api)),
          node_(api.cpp_name + "Node") {}

    std::string header() {
        file_comment(generation_, out_, "ROS 2 node");
        out_.comment(
            "Events arrive on ~/in/EVENT; operations leave on ~/out/OPERATION, events sent on ~/sent/EVENT, shared "
            "variables on ~/variable/NAME when they change; ~/set/NAME writes those that the platform may write.");
        out_.line("#pragma once");
        out_.gap();
        includes();
        out_.line(fmt::format("namespace {} {{", api_.name_space));
        out_.gap();
        robot_class();
        out_.gap();
        node_class();
        out_.gap();
        out_.line(fmt::format("}}  // namespace {}", api_.name_space));
        return out_.text();
    }

    std::string source() {
        file_comment(generation_, out_, "ROS 2 node");
        out_.line(fmt::format("#include \"{}_node.hpp\"", api_.cpp_name));
        out_.gap();
        out_.line("#include <rclcpp_components/register_node_macro.hpp>");
        out_.gap();
        out_.line(fmt::format("namespace {} {{", api_.name_space));
        out_.gap();
        constructor();
        out_.gap();
        cycle();
        out_.gap();
        publish();
        out_.gap();
        log_method();
        out_.gap();
        out_.line(fmt::format("}}  // namespace {}", api_.name_space));
        out_.gap();
        out_.line(fmt::format("RCLCPP_COMPONENTS_REGISTER_NODE({}::{})", api_.name_space, node_));
        return out_.text();
    }

private:
    // ------------------------------------------------------------ header

    void includes() {
        out_.line("#include <cstdint>");
        out_.line("#include <memory>");
        out_.line("#include <optional>");
        out_.line("#include <string>");
        out_.line("#include <vector>");
        out_.gap();
        out_.line("#include <rclcpp/rclcpp.hpp>");
        std::set<std::string> messages{"string"};
        each_topic(topics_, [&](const char*, const Topic& topic) { messages.insert(header_of(topic.message)); });
        for (const std::string& message : messages) out_.line(fmt::format("#include <std_msgs/msg/{}.hpp>", message));
        out_.gap();
        out_.line(fmt::format("#include \"{}.hpp\"", api_.cpp_name));
        out_.line("#if ROBOCHART_TRACE");
        out_.line("#include \"robochart/trace_file.hpp\"");
        out_.line("#endif");
        out_.gap();
    }

    static std::string header_of(const std::string& message) {
        return message == "Float64MultiArray" ? "float64_multi_array"
               : message == "Float64"         ? "float64"
               : message == "Int64"           ? "int64"
               : message == "Bool"            ? "bool"
                                              : "empty";
    }

    void robot_class() {
        out_.doc("The controller; what it does is kept until the end of the cycle, for a cycle must not fail.");
        out_.open(fmt::format("class {}Messages final : public {} {{", api_.cpp_name, api_.cpp_name));
        out_.label("public:");
        for (const auto& [topic, operation] : topics_.operations) {
            out_.line(fmt::format("std::vector<std_msgs::msg::{}> made_{};", topic.message, topic.member));
            keep(topic, *operation);
        }
        for (const auto& [topic, event] : topics_.sent) {
            out_.line(fmt::format("std::vector<std_msgs::msg::{}> made_sent_{};", topic.message, topic.member));
            keep(topic, *event);
        }
        out_.close("};");
    }

    void keep(const Topic& topic, const ApiOperation& operation) {
        std::string parameters, several;
        const auto& types = operation.signature->parameters;
        for (std::size_t i = 0; i < types.size(); ++i) {
            parameters += fmt::format("{}{} a{}", i == 0 ? "" : ", ", type(types[i]), i);
            several += fmt::format("{}static_cast<double>(a{})", i == 0 ? "" : ", ", i);
        }
        out_.open(fmt::format("void {}({}) override {{", operation.method, parameters));
        out_.line(fmt::format("made_{}.emplace_back();", topic.member));
        if (types.size() == 1)
            out_.line(fmt::format("made_{}.back().data = {};", topic.member, to_message(types[0], "a0")));
        if (types.size() > 1) out_.line(fmt::format("made_{}.back().data = {{{}}};", topic.member, several));
        out_.close();
    }

    void keep(const Topic& topic, const ApiEvent& event) {
        out_.open(fmt::format("void {}({}) override {{", event.method, topic.type ? type(*topic.type) + " a0" : ""));
        out_.line(fmt::format("made_sent_{}.emplace_back();", topic.member));
        if (topic.type)
            out_.line(fmt::format("made_sent_{}.back().data = {};", topic.member, to_message(*topic.type, "a0")));
        out_.close();
    }

    void node_class() {
        out_.open(fmt::format("class {} : public rclcpp::Node {{", node_));
        out_.label("public:");
        out_.doc(
            "Parameters: `cycle`, seconds of a control cycle; `log`, a file to write a log into for robochart-verify "
            "conform --traces, in builds with -DROBOCHART_TRACE=ON.");
        out_.line(fmt::format("explicit {}(const rclcpp::NodeOptions& options = rclcpp::NodeOptions());", node_));
        out_.gap();
        out_.label("private:");
        out_.line("void cycle();");
        out_.line("void publish();");
        out_.line("void log(const std::string& file);");
        out_.gap();
        out_.line("#if ROBOCHART_TRACE");
        out_.line("std::unique_ptr<robochart::TraceFile> log_;");
        out_.line("#endif");
        out_.line(fmt::format("{}Messages robot_;", api_.cpp_name));
        out_.line("rclcpp::CallbackGroup::SharedPtr group_;");
        for (const auto& [topic, event] : topics_.received) subscription("in", topic);
        for (const auto& [topic, variable] : topics_.written) subscription("set", topic);
        for (const auto& [topic, operation] : topics_.operations) publisher("out", topic);
        for (const auto& [topic, event] : topics_.sent) publisher("sent", topic);
        for (const auto& [topic, variable] : topics_.variables) {
            publisher("variable", topic);
            out_.line(fmt::format("std::optional<{}> known_{}_;", type(*topic.type), topic.member));
        }
        for (const ApiMachine& machine : api_.machines) {
            out_.line(fmt::format("rclcpp::Publisher<std_msgs::msg::String>::SharedPtr {}_;", machine.method));
            out_.line(
                fmt::format("std::optional<{}::{}> known_{}_;", api_.cpp_name, machine.enumeration, machine.method));
        }
        out_.line("rclcpp::TimerBase::SharedPtr timer_;");
        out_.close("};");
    }

    void subscription(const char* kind, const Topic& topic) {
        out_.line(fmt::format("rclcpp::Subscription<std_msgs::msg::{}>::SharedPtr {}_{}_;", topic.message, kind,
                              topic.member));
    }
    void publisher(const char* kind, const Topic& topic) {
        out_.line(
            fmt::format("rclcpp::Publisher<std_msgs::msg::{}>::SharedPtr {}_{}_;", topic.message, kind, topic.member));
    }

    // ------------------------------------------------------------ source

    void constructor() {
        out_.open(fmt::format("{0}::{0}(const rclcpp::NodeOptions& options) : rclcpp::Node(\"{1}\", options) {{", node_,
                              generation_.component.cpp_name));
        out_.comment("One callback at a time: events and cycles share the controller.");
        out_.line("group_ = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);");
        out_.line("rclcpp::SubscriptionOptions grouped;");
        out_.line("grouped.callback_group = group_;");
        for (const auto& [topic, event] : topics_.received) subscribe(topic, *event);
        for (const auto& [topic, variable] : topics_.written) subscribe(topic, *variable);
        for (const auto& [topic, operation] : topics_.operations) create_publisher("out", topic);
        for (const auto& [topic, event] : topics_.sent) create_publisher("sent", topic);
        for (const auto& [topic, variable] : topics_.variables) create_publisher("variable", topic);
        for (const ApiMachine& machine : api_.machines)
            out_.line(fmt::format("{0}_ = create_publisher<std_msgs::msg::String>(\"~/{0}\", rclcpp::QoS(10));",
                                  machine.method));
        out_.line("log(declare_parameter(\"log\", std::string()));");
        out_.line("const double seconds = declare_parameter(\"cycle\", 0.1);");
        out_.comment("On the node's clock, which is the simulator's where use_sim_time is set.");
        out_.line(
            "timer_ = rclcpp::create_timer(this, get_clock(), rclcpp::Duration::from_seconds(seconds), "
            "[this] { cycle(); }, group_);");
        out_.close();
    }

    void log_method() {
        out_.open(fmt::format("void {}::log(const std::string& file) {{", node_));
        out_.line("if (file.empty()) return;");
        out_.line("#if ROBOCHART_TRACE");
        out_.line(
            fmt::format("log_ = std::make_unique<robochart::TraceFile>({}Messages::RunHeader());", api_.cpp_name));
        out_.line("if (log_->open(file)) return robot_.SetTracer(log_.get());");
        out_.line("RCLCPP_ERROR(get_logger(), \"cannot write %s\", file.c_str());");
        out_.line("#else");
        out_.line("RCLCPP_ERROR(get_logger(), \"%s: logs need a build with -DROBOCHART_TRACE=ON\", file.c_str());");
        out_.line("#endif");
        out_.close();
    }

    void create_publisher(const char* kind, const Topic& topic) {
        out_.line(fmt::format("{0}_{1}_ = create_publisher<std_msgs::msg::{2}>(\"~/{3}/{4}\", rclcpp::QoS(10));", kind,
                              topic.member, topic.message, kind, topic.name));
    }

    void open_callback(const char* kind, const Topic& topic) {
        out_.line(fmt::format("{}_{}_ = create_subscription<std_msgs::msg::{}>(", kind, topic.member, topic.message));
        out_.open(fmt::format(
            "    \"~/{}/{}\", rclcpp::QoS(10), [this]([[maybe_unused]] const std_msgs::msg::{}& message) {{", kind,
            topic.name, topic.message));
        refuse_values(topic);
    }

    void subscribe(const Topic& topic, const ApiEvent& event) {
        open_callback("in", topic);
        out_.line(fmt::format("robot_.{} = true;", event.flag));
        if (topic.type) out_.line(fmt::format("robot_.{} = {};", event.value, from_message(*topic.type)));
        out_.close("}, grouped);");
    }

    void subscribe(const Topic& topic, const ApiVariable& variable) {
        open_callback("set", topic);
        out_.line(fmt::format("robot_.{} = {};", variable.member, from_message(*topic.type)));
        out_.close("}, grouped);");
    }

    /// A number that is no value of the model's type is not taken.
    void refuse_values(const Topic& topic) {
        if (!topic.type) return;
        const ir::Type& type = generation_.system.type(*topic.type);
        std::string wrong;
        if (type.kind == TypeKind::nat) wrong = "message.data < 0";
        if (type.kind == TypeKind::enumeration)
            wrong = fmt::format("message.data < 0 || message.data >= {}", type.labels.size());
        if (wrong.empty()) return;
        out_.open(fmt::format("if ({}) {{", wrong));
        out_.line(
            fmt::format("RCLCPP_WARN(get_logger(), \"{}: %ld is no value of {}\", static_cast<long>(message.data));",
                        topic.name, type.name));
        out_.line("return;");
        out_.close();
    }

    void cycle() {
        out_.open(fmt::format("void {}::cycle() {{", node_));
        out_.line("const robochart::StepResult result = robot_.step();");
        out_.line("publish();");
        out_.line("if (result == robochart::StepResult::quiescent) return;");
        out_.line("timer_->cancel();");
        out_.open("if (result == robochart::StepResult::terminated) {");
        out_.line("RCLCPP_INFO(get_logger(), \"the controller has terminated\");");
        out_.line("return;");
        out_.close();
        out_.line(
            "RCLCPP_ERROR(get_logger(), \"the controller cannot go on (StepResult %d)\", static_cast<int>(result));");
        out_.close();
    }

    void publish() {
        out_.open(fmt::format("void {}::publish() {{", node_));
        for (const auto& [topic, operation] : topics_.operations) {
            out_.line(fmt::format("for (const auto& made : robot_.made_{0}) out_{0}_->publish(made);", topic.member));
            out_.line(fmt::format("robot_.made_{}.clear();", topic.member));
        }
        for (const auto& [topic, event] : topics_.sent) {
            out_.line(
                fmt::format("for (const auto& made : robot_.made_sent_{0}) sent_{0}_->publish(made);", topic.member));
            out_.line(fmt::format("robot_.made_sent_{}.clear();", topic.member));
        }
        for (const auto& [topic, variable] : topics_.variables) {
            out_.open(fmt::format("if (!known_{0}_ || *known_{0}_ != robot_.{0}) {{", topic.member));
            out_.line(fmt::format("known_{0}_ = robot_.{0};", topic.member));
            out_.line(fmt::format("std_msgs::msg::{} message;", topic.message));
            out_.line(fmt::format("message.data = {};", to_message(*topic.type, "robot_." + topic.member)));
            out_.line(fmt::format("variable_{}_->publish(message);", topic.member));
            out_.close();
        }
        for (const ApiMachine& machine : api_.machines) {
            out_.open(fmt::format("if (!known_{0}_ || *known_{0}_ != robot_.{0}()) {{", machine.method));
            out_.line(fmt::format("known_{0}_ = robot_.{0}();", machine.method));
            out_.line("std_msgs::msg::String message;");
            out_.line(fmt::format("message.data = {0}::name(robot_.{1}());", api_.cpp_name, machine.method));
            out_.line(fmt::format("{}_->publish(message);", machine.method));
            out_.close();
        }
        out_.close();
    }

    [[nodiscard]] std::string type(ir::TypeId id) const { return deployed_type(generation_, core_.relative, id); }
    [[nodiscard]] bool enumerated(ir::TypeId id) const {
        return generation_.system.type(id).kind == TypeKind::enumeration;
    }
    [[nodiscard]] std::string to_message(ir::TypeId id, const std::string& value) const {
        return enumerated(id) ? fmt::format("static_cast<std::int64_t>({})", value) : value;
    }
    [[nodiscard]] std::string from_message(ir::TypeId id) const {
        return enumerated(id) ? fmt::format("static_cast<{}>(message.data)", type(id)) : "message.data";
    }

    const Generation& generation_;
    const Core& core_;
    const ClassApi& api_;
    Topics topics_;
    std::string node_;
    CodeWriter out_;
};

}  // namespace

bool has_messages(const Generation& generation, const ClassApi& api, diagnostics::Diagnostics& diagnostics) {
    bool good = true;
    each_topic(topics_of(generation, api), [&](const char* kind, const Topic& topic) {
        if (!topic.message.empty()) return;
        good = false;
        diagnostics.report(rules::no_project, topic.span,
                           {"ros2", generation.component.name,
                            fmt::format("std_msgs has no message for the {} '{}'", kind, topic.name)});
    });
    return good;
}

std::string node_header(const Generation& generation, const Core& core, const ClassApi& api) {
    return NodeWriter(generation, core, api).header();
}

std::string node_source(const Generation& generation, const Core& core, const ClassApi& api) {
    return NodeWriter(generation, core, api).source();
}

}  // namespace robochart::cpp_emit
