// SPDX-License-Identifier: Apache-2.0
// Explains probable mistakes: notation of other languages, and incomplete forms. Each language has a table of
// them.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>

namespace robochart::diagnostics {

/// A row of the table of a language. It describes a mistake that is common among authors who know another notation, and
/// the correct form.
struct Advice {
    std::string_view expected;  ///< what the parser expected, in the words of its message; "" for any
    /// The tokens around the error, separated by blanks. `@` marks the place of the error: the token after it is the
    /// one that the parser found. `NAME` matches any name that is not reserved, `NUMBER` a number, `TEXT` a string, and
    /// `END` the end of the text.
    std::string_view words;
    std::string_view advice;  ///< a sentence without a full stop
};

/// The kind of a token, as far as the rows of a table distinguish it.
enum class WordKind { other, name, number, text, end };

/// A token of a text.
struct AdviceWord {
    WordKind kind = WordKind::other;
    std::string_view text;
};

/// Returns the advice of the first row that matches, or "" if no row matches. `word(n)` must return the n-th token
/// relative to the error: token 0 is at the place of the error, token -1 is before it. Outside the text, it must return
/// a token of the kind WordKind::end.
[[nodiscard]] std::string_view advice_on(std::span<const Advice> rows, std::string_view expected,
                                         const std::function<AdviceWord(std::ptrdiff_t)>& word);

}  // namespace robochart::diagnostics
