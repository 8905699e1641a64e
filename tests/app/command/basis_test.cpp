// What a verdict rests on stands with it in every format, also where the claim holds and little is printed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/report/report.hpp"

namespace robochart::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Report report_of(Answer answer, Basis basis) {
    AssertionReport claim;
    claim.title = "Calm [untimed] Pump is deadlock-free";
    claim.answer = answer;
    claim.searched = true;
    claim.basis = std::move(basis);
    Report report;
    report.model = "pump.rct";
    report.assertions.push_back(std::move(claim));
    return report;
}

Ground guard(const std::string& name, std::uint32_t line) {
    Ground ground{GroundKind::guard,
                  "the condition of `" + name + "` is taken for true",
                  "Pump::" + name,
                  "pump.rct:" + std::to_string(line),
                  runs::Place{"pump.rct", line, 3, line, 9},
                  "write `timed assertion`"};
    return ground;
}

std::string text_of(const Report& report, bool quiet) {
    Options options;
    options.quiet = quiet;
    return render_text(report, options);
}

TEST(Basis, StandsWithTheVerdictInEveryFormat) {
    for (const Answer answer : {Answer::holds, Answer::fails, Answer::inconclusive}) {
        const Report report = report_of(answer, {guard("late", 7)});
        const char* const said = "the condition of `late` is taken for true";
        for (const bool quiet : {false, true})
            EXPECT_THAT(text_of(report, quiet), HasSubstr("rests on: the condition of `late` is taken for true "
                                                          "(pump.rct:7)\n               write `timed assertion`"));
        EXPECT_THAT(render_junit(report), HasSubstr(said));
        const auto json = nlohmann::json::parse(render_json(report));
        EXPECT_EQ(json["assertions"][0]["basis"], nlohmann::json::parse(R"([{"kind": "guard",
            "text": "the condition of `late` is taken for true", "element": "Pump::late", "place": "pump.rct:7",
            "remedy": "write `timed assertion`"}])"));
        const auto result = nlohmann::json::parse(render_sarif(report))["runs"][0]["results"][0];
        EXPECT_THAT(result["message"]["text"], HasSubstr(said));
        EXPECT_THAT(result["message"]["text"], HasSubstr("write `timed assertion`"));
        EXPECT_EQ(result["relatedLocations"][0]["physicalLocation"]["region"]["startLine"], 7);
        if (answer == Answer::holds) {
            EXPECT_EQ(result["kind"], "informational");
            EXPECT_EQ(result["level"], "none");
        }
    }
}

TEST(Basis, IsNotMentionedWhereAVerdictRestsOnTheModelAlone) {
    const Report report = report_of(Answer::holds, {});
    EXPECT_THAT(text_of(report, false), Not(HasSubstr("rests on")));
    EXPECT_THAT(text_of(report, true), Not(HasSubstr("Calm")));
    EXPECT_THAT(render_junit(report), Not(HasSubstr("system-out")));
    EXPECT_FALSE(nlohmann::json::parse(render_json(report))["assertions"][0].contains("basis"));
    EXPECT_TRUE(nlohmann::json::parse(render_sarif(report))["runs"][0]["results"].empty());
}

TEST(Basis, LinesNameAFewOfAKindAndEachRemedyOnce) {
    Basis basis;
    for (std::uint32_t line = 1; line <= 5; ++line) add(basis, guard("t" + std::to_string(line), line));
    add(basis, guard("t2", 2));
    EXPECT_EQ(basis.size(), 5U);
    add(basis, {GroundKind::never_asked, "no run does `halt`", {}, {}, {}, {}});
    EXPECT_EQ(basis_lines(basis, 2),
              (std::vector<std::string>{"rests on: the condition of `t1` is taken for true (pump.rct:1)",
                                        "rests on: the condition of `t2` is taken for true (pump.rct:2)",
                                        "and on 3 more of this kind", "write `timed assertion`",
                                        "rests on: no run does `halt`"}));
}

TEST(Basis, TextOfOthersIsEscaped) {
    Ground ground = guard("late", 7);
    ground.text = "<script>\x1b[31m";
    const Report report = report_of(Answer::holds, {ground});
    EXPECT_THAT(render_junit(report), Not(HasSubstr("<script>")));
    EXPECT_THAT(text_of(report, false), Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace robochart::app
