// SPDX-License-Identifier: Apache-2.0
#include "app/base/junit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/diagnostics/escape.hpp"

namespace robochart::app {
namespace {

using diagnostics::xml_text;

/// Escapes the text for XML. Line ends remain, and characters that XML does not allow become visible escapes.
std::string xml_lines(const std::string& text) {
    std::istringstream lines(text);
    std::string out;
    for (std::string line; std::getline(lines, line);) out += xml_text(line) + "\n";
    return out;
}

std::string outcome_element(const JunitCase& test_case) {
    if (test_case.kind == JunitCase::Kind::skipped)
        return fmt::format("      <skipped message=\"{}\"/>\n", xml_text(test_case.message));
    const char* const element = test_case.kind == JunitCase::Kind::failed ? "failure" : "error";
    return fmt::format("      <{0} message=\"{1}\" type=\"{0}\">{2}</{0}>\n", element, xml_text(test_case.message),
                       xml_lines(test_case.text));
}

std::string case_element(const JunitCase& test_case) {
    std::string out = fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"",
                                  xml_text(test_case.group), xml_text(test_case.name), test_case.seconds);
    if (test_case.kind == JunitCase::Kind::passed) return out + "/>\n";
    return out + ">\n" + outcome_element(test_case) + "    </testcase>\n";
}

/// Returns the element `system-out` with the texts of the cases that passed. Some schemas allow this element only after
/// all cases.
std::string passed_output(const std::vector<JunitCase>& cases) {
    std::string text;
    for (const JunitCase& test_case : cases)
        if (test_case.kind == JunitCase::Kind::passed) text += test_case.text;
    return text.empty() ? "" : fmt::format("    <system-out>{}</system-out>\n", xml_lines(text));
}

}  // namespace

std::string junit_document(const std::string& suite, const std::vector<JunitCase>& cases) {
    const auto count = [&](JunitCase::Kind kind) {
        return std::ranges::count_if(cases, [&](const JunitCase& test_case) { return test_case.kind == kind; });
    };
    double seconds = 0;
    for (const JunitCase& test_case : cases) seconds += test_case.seconds;
    const std::string totals = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3f}\"",
                                           cases.size(), count(JunitCase::Kind::failed), count(JunitCase::Kind::error),
                                           count(JunitCase::Kind::skipped), seconds);
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    out += fmt::format("<testsuites name=\"robochart-verify\" {}>\n", totals);
    out += fmt::format("  <testsuite name=\"{}\" {}>\n", xml_text(suite), totals);
    for (const JunitCase& test_case : cases) out += case_element(test_case);
    return out + passed_output(cases) + "  </testsuite>\n</testsuites>\n";
}

}  // namespace robochart::app
