// SPDX-License-Identifier: Apache-2.0
// The verb `explain`: prints the page of a rule, or the list of all rules.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>

#include "app/command/option_table.hpp"
#include "app/command/output.hpp"
#include "app/command/rules.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/containers.hpp"
#include "base/rule_pages/rule_pages.hpp"

namespace robochart::app {
namespace {

std::string upper_start(std::string_view code) {
    std::string letters;
    for (const char c : code) {
        if (c >= '0' && c <= '9') break;
        letters += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    return letters;
}

/// Returns suggestions for a mistyped code: the nearest code, or the codes with the same prefix.
std::string similar_codes(std::string_view code) {
    std::vector<std::string> all, found;
    for (const diagnostics::Rule* rule : all_rules()) {
        all.emplace_back(rule->code);
        if (upper_start(rule->code) == upper_start(code)) found.emplace_back(rule->code);
    }
    if (const std::string meant = did_you_mean(code, all); !meant.empty()) return meant;
    diagnostics::erase_repeated(found);
    return found.empty() ? "; `robochart-verify explain` lists all"
                         : fmt::format("; there are {}", fmt::join(found, ", "));
}

bool explain_code(const std::string& written, bool color) {
    const std::vector<std::string> meant = codes_meant(written);
    const std::string code = meant.size() == 1 ? meant.front() : written;
    const std::string_view page = diagnostics::page_text(code);
    if (page.empty() || find_rules(code).empty()) {
        const std::string instead =
            meant.empty() ? similar_codes(written) : fmt::format("; there are {}", fmt::join(meant, ", "));
        print_error("robochart-verify: no rule has the code {}{}\n", written, instead);
        return false;
    }
    print_styled(diagnostics::render_page(page, color));
    return true;
}

/// Returns the index without the text before its first heading below the title, which is for authors of pages.
std::string_view list_of_rules() {
    std::string_view index = diagnostics::page_text("README");
    const std::size_t first = index.find("\n## ");
    index.remove_prefix(first == std::string_view::npos ? index.size() : first + 1);
    return index;
}

}  // namespace

Exit run_explain(const Options& options) {
    const bool color = color_wanted(options.output.color, STDOUT_FILENO);
    if (options.load.inputs.empty()) print_styled(diagnostics::render_page(list_of_rules(), color));
    Exit exit = Exit::success;
    for (std::size_t i = 0; i < options.load.inputs.size(); ++i) {
        if (i > 0) print("\n");
        if (!explain_code(options.load.inputs[i], color)) exit = Exit::usage;
    }
    return exit;
}

}  // namespace robochart::app
