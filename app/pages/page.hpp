// SPDX-License-Identifier: Apache-2.0
// Renders self-contained pages. Such a page needs no network and no other file. It runs only the script that it
// contains, which a Content Security Policy (Level 3) allows by hash.
#pragma once

#include <string>
#include <string_view>

#include "app/command/run_record.hpp"

namespace robochart::app {

/// Returns the text of app/pages/parts/`path`.
[[nodiscard]] std::string page_part(std::string_view path);

/// The contents of a page. Foreign text must be escaped already.
struct Page {
    std::string title;   ///< unescaped
    std::string script;  ///< script in app/pages/parts that runs after tables.js: "script.js"
    std::string body;    ///< HTML; the `<style>` elements of its diagrams are allowed by hash
    RunRecord run;       ///< shown below the body
};

[[nodiscard]] std::string page_text(const Page&);

/// Returns an element with JSON data for the script of a page. The data are escaped, so that they cannot end the
/// element.
[[nodiscard]] std::string page_data(std::string_view id, std::string json);

}  // namespace robochart::app
