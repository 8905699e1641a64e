// SPDX-License-Identifier: Apache-2.0
// Explains probable mistakes: forms of other notations and incomplete forms. Each language has a table of them.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>

namespace robochart::diagnostics {

/// A row of a language's table: a mistake of authors who know another notation, and the correct form.
struct Advice {
    std::string_view expected;  ///< what the parser expected, in the words of its message; "" matches every expectation
    /// The tokens around the place, separated by blanks. `@` marks the place; the token after it is the one that was
    /// found. `NAME` is any name that is not reserved, `NUMBER` a number, `TEXT` a string, `END` the end of the text.
    std::string_view words;
    std::string_view advice;  ///< a sentence without a full stop
};

/// The kind of a token, for the rows of a table.
enum class WordKind { other, name, number, text, end };

/// A token of a text.
struct AdviceWord {
    WordKind kind = WordKind::other;
    std::string_view text;
};

/// The advice of the first row that matches; "" if none does. `word(n)` is the n-th token relative to the place: 0 is
/// the token at the place, -1 the token before it. Outside the text, it has the kind WordKind::end.
[[nodiscard]] std::string_view advice_on(std::span<const Advice> rows, std::string_view expected,
                                         const std::function<AdviceWord(std::ptrdiff_t)>& word);

}  // namespace robochart::diagnostics
