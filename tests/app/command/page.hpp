// What stands in the text of a page, and somebody who plays with it in a browser.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace robochart::app::testing {

/// The first group of each match of a regular expression.
[[nodiscard]] std::vector<std::string> all(const std::string& text, const std::string& pattern);

/// What stands between these marks, each time.
[[nodiscard]] std::vector<std::string> between(const std::string& text, const std::string& begin,
                                               const std::string& end);

/// A page's policy names its styles and its one script by their hashes, allows nothing else, and nothing is fetched;
/// no two elements have one id.
void expect_closed(const std::string& page);

/// Commands of a shell that write page.html, then what tests/app/command/browser.mjs prints, line by line: problems
/// too. `how`: its second argument.
[[nodiscard]] std::vector<std::string> played(const std::string& written, const std::string& commands,
                                              const std::string& how = "");

/// Is skipped where there is no browser (tests/needed.hpp).
class InABrowser : public ::testing::Test {
protected:
    void SetUp() override;
};

}  // namespace robochart::app::testing
