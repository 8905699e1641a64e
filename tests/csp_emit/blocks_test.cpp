// SPDX-License-Identifier: Apache-2.0
// Tests the checks of CSP blocks for which no assertion is decided. Findings have places in the block and use the names
// of the script.
#include <gtest/gtest.h>

#include "base/diagnostics/render.hpp"
#include "csp_emit/blocks/check_blocks.hpp"
#include "csp_emit/blocks/script_names.hpp"
#include "frontend/project/project.hpp"

namespace robochart::csp_emit::blocks_test {
namespace {

const std::string model_text =
    "package lamp\ninterface Signals { event press event shine }\n"
    "stm Switch { uses Signals initial i state Off { } state On { entry shine }\n"
    "transition t { from i to Off } transition u { from Off to On trigger press } }\n";

/// Checks a block of an assertion file about the lamp, and stores its findings.
class Checked {
public:
    explicit Checked(const std::string& claims, const std::string& rct = model_text) {
        const auto model_source = sources_.add("lamp.rct", rct);
        claims_ = sources_.add("lamp.assertions", claims);
        model_ = frontend::load_texts(sources_, {model_source, claims_}, reading_);
        check_blocks(*model_, sources_, findings_);
    }
    [[nodiscard]] std::string report() const { return diagnostics::render_text(sources_, findings_); }
    /// Returns "CODE@line" of each finding.
    [[nodiscard]] std::string codes() const {
        std::string result;
        for (const diagnostics::Diagnostic& finding : findings_.sorted_findings()) {
            EXPECT_EQ(finding.span.source, claims_);
            result += (result.empty() ? "" : " ") + std::string(finding.rule->code) + "@" +
                      std::to_string(sources_.position(finding.span.source, finding.span.begin).line);
        }
        return result;
    }
    [[nodiscard]] std::optional<Emission> without_blocks() const {
        return emission_without_blocks(*model_, sources_, claims_, Time::timed, nullptr);
    }

private:
    diagnostics::SourceManager sources_;
    diagnostics::SourceId claims_;
    diagnostics::Diagnostics reading_, findings_;
    std::unique_ptr<frontend::Model> model_;
};

std::string block_text(const std::string& body, const std::string& kind = "timed ") {
    return "package claims\nimport lamp::*\n" + kind + "csp P csp-begin\n" + body + "\ncsp-end\n" + kind +
           "assertion A : lamp::Switch refines P in the traces model\n";
}

TEST(Blocks, InOrderGiveNothing) {
    for (const char* kind : {"timed ", "untimed ", ""}) {
        const Checked checked(block_text("P = lamp::Switch::press.in -> P", kind));
        EXPECT_EQ(checked.codes(), "") << checked.report();
    }
}

TEST(Blocks, AnUnknownNameIsReportedOnceWithWhatIsMeant) {
    const Checked bare(block_text("P = press -> P", ""));
    EXPECT_EQ(bare.codes(), "CSPM-T01@4") << bare.report();
    EXPECT_NE(bare.report().find("`lamp::Switch::press.in`"), std::string::npos) << bare.report();
    const Checked misspelt(block_text("P = lamp::Switch::prss.in -> P"));
    EXPECT_EQ(misspelt.codes(), "CSPM-T01@4") << misspelt.report();
    EXPECT_NE(misspelt.report().find("`lamp::Switch::press.in`"), std::string::npos) << misspelt.report();
}

TEST(Blocks, SyntaxIsReadEvenIfTheModelHasErrors) {
    const std::string wrong = block_text("P = lamp::Switch::press.in ->");
    EXPECT_EQ(Checked(wrong).codes().substr(0, 8), "CSPM-P01") << Checked(wrong).report();
    const Checked both(wrong, model_text + "interface J { var x : Nothing }\n");
    EXPECT_EQ(both.codes().substr(0, 8), "CSPM-P01") << both.report();
}

/// Only the claim shows that the process is used as an event.
TEST(Blocks, ATypeErrorOfAClaimHasItsPlace) {
    const Checked checked(block_text("P = lamp::Switch::press.in --> P"));
    EXPECT_EQ(checked.codes(), "CSPM-P18@4 CSPM-T08@6") << checked.report();
}

TEST(Blocks, CanWriteTheNamesOfTheScript) {
    const auto emission = Checked(block_text("P = unknown")).without_blocks();
    ASSERT_TRUE(emission);
    const ScriptNames names(emission->definitions);
    const auto has = [&](const std::string& qualifier, const std::string& name) {
        for (const ScriptName* candidate : names.names_after(qualifier))
            if (candidate->name == name) return true;
        return false;
    };
    EXPECT_TRUE(has("", "lamp"));
    EXPECT_TRUE(has("lamp", "Switch"));
    EXPECT_TRUE(has("lamp::Switch", "press"));
    EXPECT_TRUE(has("lamp::Switch", "D__"));
    EXPECT_FALSE(has("lamp::Switch", "nothing"));
}

}  // namespace
}  // namespace robochart::csp_emit::blocks_test
