// SPDX-License-Identifier: Apache-2.0
// Tests one mistake in any construct. Every word of the table of constructs is omitted, doubled, or exchanged with the
// next word. The parser must end, report one or two errors if the text is invalid, and parse the text after the
// construct.
#include <gtest/gtest.h>

#include <algorithm>

#include "constructs.hpp"
#include "frontend/syntax/lexer.hpp"
#include "tests/frontend/fixture.hpp"

namespace robochart::frontend {
namespace {

using testing::Frame;
using testing::Row;

struct Words {
    std::vector<std::string> texts;

    [[nodiscard]] std::string joined() const {
        std::string out;
        for (const std::string& text : texts) out += text + " ";
        return out;
    }
};

Words words_of(const std::string& text, bool is_assertions) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics ignored;
    Words words;
    const auto source = sources.add("t", text);
    for (const Token& token : tokenize(sources, source, is_assertions, ignored).tokens)
        if (token.kind != TokenKind::end) words.texts.emplace_back(token.text);
    return words;
}

struct Count {
    std::size_t mutations = 0;
    std::size_t accepted = 0;
    std::size_t above_one = 0;
    std::size_t above_two = 0;
    std::size_t lost = 0;  ///< the next declaration was not parsed
    std::size_t most = 0;
    std::string worst;
    std::string some_lost;

    [[nodiscard]] double share(std::size_t part) const {
        return static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(mutations, 1));
    }
    void report(const char* name) const {
        std::printf(
            "%-12s %5zu mutations, %4.1f%% accepted: %.1f%% more than one message, %.1f%% more than two, at most "
            "%zu (%s); %.1f%% hide what follows (%s)\n",
            name, mutations, 100 * share(accepted), 100 * share(above_one), 100 * share(above_two), most, worst.c_str(),
            100 * share(lost), some_lost.c_str());
    }
};

bool has_next(const File& file) {
    return file.is_assertions
               ? std::ranges::any_of(file.assertions, [](const Assertion& a) { return a.name == "Next"; })
               : std::ranges::any_of(file.declarations, [](const auto& d) { return d->name == "Next"; });
}

void judge(const std::string& text, bool is_assertions, Count& count) {
    const auto reading = testing::read(
        text + (is_assertions ? "\nassertion Next : X terminates\n" : "\ninterface Next { var v : nat }\n"),
        is_assertions);
    const std::size_t errors = reading->findings.error_count();
    EXPECT_EQ(reading->file().has_syntax_errors, errors > 0) << text;
    ++count.mutations;
    count.accepted += errors == 0 ? 1U : 0U;
    count.above_one += errors > 1 ? 1U : 0U;
    count.above_two += errors > 2 ? 1U : 0U;
    if (errors > count.most) {
        count.most = errors;
        count.worst = text;
    }
    if (has_next(reading->file())) return;
    ++count.lost;
    count.some_lost = text;
}

void mutate(const std::string& text, bool is_assertions, Count& count) {
    const Words words = words_of(text, is_assertions);
    for (std::size_t i = 0; i < words.texts.size(); ++i) {
        const auto at = static_cast<std::ptrdiff_t>(i);
        Words left_out = words;
        left_out.texts.erase(left_out.texts.begin() + at);
        judge(left_out.joined(), is_assertions, count);
        Words twice = words;
        twice.texts.insert(twice.texts.begin() + at, words.texts[i]);
        judge(twice.joined(), is_assertions, count);
        if (i + 1 == words.texts.size() || words.texts[i] == words.texts[i + 1]) continue;
        Words exchanged = words;
        std::swap(exchanged.texts[i], exchanged.texts[i + 1]);
        judge(exchanged.joined(), is_assertions, count);
    }
}

/// Checks mutations of these rows. An omitted or doubled word is one mistake. An unmatched bracket or brace is also
/// reported at the end of the construct, which makes two messages. Two exchanged words may cause errors at both
/// positions and, if one is a brace, at the end too, which makes three messages. This happens only in the few
/// constructs with inner braces, so at less than one position in a hundred. The next declaration starts on a new line
/// with a keyword that starts nothing else, so it is parsed. PRISM parts are kept as text up to the word that ends
/// them. Without that word, they may hide the next declaration.
void check(const char* name, const std::vector<Row>& rows, const Frame& frame, bool is_assertions = false) {
    Count count;
    for (const Row& row : rows) mutate(frame(row.text), is_assertions, count);
    count.report(name);
    EXPECT_GT(count.mutations, 100U);
    EXPECT_LE(count.share(count.above_two), 0.01) << name;
    EXPECT_LE(count.most, 3U) << name << ": " << count.worst;
    EXPECT_LE(count.share(count.lost), is_assertions ? 0.01 : 0.0) << name;
}

TEST(ConstructMutations, OfExpressions) {
    check("atoms", testing::atoms(), testing::as_guard);
    check("operators", testing::operators(), testing::as_guard);
}

TEST(ConstructMutations, OfTypes) {
    check("types", testing::types(), testing::as_type);
}

TEST(ConstructMutations, OfStatements) {
    check("statements", testing::statements(), testing::as_entry);
}

TEST(ConstructMutations, OfClauses) {
    check("clauses", testing::clauses(), testing::as_clauses);
}

TEST(ConstructMutations, OfDeclarations) {
    check("declarations", testing::declarations(), testing::as_file);
}

TEST(ConstructMutations, OfAssertions) {
    check("assertions", testing::assertions(), testing::as_file, true);
}

}  // namespace
}  // namespace robochart::frontend
