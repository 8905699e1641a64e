// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/ros2/node_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/diagnostics/spelling.hpp"
#include "cpp_emit/plan/rules.hpp"
#include "cpp_emit/ros2/elements.hpp"
#include "cpp_emit/ros2/messages.hpp"
#include "cpp_emit/ros2/model_values.hpp"
#include "cpp_emit/ros2/node_constants.hpp"
#include "cpp_emit/ros2/ros_names.hpp"
#include "cpp_emit/ros2/rules.hpp"
#include "cpp_emit/ros2/time_use.hpp"

namespace robochart::cpp_emit::ros2 {

namespace {

using diagnostics::Span;

std::string suggest_name(const std::string& name, const std::vector<std::string>& known) {
    const std::string meant = diagnostics::nearest_spelling(name, known);
    return meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant);
}

bool is_modelled(const ClassApi& api, const std::string& name) {
    bool found = false;
    each_class(api, [&](const ApiClass& part) {
        for (const ApiOperation& operation : part.operations)
            found = found || (operation.modelled && operation.signature->name == name);
    });
    return found;
}

/// Returns whether the fields overlap: one contains the other, or both are the same.
bool fields_overlap(const std::string& a, const std::string& b) {
    return a == b || a.starts_with(b + ".") || b.starts_with(a + ".");
}

class Planner {
public:
    Planner(const Generation& generation, const ClassApi& api, diagnostics::Diagnostics& diagnostics)
        : generation_(generation), api_(api), diagnostics_(diagnostics) {
        style_ = generation.options.model_names ? NameStyle::model : NameStyle::snake;
        plan_.node = style_ == NameStyle::model ? generation.component.cpp_name
                                                : topic_part(generation.component.cpp_name, style_);
        for (const char* const own : {"message", "outbox", "unfit", "now"}) members_.reserve_name(own);
    }

    NodePlan make_plan() {
        std::vector<Element> elements = elements_of(generation_, api_);
        const Mapping* const mapping = generation_.options.mapping;
        if (mapping != nullptr) {
            match_items(*mapping, elements);
            match_deadlines(*mapping, elements);
            match_parameters(*mapping);
        }
        for (const ApiMachine& machine : api_.machines)
            plan_.states.push_back({&machine, topic_index({"~/" + topic_part(machine.method, style_),
                                                           {"std_msgs", "String", {}},
                                                           latched_quality(),
                                                           true,
                                                           "",
                                                           machine.method},
                                                          generation_.component.origin.span)});
        for (const Element& element : elements)
            if (!element.is_mapped()) add_default(element);
        for (const Element& element : elements)
            if (element.item != nullptr && !names_call(*element.item)) add_mapped(element);
        for (const Element& element : elements)
            if (element.item != nullptr && names_call(*element.item)) add_to_call(element);
        for (const Element& element : elements)
            if (element.deadline != nullptr) add_silence(element);
        if (mapping != nullptr)
            for (const Item& item : mapping->farewells) add_farewell(item);
        note_defaults();
        if (generation_.options.dispatch == Dispatch::immediate) check_dispatch();
        collect_packages();
        return std::move(plan_);
    }

private:
    static QualityOfService latched_quality() { return {true, true, 1}; }

    // ------------------------------------------------------------ names in the mapping

    void match_items(const Mapping& mapping, std::vector<Element>& elements) {
        for (const Item& item : mapping.items) {
            diagnostics_.poll();
            Element* found = nullptr;
            for (Element& element : elements)
                if (element.kind == item.kind && element.published == item.published &&
                    element.name == item.element.text && found == nullptr)
                    found = &element;
            if (found == nullptr) {
                report_unknown(item, elements);
            } else if (found->item != nullptr) {
                diagnostics_.report(rules::said_twice, item.element.span,
                                    {fmt::format("{} '{}'", describe_kind(item.kind), item.element.text)});
            } else {
                found->item = &item;
            }
            if (!names_call(item)) note_unchecked(data_of(item, item.message));
        }
    }

    /// Returns whether the item belongs to a service or action that another item calls.
    static bool names_call(const Item& item) {
        return item.transport == Transport::reply || item.transport == Transport::cancel;
    }

    /// Returns the message that has the fields of an item: a part of a service or an action.
    static MessageName data_of(const Item& item, MessageName message) {
        if (item.transport == Transport::service) message.type += "_Request";
        if (item.transport == Transport::action) message.type += "_Goal";
        if (item.transport != Transport::reply) return message;
        if (item.reply == Reply::answer)
            message.type += "_Response";
        else
            message.type += item.reply == Reply::feedback ? "_Feedback" : "_Result";
        return message;
    }

    void match_deadlines(const Mapping& mapping, std::vector<Element>& elements) {
        for (const Deadline& deadline : mapping.deadlines) {
            std::vector<std::string> known;
            Element* found = nullptr;
            for (Element& element : elements) {
                if (element.kind != ElementKind::event || element.published || element.event->port->type) continue;
                known.push_back(element.name);
                if (element.name == deadline.event.text && found == nullptr) found = &element;
            }
            if (found == nullptr) {
                diagnostics_.report(
                    rules::unknown_name, deadline.event.span,
                    {fmt::format("'{}'", generation_.component.name), "event without a value to receive",
                     deadline.event.text, suggest_name(deadline.event.text, known)});
            } else if (found->is_mapped()) {
                diagnostics_.report(rules::said_twice, deadline.event.span,
                                    {fmt::format("event '{}'", deadline.event.text)});
            } else {
                found->deadline = &deadline;
            }
        }
    }

    /// Matches parameters and constants. A parameter names one constant, and a constant has one parameter.
    void match_parameters(const Mapping& mapping) {
        const std::vector<NodeConstant> constants = node_constants(generation_);
        std::set<std::string> paths;
        for (const ParameterName& given : mapping.parameters) {
            std::vector<std::string> known, found;
            for (const NodeConstant& constant : constants) {
                known.push_back(constant.path.substr(constant.path.rfind(':') + 1));
                if (names_constant(given.constant.text, constant.path)) found.push_back(constant.path);
            }
            if (found.empty()) {
                diagnostics_.report(rules::unknown_name, given.constant.span,
                                    {fmt::format("'{}'", generation_.component.name), "constant without a value",
                                     given.constant.text, suggest_name(given.constant.text, known)});
            } else if (found.size() > 1) {
                diagnostics_.report(rules::unknown_name, given.constant.span,
                                    {fmt::format("'{}'", generation_.component.name), "single constant",
                                     given.constant.text, fmt::format("; write {}", fmt::join(found, " or "))});
            } else if (!paths.insert(found.front()).second) {
                diagnostics_.report(rules::said_twice, given.constant.span,
                                    {fmt::format("constant '{}'", found.front())});
            }
        }
        std::map<std::string, int> names;
        for (const NodeConstant& constant : constants) ++names[constant.parameter];
        for (const ParameterName& given : mapping.parameters)
            if (const auto name = names.find(given.parameter.text); name != names.end() && name->second > 1)
                diagnostics_.report(rules::said_twice, given.parameter.span,
                                    {fmt::format("parameter '{}'", given.parameter.text)});
    }

    /// Adds a deadline. Another item must receive its topic.
    void add_silence(const Element& element) {
        const Word& topic = element.deadline->topic;
        const std::string member = members_.unique_name("watch_" + element.event->method);
        if (element.deadline->transport == Transport::service) {
            if (const auto service = call_of(topic, {Transport::service, Transport::action}))
                plan_.silences.push_back({element.event, element.deadline->seconds, *service, member});
            return;
        }
        std::vector<std::string> known;
        for (std::size_t i = 0; i < plan_.topics.size(); ++i) {
            if (plan_.topics[i].published) continue;
            known.push_back(plan_.topics[i].name);
            if (resolve_name(known.back()) != resolve_name(topic.text)) continue;
            plan_.silences.push_back({element.event, element.deadline->seconds, i, member});
            return;
        }
        diagnostics_.report(rules::unknown_name, topic.span,
                            {"the mapping", "received topic", topic.text, suggest_name(topic.text, known)});
    }

    /// Returns the service or action that the operation calls. Returns no value and reports a finding if it calls none.
    std::optional<std::size_t> call_of(const Word& operation, const std::set<Transport>& transports) {
        std::vector<std::string> known;
        for (const Outgoing& out : plan_.outgoing) {
            if (out.cancels || !transports.contains(plan_.topics[out.topic].transport)) continue;
            if (out.name == operation.text) return out.topic;
            known.push_back(out.name);
        }
        diagnostics_.report(
            rules::unknown_name, operation.span,
            {"the mapping", describe_call(transports), operation.text, suggest_name(operation.text, known)});
        return std::nullopt;
    }

    static const char* describe_call(const std::set<Transport>& transports) {
        if (transports.size() > 1) return "operation that calls a service or an action";
        return transports.contains(Transport::action) ? "operation that calls an action"
                                                      : "operation that calls a service";
    }

    /// Adds a service. Two operations that call the same service would get each other's answers.
    std::size_t add_service(const Element& element) {
        const Item& item = *element.item;
        Topic service{item.topic.text, item.message, {}, true, "", element.name, item.transport};
        for (const Topic& other : plan_.topics)
            if (other.transport == service.transport && resolve_name(other.name) == resolve_name(service.name))
                diagnostics_.report(rules::shared_topic, item.topic.span,
                                    {element.name, service.name, other.user,
                                     item.transport == Transport::action ? "it is an action" : "it is a service"});
        std::string stem = service.name;
        std::ranges::replace(stem, '/', '_');
        service.member = members_.unique_name("call_" + to_identifier(stem));
        plan_.topics.push_back(std::move(service));
        return plan_.topics.size() - 1;
    }

    /// Adds a message that is published when the node stops. If its item gives no quality of service, the message has
    /// that of the other messages on its topic.
    void add_farewell(const Item& item) {
        Element element;
        element.published = true;
        element.name = item.element.text;
        element.span = item.element.span;
        element.item = &item;
        note_unchecked(item.message);
        QualityOfService quality = quality_of(element, item.message, item.delivery);
        const bool given = item.delivery.reliable || item.delivery.latched || item.delivery.depth;
        for (const Topic& topic : plan_.topics)
            if (!given && topic.published && resolve_name(topic.name) == resolve_name(item.topic.text))
                quality = topic.quality;
        Outgoing out = make_outgoing(
            element, topic_index({item.topic.text, item.message, quality, true, "", element.name}, item.topic.span));
        plan_fields(element, out);
        plan_.farewells.push_back(std::move(out));
    }

    void report_unknown(const Item& item, const std::vector<Element>& elements) {
        std::vector<std::string> known;
        std::string other;
        for (const Element& element : elements) {
            if (element.kind == item.kind && element.published == item.published) known.push_back(element.name);
            if (element.name == item.element.text)
                other = fmt::format("; write '{} {} {}'", element.published ? "publish" : "receive",
                                    describe_kind(element.kind), element.name);
        }
        if (item.kind == ElementKind::operation && is_modelled(api_, item.element.text))
            other = "; the model defines it, so it runs as modelled";
        const std::string what =
            fmt::format("{} to {}", describe_kind(item.kind), item.published ? "publish" : "receive");
        diagnostics_.report(rules::unknown_name, item.element.span,
                            {fmt::format("'{}'", generation_.component.name), what, item.element.text,
                             other.empty() ? suggest_name(item.element.text, known) : other});
    }

    void note_unchecked(const MessageName& message) {
        if (is_known(message) || !noted_.insert(message.full_name()).second) return;
        diagnostics_.report(rules::not_checked, message.span,
                            {message.full_name(), suggest_name(message.type, known_messages(message.package))});
    }

    // ------------------------------------------------------------ topics

    /// Returns the topic as ROS resolves it without a namespace and remappings.
    [[nodiscard]] std::string resolve_name(const std::string& name) const {
        if (name.starts_with("~/")) return "/" + plan_.node + name.substr(1);
        return name.starts_with('/') ? name : "/" + name;
    }

    /// Returns the reason why two elements cannot share a topic; "" if they can share it.
    static std::string describe_conflict(const Topic& first, const Topic& second) {
        if (first.published != second.published) return "one is published, and the other is received";
        if (!(first.message == second.message))
            return fmt::format("one is {} and the other {}", first.message.full_name(), second.message.full_name());
        return first.quality == second.quality ? "" : "they differ in quality of service";
    }

    std::size_t topic_index(Topic topic, Span span) {
        for (std::size_t i = 0; i < plan_.topics.size(); ++i) {
            if (plan_.topics[i].is_called() || resolve_name(plan_.topics[i].name) != resolve_name(topic.name)) continue;
            const std::string why = describe_conflict(plan_.topics[i], topic);
            if (!why.empty())
                diagnostics_.report(rules::shared_topic, span, {topic.user, topic.name, plan_.topics[i].user, why});
            return i;
        }
        std::string stem = topic.name;
        std::ranges::replace(stem, '/', '_');
        topic.member = members_.unique_name((topic.published ? "to_" : "from_") + to_identifier(stem));
        plan_.topics.push_back(std::move(topic));
        return plan_.topics.size() - 1;
    }

    /// Returns the default topic, such as "~/out/move". If names differ only in underscores, a number is appended.
    std::string default_topic(const char* kind, const std::string& name) {
        const std::string stem = fmt::format("~/{}/{}", kind, topic_part(name, style_));
        std::string topic = stem;
        for (int i = 2; !default_topics_.insert(topic).second; ++i) topic = fmt::format("{}_{}", stem, i);
        return topic;
    }

    static QualityOfService quality_of(const Element& element, const MessageName& message, const Delivery& delivery) {
        QualityOfService quality;
        if (element.published && element.kind == ElementKind::variable) quality = latched_quality();
        // Drivers of sensors publish with best effort, and a reliable subscription would not receive their messages.
        if (!element.published && message.package == "sensor_msgs") quality = {false, false, 5};
        quality.reliable = delivery.reliable.value_or(quality.reliable);
        quality.latched = delivery.latched.value_or(quality.latched);
        quality.depth = delivery.depth.value_or(quality.depth);
        return quality;
    }

    // ------------------------------------------------------------ without a mapping

    void add_default(const Element& element) {
        const std::vector<ModelValue> values = values_of(element);
        std::vector<Scalar> scalars;
        bool carried = true;
        for (const ModelValue& value : values) {
            const auto kind = scalar_kind(generation_.system.type(value.type));
            carried = carried && kind.has_value();
            if (kind) scalars.push_back({*kind, value.type, value.place, value.name});
        }
        if (!carried) {
            diagnostics_.report(
                cpp_emit::rules::no_project, element.span,
                {"ros2", generation_.component.name,
                 fmt::format("std_msgs has no message for the {} '{}'", describe_kind(element.kind), element.name)});
            return;
        }
        const MessageName message = default_message(scalars);
        const std::size_t place = topic_index({default_topic(topic_kind(element), element.name), message,
                                               quality_of(element, message, {}), element.published, "", element.name},
                                              element.span);
        if (element.published) {
            Outgoing out = make_outgoing(element, place);
            out.array = scalars.size() > 1;
            for (const Scalar& scalar : scalars) out.fields.push_back({"data", scalar, "", false});
            plan_.outgoing.push_back(std::move(out));
        } else {
            Incoming in = make_incoming(element, place);
            if (!scalars.empty()) in.fields.push_back({"data", scalars.front()});
            plan_.incoming.push_back(std::move(in));
        }
    }

    /// Returns the word for the element's kind and direction in its default topic.
    static const char* topic_kind(const Element& element) {
        switch (element.kind) {
            case ElementKind::variable:
                return element.published ? "variable" : "set";
            case ElementKind::operation:
                return "out";
            case ElementKind::event:
                break;
        }
        return element.published ? "sent" : "in";
    }

    static MessageName default_message(const std::vector<Scalar>& scalars) {
        if (scalars.empty()) return {"std_msgs", "Empty", {}};
        if (scalars.size() == 1) return {"std_msgs", message_of(scalars.front().kind), {}};
        return {"std_msgs", "Float64MultiArray", {}};
    }

    static Outgoing make_outgoing(const Element& element, std::size_t topic) {
        Outgoing out;
        out.kind = element.kind;
        out.name = element.name;
        out.operation = element.operation;
        out.event = element.event;
        out.variable = element.variable;
        out.topic = topic;
        out.mapped = element.item != nullptr;
        return out;
    }

    static Incoming make_incoming(const Element& element, std::size_t topic) {
        return {element.name, element.event, element.variable, type_of(element), topic, {}};
    }

    // ------------------------------------------------------------ with one

    /// Adds an item that belongs to a call: a reply of a service or an action, or a cancellation.
    void add_to_call(const Element& element) {
        const Item& item = *element.item;
        const bool service = item.transport == Transport::reply && item.reply == Reply::answer;
        const auto call = call_of(item.topic, {service ? Transport::service : Transport::action});
        if (!call) return;
        if (item.transport == Transport::cancel) {
            plan_.outgoing.push_back(make_outgoing(element, *call));
            plan_.outgoing.back().cancels = true;
            return plan_fields(element, plan_.outgoing.back());
        }
        Incoming in = make_incoming(element, *call);
        in.reply = item.reply;
        plan_reception(element, std::move(in));
    }

    void add_mapped(const Element& element) {
        const Item& item = *element.item;
        if (item.transport != Transport::topic) {
            plan_.outgoing.push_back(make_outgoing(element, add_service(element)));
            return plan_fields(element, plan_.outgoing.back());
        }
        const std::size_t place =
            topic_index({item.topic.text, item.message, quality_of(element, item.message, item.delivery),
                         item.published, "", element.name},
                        item.topic.span);
        if (item.published) {
            plan_.outgoing.push_back(make_outgoing(element, place));
            plan_fields(element, plan_.outgoing.back());
        } else {
            plan_reception(element, make_incoming(element, place));
        }
    }

    void plan_fields(const Element& element, Outgoing& out) {
        const std::vector<ModelValue> values = values_of(element);
        std::set<std::string> used;
        for (const Assignment& assignment : element.item->assignments) {
            diagnostics_.poll();
            const std::optional<FieldType> field = field_of(*element.item, assignment.target);
            if (!field) continue;
            const std::string text = assignment.target.path_text();
            for (const Filled& before : out.fields)
                if (fields_overlap(before.field, text))
                    diagnostics_.report(rules::said_twice, assignment.target.span(),
                                        {fmt::format("the field '{}'", text)});
            Filled filled{text, {}, "", false};
            const bool value =
                assignment.source.kind == Source::Kind::path || assignment.source.kind == Source::Kind::truth;
            if (value && names_value(values, assignment.source.path)) {
                filled.scalar = scalar_of(element, values, assignment.source.path, *field, assignment.target);
                if (filled.scalar) used.insert(filled.scalar->reading);
            } else {
                fill_literal(element, values, assignment, *field, filled);
            }
            out.fields.push_back(std::move(filled));
        }
        for (const ModelValue& value : values) warn_unsent(element, value, used);
    }

    static bool names_value(const std::vector<ModelValue>& values, const Path& path) {
        return std::ranges::any_of(values,
                                   [&](const ModelValue& value) { return value.name == path.words.front().text; });
    }

    void warn_unsent(const Element& element, const ModelValue& value, const std::set<std::string>& used) {
        std::vector<Scalar> scalars;
        if (!scalars_of(generation_.system, value, scalars))
            scalars.push_back({ScalarKind::real, value.type, value.place, value.name});
        for (const Scalar& scalar : scalars)
            if (!used.contains(scalar.reading))
                diagnostics_.report(
                    rules::not_sent, element.item->element.span,
                    {fmt::format("'{}'", scalar.reading), std::string(describe_kind(element.kind)), element.name});
    }

    void plan_reception(const Element& element, Incoming in) {
        const std::vector<ModelValue> values = values_of(element);
        std::set<std::string> used;
        for (const Assignment& assignment : element.item->assignments) {
            diagnostics_.poll();
            const std::optional<FieldType> field = field_of(*element.item, assignment.source.path);
            if (!field) continue;
            const auto scalar = scalar_of(element, values, assignment.target, *field, assignment.source.path);
            if (!scalar) continue;
            if (assignment.capacity && !scalar->list)
                diagnostics_.report(
                    rules::wrong_type, assignment.capacity->span,
                    {"a capacity", "for an array", fmt::format("the field '{}'", assignment.source.path.path_text()),
                     describe_field(*field)});
            if (!used.insert(scalar->reading).second)
                diagnostics_.report(rules::said_twice, assignment.target.span(),
                                    {fmt::format("'{}'", scalar->reading)});
            in.fields.push_back({assignment.source.path.path_text(), *scalar});
        }
        for (const ModelValue& value : values) require_all(element, value, used);
        for (const Condition& condition : element.item->conditions) plan_test(*element.item, condition, in);
        const bool topic = element.item->transport == Transport::topic;
        if (topic && values.empty() && element.item->assignments.empty() && element.item->conditions.empty())
            warn_unread(element);
        plan_.incoming.push_back(std::move(in));
    }

    /// Plans the test of a condition. Truth values and texts can only be compared for equality. A number in a condition
    /// is compared as a value of the field's type.
    void plan_test(const Item& item, const Condition& condition, Incoming& in) {
        const std::optional<FieldType> field = field_of(item, condition.field);
        if (!field) return;
        const Source& source = condition.value;
        const FieldKind kind = field->kind;
        const bool equality =
            condition.comparison == Comparison::equal || condition.comparison == Comparison::not_equal;
        const bool number = kind == FieldKind::whole || kind == FieldKind::real || kind == FieldKind::unknown;
        bool good = false;
        std::string text;
        switch (source.kind) {
            case Source::Kind::path:
                break;
            case Source::Kind::whole:
                good = number;
                text = fmt::format("std::int64_t{{{}}}", source.number);
                break;
            case Source::Kind::decimal:
                good = number;
                text = source.number;
                break;
            case Source::Kind::truth:
                good = equality && (kind == FieldKind::truth || kind == FieldKind::unknown);
                text = source.path.path_text();
                break;
            case Source::Kind::text:
                good = equality && (kind == FieldKind::text || kind == FieldKind::unknown);
                text = diagnostics::cpp_string(source.text);
                break;
        }
        if (good) return in.tests.push_back({condition.field.path_text(), condition.comparison, text});
        const char* const expected = equality ? "no value that can be equal to the field"
                                              : "no number, or the field is none; only numbers are ordered";
        diagnostics_.report(rules::wrong_type, source.span,
                            {"the value", expected, fmt::format("the field '{}'", condition.field.path_text()),
                             describe_field(*field)});
    }

    /// Warns of fields that have no effect. Every message raises an event without a value, for any contents of its
    /// fields.
    void warn_unread(const Element& element) {
        const MessageName& message = element.item->message;
        const std::vector<std::string> fields = fields_of(message.full_name());
        if (fields.empty()) return;
        std::string some = fmt::format("'{}'", fields.front());
        if (fields.size() > 1) some += fmt::format(" and {} more", fields.size() - 1);
        diagnostics_.report(rules::not_asked, element.item->element.span, {message.full_name(), element.name, some});
    }

    void require_all(const Element& element, const ModelValue& value, const std::set<std::string>& used) {
        std::vector<Scalar> scalars;
        if (!scalars_of(generation_.system, value, scalars)) {
            diagnostics_.report(rules::wrong_type, element.item->element.span,
                                {fmt::format("the value of '{}'", element.name),
                                 describe_type(generation_.system.type(value.type)), "a value from a message",
                                 "a truth value, a number, an enumeration, a sequence of these or a record of them"});
            return;
        }
        for (const Scalar& scalar : scalars)
            if (!used.contains(scalar.reading))
                diagnostics_.report(
                    rules::incomplete, element.item->element.span,
                    {fmt::format("'{}'", scalar.reading), std::string(describe_kind(element.kind)), element.name});
    }

    /// Returns the field's type. Returns no value and reports a finding if the message does not have the field.
    std::optional<FieldType> field_of(const Item& item, const Path& path) {
        MessageName message = item.message;
        if (item.transport == Transport::reply)
            for (const Outgoing& out : plan_.outgoing)
                if (plan_.topics[out.topic].is_called() && !out.cancels && out.name == item.topic.text)
                    message = plan_.topics[out.topic].message;
        const FoundField found = find_field(data_of(item, message), path);
        if (found.missing == path.words.size()) return found.type;
        const Word& word = path.words[found.missing];
        diagnostics_.report(rules::unknown_field, word.span,
                            {std::string(found.in), word.text, suggest_name(word.text, fields_of(found.in))});
        return std::nullopt;
    }

    /// Returns the part of the element's value that the path names, if the field can carry it.
    std::optional<Scalar> scalar_of(const Element& element, const std::vector<ModelValue>& values, const Path& path,
                                    const FieldType& field, const Path& field_path) {
        const FoundScalar found = find_scalar(generation_.system, values, path);
        const std::string place = fmt::format("{} '{}'", describe_kind(element.kind), element.name);
        if (found.missing < path.words.size()) {
            const Word& word = path.words[found.missing];
            std::string what = element.kind == ElementKind::operation ? "parameter" : "value";
            if (found.missing > 0) what = "field";
            diagnostics_.report(rules::unknown_name, word.span,
                                {place, what, word.text, suggest_name(word.text, found.known)});
            return std::nullopt;
        }
        if (found.scalar && fits_field(field, *found.scalar, element.published)) return found.scalar;
        diagnostics_.report(rules::wrong_type, path.span(),
                            {fmt::format("'{}'", path.path_text()), describe_type(generation_.system.type(*found.type)),
                             fmt::format("the field '{}'", field_path.path_text()), describe_field(field)});
        return std::nullopt;
    }

    void fill_literal(const Element& element, const std::vector<ModelValue>& values, const Assignment& assignment,
                      const FieldType& field, Filled& filled) {
        const FieldKind kind = field.kind;
        bool good = kind == FieldKind::unknown;
        const char* what = "a text";
        switch (assignment.source.kind) {
            case Source::Kind::path:
                if (assignment.source.path.path_text() != "now") {
                    (void)scalar_of(element, values, assignment.source.path, field, assignment.target);
                    return;
                }
                what = "a time";
                good = good || kind == FieldKind::time;
                filled.now = true;
                break;
            case Source::Kind::whole:
                what = "a whole number";
                good = good || kind == FieldKind::real || kind == FieldKind::whole;
                if (good && !holds_number(field, assignment.source.number)) {
                    good = false;
                    what = "out of its range";
                }
                filled.literal = fmt::format("std::int64_t{{{}}}", assignment.source.number);
                break;
            case Source::Kind::decimal:
                what = "a number";
                good = good || kind == FieldKind::real;
                filled.literal = assignment.source.number;
                break;
            case Source::Kind::truth:
                what = "a truth value";
                good = good || kind == FieldKind::truth;
                filled.literal = assignment.source.path.path_text();
                break;
            case Source::Kind::text:
                good = good || kind == FieldKind::text;
                filled.literal = diagnostics::cpp_string(assignment.source.text);
                break;
        }
        if (!good)
            diagnostics_.report(rules::wrong_type, assignment.source.span,
                                {"the value", what, fmt::format("the field '{}'", assignment.target.path_text()),
                                 describe_field(field)});
    }

    // ------------------------------------------------------------ the whole

    void note_defaults() {
        std::vector<std::string> names;
        for (const Outgoing& out : plan_.outgoing)
            if (out.kind == ElementKind::operation && !out.mapped)
                names.push_back(fmt::format("{} ({})", out.name, plan_.topics[out.topic].name));
        if (!names.empty())
            diagnostics_.report(rules::not_mapped, generation_.component.origin.span,
                                {generation_.component.name, fmt::format("{}", fmt::join(names, ", "))});
    }

    /// A cycle that an input begins is shorter than the others, which is right only if the model counts no time.
    void check_dispatch() {
        const Component& component = generation_.component;
        const auto use = find_time_use(component);
        if (use)
            diagnostics_.report(rules::counts_time, use->span.is_known() ? use->span : component.origin.span,
                                {component.name, use->text});
        else
            diagnostics_.report(rules::dispatched, component.origin.span, {component.name});
    }

    void collect_packages() {
        std::set<std::string> names{"diagnostic_msgs", "rcl_interfaces", "std_msgs"};
        for (const Topic& topic : plan_.topics) names.insert(topic.message.package);
        if (plan_.is_stamped()) names.insert("builtin_interfaces");
        if (plan_.calls(Transport::action)) names.insert("rclcpp_action");
        plan_.packages.assign(names.begin(), names.end());
        names.insert({"ament_cmake", "ament_index_python", "launch", "launch_ros", "lifecycle_msgs", "rclcpp",
                      "rclcpp_components", "rclcpp_lifecycle"});
        plan_.package = package_name(generation_.component.name, names);
        plan_.files = style_ == NameStyle::model ? api_.cpp_name : plan_.package;
    }

    const Generation& generation_;
    const ClassApi& api_;
    diagnostics::Diagnostics& diagnostics_;
    NodePlan plan_;
    NameStyle style_ = NameStyle::snake;
    NameScope members_;
    std::set<std::string> default_topics_;
    std::set<std::string> noted_;
};

}  // namespace

bool NodePlan::calls(Transport transport) const {
    return std::ranges::any_of(topics, [transport](const Topic& topic) { return topic.transport == transport; });
}

bool NodePlan::is_stamped() const {
    return std::ranges::any_of(outgoing, [](const Outgoing& out) {
        return std::ranges::any_of(out.fields, [](const Filled& field) { return field.now; });
    });
}

NodePlan plan_node(const Generation& generation, const ClassApi& api, diagnostics::Diagnostics& diagnostics) {
    return Planner(generation, api, diagnostics).make_plan();
}

}  // namespace robochart::cpp_emit::ros2
