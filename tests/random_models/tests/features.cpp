// SPDX-License-Identifier: Apache-2.0
#include "features.hpp"

#include <string_view>
#include <vector>

namespace robochart::random_models {

namespace {

/// A node `(head mark mark (child) ...)`. For a name, it stores only whether the name is qualified.
struct Node {
    std::string head;
    std::set<std::string> marks;
    std::vector<Node> children;
};

class Reader {
public:
    explicit Reader(std::string_view text) : text_(text) {}

    bool at_node() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
        return at_ < text_.size() && text_[at_] == '(';
    }

    Node node() {
        Node result;
        ++at_;
        result.head = word();
        while (true) {
            if (at_node()) {
                result.children.push_back(node());
                continue;
            }
            if (text_[at_] == ')') break;
            const std::string mark = word();
            if (!mark.empty()) result.marks.insert(mark);
        }
        ++at_;
        return result;
    }

private:
    /// Returns a word, or the relevant property of a name or number. Returns "" for plain names, which are arbitrary.
    std::string word() {
        if (text_.substr(at_).starts_with("`")) return quoted("`").find("::") != std::string_view::npos ? "A::B" : "";
        if (text_.substr(at_).starts_with("«")) {
            (void)quoted("»");
            return "";
        }
        const std::size_t begin = at_;
        while (text_[at_] != ' ' && text_[at_] != '(' && text_[at_] != ')') ++at_;
        const std::string found(text_.substr(begin, at_ - begin));
        const bool number = !found.empty() && found.find_first_not_of("0123456789") == std::string::npos;
        return number && found != "1" ? "n" : found;
    }

    std::string_view quoted(std::string_view end) {
        const std::size_t begin = text_[at_] == '`' ? at_ + 1 : at_ + 2;
        const std::size_t stop = text_.find(end, begin);
        at_ = stop + end.size();
        return text_.substr(begin, stop - begin);
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

bool is_literal(const std::string& head) {
    return head == "string" || head == "csp" || head == "verbatim" || head == "package" || head == "import";
}

void add(const Node& node, Features& features) {
    features.constructs.insert(node.head);
    std::string all;
    std::string parts;
    bool lacks = false;
    for (const std::string& mark : node.marks) {
        if (!is_literal(node.head) || mark != "A::B") features.constructs.insert(node.head + ": " + mark);
        all += " " + mark;
    }
    for (const Node& child : node.children) {
        lacks = lacks || child.head.empty();
        if (child.head != "bound") parts += child.head.empty() ? "-" : "+";
        if (!child.head.empty()) features.compositions.insert(node.head + " > " + child.head);
        if (!child.head.empty()) add(child, features);
    }
    features.compositions.insert(node.head + ":" + all);
    if (lacks) features.constructs.insert(node.head + " " + parts);
    features.constructs.insert(node.head + (node.children.empty() ? "/0" : "/+"));
}

}  // namespace

void add_features(const std::string& structure, Features& features) {
    Reader reader(structure);
    while (reader.at_node()) add(reader.node(), features);
}

std::string lacking(const std::set<std::string>& expected, const std::set<std::string>& found) {
    std::string out;
    for (const std::string& word : expected)
        if (!found.contains(word)) out += word + "\n";
    return out;
}

}  // namespace robochart::random_models
