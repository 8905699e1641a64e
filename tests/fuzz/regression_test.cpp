// SPDX-License-Identifier: Apache-2.0
// Runs the targets on inputs that once violated a property of tests/fuzz/targets/targets.hpp, and on the examples
// stored next to them, with every compiler.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "tests/contents.hpp"
#include "tests/fuzz/targets/targets.hpp"
#include "tests/source_folder.hpp"

namespace robochart::fuzz {

static void PrintTo(const Target& target, std::ostream* out) {
    *out << target.name;
}

namespace {

using tests::read_contents;

namespace fs = std::filesystem;

const fs::path root = tests::source_folder();

std::vector<fs::path> files_of(const fs::path& folder) {
    std::vector<fs::path> result;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) result.push_back(entry.path());
    std::ranges::sort(result);
    return result;
}

class Regressions : public ::testing::TestWithParam<Target> {};

TEST_P(Regressions, KeepEveryPromise) {
    const auto files = files_of(root / "tests/fuzz/regressions" / GetParam().name);
    ASSERT_FALSE(files.empty());
    for (const fs::path& file : files) EXPECT_EQ(GetParam().run(read_contents(file)), "") << file;
}

/// Every prefix of a text is an input that occurs while the text is typed.
TEST_P(Regressions, KeepEveryPromiseWhileTyped) {
    for (const fs::path& file : files_of(root / "tests/fuzz/regressions" / GetParam().name)) {
        const std::string text = read_contents(file).substr(0, 2000);
        for (std::size_t length = 0; length < text.size(); length += 7)
            ASSERT_EQ(GetParam().run(text.substr(0, length)), "") << file << " until byte " << length;
    }
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Regressions, ::testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Regressions, EveryFolderHasItsTarget) {
    for (const auto& entry : fs::directory_iterator(root / "tests/fuzz/regressions")) {
        const std::string name = entry.path().filename().string();
        EXPECT_TRUE(std::ranges::any_of(targets(), [&](const Target& t) { return t.name == name; })) << name;
    }
}

TEST(Targets, TheCorpusKeepsEveryPromise) {
    for (const fs::path& file : files_of(root / "corpus")) {
        if (file.extension() == ".rct") {
            EXPECT_EQ(run_model(read_contents(file)), "") << file;
        }
        if (file.extension() == ".assertions") {
            EXPECT_EQ(run_assertions(read_contents(file)), "") << file;
        }
    }
}

}  // namespace
}  // namespace robochart::fuzz
