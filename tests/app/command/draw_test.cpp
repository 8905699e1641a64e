// SPDX-License-Identifier: Apache-2.0
// Tests the verb `draw`: all diagrams into a folder, one diagram to standard output or a file, formats, rejected
// inputs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/app/command.hpp"
#include "tests/contents.hpp"
#include "tests/needed.hpp"

namespace robochart::app::draw_test {
namespace {

namespace fs = std::filesystem;
using testing::Folder;
using ::testing::HasSubstr;
using testing::repository;
using testing::run;
using ::testing::StartsWith;
using testing::TemporaryFile;
using tests::read_contents;

TEST(Draw, WritesADiagramForEachComponent) {
    const Folder folder;
    const auto ran = run({"draw", repository("corpus/aggregation"), "--out", folder / "d"});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    for (const std::string name : {"AggregationFSM", "AggregationController", "Aggregation", "EPuck", "MoveClockwise",
                                   "RotateClockwise", "aggregation_types"}) {
        EXPECT_THAT(read_contents(folder / ("d/" + name + ".svg")), StartsWith("<svg ")) << name;
        EXPECT_THAT(ran.out, HasSubstr("d/" + name + ".svg"));
    }
    EXPECT_EQ(run({"draw", repository("corpus/aggregation"), "-q", "--out", folder / "d"}).out, "");
}

TEST(Draw, WritesOneComponentToStandardOutputOrAFile) {
    const Folder folder;
    const auto printed = run({"draw", repository("corpus/aggregation"), "AggregationFSM"});
    EXPECT_EQ(printed.exit, 0) << printed.err;
    EXPECT_THAT(printed.out, StartsWith("<svg "));
    EXPECT_THAT(printed.out, HasSubstr("<title>state machine aggregation::AggregationFSM</title>"));
    const auto written =
        run({"draw", repository("corpus/aggregation"), "aggregation::AggregationFSM", "-o", folder / "fsm.svg"});
    EXPECT_EQ(written.exit, 0) << written.err;
    EXPECT_EQ(written.out, "");
    EXPECT_EQ(read_contents(folder / "fsm.svg"), printed.out);
    EXPECT_EQ(run({"draw", repository("corpus/aggregation"), "AggregationFSM", "-o", "-"}).out, printed.out);
}

TEST(Draw, SeveralComponentsGoToTheFolder) {
    const Folder folder;
    const auto ran = run({"draw", repository("corpus/aggregation"), "AggregationFSM", "EPuck", "--out", folder.path()});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_TRUE(fs::exists(folder / "AggregationFSM.svg"));
    EXPECT_TRUE(fs::exists(folder / "EPuck.svg"));
    EXPECT_FALSE(fs::exists(folder / "Aggregation.svg"));
}

TEST(Draw, SuggestsTheComponentThatWasMeant) {
    const auto ran = run({"draw", repository("corpus/aggregation"), "AggregationFMS"});
    EXPECT_EQ(ran.exit, 4);
    EXPECT_EQ(ran.out, "");
    EXPECT_THAT(ran.err, HasSubstr("no component 'AggregationFMS'; did you mean 'AggregationFSM'?"));
}

TEST(Draw, AsksWhichComponentIsMeant) {
    const TemporaryFile file("m.rct",
                             "package p\nstm M { initial i }\ncontroller A { stm S { initial i } }\n"
                             "controller B { stm S { initial i } }\n");
    const auto ran = run({"draw", file.path(), "S"});
    EXPECT_EQ(ran.exit, 4);
    EXPECT_THAT(ran.err, HasSubstr("p__A__S (p::A::S), p__B__S (p::B::S)"));
    EXPECT_EQ(run({"draw", file.path(), "B::S"}).exit, 2) << "B has no platform to be well-formed with, but is drawn";
    EXPECT_THAT(run({"draw", file.path(), "B::S"}).out, HasSubstr("p::B::S"));
}

TEST(Draw, DrawsWhatHasErrors) {
    const TemporaryFile file(
        "m.rct", "stm M { initial i state s { } transition t { from i to nowhere } transition u { from s }\n");
    const auto ran = run({"draw", file.path(), "M"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.out, HasSubstr(">nowhere</text>"));
    EXPECT_THAT(ran.err, HasSubstr("error["));
}

TEST(Draw, NothingToDrawIsNoSuccess) {
    const TemporaryFile file("m.rct", "package p\n");
    EXPECT_EQ(run({"draw", file.path()}).exit, 2);
    EXPECT_EQ(run({"draw", "/nowhere"}).exit, 2);
    EXPECT_EQ(run({"draw"}).exit, 4);
}

TEST(Draw, OtherFormats) {
    const std::string model = repository("corpus/aggregation");
    EXPECT_THAT(run({"draw", model, "AggregationFSM", "--format", "mermaid"}).out, StartsWith("stateDiagram-v2\n"));
    EXPECT_THAT(run({"draw", model, "AggregationFSM", "--format", "dot"}).out, StartsWith("digraph "));
    EXPECT_EQ(run({"draw", model, "AggregationFSM", "--format", "gif"}).exit, 4);
    const Folder folder;
    EXPECT_EQ(run({"draw", model, "--format", "mermaid", "-o", folder.path()}).exit, 0);
    EXPECT_TRUE(fs::exists(folder / "AggregationFSM.mmd"));
}

TEST(Draw, ImagesAreMadeByRsvgConvert) {
    ROBOCHART_NEEDS(std::system("rsvg-convert --version > /dev/null 2>&1") == 0, "rsvg-convert (Debian: librsvg2-bin)");
    const std::string model = repository("corpus/aggregation");
    EXPECT_THAT(run({"draw", model, "AggregationFSM", "--format", "png"}).out, StartsWith("\x89PNG"));
    EXPECT_THAT(run({"draw", model, "AggregationFSM", "--format", "pdf"}).out, StartsWith("%PDF"));
}

/// Checks every diagram of both case studies: the chunks of PNG files with their checksums, and the objects of PDF
/// files.
TEST(Draw, ImagesAreAcceptedByProgramsThatReadThem) {
    for (const char* const program : {"rsvg-convert", "pngcheck", "pdfinfo"})
        ROBOCHART_NEEDS(std::system(("command -v " + std::string(program) + " > /dev/null 2>&1").c_str()) == 0,
                        std::string(program) + " (scripts/setup.sh installs it)");
    for (const std::string study : {"aggregation", "swarm_taxis"}) {
        const auto read = [&](const std::string& format, const std::string& reader) {
            const auto ran =
                testing::run_shell("\"$verify\" draw '" + repository("corpus/" + study) + "' --format " + format +
                                   " --out made > drawn 2>&1\n" + "for each in made/*." + format + "; do " + reader +
                                   " \"$each\" > said 2>&1 || cat said; done; "
                                   "ls made | wc -l");
            EXPECT_EQ(ran.err, "");
            EXPECT_GE(std::atoi(ran.out.c_str()), 4) << ran.out;
        };
        read("png", "pngcheck");
        read("pdf", "pdfinfo");
    }
}

TEST(Draw, WithoutRsvgConvertItSaysWhatToInstall) {
    const auto ran = testing::run_shell("PATH=/nowhere \"$verify\" draw '" + repository("corpus/aggregation") +
                                        "' AggregationFSM --format png");
    EXPECT_EQ(ran.exit, 2);
    EXPECT_EQ(ran.out, "");
    EXPECT_THAT(ran.err, HasSubstr("apt install librsvg2-bin"));
}

/// Names in a model cannot redirect files out of the folder, and a symbolic link in the folder is not followed.
TEST(Draw, FollowsNoLinkInTheFolder) {
    const std::vector<std::pair<std::string, std::string>> files{{"kept", "kept"}};
    const Folder folder(files);
    fs::create_directory(folder / "d");
    fs::create_symlink(folder / "kept", folder / "d/AggregationFSM.svg");
    EXPECT_EQ(run({"draw", repository("corpus/aggregation"), "-q", "-o", folder / "d"}).exit, 0);
    EXPECT_EQ(read_contents(folder / "kept"), "kept");
    EXPECT_THAT(read_contents(folder / "d/AggregationFSM.svg"), StartsWith("<svg "));
}

/// The pictures in docs/diagrams.md are identical to the program's output.
TEST(Draw, PicturesOfTheDocumentationAreUpToDate) {
    for (const auto& [component, picture] : {std::pair{"SwarmTaxisFSM", "machine"}, {"SwarmTaxis", "module"}})
        EXPECT_EQ(run({"draw", repository("corpus/swarm_taxis"), component}).out,
                  read_contents(repository(std::string("docs/pictures/swarm_taxis_") + picture + ".svg")))
            << component;
}

TEST(Draw, IsTheSameTwice) {
    EXPECT_EQ(run({"draw", repository("corpus/swarm_taxis"), "SwarmTaxisFSM"}).out,
              run({"draw", repository("corpus/swarm_taxis"), "SwarmTaxisFSM"}).out);
}

}  // namespace
}  // namespace robochart::app::draw_test
