// A verdict is never silently about a smaller model: where arithmetic left its type or a function without a body was
// asked, the report says so, and it says nothing where no explored state does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"

namespace robochart::app::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// x counts to 3; the guard of t2 doubles it: 2 * 2 is not in 0..3. t3 is never enabled, so x + 9 is never evaluated.
const char* const machine = R"(
function f(x : nat) : nat { }
stm S {
  event a : nat
  event b
  event c
  var x : nat = 0
  initial i
  state A { }
  state B { entry a ! f(x) }
  transition t0 { from i to A }
  transition t1 { from A to A trigger b condition x < 3 action x = x + 1 }
  transition t2 { from A to B trigger c condition x * 2 == 2 }
  transition t3 { from B to B trigger c condition x > 3 action x = x + 9 }
}
)";

class Bounds : public ::testing::Test {
protected:
    nlohmann::json check(const std::string& assertions, const std::vector<std::string>& options = {}) {
        const TemporaryFile model("bounds.rct", machine);
        const std::string folder = std::filesystem::path(model.path()).parent_path().string();
        std::ofstream(folder + "/bounds.assertions") << assertions;
        std::vector<std::string> arguments{"check", folder, "--format", "json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Ran ran = run(arguments);
        const auto report = nlohmann::json::parse(ran.out, nullptr, false);
        EXPECT_FALSE(report.is_discarded()) << ran.out << ran.err;
        return report.is_discarded() ? nlohmann::json::object() : report["bounds"];
    }
};

TEST_F(Bounds, AreReportedWithElementAndPlace) {
    const auto bounds = check("assertion A : S is divergence-free\n", {"--range", "nat=0..3"});
    ASSERT_EQ(bounds.size(), 2U) << bounds;
    const std::string all = bounds.dump();
    EXPECT_THAT(all, HasSubstr("in x * 2 == 2, 2 * 2 leaves its type and is taken as 2"));
    EXPECT_THAT(all, HasSubstr("\"element\":\"S::t2\""));
    EXPECT_THAT(all, HasSubstr("bounds.rct:13"));
    EXPECT_THAT(all, HasSubstr("in f(x), f has no body here and is taken as 0"));
    EXPECT_THAT(all, HasSubstr("bounds.rct:10"));
    for (const auto& bound : bounds) EXPECT_EQ(bound["time"], "untimed, timed");
}

TEST_F(Bounds, AreNotReportedWhereNoneIsReached) {
    // With a carrier that includes 3 * 2 only the function remains; with a body for it in the instantiations, nothing
    // does.
    const auto wide = check("untimed assertion A : S is divergence-free\n", {"--range", "nat=0..9"});
    ASSERT_EQ(wide.size(), 1U) << wide;
    EXPECT_EQ(wide[0]["element"], "S::B");
    EXPECT_EQ(wide[0]["time"], "untimed");
    const auto none = check(
        "untimed assertion A : S is divergence-free\n"
        "csp Instantiations csp-begin\nf(x__) = x__\ncsp-end\n",
        {"--range", "nat=0..9"});
    EXPECT_EQ(none.size(), 0U) << none;
    // Without assertions core properties are checked, which are about the same states.
    EXPECT_EQ(check("").size(), 1U);
}

TEST_F(Bounds, AreInTheTextAlthoughQuiet) {
    const TemporaryFile model("quiet.rct", machine);
    const std::string folder = std::filesystem::path(model.path()).parent_path().string();
    std::ofstream(folder + "/quiet.assertions") << "untimed assertion A : S is divergence-free\n";
    const Ran ran = run({"check", folder, "--quiet", "--range", "nat=0..3"});
    EXPECT_EQ(ran.exit, 0);
    EXPECT_THAT(ran.out, AllOf(HasSubstr("about a smaller model"), HasSubstr("S::t2: in x * 2 == 2, 2 * 2 leaves"),
                               Not(HasSubstr("x + 9"))));
}

/// With its package, and of several parts with components of one name with the part in front.
TEST_F(Bounds, NameTheComponent) {
    const Folder folder(
        {{"a.rct", "package a\n" + std::string(machine)}, {"b.rct", "package b\n" + std::string(machine)}});
    const Ran ran = run({"check", folder.path(), "--untimed", "--quiet", "--range", "nat=0..3"});
    EXPECT_THAT(ran.out, AllOf(HasSubstr("a::S::t2: in x * 2 == 2"), HasSubstr("b::S::t2: in x * 2 == 2"))) << ran.err;
}

}  // namespace
}  // namespace robochart::app::testing
