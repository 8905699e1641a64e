// SPDX-License-Identifier: Apache-2.0
// Tests that after any edits, the state of the server equals that of a newly loaded project.
#include <gtest/gtest.h>
#include <algorithm>

#include <filesystem>
#include <iterator>
#include <random>

#include "base/diagnostics/render.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"
#include "tests/contents.hpp"
#include "tests/editors/server/client.hpp"
#include "tests/rounds.hpp"
#include "tests/source_folder.hpp"

namespace robochart::lsp {
namespace {

using tests::read_contents;

using testing::Answer;
using testing::Client;

/// Edits the texts of several files through a server.
class Editing {
public:
    enum class Language { robochart, cspm };
    Editing(std::vector<std::string> texts, std::uint32_t seed, Language language = Language::robochart)
        : texts_(std::move(texts)), random_(seed), language_(language) {
        for (std::size_t i = 0; i < texts_.size(); ++i) client.open(uri(i), texts_[i]);
    }

    [[nodiscard]] const char* extension(std::size_t i) const {
        if (language_ == Language::cspm) return ".csp";
        return i == 0 ? ".assertions" : ".rct";
    }
    [[nodiscard]] std::string uri(std::size_t i) const { return "file:///p/" + std::to_string(i) + extension(i); }

    /// Makes a random change, and sends it as ranges.
    void edit() {
        const std::size_t file = pick(texts_.size());
        Json list = Json::array();
        for (std::size_t i = 0, n = 1 + pick(3); i < n; ++i) {
            std::string& text = texts_[file];
            const std::size_t begin = pick(text.size() + 1);
            const std::size_t length =
                pick(4) == 0 ? std::min<std::size_t>(text.size() - begin, pick(40)) : pick(2) == 0;
            const std::size_t end = std::min(text.size(), begin + length);
            const std::vector<std::string>& pieces = language_ == Language::cspm ? pieces_of_scripts : pieces_of_models;
            const std::string piece = pieces[pick(pieces.size())];
            list.push_back(Json::object({{"range", range_of(text, begin, end)}, {"text", piece}}));
            text.replace(begin, end - begin, piece);
        }
        client.changes(uri(file), std::move(list));
    }

    void expect_as_anew() {
        Client fresh;
        for (std::size_t i = 0; i < texts_.size(); ++i) fresh.open(uri(i), texts_[i]);
        for (std::size_t i = 0; i < texts_.size(); ++i) {
            const Answer incremental = client.diagnostics(uri(i));
            const Answer anew = fresh.diagnostics(uri(i));
            ASSERT_EQ(incremental.items().size(), anew.items().size()) << texts_[i];
            ASSERT_EQ(incremental.items(), anew.items());
            for (const char* method : {"textDocument/documentSymbol", "textDocument/semanticTokens/full"}) {
                const Json document = Json::object({{"textDocument", Json::object({{"uri", uri(i)}})}});
                ASSERT_EQ(client.request(method, document), fresh.request(method, document));
            }
        }
    }

    /// Requests every feature at a random place. None may fail.
    void probe() {
        const std::size_t file = pick(texts_.size());
        const std::size_t place = pick(texts_[file].size() + 1);
        Json params = Json::object({{"textDocument", Json::object({{"uri", uri(file)}})},
                                    {"position", range_of(texts_[file], place, place)["start"]},
                                    {"range", range_of(texts_[file], place, place)},
                                    {"newName", "fresh_name"},
                                    {"context", Json::object({{"includeDeclaration", true}})}});
        for (const char* method :
             {"textDocument/hover", "textDocument/definition", "textDocument/references", "textDocument/completion",
              "textDocument/documentHighlight", "textDocument/signatureHelp", "textDocument/codeAction",
              "textDocument/foldingRange", "textDocument/prepareRename", "textDocument/rename",
              "textDocument/formatting", "textDocument/documentSymbol", "textDocument/selectionRange"}) {
            const Answer response = client.ask(method, params);
            EXPECT_NE(response["error"]["code"].number(), -32603) << method << response.write();
        }
        client.messages.clear();
    }

    Client client;

private:
    std::size_t pick(std::size_t bound) { return random_() % bound; }

    static Json range_of(const std::string& text, std::size_t begin, std::size_t end) {
        return Json::object({{"start", place_of(text, begin)}, {"end", place_of(text, end)}});
    }
    static Json place_of(const std::string& text, std::size_t offset) {
        const std::string before = text.substr(0, offset);
        const auto line = std::ranges::count(before, '\n');
        const std::size_t start = line == 0 ? 0 : before.rfind('\n') + 1;
        return Json::object({{"line", line}, {"character", offset - start}});
    }

    const std::vector<std::string> pieces_of_models = {
        "",       "",           "x",     "{",  "}",   "(",  " ",    "\n",    ";",   "::",         "state Q ",
        "^",      "import ",    "/*",    "*/", "//",  "\"", "stm ", "from ", "1.5", "= ",         "event",
        " : nat", "csp-begin ", "speed", "S",  "p::", ".",  "[|",   "|]",    "<{",  "requires I "};
    const std::vector<std::string> pieces_of_scripts = {
        "",       "",          "",      "x",  "(",    ")",   "<",   ">",  "{",     "}",    "\n", "\n",
        "= ",     " -> ",      " [] ",  "->", "{-",   "-}",  "--",  "\"", "?x",    "!1",   "::", " within ",
        "let x=", "channel x", "print", "^",  "\\ x", "[|x", "<-3", "@",  "STOP ", "P(1)", "[[", "include \"0.csp\"\n"};
    std::vector<std::string> texts_;
    std::mt19937 random_;
    Language language_;
};

std::vector<std::string> corpus_texts() {
    const std::filesystem::path corpus = tests::source_folder().string() + "/corpus";
    return {
        read_contents(corpus / "aggregation/aggregation.assertions"),
        read_contents(corpus / "aggregation/aggregation.rct"), read_contents(corpus / "swarm_taxis/swarm_taxis.rct"),
        "import set_toolkit::*\ninterface I { var speed : nat var s : Set(nat) }\n"
        "stm S { requires I initial i state A { entry speed = size(union(s, {1})) } transition t { from i to A } }\n"};
}

/// Makes thousands of edits. After every few edits, the server must agree with a server that has received only the
/// result.
TEST(Incremental, IsTheSameAsFromScratch) {
    for (std::uint32_t seed = 1; seed <= tests::rounds(2); ++seed) {
        Editing editing(corpus_texts(), seed);
        for (int round = 0; round < 30; ++round) {
            for (int i = 0; i < 8; ++i) editing.edit();
            editing.expect_as_anew();
            ASSERT_FALSE(::testing::Test::HasFailure()) << "seed " << seed << " round " << round;
        }
    }
}

TEST(Incremental, NothingFailsInTextsHoweverBroken) {
    for (std::uint32_t seed = 100; seed < 100 + tests::rounds(3); ++seed) {
        Editing editing(corpus_texts(), seed);
        for (int round = 0; round < 60; ++round) {
            editing.edit();
            editing.probe();
        }
    }
}

/// Returns the texts of several scripts. One of them includes the first.
std::vector<std::string> scripts_of_tests() {
    const std::filesystem::path tests = tests::source_folder().string() + "/tests";
    return {
        read_contents(tests / "app/phases/timed_script.csp"),
        read_contents(tests / "fuzz/regressions/script/while_typed.csp"),
        "include \"0.csp\"\nchannel c_ : {0..2}.Bool\nmodule M_(p)\n  q = p + 1\nexports\n  R_(x) = c_!x?b -> R_(q)\n"
        "endmodule\ninstance I_ = M_(1)\nfold_(f, <>) = 0\nfold_(f, <x>^s) = f(x, fold_(f, s))\n"
        "assert I_::R_(1) :[deadlock free]\n"};
}

TEST(Incremental, ScriptsAreTheSameAsFromScratch) {
    for (std::uint32_t seed = 1; seed <= tests::rounds(3); ++seed) {
        Editing editing(scripts_of_tests(), seed, Editing::Language::cspm);
        for (int round = 0; round < 15; ++round) {
            for (int i = 0; i < 4; ++i) editing.edit();
            editing.expect_as_anew();
            ASSERT_FALSE(::testing::Test::HasFailure()) << "seed " << seed << " round " << round;
        }
    }
}

TEST(Incremental, NothingFailsInScriptsHoweverBroken) {
    for (std::uint32_t seed = 100; seed < 100 + tests::rounds(4); ++seed) {
        Editing editing(scripts_of_tests(), seed, Editing::Language::cspm);
        for (int round = 0; round < 60; ++round) {
            editing.edit();
            editing.probe();
        }
    }
}

/// The server finds what the command line finds.
TEST(Incremental, AgreesWithTheCommandLine) {
    for (const auto& entry :
         std::filesystem::directory_iterator(tests::source_folder().string() + "/tests/frontend/fixtures")) {
        if (entry.path().extension() != ".rct") continue;
        SourceManager sources;
        diagnostics::Diagnostics findings;
        auto model = std::make_unique<frontend::Model>();
        const std::string text = read_contents(entry.path());
        model->files.push_back(frontend::parse(sources, sources.add("a.rct", text), false, findings));
        frontend::update_toolkits(sources, *model, findings);
        frontend::resolve(*model, findings);
        std::string expected;
        for (const auto& finding : findings.sorted_findings())
            expected += (expected.empty() ? "" : " ") + std::string(finding.rule->code) + "@" +
                        std::to_string(sources.position(finding.span.source, finding.span.begin).line);
        Client client;
        client.open("file:///p/a.rct", text);
        EXPECT_EQ(client.all_codes(), expected) << entry.path();
    }
}

}  // namespace
}  // namespace robochart::lsp
