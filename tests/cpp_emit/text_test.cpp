// SPDX-License-Identifier: Apache-2.0
// Tests names and layout of generated text.
#include <gtest/gtest.h>

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/plan/names.hpp"
#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit::text_test {
namespace {

TEST(Names, BecomeIdentifiers) {
    EXPECT_EQ(to_identifier("O::P"), "O_P");
    EXPECT_EQ(to_identifier("__x__"), "x_");
    EXPECT_EQ(to_identifier("2d"), "n2d");
    EXPECT_EQ(to_identifier(""), "unnamed");
    EXPECT_EQ(to_identifier("caf\xc3\xa9"), "caf_");
}

TEST(Names, AvoidKeywordsAndEachOther) {
    NameScope scope({"at"});
    EXPECT_EQ(scope.unique_name("class"), "class_");
    EXPECT_EQ(scope.unique_name("class"), "class_2");
    EXPECT_EQ(scope.unique_name("at"), "at_2");
    EXPECT_EQ(scope.unique_name("x"), "x");
    EXPECT_EQ(scope.numbered_name("x"), "x_1");
    EXPECT_EQ(scope.numbered_name("x"), "x_2");
}

TEST(CodeWriter, IndentsBlocks) {
    CodeWriter out;
    out.open("if (a) {");
    out.line("b();");
    out.reopen_block("} else {");
    out.line("c();");
    out.close();
    EXPECT_EQ(out.text(), "if (a) {\n    b();\n} else {\n    c();\n}\n");
}

TEST(CodeWriter, LeavesOneGapAndNoneAtTheBeginning) {
    CodeWriter out;
    out.gap();
    out.line("a");
    out.gap();
    out.gap();
    out.open("{");
    out.gap();
    out.line("b");
    out.close();
    EXPECT_EQ(out.text(), "a\n\n{\n    b\n}\n");
}

TEST(CodeWriter, WrapsComments) {
    CodeWriter out;
    out.comment(std::string(100, 'x') + " " + std::string(100, 'y'));
    EXPECT_EQ(out.text(), "// " + std::string(100, 'x') + "\n// " + std::string(100, 'y') + "\n");
}

TEST(Decimals, HaveAPoint) {
    EXPECT_EQ(decimal_text({-75, 2}), "-0.75");
    EXPECT_EQ(decimal_text({5, 3}), "0.005");
    EXPECT_EQ(decimal_text({3, 0}), "3.0");
    EXPECT_EQ(decimal_text({-1088, 2}), "-10.88");
}

}  // namespace
}  // namespace robochart::cpp_emit::text_test
