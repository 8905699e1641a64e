// SPDX-License-Identifier: Apache-2.0
#include "tests/app/documents/document.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <sstream>
#include <string_view>
#include <utility>

namespace robochart::app::testing {
namespace {

constexpr std::string_view fence = "```";
constexpr std::array<std::string_view, 2> file_marks = {"// file: ", "-- file: "};

using Lines = std::vector<std::string>;

std::string joined(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

/// Returns the file name in the first line of a block, or "" if there is none.
std::string file_name(const Block& block) {
    for (const std::string_view mark : file_marks)
        if (!block.lines.empty() && block.lines.front().starts_with(mark))
            return block.lines.front().substr(mark.size());
    return {};
}

ShownSession session(const Block& block) {
    ShownSession result{block.line, {}};
    bool continues = false;
    for (const std::string& line : block.lines) {
        if (continues) {
            result.commands.back().command += "\n" + line;
        } else if (line.starts_with("$ ")) {
            result.commands.push_back({line.substr(2), {}});
        } else if (!result.commands.empty()) {
            result.commands.back().output.push_back(line);
            continue;
        }
        continues = line.ends_with("\\");
    }
    for (ShownCommand& command : result.commands) command.output = lines_of(joined(command.output));
    return result;
}

/// Returns a line in the normalised form that the comparison uses.
std::string plain(const std::string& line) {
    static const std::regex times("[0-9][0-9,.]* m?s\\b");  // a slower machine may print seconds
    static const std::regex figures("[0-9][0-9,.]* (bytes|states?|transitions?|cycles?)\\b");
    static const std::regex gaps("[ \t]+");
    std::string text = std::regex_replace(line, times, "N s");
    text = std::regex_replace(std::regex_replace(text, figures, "N $1"), gaps, " ");
    if (text.ends_with(' ')) text.pop_back();
    return text;
}

using Place = Lines::const_iterator;

/// Compares all lines up to `...` with the same number of printed lines.
bool equal_until(Place shown, Place end, Place printed, Place printed_end) {
    if (printed_end - printed < end - shown) return false;
    return std::equal(shown, end, printed, [](const auto& a, const auto& b) { return plain(a) == plain(b); });
}

/// Adds the text between backquotes in a paragraph.
void add_inline(const std::string& paragraph, std::size_t line, std::vector<Inline>& out) {
    for (std::size_t open = paragraph.find('`'); open != std::string::npos;) {
        const std::size_t close = paragraph.find('`', open + 1);
        if (close == std::string::npos) return;
        out.push_back({line, paragraph.substr(open + 1, close - open - 1)});
        open = paragraph.find('`', close + 1);
    }
}

}  // namespace

std::vector<Block> blocks_of(const std::string& document) {
    std::vector<Block> result;
    std::istringstream text(document);
    std::optional<Block> open;
    std::size_t number = 0;
    for (std::string line; std::getline(text, line);) {
        ++number;
        const bool is_fence = line.starts_with(fence);
        if (is_fence && open) {
            result.push_back(*std::exchange(open, std::nullopt));
        } else if (is_fence) {
            open = Block{line.substr(fence.size()), number, {}};
        } else if (open) {
            open->lines.push_back(line);
        }
    }
    return result;
}

std::vector<Inline> inline_code(const std::string& document) {
    std::vector<Inline> result;
    std::istringstream text(document);
    std::string paragraph;
    std::size_t number = 0;
    std::size_t begin = 1;
    bool in_block = false;
    const auto finish = [&] {
        add_inline(paragraph, begin, result);
        paragraph.clear();
        begin = number + 1;
    };
    for (std::string line; std::getline(text, line);) {
        ++number;
        const bool is_fence = line.starts_with(fence);
        if (is_fence) in_block = !in_block;
        // Each row of a table and each item of a list is a paragraph.
        const bool alone = line.empty() || line.starts_with('|') || line.starts_with("* ") || line.starts_with('#');
        if (is_fence || in_block || alone) finish();
        if (!is_fence && !in_block) paragraph += (paragraph.empty() ? "" : " ") + line;
        if (line.starts_with('|')) finish();
    }
    finish();
    return result;
}

std::vector<Step> steps_of(const std::string& document) {
    std::vector<Step> result;
    for (const Block& block : blocks_of(document)) {
        if (block.language == "console") {
            result.emplace_back(session(block));
        } else if (const std::string name = file_name(block); !name.empty()) {
            result.emplace_back(ShownFile{name, joined(block.lines)});
        }
    }
    return result;
}

std::vector<std::string> lines_of(const std::string& text) {
    Lines result;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) result.push_back(line);
    while (!result.empty() && result.back().empty()) result.pop_back();
    return result;
}

bool lines_agree(const std::vector<std::string>& shown, const std::vector<std::string>& printed) {
    const auto omitted = [](const std::string& line) { return plain(line) == "..." || plain(line) == " ..."; };
    Place at = shown.begin();
    Place now = printed.begin();
    bool anywhere = false;
    while (true) {
        const Place end = std::find_if(at, shown.end(), omitted);
        const bool last = end == shown.end();
        if (last && anywhere && printed.end() - now >= end - at) now = printed.end() - (end - at);
        while (!equal_until(at, end, now, printed.end()))
            if (!anywhere || last || now++ == printed.end()) return false;
        now += end - at;
        if (last) return now == printed.end();
        at = end + 1;
        anywhere = true;
    }
}

}  // namespace robochart::app::testing
