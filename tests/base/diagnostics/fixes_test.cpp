// SPDX-License-Identifier: Apache-2.0
// Tests how fixes are selected and applied.
#include "base/diagnostics/fixes.hpp"

#include <gtest/gtest.h>

#include "base/diagnostics/render.hpp"

namespace robochart::diagnostics {
namespace {

const Rule rule{"F1", Severity::error, "wrong"};

class Fixes : public ::testing::Test {
protected:
    void add(std::uint32_t begin, std::uint32_t end, std::string text, bool certain = true) {
        findings_.report(rule, {source_, begin, end})
            .fixes.push_back({{source_, begin, end}, std::move(text), certain ? "write" : "did you mean"});
    }
    [[nodiscard]] std::string fixed() const {
        return apply_fixes(sources_.source_text(source_), certain_fixes(findings_, source_));
    }

    SourceManager sources_;
    SourceId source_ = sources_.add("a.rct", "abcdef");
    Diagnostics findings_;
};

TEST_F(Fixes, ReplaceInsertAndRemoveInTheOrderOfTheText) {
    add(4, 5, "");
    add(0, 1, "AA");
    add(6, 6, "!");
    EXPECT_EQ(fixed(), "AAbcdf!");
}

TEST_F(Fixes, ThoseThatOverlapWaitForTheNextRun) {
    add(1, 4, "x");
    add(3, 5, "y");
    EXPECT_EQ(fixed(), "axef");
}

TEST_F(Fixes, TwoInsertionsAtOnePlaceAreNotBothMade) {
    add(2, 2, "x");
    add(2, 2, "y");
    EXPECT_EQ(fixed(), "abxcdef");
}

TEST_F(Fixes, NeighboursAreFreeOfEachOther) {
    add(0, 2, "x");
    add(2, 4, "y");
    EXPECT_EQ(fixed(), "xyef");
}

TEST_F(Fixes, SuggestionsAreNotApplied) {
    add(0, 1, "x", false);
    EXPECT_EQ(fixed(), "abcdef");
}

TEST_F(Fixes, OfOneFindingTheFirstAloneCounts) {
    Diagnostic& finding = findings_.report(rule, {source_, 0, 1});
    finding.fixes.push_back({{source_, 0, 1}, "x", "write"});
    finding.fixes.push_back({{source_, 3, 4}, "y", "or write"});
    EXPECT_EQ(fixed(), "xbcdef");
}

TEST_F(Fixes, ShowTheFixedLine) {
    add(2, 4, "XYZ");
    EXPECT_NE(render_text(sources_, findings_).find(" 1 | abXYZef\n   |   +++\n"), std::string::npos)
        << render_text(sources_, findings_);
}

TEST(RenderText, CountsWithGroupsAndSaysWhatIsNotShown) {
    Diagnostics out;
    for (int i = 0; i < 1324; ++i) out.report(rule, {});
    const std::string text = render_text(SourceManager{}, out);
    EXPECT_NE(text.find("200 shown of 1,324\n"), std::string::npos);
    EXPECT_NE(text.find("1,324 errors, 0 warnings\n"), std::string::npos);
}

}  // namespace
}  // namespace robochart::diagnostics
