// SPDX-License-Identifier: Apache-2.0
// Tests nested path formulas. Random formulas are decided on lassos and compared with a naive evaluation of the
// semantics, which follows the only path of the lasso state by state. The expected values for models with choices are
// computed by hand.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

#include "base/diagnostics/splitmix64.hpp"
#include "prism/session/evaluator.hpp"
#include "tests/prism/support.hpp"

namespace robochart::prism {
namespace {

using testing::Explored;

class Random {
public:
    explicit Random(std::uint64_t seed) : seed_(seed) {}
    int below(int bound) { return static_cast<int>(diagnostics::splitmix64(seed_) % static_cast<unsigned>(bound)); }

private:
    std::uint64_t seed_;
};

/// Returns a random subset of the states 0..size-1.
std::string atom(Random& random, int size) {
    std::string text = "(s=" + std::to_string(random.below(size));
    while (random.below(2) == 0) text += "|s=" + std::to_string(random.below(size));
    return text + ")";
}

std::string random_bound(Random& random) {
    switch (random.below(8)) {
        case 0:
            return "<=" + std::to_string(random.below(4));
        case 1:
            return ">=" + std::to_string(random.below(3));
        case 2:
            return "[1," + std::to_string(1 + random.below(3)) + "]";
        default:
            return "";
    }
}

std::string formula(Random& random, int size, int depth) {
    if (depth == 0) return atom(random, size);
    const std::string a = "(" + formula(random, size, depth - 1) + ")";
    const std::string b = "(" + formula(random, size, depth - 1) + ")";
    switch (random.below(11)) {
        case 0:
            return "!" + a;
        case 1:
            return a + " & " + b;
        case 2:
            return a + " | " + b;
        case 3:
            return a + " => " + b;
        case 4:
            return a + " <=> " + b;
        case 5:
            return "X " + a;
        case 6:
            return "F" + random_bound(random) + " " + a;
        case 7:
            return "G" + random_bound(random) + " " + a;
        case 8:
            return a + " U" + random_bound(random) + " " + b;
        case 9:
            return a + " W" + random_bound(random) + " " + b;
        default:
            return a + " R" + random_bound(random) + " " + b;
    }
}

/// A path through the states 0, 1, ..., size-1, which then repeats the states from `loop` on.
class Lasso {
public:
    Lasso(int size, int loop) : size_(size), loop_(loop) {}

    [[nodiscard]] std::string model() const {
        std::string text = "dtmc module M s:[0.." + std::to_string(size_ - 1) + "];\n";
        for (int s = 0; s < size_; ++s)
            text += "[] s=" + std::to_string(s) + " -> (s'=" + std::to_string(next(s)) + ");\n";
        return text + "endmodule\n";
    }

    [[nodiscard]] bool holds(const ExprPtr& expr, int at) const {
        const auto part = [&](std::size_t i, int where) { return holds(expr->parts[i], where); };
        switch (expr->op) {
            case Op::equal:
                return std::stoi(expr->parts[1]->text) == at;
            case Op::negation:
                return !part(0, at);
            case Op::conjunction:
                return part(0, at) && part(1, at);
            case Op::disjunction:
                return part(0, at) || part(1, at);
            case Op::implies:
                return !part(0, at) || part(1, at);
            case Op::iff:
                return part(0, at) == part(1, at);
            case Op::next:
                return part(0, next(at));
            case Op::eventually:
                return until(
                    *expr, at, [](int) { return true; }, [&](int s) { return part(0, s); });
            case Op::globally:
                return !until(
                    *expr, at, [](int) { return true; }, [&](int s) { return !part(0, s); });
            case Op::until:
                return until(
                    *expr, at, [&](int s) { return part(0, s); }, [&](int s) { return part(1, s); });
            case Op::release:
                return !until(
                    *expr, at, [&](int s) { return !part(0, s); }, [&](int s) { return !part(1, s); });
            default:  // a W b: not (a & !b) U (!a & !b)
                return !until(
                    *expr, at, [&](int s) { return part(0, s) && !part(1, s); },
                    [&](int s) { return !part(0, s) && !part(1, s); });
        }
    }

private:
    [[nodiscard]] int next(int s) const { return s + 1 < size_ ? s + 1 : loop_; }

    [[nodiscard]] bool until(const Expr& expr, int at, const std::function<bool(int)>& left,
                             const std::function<bool(int)>& right) const {
        const auto number = [](const ExprPtr& side) { return std::stoi(side->text); };
        const int from = expr.steps && expr.steps->low ? number(expr.steps->low) : 0;
        const int to = expr.steps && expr.steps->high ? number(expr.steps->high) : from + 2 * size_;
        for (int step = 0; step <= to; ++step, at = next(at)) {
            if (step >= from && right(at)) return true;
            if (!left(at)) return false;
        }
        return false;
    }

    int size_, loop_;
};

TEST(PrismPathFormulas, AgreeWithANaiveReadingOfLassos) {
    constexpr int size = 6;
    int decided = 0;
    int open = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        Random random(seed);
        const Lasso lasso(size, random.below(size));
        Explored model(lasso.model());
        const std::string text = formula(random, size, 3);
        testing::Read read;
        const PropertyFile file = read_properties(read.sources, read.add("P=? [ " + text + " ]"), read.diagnostics);
        ASSERT_EQ(read.findings(), "") << text;
        const Result found = model.ask("P=? [ " + text + " ]", {1e-6, true, nullptr});
        if (found.kind == Result::Kind::unknown) {
            ++open;
            continue;
        }
        ++decided;
        const bool expected = lasso.holds(file.properties[0].expression->parts[0], 0);
        EXPECT_EQ(found.low.text(), expected ? "1" : "0") << text << "\n" << lasso.model();
    }
    EXPECT_GT(decided, 300);
    EXPECT_GT(open, 0);  // some formulas are outside the supported automata and must stay open
}

std::string answer(const char* model, const std::string& property) {
    Explored explored(model);
    const Result found = explored.ask(property, {1e-6, true, nullptr});
    if (found.kind == Result::Kind::truth) return found.truth ? "true" : "false";
    return found.kind == Result::Kind::number ? found.low.text() : "not decided: " + found.reason;
}

const char* const chain =
    "dtmc module M s:[0..4];\n"
    "[] s=0 -> 0.5:(s'=1) + 0.25:(s'=2) + 0.25:(s'=3);\n"
    "[] s=1 -> (s'=4); [] s=4 -> (s'=1);\n"
    "[] s=2 -> true; [] s=3 -> (s'=0);\n"
    "endmodule\n";

/// State 0 goes to 1 with probability 1/2 (and then alternates between 1 and 4 forever), to 2 forever with 1/4, and
/// back through 3 with 1/4. In the limit, two thirds of the paths go to 1 and one third to 2.
TEST(PrismPathFormulas, AreDecidedOnAChain) {
    EXPECT_EQ(answer(chain, "P=? [ F (s=3 & X s=0) ]"), "0.25");
    EXPECT_EQ(answer(chain, "P=? [ F (s=3 & F s=2) ]"), "1/12");  // 1/4 * 1/3
    EXPECT_EQ(answer(chain, "P=? [ (F s=3) & (F s=2) ]"), "1/12");
    EXPECT_EQ(answer(chain, "P=? [ (G s!=3) & F s=2 ]"), "0.25");
    EXPECT_EQ(answer(chain, "P=? [ (F s=3) | (G F s=2) ]"), "0.5");  // 1/4, and 1/4 without 3
    EXPECT_EQ(answer(chain, "P=? [ (G F s=1) & (F s=3) ]"), "1/6");
    EXPECT_EQ(answer(chain, "P=? [ G (s=1 => X s=4) ]"), "1");
    EXPECT_EQ(answer(chain, "P=? [ G (s=1 => F s=1) ]"), "1");
    EXPECT_EQ(answer(chain, "P=? [ G (s=1 => X F s=2) ]"), "1/3");
    EXPECT_EQ(answer(chain, "P=? [ G F (s=1 & X s=4) ]"), "2/3");
    EXPECT_EQ(answer(chain, "P=? [ F G (s=1 | s=4) ]"), "2/3");
    EXPECT_EQ(answer(chain, "P=? [ F G (s=1 => X s=4) ]"), "1");
    EXPECT_EQ(answer(chain, "P=? [ s!=2 U<=2 (s=1 & X s=4) ]"), "0.5");
    EXPECT_EQ(answer(chain, "P>=1 [ G (s=0 => F (s=1 | s=2)) ]"), "true");
    EXPECT_EQ(answer(chain, "filter(max, P=? [ F (s=3 & F s=2) ], s=3)"), "1/3");
}

/// A switch that the scheduler turns on or off.
const char* const turned =
    "mdp module M on : bool; n : [0..1];\n"
    "[turn] true -> 0.9:(on'=!on)&(n'=0) + 0.1:(n'=1);\n"
    "[stay] true -> (n'=0);\n"
    "endmodule\n";

TEST(PrismPathFormulas, AreDecidedForTheBestAndTheWorstScheduler) {
    EXPECT_EQ(answer(turned, "Pmax=? [ (G F on) & (G F !on) ]"), "1");
    EXPECT_EQ(answer(turned, "Pmin=? [ (G F on) | (G F !on) ]"), "1");
    EXPECT_EQ(answer(turned, "Pmin=? [ (G F on) & (G F !on) ]"), "0");
    EXPECT_EQ(answer(turned, "Pmax=? [ (G F on) & (F G !on) ]"), "0");
    EXPECT_EQ(answer(turned, "Pmax=? [ (G F on) & (F G n=0) ]"), "1");  // the switch stays on
    EXPECT_EQ(answer(turned, "Pmax=? [ (G F on) & (G n=0) ]"), "0.9");  // one turn has to succeed
    EXPECT_EQ(answer(turned, "Pmax=? [ F (on & X !on) ]"), "1");
    EXPECT_EQ(answer(turned, "Pmax=? [ (X on) & (X X !on) ]"), "0.81");
    EXPECT_EQ(answer(turned, "Pmax=? [ G (on => X !on) ]"), "1");  // the switch is never turned on
    EXPECT_EQ(answer(turned, "Pmin=? [ G (on => X !on) ]"), "0");
    EXPECT_EQ(answer(turned, "Pmax=? [ (X on) & G (on => X !on) ]"), "0.81");
    EXPECT_EQ(answer(turned, "Pmax=? [ G ((on => F !on) & (!on => F on)) ]"), "1");
}

TEST(PrismPathFormulas, ThatAreTooLargeAreNotDecided) {
    EXPECT_EQ(answer(chain, "P=? [ F (s=1 & G F (s=2 U G s=1)) ]").substr(0, 11), "not decided");
    EXPECT_EQ(answer(chain, "P=? [ G<=1000000 (s=0 | F s=2) ]").substr(0, 11), "not decided");
}

}  // namespace
}  // namespace robochart::prism
