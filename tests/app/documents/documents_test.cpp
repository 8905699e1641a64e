// SPDX-License-Identifier: Apache-2.0
// Follows README.md and the pages of docs/: writes the files that they show, runs the commands that they show, and
// compares the output with the shown output.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/app/command.hpp"
#include "tests/app/documents/document.hpp"
#include "tests/contents.hpp"
#include "tests/source_folder.hpp"

namespace robochart::app::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;

constexpr const char* mark = "==== end of a command ====";

void write(const Folder& folder, const ShownFile& file) {
    fs::create_directories(fs::path(folder / file.name).parent_path());
    std::ofstream(folder / file.name, std::ios::binary) << file.text;
}

/// Returns a script that runs all commands of a session in one shell, so `$?` is the exit code of the previous command.
std::string script(const Folder& folder, const ShownSession& session) {
    std::string text = "cd '" + folder.path() + "'; PATH=\"$PWD/bin:$PATH\"; exec 2>&1\n";
    for (const ShownCommand& command : session.commands)
        text += command.command + "\nstatus=$?; echo '" + mark + "'; (exit $status)\n";
    return text;
}

std::string shown(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += "  " + line + "\n";
    return text;
}

void run_session(const std::string& document, const Folder& folder, const ShownSession& session) {
    std::string out = run_shell(script(folder, session)).out;
    const std::string place = document + ":" + std::to_string(session.line);
    for (const ShownCommand& command : session.commands) {
        const std::size_t end = out.find(mark);
        ASSERT_NE(end, std::string::npos) << place << ": not reached: " << command.command << "\n" << out;
        const std::vector<std::string> printed = lines_of(out.substr(0, end));
        EXPECT_TRUE(lines_agree(command.output, printed)) << place << ": $ " << command.command << "\nshows\n"
                                                          << shown(command.output) << "but prints\n"
                                                          << shown(printed);
        out.erase(0, out.find('\n', end) + 1);
    }
}

/// Sets up the environment of a reader: the command on the path, and the models of the repository.
void furnish(const Folder& folder) {
    fs::create_directories(folder / "bin");
    fs::create_symlink(tests::command_path(), folder / "bin/robochart-verify");
    fs::copy(repository("corpus"), folder / "corpus", fs::copy_options::recursive);
}

bool has_session(const std::string& document) {
    const std::vector<Step> all = steps_of(tests::read_contents(repository(document)));
    return std::ranges::any_of(all, [](const Step& step) { return step.index() == 1; });
}

std::vector<std::string> documents() {
    std::vector<std::string> result;
    for (const auto& entry : fs::directory_iterator(repository("docs")))
        if (entry.path().extension() == ".md") result.push_back("docs/" + entry.path().filename().string());
    result.emplace_back("README.md");
    std::erase_if(result, [](const std::string& document) { return !has_session(document); });
    std::ranges::sort(result);
    return result;
}

class Document : public ::testing::TestWithParam<std::string> {};

TEST_P(Document, PrintsWhatItShows) {
    const Folder folder;
    furnish(folder);
    for (const Step& step : steps_of(tests::read_contents(repository(GetParam())))) {
        if (const auto* file = std::get_if<ShownFile>(&step))
            write(folder, *file);
        else
            run_session(GetParam(), folder, std::get<ShownSession>(step));
    }
}

INSTANTIATE_TEST_SUITE_P(OfTheProject, Document, ::testing::ValuesIn(documents()), [](const auto& document) {
    std::string name = fs::path(document.param).stem().string();
    std::ranges::replace(name, '-', '_');
    return name;
});

TEST(Steps, AreFilesAndSessions) {
    const std::vector<Step> all = steps_of(
        "Text\n```robochart\n// file: a/m.rct\nstm S { }\n```\n```text\nnothing\n```\n"
        "```console\n$ one \\\n  more\nout\n\n$ two\n```\n");
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(std::get<ShownFile>(all[0]).name, "a/m.rct");
    EXPECT_EQ(std::get<ShownFile>(all[0]).text, "// file: a/m.rct\nstm S { }\n");
    const auto& session = std::get<ShownSession>(all[1]);
    EXPECT_EQ(session.line, 9U);
    ASSERT_EQ(session.commands.size(), 2U);
    EXPECT_EQ(session.commands[0].command, "one \\\n  more");
    EXPECT_THAT(session.commands[0].output, ElementsAre("out"));
    EXPECT_EQ(session.commands[1].command, "two");
    EXPECT_THAT(session.commands[1].output, ElementsAre());
}

TEST(Agreement, IsOfLinesWithoutFiguresAndGaps) {
    EXPECT_TRUE(lines_agree({"holds  A1  11 states  0 ms"}, {"holds A1 1,024 states 12 ms  "}));
    EXPECT_TRUE(lines_agree({"conforms  C  404 ms"}, {"conforms C 1.7 s"}));
    EXPECT_FALSE(lines_agree({"holds A1"}, {"FAILS A1"}));
    EXPECT_FALSE(lines_agree({"1 of 2 hold"}, {"2 of 2 hold"}));
    EXPECT_FALSE(lines_agree({"a"}, {}));
    EXPECT_FALSE(lines_agree({}, {"a"}));
    EXPECT_FALSE(lines_agree({"a", "b"}, {"a"}));
}

TEST(Agreement, DotsStandForAnyLines) {
    EXPECT_TRUE(lines_agree({"..."}, {}));
    EXPECT_TRUE(lines_agree({"a", "...", "c"}, {"a", "b", "b", "c"}));
    EXPECT_TRUE(lines_agree({"a", "  ...", "c"}, {"a", "c"}));
    EXPECT_TRUE(lines_agree({"...", "b", "...", "c"}, {"a", "b", "c", "b", "c"}));
    EXPECT_FALSE(lines_agree({"a", "...", "c"}, {"a", "b"}));
    EXPECT_FALSE(lines_agree({"...", "b", "..."}, {"a", "c"}));
    EXPECT_FALSE(lines_agree({"a", "...", "a"}, {"a"}));
}

}  // namespace
}  // namespace robochart::app::testing
