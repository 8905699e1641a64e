// SPDX-License-Identifier: Apache-2.0
// Tests the grammar of both dialects (docs/rules-language.md): accepted texts with their trees, and rejected texts with
// places.
#include <gtest/gtest.h>

#include <set>

#include "claims/sleec/syntax/parser.hpp"
#include "claims/sleec/syntax/printer.hpp"
#include "tests/claims/sleec/support.hpp"

namespace robochart::sleec {
namespace {

using testing::Read;
using testing::with_definitions;

/// Returns the first rule as it is printed.
std::string as_read(const std::string& rule) {
    const Read read(with_definitions("R " + rule));
    return read.diagnostics.ok() && !read.file.rules.empty() ? print(read.file.rules.front()) : read.findings();
}

TEST(SleecReader, ReadsEachFormOfRule) {
    for (const std::string rule :
         {"when Go then Stop", "when Go and near then Stop within 5 seconds",
          "when Go then not Stop within MAX minutes",
          "when Go then Stop within 3 hours otherwise Alarm within 1 days otherwise Help",
          "when Go then Stop unless near unless level > 5 then Alarm",
          "when Go then Stop within 1 minutes unless near then {Help within 3 seconds unless safe}",
          "when Go and load >= mid and not near then Stop", "when Go and true then Stop",
          "after Go and near, Stop within 5 seconds", "Stop at least 5 seconds after Go"})
        EXPECT_EQ(as_read(rule), rule);
}

/// [TK]: `and` and `or` have the same precedence and are left-associative. `not` applies to one comparison.
TEST(SleecReader, AndAndOrBindAlikeFromTheLeft) {
    EXPECT_EQ(as_read("when Go and near or safe and level < 3 then Stop"),
              "when Go and (near or safe) and level < 3 then Stop");
    EXPECT_EQ(as_read("when Go and near and (safe or level < 3) then Stop"),
              "when Go and near and (safe or level < 3) then Stop");
    EXPECT_EQ(as_read("when Go and not level = 1 and near then Stop"), "when Go and not level = 1 and near then Stop");
}

/// The warning shows how the condition is parsed, and its fix adds the parentheses.
TEST(SleecReader, WarnsWhereTheTwoMeet) {
    const Read read(with_definitions("R when Go and near or safe and level < 3 then Stop"));
    EXPECT_EQ(read.findings(), "SLEEC-P10:7");
    EXPECT_NE(read.report().find("this is '(near or safe) and level < 3'"), std::string::npos) << read.report();
    EXPECT_EQ(Read(with_definitions("R when Go and (near or safe) and level < 3 then Stop")).findings(), "");
    EXPECT_EQ(Read(with_definitions("R when Go and near and safe then Stop")).findings(), "");
}

/// [TK]: without braces, a defeater belongs to the whole response, not to the part after `otherwise`.
TEST(SleecReader, DefeatersBelongToTheWholeResponse) {
    const Read read(with_definitions("R when Go then Stop within 2 seconds otherwise Alarm unless near"));
    const Response& response = *read.file.rules.at(0).response;
    EXPECT_EQ(response.defeaters.size(), 1U);
    EXPECT_TRUE(response.otherwise->defeaters.empty());
}

TEST(SleecReader, OtherwiseBehindADefeaterBelongsToItsResponse) {
    const Read read(with_definitions(
        "R when Go then Stop unless near then Alarm within 1 seconds otherwise Help within 2 seconds otherwise Go"));
    const Response& response = *read.file.rules.at(0).response;
    EXPECT_EQ(response.otherwise, nullptr);
    EXPECT_EQ(response.defeaters.at(0).response->otherwise->otherwise->event.text, "Go");
}

TEST(SleecReader, ReadsConcernsAndPurposes) {
    const Read read(
        "def_start event Go event Stop measure near : boolean def_end\n"
        "rule_start R when Go then not Stop rule_end\n"
        "concern_start c1 when Go and {near} then not Stop concern_end\n"
        "purpose_start p1 exists Go and {near} while Stop p2 when Go then Stop within [1, 3] seconds purpose_end");
    EXPECT_EQ(read.findings(), "");
    EXPECT_EQ(read.file.dialect, Dialect::legos);
    ASSERT_EQ(read.file.purposes.size(), 2U);
    EXPECT_EQ(read.file.purposes[0].during->event.text, "Stop");
    EXPECT_EQ(read.file.purposes[1].response->limit->from->text, "1");
    EXPECT_FALSE(read.file.concerns.at(0).exists);
}

/// `while E` means an occurrence at the same instant. `while E within N` means a response.
TEST(SleecReader, ReadsWhileWithALimitAsAResponse) {
    const Read read(
        "def_start event Go event Stop measure near : boolean def_end\nrule_start R when Go then not Stop rule_end\n"
        "purpose_start p1 exists Go and {near} while Stop eventually p2 exists Go while Stop within 3 seconds "
        "p3 exists Go while not Stop within 3 seconds purpose_end");
    EXPECT_EQ(read.findings(), "");
    ASSERT_EQ(read.file.purposes.size(), 3U);
    for (const Property& purpose : read.file.purposes) {
        EXPECT_TRUE(purpose.exists);
        EXPECT_EQ(purpose.during, nullptr);
        ASSERT_NE(purpose.response, nullptr);
    }
    EXPECT_TRUE(read.file.purposes[0].response->eventually);
    EXPECT_EQ(read.file.purposes[1].response->limit->to->text, "3");
    EXPECT_TRUE(read.file.purposes[2].response->negated);
}

TEST(SleecReader, ReadsLimitsThatLegosWrites) {
    for (const std::string rule :
         {"when Go then Stop within [1 seconds, 10 minutes]", "when Go then Stop within [1, 2] hours",
          "when Go then Stop within (60 - {level}) seconds", "when Go then Stop within [(MAX + 1), (2 * MAX)] days"}) {
        EXPECT_EQ(as_read(rule), rule);
        EXPECT_EQ(Read(with_definitions("R " + rule)).file.dialect, Dialect::legos) << rule;
    }
}

TEST(SleecReader, KnowsTheDialectByWhatOnlyOneHas) {
    EXPECT_EQ(Read(with_definitions("R when Go then Stop")).file.dialect, Dialect::sleec_tk);
    for (const std::string rule :
         {"R when Go and {near} then Stop", "R when Go then not Stop", "R when Go then Stop eventually",
          "R when Go then Stop otherwise Help", "R when Go then Stop within [1, 2] seconds",
          "R when Go then Stop within 2 seconds else Help", "R when Go and ({level} + 1 > 5) then Stop"}) {
        const Read read(with_definitions(rule));
        EXPECT_EQ(read.file.dialect, Dialect::legos) << rule;
        EXPECT_EQ(read.findings(), "") << rule;
    }
}

TEST(SleecReader, NamesWhatTheDialectOfTheFileLacks) {
    const Read read(with_definitions("R1 when Go and {near} then Stop\nR2 when Go and safe then Stop"));
    EXPECT_EQ(read.findings(), "SLEEC-P08:8");
    EXPECT_NE(read.report().find("a measure without braces does not belong to the dialect of LEGOS"),
              std::string::npos);
}

TEST(SleecReader, MarksItsExtensions) {
    EXPECT_EQ(Read(with_definitions("R after Go, Stop within 1 seconds")).findings(), "SLEEC-P09:7");
    EXPECT_EQ(Read(with_definitions("assume R when Go then Stop")).findings(), "SLEEC-P09:7");
    EXPECT_EQ(Read(with_definitions("assume when Go then Stop")).findings(), "") << "a rule of that name";
    EXPECT_EQ(Read("def_start event Go map Go to M::go def_end rule_start rule_end").findings(), "SLEEC-P09:1");
    EXPECT_EQ(Read(with_definitions("R when Go then Stop unless Halt")).checked_too().findings(), "SLEEC-P09:7");
}

TEST(SleecReader, GoesOnAtTheNextRule) {
    const Read read(
        with_definitions("R1 when Go Stop\nR2 when Go then\nR3 when Go then Stop within 5\n"
                         "R4 when Go then Stop\nR5 wehn Go then Stop"));
    // R2 has no response, so the parser takes the event name R3 as its response. The rest of rule R3 is then an error.
    EXPECT_EQ(read.findings(), "SLEEC-P01:7 SLEEC-P01:9 SLEEC-P01:11");
    EXPECT_EQ(read.file.rules.size(), 2U);
}

TEST(SleecReader, SuggestsTheWordThatWasMeant) {
    const Read read(with_definitions("R1 when Go then Stop within 5 second"));
    ASSERT_EQ(read.findings(), "SLEEC-P01:7");
    ASSERT_EQ(read.diagnostics.sorted_findings().front().fixes.size(), 1U);
    EXPECT_EQ(read.diagnostics.sorted_findings().front().fixes.front().replacement, "seconds");
}

TEST(SleecReader, RefusesWithAReason) {
    EXPECT_EQ(Read("def_start def_end rule_start rule_end relation_start equal A B relation_end").findings(),
              "SLEEC-P06:1");
    EXPECT_EQ(Read(with_definitions("R when Go then Stop within -5 seconds")).findings(), "SLEEC-P06:7");
    EXPECT_EQ(Read(with_definitions("R when Go then Stop within 99999999999 seconds")).findings(), "SLEEC-P04:7");
    EXPECT_EQ(Read(with_definitions("R when Go then Stop \xc3\xb6")).findings(), "SLEEC-P02:7");
    EXPECT_EQ(Read("/* def_start").findings(), "SLEEC-P03:1 SLEEC-P01:1");
    EXPECT_EQ(Read(with_definitions("R when Go and {level < 10} then Stop")).findings(), "SLEEC-P01:7")
        << "in neither dialect";
}

TEST(SleecReader, LimitsNestingAndChains) {
    std::string deep = "R when Go and ";
    for (int i = 0; i < 50'000; ++i) deep += "(";
    EXPECT_EQ(Read(with_definitions(deep)).findings(), "SLEEC-P05:7");
    std::string chain = "R when Go and near";
    for (int i = 0; i < 50'000; ++i) chain += " and near";
    EXPECT_EQ(Read(with_definitions(chain + " then Stop")).findings(), "SLEEC-P05:7");
    std::string otherwise = "R when Go then Stop within 1 seconds";
    for (int i = 0; i < 50'000; ++i) otherwise += " otherwise Stop within 1 seconds";
    EXPECT_EQ(Read(with_definitions(otherwise)).findings(), "SLEEC-P05:7");
    std::string braces = "R when Go then Stop unless near then ";
    for (int i = 0; i < 50'000; ++i) braces += "{";
    EXPECT_EQ(Read(with_definitions(braces)).findings(), "SLEEC-P01:7");
}

TEST(SleecReader, ReadsArgumentsAndStates) {
    const Read read(
        with_definitions("R1 when Go(1, red) then not Stop(_) within 3 seconds unless Halt(-2)\n"
                         "R2 when Go(2, Colour::red) and near or in Operating::Held then Stop(true)\n"
                         "R3 Stop(false) at least 2 seconds after Go(MAX, _)"));
    ASSERT_TRUE(read.diagnostics.ok()) << read.report();
    ASSERT_EQ(read.file.rules.size(), 3U);
    EXPECT_EQ(print(read.file.rules[0]), "when Go(1, red) then not Stop(_) within 3 seconds unless Halt(-2)");
    EXPECT_EQ(print(read.file.rules[1]), "when Go(2, Colour::red) and near or in Operating::Held then Stop(true)");
    EXPECT_EQ(print(read.file.rules[2]), "Stop(false) at least 2 seconds after Go(MAX, _)");
}

/// Files of the published dialects keep their meaning, so `in` may be a measure.
TEST(SleecReader, KnowsAMeasureWithTheNameIn) {
    const Read read(
        "def_start event Go event Stop measure in : boolean def_end rule_start R1 when Go then Stop unless in\n"
        "R2 when Stop and in then Go rule_end");
    ASSERT_TRUE(read.diagnostics.ok()) << read.report();
    ASSERT_EQ(read.file.rules.size(), 2U);
    EXPECT_EQ(read.file.rules[0].response->defeaters[0].condition->op, Op::name);
}

struct Mistake {
    const char* text;  ///< text of a rule, or of a whole file if it starts with "def_start" or "rule_start"
    const char* note;
};

const Mistake mistakes[] = {
    {"R: when Go then Stop", "directly follows the name of a rule"},
    {"rule R when Go then Stop", "without a keyword"},
    {"R when Go then Stop in 20 seconds", "`within 5 seconds`"},
    {"R when Go then Stop after 20 seconds", "`within 5 seconds`"},
    {"R when Go then Stop until Alarm", "`within 5 seconds`"},
    {"R when Go then Stop within 20 sec", "with the unit in full"},
    {"R when Go then Stop except near then Alarm", "`unless CONDITION"},
    {"R when Go then Stop unless if (near) then Alarm", "`unless CONDITION"},
    {"R when Go then never Stop within 2 seconds", "`not EVENT within 5 seconds` forbids"},
    {"R when Go then robot shall Stop", "a response is an event"},
    {"R when Go then robot must Stop", "a response is an event"},
    {"R when Go then robot should Stop", "a response is an event"},
    {"R if Go then Stop", "has the form `R1 when"},
    {"R when Go -> Stop", "has the form `R1 when"},
    {"when Go then Stop", "begins with a name"},
    {"R when Go then Stop unless Gone(1)", "declare it with `event NAME`"},
    {"R when Go then Stop and Alarm", "requires one event"},
    {"R when Go then Stop or Alarm", "requires one event"},
    {"R when Go or near then Stop", "begins with one event"},
    {"R when Go > 3 then Stop", "is an argument: `goTo(3)`"},
    {"R when Go < 3 then Stop", "is an argument: `goTo(3)`"},
    {"R when Go = 3 then Stop", "is an argument: `goTo(3)`"},
    {"R when Go and level == 3 then Stop", "`=` compares values"},
    {"def_start measure m : bool def_end", "`boolean`"},
    {"def_start measure m : int def_end", "`numeric`"},
    {"def_start measure m : integer def_end", "`numeric`"},
    {"def_start measure m : real def_end", "`numeric`"},
    {"def_start measure m : float def_end", "`numeric`"},
    {"def_start measure m : {low, high} def_end", "`scale(low, high)`"},
    {"def_start measure m : scale(low high) def_end", "separate levels with commas"},
    {"def_start constant C : 5 def_end", "`constant NAME = 5`"},
    {"def_start const C = 5 def_end", "`constant NAME = 5`"},
    {"def_start event A, B def_end", "define each event separately"},
    {"def_start event goTo(1) def_end", "rules give its arguments: `goTo(1)`"},
    {"def_start -- words\nevent A def_end", "begins with `//`"},
    {"def_start event Low-Battery def_end", "letters, digits and `_`"},
    {"rule_start R when Go then Stop rule_end", "`def_start ... def_end`"},
    {"R when Go && near then Stop", "join conditions with `and`"},
    {"R when Go and near || safe then Stop", "join conditions with `or`"},
    {"R when Go and !near then Stop", "`not` negates a condition"},
    {"R when Go then Stop;", "need no terminator"},
    {"# words\nR when Go then Stop", "begins with `//`"},
};

TEST(SleecReader, SaysWhatIsProbablyMeant) {
    std::set<std::string> given;
    for (const Mistake& mistake : mistakes) {
        const std::string text = mistake.text;
        const Read read(text.starts_with("def_") || text.starts_with("rule_") ? text : with_definitions(text));
        EXPECT_NE(read.report().find(mistake.note), std::string::npos) << text << "\n" << read.report();
        for (const diagnostics::Diagnostic& finding : read.diagnostics.sorted_findings())
            for (const diagnostics::Note& note : finding.notes) given.insert(note.message);
    }
    for (const diagnostics::Advice& row : syntax_advice()) {
        EXPECT_TRUE(given.contains(std::string(row.advice))) << row.words;
        EXPECT_FALSE(row.advice.ends_with('.')) << row.advice;
    }
}

}  // namespace
}  // namespace robochart::sleec
