// SPDX-License-Identifier: Apache-2.0
// Tests lazy evaluation as in FDR, early evaluation that is abandoned, and sets whose elements cannot be listed. The
// expected values follow from the definition of each operator. `error("never")` marks expressions that must not be
// evaluated.
#include "tests/checker/cspm/outcomes.hpp"

namespace robochart::cspm::test {
namespace {

const std::string never = "error(\"never\")";
const std::string never_error = "error: error: never";

TEST(ByNeed, PartsOfSequences) {
    EXPECT_EQ(value("head(<1, " + never + ">)"), "1");
    EXPECT_EQ(value("#<" + never + ", 2>"), "2");
    EXPECT_EQ(value("null(<" + never + ">)"), "false");
    EXPECT_EQ(value("head(tail(<" + never + ", 7>))"), "7");
    EXPECT_EQ(value("head(<4> ^ " + never + ")"), "4");
    EXPECT_EQ(value("#(<1, 2> ^ <" + never + "> ^ <4>)"), "4");
    EXPECT_EQ(value("head(concat(<<>, <9>, " + never + ", <1>>))"), "9");
    EXPECT_EQ(value("#concat(<<" + never + ">, <1, 2>>)"), "3");
    EXPECT_EQ(value("elem(5, <4, 5, " + never + ">)"), "true");
    EXPECT_EQ(value("let f(<>) = 0\n f(<_> ^ rest) = 1 + f(rest) within f(<" + never + ", " + never + ">)"), "2");
    EXPECT_EQ(value("let f(xs ^ <x>) = x within f(<" + never + ", 3>)"), "3");
    EXPECT_EQ(value("let f(<x, y>) = y within f(<" + never + "> ^ <6>)"), "6");
    EXPECT_EQ(value("<1, " + never + "> == <2, " + never + ">"), "false");
    EXPECT_EQ(value("<" + never + "> == <>"), "false");
    EXPECT_EQ(value("<0..> == <1..>"), "false");
    EXPECT_EQ(value("elem(" + never + ", <>)"), "false");
    EXPECT_EQ(value("<1, 2> < <3, " + never + ">"), "false");
    EXPECT_EQ(value("<1> <= <1, " + never + ">"), "true");
    EXPECT_EQ(value("<1> <= <1..>"), "true");
    EXPECT_EQ(value("<1, 3> >= <2, " + never + ">"), "false");
    for (const char* whole : {"<1, #>", "head(<#, 1>)", "head(tail(<1> ^ #))", "elem(6, <4, #>)", "<1, #> == <1, 2>",
                              "seq({#})", "set(<1, #>)", "show(<#>)", "<#> <= <1>"}) {
        std::string text = whole;
        text.replace(text.find('#'), 1, never);
        EXPECT_EQ(value(text), never_error) << text;
    }
}

TEST(ByNeed, PartsOfTuplesAndMaps) {
    EXPECT_EQ(value("let first((x, _)) = x within first((1, " + never + "))"), "1");
    EXPECT_EQ(value("let (a, (b, c)) = (" + never + ", (2, " + never + ")) within b"), "2");
    EXPECT_EQ(value("(1, " + never + ") == (2, " + never + ")"), "false");
    EXPECT_EQ(value("(1, " + never + ") < (2, " + never + ")"), "true");
    EXPECT_EQ(value("(| 0 => " + never + " |) == (| 1 => 2 |)"), "false");
    EXPECT_EQ(value("(| 0 => 1, 1 => " + never + " |) == (| 0 => 2, 1 => 3 |)"), "false");
    EXPECT_EQ(value("(| 0 => 1, 2 => 3 |) == (| 0 => 1, 2 => 3 |)"), "true");
    EXPECT_EQ(value("mapLookup(mapFromList(<(0, " + never + "), (1, 5)>), 1)"), "5");
    EXPECT_EQ(value("mapLookup((| 0 => " + never + ", 1 => 2 |), 1)"), "2");
    EXPECT_EQ(value("mapMember(mapUpdate(emptyMap, 3, " + never + "), 3)"), "true");
    EXPECT_EQ(value("let second((_, y)) = y within second(head(tail(mapToList((| 0 => " + never + ", 1 => 8 |)))))"),
              "8");
    EXPECT_EQ(value("mapLookup(mapDelete((| 0 => " + never + ", 1 => 2 |), 0), 1)"), "2");
    for (const char* whole :
         {"(1, #)", "mapLookup((| 0 => # |), 0)", "(| # => 1 |)", "mapMember(emptyMap, #)", "{(1, #)}"}) {
        std::string text = whole;
        text.replace(text.find('#'), 1, never);
        EXPECT_EQ(value(text), never_error) << text;
    }
}

/// If the first set is empty, intersection and difference do not evaluate the second one.
TEST(ByNeed, TheEmptySetDecidesAlone) {
    EXPECT_EQ(value("inter({}, {" + never + "})"), "{}");
    EXPECT_EQ(value("diff({}, {" + never + "})"), "{}");
    EXPECT_EQ(value("inter({" + never + "}, {})"), never_error);
    EXPECT_EQ(value("inter({1}, {" + never + "})"), never_error);
}

TEST(ByNeed, FieldsOfDatatypesHaveValues) {
    EXPECT_EQ(process_failure("datatype D = B.{0..1}\ng(B._) = STOP\nX = g(B." + never + ")\n"), "error: never");
}

TEST(ByNeed, Comprehensions) {
    EXPECT_EQ(value("head(<x | x <- <1, " + never + ">>)"), "1");
    EXPECT_EQ(value("head(<x | x <- <0, " + never + ">, x == 0>)"), "0");
    EXPECT_EQ(value("#<0 | x <- <1, " + never + ">>"), "2");
    EXPECT_EQ(value("head(<x | y <- <1, 2>, x <- <y, " + never + ">, (x > 0)>)"), "1");
    EXPECT_EQ(value("head(tail(<x + y | x <- <1, 2>, y <- <10> ^ <20, " + never + ">>))"), "21");
    EXPECT_EQ(value("head(<1 | true, x <- <0, " + never + ">, x == 0>)"), "1");
    EXPECT_EQ(value("<x | x <- <0, " + never + ">, x == 0>"), never_error);
    EXPECT_EQ(value("head(tail(<x | x <- <0, " + never + ">, x == 0>))"), never_error);
    EXPECT_EQ(value("head(<x | x <- <1, 2>, 1 / (x - 1) == 1>)"), "error: division by zero");
}

TEST(ByNeed, SequencesDefinedByThemselves) {
    EXPECT_EQ(value("let ones = <1> ^ ones within head(tail(tail(ones)))"), "1");
    EXPECT_EQ(value("let from(n) = <n> ^ from(n + 1) within head(tail(tail(from(5))))"), "7");
    EXPECT_EQ(value("let from(n) = <n> ^ from(n + 1)\n"
                    " take(0, _) = <>\n take(n, <x> ^ xs) = <x> ^ take(n - 1, xs) within #take(3000, from(0))"),
              "3000");
    EXPECT_EQ(value("let fibs = <0, 1> ^ <x + y | (x, y) <- zip(fibs, tail(fibs))>\n"
                    " zip(<x> ^ xs, <y> ^ ys) = <(x, y)> ^ zip(xs, ys)\n zip(_, _) = <>\n"
                    " at(0, <x> ^ _) = x\n at(n, <_> ^ xs) = at(n - 1, xs) within at(12, fibs)"),
              "144");
    EXPECT_EQ(value("let primes(<p> ^ xs) = <p> ^ primes(<x | x <- xs, x % p != 0>)\n"
                    " at(0, <x> ^ _) = x\n at(n, <_> ^ xs) = at(n - 1, xs) within at(20, primes(<2..>))"),
              "73");
}

// Early evaluation is bounded. If it is abandoned, the value is computed when it is needed. The depth of recursion is
// not reduced.
TEST(ByNeed, WorkThatIsGivenUp) {
    EXPECT_EQ(value("let slow(0) = 1\n slow(n) = slow(n - 1) within head(<2, slow(1000000000)>)"), "2");
    EXPECT_EQ(value("let slow(0) = 1\n slow(n) = slow(n - 1) within head(tail(<2, slow(10000)>))"), "1");
    EXPECT_EQ(value("let tree(n) = <tree2(n + 1), tree2(n + 2)>\n tree2(n) = <tree(n), tree(n)> within #tree(0)"), "2");
    EXPECT_EQ(value("let down(0) = <>\n down(n) = <n> ^ down(n - 1) within #down(20000)"), "20000");
    EXPECT_EQ(value("let sum(<>) = 0\n sum(<x> ^ xs) = x + sum(xs)\n"
                    " squares(n) = <x * x | x <- <1..n>> within sum(squares(200))"),
              "2686700");
}

TEST(ByNeed, ConstantsOfTheScript) {
    expect_outcomes("channel c : {0..9}\nPair = (1, " + never + ")\nList = <2, " + never + R"(>
Ones = <3> ^ Ones
first((x, _)) = x
P = c!first(Pair) -> c!head(List) -> c!head(tail(Ones)) -> STOP
assert P :[has trace [T]]: <c.1, c.2, c.3>
assert P :[has trace [T]]: <c.1, c.2, c.4>
)",
                    "hf");
}

TEST(SetsWithoutEnd, UnionsKeepTheirParts) {
    EXPECT_EQ(value("member(1, union({0..}, {1, 2, 3}))"), "true");
    EXPECT_EQ(value("member(-5, union({0..}, { -5})) and not member(-4, union({0..}, { -5}))"), "true");
    EXPECT_EQ(value("union({0..}, {1, 2}) == {0..}"), "true");
    EXPECT_EQ(value("union({2..}, {0, 1}) == {0..}"), "true");
    EXPECT_EQ(value("union({5}, {2..}) == union({2..}, {7})"), "true");
    EXPECT_EQ(value("union({2..}, {0}) == union({1..}, {0})"), "false");
    EXPECT_EQ(value("Union({{3..}, {1}, {2}}) == {1..}"), "true");
    EXPECT_EQ(value("union(Int, {1}) == Int"), "true");
    EXPECT_EQ(value("member(<2>, union(Seq({1}), {<2>})) and not member(<1, 2>, union(Seq({1}), {<2>}))"), "true");
    EXPECT_EQ(value("union(Seq({1}), {<1, 1>}) == Seq({1})"), "true");
    EXPECT_EQ(value("member(<3>, union(Seq({1}), Seq({3})))"), "true");
    EXPECT_EQ(value("{1} <= union({0..}, { -5}) and {3..} <= union({5..}, {2, 3, 4})"), "true");
    EXPECT_EQ(value("{3..} <= union({5..}, {2, 3})"), "false");
    EXPECT_EQ(value("inter(union({5..}, {0}), {0..6})"), "{0, 5, 6}");
    EXPECT_EQ(value("empty(union({0..}, { -5}))"), "false");
    EXPECT_EQ(value("card(union({0..}, { -5}))").find("error:"), 0U);
}

TEST(SetsWithoutEnd, Differences) {
    EXPECT_EQ(value("diff({1..}, {1}) == {2..}"), "true");
    EXPECT_EQ(value("diff({0..}, {2}) == union({0, 1}, {3..})"), "true");
    EXPECT_EQ(value("diff({0..}, {3..})"), "{0, 1, 2}");
    EXPECT_EQ(value("diff(union({5..}, {0}), {5..})"), "{0}");
    EXPECT_EQ(value("diff({ -1, 3, 7}, union({5..}, { -1}))"), "{3}");
    EXPECT_EQ(value("diff({0..}, Int)"), "{}");
    EXPECT_EQ(value("diff(Seq({1}), Seq({1, 2}))"), "{}");
    EXPECT_EQ(value("diff(Int, {1})").find("error: the elements of diff"), 0U);
}

// Sizes are computed without listing the elements.
TEST(SetsWithoutEnd, LargeSets) {
    EXPECT_EQ(value("card(Set({1..40}))"), "1099511627776");
    EXPECT_EQ(value("card(Map({1..10}, {1..9}))"), "10000000000");
    EXPECT_EQ(value("card(Set(Set({1..40})))"), "error: the number does not fit in 64 bits");
    EXPECT_EQ(value("card(Int)"), "error: the set Int is infinite");
    EXPECT_EQ(value("empty(Set({1..40}))"), "false");
    EXPECT_EQ(value("empty(Seq({}))"), "true");
    EXPECT_EQ(value("member({1, 40}, union(Set({1..40}), {{50}})) and member({50}, union(Set({1..40}), {{50}}))"),
              "true");
    EXPECT_EQ(value("Set({1..40}) <= Set({1..41})"), "true");
    EXPECT_EQ(value("Set({1..40}) == Set({1..41})"), "false");
    EXPECT_EQ(value("inter(Set({1..40}), Set({39..60})) == Set({39, 40})"), "true");
    EXPECT_EQ(value("let f({}) = 0\n f({_}) = 1\n f(_) = 2 within f(Set({1..40}))"), "2");
    EXPECT_EQ(value("card(Union({{x} | x <- {1..20000}}))"), "20000");
}

TEST(DotPatterns, TwoPatternsForOnePart) {
    EXPECT_EQ(value("let f(((x.y) @@ (a.b.c)).d) = (x, y, a, b, c, d) within f(0.1.2.3)"), "(0, 1.2, 0, 1, 2, 3)");
    EXPECT_EQ(value("let f((x @@ y).z) = (x, y, z) within f(1.2.3)"), "(1, 1, 2.3)");
    EXPECT_EQ(value("let f(x.(y @@ (a.b))) = (x, y, a, b) within f(1.2.3)"), "(1, 2.3, 2, 3)");
}

/// Composite values are compared by the identity of their parts, so equal sets must be one value however they are
/// written.
TEST(SetsWrittenDifferently, AreOneValueAsPartsOfOthers) {
    const std::string all = "Set({1})";
    const std::string listed = "{{}, {1}}";
    for (const std::string around : {"#", "(#, 1)", "<#>", "{#}", "{(#, <#>)}", "(| (#, 0) => # |)"}) {
        const auto with = [&](const std::string& set) {
            std::string text = around;
            for (std::size_t at = text.find('#'); at != std::string::npos; at = text.find('#'))
                text.replace(at, 1, set);
            return text;
        };
        EXPECT_EQ(value(with(all) + " == " + with(listed)), "true") << around;
        EXPECT_EQ(value(with(all) + " != " + with(listed)), "false") << around;
        EXPECT_EQ(value("member(" + with(all) + ", {" + with(listed) + "})"), "true") << around;
        EXPECT_EQ(value("card({" + with(all) + ", " + with(listed) + "})"), "1") << around;
        EXPECT_EQ(value("elem(" + with(all) + ", <" + with(listed) + ">)"), "true") << around;
    }
    EXPECT_EQ(value("mapLookup((| Set({1}) => 5 |), {{}, {1}})"), "5");
    EXPECT_EQ(value("mapMember((| (Set({1}), 0) => 5 |), ({{}, {1}}, 0))"), "true");
    EXPECT_EQ(value("Set({1, 2}) == Set({2, 1})"), "true");
    EXPECT_EQ(value("(Set({1, 2}), 1) == ({{}, {1}}, 1)"), "false");
}

TEST(SetsWrittenDifferently, OfOneKindAreComparedByTheirElements) {
    EXPECT_EQ(value("Set({true, false}) == Set(Bool)"), "true");
    EXPECT_EQ(value("Seq({true, false}) == Seq(Bool)"), "true");
    EXPECT_EQ(value("Seq({true}) == Seq(Bool)"), "false");
    EXPECT_EQ(value("Set(Int) == Set({0..})"), "false");
    EXPECT_EQ(value("({0..}, 1) == ({1..}, 1)"), "false");
}

}  // namespace
}  // namespace robochart::cspm::test
