// SPDX-License-Identifier: Apache-2.0
// Tests compiling and loading of code, and the messages for errors.
#include "conformance/code/shared_object.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/conformance/support.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::conformance {
namespace {

using testing::HasSubstr;

std::string error_of(const std::string& text, BuildOptions options = {}, const std::string& path = "a.cpp") {
    std::string error;
    EXPECT_FALSE(SharedObject::build({{path, text}}, {path}, options, error));
    return error;
}

TEST(SharedObject, LoadsAController) {
    std::string error;
    const auto object = test::hand_made("turner", 0, error);
    ASSERT_TRUE(object) << error;
    EXPECT_EQ(object->interface().inputs, 3U);
    EXPECT_STREQ(object->interface().component, "Turner");
}

TEST(SharedObject, TwoControllersStayApart) {
    std::string error;
    const auto one = test::hand_made("turner", 0, error);
    const auto two = test::hand_made("turner", 3, error);
    ASSERT_TRUE(one && two) << error;
    EXPECT_NE(&one->interface(), &two->interface());
    EXPECT_NE(one->interface().step, two->interface().step);
}

TEST(SharedObject, CompilerErrorsAreQuoted) {
    EXPECT_THAT(error_of("int f( {"), HasSubstr("a.cpp:1"));
}

// clang generates no unique symbols and rejects the option that disables them.
TEST(SharedObject, ClangIsAnotherCompiler) {
    if (std::system("clang++ --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "clang++ is not installed";
    BuildOptions options;
    options.compiler = "clang++";
    EXPECT_THAT(error_of("int f() { return 0; }", options), HasSubstr("no exploration interface"));
}

TEST(SharedObject, MissingCompiler) {
    BuildOptions options;
    options.compiler = "no-such-compiler";
    try {
        (void)error_of("", options);
        FAIL() << "it was compiled";
    } catch (const cpp_emit::NoCompiler& missing) {
        EXPECT_THAT(missing.what(), HasSubstr("cannot run no-such-compiler"));
    }
}

TEST(SharedObject, MissingInterface) {
    EXPECT_THAT(error_of("int f() { return 0; }"), HasSubstr("no exploration interface"));
}

TEST(SharedObject, WrongVersion) {
    std::string error;
    EXPECT_FALSE(test::hand_made("turner", 12, error));
    EXPECT_THAT(error, HasSubstr("version 10 where 9 is needed"));
}

TEST(SharedObject, UndefinedSymbol) {
    EXPECT_THAT(error_of("int g(); extern \"C\" int f() { return g(); }"), HasSubstr("cannot load"));
}

TEST(SharedObject, PathsStayInTheFolder) {
    EXPECT_THAT(error_of("", {}, "../a.cpp"), HasSubstr("outside"));
    EXPECT_THAT(error_of("", {}, "/a.cpp"), HasSubstr("outside"));
}

TEST(SharedObject, WorkFolderKeepsSources) {
    const tests::TemporaryFolder folder;
    BuildOptions options;
    options.work_dir = folder.in("work");
    (void)error_of("int f() { return 0; }", options);
    EXPECT_TRUE(std::filesystem::exists(folder.in("work/a.cpp")));
}

}  // namespace
}  // namespace robochart::conformance
