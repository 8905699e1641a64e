// A page that opens anywhere: one file that needs no network and no other file, and lets nothing run but its own
// script, by hash (Content Security Policy Level 3).
#pragma once

#include <string>
#include <string_view>

namespace robochart::app {

/// The text of app/pages/parts/`path`.
[[nodiscard]] std::string page_part(std::string_view path);

/// What makes a page. What others wrote is escaped already.
struct Page {
    std::string title;   ///< as it is
    std::string script;  ///< the file of app/pages/parts that it runs, behind tables.js: "script.js"
    std::string body;    ///< HTML; each `<style>` in it, a diagram's, is let in
};

[[nodiscard]] std::string page_text(const Page&);

/// Data for the script of a page: the text of JSON as the element of this id, which nothing in it can end.
[[nodiscard]] std::string page_data(std::string_view id, std::string json);

}  // namespace robochart::app
