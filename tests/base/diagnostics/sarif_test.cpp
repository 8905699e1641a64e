// SPDX-License-Identifier: Apache-2.0
// Tests that SARIF output has the structure that the 2.1.0 schema requires. The expectations were derived from the
// schema by hand.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "base/diagnostics/render.hpp"
#include "base/diagnostics/sarif.hpp"

namespace robochart::diagnostics {
namespace {

using nlohmann::json;

const Rule wrong{"R1", Severity::error, "`{}` is wrong"};
const Rule wrong_too{"R1", Severity::error, "`{}` is wrong, too"};
const Rule odd{"R2", Severity::warning, "odd"};

void expect_keys(const json& object, const std::set<std::string>& allowed, const std::set<std::string>& required) {
    ASSERT_TRUE(object.is_object());
    for (const auto& [key, value] : object.items()) EXPECT_TRUE(allowed.contains(key)) << key;
    for (const std::string& key : required) EXPECT_TRUE(object.contains(key)) << key;
}

/// Checks a region: lines and columns start at 1, and the end is not before the start (3.30).
void expect_region(const json& region) {
    expect_keys(region, {"startLine", "startColumn", "endLine", "endColumn"}, {"startLine"});
    EXPECT_GE(region.at("startLine").get<int>(), 1);
    EXPECT_GE(region.at("startColumn").get<int>(), 1);
    EXPECT_GE(std::pair(region.at("endLine").get<int>(), region.at("endColumn").get<int>()),
              std::pair(region.at("startLine").get<int>(), region.at("startColumn").get<int>()));
}

void expect_place(const json& place) {
    expect_keys(place, {"artifactLocation", "region"}, {"artifactLocation", "region"});
    const std::string uri = place.at("artifactLocation").at("uri");
    EXPECT_EQ(uri.find_first_of(" \"<>\\^`{|}"), std::string::npos) << uri;
    expect_region(place.at("region"));
}

void expect_result(const json& result, const json& rules) {
    expect_keys(
        result,
        {"ruleId", "ruleIndex", "level", "message", "locations", "relatedLocations", "fixes", "partialFingerprints"},
        {"message", "locations", "partialFingerprints"});
    EXPECT_TRUE(result.at("message").at("text").is_string());
    EXPECT_TRUE((std::set<std::string>{"none", "note", "warning", "error"}.contains(result.at("level"))));
    EXPECT_EQ(rules.at(result.at("ruleIndex").get<std::size_t>()).at("id"), result.at("ruleId"));
    for (const json& location : result.value("locations", json::array())) expect_place(location.at("physicalLocation"));
    std::set<int> ids;
    for (const json& location : result.value("relatedLocations", json::array())) {
        EXPECT_TRUE(ids.insert(location.at("id").get<int>()).second);
        expect_place(location.at("physicalLocation"));
        EXPECT_TRUE(location.at("message").at("text").is_string());
    }
    for (const json& fix : result.value("fixes", json::array())) {
        expect_keys(fix, {"description", "artifactChanges"}, {"artifactChanges"});
        for (const json& change : fix.at("artifactChanges")) {
            EXPECT_TRUE(change.at("artifactLocation").at("uri").is_string());
            ASSERT_GE(change.at("replacements").size(), 1U);
            for (const json& replacement : change.at("replacements")) {
                expect_region(replacement.at("deletedRegion"));
                EXPECT_TRUE(replacement.at("insertedContent").at("text").is_string());
            }
        }
    }
}

json expect_sarif(const std::string& text) {
    const json log = json::parse(text);
    expect_keys(log, {"$schema", "version", "runs"}, {"version", "runs"});
    EXPECT_EQ(log.at("version"), "2.1.0");
    EXPECT_EQ(log.at("runs").size(), 1U);
    const json& run = log.at("runs").at(0);
    expect_keys(run, {"tool", "columnKind", "results", "properties", "automationDetails", "invocations"},
                {"tool", "automationDetails"});
    EXPECT_EQ(run.at("columnKind"), "unicodeCodePoints");
    const json& driver = run.at("tool").at("driver");
    EXPECT_EQ(driver.at("name"), "robochart-verify");
    std::set<std::string> ids;
    for (const json& rule : driver.at("rules")) {
        expect_keys(rule, {"id", "name", "shortDescription", "fullDescription", "help", "defaultConfiguration"},
                    {"id", "name", "shortDescription", "fullDescription"});
        EXPECT_TRUE(ids.insert(rule.at("id")).second) << "a rule stands twice";
        EXPECT_FALSE(rule.at("help").at("text").get<std::string>().empty());
    }
    for (const json& result : run.at("results")) expect_result(result, driver.at("rules"));
    return run;
}

/// Returns rules with titles that differ from their messages, as in the verb `validate`.
SarifRules about(const std::string& limit = "") {
    return {"1.2", "validate/m.rct",
            [](const Rule& rule) { return rule.code == "R1" ? "a name is wrong" : "something is odd"; },
            [](const Rule&) { return "because of the rule"; }, limit};
}

TEST(Sarif, HasRulesPlacesNotesAndFixes) {
    SourceManager sources;
    const SourceId id = sources.add("a folder/m.rct", "\xC3\xA9\xC3\xA9 x\ntwo\n");
    Diagnostics out;
    Diagnostic& first = out.report(wrong, {id, 5, 6}, {"x"});
    first.notes.push_back({{id, 7, 10}, "declared here"});
    first.notes.push_back({{}, "without a place"});
    first.fixes.push_back({{id, 5, 6}, "y\"", "write"});
    out.report(wrong_too, {id, 7, 10}, {"two"});
    out.report(odd, {});
    const json run = expect_sarif(render_sarif(sources, out, about()));
    ASSERT_EQ(run.at("results").size(), 2U);
    ASSERT_EQ(run.at("tool").at("driver").at("rules").size(), 1U);
    const json& rule = run.at("tool").at("driver").at("rules").at(0);
    EXPECT_EQ(rule.at("name"), "ANameIsWrong");
    EXPECT_EQ(rule.at("shortDescription").at("text"), "A name is wrong.");
    EXPECT_EQ(rule.at("fullDescription").at("text"), "Because of the rule.");
    EXPECT_EQ(run.at("automationDetails").at("id"), "validate/m.rct/");
    // A finding without a place is not a result.
    const json& invocation = run.at("invocations").at(0);
    EXPECT_EQ(invocation.at("executionSuccessful"), true) << "it is a warning";
    EXPECT_EQ(invocation.at("toolExecutionNotifications").at(0).at("descriptor").at("id"), "R2");
    const json& result = run.at("results").at(0);
    EXPECT_EQ(result.at("ruleId"), "R1");
    EXPECT_EQ(result.at("message").at("text"), "`x` is wrong; without a place");
    const json& place = result.at("locations").at(0).at("physicalLocation");
    EXPECT_EQ(place.at("artifactLocation"), (json{{"uri", "a%20folder/m.rct"}, {"uriBaseId", "%SRCROOT%"}}));
    EXPECT_EQ(place.at("region"), (json{{"startLine", 1}, {"startColumn", 4}, {"endLine", 1}, {"endColumn", 5}}));
    EXPECT_EQ(result.at("relatedLocations").size(), 1U);
    EXPECT_EQ(
        result.at("fixes").at(0).at("artifactChanges").at(0).at("replacements").at(0).at("insertedContent").at("text"),
        "y\"");
    EXPECT_EQ(run.at("properties").at("errors"), 2);
}

TEST(Sarif, WithoutFindingsIsARunToo) {
    const json run = expect_sarif(render_sarif(SourceManager{}, Diagnostics{}, about()));
    EXPECT_TRUE(run.at("results").empty());
}

// SARIF 2.1.0, 3.20: an interrupted run must report that its results are incomplete.
TEST(Sarif, OfARunThatWasCutShortSaysSo) {
    const json run = json::parse(render_sarif({}, {}, about("the time limit was reached"))).at("runs").at(0);
    const json& invocation = run.at("invocations").at(0);
    EXPECT_EQ(invocation.at("executionSuccessful"), false);
    EXPECT_EQ(invocation.at("toolExecutionNotifications").at(0).at("message").at("text"), "the time limit was reached");
    EXPECT_FALSE(json::parse(render_sarif({}, {}, about())).at("runs").at(0).contains("invocations"));
}

TEST(Sarif, AFileThatCannotBeReadIsNoResult) {
    Diagnostics out;
    out.report(wrong, {}, {"x"});
    const json run = expect_sarif(render_sarif({}, out, about()));
    EXPECT_TRUE(run.at("results").empty());
    EXPECT_EQ(run.at("invocations").at(0).at("executionSuccessful"), false);
    EXPECT_EQ(run.at("invocations").at(0).at("toolExecutionNotifications").at(0).at("message").at("text"),
              "`x` is wrong");
}

// Services use the fingerprint to recognise findings of earlier runs.
TEST(Sarif, AFingerprintStaysWhereLinesAreAddedAbove) {
    const auto fingerprint = [](const std::string& above, std::uint32_t begin) {
        SourceManager sources;
        const SourceId id = sources.add("m.rct", above + "  state A\nstate B\n");
        Diagnostics out;
        out.report(wrong, {id, begin, begin + 1}, {"A"});
        return json::parse(render_sarif(sources, out, about()))
            .at("runs")
            .at(0)
            .at("results")
            .at(0)
            .at("partialFingerprints");
    };
    EXPECT_EQ(fingerprint("", 8), fingerprint("// more\n", 16));
    EXPECT_NE(fingerprint("", 8), fingerprint("", 16)) << "another line";
}

TEST(Sarif, PathsBelowTheCurrentFolderAreRelative) {
    const std::string here = std::filesystem::current_path().string();
    EXPECT_EQ(sarif_file(here + "/a/../m.rct"), (Json{{"uri", "m.rct"}, {"uriBaseId", "%SRCROOT%"}}));
    EXPECT_EQ(sarif_file("./m.rct"), (Json{{"uri", "m.rct"}, {"uriBaseId", "%SRCROOT%"}}));
    EXPECT_EQ(sarif_file("/elsewhere/m.rct"), (Json{{"uri", "file:///elsewhere/m.rct"}}));
}

TEST(Sarif, SurvivesWhatIsNotText) {
    SourceManager sources;
    const SourceId id = sources.add("/x\xFF y.rct", "\xED\xA0\x80\x01");
    Diagnostics out;
    out.report(wrong, {id, 0, 4}, {"\xFF\"\x01"});
    const json run = expect_sarif(render_sarif(sources, out, about()));
    EXPECT_EQ(run.at("results").at(0).at("locations").at(0).at("physicalLocation").at("artifactLocation").at("uri"),
              "file:///x%FF%20y.rct");
}

}  // namespace
}  // namespace robochart::diagnostics
