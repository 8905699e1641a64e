// SPDX-License-Identifier: Apache-2.0
// Tests probabilistic assertions that are decided in RoboTool's encoding. The chains are so small that the expected
// values can be computed by hand. Those of the case studies come from recorded results.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "prism/emit/preferences.hpp"
#include "prism/syntax/printer.hpp"
#include "prism/syntax/reader.hpp"
#include "tests/contents.hpp"
#include "tests/prism/assertions/models.hpp"
#include "tests/prism/emit/structure.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::probability {
namespace {

namespace fs = std::filesystem;
using testing::load;
using testing::robotool_rows;
using testing::rows_text;

/// A coin that is thrown until it shows heads. Its Markov chain visits the initial node, Ready, the junction, then
/// Heads (with probability p) or Ready again. Each visit is one step. `stop` comes from the platform, and no other
/// event is possible in Ready.
const char* const coin = R"(package coin
	enumeration Side { Head Tail }
	interface Shown { var side : Side, throws : nat }
	robotic platform Table { provides Shown event throw }
	stm Thrower {
		requires Shown
		event throw
		const p : real
		initial i
		state Ready { }
		state Heads { entry side = Side::Head }
		state Again { initial j state Inner { } transition u { from j to Inner } }
		probabilistic toss
		transition t0 { from i to Ready }
		transition t1 { from Ready to toss trigger throw }
		transition t2 { from toss to Heads probability p }
		transition t3 { from toss to Ready probability 1 - p }
		transition t4 { from Heads to Again trigger throw }
	}
	controller Hand { requires Shown event throw sref thrower = Thrower connection Hand on throw to thrower on throw }
	module Game { rref table = Table cref hand = Hand connection table on throw to hand on throw ( _async ) }
)";

std::vector<Row> rows_of(const std::string& assertions, const std::string& name = "P",
                         const RoboToolOptions& options = testing::small_ranges(), bool exact = true) {
    const auto loaded = load({{"coin.rct", coin}, {"coin.assertions", "import coin::*\n" + assertions}});
    return robotool_rows(*loaded, name, options, {1e-6, exact});
}

const std::string half = " with constants Game::hand::thrower::p set to 0.5";

TEST(RoboToolChain, IsAskedForValuesAndTruths) {
    const std::string heads = "Game::hand::thrower is in Game::hand::thrower::Heads";
    EXPECT_EQ(rows_text(rows_of("prob property P: Prob=? of [Finally " + heads + "]" + half)),
              "Game::hand::thrower::p=0.5: 1");
    EXPECT_EQ(rows_text(rows_of("prob property P: Prob>=0.9 of [Finally " + heads + "]" + half)),
              "Game::hand::thrower::p=0.5: true");
    // The chain has four steps: to Ready, to the junction, to Heads_entering, to Heads.
    EXPECT_EQ(rows_text(rows_of("prob property P: Prob=? of [Finally <=3 " + heads + "]" + half)),
              "Game::hand::thrower::p=0.5: 0");
    EXPECT_EQ(rows_text(rows_of("prob property P: Prob=? of [Finally <=4 " + heads + "]" + half)),
              "Game::hand::thrower::p=0.5: 0.5");
    EXPECT_EQ(rows_text(rows_of("prob property P: Prob<0.5 of [Finally <5 " + heads + "]" + half)),
              "Game::hand::thrower::p=0.5: false");
    EXPECT_EQ(rows_text(rows_of("prob property P: Forall [Finally " + heads + "]" + half)),
              "Game::hand::thrower::p=0.5: false")
        << "it may come up tails for ever";
    EXPECT_EQ(rows_text(rows_of("prob property P: not Exists [Finally deadlock]" + half)),
              "Game::hand::thrower::p=0.5: true");
}

TEST(RoboToolChain, IsTriedForEveryValueOfASet) {
    const std::string few =
        "const k : core::nat\n"
        "constants Few: Game::hand::thrower::p from set {0.5, 0.25}, and k from set {4 to 8 by step 2}\n"
        "label heads = Game::table::side == Side::Head /\\ Game::hand::thrower is in Heads\n"
        "prob property P: Prob=? of [Finally <=k #heads] with constants Few";
    // After 4 steps there was one throw, after 6 steps two.
    EXPECT_EQ(rows_text(rows_of(few)),
              "Game::hand::thrower::p=0.5, k=4: 0.5\n"
              "Game::hand::thrower::p=0.5, k=6: 0.75\n"
              "Game::hand::thrower::p=0.5, k=8: 0.875\n"
              "Game::hand::thrower::p=0.25, k=4: 0.25\n"
              "Game::hand::thrower::p=0.25, k=6: 0.4375\n"
              "Game::hand::thrower::p=0.25, k=8: 0.578125");
}

TEST(RoboToolChain, EarnsRewards) {
    // A fair coin needs 1 / 0.5 throws until heads.
    EXPECT_EQ(rows_text(rows_of("rewards throws = [Game::hand::thrower::throw.in] true : 1; endrewards\n"
                                "prob property P: Reward {throws} =? of [Reachable Game::hand::thrower is in Heads]" +
                                half)),
              "Game::hand::thrower::p=0.5: 2");
    EXPECT_EQ(rows_text(rows_of("rewards throws = [Game::table::throw.out] true : 1; endrewards\n"
                                "prob property P: Reward {throws} =? of [Cumul 5]" +
                                half)),
              "Game::hand::thrower::p=0.5: 2")
        << "the second step throws; after tails the fourth does, after heads the fifth, which leaves Heads";
    EXPECT_EQ(rows_text(rows_of("const c : core::nat rewards waits = Game::hand::thrower is in Ready : c; endrewards\n"
                                "prob property P: Reward {waits} =? of [Reachable Game::hand::thrower is in Heads]"
                                " with constants c set to 3, Game::hand::thrower::p set to 0.5")),
              "c=3, Game::hand::thrower::p=0.5: 6");
}

TEST(RoboToolChain, KnowsFormulasFunctionsAndModules) {
    EXPECT_EQ(
        rows_text(rows_of(
            "formula ready = Game::hand::thrower is in Ready\n"
            "defs D: pfunction twice(x) = { return $$x + $$x } pfunction quad(x) = { return &twice(&twice($$x)) }\n"
            "prob property P: Prob=? of [Finally <=4 (not $ready) /\\ "
            "Game::hand::thrower is in Heads /\\ &quad(1) == 4]" +
            half + " with definitions D")),
        "Game::hand::thrower::p=0.5: 0.5");
    // The observer counts to 2 throws and refuses a third one, so the coin must show heads at the first or second
    // throw.
    EXPECT_EQ(
        rows_text(rows_of("pmodules M: pmodule Count { n : [0 to 2] init 0; "
                          "[Game::table::throw.out] @n < 2 -> (@n = @n + 1); [] @n == 2 -> skip; }\n"
                          "prob property P: Prob=? of [Finally Game::hand::thrower is in Heads /\\ @M::Count::n <= 2]" +
                          half + " with modules M")),
        "Game::hand::thrower::p=0.5: 0.75");
    EXPECT_EQ(rows_text(rows_of("pmodules M: pmodule Flip { up : bool init false; "
                                "[Game::table::throw.out] not @up -> (0.25 : @up = true) & (0.75 : @up = false); }\n"
                                "prob property P: Prob=? of [Finally <=2 @M::Flip::up] with modules M" +
                                    std::string(),
                                "P",
                                [] {
                                    RoboToolOptions options = testing::small_ranges();
                                    options.constants["thrower::p"] = "0.5";
                                    return options;
                                }())),
              "0.25");
}

TEST(RoboToolChain, InnerStatesAreAskedFor) {
    EXPECT_EQ(rows_text(rows_of("prob property P: Prob=? of [Finally Game::hand::thrower is in "
                                "Game::hand::thrower::Again::Inner]" +
                                half)),
              "Game::hand::thrower::p=0.5: 1");
}

/// The test samples 1000 throws of a fair coin. All intervals are computed from the number of hits, which the seed
/// determines.
TEST(RoboToolChain, IsSampled) {
    const std::string sampled = "Prob=? of [Finally <=4 Game::hand::thrower is in Heads] using sim with ";
    const auto rows = rows_of("prob property P: " + sampled + "CI at pathlen=100, n=1000, and alpha=0.001" + half);
    ASSERT_EQ(rows.front().error, "");
    const prism::Result& result = rows.front().results.front();
    ASSERT_TRUE(result.estimate && result.estimate->binomial);
    EXPECT_EQ(result.estimate->method, prism::Method::Kind::ci);
    EXPECT_EQ(result.estimate->samples, 1000u);
    EXPECT_EQ(result.estimate->alpha, 0.001);
    EXPECT_LT(result.estimate->binomial->low, 0.5);
    EXPECT_GT(result.estimate->binomial->high, 0.5);
    EXPECT_EQ(rows.front().states, 0u) << "nothing is explored";
    const auto same = rows_of("prob property P: " + sampled + "CI at pathlen=100, n=1000, and alpha=0.001" + half);
    EXPECT_EQ(same.front().results.front().estimate->hits, result.estimate->hits);
    const auto apmc =
        rows_of("prob property P: " + sampled + "APMC at epsilon=0.1, delta=0.01, and pathlen=100" + half);
    EXPECT_EQ(apmc.front().results.front().estimate->samples, 265u) << "ln(200) / 0.02";
    EXPECT_EQ(
        rows_text(rows_of("prob property P: Prob>=0.9 of [Finally <=4 Game::hand::thrower is in Heads] using sim with "
                          "SPRT at delta=0.05, alpha=0.001, and pathlen=100" +
                          half)),
        "Game::hand::thrower::p=0.5: false");
    EXPECT_EQ(rows_text(rows_of("prob property P: " + sampled + "CI at n=10, alpha=0.01, and pathlen=3" + half)),
              "Game::hand::thrower::p=0.5: not decided: path 1 is open after 3 steps (path=3)");
    EXPECT_EQ(rows_text(rows_of("prob property P: " + sampled + "CI at n=10, alpha=2, and pathlen=3" + half)),
              "Game::hand::thrower::p=0.5: `using sim with`: confidence=2: expected a number between 0 and 1");
    EXPECT_EQ(rows_text(rows_of("prob property P: " + sampled + "SPRT at n=10, alpha=0.1, and pathlen=3" + half)),
              "`sim with SPRT` has no parameter `n`: alpha, delta, pathlen");
    EXPECT_EQ(rows_text(rows_of("prob property P: not " + sampled + "CI at n=10, alpha=0.1, and pathlen=3" + half)),
              "`using sim` inside another expression: random paths answer one probability or reward");
}

TEST(RoboToolChain, IsSampledWithExpressions) {
    const std::string sampled = "Prob=? of [Finally <=4 Game::hand::thrower is in Heads] using sim with ";
    const auto rows =
        rows_of("const k : core::nat\n prob property P: " + sampled +
                "CI at pathlen=(if k > 1 then 100 else 3 end), n=10*k + 5, and alpha=Game::hand::thrower::p/50" + half +
                ", k from set {1, 2}");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows_text({rows.front()}),
              "Game::hand::thrower::p=0.5, k=1: not decided: path 1 is open after 3 steps (path=3)");
    ASSERT_TRUE(rows.back().results.front().estimate);
    EXPECT_EQ(rows.back().results.front().estimate->samples, 25u);
    EXPECT_EQ(rows.back().results.front().estimate->alpha, 0.01);
    EXPECT_EQ(rows_text(rows_of("prob property P: " + sampled + "CI at n=5/2, alpha=0.1, and pathlen=3" + half)),
              "Game::hand::thrower::p=0.5: `using sim with`: samples=2.5: expected a number from 1 on");
    const auto fault = [](const std::string& of) { return rows_of(of).front().error; };
    EXPECT_NE(fault("prob property P: " + sampled + "CI at n=Game::table::throws, alpha=0.1, and pathlen=3" + half), "")
        << "a variable is no number";
    EXPECT_NE(fault("const k : core::nat\n prob property P: " + sampled + "CI at n=k, alpha=0.1, and pathlen=3" + half),
              "")
        << "k has no value";
    const auto paths = rows_of("const k : core::nat\n prob generate path P: using simulation for 2*k steps" + half +
                               ", k from set {1 to 2}");
    ASSERT_EQ(paths.size(), 2u);
    EXPECT_EQ(paths.front().path->steps.size(), 2u);
    EXPECT_EQ(paths.back().path->steps.size(), 4u);
    EXPECT_NE(fault("prob generate path P: using simulation for 1/2 steps" + half), "");
}

/// The steps of the chain are known. The results of the throws depend on the seed.
TEST(RoboToolChain, GivesAPathInTheWordsOfTheModel) {
    const auto rows = rows_of("prob generate path P: using simulation for 4 steps" + half);
    ASSERT_EQ(rows.front().error, "");
    ASSERT_TRUE(rows.front().path);
    const Path& path = *rows.front().path;
    EXPECT_EQ(path.begin,
              "Game::Table::side = Head, Game::Table::throws = 0, Game::hand::thrower at i, "
              "Game::hand::thrower::Again at no state");
    ASSERT_EQ(path.steps.size(), 4u);
    EXPECT_EQ(path.steps[0].by, "Game::hand::thrower");
    EXPECT_EQ(path.steps[0].changes, "Game::hand::thrower at Ready");
    EXPECT_EQ(path.steps[1].by, "Game::hand::thrower::throw.in, Game::Table::throw.out");
    EXPECT_EQ(path.steps[1].changes, "Game::hand::thrower at toss");
    const bool heads = path.steps[2].changes == "Game::hand::thrower at the entry of Heads";
    EXPECT_TRUE(heads || path.steps[2].changes == "Game::hand::thrower at Ready") << path.steps[2].changes;
    EXPECT_EQ(path.steps[3].changes, heads ? "Game::hand::thrower at Heads" : "Game::hand::thrower at toss");
    EXPECT_FALSE(path.deadlock);
    EXPECT_EQ(
        rows_text(rows_of("prob generate path P: using simulation for deadlock with 2 repeats up to 20 steps" + half)),
        "Game::hand::thrower::p=0.5: not decided: none of 3 paths of 20 steps reaches a deadlock");
    EXPECT_EQ(rows_text(rows_of("prob generate path P: using simulation for 1000000 steps" + half)),
              "Game::hand::thrower::p=0.5: a path has at most 100000 steps");
}

TEST(RoboToolChain, AsAnMdpHasALeastAndAGreatestValue) {
    RoboToolOptions options = testing::small_ranges();
    options.preferences.kind = prism::ModelKind::mdp;
    options.constants["p"] = "0.5";
    // This model has no nondeterminism, so all schedulers agree.
    EXPECT_EQ(
        rows_text(rows_of("prob property P: Prob=? of [Finally <=4 Game::hand::thrower is in Heads]", "P", options)),
        "0.5 to 0.5");
    EXPECT_EQ(rows_text(rows_of("prob property P: Prob max=? of [Finally <=4 Game::hand::thrower is in Heads]", "P",
                                options)),
              "0.5");
}

/// The limit has no value in the model. The machine counts until n is one beyond the limit.
const char* const counter = R"(package counter
	robotic platform Nothing { }
	stm Count {
		const limit : int
		var n : int = 0
		initial i
		state Run { }
		state Done { }
		transition t0 { from i to Run }
		transition t1 { from Run to Run condition n <= limit action n = n + 1 }
		transition t2 { from Run to Done condition n > limit }
	}
	controller Hand { sref s = Count }
	module All { rref r = Nothing cref c = Hand }
)";

TEST(RoboToolChain, RangesHoldTheConstantsThatAClaimSets) {
    const auto loaded = load({{"counter.rct", counter},
                              {"counter.assertions",
                               "import counter::*\n"
                               "prob property P: Prob=? of [Finally All::c::s is in Count::Done] with constants "
                               "All::c::s::limit from set {7, 20}\n"}});
    const auto rows = robotool_rows(*loaded, "P", testing::small_ranges(), {1e-6, true});
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows_text(rows), "All::c::s::limit=7: 1\nAll::c::s::limit=20: 1");
    RoboToolOptions options = testing::small_ranges();
    options.preferences.integer.asked = true;
    EXPECT_NE(robotool_rows(*loaded, "P", options, {1e-6, true}).front().error.find("outside its range"),
              std::string::npos)
        << "the user's own range stays";
}

/// Two machines throw a coin on request. The order of the requests and of the moves is open.
const char* const race = R"(package race
	robotic platform Table { event go }
	stm Thrower {
		event go
		initial i
		state Ready { }
		state Heads { }
		state Tails { }
		probabilistic toss
		transition t0 { from i to Ready }
		transition t1 { from Ready to toss trigger go }
		transition t2 { from toss to Heads probability 0.3 }
		transition t3 { from toss to Tails probability 0.7 }
		transition t4 { from Tails to Ready }
	}
	stm Caller {
		event go
		event one
		event two
		initial i
		state Waiting { }
		transition t0 { from i to Waiting }
		transition t1 { from Waiting to Waiting trigger go action send one }
		transition t2 { from Waiting to Waiting trigger go action send two }
	}
	controller Hands {
		event go
		sref caller = Caller
		sref left = Thrower
		sref right = Thrower
		connection Hands on go to caller on go
		connection caller on one to left on go ( _async )
		connection caller on two to right on go ( _async )
	}
	module Race { rref table = Table cref hands = Hands connection table on go to hands on go ( _async ) }
)";

/// If the model is read as an mdp, some scheduler makes the uniform choice of the chain. So the value of the chain is
/// between the minimum and the maximum.
TEST(RoboToolChain, LiesBetweenTheSchedulersOfItsText) {
    const std::string heads = "Race::hands::left is in Thrower::Heads";
    const std::string first = "Finally " + heads + " /\\ not Race::hands::right is in Thrower::Heads";
    const auto loaded = load({{"race.rct", race},
                              {"race.assertions",
                               "import race::*\n"
                               "rewards calls = [Race::hands::caller::go.in] true : 1; endrewards\n"
                               "prob property First : Prob=? of [" +
                                   first +
                                   "]\n"
                                   "prob property Soon : Prob=? of [Finally <=9 " +
                                   heads +
                                   "]\n"
                                   "prob property Calls : Reward {calls} =? of [Cumul 12]\n"}});
    RoboToolOptions as_mdp = testing::small_ranges();
    as_mdp.preferences.kind = prism::ModelKind::mdp;
    for (const std::string name : {"First", "Soon", "Calls"}) {
        const auto chain = robotool_rows(*loaded, name, testing::small_ranges(), {1e-9, false});
        const auto all = robotool_rows(*loaded, name, as_mdp, {1e-9, false});
        ASSERT_EQ(chain.front().error + all.front().error, "");
        ASSERT_EQ(all.front().results.size(), 2u);
        const auto value = chain.front().results.front().low.bounds();
        const auto least = all.front().results.front().low.bounds();
        const auto greatest = all.front().results.back().low.bounds();
        EXPECT_LE(least.low, value.high) << name;
        EXPECT_GE(greatest.high, value.low) << name;
        // All these models have nondeterminism.
        EXPECT_LT(least.high, value.low) << name;
        EXPECT_GT(greatest.low, value.high) << name;
    }
}

TEST(RoboToolChain, WhatHasNoCounterpartIsRefusedByName) {
    const auto refusal = [](const std::string& property) { return rows_text(rows_of("prob property P: " + property)); };
    EXPECT_EQ(refusal("Prob=? of [Finally deadlock]"),
              "the constant Game::hand::thrower::p has no value: give it one `with constants` or by --const");
    EXPECT_EQ(refusal("Prob=? of [Finally Thrower is in Thrower::Heads]"),
              "RoboTool's encoding has no state `Thrower::Heads`");
    EXPECT_EQ(refusal("Prob=? of [Finally Game::hand::thrower::throw.in.val == 0]"),
              "RoboTool's encoding has no value `Game::hand::thrower::throw.in`");
    EXPECT_EQ(rows_text(rows_of("formula f = $g formula g = $f prob property P: Prob=? of [Finally $f]")),
              "a definition that uses itself");
    EXPECT_EQ(rows_text(rows_of("prob property P: Prob=? of [Finally deadlock] with constants "
                                "Game::hand::thrower::p from set {0.5 to 0.1}")),
              "Game::hand::thrower::p: c=0.5:1:0.1: the range is empty");
}

TEST(RoboToolChain, MistakesOfAProbabilityHaveTheState) {
    const std::string found =
        rows_text(rows_of("prob property P: Prob=? of [Finally deadlock] with constants "
                          "Game::hand::thrower::p set to 2"));
    EXPECT_NE(found.find("2 is not a probability"), std::string::npos) << found;
    EXPECT_NE(found.find("in the state"), std::string::npos) << found;
}

// ---------------------------------------------------------------- case studies

fs::path suite(const std::string& name) {
    const fs::path shared = tests::shared_folder();
    return shared.empty() ? fs::path() : shared / "suite/prism" / name;
}

std::map<std::string, std::string> files_in(const fs::path& folder) {
    std::map<std::string, std::string> result;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".rct" || entry.path().extension() == ".assertions")
            result[fs::relative(entry.path(), folder).string()] = tests::read_contents(entry.path());
    return result;
}

RoboToolOptions preferences_of(const fs::path& folder) {
    RoboToolOptions options;
    EXPECT_EQ(
        prism_emit::read_preferences(tests::read_contents(folder / "prism-gen/rc2prism.prefs"), options.preferences),
        "");
    return options;
}

/// Returns the recorded value for a set of constants and t.
double recorded(const fs::path& folder, const std::string& set, const std::string& t) {
    std::istringstream lines(tests::read_contents(folder / "EXPECTED.tsv"));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream cells(line);
        std::vector<std::string> row;
        for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
        if (row.size() > 6 && row[0] == set && row[1] == t) return std::stod(row[6]);
    }
    return -1;
}

TEST(UvcAssertions, GiveTheRecordedValue) {
    const fs::path folder = suite("uvc");
    if (!fs::exists(folder)) GTEST_SKIP() << "no case study at hand";
    auto files = files_in(folder);
    // The test uses only one value of t, with which it takes a few seconds.
    std::string& config = files.at("Properties/config.assertions");
    const auto begin = config.find("constants C20_noOds_delibrate");
    const auto range = config.find("{1 to 19 by step 1}", begin);
    config.replace(range, std::string("{1 to 19 by step 1}").size(), "{5}");
    const auto loaded = load(files);
    const auto rows = robotool_rows(*loaded, "P_dangerous_C20_noOds_delibrate", preferences_of(folder));
    ASSERT_EQ(rows.size(), 1u);
    ASSERT_EQ(rows.front().error, "");
    EXPECT_EQ(rows.front().states, 497'567u);
    EXPECT_EQ(rows.front().transitions, 1'919'756u);
    const double expected = recorded(folder, "C20_noOds_delibrate", "5");
    const auto bounds = rows.front().results.front().low.bounds();
    EXPECT_LE(bounds.low, expected * (1 + 1e-10));
    EXPECT_GE(bounds.high, expected * (1 - 1e-10));
    EXPECT_LE(bounds.high - bounds.low, 1e-6 * expected);
}

prism::ModelFile read(const fs::path& path) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto source = sources.add(path.string(), tests::read_contents(path));
    prism::ModelFile model = prism::read_model(sources, source, findings);
    EXPECT_TRUE(findings.ok()) << path;
    return model;
}

/// Returns the lines of a module, without the numbers in names, blanks and parentheses.
std::multiset<std::string> lines_of(const prism::ModelFile& model, const std::string& module) {
    prism::ModelFile alone;
    for (const prism::Module& candidate : model.modules)
        if (candidate.name.text == module) alone.modules.push_back(candidate);
    std::string text = std::regex_replace(prism::print(alone), std::regex("_[0-9]+|[ ()]"), "");
    // Replaces literals by their numbers.
    for (const prism::Constant& constant : model.constants)
        if (constant.value && constant.value->op == prism::Op::integer)
            text = std::regex_replace(text, std::regex("\\b" + constant.name.text + "\\b"), constant.value->text);
    std::multiset<std::string> result;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) result.insert(line);
    return result;
}

Question hvc_question(const testing::Loaded& loaded, const fs::path& folder, const std::string& name,
                      prism::ModelFile& model) {
    const Assertions all(loaded.model);
    const testing::Claim claim = testing::find_claim(loaded, name);
    RoboToolEncoding encoding(loaded.system, loaded.system.modules.front(), preferences_of(folder),
                              functions_of(all, *claim.file, *claim.assertion));
    Question question = translate_assertion(all, *claim.file, *claim.assertion, encoding.elements());
    model = encoding.model_for(question);
    return question;
}

/// Functions defined in assertions are added to the model, as in RoboTool.
TEST(HvcAssertions, DefineTheFunctionsOfTheModel) {
    const fs::path folder = suite("robotool/hvc");
    if (!fs::exists(folder)) GTEST_SKIP() << "no case study at hand";
    const auto loaded = load(files_in(folder));
    prism::ModelFile model;
    (void)hvc_question(*loaded, folder, "P_deadlock_free", model);
    const auto found = prism_emit::testing::find_differences(read(folder / "prism-gen/P4.prism"), model);
    EXPECT_TRUE(found.empty()) << found.size() << " differences, the first: " << found.front();
}

/// Modules of assertions are added to the model, with RoboTool's labels and values.
TEST(HvcAssertions, AddTheirModules) {
    const fs::path folder = suite("robotool/hvc");
    if (!fs::exists(folder)) GTEST_SKIP() << "no case study at hand";
    const auto loaded = load(files_in(folder));
    for (const std::string name : {"P1A", "P1B", "P2", "P3"}) {
        prism::ModelFile model;
        (void)hvc_question(*loaded, folder, name, model);
        const auto expected = lines_of(read(folder / "prism-gen" / (name + ".prism")), name);
        EXPECT_GT(expected.size(), 5u) << name;
        EXPECT_EQ(lines_of(model, name), expected);
    }
}

}  // namespace
}  // namespace robochart::probability
