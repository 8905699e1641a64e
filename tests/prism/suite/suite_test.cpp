// SPDX-License-Identifier: Apache-2.0
// Tests expectations that were computed by hand (suite/prism/prism-tests), and values of the Quantitative Verification
// Benchmark Set (suite/prism/qvbs). Each is checked with enclosures, and with fractions if the model is small. The test
// is skipped if the material is absent.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "prism/session/experiment.hpp"
#include "tests/contents.hpp"
#include "tests/needed.hpp"
#include "tests/prism/support.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::prism {
namespace {

namespace fs = std::filesystem;
using testing::Explored;
using Row = std::map<std::string, std::string>;
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> cells(1);
    for (const char c : text)
        if (c == separator)
            cells.emplace_back();
        else
            cells.back() += c;
    return cells;
}

std::vector<Row> read_table(const fs::path& path) {
    std::vector<Row> rows;
    std::ifstream lines(path);
    std::string line;
    std::getline(lines, line);
    const std::vector<std::string> names = split(line, '\t');
    while (std::getline(lines, line)) {
        const std::vector<std::string> cells = split(line, '\t');
        Row& row = rows.emplace_back();
        for (std::size_t i = 0; i < names.size() && i < cells.size(); ++i) row[names[i]] = cells[i];
    }
    return rows;
}

/// Parses values in the notation of --const.
Values values(const std::string& text, const std::string& model) {
    testing::Read read;
    const ModelFile file = read_model(read.sources, read.add(model), read.diagnostics);
    return text.empty() ? Values{} : combinations(read_series(text, open_constants(file.constants))).front();
}

Explored explored(const fs::path& folder, const Row& row, const std::string& constants) {
    const std::string model = tests::read_contents(folder / row.at("model"));
    return Explored(model, values(constants, model));
}

/// Returns whether the enclosure contains the value and is narrow.
bool is_enclosed(const Real& found, double expected) {
    const Enclosure bounds = found.bounds();
    if (std::isinf(expected)) return bounds.low == expected;
    const double slack = 1e-15 * std::abs(expected);  // the table's values are rounded
    return bounds.low <= expected + slack && expected - slack <= bounds.high &&
           bounds.high - bounds.low <= 1e-6 * std::max(std::abs(expected), 1e-300);
}

double parse_number(const std::string& text) {
    return text == "Infinity" || text == "∞" ? infinity : std::stod(text);
}

bool as_wanted(const Result& found, const std::string& expected) {
    using Kind = Result::Kind;
    if (expected == "true" || expected == "false")
        return found.kind == Kind::truth && found.truth == (expected == "true");
    if (expected.front() == '[') {
        const std::vector<std::string> ends = split(expected.substr(1, expected.size() - 2), ',');
        return found.kind == Kind::range && is_enclosed(found.low, parse_number(ends[0])) &&
               is_enclosed(found.high, parse_number(ends[1]));
    }
    return found.kind == Kind::number && is_enclosed(found.low, parse_number(expected));
}

/// Returns the first difference from the row, or "" if there is none.
std::string find_difference(const fs::path& folder, const Row& row, bool exact) {
    const std::string& expected = row.at("result");
    const std::string& expression = row.at("expression");
    std::string found;
    const std::string failed = testing::failure_text([&] {
        Explored model = explored(folder, row, row.at("constants"));
        if (expression == "states") {
            found = std::to_string(model.space->chain().states());
            return;
        }
        const Result result = model.ask(expression, {1e-6, exact, nullptr});
        found = as_wanted(result, expected) ? expected : "another value: " + result.low.text() + " " + result.reason;
    });
    if (expected == "error") return failed.find("error[PRISM-") == std::string::npos ? "is not refused" : "";
    return found == expected ? "" : failed + found;
}

TEST(PrismSuite, HandMadeExpectations) {
    const fs::path shared = tests::shared_folder();
    ROBOCHART_NEEDS(!shared.empty(), "../shared");
    const fs::path folder = shared / "suite/prism/prism-tests";
    const std::vector<Row> rows = read_table(folder / "EXPECTED.tsv");
    EXPECT_EQ(rows.size(), 92U);
    for (const Row& row : rows)
        for (const bool exact : {false, true})
            EXPECT_EQ(find_difference(folder, row, exact), "")
                << row.at("model") << " " << row.at("constants") << ": " << row.at("expression") << ", wanted "
                << row.at("result") << (exact ? " (exact)" : "");
}

/// Returns the reason why this test skips a row of the benchmark set, or "" if it runs the row.
std::string left_out(const Row& row) {
    if (row.at("dialect") == "storm") return "asks for reward-bounded paths, which PRISM's language does not have";
    if (row.at("model") == "mdp/rabin/rabin.5.prism")
        return "its states are counted up to the target; the whole state space is far larger";
    if (std::stoul(row.at("states")) > 100'000) return "takes longer than a test should";
    return "";
}

/// Returns true for counts in the table that do not follow from the definition.
bool known_departure(const Row& row, const std::string& column) {
    // A philosopher's step changes one of three equal parts of a ring. Coin flips are the only choices with two
    // branches, so each philosopher has the same number of them, and their total must be divisible by 3. 3696 - 3342 =
    // 354 is divisible by 3, but 3696 - 3271 = 425 is not. Like PRISM, the table counts the branches of equal choices
    // each time, but the choices only once.
    return row.at("model") == "mdp/philosophers-mdp/philosophers-mdp.3.prism" && column == "choices";
}

void expect_counts(const Row& row, const StateSpace& space) {
    const std::pair<const char*, std::uint64_t> counts[] = {{"states_full", space.chain().states()},
                                                            {"choices", space.chain().choices()},
                                                            {"transitions", space.transitions()},
                                                            {"deadlocks", space.deadlock_count()}};
    for (const auto& [column, count] : counts)
        if (!row.at(column).empty() && !known_departure(row, column)) {
            EXPECT_EQ(row.at(column), std::to_string(count)) << row.at("id") << ": " << column;
        }
}

/// Returns the fraction of the row, from EXACT.tsv if it is long.
std::string fraction(const Row& row, const std::vector<Row>& long_ones) {
    const std::string& text = row.at("exact");
    if (text.find("EXACT") == std::string::npos) return text;
    for (const Row& candidate : long_ones)
        if (candidate.begin() != candidate.end() && candidate.count("id") != 0 && candidate.at("id") == row.at("id"))
            return candidate.count("exact") != 0 ? candidate.at("exact") : "";
    return "";
}

TEST(PrismSuite, BenchmarkSet) {
    const fs::path shared = tests::shared_folder();
    ROBOCHART_NEEDS(!shared.empty(), "../shared");
    const fs::path folder = shared / "suite/prism/qvbs";
    const std::vector<Row> exact_values = read_table(folder / "EXACT.tsv");
    std::map<std::pair<std::string, std::string>, std::vector<Row>> models;
    std::map<std::string, std::size_t> reasons;
    std::size_t run = 0;
    std::size_t exact_run = 0;
    for (const Row& row : read_table(folder / "EXPECTED.tsv"))
        if (const std::string reason = left_out(row); !reason.empty())
            ++reasons[reason];
        else
            models[{row.at("model"), row.at("constants")}].push_back(row);
    for (const auto& [key, rows] : models) {
        // The constant B belongs to properties that this test skips.
        const std::string constants = key.second.substr(0, key.second.find(",B="));
        Explored model = explored(folder, rows.front(), constants);
        expect_counts(rows.front(), *model.space);
        for (const Row& row : rows) {
            ++run;
            const Result result = model.ask(row.at("expression"));
            EXPECT_TRUE(as_wanted(result, row.at("value")))
                << row.at("id") << ": " << result.low.text() << " " << result.reason << ", wanted " << row.at("value");
            const std::string expected = row.at("kind") == "exact" ? fraction(row, exact_values) : "";
            const bool dense = row.at("model").find("herman") != std::string::npos;  // fractions take minutes
            if (expected.empty() || model.space->chain().states() > (dense ? 100 : 3000)) continue;
            ++exact_run;
            const Result exact = model.ask(row.at("expression"), {1e-6, true, nullptr});
            ASSERT_EQ(exact.kind, Result::Kind::number) << row.at("id");
            const std::size_t slash = expected.find('/');
            if (expected == "∞") {
                EXPECT_EQ(exact.low.bounds().low, infinity) << row.at("id");
            } else {
                const Rational value =
                    slash == std::string::npos
                        ? decimal(expected)
                        : Rational(decimal(expected.substr(0, slash)) / decimal(expected.substr(slash + 1)));
                EXPECT_TRUE(exact.low.is_exact() && exact.low.value() == value) << row.at("id");
            }
        }
    }
    std::size_t out = 0;
    for (const auto& [reason, count] : reasons) {
        std::cout << count << " rows left out: " << reason << "\n";
        out += count;
    }
    EXPECT_EQ(run + out, 172U);
    EXPECT_GE(run, 130U);
    EXPECT_GE(exact_run, 60U);
}

/// RoboTool's model of a robot next to people has half a million states. The counts are those of PRISM. The values come
/// from an independent computation, for one of the six sets of constants (the others have up to 2.3 million states).
TEST(PrismSuite, AModelOfRoboTool) {
    const fs::path shared = tests::shared_folder();
    ROBOCHART_NEEDS(!shared.empty(), "../shared");
    const fs::path folder = shared / "suite/prism/uvc";
    const std::string text = tests::read_contents(folder / "prism-gen/system.prism");
    std::optional<Explored> model;
    std::size_t rows = 0;
    for (const Row& row : read_table(folder / "EXPECTED.tsv")) {
        if (row.at("constant_set") != "C20_noOds_delibrate") continue;
        if (!model) model.emplace(text, values(row.at("constants"), text));
        EXPECT_EQ(std::to_string(model->space->chain().states()), row.at("states"));
        EXPECT_EQ(std::to_string(model->space->transitions()), row.at("transitions"));
        const Values step{{"t", {Type::integer, std::stoi(row.at("t")), {}}}};
        const Result result = model->ask(
            "const int t; P=? [ F shuman=SHuman_inRed & srobot=SRobot_transitionRow & modUVC_ctrlUVC_stm_ref3_ticks=t "
            "]",
            {1e-11, false, nullptr}, step);
        const double reference = std::stod(row.at("reference"));
        const Enclosure bounds = result.low.bounds();
        EXPECT_LE(bounds.low, reference * (1 + 1e-12)) << row.at("t");
        EXPECT_GE(bounds.high, reference * (1 - 1e-12)) << row.at("t");
        EXPECT_LE(bounds.high - bounds.low, 1e-10 * reference) << row.at("t");
        ++rows;
    }
    EXPECT_EQ(rows, 19U);
}

}  // namespace
}  // namespace robochart::prism
