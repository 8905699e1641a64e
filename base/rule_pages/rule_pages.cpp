// SPDX-License-Identifier: Apache-2.0
// Parses and prints the pages of rules. The parser supports only the Markdown that the pages use: headings, paragraphs,
// fences, lists, links, `code`, *emphasis*.
#include "base/rule_pages/rule_pages.hpp"

#include <algorithm>
#include <cctype>

#include "base/diagnostics/paint.hpp"

namespace robochart::diagnostics {
namespace {

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

std::string_view trim_spaces(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

bool same_ignoring_case(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b,
                              [](unsigned char x, unsigned char y) { return std::toupper(x) == std::toupper(y); });
}

// ---------------------------------------------------------------- reading

constexpr std::string_view fence = "```";
constexpr std::string_view separator = " · ";

class PageReader {
public:
    explicit PageReader(std::string_view text) : lines_(lines_of(text)) {}

    RulePage read() {
        read_title();
        read_kind();
        while (at_ < lines_.size()) body_line(lines_[at_++]);
        if (trim_spaces(page_.reason).empty()) add_fault("there is no reason between the title and the examples");
        if (page_.wrong.empty()) add_fault("there is no example under `## Wrong`");
        if (page_.right.empty()) add_fault("there is no example under `## Right`");
        return std::move(page_);
    }

private:
    void add_fault(std::string what) { page_.faults.push_back(std::move(what)); }

    void read_title() {
        const std::string_view line = at_ < lines_.size() ? lines_[at_++] : std::string_view();
        const std::size_t colon = line.find(": ");
        if (!line.starts_with("# ") || colon == std::string_view::npos)
            return add_fault("the first line must be `# CODE: what is wrong`");
        page_.code = line.substr(2, colon - 2);
        page_.title = line.substr(colon + 2);
        skip_blank();
    }

    /// Reads the line `*severity · area · source*`.
    void read_kind() {
        const std::string_view line = at_ < lines_.size() ? lines_[at_] : std::string_view();
        const bool fits = line.size() > 2 && line.front() == '*' && line.back() == '*';
        const std::size_t first = line.find(separator);
        if (!fits || first == std::string_view::npos)
            return add_fault("the title must be followed by `*severity · area · source*`");
        ++at_;
        const std::string_view inner = line.substr(1, line.size() - 2);
        const std::size_t second = inner.find(separator, first);
        page_.severity = inner.substr(0, first - 1);
        page_.area = inner.substr(first - 1 + separator.size(), second == std::string_view::npos
                                                                    ? std::string_view::npos
                                                                    : second - (first - 1) - separator.size());
        if (second != std::string_view::npos) page_.source = inner.substr(second + separator.size());
    }

    void skip_blank() {
        while (at_ < lines_.size() && trim_spaces(lines_[at_]).empty()) ++at_;
    }

    void body_line(std::string_view line) {
        if (line.starts_with("## ")) {
            section_ = line.substr(3);
        } else if (line.starts_with(fence)) {
            read_block(line.substr(fence.size()));
        } else if (section_.empty()) {
            page_.reason.append(line).append("\n");
        }
    }

    void read_block(std::string_view info) {
        Block block;
        const std::size_t blank = std::min(info.find(' '), info.size());
        block.language = info.substr(0, blank);
        const std::size_t name = info.find("file=");
        if (name != std::string_view::npos) block.file = trim_spaces(info.substr(name + 5));
        while (at_ < lines_.size() && lines_[at_] != fence) block.text.append(lines_[at_++]).append("\n");
        if (at_ == lines_.size()) add_fault("a fence is not closed");
        ++at_;
        if (section_ == "Wrong") {
            page_.wrong.push_back(std::move(block));
        } else if (section_ == "Right") {
            page_.right.push_back(std::move(block));
        }
    }

    std::vector<std::string_view> lines_;
    std::size_t at_ = 0;
    std::string_view section_;
    RulePage page_;
};

// ---------------------------------------------------------------- drawing

class Drawing {
public:
    explicit Drawing(bool color) : color_(color) {}

    std::string draw_text(std::string_view text) {
        for (const std::string_view line : lines_of(text)) draw_line(line);
        while (out_.size() > 1 && out_.ends_with("\n\n")) out_.pop_back();
        return std::move(out_);
    }

private:
    void draw_line(std::string_view line) {
        if (line.starts_with(fence)) {
            in_code_ = !in_code_;
        } else if (in_code_) {
            code_line(line);
        } else if (line.starts_with("#")) {
            const std::size_t start = std::min(line.find_first_not_of("# "), line.size());
            add_painted(line.substr(start), Paint::heading);
            out_ += '\n';
        } else {
            draw_words(line);
            out_ += '\n';
        }
    }

    /// Draws a line of an example. Tabs become four blanks, and comments that state expected findings become arrows.
    void code_line(std::string_view line) {
        constexpr std::string_view expectation = " expect: ";
        const std::size_t at = line.find(expectation);
        std::string text(line.substr(0, at));
        if (at != std::string_view::npos) text.append(" <-- ").append(line.substr(at + expectation.size()));
        for (std::size_t tab = text.find('\t'); tab != std::string::npos; tab = text.find('\t'))
            text.replace(tab, 1, "    ");
        out_.append("    ").append(text).append("\n");
    }

    void add_painted(std::string_view text, Paint paint) { out_ += paint_text(text, paint, color_); }

    /// Draws a line of text with `code`, [name](address) and *emphasis*.
    void draw_words(std::string_view line) {
        while (!line.empty()) {
            const std::size_t at = std::min(line.find_first_of("`[*"), line.size());
            out_ += line.substr(0, at);
            line.remove_prefix(at);
            if (!line.empty()) line.remove_prefix(draw_special(line));
        }
    }

    /// Draws an element that begins with a special character. Returns the number of characters of the element.
    std::size_t draw_special(std::string_view line) {
        const char sign = line.front();
        if (sign == '[') {
            const std::size_t name = line.find("](");
            const std::size_t end = name == std::string_view::npos ? name : line.find(')', name);
            if (end != std::string_view::npos) {
                add_painted(line.substr(1, name - 1), Paint::name);
                return end + 1;
            }
        } else if (line.size() > 1 && line[1] != ' ') {
            const std::size_t end = line.find(sign, 1);
            if (end != std::string_view::npos) {
                // Backquotes are printed only without colours.
                const bool quotes = sign == '`' && !color_;
                add_painted(quotes ? line.substr(0, end + 1) : line.substr(1, end - 1),
                            sign == '`' ? Paint::name : Paint::heading);
                return end + 1;
            }
        }
        out_ += sign;
        return 1;
    }

    bool color_;
    bool in_code_ = false;
    std::string out_;
};

/// Joins the lines of each paragraph. The paragraphs are separated by an empty line.
std::string join_lines(std::string_view text) {
    std::string joined;
    bool paragraph_ended = false;
    for (const std::string_view line : lines_of(text)) {
        if (!line.empty() && !joined.empty()) joined += paragraph_ended ? "\n\n" : " ";
        joined += line;
        paragraph_ended = line.empty();
    }
    return joined;
}

}  // namespace

std::string_view page_text(std::string_view code) {
    for (const PageText& page : page_texts())
        if (same_ignoring_case(page.code, code)) return page.text;
    return {};
}

RulePage read_page(std::string_view text) {
    return PageReader(text).read();
}

std::string reason_for(const Rule& rule) {
    return join_lines(render_page(read_page(page_text(rule.code)).reason, false));
}

std::string render_page(std::string_view text, bool color) {
    return Drawing(color).draw_text(text);
}

}  // namespace robochart::diagnostics
