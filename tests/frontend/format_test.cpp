// The house style: what it looks like, and its laws over every text at hand: no word or comment is lost, the model stays
// the same, formatting twice is formatting once, and blanks of the input do not matter.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "fixture.hpp"
#include "frontend/format.hpp"
#include "frontend/lexer.hpp"

namespace robochart::frontend {
namespace {

namespace fs = std::filesystem;

/// The formatted text; "" and a failure if there is none.
std::string formatted(const std::string& text, bool is_assertions = false) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto source = sources.add(is_assertions ? "t.assertions" : "t.rct", text);
    const auto result = format(sources, source, is_assertions, findings);
    EXPECT_TRUE(result.has_value()) << diagnostics::render_text(sources, findings) << text;
    return result.value_or("");
}

/// The model without its places.
std::string meaning(const std::string& text, bool is_assertions) {
    const auto reading = testing::read(text, is_assertions);
    return reading->dumped();
}

void expect_laws(const std::string& text, bool is_assertions, const std::string& origin) {
    const std::string once = formatted(text, is_assertions);
    EXPECT_EQ(formatted(once, is_assertions), once) << origin << " is not stable:\n" << text;
    EXPECT_TRUE(same_words(text, once, is_assertions)) << origin;
}

void expect_format(const std::string& text, const std::string& wanted, bool is_assertions = false) {
    EXPECT_EQ(formatted(text, is_assertions), wanted);
    EXPECT_EQ(formatted(wanted, is_assertions), wanted) << "not stable";
}

struct Example {
    std::string origin;
    std::string text;
    bool is_assertions;
};

void add_examples(std::vector<Example>& examples, const fs::path& folder) {
    if (!fs::is_directory(folder)) return;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const bool is_assertions = entry.path().extension() == ".assertions";
        if (!entry.is_regular_file() || (!is_assertions && entry.path().extension() != ".rct")) continue;
        Example example{entry.path().string(), testing::slurp(entry.path()), is_assertions};
        if (!testing::read(example.text, is_assertions)->file().has_syntax_errors) examples.push_back(example);
    }
}

/// Every text without syntax errors in the repository and, where it is at hand, beside it.
const std::vector<Example>& examples() {
    static const std::vector<Example> all = [] {
        std::vector<Example> found;
        const fs::path root = ROBOCHART_SOURCE_DIR;
        for (const char* folder : {"corpus", "tests", "frontend/library", "docs"}) add_examples(found, root / folder);
        if (const fs::path shared = testing::shared_folder(); !shared.empty()) {
            add_examples(found, shared / "suite");
            add_examples(found, shared / "bench");
        }
        std::sort(found.begin(), found.end(), [](const Example& a, const Example& b) { return a.origin < b.origin; });
        return found;
    }();
    return all;
}

TEST(Format, KeepsTheLawsOverAllTexts) {
    EXPECT_GT(examples().size(), 100U);
    for (const Example& example : examples()) {
        expect_laws(example.text, example.is_assertions, example.origin);
        EXPECT_EQ(meaning(formatted(example.text, example.is_assertions), example.is_assertions),
                  meaning(example.text, example.is_assertions))
            << example.origin;
    }
}

TEST(Format, ShortBodiesStandOnOneLine) {
    expect_format("stm  S{state a{ }state b{entry x=1 }initial i transition t{from i to a\n trigger e ? x\n} }",
                  "stm S {\n\tstate a {}\n\tstate b { entry x = 1 }\n\tinitial i\n"
                  "\ttransition t { from i to a trigger e?x }\n}\n");
}

}  // namespace
}  // namespace robochart::frontend
