// SPDX-License-Identifier: Apache-2.0
// Transforms texts.
#include "base/diagnostics/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace robochart::diagnostics {

std::string on_one_line(std::string_view text) {
    std::string line;
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
        if (!blank)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    if (!line.empty() && line.back() == ' ') line.pop_back();
    return line;
}

std::string join_equal(const std::vector<std::string>& items) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < items.size();) {
        std::size_t end = i;
        while (end < items.size() && items[end] == items[i]) ++end;
        if (end - i > 2) {
            texts.push_back(fmt::format("{} times {}", end - i, items[i]));
        } else {
            texts.insert(texts.end(), end - i, items[i]);
        }
        i = end;
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

std::string fill_template(const std::string& text, const std::map<std::string, std::string>& keys) {
    std::string result;
    std::size_t from = 0;
    for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@', at + 1)) {
        const std::size_t end = text.find('@', at + 1);
        if (end == std::string::npos) break;
        const auto key = keys.find(text.substr(at + 1, end - at - 1));
        if (key == keys.end()) continue;
        result.append(text, from, at - from) += key->second;
        from = end + 1;
        at = end;
    }
    return result.append(text, from);
}

}  // namespace robochart::diagnostics
