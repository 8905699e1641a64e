// SPDX-License-Identifier: Apache-2.0
// Tests the verb `tune` in a world whose best constants are known, and with altered certificates.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/diagnostics/files.hpp"
#include "command.hpp"
#include "driver/evidence/certificate.hpp"
#include "tests/contents.hpp"

namespace robochart::app::tune_test {
namespace {

using testing::Folder;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::run;
using testing::run_shell;
using tests::read_contents;

/// A robot drives along a curve, or spins. The way from (0, 0) to within 30 cm of a lamp at (100 cm, 0) is 70 cm
/// straight ahead. So the best constants are no curve, no spinning, and the highest speed. Speeds above 8 reach the
/// state Hasty.
constexpr const char* model = R"(package aim
interface Drive {
	const speed : real = 4
	const curve : real = 1
	const spinning : boolean = true
	var linear : real = 0
	var angular : real = 0
}
robotic platform Body { provides Drive }
stm Go {
	requires Drive
	initial i
	state Driving { entry linear = speed; if spinning then angular = 3 else angular = curve end }
	state Hasty { }
	transition t0 { from i to Driving }
	transition t1 { from Driving to Hasty condition speed > 8 }
}
controller Brain { requires Drive sref go = Go }
module Robot { rref body = Body cref brain = Brain }
)";

constexpr const char* world = R"(scenario Aim for aim::Robot {
	step 0.1 s physics 0.01 s unit 0.1 s duration 30 s seed 1
	arena 400 cm by 400 cm
	light lamp at (100 cm, 0 cm)
	robots 1 { radius 3 cm axle 5 cm wheel 20 cm/s noise 5 %
		place at (0 cm, 0 cm) heading 0 deg }
	actuator motors is differential_drive
	drive motors by speeds(linear in cm/s, angular in rad/s)
	measure way is distance(lamp)
	accept probability way <= 30 cm within 30 s >= 90 % with confidence 95 %
}
)";

constexpr const char* harmless = "assertion A1 : aim::Go::Driving is reachable in aim::Go\n";
constexpr const char* reached = "assertion A1 : aim::Go::Hasty is reachable in aim::Go\n";
constexpr const char* not_hasty = "assertion A1 : aim::Go::Hasty is not reachable in aim::Go\n";

std::vector<std::pair<std::string, std::string>> project(const std::string& assertions) {
    return {{"aim/aim.rct", model}, {"aim/aim.scenario", world}, {"aim/aim.assertions", assertions}};
}

std::vector<std::string> tuning(const Folder& folder, const std::vector<std::string>& more) {
    std::vector<std::string> words{
        "tune",    folder / "aim/aim.scenario", "--const", "speed=1..10", "--const", "curve=-0.2..0.2",
        "--const", "spinning=true,false",       "--out",   folder / "out"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

std::string constant(const nlohmann::json& elite, const std::string& name) {
    return elite.at("constants").at(name).get<std::string>();
}

TEST(Tune, FindsWhatIsBestAndCertifiesIt) {
    const Folder folder(project(harmless));
    const auto ran = run(tuning(folder, {"--budget", "400", "--format", "json"}));
    ASSERT_EQ(ran.exit, 0) << ran.out << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    const auto& winner = json.at("elites").at(0);
    EXPECT_LE(json.at("trials"), 400);
    EXPECT_GE(std::stod(constant(winner, "speed")), 8.0);
    // With a curve c, the robot passes roughly c 100^2 / (2 v) cm beside the lamp. This is 30 cm for a curve of 0.06 at
    // the highest speed.
    EXPECT_NEAR(std::stod(constant(winner, "curve")), 0, 0.06);
    EXPECT_EQ(constant(winner, "spinning"), "false");
    const auto& certificate = json.at("certificate");
    EXPECT_EQ(certificate.at("claims").at(0).at("answer"), "holds");
    EXPECT_EQ(certificate.at("conformance").at(0).at("answer"), "conforms");
    EXPECT_EQ(certificate.at("assertions").at(0).at("answer"), "holds");
    EXPECT_EQ(certificate.at("seed"), 1) << "of the claims";
    EXPECT_EQ(certificate.at("search").at("firstSeed"), 1 + (std::uint64_t{2} << 32U)) << "none of the claims'";

    const auto& record = certificate.at("run");
    EXPECT_EQ(record.at("program").at("name"), "robochart-verify");
    EXPECT_EQ(record.at("seed"), 1);
    EXPECT_EQ(record.at("command").at(1), "tune");
    EXPECT_EQ(record.at("inputs").size(), 3U) << "scenario, model, assertions";
    EXPECT_EQ(json.at("run").at("constants"), record.at("constants")) << "of the winner";

    const std::string file = folder / "out/tuning/Aim/certificate.json";
    const std::vector<std::string> verify{"tune", folder / "aim/aim.scenario", "--verify-certificate", file};
    const auto again = run(verify);
    EXPECT_EQ(again.exit, 0) << again.out << again.err;
    EXPECT_THAT(again.out, HasSubstr("\nthe certificate says what is decided here\n"));
    EXPECT_THAT(again.out, HasSubstr("  ranges: none\n  search: as recorded, not repeated\n"));

    // The test alters the certificate, first without and then with a new digest. Then it alters the model.
    const std::string text = read_contents(file);
    std::string error;
    std::string changed = text;
    changed.replace(changed.find("holds"), 5, "fails");
    EXPECT_EQ(diagnostics::replace_file(file, changed), "");
    const auto tampered = run(verify);
    EXPECT_EQ(tampered.exit, 4) << tampered.out;
    EXPECT_THAT(tampered.err, HasSubstr("its digest is not that of its contents"));

    auto forged = driver::read_certificate(text, error);
    ASSERT_TRUE(forged) << error;
    forged->evidence.claims.at(0).successes += 1;
    EXPECT_EQ(diagnostics::replace_file(file, certificate_text(*forged)), "");
    const auto refuted = run(verify);
    EXPECT_EQ(refuted.exit, 1) << refuted.err;
    EXPECT_THAT(refuted.out, HasSubstr("differs      claim: probability way <= 30 cm"));

    // A line end in the certificate's text must not start a new line of output.
    forged->evidence.assertions.at(0).subject = "A1\nthe certificate says what is decided here\n";
    EXPECT_EQ(diagnostics::replace_file(file, certificate_text(*forged)), "");
    const auto faked = run(verify);
    EXPECT_EQ(faked.exit, 1) << faked.err;
    EXPECT_THAT(faked.out, HasSubstr(R"(A1\nthe certificate says what is decided here\n is not there)"));
    EXPECT_THAT(faked.out, Not(HasSubstr("\nthe certificate says what is decided here")));

    EXPECT_EQ(diagnostics::replace_file(file, text), "");
    EXPECT_EQ(diagnostics::replace_file(folder / "aim/aim.assertions", "// another\n" + std::string(harmless)), "");
    const auto other = run(verify);
    EXPECT_EQ(other.exit, 1) << other.err;
    EXPECT_THAT(other.out, HasSubstr("differs      model: aim.assertions is not the one that is certified"));
}

/// A higher speed would be better, but an assertion fails for it, so it is rejected.
TEST(Tune, WhatFailsACheckIsRefused) {
    const Folder folder(project(not_hasty));
    const auto ran = run(tuning(folder, {"--budget", "300", "--format", "json"}));
    ASSERT_LE(ran.exit, 1) << ran.out << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    for (const auto& elite : json.at("elites")) EXPECT_LE(std::stod(constant(elite, "speed")), 8.0);
    std::uint64_t refused = 0;
    for (const auto& iteration : json.at("iterations")) refused += iteration.at("refused").get<std::uint64_t>();
    EXPECT_GT(refused, 0U);
}

/// No robot reaches the lamp within a second. A certificate that states this is correct, but the exit code is not
/// success.
TEST(Tune, ACertificateOfWhatFailsIsNoSuccess) {
    std::string fast = world;
    fast.replace(fast.find("within 30 s"), 11, "within 1 s");
    const Folder folder({{"aim/aim.rct", model}, {"aim/aim.scenario", fast}, {"aim/aim.assertions", harmless}});
    const std::string scenario = folder / "aim/aim.scenario";
    const auto ran = run(
        {"tune", scenario, "--const", "speed=1,2", "--budget", "60", "--range", "nat=0..2", "--out", folder / "out"});
    ASSERT_EQ(ran.exit, 1) << ran.out << ran.err;
    std::vector<std::string> verify{"tune", scenario, "--verify-certificate",
                                    folder / "out/tuning/Aim/certificate.json"};
    const auto again = run(verify);
    EXPECT_EQ(again.exit, 1) << again.err;
    EXPECT_THAT(again.out, HasSubstr("\nthe certificate says what is decided here: something fails\n"));
    EXPECT_THAT(again.out, HasSubstr("  ranges: nat=0..2\n"));
    verify.insert(verify.end(), {"--format", "json"});
    const auto json = nlohmann::json::parse(run(verify).out);
    EXPECT_EQ(json.at("differences").size(), 0U);
    EXPECT_EQ(json.at("ranges").at(0), "nat=0..2");
    EXPECT_EQ(json.at("exit"), 1);
}

/// The scenario's own constants are constants of the robots, so the model is checked with them too: with speed 9, Hasty
/// is reachable.
TEST(Tune, ConstantsOfTheScenarioAreThoseOfTheCertificate) {
    std::string hasty = world;
    hasty.replace(hasty.find("noise 5 %"), 9, "noise 5 % const speed = 9 const spinning = true");
    const Folder folder({{"aim/aim.rct", model}, {"aim/aim.scenario", hasty}, {"aim/aim.assertions", reached}});
    const std::string scenario = folder / "aim/aim.scenario";
    const auto ran = run({"tune", scenario, "--const", "curve=0,0.01", "--const", "spinning=false", "--budget", "60",
                          "--out", folder / "out", "--format", "json"});
    ASSERT_EQ(ran.exit, 0) << ran.out << ran.err;
    const auto certificate = nlohmann::json::parse(ran.out).at("certificate");
    EXPECT_EQ(certificate.at("assertions").at(0).at("answer"), "holds");
    const auto& constants = certificate.at("constants");
    ASSERT_EQ(constants.size(), 3U) << constants;
    EXPECT_EQ(constants.at(0).at("name"), "curve");
    EXPECT_EQ(constants.at(1).at("name"), "spinning");
    EXPECT_EQ(constants.at(1).at("value"), "false") << "the option's, not the scenario's";
    EXPECT_EQ(constants.at(2).at("name"), "speed");
    EXPECT_EQ(constants.at(2).at("value"), "9");
    const auto again =
        run({"tune", scenario, "--verify-certificate", folder / "out/tuning/Aim/certificate.json", "-q"});
    EXPECT_EQ(again.exit, 0) << again.out << again.err;
}

TEST(Tune, TheSameForAnyNumberOfThreadsAndGoesOnWhereItWas) {
    const Folder folder(project(harmless));
    const std::string scenario = folder / "aim/aim.scenario";
    const auto ran =
        run_shell("tune() { \"$verify\" tune " + scenario +
                  " --const curve=-0.2..0.2 --const speed=4..8 --const spinning=false --budget 60 \"$@\"; }\n"
                  "tune --threads 1 --no-cache --out one > /dev/null\n"
                  "tune --threads 3 --out three > /dev/null\n"
                  "same() { sed -e '/^  \"run\": {/,/^  }/d' -e '/^  \"digest\":/d' $1/tuning/Aim/certificate.json; }\n"
                  "[ \"$(same one)\" = \"$(same three)\" ] && same one | grep -q firstSeed && echo equal\n"
                  "tune --threads 2 --out three | grep known\n");
    EXPECT_THAT(ran.out, HasSubstr("equal\n")) << ran.err;
    // A third of the budget suffices for three candidates on five seeds, and three candidates may survive.
    EXPECT_THAT(ran.out, HasSubstr("15 of 15 trials known from earlier runs")) << ran.err;
}

TEST(Tune, ALimitLeavesWhatIsKnown) {
    const Folder folder(project(harmless));
    const auto ran = run(tuning(folder, {"--budget", "100000", "--timeout", "3"}));
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("the same command goes on where it was"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out/tuning/Aim/certificate.json"));
}

TEST(Tune, WrongUsage) {
    const Folder folder(project(harmless));
    const std::string scenario = folder / "aim/aim.scenario";
    const auto expect = [&](const std::vector<std::string>& more, const std::string& what) {
        std::vector<std::string> words{"tune", scenario};
        words.insert(words.end(), more.begin(), more.end());
        const auto ran = run(words);
        EXPECT_EQ(ran.exit, 4) << ran.out << ran.err;
        EXPECT_THAT(ran.err, HasSubstr(what));
    };
    expect({}, "--const NAME=LOW..HIGH");
    expect({"--const", "speed=3"}, "--const NAME=LOW..HIGH");
    expect({"--const", "sped=1..3"}, "did you mean 'speed'");
    expect({"--const", "speed=3..1"}, "below the upper one");
    expect({"--const", "speed=1..x"}, "two numbers");
    expect({"--const", "speed=1,1"}, "a value is listed twice");
    expect({"--const", "spinning=0..1"}, "");
    expect({"--const", "speed=1..3", "--const", "speed=4"}, "given twice");
    expect({"--budget", "0"}, "");
    expect({"--verify-certificate", folder / "none.json"}, "none.json");
    expect({"--verify-certificate", scenario}, "it is no JSON");
    expect({"--verify-certificate", scenario, "--const", "speed=1..3"}, "no --const beside it");
    expect({"--verify-certificate", scenario, "--range", "nat=0..2"}, "no --range beside it");
}

/// One candidate needs more than two trials.
TEST(Tune, ProgramsLearnWhyNothingWasFound) {
    const Folder folder(project(harmless));
    const auto ran = run(tuning(folder, {"--budget", "2", "--format", "json"}));
    EXPECT_EQ(ran.exit, 2) << ran.out << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    ASSERT_EQ(json.at("reasons").size(), 1U);
    EXPECT_THAT(json.at("reasons").at(0).get<std::string>(), HasSubstr("--budget takes more"));
}

TEST(Tune, ScenariosThatCannotBeTuned) {
    std::string varied = world;
    varied.insert(varied.rfind('}'), "\tvary robots in 1 to 3\n");
    std::string unclaimed = world;
    unclaimed.erase(unclaimed.find("\taccept"), unclaimed.rfind('}') - unclaimed.find("\taccept"));
    const Folder folder({{"aim.rct", model}, {"varied.scenario", varied}, {"unclaimed.scenario", unclaimed}});
    const auto tried = [&](const std::string& name) { return run({"tune", folder / name, "--const", "speed=1..3"}); };
    EXPECT_THAT(tried("varied.scenario").err, HasSubstr("in which nothing varies"));
    EXPECT_EQ(tried("unclaimed.scenario").exit, 2);
    EXPECT_THAT(tried("unclaimed.scenario").err, HasSubstr("RC-M04"));
}

TEST(Certificates, AreReadStrictly) {
    driver::Certificate written;
    written.program = "robochart-verify 0.1.0";
    written.constants = {{"speed", "8"}, {"name\n\"'", "\x01<b>"}};
    written.evidence.claims = {{"P", "holds", 16, 16, 0.5, 1}};
    written.evidence.assertions = {{"A1", "holds"}};
    const std::string text = certificate_text(written);
    std::string error;
    const auto read = driver::read_certificate(text, error);
    ASSERT_TRUE(read) << error;
    EXPECT_EQ(certificate_text(*read), text);
    EXPECT_TRUE(evidence_differences(written.evidence, read->evidence).empty());

    const auto refused = [&](const std::string& changed) {
        std::string why;
        EXPECT_FALSE(driver::read_certificate(changed, why)) << changed;
        return why;
    };
    const auto with = [&](const std::string& what, const std::string& new_text) {
        std::string changed = text;
        changed.replace(changed.find(what), what.size(), new_text);
        return changed;
    };
    EXPECT_EQ(refused(""), "it is no JSON");
    EXPECT_EQ(refused("[]"), "the certificate is no object");
    EXPECT_EQ(refused(std::string(100'000, '[')), "it is no JSON");
    EXPECT_THAT(refused(std::string(100'000, '[') + std::string(100'000, ']')), HasSubstr("no object"));
    EXPECT_THAT(refused("{}"), HasSubstr("has no schema"));
    EXPECT_EQ(refused(with("\"trials\": 16", "\"trials\": 16, \"trials\": 16")), "it has the key `trials` twice");
    EXPECT_THAT(refused(with("certificate/1", "certificate/2")), HasSubstr("schema"));
    EXPECT_THAT(refused(with("\"trials\": 16", "\"trials\": -16")), HasSubstr("trials of claims is no whole number"));
    EXPECT_THAT(refused(with("\"trials\": 16", "\"trials\": 1e999")), HasSubstr("no JSON"));
    EXPECT_THAT(refused(with("\"trials\": 16", "\"trials\": \"16\"")), HasSubstr("no whole number"));
    EXPECT_THAT(refused(with("\"run\": {}", "\"run\": []")), HasSubstr("run of the certificate is no object"));
    EXPECT_THAT(refused(with("\"run\": {}", "\"run\": {\"seed\": 1}")), HasSubstr("it was changed"));
    EXPECT_THAT(refused(with("\"ranges\": []", "\"ranges\": [1]")), HasSubstr("a range is no text"));
    EXPECT_THAT(refused(with("\"ranges\": []", "\"ranges\": [], \"more\": 1")), HasSubstr("unknown"));
    EXPECT_THAT(refused(with("\"answer\": \"holds\"", "\"answer\": \"fails\"")), HasSubstr("it was changed"));
    EXPECT_THAT(refused(std::string(17U << 20U, ' ')), HasSubstr("longer"));
}

TEST(Certificates, EachDifferenceIsNamed) {
    driver::Evidence one;
    one.model = {{"a.rct", "1"}, {"b.rct", "2"}};
    one.assertions = {{"A1", "holds"}, {"A2", "holds"}};
    one.claims = {{"P", "holds", 16, 16, 0.5, 1}};
    driver::Evidence other = one;
    EXPECT_TRUE(evidence_differences(one, other).empty());
    other.model = {{"a.rct", "3"}, {"c.rct", "2"}};
    other.assertions = {{"A1", "fails"}, {"A3", "holds"}};
    other.conformance = {{"S", "conforms"}};
    other.seed = 5;
    other.claims[0].low = 0.4;
    EXPECT_EQ(evidence_differences(one, other).size(), 10U)
        << "a and b changed or gone, c new; A1, A2, A3; S, a count; seed, claim";
}

}  // namespace
}  // namespace robochart::app::tune_test
