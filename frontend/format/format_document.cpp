// SPDX-License-Identifier: Apache-2.0
// Builds and prints documents. A group is printed on one line if it fits. Otherwise its breaks become line ends.
#include "frontend/format/format_document.hpp"

#include <algorithm>

#include "base/diagnostics/utf8.hpp"

namespace robochart::frontend {

namespace {

std::size_t count_columns(std::string_view text) {
    const auto begins_character = [](char c) { return !diagnostics::is_continuation(c); };
    return static_cast<std::size_t>(std::ranges::count_if(text, begins_character));
}

}  // namespace

Document::Document() {
    nodes_.push_back({});
    blank_ = plain_text(" ");
    line_ = add_break(Kind::line, 1);
    soft_ = add_break(Kind::soft, 0);
    hard_ = add_break(Kind::hard, endless);
    empty_line_ = add_break(Kind::empty_line, endless);
    raw_ = add_break(Kind::raw, endless);
    constant_ = nodes_.size();
}

void Document::clear() {
    nodes_.resize(constant_);
}

std::uint16_t Document::capped_sum(std::uint16_t a, std::uint16_t b) {
    return static_cast<std::uint16_t>(std::min<std::uint32_t>(endless, std::uint32_t{a} + b));
}

Doc Document::add(const Node& node) {
    nodes_.push_back(node);
    return static_cast<Doc>(nodes_.size() - 1);
}

Doc Document::add_break(Kind kind, std::uint16_t flat) {
    Node node;
    node.kind = kind;
    node.breaks = true;
    node.flat = flat;
    return add(node);
}

Doc Document::add_text(Kind kind, std::string_view text) {
    if (text.empty()) return 0;
    Node node;
    node.kind = kind;
    node.text = text;
    const bool one_line = text.find_first_of("\r\n") == std::string_view::npos;
    node.flat = one_line ? static_cast<std::uint16_t>(std::min<std::size_t>(endless, count_columns(text))) : endless;
    node.lead = node.flat;
    return add(node);
}

Doc Document::plain_text(std::string_view text) {
    return add_text(Kind::text, text);
}

Doc Document::comment_text(std::string_view text) {
    const Doc doc = add_text(Kind::comment, text);
    if (doc == 0) return doc;
    nodes_[doc].breaks = true;
    nodes_[doc].lead = 0;
    return doc;
}

Doc Document::line_comment(std::string_view text) {
    const Doc doc = comment_text(text);
    nodes_[doc].flat = endless;
    return doc;
}

Doc Document::cat(Doc a, Doc b) {
    if (a == 0) return b;
    if (b == 0) return a;
    const Node& left = nodes_[a];
    const Node& right = nodes_[b];
    Node node;
    node.kind = Kind::cat;
    node.breaks = left.breaks || right.breaks;
    node.flat = capped_sum(left.flat, right.flat);
    node.lead = left.breaks ? left.lead : capped_sum(left.lead, right.lead);
    node.a = a;
    node.b = b;
    return add(node);
}

Doc Document::cat(std::initializer_list<Doc> docs) {
    Doc result = 0;
    for (const Doc doc : docs) result = cat(result, doc);
    return result;
}

Doc Document::nest_indented(Doc inner) {
    if (inner == 0) return 0;
    Node node = nodes_[inner];
    node.kind = Kind::nest;
    node.text = {};
    node.a = inner;
    return add(node);
}

Doc Document::group(Doc inner, std::uint16_t limit) {
    if (inner == 0 || !nodes_[inner].breaks) return inner;
    Node node = nodes_[inner];
    node.kind = Kind::group;
    node.text = {};
    node.a = inner;
    node.limit = limit;
    return add(node);
}

// ---------------------------------------------------------------- writing

void Printer::write(std::string_view text) {
    if (column_ == 0 && indent_ > 0) {
        out_.append(indent_, '\t');
        column_ = indent_ * tab_width;
        indent_ = 0;
    }
    out_ += text;
    const std::size_t line_end = text.find_last_of("\r\n");
    if (line_end == std::string_view::npos)
        column_ += count_columns(text);
    else
        column_ = count_columns(text.substr(line_end + 1));
}

void Printer::end_line(std::uint32_t indent, int count) {
    for (; count > 0; --count) out_ += line_end_;
    indent_ = indent;
    column_ = 0;
}

/// True if the group fits into the line limit, together with the text after it up to the next possible line break.
bool Printer::fits_line(const Document::Node& group) const {
    if (group.flat == Document::endless) return false;
    std::size_t width = (column_ == 0 ? indent_ * tab_width : column_) + group.flat;
    for (auto item = pending_.rbegin(); item != pending_.rend() && width <= group.limit; ++item) {
        const Document::Node& next = document_.nodes_[item->doc];
        width += next.lead;
        if (next.breaks) break;
    }
    return width <= group.limit;
}

void Printer::print_item(Item item) {
    const Document::Node& node = document_.nodes_[item.doc];
    switch (node.kind) {
        case Kind::text:
        case Kind::comment:
            return write(node.text);
        case Kind::line:
            return item.flat ? write(" ") : end_line(item.indent, 1);
        case Kind::soft:
            return item.flat ? void() : end_line(item.indent, 1);
        case Kind::hard:
            return end_line(item.indent, 1);
        case Kind::empty_line:
            return end_line(item.indent, 2);
        case Kind::raw:
            return end_line(0, 1);
        case Kind::cat:
            pending_.push_back({node.b, item.indent, item.flat});
            pending_.push_back({node.a, item.indent, item.flat});
            return;
        case Kind::nest:
            pending_.push_back({node.a, item.indent + 1, item.flat});
            return;
        case Kind::group:
            pending_.push_back({node.a, item.indent, item.flat || fits_line(node)});
            return;
    }
}

void Printer::print(Doc doc) {
    pending_.push_back({doc, 0, false});
    while (!pending_.empty()) {
        const Item item = pending_.back();
        pending_.pop_back();
        print_item(item);
    }
}

}  // namespace robochart::frontend
