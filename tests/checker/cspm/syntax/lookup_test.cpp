// SPDX-License-Identifier: Apache-2.0
// Tests that qualified names find their declarations in modules, timed sections and instances.
#include "checker/cspm/syntax/lookup.hpp"

#include <gtest/gtest.h>

#include "tests/checker/cspm/support.hpp"

namespace robochart::cspm::test {
namespace {

constexpr const char* text = R"(
channel top
module T(n)
    hidden = 1
exports
    channel inside
    module Deep
    exports
        deepest(x) = x
        deepest(_) = 0
    endmodule
endmodule
module M
exports
    module T2
    exports
        nametype N = {0}
    endmodule
    instance of_outer = T(0)
    instance of_own = T2
endmodule
instance alone = T(1)
instance twice = alone
OneStep(_) = 0
Timed(OneStep) {
    Later = STOP
}
)";

class Lookup : public ::testing::Test {
protected:
    DeclKind kind(const std::string& path) {
        const DeclPtr found = declaration_of(reading_.script, path);
        EXPECT_TRUE(found) << path;
        return found ? found->kind : DeclKind::assertion;
    }
    Reading reading_{text};
};

TEST_F(Lookup, FindsDeclarationsOfEveryKind) {
    EXPECT_EQ(kind("top"), DeclKind::channel);
    EXPECT_EQ(kind("::top"), DeclKind::channel);
    EXPECT_EQ(kind("T"), DeclKind::module);
    EXPECT_EQ(kind("T::hidden"), DeclKind::value);
    EXPECT_EQ(kind("T::Deep::deepest"), DeclKind::function);
    EXPECT_EQ(kind("Later"), DeclKind::value);
    EXPECT_EQ(kind("M::T2::N"), DeclKind::nametype);
}

TEST_F(Lookup, FollowsInstancesToTheirModules) {
    EXPECT_EQ(kind("M::of_outer"), DeclKind::instance);
    EXPECT_EQ(kind("M::of_outer::inside"), DeclKind::channel);
    EXPECT_EQ(kind("M::of_outer::Deep::deepest"), DeclKind::function);
    EXPECT_EQ(kind("M::of_own::N"), DeclKind::nametype);
}

TEST_F(Lookup, FindsNothingElse) {
    for (const char* path : {"", "nothing", "T::top", "M::inside", "top::inside", "twice::inside", "M::", "::"})
        EXPECT_FALSE(declaration_of(reading_.script, path)) << path;
}

}  // namespace
}  // namespace robochart::cspm::test
