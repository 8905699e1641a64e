// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/ros2/read_mapping.hpp"

#include <fmt/format.h>

#include <charconv>

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
        expect("ros2");
        expect("for");
        mapping.component = qualified_name("the component of the node");
        expect("{");
        while (!failed() && !at("}")) mapping.items.push_back(item());
        expect("}");
        if (!failed() && !at_end()) fail("the end of the file");
        return mapping;
    }

private:
    Item item() {
        Item item;
        item.published = take("publish");
        if (!item.published && !take("receive")) fail("'publish', 'receive' or '}'");
        element(item);
        expect("as");
        item.message = message();
        expect("on");
        const Span begin = token().span;
        item.topic = {quoted("a topic in quotes"), begin};
        valid("topic", item.topic, wrong_topic(item.topic.text));
        if (take("with")) delivery(item.delivery);
        if (take("{")) assignments(item);
        return item;
    }

    void element(Item& item) {
        if (take("operation"))
            item.kind = ElementKind::operation;
        else if (take("event"))
            item.kind = ElementKind::event;
        else if (take("variable"))
            item.kind = ElementKind::variable;
        else
            fail("'operation', 'event' or 'variable'");
        item.element = name(fmt::format("the name of the {}", described(item.kind)));
        if (!failed() && item.kind == ElementKind::operation && !item.published)
            report(rules::wrong_name, item.element.span,
                   {item.element.text, "thing that is received", "the controller calls its operations itself"});
    }

    /// Parses `geometry_msgs/Twist`, or in full `geometry_msgs/msg/Twist`.
    MessageName message() {
        const Word package = name("the package of a message");
        expect("/");
        Word type = name("the type of a message");
        if (type.text == "msg" && take("/")) type = name("the type of a message");
        valid("package", package, wrong_package(package.text));
        valid("message", type, wrong_message(type.text));
        return {package.text, type.text, diagnostics::join(package.span, type.span)};
    }

    /// Parses `best_effort transient_local depth 5`; each option may occur once.
    void delivery(Delivery& delivery) {
        bool some = false;
        for (bool more = true; more && !failed(); some = some || more) {
            more = true;
            if (at("reliable") || at("best_effort"))
                once(delivery.reliable, at("reliable"), "the reliability");
            else if (at("transient_local") || at("volatile"))
                once(delivery.latched, at("transient_local"), "the durability");
            else if (take("depth"))
                depth(delivery);
            else
                more = false;
        }
        if (!some) fail("'reliable', 'best_effort', 'transient_local', 'volatile' or 'depth'");
    }

    void once(std::optional<bool>& place, bool value, const char* what) {
        advance();
        if (place) report(rules::said_twice, last_span(), {what});
        place = value;
    }

    void depth(Delivery& delivery) {
        const frontend::Token next = token();
        std::uint32_t depth = 0;
        const char* const end = next.text.data() + next.text.size();
        const auto [rest, code] = std::from_chars(next.text.data(), end, depth);
        const bool whole = next.kind == frontend::TokenKind::integer && code == std::errc() && rest == end;
        if (!whole || depth == 0 || depth > deepest_queue)
            return fail(fmt::format("a number from 1 to {}", deepest_queue));
        advance();
        if (delivery.depth) report(rules::said_twice, last_span(), {"the depth"});
        delivery.depth = depth;
    }

    void assignments(Item& item) {
        while (!failed() && !at("}")) {
            Assignment assignment;
            assignment.target = path("a field");
            expect("=");
            assignment.source = source(item.published);
            check_fields(item.published ? assignment.target : assignment.source.path);
            item.assignments.push_back(std::move(assignment));
        }
        expect("}");
    }

    Path path(std::string_view what) {
        Path path;
        path.words.push_back(name(what));
        while (take(".")) path.words.push_back(name(what));
        return path;
    }

    /// Checks names of fields, because they are written to generated code.
    void check_fields(const Path& path) {
        for (const Word& word : path.words) valid("field", word, wrong_field(word.text));
    }

    Source source(bool published) {
        Source source;
        const Span begin = token().span;
        if (!published) {
            source.path = path("a field of the message");
        } else if (at_number()) {
            number(source);
        } else if (token().kind == frontend::TokenKind::string) {
            source.kind = Source::Kind::text;
            source.text = quoted("a text");
        } else {
            source.path = path("a parameter, 'value' or a literal");
            const std::string word = source.path.text();
            if (word == "true" || word == "false") source.kind = Source::Kind::truth;
        }
        source.span = diagnostics::join(begin, last_span());
        return source;
    }

    void number(Source& source) {
        const bool negative = take("-");
        const frontend::Token next = token();
        const bool whole = next.kind == frontend::TokenKind::integer;
        if (!whole && next.kind != frontend::TokenKind::real) return fail("a number");
        source.kind = whole ? Source::Kind::whole : Source::Kind::decimal;
        std::int64_t value = 0;
        const auto [rest, code] = std::from_chars(next.text.data(), next.text.data() + next.text.size(), value);
        if (whole && code != std::errc()) return fail("a number of at most 64 bits");
        double real = 0;
        std::from_chars(next.text.data(), next.text.data() + next.text.size(), real);
        source.number = (negative ? "-" : "") + (whole ? fmt::format("{}", value) : fmt::format("{:#}", real));
        advance();
    }

    void valid(const char* kind, const Word& word, const std::string& wrong) {
        if (!wrong.empty()) report(rules::wrong_name, word.span, {word.text, kind, wrong});
    }
};

}  // namespace

std::string_view described(ElementKind kind) {
    return kind == ElementKind::operation ? "operation" : kind == ElementKind::event ? "event" : "variable";
}

std::string Path::text() const {
    std::string result;
    for (const Word& word : words) result += (result.empty() ? "" : ".") + word.text;
    return result;
}

Span Path::span() const {
    return words.empty() ? Span{} : diagnostics::join(words.front().span, words.back().span);
}

Mapping read_mapping(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                     diagnostics::Diagnostics& diagnostics) {
    return MappingReader(sources, source, diagnostics).read();
}

}  // namespace robochart::cpp_emit::ros2
