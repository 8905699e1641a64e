// SPDX-License-Identifier: Apache-2.0
// See page.hpp.
#include "app/pages/page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <vector>

#include "base/cache/digest.hpp"
#include "base/diagnostics/escape.hpp"

namespace robochart::app {
namespace {

/// Returns the contents of all style elements of an HTML text.
std::set<std::string> styles_of(std::string_view text) {
    constexpr std::string_view begin = "<style>", end = "</style>";
    std::set<std::string> result;
    for (std::size_t at = text.find(begin); at != std::string_view::npos; at = text.find(begin, at)) {
        at += begin.size();
        const std::size_t stop = text.find(end, at);
        if (stop == std::string_view::npos) break;
        result.emplace(text.substr(at, stop - at));
        at = stop;
    }
    return result;
}

}  // namespace

std::string page_text(const Page& page) {
    const std::string style = page_part("style.css");
    const std::string script = page_part("tables.js") + page_part(page.script);
    std::set<std::string> styles = styles_of(page.body);
    styles.insert(style);
    std::vector<std::string> hashes;
    for (const std::string& style_text : styles) hashes.push_back("'" + diagnostics::policy_hash(style_text) + "'");
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src {}; script-src '{}'; "
        "base-uri 'none'; form-action 'none'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{} - robochart-verify</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n{}{}</main>\n"
        "<script>{}</script>\n</body>\n</html>\n",
        fmt::join(hashes, " "), diagnostics::policy_hash(script), diagnostics::xml_text(page.title), style, page.body,
        run_html(page.run), script);
}

std::string page_data(std::string_view id, std::string json) {
    for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at))
        json.replace(at, 1, "\\u003c");
    return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id, json);
}

}  // namespace robochart::app
