// SARIF: the structure that the 2.1.0 schema demands of what we write, checked by hand.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "diagnostics/render.hpp"

namespace robochart::diagnostics {
namespace {

using nlohmann::json;

const Rule wrong{"R1", Severity::error, "`{}` is wrong", "Because of the rule."};
const Rule wrong_too{"R1", Severity::error, "`{}` is wrong, too", "The same rule, other circumstances."};
const Rule odd{"R2", Severity::warning, "odd", "It may be meant."};

void expect_keys(const json& object, const std::set<std::string>& allowed, const std::set<std::string>& required) {
    ASSERT_TRUE(object.is_object());
    for (const auto& [key, value] : object.items()) EXPECT_TRUE(allowed.contains(key)) << key;
    for (const std::string& key : required) EXPECT_TRUE(object.contains(key)) << key;
}

/// region: lines and columns from 1, the end not before the begin (3.30).
void expect_region(const json& region) {
    expect_keys(region, {"startLine", "startColumn", "endLine", "endColumn"}, {"startLine"});
    EXPECT_GE(region.at("startLine").get<int>(), 1);
    EXPECT_GE(region.at("startColumn").get<int>(), 1);
    EXPECT_GE(std::pair(region.at("endLine").get<int>(), region.at("endColumn").get<int>()),
              std::pair(region.at("startLine").get<int>(), region.at("startColumn").get<int>()));
}

void expect_place(const json& place) {
    expect_keys(place, {"artifactLocation", "region"}, {"artifactLocation"});
    const std::string uri = place.at("artifactLocation").at("uri");
    EXPECT_EQ(uri.find_first_of(" \"<>\\^`{|}"), std::string::npos) << uri;
    expect_region(place.at("region"));
}

void expect_result(const json& result, const json& rules) {
    expect_keys(result, {"ruleId", "ruleIndex", "level", "message", "locations", "relatedLocations", "fixes"},
                {"message"});
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
    expect_keys(run, {"tool", "columnKind", "results", "properties"}, {"tool"});
    EXPECT_EQ(run.at("columnKind"), "unicodeCodePoints");
    const json& driver = run.at("tool").at("driver");
    EXPECT_EQ(driver.at("name"), "robochart-verify");
    std::set<std::string> ids;
    for (const json& rule : driver.at("rules")) {
        expect_keys(rule, {"id", "shortDescription", "help", "defaultConfiguration"}, {"id"});
        EXPECT_TRUE(ids.insert(rule.at("id")).second) << "a rule stands twice";
        EXPECT_FALSE(rule.at("help").at("text").get<std::string>().empty());
    }
    for (const json& result : run.at("results")) expect_result(result, driver.at("rules"));
    return run;
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
    const json run = expect_sarif(render_sarif(sources, out, "1.2"));
    ASSERT_EQ(run.at("results").size(), 3U);
    EXPECT_EQ(run.at("tool").at("driver").at("rules").size(), 2U);
    const json& result = run.at("results").at(0);
    EXPECT_EQ(result.at("ruleId"), "R1");
    EXPECT_EQ(result.at("message").at("text"), "`x` is wrong; without a place");
    const json& place = result.at("locations").at(0).at("physicalLocation");
    EXPECT_EQ(place.at("artifactLocation").at("uri"), "a%20folder/m.rct");
    EXPECT_EQ(place.at("region"), (json{{"startLine", 1}, {"startColumn", 4}, {"endLine", 1}, {"endColumn", 5}}));
    EXPECT_EQ(result.at("relatedLocations").size(), 1U);
    EXPECT_EQ(
        result.at("fixes").at(0).at("artifactChanges").at(0).at("replacements").at(0).at("insertedContent").at("text"),
        "y\"");
    EXPECT_EQ(run.at("properties").at("errors"), 2);
}

TEST(Sarif, WithoutFindingsIsARunToo) {
    const json run = expect_sarif(render_sarif(SourceManager{}, Diagnostics{}, "1"));
    EXPECT_TRUE(run.at("results").empty());
}

// SARIF 2.1.0, 3.20: of a run that was cut short the results are not all.
TEST(Sarif, OfARunThatWasCutShortSaysSo) {
    const json run = json::parse(render_sarif({}, {}, "1", "the time limit was reached")).at("runs").at(0);
    const json& invocation = run.at("invocations").at(0);
    EXPECT_EQ(invocation.at("executionSuccessful"), false);
    EXPECT_EQ(invocation.at("toolExecutionNotifications").at(0).at("message").at("text"), "the time limit was reached");
    EXPECT_FALSE(json::parse(render_sarif({}, {}, "1")).at("runs").at(0).contains("invocations"));
}

TEST(Sarif, SurvivesWhatIsNotText) {
    SourceManager sources;
    const SourceId id = sources.add("/x\xFF y.rct", "\xED\xA0\x80\x01");
    Diagnostics out;
    out.report(wrong, {id, 0, 4}, {"\xFF\"\x01"});
    const json run = expect_sarif(render_sarif(sources, out, "1"));
    EXPECT_EQ(run.at("results").at(0).at("locations").at(0).at("physicalLocation").at("artifactLocation").at("uri"),
              "file:///x%FF%20y.rct");
}

}  // namespace
}  // namespace robochart::diagnostics
