// SPDX-License-Identifier: Apache-2.0
// Tests certificates: their files, and the answers of robochart-certify. The naive checker decides random scripts. The
// test makes certificates for claims that hold, and also for claims that fail, as a faulty checker would. The certifier
// must accept the former and refuse the latter.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>

#include "base/cache/sha256.hpp"
#include "checker/certify/certificate.hpp"
#include "checker/certify/process_text.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "tests/checker/cspm/support.hpp"
#include "tests/checker/processes/random_cases.hpp"
#include "tests/small_disk.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::certify {
namespace {

using cspm::test::Reading;
using refine::RandomCases;

/// The paths of programs, or "" if a program is not installed.
const std::string certifier = ROBOCHART_CERTIFY;
const std::string coq = ROBOCHART_COQC;
const char* const no_certifier = "robochart-certify is not built, because there is no ocamlopt";

struct Ran {
    int exit = -1;
    std::string out;
};

/// Runs a shell command.
Ran run(const std::string& command) {
    Ran result;
    FILE* const pipe = popen(command.c_str(), "r");
    std::array<char, 4096> piece{};
    while (pipe != nullptr && fgets(piece.data(), piece.size(), pipe) != nullptr) result.out += piece.data();
    const int status = pclose(pipe);
    result.exit = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
    return result;
}

/// Runs the certifier on a folder.
Ran certify(const std::string& folder, const std::string& options = "") {
    return run(fmt::format("'{}' {} '{}' 2>&1", certifier, options, folder));
}

/// Returns the answers of the certifier by folder.
std::map<std::string, bool> answers_in(const std::string& output) {
    std::map<std::string, bool> result;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        const bool accepted = line.starts_with("CERTIFIED");
        if (!accepted && !line.starts_with("REFUSED")) continue;
        const std::string path = line.substr(11, line.find(": ") - 11);
        result[std::filesystem::path(path).filename().string()] = accepted;
    }
    return result;
}

/// A script with its session.
class Opened {
public:
    explicit Opened(const std::string& text) : reading_(text) {
        (void)cspm::check_types(reading_.script, reading_.diagnostics);
        EXPECT_TRUE(reading_.ok()) << reading_.report();
        session_.emplace(reading_.script);
        assertions_ = session_->assertions();
    }
    [[nodiscard]] CertificateResult certificate(std::size_t number, const std::string& source = "test",
                                                Level highest = Level::term) {
        return make_certificate(*session_, *assertions_.at(number), source, {}, highest);
    }
    /// Returns the certificate that an event of the goal, which is a set of channels, stays possible in a process.
    [[nodiscard]] CertificateResult possible(const std::string& process, const std::vector<std::string>& goal,
                                             Level highest = Level::term) {
        std::vector<cspm::ExprPtr> channels;
        channels.reserve(goal.size());
        for (const std::string& channel : goal) channels.push_back(cspm::build::name(channel));
        const StaysPossible claim{cspm::build::name(process), cspm::build::set(std::move(channels))};
        return make_certificate(*session_, claim, "test", {}, highest);
    }

private:
    Reading reading_;
    std::optional<cspm::Session> session_;
    std::vector<cspm::DeclPtr> assertions_;
};

const std::string two_cells =
    "channel in, mid, out\nCELL = in -> mid -> CELL\nOTHER = mid -> out -> OTHER\n"
    "PAIR = (CELL [|{mid}|] OTHER) \\ {mid}\nSPEC = in -> (out -> SPEC |~| in -> out -> SPEC) [] STOP\n"
    "ONE = in -> ONE\nassert PAIR :[deadlock free [F]]\nassert RUN({in, out}) [T= PAIR\nassert not STOP [T= PAIR\n"
    "assert PAIR :[deterministic]\nassert STOP [T= ONE\n";

TEST(Certificates, AreTextsWithDigests) {
    Opened script(two_cells);
    const CertificateResult result = script.certificate(1, "the claim\n(a.csp:8)");
    ASSERT_TRUE(result.certificate) << result.reason;
    const Certificate& files = *result.certificate;
    EXPECT_TRUE(files.claim.starts_with("robochart-verify certificate 1\nclaim: refinement in the traces model\n"));
    EXPECT_NE(files.claim.find("\nassertion: assert RUN({in, out}) [T= PAIR\nsource: the claim (a.csp:8)\n"),
              std::string::npos)
        << files.claim;
    EXPECT_NE(files.claim.find("\nlevel: term, unreduced\n"), std::string::npos);
    EXPECT_NE(files.claim.find("\nspecification-sha256: " + diagnostics::sha256(files.specification) + "\n"),
              std::string::npos);
    EXPECT_NE(files.claim.find("\nimplementation-sha256: " + diagnostics::sha256(files.implementation) + "\n"),
              std::string::npos);
    const std::size_t end = files.claim.find("end-sha256: ");
    ASSERT_NE(end, std::string::npos);
    EXPECT_EQ(files.claim.substr(end), "end-sha256: " + diagnostics::sha256(files.claim.substr(0, end)) + "\n");
    EXPECT_TRUE(files.implementation.starts_with("robochart-verify term 1\nevents 3\n")) << files.implementation;
    EXPECT_TRUE(files.implementation.ends_with("\nend\n"));
}

TEST(Certificates, AtTheProductLevelContainCompiledProcesses) {
    Opened script(two_cells);
    const CertificateResult result = script.certificate(1, "test", Level::product);
    ASSERT_TRUE(result.certificate) << result.reason;
    const Certificate& files = *result.certificate;
    EXPECT_NE(files.claim.find("\nlevel: product, unreduced\n"), std::string::npos);
    EXPECT_TRUE(files.implementation.starts_with("robochart-verify process 1\nevents 3\n")) << files.implementation;
    EXPECT_TRUE(files.implementation.ends_with("\nend\n"));
}

/// Returns the text of the term of a process, from its sets to its end.
std::string term_of(const std::string& declarations, const std::string& process) {
    Opened script(declarations + "\nassert " + process + " :[divergence free]\n");
    const CertificateResult result = script.certificate(0);
    EXPECT_TRUE(result.certificate) << result.reason;
    if (!result.certificate) return "";
    EXPECT_EQ(result.certificate->why_product, "");
    const std::string& text = result.certificate->implementation;
    return text.substr(std::min(text.find("sets "), text.size()));
}

/// Sets and definitions are numbered in the order of their first use. Events are numbered in the order in which
/// definitions use them, from 2. The sets of an alphabetised parallel come after those of its operands.
TEST(Certificates, ContainTermsWithTheirDefinitions) {
    EXPECT_EQ(term_of("channel a, b\nP = a -> P\nQ = b -> SKIP", "(P [|{a}|] Q) \\ {b}"),
              "sets 3\n+ 3\n- 2\n+ 2\nrenamings 0\norders 0\ndefinitions 4\noffer 1 2 0 #P\noffer 1 3 2 #Q\n"
              "offer 1 1 3\noffer 0\nmain hide 0 parallel 1 1 2 0 1\nend\n");
    EXPECT_EQ(term_of("channel a, b, c\nP = a -> b -> P\nQ = b -> c -> Q", "P [{a, b} || {b, c}] Q"),
              "sets 3\n+ 2\n+ 4\n+ 3\nrenamings 0\norders 0\ndefinitions 4\noffer 1 2 2 #P\noffer 1 3 3 #Q\n"
              "offer 1 3 0\noffer 1 4 1\nmain parallel 0 1 2 0 1\nend\n");
    EXPECT_EQ(term_of("channel a, b\nP = a -> P", "P [[a <- b]]"),
              "sets 0\nrenamings 1\n2 3\norders 0\ndefinitions 1\noffer 1 2 0 #P\nmain rename 0 0\nend\n");
}

/// A term that cannot be written is no reason against a certificate of the compiled processes.
TEST(Certificates, AreAtTheProductLevelIfATermCannotBeWritten) {
    const auto reason = [](const std::string& process) {
        Opened script("external chase, prioritisepo\nchannel a, b\nP = a -> P [] b -> STOP\nassert " + process +
                      " :[divergence free]\n");
        const CertificateResult result = script.certificate(0);
        EXPECT_TRUE(result.certificate) << result.reason;
        if (!result.certificate) return std::string();
        EXPECT_EQ(result.certificate->level, Level::product);
        EXPECT_TRUE(result.certificate->implementation.starts_with("robochart-verify process 1\n"));
        return result.certificate->why_product;
    };
    EXPECT_EQ(reason("chase(P)"), "it uses chase");
    EXPECT_EQ(reason("prioritisepo(P, {a, b}, {(a, b)}, {a})"), "it uses prioritisepo");
}

TEST(Certificates, AreNotMadeForOtherKindsOfAssertions) {
    Opened script(
        "channel a\nP = a -> P\nassert not P :[divergence free [FD]]\nassert P :[has trace [F]]: <a>\n"
        "assert P [V= P\n");
    EXPECT_EQ(script.certificate(0).reason, "it rests on an assertion about one process that fails");
    EXPECT_EQ(script.certificate(1).reason, "there are no certificates for `has trace` in the models F and FD");
    EXPECT_EQ(script.certificate(2).reason, "there are no certificates for this model");
}

/// Determinism, traces, refinements that fail, timed sections and tau priority. The second assertion of each pair is
/// false: CHOICE may refuse `b` after <>, although <b> is a trace; it has no trace <c>; and CHOICE refines RUN({a, b})
/// in T. LATE can perform `tock` in place of its tau, unless tau has priority. Each claim is certified at both levels.
TEST(Certificates, OfFurtherClaimsAreAcceptedIfTheyAreTrue) {
    if (certifier.empty()) GTEST_SKIP() << no_certifier;
    Opened script(
        "channel a, b, c, tock\nP = a -> b -> P\nCHOICE = a -> CHOICE |~| b -> CHOICE\n"
        "VISIBLE = c -> STOP [] tock -> VISIBLE\nLATE = VISIBLE \\ {c}\n"
        "assert P :[deterministic [FD]]\nassert CHOICE :[deterministic [F]]\n"
        "assert CHOICE :[has trace [T]]: <a, b, b>\nassert CHOICE :[has trace [T]]: <a, c>\n"
        "assert not P [T= CHOICE\nassert not RUN({a, b}) [T= CHOICE\n"
        "assert not RUN({a, b}) [F= CHOICE\nassert not CHOICE [FD= P\n"
        "assert STOP [T= LATE :[tau priority]: {tock}\nassert STOP [T= LATE\n"
        "Timed(\\ _ @ 1) {\nQ = a -> Q\nassert Q :[divergence free]\nassert STOP [T= Q\n}\n");
    for (const Level level : {Level::term, Level::product}) {
        const tests::TemporaryFolder folder;
        for (std::size_t i = 0; i < 12; ++i) {
            const CertificateResult result = script.certificate(i, "test", level);
            ASSERT_TRUE(result.certificate) << i << result.reason;
            EXPECT_EQ(result.certificate->level, level) << i << result.certificate->why_product;
            ASSERT_EQ(write_certificate(folder.path(), fmt::format("{:02}", i), *result.certificate, nullptr), "");
        }
        const Ran ran = certify(folder.path());
        for (std::size_t i = 0; i < 12; ++i)
            EXPECT_EQ(answers_in(ran.out).at(fmt::format("{:02}", i)), i % 2 == 0) << i << ran.out;
    }
}

const std::string lamps =
    "external chase\nchannel on, off, broken, hidden\nLAMP = on -> off -> LAMP\nFRAIL = LAMP /\\ broken -> STOP\n"
    "TWO = (LAMP ||| LAMP [[on <- hidden]]) \\ {hidden}\nCHASED = chase(TWO)\n";

/// FRAIL can lose its events, but it can be broken until then.
TEST(Certificates, OfEventsThatStayPossibleAreAcceptedIfTheyAreTrue) {
    if (certifier.empty()) GTEST_SKIP() << no_certifier;
    Opened script(lamps);
    const tests::TemporaryFolder folder;
    std::map<std::string, bool> truth;
    const auto write = [&](const std::string& name, const CertificateResult& result, bool holds) {
        ASSERT_TRUE(result.certificate) << result.reason;
        ASSERT_EQ(write_certificate(folder.path(), name, *result.certificate, nullptr), "");
        truth[name] = holds;
    };
    for (const Level level : {Level::term, Level::product}) {
        const std::string name = level_name(level);
        write("lamp-" + name, script.possible("LAMP", {"on"}, level), true);
        write("two-" + name, script.possible("TWO", {"broken", "on"}, level), true);
        write("frail-" + name, script.possible("FRAIL", {"on", "off"}, level), false);
        write("never-" + name, script.possible("TWO", {"broken"}, level), false);
        EXPECT_EQ(script.possible("TWO", {"on"}, level).certificate->level, level);
    }
    const Ran ran = certify(folder.path());
    EXPECT_EQ(answers_in(ran.out), truth) << ran.out;
    EXPECT_NE(ran.out.find("/two-term: test: term level, "), std::string::npos) << ran.out;
    const CertificateResult chased = script.possible("CHASED", {"on"});
    ASSERT_TRUE(chased.certificate) << chased.reason;
    EXPECT_EQ(chased.certificate->level, Level::product);
    EXPECT_EQ(chased.certificate->why_product, "it uses chase");
}

TEST(Certificates, HaveTextsWithoutControlCharacters) {
    EXPECT_EQ(one_line("assert P\n    [T= Q"), "assert P [T= Q");
    EXPECT_EQ(one_line("a\x1b[0m\tb  c"), "a [0m b  c");
}

TEST(Certificates, HaveNumberedFolders) {
    EXPECT_EQ(folder_name("3", "A [FD= B_1 \\ {x}"), "3-A-FD-B-1-x");
    EXPECT_EQ(folder_name("2.1", "../../etc"), "2.1-etc");
    EXPECT_EQ(folder_name("7", "\xe2\x9c\x93"), "7");
    EXPECT_LE(folder_name("1", std::string(500, 'a')).size(), 60U);
}

TEST(Certificates, AreRefusedIfTheClaimFails) {
    if (certifier.empty()) GTEST_SKIP() << no_certifier;
    Opened script(two_cells);
    const tests::TemporaryFolder folder;
    const auto write = [&](std::size_t number) {
        const CertificateResult result = script.certificate(number);
        ASSERT_TRUE(result.certificate) << result.reason;
        ASSERT_EQ(write_certificate(folder.path(), fmt::format("{}", number), *result.certificate, nullptr), "");
    };
    write(0);
    write(1);
    write(4);
    const Ran ran = certify(folder.path());
    EXPECT_EQ(ran.exit, 1);
    EXPECT_NE(ran.out.find("/0: test: term level, "), std::string::npos);
    EXPECT_NE(ran.out.find("after <>, in the state ("), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("it can perform in; the specification allows only {}"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("2 certified, 1 refused"), std::string::npos) << ran.out;
}

/// Every file of a certificate is protected by a digest.
TEST(Certificates, AreRefusedIfAByteChanges) {
    if (certifier.empty()) GTEST_SKIP() << no_certifier;
    Opened script(two_cells);
    const CertificateResult result = script.certificate(1);
    ASSERT_TRUE(result.certificate) << result.reason;
    const tests::TemporaryFolder folder;
    int copies = 0;
    const auto damage = [&](std::string Certificate::*file, std::size_t step) {
        const std::string text = (*result.certificate).*file;
        for (std::size_t at = 0; at < text.size(); at += step) {
            Certificate changed = *result.certificate;
            (changed.*file)[at] = static_cast<char>((changed.*file)[at] ^ 1);
            ASSERT_EQ(write_certificate(folder.path(), fmt::format("{}", copies++), changed, nullptr), "");
            changed = *result.certificate;
            (changed.*file).resize(at);
            ASSERT_EQ(write_certificate(folder.path(), fmt::format("{}", copies++), changed, nullptr), "");
        }
    };
    damage(&Certificate::claim, 7);
    damage(&Certificate::specification, 11);
    damage(&Certificate::implementation, 11);
    const Ran ran = certify(folder.path(), "--quiet");
    EXPECT_EQ(ran.exit, 1);
    EXPECT_NE(ran.out.find(fmt::format("0 certified, {} refused", copies)), std::string::npos) << ran.out;
}

TEST(Certificates, AreNotCompleteWithoutTheirClaim) {
    if (certifier.empty()) GTEST_SKIP() << no_certifier;
    Opened script(two_cells);
    const tests::TemporaryFolder folder;
    ASSERT_EQ(write_certificate(folder.path(), "1", *script.certificate(1).certificate, nullptr), "");
    std::filesystem::remove(folder.in("1/claim.txt"));
    const Ran ran = certify(folder.path());
    EXPECT_EQ(ran.exit, 1);
    EXPECT_NE(ran.out.find("0 certified, 1 refused"), std::string::npos) << ran.out;
}

/// On a full disk, the error says so, and the incomplete folder is not accepted as a certificate.
TEST(Certificates, AreCompleteOrRefusedOnASmallDisk) {
    if (certifier.empty()) GTEST_SKIP() << no_certifier;
    Opened script(two_cells);
    const Certificate files = *script.certificate(1).certificate;
    int failures = 0;
    for (unsigned kibibytes = 4; kibibytes <= 32; kibibytes += 4) {
        const tests::TemporaryFolder folder;
        const int result = tests::on_small_disk(folder.path(), kibibytes, [&] {
            const std::string error = write_certificate(folder.path(), "1", files, nullptr);
            const bool accepted = certify(folder.path()).exit == 0;
            if (accepted != error.empty() || std::filesystem::exists(folder.in("1/claim.txt")) != error.empty())
                return 2;
            return error.find("No space left on device") != std::string::npos ? 1 : 0;
        });
        if (result == 100) GTEST_SKIP() << "this system allows no small disk";
        ASSERT_LE(result, 1) << kibibytes;
        failures += result;
    }
    EXPECT_GT(failures, 0);
    EXPECT_LT(failures, 8);
}

/// If the program is killed at any time, the certifier accepts exactly the folders that have a claim.
TEST(Certificates, AreCompleteOrRefusedIfTheProgramIsKilled) {
    if (certifier.empty()) GTEST_SKIP() << no_certifier;
    Opened script(two_cells);
    const Certificate files = *script.certificate(1).certificate;
    for (int round = 0; round < 5; ++round) {
        const tests::TemporaryFolder folder;
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0)
            for (int i = 0;; ++i) (void)write_certificate(folder.path(), fmt::format("{}", i), files, nullptr);
        while (!std::filesystem::exists(folder.in("1/claim.txt"))) usleep(100);
        usleep(static_cast<useconds_t>(1'234 * round));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        const Ran ran = certify(folder.path());
        const std::map<std::string, bool> answers = answers_in(ran.out);
        EXPECT_GE(answers.size(), 2U);
        for (const auto& [name, accepted] : answers)
            EXPECT_EQ(accepted, std::filesystem::exists(folder.in(name + "/claim.txt"))) << ran.out;
    }
}

/// Components with more than 61 bits of states need several words.
TEST(Certificates, OfWideStatesAreChecked) {
    if (certifier.empty()) GTEST_SKIP() << no_certifier;
    Opened script(
        "channel c : {0..69}\nWIDE = ||| i : {0..69} @ (if i < 3 then c.i -> STOP else STOP)\n"
        "LIMIT(n) = if n == 0 then STOP else c?i -> LIMIT(n - 1)\n"
        "assert LIMIT(3) [T= WIDE\nassert LIMIT(2) [T= WIDE\nassert WIDE :[divergence free]\n");
    const tests::TemporaryFolder folder;
    for (std::size_t i = 0; i < 3; ++i) {
        const CertificateResult result = script.certificate(i);
        ASSERT_TRUE(result.certificate) << result.reason;
        ASSERT_EQ(write_certificate(folder.path(), fmt::format("{}", i), *result.certificate, nullptr), "");
    }
    const Ran ran = certify(folder.path());
    EXPECT_EQ(answers_in(ran.out), (std::map<std::string, bool>{{"0", true}, {"1", false}, {"2", true}})) << ran.out;
    EXPECT_NE(ran.out.find(", 70 components\n"), std::string::npos) << ran.out;
}

/// The buffers of a chain perform their hidden steps in any order. The check follows these steps.
TEST(Certificates, AreCheckedWithFewerPairsIfTausAreConfluent) {
    if (certifier.empty()) GTEST_SKIP() << no_certifier;
    Opened script(
        "N = 6\nchannel c : {0..N}\nCELL(i) = c.i -> c.(i + 1) -> CELL(i)\n"
        "CHAIN = (|| i : {0..N-1} @ [{c.i, c.(i + 1)}] CELL(i)) \\ {c.i | i <- {1..N-1}}\n"
        "QUEUE(n) = (n < N & c.0 -> QUEUE(n + 1)) [] (n > 0 & c.N -> QUEUE(n - 1))\n"
        "assert QUEUE(0) [FD= CHAIN\nassert QUEUE(0) [T= CHAIN\nassert CHAIN :[deadlock free [F]]\n"
        "assert QUEUE(1) [F= CHAIN\n");
    const tests::TemporaryFolder folder;
    for (std::size_t i = 0; i < 4; ++i) {
        const CertificateResult result = script.certificate(i);
        ASSERT_TRUE(result.certificate) << result.reason;
        ASSERT_EQ(write_certificate(folder.path(), fmt::format("{}", i), *result.certificate, nullptr), "");
    }
    const Ran ran = certify(folder.path());
    EXPECT_EQ(answers_in(ran.out), (std::map<std::string, bool>{{"0", true}, {"1", true}, {"2", true}, {"3", false}}))
        << ran.out;
    // The values move to the end of the chain, so the number of values determines a state.
    // There are seven such states in place of 64.
    EXPECT_NE(ran.out.find("/0: test: term level, 7 pairs, reduced by confluent taus, 6 components\n"),
              std::string::npos)
        << ran.out;
    EXPECT_NE(ran.out.find("/2: test: term level, 1 pair, reduced by confluent taus, 6 components\n"),
              std::string::npos)
        << ran.out;
}

/// Five equal robots of two states, also with a component each beside them and priorities around them. The check visits
/// one of the states that differ only by an exchange of robots: with k robots in the second state, for k from 0 to 5.
TEST(Certificates, AreCheckedWithFewerPairsIfComponentsAreEqual) {
    if (certifier.empty()) GTEST_SKIP() << no_certifier;
    Opened script(
        "external prioritise\nchannel go\nchannel a, b : {1..5}\n"
        "ROBOT(i) = a.i -> b.i -> ROBOT(i) [] go -> ROBOT(i)\n"
        "SWARM = [| {go} |] i : {1..5} @ ROBOT(i)\nANY = a?i -> ANY [] b?i -> ANY [] go -> ANY\n"
        "COUNTED(i) = prioritise(ROBOT(i) [| {a.i, b.i} |] ROBOT(i), <{a.i}, {go}>)\n"
        "SOME = |~| e : {| a, b, go |} @ e -> SOME\n"
        "FREE = a.1 -> BUSY [] a?i : {2..5} -> FREE [] b?i : {2..5} -> FREE [] go -> FREE\n"
        "BUSY = b.1 -> FREE [] a?i : {2..5} -> BUSY [] b?i : {2..5} -> BUSY [] go -> BUSY\n"
        "assert ANY [T= SWARM\nassert SOME [FD= SWARM\nassert SWARM :[divergence free]\n"
        "assert ANY [T= ([| {go} |] i : {1..5} @ COUNTED(i))\nassert FREE [T= SWARM\nassert STOP [T= SWARM\n");
    const tests::TemporaryFolder folder;
    for (std::size_t i = 0; i < 6; ++i) {
        const CertificateResult result = script.certificate(i);
        ASSERT_TRUE(result.certificate) << result.reason;
        ASSERT_EQ(write_certificate(folder.path(), fmt::format("{}", i), *result.certificate, nullptr), "");
    }
    const Ran ran = certify(folder.path());
    EXPECT_EQ(answers_in(ran.out), (std::map<std::string, bool>{
                                       {"0", true}, {"1", true}, {"2", true}, {"3", true}, {"4", true}, {"5", false}}))
        << ran.out;
    for (const std::string line : {"/0: test: term level, 6 pairs, reduced by symmetry, 5 components\n",
                                   "/1: test: term level, 6 pairs, reduced by symmetry, 5 components\n",
                                   "/2: test: term level, 6 pairs, reduced by symmetry, 5 components\n",
                                   "/3: test: term level, 6 pairs, reduced by symmetry, 10 components\n"})
        EXPECT_NE(ran.out.find(line), std::string::npos) << line << ran.out;
    // FREE distinguishes one robot, so only the other four are exchanged.
    EXPECT_NE(ran.out.find("/4: test: term level, 10 pairs, reduced by symmetry, 5 components\n"), std::string::npos)
        << ran.out;
}

/// Returns the theorem of a certificate in the Coq form.
std::string coq_form(const std::string& folder, const Certificate& certificate) {
    EXPECT_EQ(write_certificate(folder, "1", certificate, nullptr), "");
    const Ran made = certify(folder + "/1", "--coq");
    EXPECT_EQ(made.exit, 0) << made.out;
    return made.out;
}

/// The file with the theorem needs only Coq, no other files. The proofs are the same in each file and take the most
/// time. So one file is compiled as it is, and the definitions of the other files follow as modules.
TEST(Certificates, BecomeTheoremsOfCoq) {
    if (certifier.empty()) GTEST_SKIP() << no_certifier;
    if (coq.empty()) GTEST_SKIP() << "there is no coqc";  // it is large, so scripts/setup.sh does not install it
    Opened script(two_cells +
                  "assert PAIR :[deterministic [F]]\nassert PAIR :[has trace [T]]: <in, in, out>\n"
                  "assert not STOP [FD= ONE\nassert not ONE [F= STOP\nassert not STOP [FD= ONE \\ {in}\n");
    std::string text;
    std::size_t theorems = 0;
    const auto add = [&](const CertificateResult& result, Level level, const std::string& theorem) {
        ASSERT_TRUE(result.certificate) << result.reason;
        EXPECT_EQ(result.certificate->level, level) << theorem;
        const tests::TemporaryFolder folder;
        const std::string file = coq_form(folder.path(), *result.certificate);
        const std::string statement =
            level == Level::term ? fmt::format("eventually (fun bound => {})", theorem) : theorem;
        EXPECT_NE(file.find(fmt::format("\nTheorem holds : {}.\n", statement)), std::string::npos)
            << statement << file.substr(std::min(file.find("\nTheorem holds"), file.size()));
        const std::size_t own = file.find("(* How the evidence is found");
        ASSERT_NE(own, std::string::npos);
        text +=
            text.empty() ? file : fmt::format("\nModule Other{0}.\n{1}\nEnd Other{0}.\n", theorems, file.substr(own));
        ++theorems;
    };
    for (const Level level : {Level::term, Level::product}) {
        const auto process = [&](const std::string& name) {
            return level == Level::term ? fmt::format("(term_lts bound {})", name)
                                        : fmt::format("(system_lts {})", name);
        };
        const std::string spec = process("specification");
        const std::string impl = process("implementation");
        const auto certificate = [&](std::size_t number) { return script.certificate(number, "test", level); };
        add(certificate(0), level, "satisfies Deadlock_free " + impl);
        add(certificate(1), level, fmt::format("refines T {} {}", spec, impl));
        add(certificate(3), level, "deterministic FD " + impl);
        add(certificate(5), level, "deterministic F " + impl);
        add(certificate(6), level, fmt::format("traces {} (2 :: 2 :: 3 :: nil)", impl));
        add(certificate(2), level, fmt::format("~ refines T {} {}", spec, impl));
        add(certificate(7), level, fmt::format("~ refines FD {} {}", spec, impl));
        add(certificate(8), level, fmt::format("~ refines F {} {}", spec, impl));
        add(certificate(9), level, fmt::format("~ refines FD {} {}", spec, impl));
        add(script.possible("PAIR", {"out"}, level), level,
            fmt::format("stays_possible (fun a => In a (2 :: nil)) {}", impl));
    }
    const tests::TemporaryFolder folder;
    const std::string file = folder.write("Holds.v", text);
    const Ran ran = run(fmt::format("cd '{}' && '{}' -q '{}' 2>&1", folder.path(), coq, file));
    EXPECT_EQ(ran.exit, 0) << ran.out;
    EXPECT_EQ(ran.out.find("holds"), std::string::npos) << ran.out;
    std::size_t printed = 0;
    for (std::size_t at = 0; (at = ran.out.find("Axioms:\n", at)) != std::string::npos; ++at) ++printed;
    EXPECT_EQ(printed, theorems) << ran.out;
}

/// A claim that fails does not become a theorem.
TEST(Certificates, HaveNoCoqFormIfTheClaimFails) {
    if (certifier.empty()) GTEST_SKIP() << no_certifier;
    Opened script(two_cells +
                  "assert SPEC :[deterministic]\nassert ONE :[has trace [T]]: <out>\nassert not ONE [T= ONE\n");
    const auto is_refused = [](const CertificateResult& result) {
        ASSERT_TRUE(result.certificate) << result.reason;
        const tests::TemporaryFolder folder;
        ASSERT_EQ(write_certificate(folder.path(), "1", *result.certificate, nullptr), "");
        const Ran made = certify(folder.in("1"), "--coq");
        EXPECT_EQ(made.exit, 1) << made.out;
        EXPECT_TRUE(made.out.starts_with("robochart-certify: ")) << made.out;
    };
    for (const Level level : {Level::term, Level::product}) {
        for (const std::size_t number : {4U, 5U, 6U, 7U}) is_refused(script.certificate(number, "test", level));
        is_refused(script.possible("ONE", {"out"}, level));
    }
}

TEST(Certificates, OfRandomScriptsAreAcceptedIfAndOnlyIfTheClaimHolds) {
    if (certifier.empty()) GTEST_SKIP() << no_certifier;
    const int required = refine::wanted_checks(1'000);
    RandomCases cases(41);
    std::map<bool, int> counted;
    std::map<Level, int> levels;
    for (int checks = 0; checks < required;) {
        const RandomCases::Explored explored = cases.next();
        const std::string text = refine::script_with_assertions(explored.test_case);
        if (text.find("chase(") != std::string::npos) continue;  // the naive checker may follow another tau
        Opened script(text);
        const tests::TemporaryFolder folder;
        std::map<std::string, bool> truth;
        const auto write = [&](std::size_t question, Level highest) {
            const CertificateResult result = script.certificate(question, "test", highest);
            if (!result.certificate) return;
            const std::string name = fmt::format("{}-{}", question, level_name(highest));
            ASSERT_EQ(write_certificate(folder.path(), name, *result.certificate, nullptr), "");
            truth[name] = expected(refine::questions()[question], explored.graphs, explored.test_case.trace);
            ++levels[result.certificate->level];
        };
        for (std::size_t i = 0; i < refine::questions().size(); ++i) {
            write(i, Level::term);
            write(i, Level::product);
        }
        const Ran ran = certify(folder.path());
        ASSERT_EQ(answers_in(ran.out), truth) << ran.out << text;
        for (const auto& [name, holds] : truth) ++counted[holds];
        checks += static_cast<int>(truth.size());
        ASSERT_FALSE(truth.empty()) << text;
    }
    std::cout << counted[true] << " claims that hold are certified, " << counted[false] << " that fail are refused\n";
    std::cout << levels[Level::term] << " certificates are at the term level, " << levels[Level::product]
              << " at the product level\n";
    EXPECT_GT(counted[true], 0);
    EXPECT_GT(counted[false], 0);
    EXPECT_GT(levels[Level::term], levels[Level::product] / 2);
}

}  // namespace
}  // namespace robochart::certify
