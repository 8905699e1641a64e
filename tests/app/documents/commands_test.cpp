// SPDX-License-Identifier: Apache-2.0
// Runs every command in a document, unless this file lists it with the reason why not. All verbs and options that
// documents name must exist. The language of a fenced block decides: `console` is run, `sh` is not run, `text` contains
// no commands.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <set>
#include <sstream>
#include <string_view>

#include "app/command/option_table.hpp"
#include "tests/app/command.hpp"
#include "tests/app/documents/document.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;

// ---------------------------------------------------------------- commands that are not run

struct NotRun {
    std::string_view document;  ///< "" for any document
    std::string_view command;   ///< prefix of the command
    std::string_view reason;
};

constexpr std::array not_run = {
    NotRun{"", "scripts/", "builds, tests or measures, for minutes"},
    NotRun{"", "tests/long.sh", "tests for minutes"},
    NotRun{"", "benchmarks/", "measures for minutes"},
    NotRun{"", "cmake ", "builds"},
    NotRun{"", "ctest ", "runs the tests of a build tree"},
    NotRun{"", "run-clang-tidy ", "checks a build tree for minutes"},
    NotRun{"", "build/", "a program of a build tree that is not built for these tests"},
    NotRun{"", "setarch -R build/", "needs ARGoS"},
    NotRun{"docs/emergence.md", "robochart-verify simulate corpus/", "hundreds of trials"},
    NotRun{"docs/emergence.md", "robochart-verify tune ", "hundreds of trials"},
    NotRun{"docs/scale.md", "apt install ", "installs packages"},
    NotRun{"docs/scale.md", "mpirun ", "a cluster"},
    NotRun{"docs/cpp.md", "$ build/M_console", "a conversation on a terminal"},
    NotRun{"editors/vscode/README.md", "code ", "needs VS Code"},
    NotRun{"editors/vscode/README.md", "ln -s", "needs VS Code"},
    NotRun{"editors/vscode/README.md", "npm ", "fetches packages"},
    NotRun{"simulation/adapters/argos/README.md", "git clone ", "fetches ARGoS"},
};

/// Languages of blocks without commands: other tests or other programs read them.
constexpr std::array<std::string_view, 22> no_commands = {
    "robochart", "ros2",  "assertions", "scenario", "swarm", "cspm", "prism", "props", "sleec",   "claims",
    "cpp",       "cmake", "yaml",       "lua",      "elisp", "toml", "json",  "text",  "robosim", "robosim-assertions",
    "coq",       "python"};

// ---------------------------------------------------------------- documents

/// Returns the paths of all Markdown documents except the history, templates and documents of third parties.
std::vector<std::string> written_documents() {
    std::vector<std::string> result;
    const fs::path root = repository("");
    for (auto at = fs::recursive_directory_iterator(root); at != fs::recursive_directory_iterator(); ++at) {
        const std::string name = at->path().filename().string();
        const bool skipped = name.starts_with('.') || name.starts_with("build") || name == "node_modules" ||
                             name == "out" || name == "templates";
        if (at->is_directory() && skipped) at.disable_recursion_pending();
        if (at->is_regular_file() && at->path().extension() == ".md" && name != "CHANGELOG.md")
            result.push_back(fs::relative(at->path(), root).string());
    }
    std::ranges::sort(result);
    return result;
}

std::string first_word(const std::string& text) {
    std::istringstream words(text);
    std::string word;
    words >> word;
    return word;
}

/// Returns the commands in a block: the lines after `$ ` if there are any, otherwise all lines. A command may continue
/// on the next line. Comments and indented lines belong to the command above.
std::vector<std::string> commands_of(const Block& block) {
    const bool marked =
        std::ranges::any_of(block.lines, [](const std::string& line) { return line.starts_with("$ "); });
    std::vector<std::string> result;
    bool continues = false;
    for (const std::string& line : block.lines) {
        if (!continues && !line.empty() && !line.starts_with(' ') && !line.starts_with('#') &&
            (!marked || line.starts_with("$ ")))
            result.push_back(line);
        continues = line.ends_with('\\');
    }
    return result;
}

/// Returns true if the word is the path of a script of the project.
bool is_script(const std::string& word) {
    return word == "tests/long.sh" ||
           (!word.ends_with('/') && (word.starts_with("scripts/") || word.starts_with("benchmarks/")));
}

bool looks_like_command(const std::string& line) {
    static const std::set<std::string> programs = {
        "robochart-verify", "$",   "cmake",  "ctest", "run-clang-tidy", "cpack", "sudo", "apt", "apt-get", "git", "npm",
        "docker",           "pip", "python3"};
    const std::string word = first_word(line);
    return programs.contains(word) || word.starts_with("build/") || word.starts_with("./") || is_script(word);
}

const NotRun* exception_for(const std::string& document, const std::string& command) {
    const auto* const found = std::ranges::find_if(not_run, [&](const NotRun& exception) {
        return (exception.document.empty() || exception.document == document) && command.starts_with(exception.command);
    });
    return found == not_run.end() ? nullptr : found;
}

/// Returns the faults of a document. `used` receives the exceptions that the document needs.
std::vector<std::string> faults_of(const std::string& document, std::set<const NotRun*>& used) {
    std::vector<std::string> faults;
    for (const Block& block : blocks_of(tests::read_contents(repository(document)))) {
        const std::string place = document + ":" + std::to_string(block.line) + ": ";
        const std::string language = first_word(block.language);
        if (language == "console") continue;
        if (language == "sh") {
            for (const std::string& command : commands_of(block)) {
                const NotRun* const exception = exception_for(document, command);
                if (exception == nullptr) faults.push_back(place + "neither run nor excepted: " + command);
                used.insert(exception);
            }
        } else if (std::ranges::find(no_commands, language) == no_commands.end()) {
            faults.push_back(place + "is this `console`, `sh` or `text`?");
        } else if (language == "text") {
            for (const std::string& line : block.lines)
                if (looks_like_command(line)) faults.push_back(place + "a command in a text: " + line);
        }
    }
    return faults;
}

TEST(CommandsInDocuments, AreRunOrExcepted) {
    std::set<const NotRun*> used;
    for (const std::string& document : written_documents()) EXPECT_THAT(faults_of(document, used), IsEmpty());
    for (const NotRun& exception : not_run)
        EXPECT_TRUE(used.contains(&exception)) << "nobody needs it: " << exception.command;
}

/// The tests in this file would not find commands in other kinds of blocks.
TEST(CommandsInDocuments, StandInFencedBlocks) {
    for (const std::string& document : written_documents()) {
        std::istringstream text(tests::read_contents(repository(document)));
        bool in_block = false;
        for (std::string line; std::getline(text, line);) {
            const bool is_fence = line.starts_with("```");
            if (is_fence) in_block = !in_block;
            if (in_block || is_fence) continue;
            const std::string word = first_word(line);
            EXPECT_FALSE(word.starts_with("```") || word.starts_with("~~~")) << document << ": " << line;
            const bool indented = line.starts_with("    ") || line.starts_with('\t');
            EXPECT_FALSE(indented && looks_like_command(line)) << document << ": " << line;
        }
        EXPECT_FALSE(in_block) << document << ": the last block has no end";
    }
}

/// Only these documents may have `console` blocks: README.md and docs/*.md, which tests in this folder run, and
/// docs/rules/*.md, which tests/rules runs.
TEST(CommandsInDocuments, SessionsStandWhereTheyAreRun) {
    for (const std::string& document : written_documents()) {
        const fs::path folder = fs::path(document).parent_path();
        if (document == "README.md" || folder == "docs" || folder == "docs/rules") continue;
        for (const Block& block : blocks_of(tests::read_contents(repository(document))))
            EXPECT_NE(block.language, "console") << document << ":" << block.line;
    }
}

TEST(CommandsInDocuments, NameScriptsThatAreThere) {
    for (const std::string& document : written_documents())
        for (const Block& block : blocks_of(tests::read_contents(repository(document))))
            for (const std::string& command : commands_of(block))
                EXPECT_TRUE(block.language != "sh" || !is_script(first_word(command)) ||
                            fs::exists(repository(first_word(command))))
                    << document << ": " << command;
}

// ---------------------------------------------------------------- verbs and options

using Words = std::vector<std::string>;

/// Removes dots, semicolons and `\|` at the end.
void strip_end(std::string& word) {
    constexpr std::string_view endings[] = {"...", ";", "\\|"};
    const auto ends = [&](std::string_view ending) { return word.ends_with(ending); };
    for (const auto* found = std::ranges::find_if(endings, ends); found != std::end(endings);
         found = std::ranges::find_if(endings, ends))
        word.resize(word.size() - found->size());
}

/// Returns the words of a command up to the next command, without the brackets and dots of synopses.
Words words_of(std::string text) {
    for (char& c : text)
        if (c == '[' || c == ']' || c == '\'' || c == '"') c = ' ';
    Words words;
    std::istringstream in(text);
    for (std::string word; in >> word;) {
        static const std::set<std::string> ends = {"|", ">", "<", ">>", "&&", "||", ";", "#", "\\", "2>", "&"};
        if (ends.contains(word)) break;
        const bool last = word.ends_with(';');
        strip_end(word);
        if (!word.empty()) words.push_back(word);
        if (last) break;
    }
    return words;
}

Words alternatives(const std::string& word) {
    Words result;
    std::istringstream in(word);
    for (std::string alternative; std::getline(in, alternative, '|');) {
        if (alternative.ends_with('\\')) alternative.pop_back();
        result.push_back(alternative);
    }
    return result;
}

/// Returns true if a word such as "MODEL" or "N" is a placeholder for the reader's value.
bool is_placeholder(const std::string& word) {
    return !word.empty() && std::ranges::all_of(word, [](unsigned char c) {
        return std::isupper(c) != 0 || std::isdigit(c) != 0 || c == '_' || c == '.' || c == '=' || c == '|';
    });
}

const OptionRow* option_of(Verbs verb, const std::string& name) {
    for (const OptionRow* row : options_of(verb))
        if (name == long_name(*row) || name == short_name(*row)) return row;
    return nullptr;
}

/// Returns an explanation why the words after an option do not fit, or "" if they fit.
std::string wrong_words(const OptionRow& row, const Words& given) {
    for (std::size_t at = 0; at < given.size(); ++at)
        for (std::string alternative : alternatives(given[at])) {
            if (is_placeholder(alternative)) continue;
            const std::string why = wrong_word(row.argument, at, alternative);
            const bool of_choice = row.argument.kind == Argument::Kind::choice;
            if (of_choice && !why.empty()) return "`" + alternative + "` behind " + row.names + ": " + why;
        }
    return {};
}

/// Returns the first problem with the options of a verb in the rest of a command.
std::string wrong_options(Verbs verb, const Words& words, std::size_t at) {
    for (; at < words.size(); ++at) {
        if (!words[at].starts_with('-') || words[at] == "-") continue;
        const std::size_t equals = words[at].find('=');
        const OptionRow* const row = option_of(verb, words[at].substr(0, equals));
        if (row == nullptr) return "no option " + words[at];
        const std::size_t behind = equals == std::string::npos ? words_after(row->argument) : 0;
        Words given;
        for (std::size_t i = 0; i < behind && at + 1 < words.size(); ++i) given.push_back(words[++at]);
        if (const std::string why = wrong_words(*row, given); !why.empty()) return why;
    }
    return {};
}

/// Returns the first problem with the words after `robochart-verify`, or "" if there is none.
std::string wrong_call(const Words& words) {
    const Words first = first_words();
    const bool verb_given = !words.empty() && std::ranges::find(first, words[0]) != first.end();
    if (!verb_given) {
        const bool input = words.empty() || words[0].starts_with('-') || is_placeholder(words[0]) ||
                           words[0].find_first_of("./") != std::string::npos ||
                           fs::exists(repository("corpus/" + words[0]));
        const bool model = input || words.size() > 1;  // a model file of the page
        return model ? wrong_options(verb_bit(Verb::verify), words, 0) : "no verb " + words[0];
    }
    if (words[0] != "emit") return wrong_options(verb_bit(find_verb(words[0])->verb), words, 1);
    if (words.size() == 1) return {};
    for (const std::string& thing : alternatives(words[1])) {
        const VerbRow* const row = find_verb("emit " + thing);
        if (row == nullptr) return "nothing to emit: " + thing;
        if (const std::string why = wrong_options(verb_bit(row->verb), words, 2); !why.empty()) return why;
    }
    return {};
}

/// Returns the words after each call of the program in a text. A call is at the beginning of the text or after a
/// character that starts a command.
std::vector<Words> calls_in(const std::string& text) {
    constexpr std::string_view program = "robochart-verify ";
    std::vector<Words> result;
    for (std::size_t at = text.find(program); at != std::string::npos; at = text.find(program, at + 1)) {
        const std::string before = text.substr(0, at);
        const std::size_t word = before.find_last_not_of(' ');
        const bool begins =
            word == std::string::npos ||
            (before.ends_with(' ') && std::string_view("$-|;&=:").find(before[word]) != std::string_view::npos);
        if (begins) result.push_back(words_of(text.substr(at + program.size())));
    }
    return result;
}

/// Returns true if the text is a verb with its options, as in the middle of a sentence: `conform --traces`.
bool is_call_of_verb(const std::string& text) {
    const Words words = words_of(text);
    const Words first = first_words();
    if (words.size() < 2 || std::ranges::find(first, words[0]) == first.end()) return false;
    return words[0] == "emit" ||
           std::ranges::any_of(words, [](const std::string& word) { return word.starts_with("--"); });
}

TEST(CommandsInDocuments, HaveVerbsAndOptionsThatExist) {
    std::size_t calls = 0;
    const auto check = [&](const std::string& place, const Words& words) {
        ++calls;
        EXPECT_EQ(wrong_call(words), "") << place;
    };
    for (const std::string& document : written_documents()) {
        const std::string text = tests::read_contents(repository(document));
        for (const Inline& code : inline_code(text)) {
            const std::string place = document + ":" + std::to_string(code.line) + ": " + code.text;
            for (const Words& words : calls_in(code.text)) check(place, words);
            if (is_call_of_verb(code.text)) check(place, words_of(code.text));
        }
        for (const Block& block : blocks_of(text))
            for (const std::string& line : block.lines) {
                if (block.language == "console" && !line.starts_with("$ ")) continue;  // output of the program
                for (const Words& words : calls_in(line))
                    check(document + ":" + std::to_string(block.line) + ": " + line, words);
            }
    }
    EXPECT_GT(calls, 200U) << "the documents are full of them";
}

TEST(CommandsInDocuments, AreReadAsTheyAreWritten) {
    EXPECT_EQ(wrong_call(words_of("MODEL --print ir")), "");
    EXPECT_EQ(wrong_call(words_of("help --generate bash|zsh|fish")), "");
    EXPECT_EQ(wrong_call(words_of("emit csp|cpp MODEL...")), "");
    EXPECT_EQ(wrong_call(words_of("explain [CODE...]")), "");
    EXPECT_EQ(wrong_call(words_of("check a.rct > out --nothing")), "");
    EXPECT_NE(wrong_call(words_of("check MODEL --nothing")), "");
    EXPECT_NE(wrong_call(words_of("emit nothing MODEL")), "");
    EXPECT_NE(wrong_call(words_of("chekc")), "");
    EXPECT_NE(wrong_call(words_of("help --generate csh")), "");
    EXPECT_NE(wrong_call(words_of("cspm SCRIPT --core")), "") << "an option of other verbs";
    EXPECT_EQ(calls_in("$ robochart-verify lsp").size(), 1U);
    EXPECT_EQ(calls_in("- robochart-verify lsp && robochart-verify help").size(), 2U);
    EXPECT_EQ(calls_in("the program robochart-verify is").size(), 0U);
}

TEST(InlineCode, StandsOutsideBlocks) {
    const std::vector<Inline> found =
        inline_code("a `b\nc` d\n\n```sh\n`x`\n```\n| `e` | `f` |\nopen ` quote\n\n`g`\n");
    ASSERT_EQ(found.size(), 4U);
    EXPECT_EQ(found[0].text, "b c");
    EXPECT_EQ(found[0].line, 1U);
    EXPECT_EQ(found[2].text, "f");
    EXPECT_EQ(found[3].text, "g");
}

}  // namespace
}  // namespace robochart::app::testing
