#include "checker/cspm/syntax/advice.hpp"

#include <array>

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
    Advice{"", "@ <>", "values that differ are compared with `!=`; `<>` is the empty sequence"},
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
    Advice{"", "@ mod", "the remainder is `%`"},
    Advice{"", "@ div", "integers are divided by `/`"},
    Advice{"the end of the line",
           "@ =", "a definition begins a line, and no `;` ends the one before; values are compared with `==`"},
    Advice{"')'", "( NAME @ :", "parameters have no types: `P(x) = ...`"},
    Advice{"'->'", "@ in", "the values that an input takes are limited by `a?x:S -> P`"},
    Advice{"'<-'", "-> NAME @ ]]", "an event a becomes b in `P[[a <- b]]`"},
};

}  // namespace

std::span<const diagnostics::Advice> all_advice() {
    return rows;
}

}  // namespace robochart::cspm
