// SPDX-License-Identifier: Apache-2.0
// Tests that printed text parses to an equal tree, for random syntax and random models.
#include <gtest/gtest.h>

#include <regex>

#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/syntax/print.hpp"
#include "tests/random_models/models/well_formed.hpp"
#include "tests/random_models/syntax/any_syntax.hpp"
#include "tests/random_models/syntax/structure.hpp"
#include "tests/random_models/tests/seeds.hpp"

namespace robochart::random_models {
namespace {

Project one_file(const frontend::File& file, const std::string& text) {
    return {{file.is_assertions ? "t.assertions" : "t.rct", text}};
}

void expect_round_trip(const frontend::File& tree, std::uint64_t seed) {
    const std::string text = frontend::to_text(tree);
    const auto read = parse(one_file(tree, text));
    ASSERT_EQ(read->findings.error_count(), 0U) << "seed " << seed << "\n" << read->report() << text;
    const frontend::File& again = *read->model.files.front();
    ASSERT_EQ(structure_text(again), structure_text(tree)) << "seed " << seed << "\n" << text;
    ASSERT_EQ(frontend::to_text(again), text) << "seed " << seed;
}

TEST(RoundTrip, AnySyntaxReadsBackAsAnEqualTree) {
    for (const std::uint64_t seed : seeds(2000)) {
        expect_round_trip(*any_syntax(seed), seed);
        if (HasFatalFailure()) return;
    }
}

TEST(RoundTrip, AnyAssertionsReadBackAsAnEqualTree) {
    for (const std::uint64_t seed : seeds(2000)) {
        expect_round_trip(*any_assertions(seed), seed);
        if (HasFatalFailure()) return;
    }
}

/// Returns the project after parsing and printing.
Project printed(const Project& project) {
    const auto read = parse(project);
    Project result;
    for (std::size_t i = 0; i < project.size(); ++i)
        result.push_back({project[i].path, frontend::to_text(*read->model.files[i])});
    return result;
}

/// Returns the resolved model without places, which printing changes.
std::string resolved(const Project& project) {
    const auto loaded = load(project);
    static const std::regex place(R"(part\d+\.rct:\d+)");
    return std::regex_replace(frontend::dump_model(loaded->model, loaded->sources, true), place, "");
}

void expect_printing_keeps_the_meaning(const Shape& shape) {
    for (const std::uint64_t seed : seeds(100)) {
        const Project project = well_formed(seed, shape);
        const Project again = printed(project);
        ASSERT_EQ(resolved(again), resolved(project)) << "seed " << seed << "\n" << listing(project);
        ASSERT_EQ(printed(again), again) << "seed " << seed;
    }
}

TEST(RoundTrip, PrintingKeepsTheMeaningOfModels) {
    expect_printing_keeps_the_meaning(Shape::whole_language());
}

TEST(RoundTrip, PrintingKeepsHostileNamesAndStrings) {
    expect_printing_keeps_the_meaning(Shape::with_hostile_words());
}

}  // namespace
}  // namespace robochart::random_models
