// SPDX-License-Identifier: Apache-2.0
// Tests that incremental resolution gives the same result as resolution from scratch, and resolves no more files than
// necessary.
#include <gtest/gtest.h>

#include "frontend/project/incremental.hpp"
#include "frontend/syntax/lexer.hpp"
#include "frontend/syntax/parse.hpp"
#include "tests/frontend/fixture.hpp"
#include "tests/random_models/models/random.hpp"
#include "tests/random_models/models/well_formed.hpp"
#include "tests/random_models/tests/seeds.hpp"
#include "tests/rounds.hpp"
#include "tests/source_folder.hpp"

namespace robochart::frontend {
namespace {

using diagnostics::Diagnostics;
using diagnostics::SourceManager;
using random_models::Project;
using random_models::Random;

/// Returns the dump with targets and types, and every finding with its fixes.
std::string texts_of(const Model& model, const SourceManager& sources, const Diagnostics& findings) {
    return dump_model(model, sources, true) + diagnostics::render_text(sources, findings);
}

std::string anew(const Project& project) {
    SourceManager sources;
    Diagnostics ignored;
    Diagnostics findings;
    Model model;
    for (const auto& [path, text] : project)
        model.files.push_back(parse(sources, sources.add(path, text), path.ends_with(".assertions"), ignored));
    update_toolkits(sources, model, findings);
    resolve(model, findings);
    return texts_of(model, sources, findings);
}

/// A project whose files change one by one.
class Kept {
public:
    explicit Kept(Project project) : project_(std::move(project)) {
        Diagnostics ignored;
        for (const auto& file : project_)
            model_.files.push_back(parse(sources_, sources_.add(file.path, file.text), file.is_assertions(), ignored));
    }
    void change(std::size_t file, std::string text) {
        Diagnostics ignored;
        const auto source = model_.files[file]->source;
        sources_.replace(source, text);
        resolution_.replace(model_.files[file], parse(sources_, source, project_[file].is_assertions(), ignored));
        project_[file].text = std::move(text);
    }
    std::string resolve() {
        Diagnostics findings;
        update_toolkits(sources_, model_, findings);
        resolution_.resolve(model_, findings);
        return texts_of(model_, sources_, findings);
    }
    /// Returns true if the last resolution skipped some files.
    [[nodiscard]] bool left_others() const { return resolution_.files_resolved() < model_.files.size(); }
    [[nodiscard]] const Project& project() const { return project_; }
    [[nodiscard]] std::size_t resolved() const { return resolution_.files_resolved(); }

private:
    Project project_;
    SourceManager sources_;
    Model model_;
    Resolution resolution_;
};

/// Returns the text with one word omitted, doubled, or replaced by another word of the text.
std::string edited(const std::string& text, bool is_assertions, Random& random) {
    SourceManager sources;
    Diagnostics ignored;
    const auto words = tokenize(sources, sources.add("t", text), is_assertions, ignored).tokens;
    if (words.size() < 2) return text + " stm";
    const auto& word = words[random.below(words.size() - 1)];
    const auto& other = words[random.below(words.size() - 1)];
    const auto of = [&](const Token& token) {
        return text.substr(token.span.begin, token.span.end - token.span.begin);
    };
    const std::string instead[] = {"", of(word) + " " + of(word), of(other), of(other)};
    std::string result = text;
    return result.replace(word.span.begin, word.span.end - word.span.begin, instead[random.below(4)]);
}

/// Changes random words, reverts half of the changes, and compares after each change.
std::size_t expect_the_same(Project project, std::size_t edits, Random& random) {
    Kept incremental(std::move(project));
    std::size_t left_others = 0;
    EXPECT_EQ(incremental.resolve(), anew(incremental.project()));
    for (std::size_t i = 0; i < edits; ++i) {
        const std::size_t file = random.below(incremental.project().size());
        const std::string before = incremental.project()[file].text;
        for (const std::string& text : {edited(before, incremental.project()[file].is_assertions(), random), before}) {
            if (text == before && random.below(4) == 0) continue;  // keeps some mistakes in the text
            incremental.change(file, text);
            const std::string now = incremental.resolve();
            const std::string expected = anew(incremental.project());
            EXPECT_EQ(now, expected);
            if (now != expected) return left_others;
            if (incremental.left_others()) ++left_others;
        }
    }
    return left_others;
}

TEST(Incremental, RandomProjectsAreResolvedAsAnew) {
    std::size_t left_others = 0;
    for (const std::uint64_t seed : random_models::seeds(6)) {
        if (HasFailure()) break;
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        left_others += expect_the_same(random_models::sized(seed, 300, 4), 25, random);
    }
    EXPECT_GT(left_others, 5U) << "the test would say nothing";
}

TEST(Incremental, TheCorpusIsResolvedAsAnew) {
    const std::filesystem::path corpus = tests::source_folder().string() + "/corpus";
    Project project;
    for (const char* path : {"aggregation/aggregation.assertions", "aggregation/aggregation.rct",
                             "swarm_taxis/swarm_taxis.assertions", "swarm_taxis/swarm_taxis.rct"})
        project.push_back({path, testing::read_contents(corpus / path)});
    Random random(7);
    EXPECT_GT(expect_the_same(project, tests::rounds(90), random), tests::rounds(30));
}

// ---------------------------------------------------------------- files that are resolved

const Project three = {
    {"a.rct", "interface I { var x : nat var y : nat event e : nat }\ninterface O { go(n : nat) }\n"},
    {"b.rct",
     "stm S { uses I requires O initial i state A { entry x = 1 } transition t { from i to A action y = x } }\n"},
    {"c.rct", "stm T { uses I initial i state A { entry x = x + y } transition t { from i to A } }\n"},
};

std::size_t looked_at(std::size_t file, const std::string& text) {
    Kept incremental(three);
    incremental.resolve();
    incremental.change(file, text);
    EXPECT_EQ(incremental.resolve(), anew(incremental.project()));
    return incremental.resolved();
}

TEST(Incremental, ABodyConcernsItsFileAlone) {
    EXPECT_EQ(looked_at(1,
                        "stm S { uses I requires O initial i state A { entry x = y; go(3) } "
                        "transition t { from i to A condition x > 2 } }\n"),
              1U);
    EXPECT_EQ(looked_at(1,
                        "stm S { uses I requires O initial i state A { entry x = nothing } "
                        "transition t { from i to B } }\n"),
              1U);
}

TEST(Incremental, ADeclarationConcernsEveryFile) {
    const std::size_t all = three.size() + 1;  // and the core library
    EXPECT_EQ(looked_at(0, "interface I { var x : real var y : nat event e : nat }\ninterface O { go(n : nat) }\n"),
              all);
    EXPECT_EQ(looked_at(1, "stm S2 { uses I requires O initial i state A { } transition t { from i to A } }\n"), all);
    EXPECT_EQ(looked_at(1, "import set_toolkit::*\n" + three[1].text), all + 1);
}

/// If a note points into a changed text, its place moves with the text.
TEST(Incremental, NotesIntoTheChangedFileMove) {
    Kept incremental(
        {{"a.rct", "stm M { initial i state A { } transition t { from i to A } }\ninterface I { var speed : nat }\n"},
         {"b.rct",
          "stm S { requires I var speed : real initial i state A { entry speed = 1.0 } "
          "transition t { from i to A } }\n"}});
    const std::string before = incremental.resolve();
    EXPECT_NE(before.find("this declaration is hidden"), std::string::npos) << before;
    incremental.change(
        0, "stm M {\n\n\n initial i state A { } transition t { from i to A } }\ninterface I { var speed : nat }\n");
    const std::string after = incremental.resolve();
    EXPECT_EQ(after, anew(incremental.project()));
    EXPECT_NE(after.find("a.rct:5:"), std::string::npos) << after;
}

/// If a syntax error hides a part of one file, errors for unknown names in another file are suppressed until it is
/// corrected.
TEST(Incremental, WhatWasLostMattersElsewhere) {
    Kept incremental({{"a.rct", "stm M { initial i state A { } transition t { from i to A } }\n"},
                      {"b.rct", "stm S { requires Lost initial i state A { } transition t { from i to A } }\n"}});
    for (const char* text : {"stm M { initial i state A { } transition t { from i to A } }\ninterface Lost { var ( }\n",
                             "stm M { initial i state A { } transition t { from i to A } }\ninterface { }\n",
                             "stm M { initial i state A { } transition t { from i to A action } }\n",
                             "stm M { initial i state A { } transition t { from i to A } }\n"}) {
        incremental.change(0, text);
        EXPECT_EQ(incremental.resolve(), anew(incremental.project())) << text;
    }
}

}  // namespace
}  // namespace robochart::frontend
