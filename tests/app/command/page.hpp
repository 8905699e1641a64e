// SPDX-License-Identifier: Apache-2.0
// Reads the text of a page, and simulates its user in a browser.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace robochart::app::testing {

/// Returns the first group of every match of a regular expression.
[[nodiscard]] std::vector<std::string> all_matches(const std::string& text, const std::string& pattern);

/// Returns the text between each pair of these marks.
[[nodiscard]] std::vector<std::string> texts_between(const std::string& text, const std::string& begin,
                                                     const std::string& end);

/// Checks that the page's policy allows only its own styles and script, by their hashes. Checks also that the page
/// fetches nothing and that the ids of its elements are unique.
void expect_closed(const std::string& page);

/// Runs shell commands that write page.html, then tests/app/command/browser.mjs. Returns its output line by line,
/// including problems. `how` is the second argument of browser.mjs.
[[nodiscard]] std::vector<std::string> play_page(const std::string& written, const std::string& commands,
                                                 const std::string& how = "");

/// A test that is skipped if there is no browser (tests/needed.hpp).
class InABrowser : public ::testing::Test {
protected:
    void SetUp() override;
};

}  // namespace robochart::app::testing
