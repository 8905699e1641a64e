// What a mistake probably means: forms of other notations, and forms that are not complete, as a table of each
// language.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>

namespace robochart::diagnostics {

/// A mistake that people make who know another notation, with what is written instead: one row of a language's table.
struct Advice {
    std::string_view expected;  ///< what the reader expected, as its message says it; "": anything
    /// The words around the place, separated by blanks: `@` is the place, behind which stands the word that was found.
    /// `NAME` is any name that is not reserved, `NUMBER` a number, `TEXT` a string, `END` the end of the text.
    std::string_view words;
    std::string_view advice;  ///< a sentence without full stop
};

/// What a word of a text is, for the rows of a table.
enum class WordKind { other, name, number, text, end };

/// A word of a text.
struct AdviceWord {
    WordKind kind = WordKind::other;
    std::string_view text;
};

/// What the first row says that fits; "" if none does. `word(n)` is the n-th word from the place on: 0 was found there,
/// -1 stands in front of it; WordKind::end beyond both ends of the text.
[[nodiscard]] std::string_view advice_on(std::span<const Advice> rows, std::string_view expected,
                                         const std::function<AdviceWord(std::ptrdiff_t)>& word);

}  // namespace robochart::diagnostics
