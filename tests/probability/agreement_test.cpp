// The decision process against what it is made of: it is branching bisimilar to the process that is checked for
// refinement (ProcessEncoding throws std::logic_error where it is not), and what a scheduler of fewer ways can do lies
// within what all can.
#include <gtest/gtest.h>

#include "tests/contents.hpp"
#include "tests/probability/models.hpp"
#include "tests/random_models/models/well_formed.hpp"
#include "tests/random_models/tests/seeds.hpp"
#include "tests/source_folder.hpp"

namespace robochart::probability {
namespace {

using prism::Rational;

/// The least and the greatest value of rows with one of each; nothing where they are not known.
std::optional<std::pair<Rational, Rational>> bounds(const std::vector<Row>& rows) {
    if (rows.size() != 1 || !rows.front().error.empty()) return std::nullopt;
    for (const prism::Result& each : rows.front().results)
        if (each.kind != prism::Result::Kind::number || !each.low.exact()) return std::nullopt;
    return std::pair(rows.front().results.front().low.value(), rows.front().results.back().low.value());
}

/// Small models with chances, in time. Not every one has an answer: probabilities of random expressions need not sum to
/// 1, and some models are too large.
TEST(Agreement, OfRandomModels) {
    random_models::Shape shape = random_models::Shape::timed_core();
    shape.probabilistic = true;
    shape.junctions = true;
    shape.controllers = {1, 1};
    shape.machines = {1, 2};
    shape.states = {1, 2};
    shape.data.largest = 1;
    std::size_t answered = 0;
    for (const std::uint64_t seed : random_models::seeds(4)) {
        const random_models::Project project = random_models::well_formed(seed, shape);
        std::map<std::string, std::string> files;
        for (const random_models::Text& each : project)
            if (!each.is_assertions()) files[each.path] = each.text;
        files["p.assertions"] = "prob property P : Prob=? of [Finally <=2 deadlock]";
        const auto loaded = testing::load(files);
        const auto asked = [&](Scheduler scheduler) {
            std::uint64_t compared = 0;
            return testing::process(*loaded, "P", scheduler, &compared, 300);
        };
        const auto any = bounds(asked(Scheduler::any));
        if (!any) continue;
        ++answered;
        const auto urgent = bounds(asked(Scheduler::urgent));
        const auto uniform = bounds(asked(Scheduler::uniform));
        ASSERT_TRUE(urgent && uniform) << seed;
        EXPECT_LE(any->first, urgent->first) << seed;
        EXPECT_LE(urgent->second, any->second) << seed;
        EXPECT_LE(any->first, uniform->first) << seed;
        EXPECT_LE(uniform->second, any->second) << seed;
    }
    EXPECT_GT(answered, 0u);
}

TEST(Agreement, OfTheForager) {
    const auto folder = tests::source_folder() / "corpus/foraging";
    const auto loaded =
        testing::load({{"foraging.rct", tests::contents(folder / "foraging.rct")},
                       {"p.assertions",
                        "import foraging::*\n"
                        "label searches = foraging::Robot::brain::forager is in foraging::Forager::Searching\n"
                        "prob property P : Prob=? of [Finally <=10 #searches]\n"
                        "prob property Q : Prob=? of [Finally <=30 foraging::Robot::brain::forager is in "
                        "foraging::Forager::Homing]"}});
    std::uint64_t compared = 0;
    // It rests for 5 units and leaves with 0.25: twice within 10.
    EXPECT_EQ(testing::text(testing::process(*loaded, "P", Scheduler::any, &compared)), "0.4375 to 0.4375");
    EXPECT_GT(compared, 30u);
    // Without food it searches for 20 units and has to leave after two rests; with food at once six are enough.
    EXPECT_EQ(testing::text(testing::process(*loaded, "Q", Scheduler::any)), "0.4375 to 3367/4096");
    EXPECT_EQ(testing::text(testing::process(*loaded, "Q", Scheduler::urgent)), "0.4375 to 3367/4096");
}

}  // namespace
}  // namespace robochart::probability
