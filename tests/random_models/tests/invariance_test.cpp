// SPDX-License-Identifier: Apache-2.0
// Tests that the order of files and declarations and the formatting do not change the results, and that damaged texts
// do not cause crashes.
#include <gtest/gtest.h>

#include <algorithm>

#include "frontend/format/format.hpp"
#include "frontend/syntax/lexer.hpp"
#include "frontend/syntax/print.hpp"
#include "tests/random_models/changes/violations.hpp"
#include "tests/random_models/models/well_formed.hpp"
#include "tests/random_models/syntax/any_syntax.hpp"
#include "tests/random_models/syntax/structure.hpp"
#include "tests/random_models/tests/seeds.hpp"

namespace robochart::random_models {
namespace {

/// Returns codes and messages of all findings, sorted and without places.
std::vector<std::string> messages(const Loaded& loaded) {
    std::vector<std::string> result;
    for (const auto& finding : loaded.findings.sorted_findings())
        result.push_back(std::string(finding.rule->code) + " " + finding.message());
    std::ranges::sort(result);
    return result;
}

template <class Items>
void shuffle(Items& items, Random& random) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random.below(i)]);
}

/// Returns the same project with its files, and the declarations in them, in another order.
Project reordered(const Project& project, Random& random) {
    const auto read = parse(project);
    Project result;
    for (std::size_t i = 0; i < project.size(); ++i) {
        shuffle(read->model.files[i]->declarations, random);
        shuffle(read->model.files[i]->imports, random);
        result.push_back({project[i].path, frontend::to_text(*read->model.files[i])});
    }
    shuffle(result, random);
    return result;
}

TEST(Invariance, OrderOfFilesAndDeclarationsChangesNoFinding) {
    for (const std::uint64_t seed : seeds(100)) {
        Random random(seed);
        const Project sound = well_formed(seed);
        const Project broken = violate(sound, random.pick(violations()), random).value_or(sound);
        const Project other = reordered(broken, random);
        ASSERT_EQ(messages(*load(other)), messages(*load(broken))) << "seed " << seed << "\n"
                                                                   << listing(broken) << "reordered\n"
                                                                   << listing(other);
    }
}

std::string formatted(const Text& file) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto text = frontend::format(sources, sources.add(file.path, file.text), file.is_assertions(), findings);
    return text.value_or("not formatted");
}

std::string structure_of(const Text& file) {
    return structure_text(*parse({file})->model.files.front());
}

void expect_formatting_is_sound(const Text& file, std::uint64_t seed) {
    const Text once{file.path, formatted(file)};
    ASSERT_EQ(structure_of(once), structure_of(file)) << "seed " << seed << "\n"
                                                      << file.text << "became\n"
                                                      << once.text;
    ASSERT_EQ(formatted(once), once.text) << "seed " << seed << "\n" << file.text;
}

TEST(Invariance, FormattingKeepsAnySyntaxAndIsIdempotent) {
    for (const std::uint64_t seed : seeds(300)) {
        expect_formatting_is_sound({"t.rct", frontend::to_text(*any_syntax(seed))}, seed);
        if (HasFatalFailure()) return;
        expect_formatting_is_sound({"t.assertions", frontend::to_text(*any_assertions(seed))}, seed);
        if (HasFatalFailure()) return;
    }
}

TEST(Invariance, FormattingReadsAMinusBehindCat) {
    expect_formatting_is_sound(
        {"t.rct", "function f() : nat {\n precondition <1> cat -a == <>\n precondition (1) == 1\n}\n"}, 0);
}

TEST(Invariance, FormattingKeepsModelsAndIsIdempotent) {
    for (const std::uint64_t seed : seeds(50))
        for (const Text& file : well_formed(seed)) {
            expect_formatting_is_sound(file, seed);
            if (HasFatalFailure()) return;
        }
}

/// Removes, duplicates, swaps or replaces words.
std::string damaged(const Text& file, Random& random) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto id = sources.add(file.path, file.text);
    const frontend::TokenStream stream = frontend::tokenize(sources, id, file.is_assertions(), findings);
    std::vector<std::string> words;
    for (const frontend::Token& token : stream.tokens)
        words.push_back(file.text.substr(token.span.begin, token.span.end - token.span.begin));
    for (std::size_t i = random.between(1, 3); i > 0 && words.size() > 2; --i) {
        const std::size_t at = random.below(words.size() - 1);
        const std::size_t way = random.below(4);
        if (way == 0) words.erase(words.begin() + static_cast<std::ptrdiff_t>(at));
        if (way == 1) words.insert(words.begin() + static_cast<std::ptrdiff_t>(at), words[at]);
        if (way == 2) std::swap(words[at], words[at + 1]);
        if (way == 3) words[at] = random.pick(words);
    }
    std::string out;
    for (const std::string& word : words) out += word + (random.chance(30) ? "\n" : " ");
    return out;
}

/// For any damage, the front end must not crash or hang, and must report findings if the text is no longer a
/// model.
TEST(Invariance, DamagedTextsAreReadToTheEnd) {
    for (const std::uint64_t seed : seeds(300)) {
        Random random(seed);
        Project project = random.chance(50) ? well_formed(seed)
                                            : Project{{"t.rct", frontend::to_text(*any_syntax(seed))},
                                                      {"t.assertions", frontend::to_text(*any_assertions(seed))}};
        for (Text& file : project) file.text = damaged(file, random);
        const auto loaded = load(project);
        for (const auto& file : loaded->model.files)
            EXPECT_FALSE(file->has_syntax_errors && loaded->findings.ok()) << "seed " << seed;
        for (const Text& file : project) formatted(file);
    }
}

}  // namespace
}  // namespace robochart::random_models
