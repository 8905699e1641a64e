// SPDX-License-Identifier: Apache-2.0
// Parses published and other files of rules. The printed text of each must parse to the same tree. Randomly changed
// files are parsed or rejected.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "base/diagnostics/splitmix64.hpp"
#include "claims/sleec/syntax/printer.hpp"
#include "tests/claims/sleec/support.hpp"
#include "tests/claims/sleec/syntax/same_file.hpp"
#include "tests/contents.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::sleec {
namespace {

namespace fs = std::filesystem;
using testing::Read;

std::vector<fs::path> published() {
    std::vector<fs::path> result;
    const fs::path suite = tests::shared_folder() / "suite/sleec";
    if (tests::shared_folder().empty() || !fs::exists(suite)) return result;
    for (const auto& entry : fs::recursive_directory_iterator(suite))
        if (entry.path().extension() == ".sleec") result.push_back(entry.path());
    std::ranges::sort(result);
    return result;
}

std::string measure_text(const Measure& measure) {
    if (measure.type == MeasureType::boolean) return "boolean";
    if (measure.type == MeasureType::numeric) return "numeric";
    std::string literals;
    for (const Name& literal : measure.literals) literals += (literals.empty() ? "" : ", ") + literal.text;
    return "scale(" + literals + ")";
}

/// Prints the declarations and rules, with the rules as the program prints them.
std::string printed_text(const RuleFile& file) {
    std::string text = "def_start\n";
    for (const Event& event : file.events) text += "event " + event.name.text + "\n";
    for (const Measure& measure : file.measures)
        text += "measure " + measure.name.text + " : " + measure_text(measure) + "\n";
    for (const Constant& constant : file.constants)
        text += "constant " + constant.name.text + " = " + print(constant.value) + "\n";
    for (const Mapping& mapping : file.mappings)
        text += "map " + mapping.name.text + " to " + mapping.element.text + "\n";
    text += "def_end\nrule_start\n";
    for (const Rule& rule : file.rules)
        text += (rule.assumed ? "assume " : "") + rule.name.text + " " + print(rule) + "\n";
    return text + "rule_end\n";
}

/// Checks that the printed text parses to the same tree. Concerns and purposes are not printed. Without them, a text
/// may contain no construct that shows its dialect.
void expect_round_trip(const std::string& text, const std::string& name) {
    Read first(text);
    if (!first.diagnostics.ok()) return;
    const std::string printed = printed_text(first.file);
    const Read second(printed);
    EXPECT_TRUE(second.diagnostics.ok()) << name << "\n" << printed << second.report();
    first.file.concerns.clear();
    first.file.purposes.clear();
    first.file.dialect = second.file.dialect;
    EXPECT_TRUE(testing::same_file(first.file, second.file)) << name << "\n" << printed;
    EXPECT_EQ(printed_text(second.file), printed) << name;
}

TEST(SleecSuite, EveryFileIsReadAndReadsBack) {
    if (published().empty()) GTEST_SKIP() << "the published files are not there";
    for (const fs::path& path : published()) {
        Read read(tests::read_contents(path));
        EXPECT_TRUE(read.checked_too().checked) << path << "\n" << read.report();
        expect_round_trip(tests::read_contents(path), path.string());
    }
}

/// The findings are known properties of the files: their dialect, `low` for `low1` in SafeSCAD, the two rules of
/// SafeSCAD named R7_1, and conditions that mix `and` and `or`. The `and` after the event is not part of a condition.
TEST(SleecSuite, FindingsAreThose) {
    if (published().empty()) GTEST_SKIP() << "the published files are not there";
    std::map<std::string, std::string> findings;
    for (const fs::path& path : published()) {
        Read read(tests::read_contents(path));
        const fs::path name = path.parent_path().filename() / path.filename();
        EXPECT_EQ(read.file.dialect == Dialect::legos, name.string().starts_with("legos/")) << name;
        if (const std::string found = read.checked_too().findings(); !found.empty()) findings[name.string()] = found;
    }
    const std::map<std::string, std::string> expected{
        {"case-studies/SafeSCAD.sleec", "SLEEC-P10:121"},
        {"legos/safescade-corrected.sleec", "SLEEC-T05:84 SLEEC-T03:123 SLEEC-T05:211"},
        {"legos/safescade.sleec", "SLEEC-T05:59 SLEEC-T05:120 SLEEC-T05:129"},
        {"runtime/boolean.sleec", "SLEEC-P10:10"},
        {"runtime/complex.sleec", "SLEEC-P10:15"},
        {"runtime/precidence.sleec", "SLEEC-P10:6"},
    };
    EXPECT_EQ(findings, expected);
}

/// The test exchanges, omits or doubles words, and changes bytes. No change causes a crash, and accepted texts can be
/// printed and parsed again.
TEST(SleecSuite, ChangedTextsAreReadOrRefused) {
    std::vector<std::string> texts{testing::with_definitions(
        "R1 when Go and near or safe then Stop within MAX minutes otherwise {Help unless level > 3} unless near\n"
        "R2 after Go, Stop within 2 seconds\nR3 Stop at least 3 seconds after Go and load >= mid\n"
        "R4 when Go and ({level} + 2 * 3 < 9) then not Stop unless {near} then Help within [2, 3] hours else Go")};
    for (const fs::path& path : published()) texts.push_back(tests::read_contents(path));
    std::uint64_t state = 21;
    const auto below = [&state](std::size_t end) { return diagnostics::splitmix64(state) % end; };
    int accepted = 0;
    for (int round = 0; round < 600; ++round) {
        std::string text = texts[below(texts.size())];
        for (std::size_t changes = 1 + below(3); changes > 0 && !text.empty(); --changes) {
            const std::size_t at = below(text.size());
            const std::size_t length = 1 + below(8);
            switch (below(4)) {
                case 0:
                    text.erase(at, length);
                    break;
                case 1:
                    text.insert(at, text.substr(below(text.size()), length));
                    break;
                case 2:
                    text[at] = static_cast<char>(below(256));
                    break;
                default:
                    text.resize(at);
            }
        }
        Read read(text);
        if (read.checked_too().checked) ++accepted;
        expect_round_trip(text, text);
        (void)read.report();
    }
    EXPECT_GT(accepted, 10);
}

}  // namespace
}  // namespace robochart::sleec
