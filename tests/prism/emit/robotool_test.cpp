// SPDX-License-Identifier: Apache-2.0
// Compares the encoding with RoboTool's own files of two case studies, if they are present (../shared).
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/diagnostics/render.hpp"
#include "prism/emit/preferences.hpp"
#include "prism/syntax/reader.hpp"
#include "tests/contents.hpp"
#include "tests/prism/emit/models.hpp"
#include "tests/prism/emit/structure.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::prism_emit {
namespace {

namespace fs = std::filesystem;
using testing::Encoded;
using testing::Size;

fs::path suite_file(const std::string& name) {
    const fs::path shared = tests::shared_folder();
    return shared.empty() ? fs::path() : shared / "suite/prism" / name;
}

std::map<std::string, std::string> models_in(const fs::path& folder) {
    std::map<std::string, std::string> result;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".rct")
            result[entry.path().filename().string()] = tests::read_contents(entry.path());
    return result;
}

Preferences preferences_of(const fs::path& folder) {
    Preferences result;
    EXPECT_EQ(read_preferences(tests::read_contents(folder / "prism-gen/rc2prism.prefs"), result), "");
    return result;
}

prism::ModelFile read_model_file(const fs::path& path) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const auto source = sources.add(path.string(), tests::read_contents(path));
    prism::ModelFile model = prism::read_model(sources, source, diagnostics);
    EXPECT_TRUE(diagnostics.ok()) << diagnostics::render_text(sources, diagnostics);
    return model;
}

std::unique_ptr<Encoded> encode_uvc(const fs::path& folder) {
    return testing::encode_model(models_in(folder), preferences_of(folder));
}

std::string first_ones(const std::vector<std::string>& differences) {
    std::string result;
    for (std::size_t i = 0; i < differences.size() && i < 20; ++i) result += differences[i] + "\n";
    return result;
}

TEST(RoboTool, UvcIsItsModelUpToNamesAndOrder) {
    const fs::path folder = suite_file("uvc");
    if (!fs::exists(folder)) GTEST_SKIP() << "no case study at hand";
    const auto model = encode_uvc(folder);
    ASSERT_TRUE(model->emission) << model->report();
    const auto found =
        testing::find_differences(read_model_file(folder / "prism-gen/system.prism"), model->emission->model);
    EXPECT_TRUE(found.empty()) << first_ones(found);
}

TEST(RoboTool, AnyOtherCommandIsADifference) {
    const fs::path folder = suite_file("uvc");
    if (!fs::exists(folder)) GTEST_SKIP() << "no case study at hand";
    const prism::ModelFile model = read_model_file(folder / "prism-gen/system.prism");
    EXPECT_TRUE(testing::find_differences(model, model).empty());
    prism::ModelFile other = model;
    other.modules.front().commands.pop_back();
    EXPECT_FALSE(testing::find_differences(model, other).empty()) << "a command less";
    other = model;
    other.modules.front().commands.front().branches.front().assignments.pop_back();
    EXPECT_FALSE(testing::find_differences(model, other).empty()) << "an assignment less";
    other = model;
    other.modules.front().commands.front().action.text = "";
    EXPECT_FALSE(testing::find_differences(model, other).empty()) << "no label";
}

/// Defines the functions as RoboTool's assertions of this case study do (`defs D1`).
void define_functions(std::map<std::string, std::string>& files) {
    std::string& text = files.at("Declarations.rct");
    const auto replace = [&](const std::string& name, const std::string& definition) {
        const auto begin = text.find("function " + name);
        const auto body = text.find('{', begin);
        const auto end = text.find('}', begin);
        ASSERT_NE(begin, std::string::npos);
        text.replace(body, end - body + 1, "{ postcondition result == " + definition + " }");
    };
    replace("overLimitF", "(if x > 2 then 2 else x end) + 0");
    replace("underLimitF", "if x < 0 then 0 else x end");
}

TEST(RoboTool, HvcIsItsModelUpToNamesAndOrder) {
    const fs::path folder = suite_file("robotool/hvc");
    if (!fs::exists(folder)) GTEST_SKIP() << "no case study at hand";
    auto files = models_in(folder);
    define_functions(files);
    const auto model = testing::encode_model(files, preferences_of(folder));
    ASSERT_TRUE(model->emission) << model->report();
    const auto found =
        testing::find_differences(read_model_file(folder / "prism-gen/P4.prism"), model->emission->model);
    EXPECT_TRUE(found.empty()) << first_ones(found);
}

/// A row of EXPECTED.tsv. The test uses the first row of each set of constants that is small enough for a test.
struct Row {
    std::map<std::string, std::string> constants;
    Size size;
};

std::map<std::string, Row> expected_sizes(const fs::path& table) {
    std::map<std::string, Row> result;
    std::istringstream lines(tests::read_contents(table));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::istringstream cells(line);
        std::string set, t, constants, states, transitions;
        for (std::string* cell : {&set, &t, &constants, &states, &transitions}) std::getline(cells, *cell, '\t');
        Row row{{}, {std::stoul(states), std::stoul(transitions)}};
        std::istringstream values(constants);
        for (std::string value; std::getline(values, value, ',');)
            row.constants[value.substr(0, value.find('='))] = value.substr(value.find('=') + 1);
        if (row.size.states < 700'000) result.emplace(set, std::move(row));
    }
    return result;
}

TEST(RoboTool, UvcHasAsManyStatesAndTransitions) {
    const fs::path folder = suite_file("uvc");
    if (!fs::exists(folder)) GTEST_SKIP() << "no case study at hand";
    const auto model = encode_uvc(folder);
    ASSERT_TRUE(model->emission) << model->report();
    const auto rows = expected_sizes(folder / "EXPECTED.tsv");
    ASSERT_FALSE(rows.empty());
    for (const auto& [set, row] : rows) {
        const Size found = testing::size_of(*model, row.constants);
        EXPECT_EQ(found.states, row.size.states) << set;
        EXPECT_EQ(found.transitions, row.size.transitions) << set;
    }
}

/// The expected value is in EXPECTED.tsv, set C20_noOds_delibrate, t=5, column `reference`.
TEST(RoboTool, UvcHasTheSameProbability) {
    const fs::path folder = suite_file("uvc");
    if (!fs::exists(folder)) GTEST_SKIP() << "no case study at hand";
    const auto model = encode_uvc(folder);
    ASSERT_TRUE(model->emission) << model->report();
    const auto row = expected_sizes(folder / "EXPECTED.tsv").at("C20_noOds_delibrate");
    const double found = testing::value_of(
        *model, row.constants,
        "P=? [ F shuman=SHuman_inRed & srobot=SRobot_transitionRow & modUVC_ctrlUVC_stm_ref3_ticks=5 ]");
    EXPECT_NEAR(found, 0.18306942358089257, 1e-10 * 0.18306942358089257);
}

}  // namespace
}  // namespace robochart::prism_emit
