// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/ros2/read_mapping.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>

#include "cpp_emit/plan/options.hpp"
#include "cpp_emit/ros2/ros_names.hpp"
#include "cpp_emit/ros2/rules.hpp"

namespace robochart::cpp_emit::ros2 {

namespace {

using diagnostics::Span;

constexpr std::uint32_t deepest_queue = 10'000;

class MappingReader : public frontend::WordReader {
public:
    MappingReader(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                  diagnostics::Diagnostics& diagnostics)
        : WordReader(sources, source, rules::syntax, diagnostics) {}

    Mapping read() {
        Mapping mapping;
        expect_word("ros2");
        expect_word("for");
        mapping.component = qualified_name("the component of the node");
        expect_word("{");
        while (!has_failed() && !at_word("}")) read_item(mapping);
        expect_word("}");
        if (!has_failed() && !at_end()) fail_expecting("the end of the file");
        return mapping;
    }

private:
    void read_item(Mapping& mapping) {
        if (take_word("on")) return mapping.farewells.push_back(read_farewell());
        if (take_word("parameter")) return mapping.parameters.push_back(read_parameter());
        Item item;
        if (take_word("call")) item.transport = Transport::service;
        item.published = item.transport == Transport::service || take_word("publish");
        if (!item.published && !take_word("receive"))
            fail_expecting("'publish', 'receive', 'call', 'on', 'parameter' or '}'");
        read_element(item);
        if (!has_failed() && item.transport == Transport::service && item.kind != ElementKind::operation)
            report(rules::wrong_name, item.element.span,
                   {item.element.text, "called element", "only an operation calls a service or an action"});
        expect_word("as");
        if (item.transport == Transport::service && take_keyword("cancel")) {
            item.transport = Transport::cancel;
            expect_word("of");
            item.topic = name("the operation that calls an action");
            return mapping.items.push_back(std::move(item));
        }
        if (item.transport == Transport::service && take_keyword("action")) item.transport = Transport::action;
        const bool silence = !item.published && item.kind == ElementKind::event && take_word("deadline");
        if (silence) return mapping.deadlines.push_back(read_deadline(item));
        if (!item.published && item.kind == ElementKind::event && take_reply(item)) {
            expect_word("of");
            item.topic = name("the operation that calls a service or an action");
            if (item.reply != Reply::accepted && item.reply != Reply::rejected) read_tests_and_fields(item);
        } else {
            item.message = read_message(&item.transport);
            read_rest(item);
        }
        mapping.items.push_back(std::move(item));
    }

    /// Takes a word of this notation. If the word is the name of a package, it is not taken.
    bool take_keyword(std::string_view word) { return token_behind().text != "/" && take_word(word); }

    bool take_reply(Item& item) {
        for (const Reply reply : {Reply::answer, Reply::accepted, Reply::rejected, Reply::feedback, Reply::succeeded,
                                  Reply::aborted, Reply::canceled})
            if (take_keyword(describe_reply(reply))) {
                item.transport = Transport::reply;
                item.reply = reply;
                return true;
            }
        return false;
    }

    /// Parses `deactivate publish geometry_msgs/Twist on "cmd_vel" { ... }`.
    Item read_farewell() {
        Item item;
        item.published = true;
        expect_word("deactivate");
        expect_word("publish");
        item.element = {"deactivate", last_span()};
        item.message = read_message();
        read_rest(item);
        return item;
    }

    /// Parses `SPEED as "max_speed"`.
    ParameterName read_parameter() {
        ParameterName result;
        result.constant = qualified_name("a constant of the model");
        expect_word("as");
        const Span begin = current_token().span;
        result.parameter = {read_quoted("a parameter in quotes"), begin};
        report_invalid("parameter", result.parameter, wrong_parameter(result.parameter.text));
        return result;
    }

    /// Parses `0.5 on "scan"` or `5 of dock`.
    Deadline read_deadline(const Item& item) {
        Deadline deadline;
        deadline.event = item.element;
        Source time;
        const Span begin = current_token().span;
        read_number(time);
        const double seconds = has_failed() ? 1 : std::strtod(time.number.c_str(), nullptr);
        if (!(seconds >= 0.001 && seconds <= 3600))
            report(rules::wrong_name, begin, {time.number, "deadline", "it must be from 0.001 to 3600 seconds"});
        deadline.seconds = time.number;
        if (take_word("of")) {
            deadline.transport = Transport::service;
            deadline.topic = name("the operation that calls a service or an action");
        } else {
            deadline.topic = read_topic();
        }
        return deadline;
    }

    Word read_topic() {
        expect_word("on");
        const Span begin = current_token().span;
        Word topic{read_quoted("a topic in quotes"), begin};
        report_invalid("topic", topic, wrong_topic(topic.text));
        return topic;
    }

    /// Parses what follows the message.
    void read_rest(Item& item) {
        item.topic = read_topic();
        if (item.transport == Transport::topic && take_word("with")) read_delivery(item.delivery);
        read_tests_and_fields(item);
    }

    void read_tests_and_fields(Item& item) {
        if (!item.published && take_word("when")) read_conditions(item);
        if (take_word("{")) read_assignments(item);
    }

    /// Parses `percentage < 0.2 and present == true`.
    void read_conditions(Item& item) {
        do {
            Condition condition;
            condition.field = read_path("a field of the message");
            check_fields(condition.field);
            condition.comparison = read_comparison();
            condition.value = read_source(true);
            item.conditions.push_back(std::move(condition));
        } while (!has_failed() && take_word("and"));
    }

    Comparison read_comparison() {
        if (take_word("==")) return Comparison::equal;
        if (take_word("!=")) return Comparison::not_equal;
        if (take_word("<=")) return Comparison::less_equal;
        if (take_word(">=")) return Comparison::greater_equal;
        if (take_word("<")) return Comparison::less;
        if (take_word(">")) return Comparison::greater;
        fail_expecting("'==', '!=', '<', '<=', '>' or '>='");
        return Comparison::equal;
    }

    void read_element(Item& item) {
        if (take_word("operation"))
            item.kind = ElementKind::operation;
        else if (take_word("event"))
            item.kind = ElementKind::event;
        else if (take_word("variable"))
            item.kind = ElementKind::variable;
        else
            fail_expecting("'operation', 'event' or 'variable'");
        item.element = name(fmt::format("the name of the {}", describe_kind(item.kind)));
        if (!has_failed() && item.kind == ElementKind::operation && !item.published)
            report(rules::wrong_name, item.element.span,
                   {item.element.text, "received element", "the controller calls its operations itself"});
    }

    /// Parses `geometry_msgs/Twist` or the full name `geometry_msgs/msg/Twist`; also the name of a service or an
    /// action. If a call has the full name of an action, `nav2_msgs/action/NavigateToPose`, it becomes a call of an
    /// action.
    MessageName read_message(Transport* transport = nullptr) {
        const Word package = name("the package of a message");
        expect_word("/");
        Word type = name("the type of a message");
        if (transport != nullptr && *transport == Transport::service && type.text == "action")
            *transport = Transport::action;
        if ((type.text == "msg" || type.text == "action" || type.text == "srv") && take_word("/"))
            type = name("the type of a message");
        report_invalid("package", package, wrong_package(package.text));
        report_invalid("message", type, wrong_message(type.text));
        return {package.text, type.text, diagnostics::join_spans(package.span, type.span)};
    }

    /// Parses `best_effort transient_local depth 5`; each option may occur once.
    void read_delivery(Delivery& delivery) {
        bool some = false;
        for (bool more = true; more && !has_failed(); some = some || more) {
            more = true;
            if (at_word("reliable") || at_word("best_effort"))
                set_once(delivery.reliable, at_word("reliable"), "the reliability");
            else if (at_word("transient_local") || at_word("volatile"))
                set_once(delivery.latched, at_word("transient_local"), "the durability");
            else if (take_word("depth"))
                read_depth(delivery);
            else
                more = false;
        }
        if (!some) fail_expecting("'reliable', 'best_effort', 'transient_local', 'volatile' or 'depth'");
    }

    void set_once(std::optional<bool>& place, bool value, const char* what) {
        advance_token();
        if (place) report(rules::said_twice, last_span(), {what});
        place = value;
    }

    void read_depth(Delivery& delivery) {
        const std::uint32_t depth = read_count(deepest_queue);
        if (delivery.depth) report(rules::said_twice, last_span(), {"the depth"});
        delivery.depth = depth;
    }

    void read_capacity(Assignment& assignment) {
        const Span begin = last_span();
        const std::size_t items = read_count(greatest_capacity);
        assignment.capacity = {items, diagnostics::join_spans(begin, last_span())};
    }

    /// Reads a whole number from 1 to `most`.
    std::uint32_t read_count(std::uint32_t most) {
        const frontend::Token next = current_token();
        std::uint32_t number = 0;
        const char* const end = next.text.data() + next.text.size();
        const auto [rest, code] = std::from_chars(next.text.data(), end, number);
        const bool whole = next.kind == frontend::TokenKind::integer && code == std::errc() && rest == end;
        if (!whole || number == 0 || number > most) {
            fail_expecting(fmt::format("a number from 1 to {}", most));
            return 1;
        }
        advance_token();
        return number;
    }

    void read_assignments(Item& item) {
        while (!has_failed() && !at_word("}")) {
            Assignment assignment;
            assignment.target = read_path("a field");
            expect_word("=");
            assignment.source = read_source(item.published);
            if (!item.published && take_word("capacity")) read_capacity(assignment);
            check_fields(item.published ? assignment.target : assignment.source.path);
            item.assignments.push_back(std::move(assignment));
        }
        expect_word("}");
    }

    Path read_path(std::string_view what) {
        Path path;
        path.words.push_back(name(what));
        while (take_word(".")) path.words.push_back(name(what));
        return path;
    }

    /// Checks names of fields, because they are written to generated code.
    void check_fields(const Path& path) {
        for (const Word& word : path.words) report_invalid("field", word, wrong_field(word.text));
    }

    Source read_source(bool published) {
        Source source;
        const Span begin = current_token().span;
        if (!published) {
            source.path = read_path("a field of the message");
        } else if (at_number()) {
            read_number(source);
        } else if (current_token().kind == frontend::TokenKind::string) {
            source.kind = Source::Kind::text;
            source.text = read_quoted("a text");
        } else {
            source.path = read_path("a parameter, 'value' or a literal");
            const std::string word = source.path.path_text();
            if (word == "true" || word == "false") source.kind = Source::Kind::truth;
        }
        source.span = diagnostics::join_spans(begin, last_span());
        return source;
    }

    void read_number(Source& source) {
        const bool negative = take_word("-");
        const frontend::Token next = current_token();
        const bool whole = next.kind == frontend::TokenKind::integer;
        if (!whole && next.kind != frontend::TokenKind::real) return fail_expecting("a number");
        source.kind = whole ? Source::Kind::whole : Source::Kind::decimal;
        std::int64_t value = 0;
        const auto [rest, code] = std::from_chars(next.text.data(), next.text.data() + next.text.size(), value);
        if (whole && code != std::errc()) return fail_expecting("a number of at most 64 bits");
        double real = 0;
        std::from_chars(next.text.data(), next.text.data() + next.text.size(), real);
        source.number = (negative ? "-" : "") + (whole ? fmt::format("{}", value) : fmt::format("{:#}", real));
        advance_token();
    }

    void report_invalid(const char* kind, const Word& word, const std::string& wrong) {
        if (!wrong.empty()) report(rules::wrong_name, word.span, {word.text, kind, wrong});
    }
};

}  // namespace

std::string_view describe_kind(ElementKind kind) {
    switch (kind) {
        case ElementKind::operation:
            return "operation";
        case ElementKind::event:
            return "event";
        case ElementKind::variable:
            break;
    }
    return "variable";
}

std::string_view describe_reply(Reply reply) {
    switch (reply) {
        case Reply::answer:
            return "answer";
        case Reply::accepted:
            return "accepted";
        case Reply::rejected:
            return "rejected";
        case Reply::feedback:
            return "feedback";
        case Reply::succeeded:
            return "succeeded";
        case Reply::aborted:
            return "aborted";
        case Reply::canceled:
            break;
    }
    return "canceled";
}

bool ends_call(Reply reply) {
    return reply != Reply::accepted && reply != Reply::feedback;
}

std::string Path::path_text() const {
    std::string result;
    for (const Word& word : words) result += (result.empty() ? "" : ".") + word.text;
    return result;
}

Span Path::span() const {
    return words.empty() ? Span{} : diagnostics::join_spans(words.front().span, words.back().span);
}

Mapping read_mapping(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                     diagnostics::Diagnostics& diagnostics) {
    return MappingReader(sources, source, diagnostics).read();
}

}  // namespace robochart::cpp_emit::ros2
