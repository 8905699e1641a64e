// Random well-formed models load without an error, whatever the seed and the shape.
#include <gtest/gtest.h>

#include "random_models/well_formed.hpp"
#include "tests/random_models/seeds.hpp"

namespace robochart::random_models {
namespace {

void expect_no_errors(const Shape& shape, std::uint64_t count) {
    for (const std::uint64_t seed : seeds(count)) {
        const Project project = well_formed(seed, shape);
        const auto loaded = load(project);
        ASSERT_EQ(loaded->findings.errors(), 0U) << "seed " << seed << "\n" << loaded->report() << listing(project);
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

TEST(WellFormed, TheSameSeedGivesTheSameProject) {
    EXPECT_EQ(well_formed(7), well_formed(7));
    EXPECT_NE(well_formed(7), well_formed(8));
}

TEST(WellFormed, SizedProjectsHaveTheSizeAskedFor) {
    const Project project = sized(3, 5000, 20);
    EXPECT_EQ(project.size(), 21U);  // and the claims
    EXPECT_GE(lines(project), 5000U);
    EXPECT_LE(lines(project), 8000U);
    EXPECT_EQ(load(project)->findings.errors(), 0U);
}

}  // namespace
}  // namespace robochart::random_models
