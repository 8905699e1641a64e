// SPDX-License-Identifier: Apache-2.0
// Tests words of other notations. Each row of the table is recognised in its position and reported once with
// RoboChart's word for it. The rest of the text is parsed as if RoboChart's word were there.
#include "frontend/syntax/foreign_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/diagnostics/fixes.hpp"
#include "frontend/syntax/lexer.hpp"
#include "tests/frontend/fixture.hpp"

namespace robochart::frontend {
namespace {

using ::testing::HasSubstr;
using testing::read;
using testing::resolved;

/// The parts of a machine. The tested text is inserted between them.
const std::string before = "stm S {\n event e event f clock C var x : int var b : boolean\n initial i\n state A { }\n";
const std::string after = "\n transition t0 { from i to A }\n}\n";

/// Returns text to follow the word, so that the text with the replacement is valid.
std::string rest_of(const ForeignWord& row) {
    switch (row.place) {
        case ForeignPlace::clause:
            if (row.instead == "trigger") return " e";
            if (row.instead == "condition") return " b";
            if (row.instead == "action") return " skip";
            return row.instead == "#" ? " C" : "";
        case ForeignPlace::state_part:
            return row.instead.empty() ? "" : " skip";
        case ForeignPlace::statement:
            if (row.instead == "send") return " f";
            return row.instead == "#" ? " C" : " x";
        case ForeignPlace::infix:
            return row.word == "mod" ? " 2 > 0" : " b";
        case ForeignPlace::declaration:
        case ForeignPlace::member:
        case ForeignPlace::if_end:
        case ForeignPlace::type:
        case ForeignPlace::value:
        case ForeignPlace::operation:
        case ForeignPlace::event:
            break;
    }
    return "";
}

std::string member_rest(const ForeignWord& row) {
    if (row.left_out) return row.word == ";" || row.word == "," ? "" : " event g";
    if (row.instead == "stm") return "";
    if (row.instead == "clock" || row.instead == "event") return " g";
    if (row.instead == "const" || row.instead == "var") return " g : int";
    return " g";
}

/// Returns text to follow the word that begins a declaration.
std::string declaration_rest(const ForeignWord& row) {
    if (row.instead == "stm") return " S { initial i state A { } }";
    if (row.instead == "enumeration" || row.instead == "datatype") return " T { }";
    if (row.instead == "function") return " g() : int { }";
    return row.instead == "operation" ? " g() { }" : " T";
}

/// Returns a text with the row's word in its position, or "" for positions that the parser does not check.
std::string text_with(const ForeignWord& row) {
    const std::string word(row.word);
    switch (row.place) {
        case ForeignPlace::declaration:
            return word + declaration_rest(row);
        case ForeignPlace::member:
            if (row.word == "operation") return "interface I { operation f() }";
            if (row.instead == "stm") return "controller D { " + word + " S { initial i state A { } } }";
            if (row.instead == "transition") return before + word + " t1 { from A to A trigger e }" + after;
            return before + word + member_rest(row) + after;
        case ForeignPlace::state_part:
            return before + "state B { " + word + rest_of(row) + " }" + after;
        case ForeignPlace::clause:
            if (row.instead == "from") return before + "transition t1 { source A to A trigger e }" + after;
            if (row.instead == "to") return before + "transition t1 { from A target A trigger e }" + after;
            return before + "transition t1 { from A to A " + word + rest_of(row) + " }" + after;
        case ForeignPlace::statement:
            return before + "state B { entry " + word + rest_of(row) + " }" + after;
        case ForeignPlace::if_end:
            return before + "state B { entry if b then x = 1 " + word + " }" + after;
        case ForeignPlace::infix:
            return before + "transition t1 { from A to A condition " + (row.word == "mod" ? "x " : "b ") + word +
                   rest_of(row) + " }" + after;
        case ForeignPlace::type:
        case ForeignPlace::value:
        case ForeignPlace::operation:
        case ForeignPlace::event:
            break;
    }
    return "";
}

TEST(ForeignWords, EachRowIsReportedOnceAndFixedWhereAWordReplacesIt) {
    for (const ForeignWord& row : foreign_words()) {
        const std::string text = text_with(row);
        if (text.empty()) continue;
        const auto reading = read(text);
        const std::vector<diagnostics::Diagnostic> findings = reading->findings.sorted_findings();
        ASSERT_EQ(findings.size(), 1U) << row.word << "\n" << text << reading->report();
        EXPECT_EQ(findings[0].rule->code, "RC-P34") << text << reading->report();
        EXPECT_THAT(reading->report(), HasSubstr(std::string(row.reason)));
        EXPECT_EQ(findings[0].fixes.empty(), row.instead.empty() && !row.left_out) << row.word;
        if (findings[0].fixes.empty()) continue;
        const auto fixed = read(diagnostics::apply_fixes(text, findings[0].fixes));
        EXPECT_TRUE(fixed->findings.ok()) << text << fixed->report();
    }
}

/// The replacements in the table are words of RoboChart. No two rows for a position have the same word.
TEST(ForeignWords, RowsNameWordsOfTheGrammar) {
    for (const ForeignWord& row : foreign_words()) {
        EXPECT_FALSE(row.reason.empty()) << row.word;
        EXPECT_FALSE(row.reason.ends_with('.')) << row.word;
        EXPECT_EQ(foreign_word(row.word, row.place), &row) << row.word << " stands twice in one place";
        if (row.place == ForeignPlace::type || row.instead.empty()) continue;
        const auto symbols = symbol_words();
        EXPECT_TRUE(is_reserved(row.instead) || std::ranges::find(symbols, row.instead) != symbols.end())
            << row.instead;
    }
}

struct Written {
    const char* text;     ///< in a machine
    const char* reason;   ///< part of the message
    const char* instead;  ///< the text of its fix, or "" if there is none
};

/// Tests forms that consist of more than a word.
TEST(ForeignForms, AreReportedOnceWithTheirFix) {
    const Written forms[] = {
        {"transition t1 { from A to A trigger e [ x > 0 ] }", "after `condition`", "condition x > 0"},
        {"transition t1 { A -> A trigger e }", "leads `from` a node", "from A to"},
        {"transition t1 { from A to A condition x <> 1 }", "`!=` tests whether", "!="},
        {"transition t1 { from A to A condition x /= 1 }", "`!=` tests whether", "!="},
        {"state B { entry x ++ }", "`x = x + 1`", "x = x + 1"},
        {"state B { entry x += 2 }", "`x = x + ...`", "x = x +"},
        {"state B { entry C := 0 }", "write `#C` to reset a clock", "#C"},
        {"transition t1 { from A to A trigger e reset(C) }", "write `#C` to reset a clock", "#C"},
        {"state B { entry / x = 1 }", "directly follows its keyword", ""},
        {"state B { entry if b { x = 1 } else { x = 2 } }", "if c then S else T end", ""},
        {"int y", "`var y : int`", "var y : int"},
        {"bool y", "`var y : boolean`", "var y : boolean"},
        {"var int y", "written after the name", "y : int"},
        {"initial state B { }", "a separate junction", ""},
        {"final state B", "`final` and a name declare", "final"},
        {"clock D = 0", "only by its name", "D"},
        {"clock D : real", "only by its name", "D"},
        {"event g()", "`event e`", ""},
        {"event g(int)", "`event e : int`", " : int"},
        {"event g(v : Seq(int))", "`event e : int`", " : Seq(int)"},
        {"event e2 event e3 var y : int := 0", "assignment with `=`", "="},
        {"state B : { }", "in braces after its name", ""},
        {"transition t1 : { from A to A trigger e }", "in braces after its name", ""},
        {"transition t1 { from A, to A trigger e }", "need no separator", ""},
        {"transition t1 { from A to A; trigger e }", "need no separator", ""},
        {"transition t1 { from A to A trigger e, condition b }", "need no separator", ""},
        {"transition t1 { from A to A trigger: e }", "directly followed by its contents", ""},
        {"transition t1 { from A to A condition = b }", "directly followed by its contents", ""},
        {"state B { entry: skip }", "directly followed by its contents", ""},
        {"state B { entry { skip } }", "have no braces", ""},
        {"probabilistic p transition t1 { from A to p trigger e } transition t2 { from p to A probability 50% } "
         "transition t3 { from p to A probability 0.5 }",
         "a number from 0 to 1", "0.50"},
    };
    for (const Written& form : forms) {
        const auto reading = read(before + form.text + after);
        const std::vector<diagnostics::Diagnostic> findings = reading->findings.sorted_findings();
        ASSERT_EQ(findings.size(), 1U) << form.text << reading->report();
        EXPECT_EQ(findings[0].rule->code, std::string_view(form.instead) == "=" ? "RC-P22" : "RC-P34") << form.text;
        EXPECT_THAT(reading->report(), HasSubstr(form.reason));
        const std::string fix = findings[0].fixes.empty() ? "" : findings[0].fixes[0].replacement;
        EXPECT_EQ(fix, form.instead) << form.text;
    }
}

/// Returns the text after the certain fixes, which must have no finding.
std::string fixed(const std::string& text, const std::string& code) {
    const auto reading = read(text, text.starts_with("assertion"));
    std::vector<diagnostics::FixIt> fixes;
    for (const diagnostics::Diagnostic& finding : reading->findings.sorted_findings()) {
        EXPECT_EQ(finding.rule->code, code) << text;
        fixes.insert(fixes.end(), finding.fixes.begin(), finding.fixes.end());
    }
    const std::string result = diagnostics::apply_fixes(text, fixes);
    const auto again = read(result, text.starts_with("assertion"));
    EXPECT_TRUE(again->findings.ok()) << result << again->report();
    return result;
}

TEST(ForeignForms, OfNumbersListsAndOrdersAreFixed) {
    EXPECT_EQ(fixed("enumeration Z { NEAR, FAR }", "RC-P34"), "enumeration Z { NEAR FAR }");
    EXPECT_EQ(fixed("stm S { const k : real = 30.5f const n : nat = 3ul }", "RC-P34"),
              "stm S { const k : real = 30.5 const n : nat = 3 }");
    EXPECT_EQ(fixed("stm S { transition t { from a to b condition x > 0 #C } }", "RC-P18"),
              "stm S { transition t { from a to b #C condition x > 0 } }");
    EXPECT_EQ(fixed("stm S { transition t { from a to b trigger e reset( C ) } }", "RC-P34"),
              "stm S { transition t { from a to b trigger e #C } }");
    EXPECT_EQ(fixed("stm S { transition t { from a to b condition x action skip trigger e } }", "RC-P18"),
              "stm S { transition t { from a to b trigger e condition x action skip } }");
    EXPECT_EQ(fixed("stm S { transition t { from a to b triger e conditon x } }", "RC-P01"),
              "stm S { transition t { from a to b trigger e condition x } }");
    EXPECT_EQ(fixed("module M { connection r on e to c on e (async) }", "RC-P01"),
              "module M { connection r on e to c on e (_async) }");
    EXPECT_EQ(fixed("module M { connection r on e to c on e async }", "RC-P34"),
              "module M { connection r on e to c on e (_async) }");
    EXPECT_EQ(fixed("module M { connection r on e to c on e [async] }", "RC-P34"),
              "module M { connection r on e to c on e (_async) }");
    EXPECT_EQ(fixed("module M { cref c : C }", "RC-P34"), "module M { cref c = C }");
    EXPECT_EQ(fixed("package p; type T", "RC-P34"), "package p type T");
    EXPECT_EQ(fixed("package p import q; type T", "RC-P34"), "package p import q type T");
    EXPECT_EQ(fixed("datatype D { x : int; y : int }", "RC-P34"), "datatype D { x : int y : int }");
    EXPECT_EQ(fixed("stm S { requires I, uses J }", "RC-P34"), "stm S { requires I uses J }");
    EXPECT_EQ(fixed("stm S {\n\tinitial i\n\tstate A\n\tstate B;\n}", "RC-P01"),
              "stm S {\n\tinitial i\n\tstate A { }\n\tstate B { }\n}");
    EXPECT_EQ(fixed("stm S { transition t { from a to b condition x \u2264 3 \u2227 \u00ACy } }", "RC-P05"),
              "stm S { transition t { from a to b condition x <= 3 /\\ not y } }");
    EXPECT_EQ(fixed("assertion A : S is determinstic", "RC-P01"), "assertion A : S is deterministic");
    EXPECT_EQ(fixed("assertion A : S refines T in the failures-divergences model", "RC-P34"),
              "assertion A : S refines T in the failures divergences model");
}

struct Formed {
    const char* text;  ///< text of a file; of an assertion file unless it starts with "stm" or a word for a declaration
    const char* note;
};

const Formed formed[] = {
    {"assert P::M is deadlock-free", "has the form `assertion A"},
    {"check P::M", "has the form `assertion A"},
    {"property P::M", "has the form `assertion A"},
    {"assertion P::M is deadlock-free", "has the form `assertion A"},
    {"untimed A : P::M is deadlock-free", "come before `assertion`"},
    {"timed A : P::M is deadlock-free", "come before `assertion`"},
    {"assertion timed A : P::M is deadlock-free", "come before `assertion`"},
    {"assertion untimed A : P::M is deadlock-free", "come before `assertion`"},
    {"A[] not deadlock", "a process specifies"},
    {"E<> S.B", "a process specifies"},
    {"assertion A : G (P::M)", "a process specifies"},
    {"P=? [ F done ]", "`prob property A"},
    {"assertion A : P::M is deadlock-free;", "a separate assertion"},
    {"assertion A : P::M is deadlock-free, deterministic", "a separate assertion"},
    {"assertion A : P::M is deadlock-free and deterministic", "a separate assertion"},
    {"assertion A : P::M is deadlock-free where c = 3", "`with constant c"},
    {"assertion A : P::M is deadlock-free with constant c = 3", "`with constant c"},
    {"assertion A : P::M deadlock-free", "written after `is`"},
    {"assertion A : P::M divergence-free", "written after `is`"},
    {"assertion A : P::M deterministic", "written after `is`"},
    {"assertion A : P::S::A reachable", "written after `is`"},
    {"assertion A : P::M does not deadlock", "written after `is`"},
    {"assertion A : P.M is deadlock-free", "is `P::M`"},
    {"assertion A : P::S reaches B", "is reachable in"},
    {"assertion A : P::S::A is reachable", "is reachable in"},
    {"assertion A : P::S::A is never reached", "is reachable in"},
    {"assertion A : P::S::A is reached", "is reachable in"},
    {"assertion A : P::S [T= P::T", "`P equals Q`"},
    {"assertion A : P::S == P::T", "`P equals Q`"},
    {"assertion A : P::S = P::T", "`P equals Q`"},
    {"assertion A : P::S is equivalent to P::T", "`P equals Q`"},
    {"assertion A : P::M is livelock-free", "`divergence-free`"},
    {"assertion A : P::M is deadlock_free", "with a hyphen"},
    {"assertion A : P::M is divergence_free", "with a hyphen"},
    {"assertion A : P::S is clock-initialised", "`assertion A : clock"},
    {"assertion A : event e missed in P::S", "is not missed in"},
    {"assertion A : P::S refines P::T in traces", "`in the traces model`"},
    {"csp X { X = STOP }", "csp-begin ... csp-end"},
    {"csp csp-begin X = STOP csp-end", "csp-begin ... csp-end"},
    {"prob property A : Prob=? of [eventually p]", "`Finally p`"},
    {"prob property A : Prob=? of [always p]", "`Finally p`"},
    {"prob property A : Prob=? of [F p]", "`Finally p`"},
    {"prob property A : Prob=? of [G p]", "`Finally p`"},
    {"-- words", "begins with `//`"},
    {"# words", "begins with `//`"},
    {"package p { type T }", "at the beginning of the file"},
    {"import \"core.rct\"", "files of a folder are read together"},
    {"type T = int", "cannot have second names"},
    {"enumeration E = A | B", "`enumeration E { A B }`"},
    {"datatype D = A | B", "`datatype D {"},
    {"stm S extends T { }", "without parameters or parents"},
    {"stm S { clock C = x }", "only by its name"},
    {"stm S { clock C : 5 }", "only by its name"},
    {"stm S { var x = 0 }", "a variable has a type"},
    {"stm S { const c = 0 }", "a constant has a type"},
    {"stm S { var x : nat[5] }", "`Seq(nat)`"},
    {"stm S { var x : int 0..5 }", "`--range T=0..5`"},
    {"stm S { var x : [0..5] }", "`--range T=0..5`"},
    {"stm S { var x : 0..5 }", "`--range T=0..5`"},
    {"interface I { f(int) }", "`x : int`"},
    {"interface I { f(x : int, int) }", "`x : int`"},
    {"interface I { f() : int }", "has no result"},
    {"controller C { S s }", "`sref s = S`"},
    {"controller C { sref s S }", "`sref s = S`"},
    {"module M { cref c C }", "`sref s = S`"},
    {"module M { rref r R }", "`sref s = S`"},
    {"module M { connection r.e -> c.e }", "`connection a on e to b on f`"},
    {"module M { connection from r on e to c on e }", "`connection a on e to b on f`"},
    {"module M { connection r on e to c on e [async, mult] }", "ends with `(_async)`"},
    {"module M { connection r on e to c on e [_async, mult] }", "ends with `(_async)`"},
    {"stm S { transition { from A to B } }", "has the form `transition t"},
    {"stm S { transition t from A to B }", "has the form `transition t"},
    {"stm S { A -> B }", "has the form `transition t"},
    {"stm S { transition t { from A -> B } }", "has the form `transition t"},
    {"stm S { [*] --> A }", "`initial i`"},
    {"stm S { initial -> A }", "`initial i`"},
    {"stm S { probabilistic { } }", "`probabilistic p`"},
    {"stm S { state { } }", "`state S { entry a }`"},
    {"stm S { state A entry skip }", "`state S { entry a }`"},
    {"stm S { transition t { from A to B trigger after(5) } }", "clocks measure time"},
    {"stm S { transition t { from A to B trigger e, f } }", "waits for one event"},
    {"stm S { transition t { from A to B trigger e or f } }", "waits for one event"},
    {"stm S { transition t { from A to B trigger e || f } }", "waits for one event"},
    {"stm S { transition t { from A to B trigger e \\/ f } }", "waits for one event"},
    {"stm S { transition t { from A to B trigger e(x) } }", "`trigger e?x`"},
    {"stm S { transition t { from A to B trigger !e } }", "send an event after `action`"},
    {"stm S { state A { entry x == 1 } }", "`x = e`"},
    {"stm S { state A { entry x <- 1 } }", "`x = e`"},
    {"stm S { state A { entry !e } }", "`e` sends an event"},
    {"stm S { state A { entry send e to c } }", "the connections of the controller"},
    {"stm S { state A { entry if b x = 1 end } }", "if c then S else T end"},
    {"stm S { state A { entry if b then x = 1 elif c then x = 2 end } }", "a separate `end`"},
    {"stm S { state A { entry if b then x = 1 elsif c then x = 2 end } }", "a separate `end`"},
    {"stm S { state A { entry if b then x = 1 elseif c then x = 2 end } }", "a separate `end`"},
    {"stm S { state A { entry wait 5 } }", "`wait(n)`"},
    {"stm S { state A { entry wait(5 s) } }", "no unit"},
    {"stm S { state A { entry wait(5 ms) } }", "no unit"},
    {"stm S { state A { entry wait(5 sec) } }", "no unit"},
    {"stm S { state A { entry wait(5 seconds) } }", "no unit"},
    {"stm S { state A { entry wait(5 min) } }", "no unit"},
    {"stm S { transition t { from A to B condition since(C) > 5 time units } }", "no unit"},
    {"stm S { state A { entry f(5 deg) } }", "no unit"},
    {"stm S { state A { entry f(5 cm) } }", "no unit"},
    {"stm S { state A { entry f(5 m) } }", "no unit"},
    {"stm S { transition t { from A to B condition since C > 5 } }", "is `since(C)`"},
    {"stm S { transition t { from A to B condition sinceEntry A > 5 } }", "is `sinceEntry(S)`"},
    {"stm S { transition t { from A to B condition sinceEntry() > 5 } }", "is `sinceEntry(S)`"},
    {"stm S { state A { entry x = b ? 1 : 2 } }", "`if c then a else b end`"},
    {"stm S { state A { entry x = y ** 2 } }", "`x * x`"},
    {"stm S { state A { entry x = |y| } }", "absolute value"},
    {"stm S { state A { entry x = .5 } }", "both sides of the point"},
    {"stm S { transition t { from A to B condition x > 1. action skip } }", "both sides of the point"},
    {"stm S { state A { entry x = 1000% } state B { } }", "`%` is the remainder"},
    {"stm S { var x : int = 0\n -- a word\n }", "begins with `//`"},
    {"-- a comment\nstm S { }", "begins with `//`"},
    {"#include <x>\nstm S { }", "begins with `//`"},
    {"stm S { #define X 3\n }", "begins with `//`"},
    {"stm S { state A { # words\n } }", "begins with `//`"},
};

bool of_a_model(std::string_view text) {
    for (const std::string_view word : {"stm ", "interface ", "controller ", "module ", "package ", "type ",
                                        "enumeration ", "datatype ", "-- a comment", "#include", "import "})
        if (text.starts_with(word)) return true;
    return false;
}

TEST(ForeignForms, OfSeveralWordsAreExplained) {
    std::set<std::string> given;
    for (const Formed& form : formed) {
        const auto reading = read(form.text, !of_a_model(form.text));
        const std::string report = reading->report();
        EXPECT_THAT(report, HasSubstr(form.note)) << form.text;
        for (const diagnostics::Diagnostic& finding : reading->findings.sorted_findings())
            for (const diagnostics::Note& note : finding.notes) given.insert(note.message);
    }
    for (const diagnostics::Advice& row : foreign_forms()) {
        EXPECT_TRUE(given.contains(std::string(row.advice))) << row.words;
        EXPECT_FALSE(row.advice.ends_with('.')) << row.advice;
    }
}

/// `1e5` is neither a 1 with a suffix nor a list of two items.
TEST(ForeignForms, AnExponentIsNotLeftOut) {
    const auto reading = read("stm S { initial i state A { entry f(1e5) } transition t { from i to A } }");
    ASSERT_FALSE(reading->findings.ok());
    for (const diagnostics::Diagnostic& finding : reading->findings.sorted_findings())
        EXPECT_TRUE(finding.fixes.empty());
}

TEST(ForeignForms, StateMachineIsStm) {
    const auto reading = read("state machine S { initial i state A { } transition t0 { from i to A } }");
    ASSERT_EQ(reading->findings.sorted_findings().size(), 1U) << reading->report();
    EXPECT_EQ(reading->findings.sorted_findings()[0].fixes.at(0).replacement, "stm");
    ASSERT_EQ(reading->file().declarations.size(), 1U);
    EXPECT_EQ(reading->file().declarations[0]->name, "S");
}

TEST(ForeignForms, AnIfWithoutEndSaysWhichOne) {
    const auto reading = read(before + "state B { entry if b then x = 1 }" + after);
    ASSERT_EQ(reading->findings.sorted_findings().size(), 1U) << reading->report();
    const diagnostics::Diagnostic finding = reading->findings.sorted_findings()[0];
    EXPECT_THAT(reading->report(), HasSubstr("`end`, which closes the `if`"));
    ASSERT_EQ(finding.notes.size(), 1U);
    const auto fixed =
        read(diagnostics::apply_fixes(before + "state B { entry if b then x = 1 }" + after, finding.fixes));
    EXPECT_TRUE(fixed->findings.ok()) << fixed->report();
}

/// The meaning of these names depends on the declarations. The finding reports an unknown name, and its note suggests
/// the meaning.
TEST(ForeignNames, AreUnknownNamesWithANoteAndAFix) {
    const Written forms[] = {
        {"transition t1 { from A to A condition C > 20 }", "time since its last reset", "since(C)"},
        {"state B { entry C = 0 }", "write `#C` to reset a clock", "#C"},
        {"state B { entry reset(C) }", "write `#C` to reset a clock", "#C"},
        {"state B { entry sleep(2) }", "lets n time units pass", "wait"},
        {"state B { entry null }", "does nothing", "skip"},
        {"transition t1 { from A to A condition True }", "truth values", "true"},
        {"var y : float", "the type of real numbers", "real"},
    };
    for (const Written& form : forms) {
        const auto reading = resolved(before + form.text + after);
        std::vector<diagnostics::Diagnostic> errors;
        for (const diagnostics::Diagnostic& finding : reading->findings.sorted_findings())
            if (finding.rule->severity == diagnostics::Severity::error) errors.push_back(finding);
        ASSERT_EQ(errors.size(), 1U) << form.text << reading->report();
        EXPECT_EQ(errors[0].rule->code, "RC-N01") << form.text;
        EXPECT_THAT(reading->report(), HasSubstr(form.reason));
        ASSERT_FALSE(errors[0].fixes.empty()) << form.text;
        EXPECT_EQ(errors[0].fixes[0].replacement, form.instead) << form.text;
    }
}

// Names that a model declares are valid, whatever they mean in other languages.
TEST(ForeignWords, MayBeNames) {
    const auto reading = read(
        "interface I { sleep(n : nat) event emit event raise }\n"
        "stm S {\n event on_ event emit var x : nat var and : nat\n initial i\n state A { entry emit ; x = and }\n"
        " transition t0 { from i to A }\n}\n");
    EXPECT_TRUE(reading->findings.ok()) << reading->report();
}

}  // namespace
}  // namespace robochart::frontend
