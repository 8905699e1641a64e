#include "checker/cspm/syntax/advice.hpp"

#include <algorithm>
#include <array>

namespace robochart::cspm {

namespace {

constexpr std::array rows{
    Advice{"a pattern", "/", "a comment begins with `--`, or stands between `{-` and `-}`"},
    Advice{"", "<-", "`<-` draws values from a set, in comprehensions and renamings; a prefix is written `a -> P`"},
    Advice{"'->'", "=>", "a prefix is written `a -> P`"},
    Advice{"'->'", "=", "a prefix is written `a -> P`"},
    Advice{"'->'", ";", "a prefix is written `a -> P`; `;` stands between two processes: `a -> SKIP; Q`"},
    Advice{"'<-'", "->", "a variable is drawn from a set by `x <- S`"},
    Advice{"'then'", "=", "values are compared with `==`; `=` stands in definitions"},
    Advice{"'then'", "<>", "values that differ are compared with `!=`; `<>` is the empty sequence"},
    Advice{"'then'", "||", "a condition is joined by `or`; `||` stands in `P [A || B] Q`"},
    Advice{"an expression", "&", "conditions are joined by `and`; `&` stands between a condition and a process"},
    Advice{"an expression", "!", "a condition is negated by `not`"},
    Advice{"'else'", "",
           "an `if` has the form `if C then A else B`: without an `else` there would be no value; for a "
           "process `else STOP` or `else SKIP` may be meant"},
    Advice{"", "within", "`within` ends a `let`, which is missing here"},
    Advice{"", "else", "`else` belongs to `if C then A else B`, which is not complete before it"},
    Advice{"'='", "", "a definition has the form `NAME = EXPRESSION` or `NAME(x) = EXPRESSION`"},
    Advice{"a refinement or a property", "",
           "a refinement is written `P [T= Q`, `P [F= Q` or `P [FD= Q`, a property `P :[deadlock free]`"},
    Advice{"the end of the line", "||",
           "processes run side by side by `P ||| Q`, together on the events of A by `P [|A|] Q`"},
    Advice{"'<->'", "]", "processes run together on the events of A by `P [|A|] Q`"},
    Advice{"the end of the line", "|",
           "a choice is written `P [] Q`; `|` stands between the constructors of a `datatype`"},
    Advice{"the end of the line", ",", "each `channel` line gives one type to all of its names"},
};

}  // namespace

std::span<const Advice> all_advice() {
    return rows;
}

std::string_view advice_on(std::string_view expected, std::string_view found) {
    const auto fits = [&](const Advice& row) {
        return (row.expected.empty() || row.expected == expected) && (row.found.empty() || row.found == found);
    };
    const auto* const row = std::ranges::find_if(rows, fits);
    return row == rows.end() ? std::string_view() : row->advice;
}

}  // namespace robochart::cspm
