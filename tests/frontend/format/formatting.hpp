// SPDX-License-Identifier: Apache-2.0
// Provides example texts for tests of the formatter, respaces these texts, and checks the laws that hold for every
// text.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/random_models/models/random.hpp"

namespace robochart::frontend::testing {

struct Example {
    std::string origin;
    std::string text;
    bool is_assertions = false;
};

/// Returns the formatted text. If there is none, returns "" and fails the test.
[[nodiscard]] std::string formatted(const std::string& text, bool is_assertions = false);

[[nodiscard]] bool is_correct(const Example& example);
/// Returns true if the whole text is parsed. Properties of probabilities are kept unparsed.
[[nodiscard]] bool is_read_whole(const Example& example);

/// Checks that no word or comment is lost, the tree is the same, and formatting is idempotent.
void expect_laws(const Example& example);

/// Returns all texts without syntax errors in the repository and, if present, next to it. Also returns two texts with
/// every construct.
[[nodiscard]] const std::vector<Example>& examples();

/// Returns the text with other blanks between its words. `choose` maps the old text of each gap to its new text. The
/// function inserts no line end where this would change the meaning.
[[nodiscard]] Example respaced(const Example& example, const std::function<std::string(std::string_view)>& choose);
/// Returns the text with random blanks, line ends and comments.
[[nodiscard]] Example respaced(const Example& example, random_models::Random& random);
/// Returns the text with names that are up to `most` - 1 letters longer. Names in assertion files stay, because some
/// are keywords there.
[[nodiscard]] Example lengthened(const Example& example, random_models::Random& random, std::size_t most);

}  // namespace robochart::frontend::testing
