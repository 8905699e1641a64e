// SPDX-License-Identifier: Apache-2.0
// Tests that random well-formed models load without an error for every seed and shape.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/random_models/models/well_formed.hpp"
#include "tests/random_models/syntax/structure.hpp"
#include "tests/random_models/tests/seeds.hpp"

namespace robochart::random_models {
namespace {

void expect_no_errors(const Shape& shape, std::uint64_t count) {
    for (const std::uint64_t seed : seeds(count)) {
        const Project project = well_formed(seed, shape);
        const auto loaded = load(project);
        ASSERT_EQ(loaded->findings.error_count(), 0U) << "seed " << seed << "\n"
                                                      << loaded->report() << listing(project);
    }
}

TEST(WellFormed, TheUntimedCoreHasNoErrors) {
    expect_no_errors(Shape::untimed_core(), 300);
}

TEST(WellFormed, TheTimedCoreHasNoErrors) {
    expect_no_errors(Shape::timed_core(), 300);
}

TEST(WellFormed, TheWholeLanguageHasNoErrors) {
    expect_no_errors(Shape::whole_language(), 300);
}

TEST(WellFormed, HostileWordsMakeNoErrors) {
    expect_no_errors(Shape::with_hostile_words(), 300);
}

/// Returns the structures of many models of a shape.
std::string syntax_of(const Shape& shape) {
    std::string all;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const auto read = parse(well_formed(seed, shape));
        for (const auto& file : read->model.files) all += structure_text(*file);
    }
    return all;
}

TEST(WellFormed, TheWholeLanguageIsUsed) {
    const std::string all = syntax_of(Shape::whole_language());
    for (const char* construct : {"(given",
                                  "(record-type",
                                  "(enumeration",
                                  "(function-declaration",
                                  "(signature",
                                  "(precondition",
                                  "(interface",
                                  "(platform",
                                  "(operation",
                                  "(stm",
                                  "(controller",
                                  "(module",
                                  "(reference",
                                  "(connection",
                                  "async",
                                  "mult",
                                  "(clock",
                                  "(junction",
                                  "(probabilistic",
                                  "(final",
                                  "entry",
                                  "during",
                                  "exit",
                                  "(probability",
                                  "clock-reset",
                                  "(transition-deadline",
                                  "else-condition",
                                  "(condition",
                                  "(wait ",
                                  "(wait-interval",
                                  "(deadline",
                                  "(reset",
                                  "(if-statement",
                                  "(group",
                                  "(call-of",
                                  "(assignment",
                                  "(input",
                                  "(output",
                                  "(sync",
                                  "send",
                                  "(since",
                                  "(sinceEntry",
                                  "(let",
                                  "(the",
                                  "(forall",
                                  "(exists",
                                  "(exists1",
                                  "(lambda",
                                  "(comprehension",
                                  "(set-range",
                                  "(range",
                                  "(tuple",
                                  "(record ",
                                  "(sequence",
                                  "(set",
                                  "(matrix-of",
                                  "(as",
                                  "(member",
                                  "(index",
                                  "(call",
                                  "(if",
                                  "(string",
                                  "(real",
                                  "concat",
                                  "modulus",
                                  "terminates-flag",
                                  "clauses",
                                  "provides",
                                  "requires",
                                  "uses",
                                  "(assertion"})
        EXPECT_THAT(all, ::testing::HasSubstr(construct));
}

TEST(WellFormed, TheCoresKeepToTheirParts) {
    const std::string untimed = syntax_of(Shape::untimed_core());
    for (const char* construct : {"(clock", "(wait", "(deadline", "(since", "(transition-deadline", "(real", "(string",
                                  "(probabilistic", "(function-declaration", "(forall", "(matrix", "broadcast", "(is ",
                                  "(call ", "no-body", "(relation", "diagram"})
        EXPECT_THAT(untimed, ::testing::Not(::testing::HasSubstr(construct)));
    EXPECT_THAT(syntax_of(Shape::timed_core()), ::testing::HasSubstr("(since"));
}

TEST(WellFormed, TheSameSeedGivesTheSameProject) {
    EXPECT_EQ(well_formed(7), well_formed(7));
    EXPECT_NE(well_formed(7), well_formed(8));
}

TEST(WellFormed, SizedProjectsHaveTheSizeAskedFor) {
    const Project project = sized(3, 5000, 20);
    EXPECT_EQ(project.size(), 21U);  // and the assertion file
    EXPECT_GE(lines(project), 5000U);
    EXPECT_LE(lines(project), 8000U);
    EXPECT_EQ(load(project)->findings.error_count(), 0U);
}

}  // namespace
}  // namespace robochart::random_models
