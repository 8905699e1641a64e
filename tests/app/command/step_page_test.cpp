// SPDX-License-Identifier: Apache-2.0
// Tests `step --html`: the page offers the same steps as the terminal, and runs no code from the model. In a browser,
// keys lead to the expected states.
#include <gmock/gmock.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "base/cache/digest.hpp"
#include "base/diagnostics/splitmix64.hpp"
#include "tests/app/command.hpp"
#include "tests/app/command/page.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing::step_page_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using tests::read_contents;

/// The state space that a page embeds.
class Space {
public:
    explicit Space(const std::string& page)
        : data_(nlohmann::json::parse(
              texts_between(page, "<script type=\"application/json\" id=\"space\">", "</script>").at(0))) {}

    [[nodiscard]] std::size_t states() const { return data_["states"].size(); }
    [[nodiscard]] std::size_t offers(std::size_t state) const { return data_["states"][state][1].size() / 2; }
    /// Returns an offer in the terminal's format: "(hidden) t0: i -> A   m.rct:3".
    [[nodiscard]] std::string offer(std::size_t state, std::size_t number) const {
        const auto& label = data_["labels"].at(data_["states"][state][1].at(2 * number).get<std::size_t>());
        const std::string place = text(label[1]);
        return (label[2] == 1 ? "(hidden) " : "") + text(label[0]) + (place.empty() ? "" : "   " + place);
    }
    /// Returns the target state, or -1 if the page does not embed it.
    [[nodiscard]] long target(std::size_t state, std::size_t number) const {
        return data_["states"][state][1].at(2 * number + 1).get<long>();
    }
    /// Returns the offers of a state with their target states: "a>1 b>2".
    [[nodiscard]] std::string listed(std::size_t state) const {
        std::string line;
        for (std::size_t i = 0; i < offers(state); ++i)
            line += (i == 0 ? "" : " ") + offer(state, i) + ">" + std::to_string(target(state, i));
        return line;
    }
    [[nodiscard]] std::string text(const nlohmann::json& number) const {
        return data_["texts"].at(number.get<std::size_t>()).get<std::string>();
    }

private:
    nlohmann::json data_;
};

/// Returns the structure of a state: an operator with its operands in parentheses.
std::string structure(const nlohmann::json& data, std::size_t part) {
    const auto text = [&](const nlohmann::json& number) {
        return data["texts"].at(number.get<std::size_t>()).get<std::string>();
    };
    const auto& it = data["parts"].at(part);
    std::string result = text(it[0]);
    if (it.size() == 2) return result + " " + text(it[1]);
    for (std::size_t i = 2; i < it.size(); ++i)
        result += (i == 2 ? "(" : ", ") + structure(data, it[i].get<std::size_t>());
    return result + ")";
}

using Files = std::vector<std::pair<std::string, std::string>>;

/// Runs `step` on files in a folder and returns the page. "@NAME" in the arguments means the path of a file.
std::string page_of(const Files& files, std::vector<std::string> words) {
    const Folder folder(files);
    for (std::string& word : words)
        if (word.starts_with("@")) word = folder / word.substr(1);
    words.insert(words.begin(), "step");
    words.insert(words.end(), {"--html", folder / "page.html"});
    const Ran ran = run(words);
    EXPECT_EQ(ran.exit, 0) << ran.err;
    return read_contents(folder / "page.html");
}

TEST(StepPage, EmbedsTheStructure) {
    const std::string page = page_of({{"s.csp", "channel a, b\nP = a -> Q\nQ = b -> P\n"}}, {"@s.csp", "P ||| Q"});
    const auto data = nlohmann::json::parse(
        texts_between(page, "<script type=\"application/json\" id=\"space\">", "</script>").at(0));
    EXPECT_EQ(structure(data, data["structures"].at(0).get<std::size_t>()), "|||(P offers {a}, Q offers {b})");
    EXPECT_THAT(page, HasSubstr("<details id=\"structure\" open>"));
    EXPECT_THAT(page, HasSubstr("<li>P <small>offers {a}</small></li>")) << "without script";
}

// P is state 0, Q is state 1, STOP is state 2.
TEST(StepPage, EmbedsTheStatesOfAScript) {
    const Space space(page_of({{"s.csp", "channel a, b\nP = a -> Q [] b -> STOP\nQ = b -> P\n"}}, {"@s.csp", "P"}));
    ASSERT_EQ(space.states(), 3U);
    EXPECT_EQ(space.listed(0), "a>1 b>2");
    EXPECT_EQ(space.listed(1), "b>0");
    EXPECT_EQ(space.listed(2), "");
}

TEST(StepPage, ReportsWhereItEnds) {
    const Folder folder(Files{{"s.csp", "channel a, b\nP(n) = n < 6000 & a -> P(n+1) [] b -> P(0)\n"}});
    const Ran ran = run({"step", folder / "s.csp", "P(0)", "--html", folder / "page.html"});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("5000 states; the limit of 5000 states was reached; found and left out: 1\n"));
    const std::string page = read_contents(folder / "page.html");
    EXPECT_THAT(page, HasSubstr("5000 states; the limit of 5000 states was reached; found and left out: 1;"));
    const Space space(page);
    ASSERT_EQ(space.states(), 5000U);
    EXPECT_EQ(space.listed(4998), "a>4999 b>0");
    EXPECT_EQ(space.listed(4999), "a>-1 b>0") << "all offers, but nothing behind the limit";
}

// Exploration takes longer for each state than for the previous one, so the time ends before the last state.
TEST(StepPage, KeepsWhatWasExploredWhenTheTimeIsOver) {
    const Folder folder(Files{{"s.csp",
                               "channel a\nf(n) = if n == 0 then 0 else f(n-1)\n"
                               "P(n) = f(20000+n) == 0 & a -> P(n+1)\n"}});
    const Ran ran = run({"step", folder / "s.csp", "P(0)", "--timeout", "1", "--html", folder / "page.html"});
    EXPECT_EQ(ran.exit, 3) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("the time limit was reached; found and left out: 1"));
    const Space space(read_contents(folder / "page.html"));
    ASSERT_GT(space.states(), 0U);
    EXPECT_EQ(space.listed(space.states() - 1), "a>-1");
}

TEST(StepPage, KeepsWhatCannotBeEvaluated) {
    const Folder folder(Files{{"s.csp", "channel a : {0..1}\nP = a?x -> Q(x)\nQ(1) = P\n"}});
    const Ran ran = run({"step", folder / "s.csp", "P", "--html", folder / "page.html"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("Q"));
    EXPECT_EQ(Space(read_contents(folder / "page.html")).listed(0), "a.0>1 a.1>2");
}

/// Returns the offers in each block of the terminal's output. There is one block for each state.
std::vector<std::vector<std::string>> shown(const std::string& out) {
    std::vector<std::vector<std::string>> result;
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty()) result.emplace_back();
        const std::size_t digit = line.find_first_not_of(' ');
        const std::size_t end = digit == std::string::npos ? digit : line.find("  ", digit);
        if (result.empty() || digit == std::string::npos || digit > 3 || digit < 1 || end == std::string::npos)
            continue;
        if (line.find_first_not_of("0123456789", digit) == end) result.back().push_back(line.substr(end + 2));
    }
    return result;
}

// Makes the same 2,000 choices in the page's data and in the terminal.
TEST(StepPage, AWalkOffersWhatTheTerminalOffers) {
    for (const std::vector<std::string>& time : {std::vector<std::string>{}, {"--untimed"}}) {
        std::vector<std::string> words{repository("corpus/aggregation")};
        words.insert(words.end(), time.begin(), time.end());
        const Space space(page_of({}, words));
        // The commands show hidden steps and return the walk to the initial state, so the first two blocks of output
        // precede it.
        std::string commands = "internal\nundo 0\n";
        std::vector<std::vector<std::string>> expected;
        std::size_t here = 0;
        std::uint64_t chance = 1;
        for (int i = 0; i < 2000; ++i) {
            std::vector<std::string> offers;
            for (std::size_t k = 0; k < space.offers(here); ++k) offers.push_back(space.offer(here, k));
            expected.push_back(offers);
            if (offers.empty()) {
                commands += "undo 0\n";
                here = 0;
                continue;
            }
            const std::size_t chosen = diagnostics::splitmix64(chance) % offers.size();
            commands += std::to_string(chosen + 1) + "\n";
            ASSERT_GE(space.target(here, chosen), 0);
            here = static_cast<std::size_t>(space.target(here, chosen));
        }
        words.insert(words.begin(), "step");
        const Ran ran = run(words, commands);
        EXPECT_EQ(ran.exit, 0) << ran.err;
        std::vector<std::vector<std::string>> blocks = shown(ran.out);
        ASSERT_EQ(blocks.size(), 2003U);
        blocks.erase(blocks.begin(), blocks.begin() + 2);
        blocks.pop_back();
        EXPECT_TRUE(blocks == expected);
    }
}

TEST(StepPage, ItsPolicyNamesItsStylesAndItsScriptAlone) {
    const std::string page = page_of({}, {repository("corpus/swarm_taxis")});
    const std::string policy = texts_between(page, "Content-Security-Policy\" content=\"", "\"").at(0);
    EXPECT_THAT(policy, HasSubstr("default-src 'none'"));
    EXPECT_THAT(policy, Not(HasSubstr("unsafe")));
    const auto scripts = texts_between(page, "<script>", "</script>");
    ASSERT_EQ(scripts.size(), 1U);
    EXPECT_THAT(policy, HasSubstr("'" + diagnostics::policy_hash(scripts.front()) + "'"));
    const auto styles = texts_between(page, "<style>", "</style>");
    EXPECT_GT(styles.size(), 1U) << "of the diagrams too";
    for (const std::string& style : styles) EXPECT_THAT(policy, HasSubstr("'" + diagnostics::policy_hash(style) + "'"));
    EXPECT_TRUE(all_matches(page, "( style=\"[^\"]*\")").empty()) << "the policy forbids attributes";
    EXPECT_TRUE(all_matches(page, "((?:src|href)=\"[^#\"][^\"]*\")").empty()) << "nothing is fetched";
    std::set<std::string> ids;
    for (const std::string& id : all_matches(page, " id=\"([^\"]*)\"")) EXPECT_TRUE(ids.insert(id).second) << id;
}

constexpr const char* lamp = R"(package p
stm S { event e : nat event f initial i var x : nat
state Off { } state On { entry wait(2) }
transition t0 { from i to Off }
transition t1 { from Off to On trigger e?x condition x > 0 }
transition t2 { from On to Off trigger f } })";

TEST(StepPage, ShowsTheFirstStateWithoutScript) {
    const std::string page = page_of({{"m.rct", lamp}}, {"@m.rct"});
    EXPECT_THAT(page, HasSubstr("<noscript>"));
    EXPECT_THAT(page, HasSubstr("<code>robochart-verify step</code> steps in a terminal"));
    const std::string offers = texts_between(page, "<ol id=\"offers\"", "</ol>").at(0);
    EXPECT_THAT(offers, HasSubstr("(hidden) t0: i -&gt; Off"));
    EXPECT_THAT(texts_between(page, "<ul id=\"machines\"", "</ul>").at(0), HasSubstr("p::S: at initial node i"));
}

TEST(StepPage, OperationsThatAreCalledAreDrawnToo) {
    const std::string page = page_of(
        {{"m.rct",
          R"(package p interface I { op() } operation unused() { initial i state V { } transition u0 { from i to V } }
operation op() { initial i state W { } final F transition u0 { from i to W } transition u1 { from W to F } }
stm S { requires I initial i state A { entry op() } transition t0 { from i to A } }
controller C { opref r = op sref a = S })"}},
        {"@m.rct", "C"});
    EXPECT_EQ(texts_between(page, "<figcaption>", "</figcaption>"),
              (std::vector<std::string>{"p::C::a", "p::C::a: operation op"}));
}

TEST(StepPage, NothingOfTheModelActs) {
    const std::string evil = "</script><img src=x onerror=alert(1)>\\\"'\xe2\x80\xae";
    const std::string page =
        page_of({{"<b>x.rct", "package p stm S { event e : string initial i state A { entry send e!\"" + evil +
                                  "\" } transition t0 { from i to A } }"}},
                {"@<b>x.rct", "S"});
    EXPECT_THAT(page, Not(HasSubstr("<img")));
    EXPECT_THAT(page, Not(HasSubstr("<b>")));
    EXPECT_THAT(page, Not(HasSubstr("\xe2\x80\xae"))) << "what turns the direction of writing is shown";
    EXPECT_EQ(texts_between(page, "<script", "</script>").size(), 2U) << "the data and the script";
    bool sent = false;
    const Space space(page);
    for (std::size_t state = 0; state < space.states(); ++state)
        for (std::size_t i = 0; i < space.offers(state); ++i)
            sent = sent || space.offer(state, i).find("<img src=x onerror=alert(1)>") != std::string::npos;
    EXPECT_TRUE(sent) << "as text it is there";
}

TEST(StepPage, ThatCannotBeWrittenIsAnError) {
    const Ran ran = run({"step", repository("corpus/aggregation"), "--html", "/proc/page.html"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("/proc/page.html"));
}

const std::string lamp_page =
    std::string("cat > m.rct <<'EOT'\n") + lamp + "\nEOT\n\"$verify\" step m.rct --html page.html";

class StepPageInABrowser : public InABrowser {};

const std::string status = "print document.getElementById('status').textContent\n";
const std::string address = "print location.hash\n";
const std::string lit =
    "print ['on', 'fired'].map((look) => Array.from(document.querySelectorAll('figure .' + look + ' > "
    "title')).map((title) => title.textContent))\n";

// The stable state Off offers e with 1, e with 2 (its condition excludes 0), and time. After e the machine waits for
// two time units, then accepts f. No output line reports a problem.
TEST_F(StepPageInABrowser, GoesWhereKeysLead) {
    const auto lines = play_page(lamp_page, status + "key 2\n" + status + lit +
                                                "print document.querySelector('#absences .reason').textContent\n"
                                                "key 1\n"
                                                "print document.querySelector('#machines .changed').textContent\n"
                                                "key t\n" +
                                                status + lit);
    ASSERT_EQ(lines.size(), 7U) << ::testing::PrintToString(lines);
    EXPECT_THAT(lines[0], HasSubstr("t=0: entered Off; 3 offers"));
    EXPECT_THAT(lines[1], HasSubstr("t=0: input e with 2 (t1: Off -> On); 1 offer"));
    EXPECT_THAT(lines[2], HasSubstr(R"([["state On"],["transition t1)"));
    EXPECT_THAT(lines[3], HasSubstr("the machine is not at rest: entry action of On, waiting"));
    EXPECT_EQ(lines[4], R"("wait left1was 2")");
    EXPECT_THAT(lines[5], HasSubstr("t=2: entered On; 2 offers")) << "hidden steps are taken at once";
    EXPECT_EQ(lines[6], R"([["state On"],["state On"]])") << "has been entered";
}

TEST_F(StepPageInABrowser, ComesBackAndKeepsTheWayInItsAddress) {
    const auto lines =
        play_page(lamp_page, address + "key 2\n" + address + "key t\nkey t\n" + address + "key u\n" + address +
                                 "key Backspace\n" + address + "back\n" + address + "key Home\n" + address +
                                 "click #way li:first-child button\n" + address + "open #1x2.2.1\n" + status +
                                 "open #1x2.9.1\n" + status + "open #<img>\n" + status);
    ASSERT_EQ(lines.size(), 11U) << ::testing::PrintToString(lines);
    const std::string rest = lines[0].substr(0, lines[0].size() - 1);  // the rest of the state before the first choice
    EXPECT_EQ(lines[1], rest + ".2\"");
    EXPECT_EQ(lines[2], rest + ".2.1x3\"") << "two time units, and that On is entered, which is hidden";
    EXPECT_EQ(lines[3], rest + ".2.1\"") << "undo takes back the last choice, with the hidden steps behind it";
    EXPECT_EQ(lines[4], rest + ".2\"");
    EXPECT_EQ(lines[5], rest + ".2.1\"") << "the browser goes back to before the last undo";
    EXPECT_EQ(lines[6], lines[0]);
    EXPECT_EQ(lines[7], "\"#0\"");
    EXPECT_THAT(lines[8], HasSubstr("step 4, t=1: one time unit passes"));
    EXPECT_THAT(lines[9], HasSubstr("followed to step 2 only"));
    EXPECT_THAT(lines[10], HasSubstr("followed to step 0 only"));
}

// There are twelve offers. 1 may be the start of a longer number, 3 may not, and 12 is complete.
TEST_F(StepPageInABrowser, TakesNumbersOfSeveralDigits) {
    const auto lines =
        play_page("printf 'channel a : {1..12}\\nP = a?x -> P\\n' > s.csp; \"$verify\" step s.csp P --html page.html",
                  "key 1\n" + status + "key Enter\n" + address + "key 3\n" + address + "key 1\nkey 2\n" + address +
                      "key 1\nkey 5\n" + status + "key 1\nkey Escape\nkey Enter\n" + address +
                      "print document.querySelectorAll('#offers button').length\n");
    EXPECT_THAT(lines, ElementsAre("\"offer 1: Enter takes it\"", "\"#1\"", "\"#1.3\"", "\"#1.3.12\"",
                                   "\"there is no offer 15\"", "\"#1.3.12\"", "12"));
}

// P has become Q, and folded parts stay folded.
TEST_F(StepPageInABrowser, ShowsTheStructure) {
    const std::string tree =
        "print [Array.from(document.querySelectorAll('#tree li > mark, #tree li > span'), (each) => each.tagName + ' ' "
        "+ "
        "each.textContent), document.querySelector('#tree details').open]\n";
    const auto lines = play_page(
        "printf 'channel a, b\\nP = a -> Q\\nQ = b -> P\\n' > s.csp; \"$verify\" step s.csp 'P ||| Q' --html page.html",
        tree + "key 1\n" + tree +
            "print void (document.querySelector('#tree details').open = false)\n"
            "print new Promise((done) => setTimeout(done))\nkey 1\n" +
            tree);
    ASSERT_EQ(lines.size(), 5U) << ::testing::PrintToString(lines);
    EXPECT_EQ(lines[0], R"([["SPAN P","SPAN Q"],true])");
    EXPECT_EQ(lines[1], R"([["MARK Q","SPAN Q"],true])");
    EXPECT_THAT(lines[4], HasSubstr("false"));
}

// The steps and the log are those of docs/step.md, "Saving a session".
TEST_F(StepPageInABrowser, WritesTheWayAsTheLogThatSaveWrites) {
    std::string keys = "key 1\nkey 1\nkey 1\n";
    for (int i = 0; i < 10; ++i) keys += "key t\n";
    const auto lines = play_page("\"$verify\" init wanderer > init.txt; \"$verify\" step wanderer --html page.html",
                                 keys + "key 1\nclick #log\nprint document.getElementById('log-text').value\n");
    std::string expected = R"("robochart-trace 1\ncomponent wanderer::Robot\ncycle 1\nrun by hand\n)"
                           R"(obstacle? forward! turn!90 tock\n)";
    for (int i = 0; i < 9; ++i) expected += R"(tock\n)";
    EXPECT_THAT(lines, ElementsAre(expected + R"(forward!\n")"));
}

TEST_F(StepPageInABrowser, RefusesLogsAsSaveDoes) {
    const auto lines = play_page(
        "printf 'stm S { event e initial i state A { } transition t0 { from i to A } transition t1 { from A to A "
        "trigger e } }' > m.rct; \"$verify\" step m.rct --html page.html",
        "key 1\nkey 1\nclick #log\n" + status);
    ASSERT_EQ(lines.size(), 1U) << ::testing::PrintToString(lines);
    EXPECT_THAT(lines[0], HasSubstr("happens twice within one time unit; a cycle reads each input once"));
}

TEST_F(StepPageInABrowser, IsQuietInTheDarkAndWithoutScript) {
    for (const std::string how : {"dark", "noscript"})
        EXPECT_THAT(play_page(lamp_page, "key 1\n", how), ElementsAre()) << how;
}

TEST_F(StepPageInABrowser, EndsWhereTheEmbeddedStatesEnd) {
    const auto lines = play_page(
        "printf 'channel a, b\nP(n) = n < 6000 & a -> P(n+1) [] b -> P(0)\n' > s.csp; \"$verify\" step s.csp 'P(0)' "
        "--html page.html",
        "open #1x4999\n" + status + "key 1\n" + address +
            "print document.getElementById('ends').textContent\n"
            "print document.querySelectorAll('#offers button:disabled').length\n"
            "print document.querySelectorAll('#way li').length\n"
            "print document.querySelector('#way li').textContent\nclick #way li button\n"
            "print document.querySelectorAll('#way li').length\nkey 2\n" +
            address);
    EXPECT_THAT(lines,
                ElementsAre("\"step 4999: a; 2 offers\"", "\"#1x4999\"",
                            "\"The embedded states end here (the limit of 5000 states was reached): behind 1 of 2 "
                            "offers there are others.\"",
                            "1", "201", "\"4799 steps before; show them all\"", "5000", "\"#1x4999.2\""));
}

// Forty states beside each other in one composite state are several times as wide as the page. The letters keep more
// than half of their size, and the figure scrolls instead of the page.
TEST_F(StepPageInABrowser, AWideMachineStaysReadable) {
    std::string wide =
        "stm Wide {\n event go\n initial i\n state Whole {\n initial j\n transition t { from j to N0 }\n";
    for (int n = 0; n < 40; ++n) {
        const std::string number = std::to_string(n);
        wide += " state N" + number + " { entry skip }\n transition t" + number + " { from N0 to N" + number +
                " trigger go }\n";
    }
    wide += " }\n transition s { from i to Whole }\n";
    const auto lines =
        play_page("cat > m.rct <<'EOT'\n" + wide + "}\nEOT\n\"$verify\" step m.rct --html page.html",
                  "print (() => { const svg = document.querySelector('.drawn svg');"
                  " const figure = svg.closest('figure'); const whole = svg.width.baseVal.value;"
                  " return [whole > 2 * figure.clientWidth, svg.getBoundingClientRect().width > whole / 2,"
                  " figure.scrollWidth > figure.clientWidth,"
                  " document.documentElement.scrollWidth <= innerWidth]; })()\n");
    EXPECT_THAT(lines, ElementsAre("[true,true,true,true]"));
}

// The address contains a path of 2,000 steps.
TEST_F(StepPageInABrowser, GoesALongWay) {
    const auto lines = play_page(lamp_page, "open #1x2.3x2000\n" + status + "key u\n" + status);
    ASSERT_EQ(lines.size(), 2U) << ::testing::PrintToString(lines);
    EXPECT_THAT(lines[0], HasSubstr("step 2002, t=2000: one time unit passes"));
    EXPECT_THAT(lines[1], HasSubstr("step 2001, t=1999"));
}

}  // namespace
}  // namespace robochart::app::testing::step_page_test
