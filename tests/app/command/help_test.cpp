// SPDX-License-Identifier: Apache-2.0
// Tests that help, man page and completions list exactly the options of the table, and that docs/cli.md names the verbs
// and exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>

#include "app/base/built_commit.hpp"
#include "app/command/help.hpp"
#include "tests/app/command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing::help_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

using Names = std::set<std::string>;

/// Returns the first group of every match of the pattern.
Names found(const std::string& text, const std::string& pattern) {
    Names names;
    const std::regex expression(pattern);
    for (auto at = std::sregex_iterator(text.begin(), text.end(), expression); at != std::sregex_iterator(); ++at)
        names.insert((*at)[1]);
    return names;
}

Names names_of(const std::vector<const OptionRow*>& rows) {
    Names names;
    for (const OptionRow* row : rows)
        for (const std::string_view name : {long_name(*row), short_name(*row)})
            if (!name.empty()) names.emplace(name);
    return names;
}

Names all_names() {
    return names_of(options_of(~Verbs{0}));
}

/// Returns the options at the beginning of the lines of a help text.
Names listed(const std::string& help) {
    Names names = found(help, "\n  (?:-[a-z], |    )(--[a-z][a-z0-9-]*)");
    names.merge(found(help, "\n  (-[a-z]), --"));
    return names;
}

TEST(OptionTable, HasOneRowForEachOptionOfAVerb) {
    EXPECT_GT(option_table().size(), 50U);
    for (const VerbRow& verb : verb_table()) {
        Names seen;
        for (const OptionRow* row : options_of(verb_bit(verb.verb)))
            EXPECT_TRUE(seen.emplace(long_name(*row)).second) << full_name(verb) << " " << row->names;
        EXPECT_TRUE(seen.contains("--help")) << full_name(verb);
    }
}

TEST(OptionTable, RowsAreWritten) {
    for (const OptionRow& row : option_table()) {
        EXPECT_NE(row.verbs, 0U) << row.names;
        EXPECT_THAT(row.help, Not(::testing::EndsWith("."))) << row.names;
        EXPECT_EQ(row.argument.kind == Argument::Kind::none, std::string(row.argument.name).empty()) << row.names;
        EXPECT_EQ(row.argument.kind == Argument::Kind::choice, !choices_of(row.argument).empty()) << row.names;
    }
}

TEST(Help, OfAVerbListsItsOptionsAndNoOthers) {
    for (const VerbRow& verb : verb_table()) {
        const std::string help = verb_help(verb);
        EXPECT_EQ(listed(help), names_of(options_of(verb_bit(verb.verb)))) << help;
        EXPECT_THAT(help, StartsWith("usage: robochart-verify " + full_name(verb) + " [OPTIONS]"));
    }
    EXPECT_EQ(listed(program_help()), (Names{"--help", "-h", "--version"}));
}

TEST(Help, FitsTheTerminal) {
    for (const VerbRow& verb : verb_table()) {
        std::istringstream lines(verb_help(verb) + program_help());
        for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
    }
}

TEST(Help, AsAVerbSaysTheSame) {
    for (const std::vector<std::string>& verb :
         {std::vector<std::string>{}, {"check"}, {"emit"}, {"emit", "cpp"}, {"cspm"}, {"help"}}) {
        std::vector<std::string> first{"help"}, second = verb;
        first.insert(first.end(), verb.begin(), verb.end());
        second.emplace_back("--help");
        const Ran ran = run(first);
        EXPECT_EQ(ran.exit, 0);
        EXPECT_EQ(ran.out, run(second).out);
        EXPECT_THAT(ran.out, HasSubstr("usage: robochart-verify"));
        EXPECT_EQ(ran.err, "");
    }
    EXPECT_EQ(run({"version"}).out, run({"--version"}).out);
    EXPECT_EQ(run({"version"}).out,
              std::string("robochart-verify ") + program_version + " (" + commit_text(built_commit()) + ")\n");
}

/// If a verb and a folder have the same name, the word means the verb. A folder whose name is similar to a verb is a
/// model.
TEST(Help, AModelMayBeCalledLikeAVerb) {
    const Ran ran = run_shell(
        "mkdir chek help\necho 'stm S { initial i state A { } transition t { from i to A } }' > chek/m.rct\n"
        "\"$verify\" chek --print ast && \"$verify\" help > /dev/null && \"$verify\" ./chek --print ast");
    EXPECT_EQ(ran.exit, 0) << ran.err;
}

TEST(ManPage, NamesTheOptionsAndNoOthers) {
    const std::string page = manual_page();
    Names options;
    for (std::string name :
         found(page, "\n\\.TP\n(?:\\\\fB\\\\-[a-z]\\\\fR, )?\\\\fB((?:\\\\-)+[a-z0-9\\\\-]+)\\\\fR")) {
        name.erase(std::remove(name.begin(), name.end(), '\\'), name.end());
        options.insert(name);
    }
    for (const std::string& name : found(page, "\n\\.TP\n\\\\fB\\\\(-[a-z])\\\\fR, ")) options.insert(name);
    EXPECT_EQ(options, all_names());
    for (const VerbRow& verb : verb_table()) EXPECT_THAT(page, HasSubstr("\\fB" + full_name(verb) + "\\fR"));
    for (const ExitRow& row : exit_table())
        EXPECT_THAT(page, HasSubstr("\\fB" + std::to_string(static_cast<int>(row.exit)) + "\\fR\n"));
    for (const char* section : {"NAME", "SYNOPSIS", "OPTIONS", "\"EXIT STATUS\"", "ENVIRONMENT", "FILES"})
        EXPECT_THAT(page, HasSubstr(std::string(".SH ") + section + "\n"));
}

TEST(ManPage, IsFormattedWithoutWarnings) {
    if (run_shell("groff --version > /dev/null 2>&1").exit != 0) GTEST_SKIP() << "groff is not installed";
    const Ran ran = run_shell("\"$verify\" help --generate man | groff -man -ww -Tascii");
    EXPECT_EQ(ran.err, "");
    EXPECT_THAT(ran.out, HasSubstr("ROBOCHART-VERIFY(1)"));
}

TEST(Completions, NameTheOptionsAndNoOthers) {
    Names in_fish;
    for (const std::string& name : found(fish_completion(), "\n(?:complete [^\n]*?)(?:'| -s [a-z]) -l ([a-z0-9-]+)"))
        in_fish.insert("--" + name);
    for (const std::string& name : found(fish_completion(), "' -s ([a-z]) -l")) in_fish.insert("-" + name);
    EXPECT_EQ(in_fish, all_names());
    Names in_bash;
    const std::string bash = bash_completion();
    const std::size_t end = bash.find("# What a verb's option takes");
    for (const std::string& line : found(bash.substr(0, end), "echo '([^']*)'")) {
        std::istringstream words(line);
        for (std::string word; words >> word;) in_bash.insert(word);
    }
    EXPECT_EQ(in_bash, all_names());
    Names in_zsh = found(zsh_completion(), "\\n        '[^']*?[)*](--?[a-z0-9-]+)=?\\[");
    EXPECT_EQ(in_zsh, all_names());
}

/// Bash completes the codes after `explain` and `--allow`, also in lower case.
TEST(Completions, OfCodesInBash) {
    const auto completed = [](const std::string& words, int current) {
        return run_shell(
                   "\"$verify\" help --generate bash > c.bash\nbash -c 'source c.bash; COMP_WORDS=(robochart-verify " +
                   words + "); COMP_CWORD=" + std::to_string(current) +
                   "; _robochart_verify; echo \"${COMPREPLY[@]}\"'")
            .out;
    };
    EXPECT_THAT(completed("explain RC-P3", 2), HasSubstr("RC-P34"));
    EXPECT_THAT(completed("explain rc-p3", 2), HasSubstr("RC-P34"));
    EXPECT_THAT(completed("explain RC-P3", 2), ::testing::Not(HasSubstr("RC-P0")));
    EXPECT_THAT(completed("check --allow RC-W1", 3), HasSubstr("RC-W17"));
    EXPECT_EQ(completed("check --allow RC-P01", 3), "\n") << "an error";
}

/// The installed man page and completions are identical to the program's output.
TEST(Completions, AreKeptAsTheyAreWritten) {
    const auto file_text = [](const char* path) { return tests::read_contents(repository(path)); };
    constexpr const char* how = "robochart-verify help --generate writes it anew";
    EXPECT_EQ(file_text("editors/completion/robochart-verify.bash"), bash_completion()) << how;
    EXPECT_EQ(file_text("editors/completion/_robochart-verify"), zsh_completion()) << how;
    EXPECT_EQ(file_text("editors/completion/robochart-verify.fish"), fish_completion()) << how;
    EXPECT_EQ(file_text("docs/robochart-verify.1"), manual_page()) << how;
    EXPECT_EQ(run({"help", "--generate", "fish"}).out, fish_completion());
}

TEST(Documentation, NamesTheVerbsAndExitCodes) {
    const std::string page = tests::read_contents(repository("docs/cli.md"));
    for (const ExitRow& row : exit_table())
        EXPECT_THAT(page, HasSubstr("\n| " + std::to_string(static_cast<int>(row.exit)) + " | "));
    for (const VerbRow& verb : verb_table()) EXPECT_THAT(page, HasSubstr("`" + full_name(verb) + "`"));
}

}  // namespace
}  // namespace robochart::app::testing::help_test
