// SPDX-License-Identifier: Apache-2.0
// Tests that one mistake causes one message. Every word of real models is omitted, preceded by an unrelated word, or
// replaced by one. The test counts the errors, including errors of resolution.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "fixture.hpp"
#include "frontend/syntax/lexer.hpp"
#include "tests/rounds.hpp"
#include "tests/source_folder.hpp"

namespace robochart::frontend {
namespace {

namespace fs = std::filesystem;

struct Count {
    std::size_t mutations = 0;
    std::size_t above_one = 0;
    std::size_t above_two = 0;
    std::size_t most = 0;
    std::string worst;
    std::string report;

    void add(const std::string& text, std::size_t before, const std::string& what) {
        const auto reading = testing::resolved(text);
        const std::size_t errors = reading->findings.error_count() - std::min(before, reading->findings.error_count());
        ++mutations;
        above_one += errors > 1 ? 1U : 0U;
        above_two += errors > 2 ? 1U : 0U;
        if (errors <= most) return;
        most = errors;
        worst = what;
        report = reading->report();
    }
    [[nodiscard]] double share(std::size_t part) const {
        return mutations == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(mutations);
    }
};

std::vector<fs::path> models() {
    std::vector<fs::path> result;
    for (const auto& entry : fs::recursive_directory_iterator(tests::source_folder() / "corpus"))
        if (entry.path().extension() == ".rct") result.push_back(entry.path());
    std::ranges::sort(result);
    return result;
}

std::size_t errors_of(const std::string& text) {
    return testing::resolved(text)->findings.error_count();
}

constexpr std::array<const char*, 12> strangers = {"}", "{", "(", ")", ";", ":", "=", ",", "state", "x", "42", "from"};

TEST(Mutations, GiveOneMessageOrTwo) {
    Count deleted;
    Count inserted;
    Count replaced;
    std::size_t turn = 0;
    std::size_t place_number = 0;
    for (const fs::path& path : models()) {
        const std::string text = testing::read_contents(path);
        const std::size_t before = errors_of(text);
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics ignored;
        const auto source = sources.add("m.rct", text);
        const TokenStream stream = tokenize(sources, source, false, ignored);
        for (const Token& token : stream.tokens) {
            if (token.kind == TokenKind::end) break;
            if (place_number++ % tests::distance_of_places(1) != 0) continue;
            // If a name replaces another, this is not a syntax error, but it may cause an error at each use.
            const std::string place = path.filename().string() + ":" +
                                      std::to_string(sources.position(source, token.span.begin).line) + " `" +
                                      std::string(token.text) + "`";
            const std::size_t length = token.span.end - token.span.begin;
            const std::string stranger = strangers.at(turn++ % strangers.size());
            deleted.add(std::string(text).erase(token.span.begin, length), before, place + " left out");
            inserted.add(std::string(text).insert(token.span.begin, stranger + " "), before,
                         place + " after " + stranger);
            if (token.kind == TokenKind::identifier && stranger == "x") continue;
            replaced.add(std::string(text).replace(token.span.begin, length, stranger + " "), before,
                         place + " replaced by " + stranger);
        }
    }
    for (const auto& [name, count] :
         {std::pair("left out", deleted), std::pair("inserted", inserted), std::pair("replaced", replaced)}) {
        RecordProperty(name, std::to_string(count.mutations));
        std::printf("%-9s %6zu words: %.2f%% more than one message, %.2f%% more than two, at most %zu (%s)\n", name,
                    count.mutations, 100 * count.share(count.above_one), 100 * count.share(count.above_two), count.most,
                    count.worst.c_str());
        EXPECT_LE(count.share(count.above_two), 0.025) << name;
        // If the name of a state or an event is lost, its five uses cause errors too.
        EXPECT_LE(count.most, 7U) << name << ": " << count.worst << "\n" << count.report;
    }
    EXPECT_GT(deleted.mutations, tests::size_of_input(500));
}

/// Mistakes elsewhere in the text are still reported.
TEST(Mutations, DoNotHideOtherMistakes) {
    for (const char* mistake : {"interface J { event e : }", "stm A { state s { entry = } initial i }", "type",
                                "} type B", "stm { initial i }", "interface J { var v nat }",
                                "function f(x:) : nat { }", "controller C { connection a on }", "foo B { x }"}) {
        const auto reading = testing::resolved(std::string(mistake) +
                                               "\nstm S {\n  var v:nat\n  initial i\n  state s { entry v = true }\n"
                                               "  junction j\n  transition t { from i to s }\n}\n");
        EXPECT_NE(reading->codes().find("RC-T02@5"), std::string::npos) << reading->report();
        EXPECT_NE(reading->codes().find("J1@6"), std::string::npos) << reading->report();
        EXPECT_LE(reading->findings.error_count(), 4U) << reading->report();
    }
}

}  // namespace
}  // namespace robochart::frontend
