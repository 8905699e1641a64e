// SPDX-License-Identifier: Apache-2.0
// Tests that resolution may run repeatedly on the same trees, and after some trees were replaced.
#include <gtest/gtest.h>

#include "frontend/syntax/parse.hpp"
#include "tests/frontend/fixture.hpp"
#include "tests/source_folder.hpp"

namespace robochart::frontend {
namespace {

using diagnostics::Diagnostics;
using diagnostics::SourceManager;

/// Returns the resolved model as text: the dump with targets and types, and every finding.
std::string texts_of(const Model& model, const SourceManager& sources, const Diagnostics& findings) {
    return dump_model(model, sources, true) + diagnostics::render_text(sources, findings);
}

std::string resolve_again(Model& model, SourceManager& sources) {
    Diagnostics findings;
    update_toolkits(sources, model, findings);
    resolve(model, findings);
    return texts_of(model, sources, findings);
}

void expect_repeatable(const std::string& path) {
    SourceManager sources;
    Diagnostics first;
    const auto model = load_project(sources, path, first);
    const std::string once = resolve_again(*model, sources);
    EXPECT_EQ(once, resolve_again(*model, sources)) << path;
    const std::string fresh = dump_model(*model, sources, true);
    EXPECT_EQ(once.substr(0, fresh.size()), fresh) << path;
}

TEST(Rerun, TwiceIsOnceForTheCorpus) {
    for (const auto& entry : std::filesystem::directory_iterator(tests::source_folder().string() + "/corpus"))
        expect_repeatable(entry.path().string());
}

TEST(Rerun, TwiceIsOnceForTheFixtures) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(tests::source_folder().string() + "/tests/frontend/fixtures"))
        if (entry.path().extension() == ".rct") expect_repeatable(entry.path().string());
}

TEST(Rerun, TwiceIsOnceForTheSuites) {
    const auto shared = testing::shared_folder();
    if (shared.empty()) GTEST_SKIP() << "the shared material is absent";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(shared / "suite"))
        if (entry.path().extension() == ".rct") expect_repeatable(entry.path().string());
}

constexpr const char* user =
    "import set_toolkit::*\n"
    "stm S { requires I var b : E = first initial i state A { entry x = 1; b = E::second }\n"
    "transition t { from i to A condition size({x}) == 1 } }\n"
    "controller C { requires I sref s = S connection C on e to s on e }\n";
constexpr const char* library = "interface I { var x : nat }\nenumeration E { first second }\n";

/// A file to which others refer is replaced by another file. The result equals that of a newly loaded project.
TEST(Rerun, AfterAFileWasReplaced) {
    const auto build = [](SourceManager& sources, const std::string& second) {
        Model model;
        Diagnostics ignored;
        model.files.push_back(parse(sources, sources.add("user.rct", user), false, ignored));
        model.files.push_back(parse(sources, sources.add("library.rct", second), false, ignored));
        return model;
    };
    for (const std::string replacement :
         {"", "interface I { var x : E }\nenumeration E { first second }\n", "interface I { var y : nat }\n",
          "interface I { event x }\ntype E\n", "controller I { } interface E { }", "interface I { var x : nat }\n"}) {
        SourceManager sources;
        Model model = build(sources, library);
        resolve_again(model, sources);
        Diagnostics ignored;
        sources.replace(model.files[1]->source, replacement);
        model.files[1] = parse(sources, model.files[1]->source, false, ignored);
        const std::string changed = resolve_again(model, sources);

        SourceManager anew;
        Model fresh = build(anew, replacement);
        EXPECT_EQ(changed, resolve_again(fresh, anew)) << replacement;
    }
}

TEST(Rerun, ToolkitsComeAndGoWithTheirImports) {
    SourceManager sources;
    Diagnostics findings;
    Model model;
    const auto source = sources.add("t.rct", "import sequence_toolkit::*\n");
    model.files.push_back(parse(sources, source, false, findings));
    update_toolkits(sources, model, findings);
    const std::size_t with = model.files.size();
    ASSERT_GT(with, 1U);
    const File* tree = model.files[1].get();
    update_toolkits(sources, model, findings);
    EXPECT_EQ(model.files.size(), with);
    EXPECT_EQ(model.files[1].get(), tree) << "a toolkit that stays is not read again";
    const std::size_t texts = sources.size();
    for (int i = 0; i < 3; ++i)
        for (const char* text : {"", "import sequence_toolkit::*\n"}) {
            sources.replace(source, text);
            model.files[0] = parse(sources, source, false, findings);
            update_toolkits(sources, model, findings);
            EXPECT_EQ(model.files.size(), *text == '\0' ? 2U : with) << "core is always there";
        }
    EXPECT_EQ(sources.size(), texts) << "texts of toolkits are added once";
}

}  // namespace
}  // namespace robochart::frontend
