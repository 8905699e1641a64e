// SPDX-License-Identifier: Apache-2.0
// Tests that the diagrams of all available models satisfy the criteria of scene.hpp, that text stays in its box, and
// that elements refer to positions in the text.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "frontend/diagrams/layout/text_width.hpp"
#include "frontend/syntax/print.hpp"
#include "tests/frontend/diagrams/models.hpp"
#include "tests/frontend/diagrams/scene.hpp"
#include "tests/random_models/models/well_formed.hpp"
#include "tests/random_models/syntax/any_syntax.hpp"
#include "tests/rounds.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::diagrams {
namespace {

using ::testing::IsEmpty;

/// Returns the distance from the left end of a text to its anchor.
double anchor_offset(const Text& text, double width) {
    switch (text.anchor) {
        case Anchor::start:
            return 0;
        case Anchor::middle:
            return width / 2;
        case Anchor::end:
            break;
    }
    return width;
}

/// Returns texts that exceed their boxes. Texts of events are next to their squares, so they are not checked.
std::vector<std::string> texts_outside(const Picture& picture) {
    std::vector<std::string> outside;
    for (const PictureBox& box : picture.boxes)
        for (const Text& text : box.texts) {
            const double width = layout::text_width(text.text, text.size, text.bold);
            const double left = text.at.x - anchor_offset(text, width);
            const PictureBox& around = box.event_of == none ? box : picture.boxes[box.event_of];
            const bool beside = box.event_of != none && around.look == Look::frame;
            const bool within = left >= around.place.x - 0.01 && left + width <= around.place.right() + 0.01 &&
                                text.at.y - text.size >= around.place.y - 1 && text.at.y <= around.place.bottom();
            if (!within && !beside) outside.push_back(text.text);
            if (left < 0 || left + width > picture.size.width) outside.push_back(text.text + " (picture)");
        }
    return outside;
}

void expect_good(const DrawnModel& drawn) {
    const std::string where = drawn.subject.name + " of " + drawn.model.sources.path(diagnostics::SourceId{0});
    EXPECT_THAT(faults_of(scene_of(drawn.picture)), IsEmpty()) << where;
    EXPECT_THAT(texts_outside(drawn.picture), IsEmpty()) << where;
}

TEST(Pictures, OfOurModelsMeetTheCriteria) {
    EXPECT_GT(draw_own_models(expect_good), 300U);
}

TEST(Pictures, OfPublicModelsMeetTheCriteria) {
    const auto folder = tests::shared_folder() / "suite";
    if (tests::shared_folder().empty()) GTEST_SKIP() << "there is no folder `shared` beside the repository";
    std::set<std::string> crossed;
    EXPECT_GT(draw_below(folder,
                         [&](const DrawnModel& drawn) {
                             expect_good(drawn);
                             const std::string file = drawn.model.sources.path(diagnostics::SourceId{0});
                             if (crossings_of(scene_of(drawn.picture)) > 0)
                                 crossed.insert(std::filesystem::path(file).filename().string());
                         }),
              100U);
    // In the machine of the chemical detector for RoboSim, three of the drawn edges cross.
    crossed.erase("Movement.rct");
    crossed.erase("Movement.rst");
    EXPECT_THAT(crossed, IsEmpty());
}

TEST(Pictures, OfRandomModelsMeetTheCriteria) {
    for (std::uint64_t seed = 1; seed <= tests::rounds(24); ++seed)
        draw_each(random_models::well_formed(seed), expect_good);
}

/// The syntax trees are arbitrary, with names that have no meaning.
TEST(Pictures, OfAnySyntaxMeetTheCriteria) {
    for (std::uint64_t seed = 1; seed <= tests::rounds(120); ++seed)
        draw_each({{"any.rct", frontend::to_text(*random_models::any_syntax(seed, 6))}}, expect_good);
}

/// The text is incomplete, as it is while somebody types.
TEST(Pictures, OfBrokenTextMeetTheCriteria) {
    for (std::uint64_t seed = 1; seed <= tests::rounds(6); ++seed) {
        random_models::Project project = random_models::well_formed(seed);
        const std::string whole = project.front().text;
        for (std::size_t part = 1; part < 12; ++part) {
            project.front().text = whole.substr(0, whole.size() * part / 12);
            draw_each(project, expect_good);
            project.front().text = whole;
            project.front().text.erase(whole.size() * part / 12, 9);
            draw_each(project, expect_good);
        }
    }
}

TEST(Pictures, ElementsLeadToTheText) {
    draw_own_models([](const DrawnModel& drawn) {
        std::set<std::string> ids;
        for (const Element& element : drawn.elements.all_elements()) {
            EXPECT_TRUE(ids.insert(element.id).second) << element.id;
            if (!element.span.is_known()) continue;
            EXPECT_LE(element.span.begin, element.span.end);
            EXPECT_LE(element.span.end, drawn.model.sources.source_text(element.span.source).size());
        }
        for (const PictureBox& box : drawn.picture.boxes)
            if (box.element != none) {
                const Element& element = drawn.elements.all_elements()[box.element];
                ASSERT_TRUE(element.span.is_known()) << element.id;
                if (!element.name_span.is_known()) continue;
                const auto text = drawn.model.sources.source_text(element.name_span.source);
                const auto written =
                    text.substr(element.name_span.begin, element.name_span.end - element.name_span.begin);
                EXPECT_TRUE(written.find(element.name) != std::string_view::npos || element.name.empty())
                    << element.name << " at " << written;
            }
    });
}

}  // namespace
}  // namespace robochart::diagrams
