// SPDX-License-Identifier: Apache-2.0
// Compares classes of values with all values of a fine grid. The classes must be exactly the combinations of answers
// that some value gives to the conditions.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <set>

#include "semantics/data/class_model.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/dump.hpp"
#include "tests/rounds.hpp"
#include "tests/semantics/lower/lowering_fixture.hpp"

namespace robochart::ir {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::optional<ClassModel> classes_of(const std::string& text) {
    const auto lowered = samples::lower_text(text);
    diagnostics::Diagnostics found;
    const Instantiation instantiation = instantiate_system(lowered->system, {}, found);
    return classify_data(lowered->system, instantiation).model;
}

/// Returns a machine that reads a value of this type into `x` and takes transitions with these guards.
std::string reading(const std::string& type, const std::vector<std::string>& guards) {
    std::string text = fmt::format(
        "package p\nimport sequence_toolkit::*\nimport set_toolkit::*\nimport relation_toolkit::*\n"
        "stm S {{\n event e : {0}\n var x : {0}\n initial i\n state A {{ }}\n junction k\n"
        " transition t0 {{ from i to A }}\n transition t1 {{ from A to k trigger e ? x }}\n",
        type);
    for (std::size_t g = 0; g < guards.size(); ++g)
        text += fmt::format(" transition g{} {{ from k to A condition {} }}\n", g, guards[g]);
    return text + "}\n";
}

/// Returns the data of the only flow class.
ReplacedData only_data(const std::string& text) {
    const auto model = classes_of(text);
    if (!model || model->data.size() != 1) {
        ADD_FAILURE() << (model ? model->data.size() : 0) << " flow classes\n" << text;
        return {};
    }
    return model->data.front();
}

using Random = std::mt19937_64;

int draw(Random& random, int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
}

const char* const relations[] = {"<", "<=", ">", ">=", "==", "!="};

bool related(int relation, double left, double right) {
    switch (relation) {
        case 0:
            return left < right;
        case 1:
            return left <= right;
        case 2:
            return left > right;
        case 3:
            return left >= right;
        case 4:
            return left == right;
        default:
            return left != right;
    }
}

/// A condition `p * x1 + q * x2 REL c`, with a small whole c and with factors of -1, 0 and 1.
struct Comparison {
    int p = 0, q = 0, c = 0, relation = 0;

    [[nodiscard]] std::string text() const {
        return fmt::format("({} * x[1] + {} * x[2] {} {})", p, q, relations[relation], c);
    }
    [[nodiscard]] bool holds(double x, double y) const { return related(relation, p * x + q * y, c); }
};

Comparison any_comparison(Random& random) {
    return {draw(random, -1, 1), draw(random, -1, 1), draw(random, -2, 2), draw(random, 0, 5)};
}

TEST(Classes, OfPairsOfRealsAreTheCombinationsThatExist) {
    Random random(36);
    for (std::size_t round = 0; round < tests::rounds(60); ++round) {
        std::vector<std::pair<Comparison, Comparison>> guards;
        std::vector<std::string> texts;
        for (int g = draw(random, 1, 4); g > 0; --g) {
            guards.emplace_back(any_comparison(random), any_comparison(random));
            texts.push_back(guards.back().first.text() + " /\\ not " + guards.back().second.text());
        }
        std::set<std::vector<bool>> answers;
        for (int x = -64; x <= 64; ++x)
            for (int y = -64; y <= 64; ++y) {
                std::vector<bool> of_point;
                for (const auto& [first, second] : guards)
                    of_point.push_back(first.holds(x / 8.0, y / 8.0) && !second.holds(x / 8.0, y / 8.0));
                answers.insert(of_point);
            }
        const std::string text = reading("real * real", texts);
        const ReplacedData data = only_data(text);
        EXPECT_TRUE(data.all_values);
        EXPECT_EQ(data.classes, answers.size()) << text;
    }
}

/// Findings about a guard of the model with classes have the place of the condition in the original model.
TEST(Classes, ARewrittenGuardKeepsThePlaceOfItsCondition) {
    const auto lowered = samples::lower_text(reading("real", {"x < 19.5", "x >= 19.5 /\\ x < 21.25"}));
    diagnostics::Diagnostics found;
    const auto model = classify_data(lowered->system, instantiate_system(lowered->system, {}, found)).model;
    ASSERT_TRUE(model);
    std::vector<std::string> texts;
    for (const Transition& transition : model->system.machines.front().transitions) {
        if (!transition.guard) continue;
        EXPECT_EQ(transition.guard->kind, ExprKind::is_in);
        const diagnostics::Span span = transition.guard->span;
        texts.emplace_back(lowered->sources.source_text(span.source).substr(span.begin, span.end - span.begin));
    }
    EXPECT_THAT(texts, ElementsAre("x < 19.5", "x >= 19.5 /\\ x < 21.25"));
}

TEST(Classes, OfOneNumberAreTheIntervalsBetweenThresholds) {
    EXPECT_EQ(only_data(reading("real", {"x < 19.5", "x > 21.25"})).classes, 3U);
    EXPECT_EQ(only_data(reading("real", {"x < 19.5", "x <= 19.5"})).classes, 3U);
    EXPECT_EQ(only_data(reading("nat", {"x < 1", "x > 1"})).classes, 3U);
    EXPECT_EQ(only_data(reading("nat", {"x < 0"})).classes, 1U);
    EXPECT_EQ(only_data(reading("nat", {"-x < -3", "x - 5 > 3"})).classes, 3U) << "0..3, 4..8, and more";
    EXPECT_EQ(only_data(reading("int", {"x > 1 /\\ x < 2"})).classes, 1U) << "there is no integer between 1 and 2";
    EXPECT_EQ(only_data(reading("real", {"x > 1 /\\ x < 2"})).classes, 2U);
    EXPECT_EQ(only_data(reading("int", {"2 * x == 5", "2 * x == 4"})).classes, 2U);
    EXPECT_EQ(only_data(reading("nat", {"x in {1, 3}"})).classes, 2U);
    EXPECT_EQ(only_data(reading("int", {"x in [1, 3]"})).classes, 2U);
}

/// A condition that compares one window of at most four places, or the whole sequence, with a number.
struct WindowTest {
    bool whole = false;
    int first = 1, last = 1, relation = 0;
    double number = 0;

    [[nodiscard]] std::string text() const {
        const std::string items = whole ? "x" : fmt::format("extract([{}, {}], x)", first, last);
        return fmt::format("min(ran({})) {} {:.1f}", items, relations[relation], number);
    }
    /// Returns 1 or 0, or -1 if the sequence has no place in the window.
    [[nodiscard]] int answer(const std::vector<double>& sequence) const {
        std::optional<double> least;
        const auto length = static_cast<int>(sequence.size());
        for (int place = whole ? 1 : first; place <= (whole ? length : std::min(last, length)); ++place) {
            const double element = sequence[static_cast<std::size_t>(place - 1)];
            least = least ? std::min(*least, element) : element;
        }
        if (!least) return -1;
        return related(relation, *least, number) ? 1 : 0;
    }
};

TEST(Classes, OfSequencesAreTheCombinationsThatExistWithUndefinedConditions) {
    Random random(37);
    const std::vector<double> elements{0, 0.5, 1, 1.5, 2};
    for (std::size_t round = 0; round < tests::rounds(12); ++round) {
        std::vector<WindowTest> windows;
        std::vector<std::string> texts;
        for (int w = draw(random, 1, 3); w > 0; --w) {
            const int first = draw(random, 1, 4);
            windows.push_back(
                {draw(random, 0, 3) == 0, first, draw(random, first, 4), draw(random, 0, 5), draw(random, 1, 3) / 2.0});
            texts.push_back(windows.back().text());
        }
        std::set<std::vector<int>> answers;
        std::vector<double> sequence;
        const auto extend = [&](const auto& self) -> void {
            std::vector<int> of_sequence;
            for (const WindowTest& window : windows) of_sequence.push_back(window.answer(sequence));
            answers.insert(of_sequence);
            if (sequence.size() == 5) return;  // one item more than the windows have
            for (const double element : elements) {
                sequence.push_back(element);
                self(self);
                sequence.pop_back();
            }
        };
        extend(extend);
        const std::string text = reading("Seq(real)", texts);
        EXPECT_EQ(only_data(text).classes, answers.size()) << text;
    }
}

TEST(Classes, OfDataThatNothingReadsAreTheDefaultValueAndOneMore) {
    const ReplacedData data = only_data(reading("real * nat", {"true"}));
    EXPECT_EQ(data.classes, 2U);
    EXPECT_TRUE(data.nothing_tested);
    EXPECT_THAT(data.places, ElementsAre("e", "x"));
}

TEST(Classes, OfValuesThatTheModelWritesAreTheValuesThatOccur) {
    const ReplacedData data = only_data(
        "package p\ninterface M { go(v : real) }\nstm S {\n requires M\n const fast : real = 1.5\n initial i\n"
        " state A { entry go(fast) }\n state B { entry go(-fast) }\n transition t0 { from i to A }\n"
        " transition t1 { from A to B }\n transition t2 { from B to A } }\n");
    EXPECT_FALSE(data.all_values);
    EXPECT_EQ(data.classes, 3U) << "the default value 0, 1.5 and -1.5";
}

/// Values with which the model computes keep their carriers.
TEST(Classes, AreNotMadeWhereValuesAreNeeded) {
    const auto data_of = [](const std::string& text) {
        const auto model = classes_of(text);
        return model ? model->data : std::vector<ReplacedData>{};
    };
    EXPECT_THAT(data_of(reading("Seq(real)", {"min(ran(x)) < 1 /\\ max(ran(x)) > 3"})), IsEmpty());
    EXPECT_THAT(data_of(reading("string", {"x == \"a\""})), IsEmpty()) << "texts are compared";
    EXPECT_THAT(data_of(reading("string", {"true"})).size(), 1U) << "a text that nothing reads";
    const std::string machine =
        "package p\nstm S {{\n event e : int\n event f : int\n event out : int\n clock T\n var x : int, y : int\n"
        " initial i\n state A {{ }}\n transition t0 {{ from i to A }}\n transition t1 {{ from A to A trigger e ? x }}\n"
        " transition t2 {{ from A to A trigger f ? y }}\n transition t3 {{ from A to A {} }} }}\n";
    const auto with = [&](const std::string& transition) {
        return data_of(fmt::format(fmt::runtime(machine), transition));
    };
    EXPECT_THAT(with("condition x < y * y"), IsEmpty()) << "two places in one comparison that is not linear";
    EXPECT_THAT(with("condition since(T) > x").size(), 1U) << "x is a time; y is read by nothing";
    EXPECT_THAT(with("condition x > 3 action x = x + 1").size(), 1U) << "a computed value is compared";
    EXPECT_THAT(with("action out ! (x + y)").size(), 3U) << "out has one value; x and y, which nothing else reads, too";
}

/// `condition else` is the negation of the other conditions and shares them.
TEST(Classes, OfAConditionThatTwoGuardsShareAreCountedOnce) {
    const auto model = classes_of(
        "package p\nstm S {\n event e : nat\n event f : boolean\n var x : nat, flag : boolean\n initial i\n"
        " state A { }\n state B { }\n junction k\n transition t0 { from i to A }\n"
        " transition t1 { from A to A trigger f ? flag }\n transition t2 { from A to k trigger e ? x }\n"
        " transition t3 { from k to B condition flag /\\ x > 3 }\n transition t4 { from k to A condition else } }\n");
    ASSERT_TRUE(model);
    EXPECT_EQ(model->data.front().classes, 2U);
    EXPECT_EQ(model->data.front().conditions, 1U);
    const std::string dump = dump_text(model->system);
    EXPECT_THAT(dump, HasSubstr("t3 k -> B when (flag /\\ (x in set(c2)))"));
    EXPECT_THAT(dump, HasSubstr("t4 k -> A when not ((flag /\\ (x in set(c2))))"));
}

TEST(Classes, AGuardThatIsUndefinedIsNotItsNegation) {
    const std::string window = "min(ran(extract([1, 2], x))) < 1";
    const auto model = classes_of(reading("Seq(real)", {window, "not (" + window + ")"}));
    ASSERT_TRUE(model);
    EXPECT_EQ(model->data.front().classes, 3U) << "near, far, and no place in the window";
    const std::string dump = dump_text(model->system);
    EXPECT_THAT(dump, HasSubstr("g0 k -> A when (x in set(c2))"));
    EXPECT_THAT(dump, HasSubstr("g1 k -> A when (x in set(c3))"));
}

// ---------------------------------------------------------------- remainders

/// Returns the remainder of a division by a positive number, which is at least 0 and less than the divisor
/// (semantics/evaluate).
double remainder_of(double dividend, double divisor) {
    return dividend - divisor * std::floor(dividend / divisor);
}

/// A condition `(p * x + q) % c REL r`.
struct RemainderTest {
    int p = 1, q = 0, c = 1, relation = 0, r = 0;

    [[nodiscard]] std::string text() const {
        return fmt::format("({} * x + {}) % {} {} {}", p, q, c, relations[relation], r);
    }
    [[nodiscard]] bool holds(double x) const { return related(relation, remainder_of(p * x + q, c), r); }
};

TEST(Classes, OfRemaindersAreTheCombinationsThatExistInOnePeriod) {
    Random random(38);
    for (std::size_t round = 0; round < tests::rounds(40); ++round) {
        const bool whole = round % 2 == 0;
        const int divisor = draw(random, 1, 5);
        std::vector<RemainderTest> guards;
        std::vector<std::string> texts;
        for (int g = draw(random, 1, 3); g > 0; --g) {
            guards.push_back({draw(random, 0, 1) == 0 ? -draw(random, 1, 2) : draw(random, 1, 2), draw(random, -3, 3),
                              divisor, draw(random, 0, 5), draw(random, 0, 4)});
            texts.push_back(guards.back().text());
        }
        std::set<std::vector<bool>> answers;
        const double step = whole ? 1 : 0.25;
        for (double x = -20; x <= 20; x += step) {
            std::vector<bool> of_number;
            for (const RemainderTest& guard : guards) of_number.push_back(guard.holds(x));
            answers.insert(of_number);
        }
        const std::string text = reading(whole ? "int" : "real", texts);
        EXPECT_EQ(only_data(text).classes, answers.size()) << text;
    }
}

TEST(Classes, OfRemaindersNeedOnePeriod) {
    const auto classes = [](const std::vector<std::string>& guards) {
        const auto model = classes_of(reading("real", guards));
        return model ? model->data.front().classes : 0;
    };
    EXPECT_EQ(classes({"x % 2 < 0"}), 1U) << "a remainder is never negative, also that of a negative number";
    EXPECT_EQ(classes({"(-1.5) % 2 == 0.5 /\\ x % 2 < 1"}), 2U);
    EXPECT_EQ(classes({"(if x % 4 >= 2 then x % 4 - 2 else 2 - x % 4 end) >= 1"}), 2U) << "1 < x % 4 < 3, or not";
    const std::size_t with_solver = has_solver() ? 4 : 0;
    EXPECT_EQ(classes({"x % 2 < 1", "x % 3 < 1"}), with_solver) << "two periods";
    EXPECT_EQ(classes({"x % 2 < 1", "x < 1"}), with_solver) << "the number itself has no period";
    EXPECT_EQ(classes({"x % 0 < 1"}), 0U) << "the remainder has no value";
    EXPECT_EQ(classes({"x % (-2) < 1"}), 0U);
}

// ---------------------------------------------------------------- functions

TEST(Classes, OfConditionsWithFunctionsAreThoseOfTheirBodies) {
    const auto classes = [](const std::string& contract, const std::string& guard) {
        const auto model =
            classes_of(reading("real", {guard}) + "function f(a : real, b : real) : real { " + contract + " }\n");
        return model ? model->data.front().classes : 0;
    };
    EXPECT_EQ(classes("postcondition result == if a < b then b else a end", "f(x, 2) > 3"), 2U);
    EXPECT_EQ(classes("postcondition a - b == result", "f(2, x) == 0"), 2U);
    EXPECT_EQ(classes("postcondition result >= a", "f(x, 2) > 3"), 0U) << "many results";
    EXPECT_EQ(classes("precondition b > 1 postcondition result == a", "f(x, 2) > 3"), 0U);
    EXPECT_EQ(classes("postcondition result == a", "f(x, 1 / (x - x)) > 3"), 0U) << "the argument has no value";
}

// ---------------------------------------------------------------- the solver

/// Returns the number of classes of the value that the guards read, or 0 if it keeps its carrier.
std::size_t count_classes(const std::string& type, const std::vector<std::string>& guards) {
    const auto model = classes_of(reading(type, guards));
    return model ? model->data.front().classes : 0;
}

class SolvedClasses : public ::testing::Test {
protected:
    void SetUp() override {
        if (!has_solver()) GTEST_SKIP() << "this program was built without Z3 (libz3-dev)";
    }
};

TEST_F(SolvedClasses, OfPolynomialsAreTheCombinationsThatExist) {
    EXPECT_EQ(count_classes("real", {"x * x < 4.0", "x > 1.0"}), 4U);
    EXPECT_EQ(count_classes("real", {"x * x < 4.0", "x > 2.0"}), 3U) << "not both";
    EXPECT_EQ(count_classes("real", {"x * x < 0.0"}), 1U) << "never true";
    EXPECT_EQ(count_classes("real", {"x * x * x - x > 0.0", "x > 1.0"}), 3U) << "above 1 the first is true";
    EXPECT_EQ(count_classes("real", {"x * x == 2.25"}), 2U);
    EXPECT_EQ(count_classes("nat", {"x * x > 3"}), 2U);
    EXPECT_EQ(count_classes("int", {"x * x == 4", "x > 0"}), 4U);
    EXPECT_EQ(count_classes("int", {"2000000 * x > 3"}), 2U) << "a coefficient above 2^20";
    EXPECT_EQ(count_classes("real", {"(if x * x < 1.0 then x else 1.0 end) > 0.5"}), 2U);
}

/// The first conditions are a disc, a half plane that intersects it, and one that does not.
TEST_F(SolvedClasses, OfPairsAreTheRegionsOfThePlane) {
    EXPECT_EQ(count_classes("real * real", {"x[1] * x[1] + x[2] * x[2] < 1.0", "x[1] > 0.0", "x[2] > 2.0"}), 6U);
    EXPECT_EQ(count_classes("real * real", {"x[1] * x[2] > 0.0", "x[1] > 0.0", "x[2] > 0.0"}), 5U);
}

/// Records may have more numbers than linear conditions alone can read. They may also contain truth values next to
/// numbers.
TEST_F(SolvedClasses, OfRecordsReadNumbersAndTruths) {
    EXPECT_EQ(count_classes("real * real * real * real * real * real",
                            {"x[1] + x[2] + x[3] + x[4] + x[5] > 10.0", "x[6] < 0.0"}),
              4U);
    EXPECT_EQ(count_classes("boolean * real", {"x[1] /\\ x[2] > 1.0", "x[2] > 2.0"}), 4U);
}

/// Each class needs a member with which the evaluator can compute.
TEST_F(SolvedClasses, AreNotMadeWithoutDecimalsOrWhereConditionsMayBeUndefined) {
    EXPECT_EQ(count_classes("real", {"x * x == 2.0"}), 0U) << "irrational";
    EXPECT_EQ(count_classes("real", {"1.0 / x > 2.0"}), 0U) << "a division by zero";
}

/// A condition `a * x^2 + b * x + c < 0`.
struct Parabola {
    int a = 0, b = 0, c = 0;

    [[nodiscard]] std::string text() const { return fmt::format("({}) * x * x + ({}) * x + ({}) < 0.0", a, b, c); }
    [[nodiscard]] bool holds(double x) const { return a * x * x + b * x + c < -1e-9; }
    void add_roots(std::set<double>& roots) const {
        if (a == 0 && b != 0) roots.insert(-static_cast<double>(c) / b);
        const int square = b * b - 4 * a * c;
        if (a == 0 || square < 0) return;
        for (const double root : {std::sqrt(square), -std::sqrt(square)}) roots.insert((-b + root) / (2 * a));
    }
};

std::vector<bool> answers_at(const std::vector<Parabola>& parabolas, double x) {
    std::vector<bool> result;
    for (const Parabola& parabola : parabolas) result.push_back(parabola.holds(x));
    return result;
}

/// The answers change only at roots. If a combination exists only at roots, its only members may be irrational.
TEST_F(SolvedClasses, OfRandomParabolasAreThoseAtAndBetweenRoots) {
    Random random(36);
    for (std::size_t round = 0; round < tests::rounds(60); ++round) {
        std::vector<Parabola> parabolas;
        std::vector<std::string> guards;
        for (int g = draw(random, 1, 3); g > 0; --g) {
            parabolas.push_back({draw(random, -2, 2), draw(random, -3, 3), draw(random, -2, 2)});
            guards.push_back(parabolas.back().text());
        }
        std::set<double> roots{-100, 100};
        for (const Parabola& parabola : parabolas) parabola.add_roots(roots);
        std::set<std::vector<bool>> between, all;
        for (auto root = roots.begin(); std::next(root) != roots.end(); ++root)
            if (*std::next(root) - *root > 1e-6) between.insert(answers_at(parabolas, (*root + *std::next(root)) / 2));
        all = between;
        for (const double root : roots) all.insert(answers_at(parabolas, root));
        const std::size_t classes = count_classes("real", guards);
        if (classes == 0 && all.size() > between.size()) continue;
        EXPECT_EQ(classes, all.size()) << fmt::format("{}", fmt::join(guards, "\n"));
    }
}

// ---------------------------------------------------------------- relations

/// Returns a machine that reads two values of this type into `x` and `y`. It has transitions with these guards, and
/// more transitions.
std::string relating(const std::string& type, const std::vector<std::string>& guards, const std::string& more = "") {
    std::string text = fmt::format(
        "package p\nstm S {{\n event e : {0}\n event f : {0}\n event out : {0}\n event go\n var x : {0}, y : {0}\n"
        " initial i\n state A {{ }}\n junction k\n transition t0 {{ from i to A }}\n"
        " transition t1 {{ from A to A trigger e ? x }}\n transition t2 {{ from A to A trigger f ? y }}\n"
        " transition t3 {{ from A to k trigger go }}\n{1}",
        type, more);
    for (std::size_t g = 0; g < guards.size(); ++g)
        text += fmt::format(" transition g{} {{ from k to A condition {} }}\n", g, guards[g]);
    return text + "}\n";
}

/// Returns "term, classes, conditions" for the related data, or "" if there are none.
std::string relation_of(const std::string& text) {
    const auto model = classes_of(text);
    if (!model) return "";
    for (const ReplacedData& data : model->data)
        if (!data.term.empty()) return fmt::format("{}, {}, {}", data.term, data.classes, data.conditions);
    return "";
}

TEST(Relations, AreConditionsOnOneLinearTerm) {
    EXPECT_EQ(relation_of(relating("int", {"x > y", "x <= y"})), "x - y, 2, 2");
    EXPECT_EQ(relation_of(relating("int", {"x > y + 1", "y < x"})), "x - y, 3, 2") << "at most 0, 1, at least 2";
    EXPECT_EQ(relation_of(relating("real", {"x + y > 1", "2 * x + 2 * y < 2", "x == 1 - y"})), "x + y, 3, 3");
    EXPECT_EQ(relation_of(relating("real", {"2 * x > 4 * y"})), "x - 2 * y, 2, 1");
    EXPECT_EQ(relation_of(relating("real", {"(x - y + 180) % 360 - 180 > 90"})), "x - y, 2, 1");
    EXPECT_EQ(relation_of(relating("int", {"(x - y) % 3 == 1", "(y - x) % 3 == 1"})), "x - y, 3, 2");
    EXPECT_EQ(relation_of(relating("int", {"x in {y, y + 2}"})), "");
    EXPECT_EQ(relation_of(relating("int", {"x - y in {0, 2}"})), "x - y, 2, 1");
}

/// Inputs reach every class only if the term takes every value for all values of the other variables.
TEST(Relations, AreNotMadeWhereAnInputMayNotReachEveryClass) {
    EXPECT_EQ(relation_of(relating("nat", {"x > y"})), "") << "no x is less than y = 0";
    EXPECT_EQ(relation_of(relating("int", {"x > 2 * y"})), "") << "2 * y is even";
    EXPECT_EQ(relation_of(relating("real", {"x > 2 * y"})), "x - 2 * y, 2, 1");
    EXPECT_EQ(relation_of(relating("int", {"x > y", "x > 5"})), "") << "two terms";
    EXPECT_EQ(relation_of(relating("int", {"x > y", "x + y > 5"})), "") << "two terms";
    EXPECT_EQ(relation_of(relating("int", {"x * y > 5"})), "") << "not linear";
    EXPECT_EQ(relation_of(relating("real", {"(x - y) % 3 > 1", "x - y > 1"})), has_solver() ? "x - y, 4, 2" : "")
        << "no period, so that only the solver finds the classes";
}

/// The class of the term must be known after each statement.
TEST(Relations, FollowAssignmentsThatTheTermDetermines) {
    const auto with = [](const std::string& action) {
        return relation_of(
            relating("int", {"x > y"}, " transition a { from A to A trigger go action " + action + " }\n"));
    };
    EXPECT_EQ(with("x = y"), "x - y, 2, 1") << "the term is 0";
    EXPECT_EQ(with("x = y + 3"), "x - y, 2, 1") << "the term is 3";
    EXPECT_EQ(with("x = 0"), "") << "the term is -y";
    EXPECT_EQ(with("x = x + 1"), "") << "a sum is compared";
    EXPECT_EQ(with("x = y * y"), "");
    EXPECT_EQ(with("out ! x"), "x - y, 2, 1") << "a copy that leaves the machine";
    EXPECT_EQ(with("out ! (x + 1)"), "");
}

/// Guards of triggers read the new value of their variable, so the class in the event is the class of the new value.
TEST(Relations, OfGuardsReadTheReceivedClass) {
    const auto model = classes_of(relating("int", {"x > y"},
                                           " transition b { from A to k trigger e ? x condition x > y }\n"
                                           " transition c { from A to k trigger f ? y condition x > y }\n"));
    ASSERT_TRUE(model);
    const std::string dump = dump_text(model->system);
    EXPECT_THAT(dump, HasSubstr("b A -> k on e?x when (received in set(c2))"));
    EXPECT_THAT(dump, HasSubstr("c A -> k on f?x when (received in set(c2))"));
    EXPECT_THAT(dump, HasSubstr("g0 k -> A when (x in set(c2))"));
}

/// Values that another component sends, or that several machines receive, may depend on each other.
TEST(Relations, NeedInputsOfThePlatformThatOneMachineReceives) {
    const auto controller = [](const std::string& parts) {
        const std::string sending = " transition a { from A to A trigger go action out ! x }\n";
        return relating("int", {"x > y"}, sending) +
               "controller C { event e : int event f : int event g : int event go sref s = S "
               "connection C on e to s on e connection C on go to s on go " +
               parts + " }\n";
    };
    EXPECT_EQ(relation_of(controller("connection C on f to s on f")), "x - y, 2, 1");
    EXPECT_EQ(relation_of(controller("connection s on out to s on f")), "") << "an output comes back";
    EXPECT_EQ(relation_of(controller("connection C on f to s on f sref t = S connection C on g to t on e")), "");
}

}  // namespace
}  // namespace robochart::ir
