// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/syntax/advice.hpp"

#include <algorithm>
#include <array>

#include "base/diagnostics/utf8.hpp"

namespace robochart::cspm {

namespace {

using diagnostics::Advice;

constexpr std::array rows{
    Advice{"", "@ / /", "a comment begins with `--`, or is written between `{-` and `-}`"},
    Advice{"", "/ @ *", "a comment begins with `--`, or is written between `{-` and `-}`"},
    Advice{"", "@ / *", "a comment begins with `--`, or is written between `{-` and `-}`"},
    Advice{"", "@ <-", "`<-` draws values from a set, in comprehensions and renamings; a prefix is written `a -> P`"},
    Advice{"'->'", "@ =>", "a prefix is written `a -> P`"},
    Advice{"'->'", "@ =", "a prefix is written `a -> P`"},
    Advice{"'->'", "@ ;", "a prefix is written `a -> P`; `;` separates two processes: `a -> SKIP; Q`"},
    Advice{"'<-'", "@ ->", "`x <- S` draws a variable from a set"},
    Advice{"'then'", "@ =", "`==` compares values; `=` is for definitions"},
    Advice{"')'", "@ =", "`==` compares values; `=` is for definitions"},
    Advice{"'}'", "@ =", "`==` compares values; `=` is for definitions"},
    Advice{"'>'", "@ =", "`==` compares values; `=` is for definitions"},
    Advice{"", "@ <>", "`!=` tests whether two values differ; `<>` is the empty sequence"},
    Advice{"'then'", "@ ||", "`or` joins conditions; `||` is part of `P [A || B] Q`"},
    Advice{"an expression", "@ &", "`and` joins conditions; `&` separates a condition from a process"},
    Advice{"an expression", "@ !", "`not` negates a condition"},
    Advice{"'else'", "@ elseif", "write another `if` after the `else`: `else if C then A else B`"},
    Advice{"'else'", "@ elif", "write another `if` after the `else`: `else if C then A else B`"},
    Advice{"", "@ endif", "an `if` ends with its `else` part, without another word"},
    Advice{"'else'", "@", "an `if` has the form `if C then A else B`; for a process, use `else STOP` or `else SKIP`"},
    Advice{"", "@ within", "`within` needs a `let` before it"},
    Advice{"", "@ else", "`else` needs a complete `if C then A` before it"},
    Advice{"a pattern", "@ #", "a comment begins with `--`; `include \"other.csp\"` includes a file"},
    Advice{"'='", "chan @", "`channel NAME` declares an event"},
    Advice{"'='", "event @", "`channel NAME` declares an event"},
    Advice{"'='", "process @", "`NAME = ...` defines a process, without a keyword"},
    Advice{"'='", "enum @", "a type of named values is `datatype T = A | B`"},
    Advice{"'='", "import @", "`include \"other.csp\"` includes a file"},
    Advice{"'='", "@ [T=", "a claim begins with `assert`"},
    Advice{"'='", "@ [F=", "a claim begins with `assert`"},
    Advice{"'='", "@ [FD=", "a claim begins with `assert`"},
    Advice{"'='", "NAME @ NAME =", "parameters are in parentheses: `P(x) = ...`"},
    Advice{"'='", "@", "a definition has the form `NAME = EXPRESSION` or `NAME(x) = EXPRESSION`"},
    Advice{"a refinement or a property", "@",
           "a refinement is written `P [T= Q`, `P [F= Q` or `P [FD= Q`, a property `P :[deadlock free]`"},
    Advice{"the end of the line", "@ ||",
           "`P ||| Q` runs processes in parallel without common events, and `P [|A|] Q` with the common events of A"},
    Advice{"'<->'", "@ ]", "`P [|A|] Q` runs processes in parallel with the common events of A"},
    Advice{"the end of the line", "@ |",
           "a choice is written `P [] Q`; `|` separates the constructors of a `datatype`"},
    Advice{"", "= NAME @ ,", "`|` separates the constructors of a `datatype`"},
    Advice{"the end of the line", "@ ,", "each `channel` line gives one type to all of its names"},
    Advice{"", "when @", "a condition comes before its process, with `&` between them: `C & P`"},
    Advice{"", "case @", "write cases as separate definitions, `P(0) = A` and `P(1) = B`, or as an `if`"},
    Advice{"", "[ @ ]", "a choice is written `P [] Q`, without a space in `[]`"},
    Advice{"", "@ ..", "a range is in braces, with two points: `{0..2}`"},
    Advice{"", "@ = <", "`<=` means at most"},
    Advice{"", "@ mod", "`%` is the remainder"},
    Advice{"", "@ div", "`/` divides integers"},
    Advice{"the end of the line",
           "@ =", "a definition begins on a new line, and needs no `;` before it; `==` compares values"},
    Advice{"')'", "( NAME @ :", "parameters have no types: `P(x) = ...`"},
    Advice{"'->'", "@ in", "`a?x:S -> P` limits the values of an input"},
    Advice{"'<-'", "-> NAME @ ]]", "`P[[a <- b]]` renames event a to b"},
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

/// Returns the code point at the beginning of a well-formed text.
char32_t first_code(std::string_view text, std::size_t length) {
    constexpr std::array<unsigned, 5> masks{0, 0x7fU, 0x1fU, 0x0fU, 0x07U};
    char32_t code = static_cast<unsigned char>(text[0]) & masks.at(length);
    for (std::size_t i = 1; i < length; ++i) code = code << 6U | (static_cast<unsigned char>(text[i]) & 0x3fU);
    return code;
}

/// Accented letters from U+00C0 to U+017F without their accents. A ligature is represented by its first letter.
constexpr char32_t first_accented = 0xc0;
constexpr std::string_view without_accents =
    "AAAAAAACEEEEIIIIDNOOOOO*OUUUUYTsaaaaaaaceeeeiiiidnooooo/ouuuuyty"
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlL"
    "lLlNnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs";

/// Returns true for an accent that is a separate character after its letter.
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
