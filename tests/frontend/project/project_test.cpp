// SPDX-License-Identifier: Apache-2.0
// Tests how models are loaded from paths: which files are loaded or rejected, and which files belong together.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/frontend/fixture.hpp"
#include "tests/rounds.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::frontend {
namespace {

namespace fs = std::filesystem;

class Project : public ::testing::Test {
protected:
    void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }
    /// Returns the names of the project's own loaded files (or of the libraries), then the codes of the findings.
    std::string load(const std::string& name = "", bool libraries = false) {
        reading_ = std::make_unique<testing::Reading>();
        const auto model = load_project(reading_->sources, folder_.in(name), reading_->findings);
        std::string files;
        for (const auto& file : model->files)
            if (file->is_library == libraries)
                files += fs::path(reading_->sources.path(file->source)).filename().string() + " ";
        for (const auto& d : reading_->findings.sorted_findings()) files += std::string(d.rule->code) + " ";
        return files;
    }

    tests::TemporaryFolder folder_;
    std::unique_ptr<testing::Reading> reading_;
};

TEST_F(Project, AFolderIsAProjectWithAllBelowIt) {
    write("b.rct", "type B");
    write("inner/a.rct", "type A");
    write("a.assertions", "csp S csp-begin csp-end assertion A1: S terminates");
    write(".hidden/x.rct", "type A");
    write("notes.txt", "not read");
    EXPECT_EQ(load(), "a.assertions b.rct a.rct ");
}

TEST_F(Project, SaysWhatIsMissing) {
    EXPECT_EQ(load("nowhere.rct"), "RC-F01 ");
    EXPECT_EQ(load(), "RC-F03 ");
    EXPECT_NE(reading_->report().find("contains no RoboChart files"), std::string::npos);
}

TEST_F(Project, BothDialectsShareTheirInterfaces) {
    write("a.rct", "stm S { uses Lamps initial i state A { } transition t { from i to A } }");
    write("parts.rst", "interface Lamps { event lamp }");
    EXPECT_EQ(load(), "a.rct parts.rst ");
    EXPECT_EQ(load("a.rct"), "a.rct parts.rst ");
    write("claims.rsa", "assertion A : S is deadlock-free");
    EXPECT_EQ(load("a.rct"), "a.rct parts.rst ") << "claims about RoboSim belong to models of RoboSim";
    EXPECT_EQ(load("parts.rst"), "parts.rst ") << "it needs nothing of a.rct";
    EXPECT_EQ(load("claims.rsa"), "a.rct claims.rsa parts.rst RC-Y11 ");
}

TEST_F(Project, AnEmptyFileIsAnError) {
    write("a.rct", "");
    EXPECT_EQ(load("a.rct"), "a.rct RC-F02 ");
    write("a.rct", "// nothing but this\n");
    EXPECT_EQ(load("a.rct"), "a.rct RC-F02 ");
    write("b.rct", "type B");
    EXPECT_EQ(load(), "a.rct b.rct RC-F04 ");
    EXPECT_TRUE(reading_->findings.ok());
}

TEST_F(Project, GarbageIsAnError) {
    write("a.rct", std::string("\x7F"
                               "ELF\x02\x01\0\0\0",
                               9));
    EXPECT_EQ(load("a.rct"), "a.rct RC-P08 ");
    write("a.rct", std::string(tests::size_of_input(10'000'000), 'x'));
    EXPECT_EQ(load("a.rct"), "a.rct RC-P01 ");
    EXPECT_LT(reading_->report().size(), 2000U);
}

TEST_F(Project, AFileBringsWhatItNeedsOfItsFolder) {
    write("main.rct",
          "package main import lib::* interface M { var v:T } stm S { initial i state s { } transition t { from i to s "
          "} }");
    write("lib.rct", "package lib import deep::* type T interface I { var d:D }");
    write("deep.rct", "package deep type D");
    write("other.rct", "package other type T stm S { nonsense }");
    write("main.assertions", "import main::* assertion A: S terminates");
    write("other.assertions", "assertion B: Q terminates");
    EXPECT_EQ(load("main.rct"), "deep.rct lib.rct main.assertions main.rct ");
    EXPECT_EQ(load("main.assertions"), "deep.rct lib.rct main.assertions main.rct ");
}

TEST_F(Project, UnnamedPackagesAreNeededByName) {
    write("a.rct", "stm S { uses I initial i state s { } transition t { from i to s } }");
    write("b.rct", "interface I { event e : E }");
    write("c.rct", "enumeration E { L }");
    write("d.rct", "stm S { } interface J { }");
    EXPECT_EQ(load("a.rct"), "a.rct b.rct c.rct ");
}

TEST_F(Project, ToolkitsComeWhenImported) {
    write("a.rct", "import sequence_toolkit::size interface I { const n:nat = size(<1>) }");
    EXPECT_EQ(load("", true),
              "core.rct sequence_toolkit.rct set_toolkit.rct relation_toolkit.rct function_toolkit.rct ");
    EXPECT_TRUE(reading_->findings.empty()) << reading_->report();
    write("a.rct", "type A");
    EXPECT_EQ(load("", true), "core.rct ");
}

TEST_F(Project, AMissingPackageIsAWarning) {
    write("a.rct", "import Nowhere::* type A");
    EXPECT_EQ(load(), "a.rct RC-N04 ");
    EXPECT_TRUE(reading_->findings.ok());
}

TEST_F(Project, APackageOfAnotherFileIsKnown) {
    write("a.rct", "import inner::* import inner::b::B import inner::b type A");
    write("b.rct", "package inner::b type B");
    write("c.rct", "package inner type C");
    EXPECT_EQ(load(), "a.rct b.rct c.rct ");
}

TEST_F(Project, APackageThatWasNotReadIsNotMissed) {
    write("a.rct", "import inner::* type A");
    write("b.rct", "package :: type B");
    EXPECT_EQ(load(), "a.rct b.rct RC-P01 ");
}

TEST_F(Project, AnUnreadableFileDoesNotHideTheOthers) {
    write("a.rct", "type A");
    fs::create_symlink(folder_.in("gone.rct"), folder_.in("b.rct"));
    EXPECT_EQ(load(), "a.rct RC-F01 ");
}

}  // namespace
}  // namespace robochart::frontend
