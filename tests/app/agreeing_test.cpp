// SPDX-License-Identifier: Apache-2.0
// Compares verdicts about small adversarial models with tables. Each model uses one or two constructs. The models are
// in tests/app/agreeing and, if it is present, in the collection next to the repository. Their verdicts were derived by
// hand from the rules of the semantics. The test also checks that the generated code conforms. For a model that cannot
// run in cycles, `conform` may report the reason or conformance in another relation, but never a difference.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "tests/app/command.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::app::testing::agreeing_test {
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

/// Reads the project's own table: model, verdicts, `conforms`.
std::vector<Row> own_rows(const fs::path& folder) {
    std::vector<Row> rows;
    std::ifstream table(folder / "EXPECTED.tsv");
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line))
        if (const auto row = cells(line); row.size() == 3) rows.push_back({row[0], row[1], row[2] == "conforms"});
    return rows;
}

/// Reads the table of the collection: model, exit code of `check`, verdicts, and the exit code of `conform` when the
/// table was made.
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

std::string short_answer(const std::string& answer) {
    if (answer == "holds") return "H";
    if (answer == "fails") return "F";
    return answer;
}

std::string verdicts(const fs::path& model) {
    const nlohmann::json found = report({"check", model.string(), "--format", "json", "--timeout", "60"});
    if (!found.contains("assertions")) return found["words"];
    std::string text;
    for (const auto& assertion : found["assertions"]) {
        const std::string title = assertion["title"];
        const std::string answer = short_answer(assertion["answer"]);
        text += (text.empty() ? "" : " ") + title.substr(0, title.find(' ')) + ":" + answer;
    }
    return text;
}

/// Returns the distinct outcomes that `conform` reports for the components.
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
        // Two controllers pass a token back and forth through buffers and make an output each time, without time
        // passing. If an output can be made only once a cycle, the second output waits for the next cycle. If outputs
        // are a sequence, the sequence is infinite.
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

/// Models of questions that users of other tools have asked. The verdicts follow from the rules of the semantics.
const std::vector<Row> models_of_questions{
    // An inner transition without a trigger and an outer transition with a trigger: either may come first. The
    // environment may refuse a call, and time waits for it.
    {"anon", "A:H B:H C:F D:F", false},
    // A value in a buffer may be read before the next value is written.
    {"bufs", "Old:F", false},
    // The module terminates only when both machines have terminated, which may never happen.
    {"fin", "T:H N:F", false},
    // A machine that waits for a local event is not stuck. A module in which another machine can proceed is not stuck
    // either.
    {"local", "WholeFree:H PartFree:H", false},
    // The counter reaches 0, which makes the other guard true.
    {"loop", "K:F D:H T:F", false},
    // Exit actions run from the inside out, then the action of the transition, then entry actions from the outside in.
    {"order", "A:H B:H C:H", false},
    // If an inner and an outer state have transitions with the same event, either transition may be taken.
    {"prio", "R1:F R2:F D:F", false},
    // Events of two machines may reach the third machine in either order.
    {"raise", "R:F D:H V:H", false},
    // A clock that is reset at entry equals the time since entry. In a timed claim, termination is not a deadlock. Time
    // may pass before the machine terminates, but the CSP block does not allow that.
    {"timer2", "X:H Y:H Z:F", false},
};

TEST(Agreeing, VerdictsOnQuestions) {
    const fs::path shared = tests::shared_folder();
    if (shared.empty()) GTEST_SKIP() << "no shared/ beside the repository, ROBOCHART_SHARED not set";
    for (const Row& row : models_of_questions)
        EXPECT_EQ(verdicts(shared / "suite/findings3/right" / row.model), row.verdicts) << row.model;
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
}  // namespace robochart::app::testing::agreeing_test
