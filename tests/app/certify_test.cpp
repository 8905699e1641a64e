// SPDX-License-Identifier: Apache-2.0
// Tests `--certify`: what the report says about certificates, and the exit codes. A short program replaces
// robochart-certify, so its answers are known. tests/checker/certify contains tests of the program itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"

namespace robochart::app::testing::certify_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Runs commands in a folder with a script whose two assertions hold. The first has a certificate. `answer` is what
/// robochart-certify prints.
Ran run_with_answer(const std::string& answer, const std::string& commands) {
    return run_shell("mkdir bin\nprintf '#!/bin/sh\\n[ \"$1\" = --answer ] && [ -f \"$2/claim.txt\" ] && echo \"" +
                     answer +
                     "\"\\n' > bin/robochart-certify\nchmod +x bin/robochart-certify\nexport PATH=\"$PWD/bin:$PATH\"\n"
                     "printf 'channel a\\nP = a -> P\\nassert P [FD= P\\nassert P :[has trace]: <a>\\n' > s.csp\n" +
                     commands);
}

TEST(Certify, ReportsSayCertifiedOnlyWithTheLevel) {
    const Ran ran = run_with_answer("certified 1739 6", "\"$verify\" cspm s.csp --no-cache --certify certs");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("holds (certified: term level, unreduced, 1,739 pairs, 6 components); certificate "
                                   "certs/1-P-FD-P\n"));
    EXPECT_THAT(ran.out, HasSubstr("no certificate: there are no certificates for `has trace` in the models F and FD"));
    EXPECT_THAT(ran.out, Not(HasSubstr("proved")));
}

TEST(Certify, ReportsSayHowTheSearchWasReduced) {
    const Ran ran =
        run_with_answer("certified 8191 12 confluent taus", "\"$verify\" cspm s.csp --no-cache --certify certs");
    EXPECT_THAT(ran.out,
                HasSubstr("holds (certified: term level, 8,191 pairs, reduced by confluent taus, 12 components); "
                          "certificate certs/1-P-FD-P\n"));
    const Ran json = run_with_answer("certified 8191 12 confluent taus",
                                     "\"$verify\" cspm s.csp --no-cache --certify certs --format json");
    const nlohmann::json certificate = nlohmann::json::parse(json.out).at("results").at(0).at("certificate");
    EXPECT_EQ(certificate.at("reduced"), true) << json.out;
    EXPECT_EQ(certificate.at("reduction"), "confluent taus") << json.out;
}

TEST(Certify, JsonHasTheFigures) {
    const Ran ran = run_with_answer("certified 1 1", "\"$verify\" cspm s.csp --no-cache --certify certs --format json");
    const nlohmann::json certificate = nlohmann::json::parse(ran.out).at("results").at(0).at("certificate");
    const nlohmann::json expected{{"level", "term"},   {"reduced", false}, {"folders", {"certs/1-P-FD-P"}},
                                  {"certified", true}, {"pairs", 1},       {"components", 1}};
    EXPECT_EQ(certificate, expected) << ran.out;
}

TEST(Certify, ReportsSayWhyACertificateIsAtTheProductLevel) {
    const std::string script =
        "printf 'external chase\\nchannel a\\nQ = a -> Q\\nP = chase(Q)\\nassert P [FD= P\\n' > s.csp\n";
    const Ran ran = run_with_answer("certified 1 1", script + "\"$verify\" cspm s.csp --no-cache --certify certs");
    EXPECT_THAT(ran.out, HasSubstr("holds (certified: product level, unreduced, 1 pair, 1 component; not at the term "
                                   "level, because it uses chase); certificate certs/1-P-FD-P\n"));
    const Ran json =
        run_with_answer("certified 1 1", script + "\"$verify\" cspm s.csp --no-cache --certify certs --format json");
    const nlohmann::json certificate = nlohmann::json::parse(json.out).at("results").at(0).at("certificate");
    EXPECT_EQ(certificate.at("level"), "product");
    EXPECT_EQ(certificate.at("why_product_level"), "it uses chase");
}

TEST(Certify, PagesSayCertified) {
    const Ran ran = run_shell(
        "mkdir bin m\nprintf '#!/bin/sh\\necho \"certified 12 1\"\\n' > bin/robochart-certify\nchmod +x "
        "bin/robochart-certify\nexport PATH=\"$PWD/bin:$PATH\"\n"
        "echo 'stm Walker { event e initial i state A { } transition t0 { from i to A } transition t1 { from A to A "
        "trigger e } }' > m/m.rct\necho 'assertion Moves : Walker is deadlock-free' > m/m.assertions\n"
        "\"$verify\" check m --assertion Moves --no-cache --certify certs --html page.html && cat page.html");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("<br>holds (certified: term level, unreduced, 12 pairs, 1 component); certificate"));
}

/// If a certificate is refused, the answer of the search is wrong, so the run must not succeed.
TEST(Certify, ARefusedCertificateIsAnError) {
    const Ran ran =
        run_with_answer("refused after <a>, it can do nothing", "\"$verify\" cspm s.csp --no-cache --certify certs");
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.out, HasSubstr("REFUSED by robochart-certify: after <a>, it can do nothing"));
    EXPECT_THAT(ran.out, Not(HasSubstr("certified:")));
}

TEST(Certify, ACertificateIsNotCheckedWithoutTheProgram) {
    const Ran undecided =
        run_with_answer("undecided there are more than 5 pairs", "\"$verify\" cspm s.csp --no-cache --certify certs");
    EXPECT_EQ(undecided.exit, 0);
    EXPECT_THAT(undecided.out, HasSubstr("certificate certs/1-P-FD-P, not checked: there are more than 5 pairs\n"));
    const Ran none = run_with_answer(
        "", "rm bin/robochart-certify; PATH=/nowhere; \"$verify\" cspm s.csp --no-cache --certify certs");
    EXPECT_EQ(none.exit, 0);
    EXPECT_THAT(none.out, HasSubstr("certificate certs/1-P-FD-P, not checked: cannot run robochart-certify"));
    const Ran mute = run_with_answer("", "\"$verify\" cspm s.csp --no-cache --certify certs");
    EXPECT_THAT(mute.out, HasSubstr("not checked: robochart-certify did not answer"));
}

TEST(Certify, AFullDiskIsAnErrorAndLeavesNoCertificate) {
    const Ran ran = run_with_answer("certified 1 1",
                                    "ulimit -f 0\n\"$verify\" cspm s.csp --no-cache --certify certs | cat; "
                                    "find certs -name claim.txt");
    EXPECT_THAT(ran.out, Not(HasSubstr("claim.txt")));
    EXPECT_THAT(ran.out, Not(HasSubstr("certified:")));
    const Ran exit =
        run_with_answer("certified 1 1", "ulimit -f 0\n\"$verify\" cspm s.csp --no-cache --certify certs > /dev/null");
    EXPECT_EQ(exit.exit, 2) << exit.err;
}

/// Runs `conform --certify certs` on a machine whose code conforms, and on one that cannot run in cycles.
Ran conform_with_answer(const std::string& answer, const std::string& options) {
    return run_shell(
        "mkdir bin m\nprintf '#!/bin/sh\\necho \"" + answer +
        "\"\\n' > bin/robochart-certify\nchmod +x bin/robochart-certify\nexport PATH=\"$PWD/bin:$PATH\"\n"
        "echo 'stm Walker { event e initial i state A { } transition t0 { from i to A } transition t1 { from A to A "
        "trigger e } } stm Loop { event e initial i state A { } transition t0 { from i to A } transition t1 { from A "
        "to A } }' > m/m.rct\n\"$verify\" conform m --no-cache --certify certs " +
        options);
}

TEST(Certify, CodeThatConformsIsCertified) {
    const Ran ran = conform_with_answer("certified 1739 1", "; ls certs certs/*");
    EXPECT_THAT(ran.out, HasSubstr("conforms (certified: product level, unreduced, 1,739 pairs, 1 component); "
                                   "certificate certs/1-code-of-Walker\n"));
    EXPECT_THAT(ran.out, HasSubstr("still trusted: that the code does what the table of the certificate states, which "
                                   "robochart-replay checks, "));
    EXPECT_THAT(ran.out, HasSubstr("NOT SCHEDULABLE Loop"));
    EXPECT_THAT(ran.out, Not(HasSubstr("code-of-Loop")));
    for (const char* file : {"claim.txt", "specification.txt", "implementation.txt", "code.txt", "model.csp", "code"})
        EXPECT_THAT(ran.out, HasSubstr(std::string("\n") + file + "\n"));
}

TEST(Certify, JsonAndPagesSayWhatIsTrustedAboutCode) {
    const Ran ran = conform_with_answer("certified 12 1", "--component Walker --format json --html page.html");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    const nlohmann::json certificate = nlohmann::json::parse(ran.out).at("conformance").at(0).at("certificate");
    EXPECT_EQ(certificate.at("certified"), true);
    EXPECT_EQ(certificate.at("pairs"), 12);
    EXPECT_THAT(certificate.at("trusted").get<std::string>(), HasSubstr("which robochart-replay checks"));
    const Ran page = conform_with_answer("certified 12 1", "--component Walker --html page.html -q; cat page.html");
    EXPECT_THAT(page.out, HasSubstr("conforms (certified: product level, unreduced, 12 pairs, 1 component)"));
    EXPECT_THAT(page.out, HasSubstr("still trusted: "));
}

TEST(Certify, CodeHasNoCertificateForAnotherRelation) {
    const Ran ran = conform_with_answer("certified 12 1", "--component Walker --model tick-tock");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("no certificate: there are no certificates for tick-tock"));
    EXPECT_THAT(ran.out, Not(HasSubstr("still trusted")));
    const Ran refused = conform_with_answer("refused it can do nothing", "--component Walker");
    EXPECT_EQ(refused.exit, 2);
    EXPECT_THAT(refused.out, HasSubstr("REFUSED by robochart-certify: it can do nothing"));
}

TEST(Certify, TheFolderMustBeEmpty) {
    const Ran ran =
        run_with_answer("certified 1 1", "mkdir certs; touch certs/x; \"$verify\" cspm s.csp --certify certs");
    EXPECT_EQ(ran.exit, 4);
    EXPECT_THAT(ran.err, HasSubstr("certs is not empty"));
}

}  // namespace
}  // namespace robochart::app::testing::certify_test
