// Formatting in tests: texts, other spacings of them, and the laws that hold for every text.
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

/// The formatted text; "" and a failure if there is none.
[[nodiscard]] std::string formatted(const std::string& text, bool is_assertions = false);

[[nodiscard]] bool is_correct(const Example& example);
/// Nothing of the text is in a language that is kept as it is (properties of probabilities).
[[nodiscard]] bool is_read_whole(const Example& example);

/// No word or comment is lost, the tree is the same, and formatting again changes nothing.
void expect_laws(const Example& example);

/// Every text without syntax errors in the repository and, where it is at hand, beside it; and two that have every
/// construct.
[[nodiscard]] const std::vector<Example>& examples();

/// The text with other blanks between its words; `choose` gives what stands in a gap, from what stood there. Where a
/// line end would be read differently there is none.
[[nodiscard]] Example respaced(const Example& example, const std::function<std::string(std::string_view)>& choose);
/// Random blanks, line ends and comments.
[[nodiscard]] Example respaced(const Example& example, random_models::Random& random);
/// Names made longer by fewer than `most` letters; those of assertion files are left, as some are words there.
[[nodiscard]] Example lengthened(const Example& example, random_models::Random& random, std::size_t most);

}  // namespace robochart::frontend::testing
