// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/syntax/advice.hpp"

#include <algorithm>
#include <array>

#include "base/diagnostics/utf8.hpp"

namespace robochart::cspm {

namespace {

using diagnostics::Advice;

constexpr std::array rows{
    Advice{"", "@ / /", "a comment begins with `--`, or stands between `{-` and `-}`"},
    Advice{"", "/ @ *", "a comment begins with `--`, or stands between `{-` and `-}`"},
    Advice{"", "@ / *", "a comment begins with `--`, or stands between `{-` and `-}`"},
    Advice{"", "@ <-", "`<-` draws values from a set, in comprehensions and renamings; a prefix is written `a -> P`"},
    Advice{"'->'", "@ =>", "a prefix is written `a -> P`"},
    Advice{"'->'", "@ =", "a prefix is written `a -> P`"},
    Advice{"'->'", "@ ;", "a prefix is written `a -> P`; `;` stands between two processes: `a -> SKIP; Q`"},
    Advice{"'<-'", "@ ->", "a variable is drawn from a set by `x <- S`"},
    Advice{"'then'", "@ =", "values are compared with `==`; `=` stands in definitions"},
    Advice{"')'", "@ =", "values are compared with `==`; `=` stands in definitions"},
    Advice{"'}'", "@ =", "values are compared with `==`; `=` stands in definitions"},
    Advice{"'>'", "@ =", "values are compared with `==`; `=` stands in definitions"},
    Advice{"", "@ <>", "`!=` tests whether two values differ; `<>` is the empty sequence"},
    Advice{"'then'", "@ ||", "a condition is joined by `or`; `||` stands in `P [A || B] Q`"},
    Advice{"an expression", "@ &", "conditions are joined by `and`; `&` stands between a condition and a process"},
    Advice{"an expression", "@ !", "a condition is negated by `not`"},
    Advice{"'else'", "@ elseif", "another `if` stands behind the `else`: `else if C then A else B`"},
    Advice{"'else'", "@ elif", "another `if` stands behind the `else`: `else if C then A else B`"},
    Advice{"", "@ endif", "an `if` ends with its `else` part, without another word"},
    Advice{"'else'", "@",
           "an `if` has the form `if C then A else B`: without an `else` there would be no value; for a "
           "process `else STOP` or `else SKIP` may be meant"},
    Advice{"", "@ within", "`within` ends a `let`, which is missing here"},
    Advice{"", "@ else", "`else` belongs to `if C then A else B`, which is not complete before it"},
    Advice{"a pattern", "@ #", "a comment begins with `--`; a file is read in by `include \"other.csp\"`"},
    Advice{"'='", "chan @", "an event is declared by `channel NAME`"},
    Advice{"'='", "event @", "an event is declared by `channel NAME`"},
    Advice{"'='", "process @", "a process is defined by `NAME = ...`, without a word in front"},
    Advice{"'='", "enum @", "a type of named values is `datatype T = A | B`"},
    Advice{"'='", "import @", "a file is read in by `include \"other.csp\"`"},
    Advice{"'='", "@ [T=", "a claim begins with `assert`"},
    Advice{"'='", "@ [F=", "a claim begins with `assert`"},
    Advice{"'='", "@ [FD=", "a claim begins with `assert`"},
    Advice{"'='", "NAME @ NAME =", "parameters stand in brackets: `P(x) = ...`"},
    Advice{"'='", "@", "a definition has the form `NAME = EXPRESSION` or `NAME(x) = EXPRESSION`"},
    Advice{"a refinement or a property", "@",
           "a refinement is written `P [T= Q`, `P [F= Q` or `P [FD= Q`, a property `P :[deadlock free]`"},
    Advice{"the end of the line", "@ ||",
           "processes run side by side by `P ||| Q`, together on the events of A by `P [|A|] Q`"},
    Advice{"'<->'", "@ ]", "processes run together on the events of A by `P [|A|] Q`"},
    Advice{"the end of the line", "@ |",
           "a choice is written `P [] Q`; `|` stands between the constructors of a `datatype`"},
    Advice{"", "= NAME @ ,", "the constructors of a `datatype` are separated by `|`"},
    Advice{"the end of the line", "@ ,", "each `channel` line gives one type to all of its names"},
    Advice{"", "when @", "a condition stands before its process, with `&` between them: `C & P`"},
    Advice{"", "case @", "cases are definitions of their own, `P(0) = A` and `P(1) = B`, or an `if`"},
    Advice{"", "[ @ ]", "a choice is written `P [] Q`, without a blank in `[]`"},
    Advice{"", "@ ..", "a range stands in braces, with two points: `{0..2}`"},
    Advice{"", "@ = <", "at most is written `<=`"},
    Advice{"", "@ mod", "`%` is the remainder"},
    Advice{"", "@ div", "integers are divided by `/`"},
    Advice{"the end of the line",
           "@ =", "a definition begins a line, and no `;` ends the one before; values are compared with `==`"},
    Advice{"')'", "( NAME @ :", "parameters have no types: `P(x) = ...`"},
    Advice{"'->'", "@ in", "the values that an input takes are limited by `a?x:S -> P`"},
    Advice{"'<-'", "-> NAME @ ]]", "an event a becomes b in `P[[a <- b]]`"},
};

struct ForeignSign {
    std::string_view character;
    std::string_view written;
};

constexpr std::array foreign_signs{
    ForeignSign{"→", "->"},  ForeignSign{"⟶", "->"},  ForeignSign{"←", "<-"}, ForeignSign{"↔", "<->"},
    ForeignSign{"□", "[]"},  ForeignSign{"⊓", "|~|"}, ForeignSign{"∥", "||"}, ForeignSign{"⫴", "|||"},
    ForeignSign{"△", "/\\"}, ForeignSign{"▷", "[>"},  ForeignSign{"≤", "<="}, ForeignSign{"≥", ">="},
    ForeignSign{"≠", "!="},  ForeignSign{"∧", "and"}, ForeignSign{"∨", "or"}, ForeignSign{"¬", "not"},
    ForeignSign{"⟨", "<"},   ForeignSign{"⟩", ">"},   ForeignSign{"×", "*"},  ForeignSign{"÷", "/"},
    ForeignSign{"–", "-"},   ForeignSign{"−", "-"},   ForeignSign{"“", "\""}, ForeignSign{"”", "\""},
    ForeignSign{"‘", "'"},   ForeignSign{"’", "'"},   ForeignSign{"∅", "{}"}, ForeignSign{"\xC2\xA0", " "},
};

/// The code point at the beginning of a well-formed text.
char32_t first_code(std::string_view text, std::size_t length) {
    constexpr std::array<unsigned, 5> kept{0, 0x7fU, 0x1fU, 0x0fU, 0x07U};
    char32_t code = static_cast<unsigned char>(text[0]) & kept.at(length);
    for (std::size_t i = 1; i < length; ++i) code = code << 6U | (static_cast<unsigned char>(text[i]) & 0x3fU);
    return code;
}

/// The letters U+00C0 to U+017F without their accents; ligatures are replaced by their first letter.
constexpr char32_t first_accented = 0xc0;
constexpr std::string_view without_accents =
    "AAAAAAACEEEEIIIIDNOOOOO*OUUUUYTsaaaaaaaceeeeiiiidnooooo/ouuuuyty"
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlL"
    "lLlNnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs";

/// Accents as separate characters after their letter.
bool is_accent(char32_t code) {
    return code >= 0x300 && code < 0x370;
}

}  // namespace

std::span<const diagnostics::Advice> all_advice() {
    return rows;
}

std::size_t foreign_letter(std::string_view text) {
    const std::size_t length = diagnostics::utf8_length(text);
    if (length < 2) return 0;
    const char32_t code = first_code(text, length);
    const bool operators = code == 0xd7 || code == 0xf7;
    const bool letter = (code >= first_accented && code < 0x2000 && !operators) || (code >= 0x2c00 && code < 0x2e00) ||
                        (code >= 0x3040 && code < 0xd800);
    return letter ? length : 0;
}

std::string in_plain_letters(std::string_view name) {
    std::string result;
    while (!name.empty()) {
        const std::size_t length = diagnostics::utf8_length(name);
        if (length == 0) return "";
        const char32_t code = first_code(name, length);
        if (code < 0x80)
            result += static_cast<char>(code);
        else if (code >= first_accented && code - first_accented < without_accents.size())
            result += without_accents[code - first_accented];
        else if (!is_accent(code))
            return "";
        name.remove_prefix(length);
    }
    return result;
}

std::string_view written_for(std::string_view symbol) {
    const auto* const found = std::ranges::find(foreign_signs, symbol, &ForeignSign::character);
    return found == foreign_signs.end() ? std::string_view() : found->written;
}

}  // namespace robochart::cspm
