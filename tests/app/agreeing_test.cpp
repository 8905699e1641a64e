// Small adversarial models, a construct or two each, with verdicts that were derived by hand from the rules of the
// semantics: those of tests/app/agreeing, and the collection beside the repository where it is at hand. The verdicts
// are as they stand in the tables, and the generated code of each conforms; where a model cannot be run in cycles it
// may, in another relation, conform or have its reason, and its code never differs.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "tests/app/command.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::app::testing {
namespace {

namespace fs = std::filesystem;

struct Row {
    std::string model;
    std::string verdicts;   ///< `T1:H F1:F`, in the order of the report; "" if there are no assertions
    bool conforms = false;  ///< in every relation
};

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> result;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, '\t');) result.push_back(cell);
    return result;
}

std::string trimmed(std::string text) {
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

/// Our table: model, verdicts, `conforms`.
std::vector<Row> own_rows(const fs::path& folder) {
    std::vector<Row> rows;
    std::ifstream table(folder / "EXPECTED.tsv");
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line))
        if (const auto row = cells(line); row.size() == 3) rows.push_back({row[0], row[1], row[2] == "conforms"});
    return rows;
}

/// That of the collection: model, exit of `check`, verdicts, exit of `conform` when the table was made.
std::vector<Row> collected_rows(const fs::path& folder) {
    std::vector<Row> rows;
    std::ifstream table(folder / "EXPECTED.tsv");
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line))
        if (const auto row = cells(line); row.size() == 4)
            rows.push_back({row[0], row[2] == "-" ? "" : trimmed(row[2]), row[3] == "0"});
    return rows;
}

nlohmann::json report(const std::vector<std::string>& arguments) {
    const Ran ran = run(arguments);
    nlohmann::json report = nlohmann::json::parse(ran.out, nullptr, false);
    if (report.is_discarded()) report = nlohmann::json::object();
    report["words"] = ran.err;
    return report;
}

std::string verdicts(const fs::path& model) {
    const nlohmann::json found = report({"check", model.string(), "--format", "json", "--timeout", "60"});
    if (!found.contains("assertions")) return found["words"];
    std::string text;
    for (const auto& assertion : found["assertions"]) {
        const std::string title = assertion["title"];
        const std::string answer = assertion["answer"];
        const std::string letter = answer == "holds" ? "H" : answer == "fails" ? "F" : answer;
        text += (text.empty() ? "" : " ") + title.substr(0, title.find(' ')) + ":" + letter;
    }
    return text;
}

/// What `conform` says of the components, each once.
std::string conformance(const fs::path& model) {
    const nlohmann::json found = report({"conform", model.string(), "--format", "json", "--timeout", "60"});
    if (!found.contains("conformance")) return found["words"];
    std::string text;
    for (const auto& component : found["conformance"]) {
        const std::string outcome = component["outcome"];
        if (text.find(outcome) == std::string::npos) text += (text.empty() ? "" : ", ") + outcome;
    }
    return text;
}

void expect_agreement(const fs::path& folder, const std::vector<Row>& rows) {
    for (const Row& row : rows) {
        const fs::path model = folder / row.model;
        if (!row.verdicts.empty()) {
            EXPECT_EQ(verdicts(model), row.verdicts) << row.model;
        }
        const std::string outcome = conformance(model);
        // Two controllers hand a token round through buffers and make an output each time, without time passing. Where
        // each output is made once a cycle the second one waits; as a sequence the outputs have no end.
        const bool endless = row.model == "m05_async_cycle";
        if (row.conforms) {
            EXPECT_EQ(outcome, endless ? "not schedulable" : "conforms") << row.model;
        }
        EXPECT_EQ(outcome.find("differs"), std::string::npos) << row.model << ": " << outcome;
        EXPECT_NE(outcome, "") << row.model;
    }
}

TEST(Agreeing, VerdictsByHand) {
    const fs::path folder = repository("tests/app/agreeing");
    const std::vector<Row> rows = own_rows(folder);
    EXPECT_GE(rows.size(), 26U);
    std::size_t folders = 0;
    for (const auto& entry : fs::directory_iterator(folder)) folders += entry.is_directory() ? 1U : 0U;
    EXPECT_EQ(rows.size(), folders);
    expect_agreement(folder, rows);
}

TEST(Agreeing, VerdictsOfTheCollection) {
    const fs::path shared = tests::shared_folder();
    if (shared.empty()) GTEST_SKIP() << "no shared/ beside the repository, ROBOCHART_SHARED not set";
    const fs::path folder = shared / "suite/findings/agreeing";
    const std::vector<Row> rows = collected_rows(folder);
    ASSERT_EQ(rows.size(), 97U);
    expect_agreement(folder, rows);
}

}  // namespace
}  // namespace robochart::app::testing
