// SPDX-License-Identifier: Apache-2.0
// Tests that modules with equal text become instances of one parameterised module. They keep their names, if names in
// the text keep their meaning.
#include "csp_emit/passes/shared_modules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "tests/csp_emit/fixture.hpp"
#include "tests/nested_instances.hpp"
#include "tests/source_folder.hpp"

namespace robochart::csp_emit::shared_modules_test {
namespace {

namespace b = cspm::build;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// A text that is long enough to be worth sharing.
const std::string body = R"(
    datatype TIDS = TID_t0 | TID_t1 | TID_t2 | TID_t3 | TID_t4 | TID_t5 | TID_t6 | TID_t7 | TID_t8 | TID_t9
    channel internal__ : TIDS
    channel reported, heard : limit_type
    module S
    exports
        channel entered
    endmodule
    first_state_of_the_machine__ = internal__.TID_t0 -> S::entered -> second_state_of_the_machine__(0)
    second_state_of_the_machine__(v) =
        reported!v -> second_state_of_the_machine__((v + 1) % 3)
        [] heard?x -> second_state_of_the_machine__(x)
        [] internal__.TID_t1 -> first_state_of_the_machine__
    D__(id__) = first_state_of_the_machine__ \ {| internal__ |}
endmodule
)";
const std::string types = "nametype limit_type = {0..2}\n";

cspm::Script parse_script(const std::string& text) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    return cspm::read(sources, sources.add("t.csp", text), diagnostics);
}

std::string in_module(const std::string& name, const std::string& inside) {
    return "module " + name + "\nexports\n" + inside + "endmodule\n";
}

TEST(SharedModules, AreWrittenOnce) {
    const std::string machine = "module M\nexports" + body;
    const cspm::Script before = parse_script(types + machine + in_module("C", "channel c\nmodule m\nexports" + body));
    const cspm::Script after{share_modules(before.decls, {})};
    const std::string text = cspm::print(after);
    EXPECT_THAT(text, HasSubstr("module M__(u__)"));
    EXPECT_THAT(text, HasSubstr("\ninstance M = M__(0)\n"));
    EXPECT_THAT(text, HasSubstr("\n    instance m = M__(0)\n"));
    EXPECT_LT(text.find("module M__"), text.find("module C"));
}

TEST(SharedModules, StandWhereAllTheirUsersSeeThem) {
    const cspm::Script before =
        parse_script(types + in_module("P", "module m\nexports" + body + "module n\nexports" + body));
    const std::string text = cspm::print(cspm::Script{share_modules(before.decls, {})});
    EXPECT_THAT(text, HasSubstr("\n    module m__(u__)"));
    EXPECT_THAT(text, HasSubstr("\n    instance n = m__(0)"));
}

TEST(SharedModules, AreThoseThatSaveTheMost) {
    const std::string controller = "channel c\nmodule m\nexports" + body;
    const cspm::Script before = parse_script(types + in_module("C", controller) + in_module("D", controller));
    const std::string text = cspm::print(cspm::Script{share_modules(before.decls, {})});
    EXPECT_THAT(text, HasSubstr("module C__(u__)"));
    EXPECT_THAT(text, Not(HasSubstr("m__(u__)")));
}

// The machine occurs alone, in its controller, and in the controller of a module, so it is shared. A controller that
// contains an instance is not shared.
TEST(SharedModules, HaveNoInstancesInside) {
    const std::string machine = "module m\nexports" + body;
    const std::string controller = in_module("C", "channel c\n" + machine);
    const cspm::Script before = parse_script(types + machine + controller + in_module("D", controller));
    const cspm::Script after{share_modules(before.decls, {})};
    const std::string text = cspm::print(after);
    EXPECT_EQ(tests::nested_instances(after.decls), std::vector<std::string>{}) << text;
    EXPECT_THAT(text, HasSubstr("\ninstance m = m__(0)\n"));
    EXPECT_THAT(text, HasSubstr("\n    instance m = m__(0)\n"));
    EXPECT_THAT(text, HasSubstr("\n        instance m = m__(0)\n"));
    EXPECT_THAT(text, Not(HasSubstr("C__(u__)")));
}

TEST(SharedModules, OfTheCorpusHaveNoInstancesInside) {
    std::set<std::filesystem::path> folders;
    for (const auto& file : std::filesystem::recursive_directory_iterator(robochart::tests::source_folder() / "corpus"))
        if (file.path().extension() == ".rct") folders.insert(file.path().parent_path());
    for (const std::filesystem::path& folder : folders) {
        const auto model = testing::project(folder.string());
        ASSERT_TRUE(model->diagnostics.ok()) << folder << model->messages();
        for (const Time time : {Time::untimed, Time::timed})
            EXPECT_EQ(tests::nested_instances(model->emit(time, true).script.decls), std::vector<std::string>{})
                << folder;
    }
    EXPECT_GE(folders.size(), 6U);
}

// Inside C the name denotes another type.
TEST(SharedModules, AreNotWhereANameMeansSomethingElse) {
    const std::string machine = "module M\nexports" + body;
    const cspm::Script before =
        parse_script(types + machine + in_module("C", "nametype limit_type = {0..1}\nmodule m\nexports" + body));
    EXPECT_THAT(cspm::print(cspm::Script{share_modules(before.decls, {})}), Not(HasSubstr("instance")));
}

TEST(SharedModules, KeepNamesAndProcesses) {
    const std::string machine = "module M\nexports" + body;
    const cspm::Script before = parse_script(types + machine + in_module("C", "module m\nexports" + body));
    cspm::Script after{share_modules(before.decls, {})};
    std::vector<cspm::DeclPtr> old;
    for (const cspm::DeclPtr& decl : before.decls)
        if (decl->kind == cspm::DeclKind::module) old.push_back(decl);
    after.decls.push_back(b::module_("before", {}, {}, old));
    for (const std::string path : {"M", "C::m"}) {
        std::vector<cspm::Link> links;
        for (const std::string event : {"::reported", "::heard", "::S::entered"})
            links.push_back({b::name("before::" + path + event), b::name(path + event)});
        const auto mine = b::call(path + "::D__", {b::number(0)});
        const auto theirs = b::rename(b::call("before::" + path + "::D__", {b::number(0)}), links);
        after.decls.push_back(b::assert_refines(mine, cspm::Model::failures_divergences, theirs));
        after.decls.push_back(b::assert_refines(theirs, cspm::Model::failures_divergences, mine));
    }
    EXPECT_THAT(testing::decide_script(after), ElementsAre("holds", "holds", "holds", "holds"));
}

}  // namespace
}  // namespace robochart::csp_emit::shared_modules_test
