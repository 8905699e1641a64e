// SPDX-License-Identifier: Apache-2.0
// Tests that a rule that is violated on purpose in a random well-formed model is reported, and that no other finding
// is.
#include <gtest/gtest.h>

#include <cstdint>

#include "tests/random_models/changes/shrink.hpp"
#include "tests/random_models/changes/violations.hpp"
#include "tests/random_models/models/well_formed.hpp"
#include "tests/random_models/tests/seeds.hpp"

namespace robochart::random_models {
namespace {

TEST(Violations, EachIsFoundAndNothingElse) {
    constexpr std::uint64_t tries = 8;
    const std::size_t enough = is_long_run() ? SIZE_MAX : 2;
    for (const Violation& violation : violations()) {
        std::size_t places = 0;
        for (const std::uint64_t seed : seeds(tries)) {
            Random random(seed);
            const Project sound = well_formed(seed);
            const auto broken = violate(sound, violation, random);
            if (!broken) continue;
            ++places;
            const auto loaded = load(*broken);
            const std::string codes = loaded->error_codes();
            EXPECT_EQ(codes, violation.code) << "seed " << seed << ": " << violation.member << "\n" << loaded->report();
            if (codes != violation.code || places == enough) break;
        }
        EXPECT_GE(places, 1U) << violation.code << " finds no place: " << violation.member;
    }
}

TEST(Violations, ShrinkingKeepsTheFaultAndLittleElse) {
    for (const Violation& violation : violations()) {
        if (violation.code != "J3" && violation.code != "RC-T04" && violation.code != "C10") continue;
        Random random(1);
        std::optional<Project> broken;
        for (std::uint64_t seed = 0; !broken; ++seed) broken = violate(well_formed(seed), violation, random);
        const auto fails = [&](const Project& project) { return load(project)->error_codes() == violation.code; };
        const Project small = shrink(*broken, fails);
        EXPECT_TRUE(fails(small));
        EXPECT_LE(lines(small), 45U) << violation.code << " from " << lines(*broken) << "\n" << listing(small);
    }
}

}  // namespace
}  // namespace robochart::random_models
