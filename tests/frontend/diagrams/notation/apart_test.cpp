// SPDX-License-Identifier: Apache-2.0
// Tests that boxes of one level have a gap, and that no square of an event covers the text of a title. The test uses
// the automatic layout, and drawn layouts with boxes that touch and squares at any place.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/diagnostics/splitmix64.hpp"
#include "frontend/diagrams/layout/text_width.hpp"
#include "frontend/diagrams/notation/painter.hpp"
#include "tests/frontend/diagrams/models.hpp"
#include "tests/random_models/models/well_formed.hpp"
#include "tests/rounds.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::diagrams {
namespace {

using layout::Rectangle;
using ::testing::IsEmpty;

constexpr double least_gap = 5;
constexpr double area_border = 5;  ///< between an area of RoboTool and the boxes in it

/// Returns the area of the letters of a centred title, from the highest to the lowest letter.
Rectangle letters_of(const Text& title) {
    const double width = layout::text_width(title.text, title.size, title.bold);
    return {title.at.x - width / 2, title.at.y - 0.75 * title.size, width, title.size};
}

bool has_title(const PictureBox& box) {
    return box.event_of == none && !is_round(box.look) && !box.texts.empty() &&
           box.texts.front().anchor == Anchor::middle;
}

std::vector<std::string> faults_of_boxes(const Picture& picture) {
    std::vector<std::string> faults;
    const auto name = [&](std::size_t b) {
        return fmt::format("{} ({})", picture.boxes[b].texts.empty() ? "" : picture.boxes[b].texts.front().text, b);
    };
    for (std::size_t a = 0; a < picture.boxes.size(); ++a)
        for (std::size_t b = 0; b < picture.boxes.size(); ++b) {
            const PictureBox& first = picture.boxes[a];
            const PictureBox& second = picture.boxes[b];
            const bool siblings = a < b && first.event_of == none && second.event_of == none &&
                                  first.parent == second.parent && first.parent != none;
            if (siblings && layout::rectangles_overlap(first.place, second.place, -least_gap))
                faults.push_back(fmt::format("{} and {} are too near", name(a), name(b)));
            if (first.event_of != none && has_title(second) &&
                layout::rectangles_overlap(first.place, letters_of(second.texts.front())))
                faults.push_back(fmt::format("{} covers the title of {}", name(a), name(b)));
        }
    return faults;
}

/// A layout by a person who draws boxes that touch, at multiples of 40 pixels. Squares are on all sides, some of them
/// near the titles.
class DrawnAnyhow {
public:
    DrawnAnyhow(const Subject& subject, std::uint64_t seed) : state_(seed) {
        if (subject.component == nullptr) return;
        if (const auto* machine = dynamic_cast<const frontend::Machine*>(subject.component)) add_nodes(*machine);
        if (const auto* component = dynamic_cast<const frontend::Component*>(subject.component))
            for (const frontend::Declaration* part : component->order) add_part(*part);
        add_squares(*subject.component);
    }
    [[nodiscard]] const StoredLayout& layout() const { return layout_; }

private:
    double number(double low, double high) {
        return low + (high - low) * static_cast<double>(diagnostics::splitmix64(state_) % 1000) / 1000;
    }
    double multiple(int most) { return 40.0 * std::floor(number(0, most)); }

    void add_box(const frontend::Declaration& declaration) {
        layout::DrawnBox box{{area_border + multiple(8), area_border + multiple(8)}, {}, {}};
        if (number(0, 1) < 0.7) box.width = 40 + multiple(4);
        if (number(0, 1) < 0.7) box.height = 40 + multiple(3);
        layout_.boxes.emplace(&declaration, box);
    }

    void add_nodes(const frontend::NodeContainer& container) {
        for (const auto& node : container.nodes) {
            add_box(*node);
            add_nodes(*node);
        }
    }

    void add_part(const frontend::Declaration& part) {
        add_box(part);
        if (const auto* machine = dynamic_cast<const frontend::Machine*>(&part);
            machine != nullptr && number(0, 1) < 0.5)
            add_nodes(*machine);
        add_squares(part);
    }

    void add_squares(const frontend::Declaration& owner) {
        const auto* reference = dynamic_cast<const frontend::Reference*>(&owner);
        const auto* context = dynamic_cast<const frontend::Context*>(reference == nullptr ? &owner : reference->target);
        if (context == nullptr) return;
        for (const frontend::Event* event : events_of(*context))
            layout_.squares[&owner].emplace(event, layout::DrawnPort{{number(-30, 300), number(-30, 90)}});
    }

    std::uint64_t state_;
    StoredLayout layout_;
};

void expect_apart(const DrawnModel& drawn) {
    const std::string where = drawn.subject.name + " of " + drawn.model.sources.path(diagnostics::SourceId{0});
    EXPECT_THAT(faults_of_boxes(drawn.picture), IsEmpty()) << where;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const DrawnAnyhow anyhow(drawn.subject, seed);
        const Picture picture = draw_subject(drawn.subject, {drawn.elements, nullptr, nullptr, &anyhow.layout()});
        EXPECT_THAT(faults_of_boxes(picture), IsEmpty()) << where << ", drawing " << seed;
    }
}

TEST(Boxes, OfOurModelsAreApartAndTitlesAreFree) {
    EXPECT_GT(draw_own_models(expect_apart), 300U);
}

TEST(Boxes, OfPublicModelsAreApartAndTitlesAreFree) {
    if (tests::shared_folder().empty()) GTEST_SKIP() << "there is no folder `shared` beside the repository";
    EXPECT_GT(draw_below(tests::shared_folder() / "suite", expect_apart), 100U);
}

TEST(Boxes, OfRandomModelsAreApartAndTitlesAreFree) {
    for (std::uint64_t seed = 1; seed <= tests::rounds(24); ++seed)
        draw_each(random_models::well_formed(seed), expect_apart);
}

}  // namespace
}  // namespace robochart::diagrams
