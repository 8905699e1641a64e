// SPDX-License-Identifier: Apache-2.0
// Writes the header and the source of the node.
#include "cpp_emit/ros2/node_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "cpp_emit/ros2/field_code.hpp"
#include "cpp_emit/ros2/model_values.hpp"
#include "cpp_emit/ros2/node_constants.hpp"

namespace robochart::cpp_emit::ros2 {

namespace {

std::string quality_text(const QualityOfService& quality) {
    return fmt::format("::rclcpp::QoS({}).{}().{}()", quality.depth, quality.reliable ? "reliable" : "best_effort",
                       quality.latched ? "transient_local" : "durability_volatile");
}

class NodeWriter {
public:
    NodeWriter(const Generation& generation, const Core& core, const ClassApi& api, const NodePlan& plan)
        : generation_(generation),
          core_(core),
          api_(api),
          plan_(plan),
          constants_(node_constants(generation)),
          node_(api.cpp_name + "Node"),
          outbox_("robot_->" + free_member(api, "outbox")) {
        NameScope names;
        for (const Outgoing& outgoing : plan.outgoing)
            last_.push_back(
                outgoing.variable == nullptr ? "" : names.unique_name("last_" + outgoing.variable->member) + "_");
        for (const StateTopic& state : plan.states)
            last_states_.push_back(names.unique_name("last_" + state.machine->method) + "_");
        plan_receptions();
    }

    std::string write_header() {
        file_comment(generation_, out_, "ROS 2 node");
        head_comment();
        out_.line("#pragma once");
        out_.gap();
        if (!plan_.farewells.empty()) out_.line("#include <atomic>");
        for (const char* const header : {"cstdint", "memory", "optional", "string"})
            out_.line(fmt::format("#include <{}>", header));
        out_.gap();
        out_.line("#include <rclcpp/rclcpp.hpp>");
        out_.line("#include <rclcpp_lifecycle/lifecycle_node.hpp>");
        out_.line("#include <rclcpp_lifecycle/lifecycle_publisher.hpp>");
        out_.gap();
        out_.line(fmt::format("#include \"{}/{}_messages.hpp\"", plan_.package, api_.cpp_name));
        if (calls_actions()) out_.line(fmt::format("#include \"{}/action_support.hpp\"", plan_.package));
        out_.line("#if ROBOCHART_TRACE");
        out_.line("#include \"robochart/trace_file.hpp\"");
        out_.line("#endif");
        out_.gap();
        out_.line(fmt::format("namespace {} {{", api_.name_space));
        out_.gap();
        node_class();
        out_.gap();
        out_.line(fmt::format("}}  // namespace {}", api_.name_space));
        return out_.text();
    }

    std::string write_source() {
        file_comment(generation_, out_, "ROS 2 node");
        out_.line(fmt::format("#include \"{}/{}_node.hpp\"", plan_.package, api_.cpp_name));
        out_.gap();
        out_.line("#include <exception>");
        out_.line("#include <type_traits>");
        out_.line("#include <utility>");
        out_.gap();
        out_.line("#include <rclcpp_components/register_node_macro.hpp>");
        out_.gap();
        out_.line(fmt::format("namespace {} {{", api_.name_space));
        write_constructors();
        write_outbox();
        if (!plan_.farewells.empty()) write_farewell();
        write_configure();
        write_activate();
        write_deactivate();
        write_release();
        for (const Reception& reception : receptions_) write_receive(reception);
        write_cycle();
        write_publish();
        write_sending();
        log_methods();
        out_.gap();
        out_.line(fmt::format("}}  // namespace {}", api_.name_space));
        out_.gap();
        out_.line(fmt::format("RCLCPP_COMPONENTS_REGISTER_NODE({}::{})", api_.name_space, node_));
        return out_.text();
    }

private:
    // ------------------------------------------------------------ header

    void head_comment() {
        out_.comment(
            fmt::format("`robochart-verify conform` checks the class {} against the model, and nothing of this node: "
                        "which messages "
                        "arrive before a cycle, what queues lose, how exactly the timer fires, and what a field of a "
                        "message means.",
                        api_.cpp_name));
        if (is_immediate())
            out_.comment(
                "The node also runs a cycle when an input arrives. The model counts no time, so its cycles may have "
                "any length: what has been checked is the order of inputs and outputs, and not their times.");
        for (const Topic& topic : plan_.topics) {
            const char* verb = topic.published ? "publishes" : "receives";
            if (topic.is_called()) verb = "calls";
            out_.comment(fmt::format("{} {} on {}", verb, topic.message.full_name(), topic.name));
        }
    }

    void node_class() {
        out_.doc(
            "A lifecycle node. Cycles run while it is active; while it is not, time of the model stands still, "
            "messages raise no events and nothing is published. Shared variables are taken whenever it is configured. "
            "To configure begins anew.");
        out_.open(fmt::format("class {} : public ::rclcpp_lifecycle::LifecycleNode {{", node_));
        out_.write_label("public:");
        out_.line(
            "using CallbackReturn = ::rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;");
        out_.gap();
        out_.line(fmt::format("explicit {}(const ::rclcpp::NodeOptions& options = ::rclcpp::NodeOptions());", node_));
        out_.doc("With operations of your own; see the class of the messages.");
        out_.line(fmt::format("{}(const ::rclcpp::NodeOptions& options, std::unique_ptr<{}Messages> robot);", node_,
                              api_.cpp_name));
        out_.gap();
        if (!plan_.farewells.empty()) out_.line(fmt::format("~{}() override;", node_));
        for (const char* const transition : {"configure", "activate", "deactivate", "cleanup", "shutdown"})
            out_.line(
                fmt::format("CallbackReturn on_{}(const ::rclcpp_lifecycle::State& previous) override;", transition));
        out_.gap();
        out_.write_label("private:");
        if (!constants_.empty()) {
            out_.line("template <class Value>");
            out_.line("void constant(const std::string& parameter, const std::string& path, const Value& generated);");
        }
        out_.line("void release();");
        out_.line("void cycle();");
        if (is_immediate()) out_.line("void dispatch();");
        out_.line("void connect_outbox();");
        out_.line("void publish();");
        out_.line("[[nodiscard]] ::robochart::ros2::Health::Facts facts() const;");
        out_.line("void report_health(unsigned char level, const char* text) noexcept;");
        if (!plan_.farewells.empty()) out_.line("void say_farewell() noexcept;");
        out_.line("template <class Publisher, class Message>");
        out_.line("void send(const Publisher& publisher, const Message& message) noexcept;");
        out_.line("void report_unfit(const char* name) noexcept;");
        out_.line("[[nodiscard]] bool open_log();");
        out_.line("void note(const std::string& text) noexcept;");
        for (const Reception& reception : receptions_)
            out_.line(fmt::format("void {}({});", reception_name(reception), reception_parameter(reception, "")));
        if (calls_actions()) {
            out_.line("template <class Goal, class Message>");
            out_.line("void send_goal(Goal& goal, const Message& message, const char* name) noexcept;");
            out_.line("template <class Goal>");
            out_.line("void cancel_goal(Goal& goal, const char* name) noexcept;");
            out_.line("void cancel_goals() noexcept;");
        }
        if (calls_services()) {
            out_.line("template <class Service, class Answer>");
            out_.line("void call(const std::shared_ptr<::rclcpp::Client<Service>>& client,");
            out_.line("          const typename Service::Request& request, Answer answer) noexcept;");
        }
        out_.gap();
        node_members();
        out_.close("};");
    }

    void node_members() {
        out_.line("#if ROBOCHART_TRACE");
        out_.line("std::unique_ptr<::robochart::TraceFile> log_;");
        out_.line("#endif");
        out_.line(fmt::format("std::unique_ptr<{}Messages> robot_;", api_.cpp_name));
        out_.line("double seconds_ = 0;");
        if (generation_.options.unit) out_.line("double scale_ = 1;");
        out_.line("::robochart::ros2::Pace pace_;");
        out_.line("::robochart::ros2::Health health_;");
        out_.line(
            "::rclcpp_lifecycle::LifecyclePublisher<::diagnostic_msgs::msg::DiagnosticArray>::SharedPtr diagnostics_;");
        out_.line("std::string log_file_;");
        if (!constants_.empty())
            out_.line_with_doc("std::string changed_;", "constants that are not those of the generated code");
        if (plan_.farewells.empty()) {
            out_.line("bool active_ = false;");
        } else {
            out_.line_with_doc("std::atomic<bool> active_{false};", "read by the thread that ends the program, too");
            out_.line("::rclcpp::PreShutdownCallbackHandle at_end_;");
        }
        for (const Silence& silence : plan_.silences)
            out_.line(fmt::format("::robochart::ros2::Watch {}_;", silence.member));
        if (is_immediate()) out_.line_with_doc("bool in_cycle_ = false;", "a cycle is running");
        out_.line_with_doc("bool ended_ = false;", "the controller has terminated or cannot go on");
        for (const Topic& topic : plan_.topics) out_.line(fmt::format("{} {}_;", end_type(topic), topic.member));
        for (const Topic& topic : plan_.topics)
            if (!topic.is_called())
                out_.line(fmt::format("::robochart::ros2::Quality quality_{}_{{{}}};", topic.member,
                                      quality_text(topic.quality)));
        for (std::size_t i = 0; i < plan_.outgoing.size(); ++i)
            if (const ApiVariable* const variable = plan_.outgoing[i].variable)
                out_.line(fmt::format("std::optional<{}> {};", type_text(variable->stored->variable->type), last_[i]));
        for (std::size_t i = 0; i < plan_.states.size(); ++i)
            out_.line(fmt::format("std::optional<{}::{}> {};", api_.cpp_name, plan_.states[i].machine->enumeration,
                                  last_states_[i]));
        out_.line("::rclcpp::TimerBase::SharedPtr timer_;");
    }

    /// Returns the type of the publisher, the subscription or the client.
    static std::string end_type(const Topic& topic) {
        const std::string type = interface_type(topic);
        if (topic.transport == Transport::action) return fmt::format("::robochart::ros2::Goal<{}>", type);
        if (topic.is_called()) return fmt::format("::rclcpp::Client<{}>::SharedPtr", type);
        const char* const end = topic.published ? "::rclcpp_lifecycle::LifecyclePublisher" : "::rclcpp::Subscription";
        return fmt::format("{}<{}>::SharedPtr", end, type);
    }

    [[nodiscard]] bool is_immediate() const { return generation_.options.dispatch == Dispatch::immediate; }
    [[nodiscard]] bool calls_services() const { return plan_.calls(Transport::service); }
    [[nodiscard]] bool calls_actions() const { return plan_.calls(Transport::action); }

    // ------------------------------------------------------------ receptions

    /// A method of the node. It takes the messages of a topic, the answers of a service, or one kind of replies of an
    /// action.
    struct Reception {
        std::size_t topic = 0;
        Reply reply = Reply::answer;
        friend bool operator==(const Reception&, const Reception&) = default;
    };

    /// Plans the methods. A topic and a service have one method. An action has one for each reply that raises an event
    /// or ends a deadline.
    void plan_receptions() {
        for (std::size_t i = 0; i < plan_.topics.size(); ++i) {
            const Topic& topic = plan_.topics[i];
            if (topic.transport != Transport::action) {
                if (!topic.published || topic.is_called()) receptions_.push_back({i, Reply::answer});
                continue;
            }
            const bool watched =
                std::ranges::any_of(plan_.silences, [i](const Silence& silence) { return silence.topic == i; });
            for (const Reply reply :
                 {Reply::accepted, Reply::rejected, Reply::feedback, Reply::succeeded, Reply::aborted, Reply::canceled})
                if ((watched && ends_call(reply)) || std::ranges::any_of(plan_.incoming, [&](const Incoming& incoming) {
                        return incoming.topic == i && incoming.reply == reply;
                    }))
                    receptions_.push_back({i, reply});
        }
    }

    [[nodiscard]] std::string reception_name(const Reception& reception) const {
        const Topic& topic = plan_.topics[reception.topic];
        const std::string name = "receive_" + topic.member;
        return topic.transport == Transport::action ? fmt::format("{}_{}", name, describe_reply(reception.reply))
                                                    : name;
    }

    static bool has_message(Reply reply) { return reply != Reply::accepted && reply != Reply::rejected; }

    [[nodiscard]] std::string reception_parameter(const Reception& reception, const char* attribute) const {
        if (!has_message(reception.reply)) return "";
        return fmt::format("{}const {}& message", attribute,
                           received_type(plan_.topics[reception.topic], reception.reply));
    }

    // ------------------------------------------------------------ source

    void write_constructors() {
        out_.gap();
        out_.line(fmt::format("{0}::{0}(const ::rclcpp::NodeOptions& options)", node_));
        out_.line(fmt::format("    : {}(options, std::make_unique<{}Messages>()) {{}}", node_, api_.cpp_name));
        out_.gap();
        out_.line(fmt::format("{0}::{0}(const ::rclcpp::NodeOptions& options, std::unique_ptr<{1}Messages> robot)",
                              node_, api_.cpp_name));
        out_.open(fmt::format("    : ::rclcpp_lifecycle::LifecycleNode(\"{}\", options), robot_(std::move(robot)) {{",
                              plan_.node));
        out_.line("seconds_ = ::robochart::ros2::declare_number(");
        out_.line(fmt::format(
            "    *this, \"cycle\", {}, ::robochart::ros2::at_start(\"seconds of a control cycle, which is {}\", "
            "0.001, 3600.0));",
            cycle_seconds(generation_.options), cycle_text(generation_.options)));
        if (generation_.options.unit) {
            out_.line("scale_ = ::robochart::ros2::declare_number(");
            out_.line(
                "    *this, \"cycle_scale\", 1.0, ::robochart::ros2::at_start(\"how many times as long as declared the "
                "time units of the model last\", 0.001, 1000.0));");
        }
        out_.line("log_file_ = declare_parameter(");
        out_.line(
            "    \"log\", std::string(), ::robochart::ros2::at_start(\"file for a log of what the controller "
            "does\"));");
        for (const NodeConstant& constant : constants_)
            out_.line(fmt::format("constant(\"{}\", \"{}\", {});", constant.parameter, constant.path,
                                  parameter_value(constant)));
        out_.line("connect_outbox();");
        if (!plan_.farewells.empty()) {
            out_.comment("When the program ends, for example by Ctrl-C, as long as messages can be published.");
            out_.open("at_end_ = get_node_base_interface()->get_context()->add_pre_shutdown_callback([this] {");
            out_.line("if (active_) say_farewell();");
            out_.close("});");
        }
        out_.close();
        if (!plan_.farewells.empty()) {
            out_.gap();
            out_.open(fmt::format("{0}::~{0}() {{", node_));
            out_.line("get_node_base_interface()->get_context()->remove_pre_shutdown_callback(at_end_);");
            out_.close();
        }
        if (constants_.empty()) return;
        out_.gap();
        out_.line("template <class Value>");
        out_.open(fmt::format(
            "void {}::constant(const std::string& parameter, const std::string& path, const Value& generated) {{",
            node_));
        out_.line("const std::string text = \"constant \" + path + \" of the model, as the code was generated\";");
        out_.line("const auto descriptor = ::robochart::ros2::at_start(text);");
        out_.open("if constexpr (std::is_same_v<Value, double>) {");
        out_.line("const double value = ::robochart::ros2::declare_number(*this, parameter, generated, descriptor);");
        out_.line("if (!(value <= generated && value >= generated)) changed_ += \" \" + parameter;");
        out_.reopen_block("} else if (declare_parameter(parameter, generated, descriptor) != generated) {");
        out_.line("changed_ += \" \" + parameter;");
        out_.close();
        out_.close();
    }

    [[nodiscard]] std::string parameter_value(const NodeConstant& constant) const {
        const ir::Type& type = generation_.system.type(constant.type);
        const std::string text = deployed_value(generation_, core_, constant.type, constant.value);
        if (type.kind == ir::TypeKind::enumeration)
            return fmt::format("std::string(\"{}\")", type.labels[static_cast<std::size_t>(constant.value.number)]);
        return type.kind == ir::TypeKind::boolean || type.kind == ir::TypeKind::real
                   ? text
                   : fmt::format("std::int64_t{{{}}}", text);
    }

    void open_transition(const char* name, const char* previous) {
        out_.gap();
        out_.open(fmt::format("{0}::CallbackReturn {0}::on_{1}(const ::rclcpp_lifecycle::State&{2}) {{", node_, name,
                              previous));
    }

    void write_configure() {
        open_transition("configure", "");
        if (!constants_.empty()) {
            out_.comment("The code has the constants' values in it, and it is what has been checked.");
            out_.open("if (!changed_.empty()) {");
            out_.line(
                "RCLCPP_ERROR(get_logger(), \"these parameters differ from the constants of the generated code:%s; "
                "generate it again with --const\", changed_.c_str());");
            out_.line("return CallbackReturn::FAILURE;");
            out_.close();
        }
        out_.open("if (!(seconds_ >= 0.001 && seconds_ <= 3600.0)) {");
        out_.line(
            "RCLCPP_ERROR(get_logger(), \"parameter cycle: %f is no number of seconds from 0.001 to 3600\", "
            "seconds_);");
        out_.line("return CallbackReturn::FAILURE;");
        out_.close();
        write_unit_check();
        out_.line("robot_->reset();");
        out_.line("if (!open_log()) return CallbackReturn::FAILURE;");
        for (const Topic& topic : plan_.topics) write_connection(topic);
        out_.line(
            "diagnostics_ = create_publisher<::diagnostic_msgs::msg::DiagnosticArray>(\"/diagnostics\", "
            "::rclcpp::QoS(10).reliable().durability_volatile());");
        out_.line("return CallbackReturn::SUCCESS;");
        out_.close();
    }

    /// Writes a check of the time unit. Clocks and timeouts count time units, so the parameter `cycle` changes their
    /// length in seconds. The node therefore reports a cycle of another length than the usual one.
    void write_unit_check() {
        const std::string usual = cycle_seconds(generation_.options);
        const std::string text = cycle_text(generation_.options);
        if (!generation_.options.unit) {
            out_.open(fmt::format("if (!(seconds_ >= {0} && seconds_ <= {0})) {{", usual));
            out_.line(
                fmt::format("const double unit = seconds_ / {};", std::max(1U, generation_.options.cycle_length)));
            out_.line(
                fmt::format("RCLCPP_WARN(get_logger(), \"with this cycle a time unit of the model lasts %g s, so "
                            "its clocks and timeouts are %g times as long as with {} s\", unit, seconds_ / {});",
                            usual, usual));
            return out_.close();
        }
        out_.line(fmt::format("const double declared = {} * scale_;", usual));
        out_.open("if (!(seconds_ >= declared * (1 - 1e-9) && seconds_ <= declared * (1 + 1e-9))) {");
        out_.line(
            fmt::format("RCLCPP_ERROR(get_logger(), \"parameter cycle: a cycle is {}, and not %g s: the clocks and "
                        "timeouts of the model would be %g times as long. The parameter cycle_scale allows it\", "
                        "seconds_, seconds_ / {});",
                        text, usual));
        out_.line("return CallbackReturn::FAILURE;");
        out_.close();
        out_.line(
            "if (!(scale_ >= 1 && scale_ <= 1)) RCLCPP_WARN(get_logger(), \"parameter cycle_scale: the clocks and "
            "timeouts of the model are %g times as long as declared\", scale_);");
    }

    void write_connection(const Topic& topic) {
        if (topic.transport == Transport::action)
            return out_.line(fmt::format("{}_.connect(::rclcpp_action::create_client<{}>(this, \"{}\"));", topic.member,
                                         interface_type(topic), topic.name));
        if (topic.is_called())
            return out_.line(
                fmt::format("{}_ = create_client<{}>(\"{}\");", topic.member, interface_type(topic), topic.name));
        const std::string message = message_type(topic.message);
        const std::string quality = "quality_" + topic.member + "_";
        if (topic.published) {
            out_.line(fmt::format("{}_ = create_publisher<{}>(", topic.member, message));
            out_.line(fmt::format("    \"{0}\", {1}.value(), {1}.options<::rclcpp::PublisherOptions>());", topic.name,
                                  quality));
        } else {
            out_.line(fmt::format("{}_ = create_subscription<{}>(", topic.member, message));
            out_.line(fmt::format("    \"{}\", {}.value(), [this](const {}& message) {{ receive_{}(message); }},",
                                  topic.name, quality, message, topic.member));
            out_.line(fmt::format("    {}.options<::rclcpp::SubscriptionOptions>());", quality));
        }
        out_.line(fmt::format("{}.settle({}_->get_actual_qos());", quality, topic.member));
    }

    void write_activate() {
        open_transition("activate", " previous");
        out_.open("if (ended_) {");
        out_.line("RCLCPP_ERROR(get_logger(), \"the controller has ended: clean up and configure to begin anew\");");
        out_.line("return CallbackReturn::FAILURE;");
        out_.close();
        out_.line("active_ = true;");
        for (const Silence& silence : plan_.silences)
            if (!plan_.topics[silence.topic].is_called()) out_.line(silence.member + "_.hear(now());");
        out_.line(
            "if (const double pause = pace_.resume(now()); pause > 0) note(\"pause of \" + std::to_string(pause) + \" "
            "s\");");
        out_.comment(
            "On the node's clock, which is the simulator's where use_sim_time is set; in the node's own callback "
            "group, "
            "so that messages, cycles and transitions never run at once.");
        out_.line(
            "timer_ = ::rclcpp::create_timer(this, get_clock(), ::rclcpp::Duration::from_seconds(seconds_), [this] { "
            "cycle(); });");
        out_.line("return ::rclcpp_lifecycle::LifecycleNode::on_activate(previous);");
        out_.close();
    }

    void write_deactivate() {
        open_transition("deactivate", " previous");
        out_.line("active_ = false;");
        out_.line("timer_.reset();");
        if (!plan_.farewells.empty()) out_.line("say_farewell();");
        if (calls_actions()) out_.line("cancel_goals();");
        out_.line("if (!ended_) report_health(::robochart::ros2::Health::Status::OK, \"inactive\");");
        out_.line("pace_.pause(now());");
        std::set<std::string> flags;
        for (const Incoming& incoming : plan_.incoming)
            if (incoming.event != nullptr) flags.insert(incoming.event->flag);
        for (const Silence& silence : plan_.silences)
            if (plan_.topics[silence.topic].is_called()) out_.line(silence.member + "_.rest();");
        if (!flags.empty()) out_.comment("What no cycle has seen yet would be late when it is activated again.");
        for (const std::string& flag : flags) out_.line(fmt::format("robot_->{} = false;", flag));
        out_.line("return ::rclcpp_lifecycle::LifecycleNode::on_deactivate(previous);");
        out_.close();
    }

    void write_release() {
        for (const char* const transition : {"cleanup", "shutdown"}) {
            open_transition(transition, "");
            if (!plan_.farewells.empty() && std::string_view(transition) == "shutdown")
                out_.line("if (active_) say_farewell();");
            if (calls_actions() && std::string_view(transition) == "shutdown")
                out_.line("if (active_) cancel_goals();");
            out_.line("release();");
            out_.line("return CallbackReturn::SUCCESS;");
            out_.close();
        }
        out_.gap();
        out_.open(fmt::format("void {}::release() {{", node_));
        out_.line("active_ = false;");
        out_.line("ended_ = false;");
        out_.line("timer_.reset();");
        out_.line("pace_ = {};");
        out_.line("health_ = {};");
        out_.line("diagnostics_.reset();");
        for (const Topic& topic : plan_.topics)
            out_.line(
                fmt::format("{}_.{}();", topic.member, topic.transport == Transport::action ? "release" : "reset"));
        for (const std::string& last : last_)
            if (!last.empty()) out_.line(fmt::format("{}.reset();", last));
        for (const std::string& last : last_states_) out_.line(fmt::format("{}.reset();", last));
        out_.line("robot_->reset();");
        out_.close();
    }

    void write_receive(const Reception& reception) {
        const std::size_t topic = reception.topic;
        const bool called = plan_.topics[topic].is_called();
        out_.gap();
        out_.open(fmt::format("void {}::{}({}) {{", node_, reception_name(reception),
                              reception_parameter(reception, "[[maybe_unused]] ")));
        for (const Silence& silence : plan_.silences)
            if (silence.topic == topic && (!called || ends_call(reception.reply)))
                out_.line(silence.member + (called ? "_.rest();" : "_.hear(now());"));
        for (const Incoming& incoming : plan_.incoming)
            if (incoming.topic == topic && incoming.variable != nullptr) write_tested(incoming);
        const auto raises = [&](const Incoming& incoming) {
            return incoming.topic == topic && incoming.reply == reception.reply && incoming.event != nullptr;
        };
        if (std::ranges::any_of(plan_.incoming, raises)) {
            out_.line("if (!active_) return;");
            for (const Incoming& incoming : plan_.incoming)
                if (raises(incoming)) write_tested(incoming);
        }
        const auto takes = [&](const Incoming& incoming) {
            return raises(incoming) || (incoming.topic == topic && incoming.variable != nullptr);
        };
        if (is_immediate() && std::ranges::any_of(plan_.incoming, takes)) out_.line("dispatch();");
        out_.close();
    }

    /// Writes the code that takes a message if the conditions of its item are true.
    void write_tested(const Incoming& incoming) {
        std::vector<std::string> tests;
        for (const Test& test : incoming.tests)
            tests.push_back(fmt::format("::robochart::ros2::holds(message.{}, ::robochart::ros2::Comparison::{}, {})",
                                        test.field, comparison_name(test.comparison), test.value));
        if (tests.empty()) return write_taking(incoming);
        out_.open(fmt::format("if ({}) {{", fmt::join(tests, " && ")));
        write_taking(incoming);
        out_.close();
    }

    static std::string_view comparison_name(Comparison comparison) {
        switch (comparison) {
            case Comparison::equal:
                return "equal";
            case Comparison::not_equal:
                return "not_equal";
            case Comparison::less:
                return "less";
            case Comparison::less_equal:
                return "less_equal";
            case Comparison::greater:
                return "greater";
            case Comparison::greater_equal:
                break;
        }
        return "greater_equal";
    }

    /// Writes the code for the messages that are published when the node stops.
    void write_farewell() {
        out_.gap();
        out_.open(fmt::format("void {}::say_farewell() noexcept {{", node_));
        for (const Outgoing& outgoing : plan_.farewells) {
            const Topic& topic = plan_.topics[outgoing.topic];
            out_.open("{");
            out_.line(fmt::format("{} message;", message_type(topic.message)));
            const std::string fits = fill_message(out_, outgoing, "message", "now()");
            out_.line(fmt::format("{}send({}_, message);", fits.empty() ? "" : "if (" + fits + ") ", topic.member));
            out_.close();
        }
        out_.close();
    }

    void write_taking(const Incoming& incoming) {
        if (!incoming.type) return out_.line(fmt::format("robot_->{}();", incoming.event->method));
        std::vector<std::string> conditions;
        for (const Taken& taken : incoming.fields) conditions.push_back(taking_condition(taken));
        out_.open("{");
        out_.line(fmt::format("{} value{{}};", type_text(*incoming.type)));
        std::string test = "if";
        for (const Taken& taken : incoming.fields)
            if (taken.scalar.list) {
                refuse_longer(incoming, taken, test);
                test = "} else if";
            }
        const std::string values = conditions.empty() ? "true" : fmt::format("{}", fmt::join(conditions, " && "));
        open_branch(fmt::format("{} ({}) {{", test, values));
        out_.line(incoming.event != nullptr ? fmt::format("robot_->{}(value);", incoming.event->method)
                                            : fmt::format("robot_->{} = value;", incoming.variable->member));
        out_.reopen_block("} else {");
        out_.line(fmt::format(
            "RCLCPP_WARN_THROTTLE(get_logger(), *get_clock(), 5000, \"a message for {} has no value of {}\");",
            incoming.name, generation_.system.type(*incoming.type).name));
        out_.close();
        out_.close();
    }

    /// Opens the first block of an `if`, or the next one.
    void open_branch(const std::string& head) {
        if (head.starts_with('}')) {
            out_.reopen_block(head);
        } else {
            out_.open(head);
        }
    }

    /// Writes code that rejects the whole message if an array has more items than the list that receives it.
    void refuse_longer(const Incoming& incoming, const Taken& taken, const std::string& test) {
        open_branch(fmt::format("{} (message.{}.size() > {}.most) {{", test, taken.field, taken.scalar.place));
        out_.line(
            fmt::format("RCLCPP_WARN_THROTTLE(get_logger(), *get_clock(), 5000, \"a message for {} is refused: {} has "
                        "%zu items, and the capacity is %zu\",",
                        incoming.name, taken.field));
        out_.line(fmt::format("                     message.{}.size(), std::size_t{{{}.most}});", taken.field,
                              taken.scalar.place));
    }

    [[nodiscard]] std::string taking_condition(const Taken& taken) const {
        const std::string field = "message." + taken.field;
        if (!taken.scalar.list) return taking_scalar(taken.scalar, taken.scalar.place, field);
        return fmt::format("::robochart::ros2::take_list({}, {}, [](auto& item, const auto& entry) {{ return {}; }})",
                           taken.scalar.place, field, taking_scalar(taken.scalar, "item", "entry"));
    }

    [[nodiscard]] std::string taking_scalar(const Scalar& scalar, const std::string& place,
                                            const std::string& field) const {
        switch (scalar.kind) {
            case ScalarKind::nat:
                return fmt::format("::robochart::ros2::take_nat({}, {})", place, field);
            case ScalarKind::enumeration:
                return fmt::format("::robochart::ros2::take_literal({}, {}, {})", place, field,
                                   generation_.system.type(scalar.type).labels.size());
            case ScalarKind::truth:
            case ScalarKind::integer:
            case ScalarKind::real:
                break;
        }
        return fmt::format("::robochart::ros2::take({}, {})", place, field);
    }

    void write_cycle() {
        out_.gap();
        out_.open(fmt::format("void {}::cycle() {{", node_));
        if (plan_.is_stamped()) out_.line(fmt::format("{}.now = now();", outbox_));
        for (const Silence& silence : plan_.silences)
            out_.line(fmt::format("if ({}_.is_due(now(), {})) robot_->{}();", silence.member, silence.seconds,
                                  silence.event->method));
        out_.line("const std::int64_t lost = pace_.count_lost(now(), seconds_);");
        out_.line("health_.count_cycle(lost);");
        out_.open("if (lost > 0) {");
        out_.line("RCLCPP_WARN_THROTTLE(get_logger(), *get_clock(), 5000,");
        out_.line("                     \"%s control cycles are lost: the model's clocks and deadlines are late\",");
        out_.line("                     std::to_string(lost).c_str());");
        out_.line("note(\"lost cycles: \" + std::to_string(lost));");
        out_.close();
        if (is_immediate()) out_.line("in_cycle_ = true;");
        out_.line("const ::robochart::StepResult result = robot_->step();");
        if (is_immediate()) out_.line("in_cycle_ = false;");
        out_.line("publish();");
        out_.line("#if ROBOCHART_TRACE");
        out_.line("if (log_ && !log_->good())");
        out_.line(
            "    RCLCPP_ERROR_THROTTLE(get_logger(), *get_clock(), 5000, \"cannot write %s\", log_file_.c_str());");
        out_.line("#endif");
        out_.open("if (result == ::robochart::StepResult::quiescent) {");
        out_.line("if (health_.is_due(now())) send(diagnostics_, health_.report_cycles(now(), get_name(), facts()));");
        out_.line("return;");
        out_.close();
        out_.line("ended_ = true;");
        out_.line("timer_->cancel();");
        if (!plan_.farewells.empty()) out_.line("say_farewell();");
        if (calls_actions()) out_.line("cancel_goals();");
        out_.open("if (result == ::robochart::StepResult::terminated) {");
        out_.line("RCLCPP_INFO(get_logger(), \"the controller has terminated\");");
        out_.line("report_health(::robochart::ros2::Health::Status::OK, \"terminated\");");
        out_.line("return;");
        out_.close();
        out_.line(
            "RCLCPP_ERROR(get_logger(), \"the controller cannot go on (StepResult %d)\", static_cast<int>(result));");
        out_.line("report_health(::robochart::ros2::Health::Status::ERROR, \"the controller cannot go on\");");
        out_.close();
        if (is_immediate()) write_dispatch();
        write_health();
    }

    /// An input that arrives during a cycle, such as a reply within a call, is read by the next cycle of the timer.
    void write_dispatch() {
        out_.gap();
        out_.open(fmt::format("void {}::dispatch() {{", node_));
        out_.line("if (active_ && !ended_ && !in_cycle_) cycle();");
        out_.close();
    }

    /// Writes the function with the data about the running controller that the node reports as its health.
    void write_health() {
        out_.gap();
        out_.open(fmt::format("::robochart::ros2::Health::Facts {}::facts() const {{", node_));
        std::vector<std::string> states;
        for (const StateTopic& state : plan_.states)
            states.push_back(
                fmt::format("{{\"{0}\", {1}::name(robot_->{0}())}}", state.machine->method, api_.cpp_name));
        out_.line(fmt::format("return {{{}}};", fmt::join(states, ", ")));
        out_.close();
        out_.gap();
        out_.open(fmt::format("void {}::report_health(unsigned char level, const char* text) noexcept {{", node_));
        out_.line("send(diagnostics_, health_.report(now(), get_name(), level, text, facts()));");
        out_.close();
    }

    void write_publish() {
        out_.gap();
        out_.open(fmt::format("void {}::publish() {{", node_));
        for (std::size_t i = 0; i < plan_.outgoing.size(); ++i)
            if (plan_.outgoing[i].variable != nullptr) publish_variable(plan_.outgoing[i], last_[i]);
        for (std::size_t i = 0; i < plan_.states.size(); ++i) publish_state(plan_.states[i], last_states_[i]);
        out_.close();
    }

    /// Connects each topic of operations and events with its publisher.
    void write_outbox() {
        out_.gap();
        out_.open(fmt::format("void {}::connect_outbox() {{", node_));
        std::set<std::size_t> connected;
        for (const Outgoing& outgoing : plan_.outgoing)
            if (outgoing.variable == nullptr && !outgoing.cancels && connected.insert(outgoing.topic).second)
                connect_topic(outgoing);
        out_.line(fmt::format("{}.unfit = [this](const char* name) {{ report_unfit(name); }};", outbox_));
        out_.close();
    }

    void connect_topic(const Outgoing& outgoing) {
        const Topic& topic = plan_.topics[outgoing.topic];
        out_.open(fmt::format("{}.{} = [this](const {}& message) {{", outbox_, topic.member, sent_type(topic)));
        if (topic.is_called()) {
            for (const Silence& silence : plan_.silences)
                if (silence.topic == outgoing.topic) out_.line(silence.member + "_.hear(now());");
            if (topic.transport == Transport::action) {
                out_.line(fmt::format("send_goal({0}_, message, \"{1}\");", topic.member, topic.name));
                out_.close("};");
                return connect_action(outgoing.topic);
            }
            out_.line(fmt::format("call<{0}>({1}_, message, [this](const {2}& answer) {{ receive_{1}(answer); }});",
                                  interface_type(topic), topic.member, received_type(topic, Reply::answer)));
            return out_.close("};");
        }
        if (outgoing.kind == ElementKind::operation && !outgoing.mapped) {
            out_.line(fmt::format("if ({0}_ && {0}_->get_subscription_count() == 0)", topic.member));
            out_.line(
                fmt::format("    RCLCPP_WARN_ONCE(get_logger(), \"operation {} is called and nobody does it: nothing "
                            "listens to {}\");",
                            outgoing.name, topic.name));
        }
        out_.line(fmt::format("send({}_, message);", topic.member));
        out_.close("};");
    }

    void connect_action(std::size_t index) {
        const Topic& topic = plan_.topics[index];
        out_.line(fmt::format("{0}.cancel_{1} = [this] {{ cancel_goal({1}_, \"{2}\"); }};", outbox_, topic.member,
                              topic.name));
        for (const Reception& reception : receptions_) {
            if (reception.topic != index) continue;
            const std::string parameter = reception_parameter(reception, "");
            out_.line(fmt::format("{}_.events.{} = [this]{} {{ {}({}); }};", topic.member,
                                  describe_reply(reception.reply), parameter.empty() ? "" : "(" + parameter + ")",
                                  reception_name(reception), parameter.empty() ? "" : "message"));
        }
    }

    /// Writes code that sends messages. An exception must not leave the controller's cycle, which is noexcept.
    void write_sending() {
        out_.gap();
        out_.line("template <class Publisher, class Message>");
        out_.open(fmt::format("void {}::send(const Publisher& publisher, const Message& message) noexcept {{", node_));
        out_.line("if (!publisher) return;");
        out_.open("try {");
        out_.line("publisher->publish(message);");
        out_.reopen_block("} catch (const std::exception& error) {");
        out_.line("RCLCPP_ERROR(get_logger(), \"%s: not published: %s\", publisher->get_topic_name(), error.what());");
        out_.line("note(std::string(\"not published: \") + publisher->get_topic_name());");
        out_.close();
        out_.close();
        if (calls_services()) write_calling();
        if (calls_actions()) write_goals();
        out_.gap();
        out_.open(fmt::format("void {}::report_unfit(const char* name) noexcept {{", node_));
        out_.line("RCLCPP_ERROR(get_logger(), \"%s has a value that its message cannot hold: not published\", name);");
        out_.line("note(std::string(\"not published, unfit: \") + name);");
        out_.close();
    }

    /// Writes calls of services. The answer arrives in the node's callback group, so it never arrives during a cycle or
    /// a transition.
    void write_calling() {
        out_.gap();
        out_.line("template <class Service, class Answer>");
        out_.line(fmt::format("void {}::call(const std::shared_ptr<::rclcpp::Client<Service>>& client,", node_));
        out_.open("                    const typename Service::Request& request, Answer answer) noexcept {");
        out_.line("if (!client) return;");
        out_.open("try {");
        out_.open("if (!client->service_is_ready()) {");
        out_.line(
            "RCLCPP_WARN_THROTTLE(get_logger(), *get_clock(), 5000, \"%s: no service, not called\", "
            "client->get_service_name());");
        out_.line("note(std::string(\"not called: \") + client->get_service_name());");
        out_.line("return;");
        out_.close();
        out_.line(
            "client->async_send_request(std::make_shared<typename Service::Request>(request), "
            "[answer](typename ::rclcpp::Client<Service>::SharedFuture future) { answer(*future.get()); });");
        out_.reopen_block("} catch (const std::exception& error) {");
        out_.line("RCLCPP_ERROR(get_logger(), \"%s: not called: %s\", client->get_service_name(), error.what());");
        out_.line("note(std::string(\"not called: \") + client->get_service_name());");
        out_.close();
        out_.close();
    }

    /// Writes goals of actions. The replies also arrive in the node's callback group. If there is no server, the
    /// earlier goal is given up, too.
    void write_goals() {
        out_.gap();
        out_.line("template <class Goal, class Message>");
        out_.open(
            fmt::format("void {}::send_goal(Goal& goal, const Message& message, const char* name) noexcept {{", node_));
        out_.line("if (!goal.is_connected()) return;");
        out_.open("try {");
        out_.line("goal.forget();");
        out_.open("if (!goal.has_server()) {");
        out_.line(
            "RCLCPP_WARN_THROTTLE(get_logger(), *get_clock(), 5000, \"%s: no action server, not called\", name);");
        out_.line("note(std::string(\"not called: \") + name);");
        out_.line("return;");
        out_.close();
        out_.line("goal.send(message);");
        close_call("not called");
        out_.gap();
        out_.line("template <class Goal>");
        out_.open(fmt::format("void {}::cancel_goal(Goal& goal, const char* name) noexcept {{", node_));
        out_.line("if (!goal.is_connected()) return;");
        out_.open("try {");
        out_.line("goal.cancel();");
        close_call("not canceled");
        out_.gap();
        out_.open(fmt::format("void {}::cancel_goals() noexcept {{", node_));
        for (const Topic& topic : plan_.topics)
            if (topic.transport == Transport::action)
                out_.line(fmt::format("cancel_goal({}_, \"{}\");", topic.member, topic.name));
        out_.close();
    }

    void close_call(const char* failure) {
        out_.reopen_block("} catch (const std::exception& error) {");
        out_.line(fmt::format("RCLCPP_ERROR(get_logger(), \"%s: {}: %s\", name, error.what());", failure));
        out_.line(fmt::format("note(std::string(\"{}: \") + name);", failure));
        out_.close();
        out_.close();
    }

    void publish_variable(const Outgoing& outgoing, const std::string& last) {
        const Topic& topic = plan_.topics[outgoing.topic];
        out_.open(fmt::format("if (!{0} || !(*{0} == robot_->{1})) {{", last, outgoing.variable->member));
        out_.line(fmt::format("const auto& value = robot_->{};", outgoing.variable->member));
        out_.line(fmt::format("{} = value;", last));
        out_.line(fmt::format("{} message;", message_type(topic.message)));
        const std::string fits = fill_message(out_, outgoing, "message", outbox_ + ".now");
        const std::string publish = fmt::format("send({}_, message);", topic.member);
        if (fits.empty()) {
            out_.line(publish);
        } else {
            out_.open(fmt::format("if ({}) {{", fits));
            out_.line(publish);
            out_.reopen_block("} else {");
            out_.line(fmt::format("report_unfit({});", diagnostics::cpp_string(outgoing.name)));
            out_.close();
        }
        out_.close();
    }

    void publish_state(const StateTopic& state, const std::string& last) {
        const std::string& method = state.machine->method;
        out_.open(fmt::format("if (!{0} || *{0} != robot_->{1}()) {{", last, method));
        out_.line(fmt::format("{} = robot_->{}();", last, method));
        out_.line("::std_msgs::msg::String message;");
        out_.line(fmt::format("message.data = {}::name(*{});", api_.cpp_name, last));
        out_.line(fmt::format("send({}_, message);", plan_.topics[state.topic].member));
        out_.close();
    }

    /// Writes the methods for logs. If the log cannot be written, the node is not configured, because a run that is
    /// meant as evidence must not go unrecorded.
    void log_methods() {
        out_.gap();
        out_.open(fmt::format("bool {}::open_log() {{", node_));
        out_.line("#if ROBOCHART_TRACE");
        out_.line("if (log_file_.empty() || log_) return true;");
        out_.line(fmt::format("auto log = std::make_unique<::robochart::TraceFile>({}Messages::RunHeader());",
                              api_.cpp_name));
        out_.open("if (!log->open(log_file_)) {");
        out_.line("RCLCPP_ERROR(get_logger(), \"parameter log: cannot write %s\", log_file_.c_str());");
        out_.line("return false;");
        out_.close();
        if (is_immediate()) out_.line("log->note(\"immediate dispatch: cycles have different lengths\");");
        out_.line("log_ = std::move(log);");
        out_.line("robot_->SetTracer(log_.get());");
        out_.line("return true;");
        out_.line("#else");
        out_.line("if (log_file_.empty()) return true;");
        out_.line(
            "RCLCPP_ERROR(get_logger(), \"parameter log: %s needs a build with -DROBOCHART_TRACE=ON\", "
            "log_file_.c_str());");
        out_.line("return false;");
        out_.line("#endif");
        out_.close();
        out_.gap();
        out_.open(fmt::format("void {}::note([[maybe_unused]] const std::string& text) noexcept {{", node_));
        out_.line("#if ROBOCHART_TRACE");
        out_.line("if (log_) log_->note(text.c_str());");
        out_.line("#endif");
        out_.close();
    }

    [[nodiscard]] std::string type_text(ir::TypeId id) const { return deployed_type(generation_, core_.relative, id); }

    const Generation& generation_;
    const Core& core_;
    const ClassApi& api_;
    const NodePlan& plan_;
    std::vector<NodeConstant> constants_;
    std::string node_, outbox_;
    std::vector<std::string> last_, last_states_;
    std::vector<Reception> receptions_;
    CodeWriter out_;
};

}  // namespace

std::string node_header(const Generation& generation, const Core& core, const ClassApi& api, const NodePlan& plan) {
    return NodeWriter(generation, core, api, plan).write_header();
}

std::string node_source(const Generation& generation, const Core& core, const ClassApi& api, const NodePlan& plan) {
    return NodeWriter(generation, core, api, plan).write_source();
}

std::string constant_lines(const Generation& generation, const Core& core) {
    const std::vector<NodeConstant> constants = node_constants(generation);
    if (constants.empty()) return "";
    std::string text =
        "    # Constants that the model leaves open, as the code was generated (--const). They are shown as "
        "parameters;\n"
        "    # another value is refused, because the code was made and checked for these.\n";
    for (const NodeConstant& constant : constants) {
        const ir::Type& type = generation.system.type(constant.type);
        const std::string value = type.kind == ir::TypeKind::enumeration
                                      ? type.labels[static_cast<std::size_t>(constant.value.number)]
                                      : deployed_value(generation, core, constant.type, constant.value);
        text += fmt::format("    # {}: {}\n", constant.parameter, value);
    }
    return text;
}

}  // namespace robochart::cpp_emit::ros2
