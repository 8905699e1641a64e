// The verb `explain`: the page of a rule.
#include <fmt/format.h>

#include <algorithm>

#include "app/rules.hpp"
#include "app/verbs.hpp"

namespace robochart::app {
namespace {

std::string_view word(diagnostics::Severity severity) {
    return severity == diagnostics::Severity::error ? "error" : severity == diagnostics::Severity::warning ? "warning" : "note";
}

std::string upper_start(std::string_view code) {
    std::string letters;
    for (const char c : code) {
        if (c >= '0' && c <= '9') break;
        letters += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    }
    return letters;
}

/// Codes of the same family, to help after a slip.
std::string relatives(std::string_view code) {
    std::vector<std::string_view> found;
    for (const diagnostics::Rule* rule : all_rules())
        if (upper_start(rule->code) == upper_start(code)) found.push_back(rule->code);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found.empty() ? "codes look like J3, STM6, RC-S01" : fmt::format("there are {}", fmt::join(found, ", "));
}

}  // namespace

Exit run_explain(const Options& options) {
    Exit exit = Exit::success;
    for (const std::string& code : options.inputs) {
        const auto rules = find_rules(code);
        if (rules.empty()) {
            fmt::print(stderr, "robochart-verify: no rule has the code {}; {}\n", code, relatives(code));
            exit = Exit::bad_input;
        }
        for (const diagnostics::Rule* rule : rules)
            fmt::print("{} ({}): {}\n\n{}\n\n", rule->code, word(rule->severity), rule->message, rule->explanation);
    }
    return exit;
}

}  // namespace robochart::app
