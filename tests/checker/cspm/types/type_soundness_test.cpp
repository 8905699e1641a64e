// SPDX-License-Identifier: Apache-2.0
// Tests soundness: a script that passes the type checker evaluates without a type error. There are two kinds of random
// scripts. Well-typed scripts must pass. Scripts into which parts of random types were inserted must evaluate without a
// type error if they pass.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>
#include <string>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "tests/checker/cspm/support.hpp"

namespace robochart::cspm::test {
namespace {

constexpr const char* declarations = R"(
datatype T = Leaf | Node.T.{0..1}.T
datatype D = A.{0..1}.Bool | B | W.E
datatype E = V.{0..1}
channel e
channel c : {0..1}.Bool
channel d : D
first((x, _)) = x
depth(Leaf) = 0
depth(Node.l.n.r) = depth(l) + n
flag(A.n.b) = b
flag(B) = false
flag(W.V.n) = n == 0
twice(f, x) = f(f(x))
apply(f)(x) = f(x)
sum(<>) = 0
sum(<x>^xs) = x + sum(xs)
events(h) = {| h |}
)";

enum class Type { integer, boolean, tree, data, inner, event, pair, sequence, set, events, function, process };
constexpr std::array all_types{Type::integer, Type::boolean,  Type::tree, Type::data,   Type::inner,    Type::event,
                               Type::pair,    Type::sequence, Type::set,  Type::events, Type::function, Type::process};

// Generates expressions of a given type. Pairs are (Int, Bool), sequences and sets contain Int, and functions are (Int)
// -> Int.
class Terms {
public:
    Terms(unsigned seed, bool mixed) : random_(seed), mixed_(mixed) {}

    std::string term_of(Type type, int size) {
        if (mixed_ && pick_number(12) == 0) type = all_types[pick_number(all_types.size())];
        if (size <= 0 || pick_number(6) == 0) return leaf(type);
        switch (pick_number(5)) {
            case 0:
                return "(if " + term_of(Type::boolean, size - 1) + " then " + term_of(type, size - 1) + " else " +
                       term_of(type, size - 1) + ")";
            case 1:
                return "(let v = " + term_of(type, size - 1) + " within v)";
            case 2:
                return "(\\ u @ " + term_of(type, size - 1) + ")(" + term_of(Type::integer, size - 1) + ")";
            default:
                return build_term(type, size - 1);
        }
    }

private:
    std::size_t pick_number(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
    std::string pick_one(std::initializer_list<const char*> choices) {
        return *(choices.begin() + pick_number(choices.size()));
    }

    std::string leaf(Type type) {
        switch (type) {
            case Type::integer:
                return pick_one({"0", "1", "x"});
            case Type::boolean:
                return pick_one({"true", "false", "y"});
            case Type::tree:
                return pick_one({"Leaf", "(Node.Leaf.0.Leaf)"});
            case Type::data:
                return pick_one({"B", "(A.0.true)", "(W.V.1)"});
            case Type::inner:
                return "(V.0)";
            case Type::event:
                return pick_one({"e", "(c.1.true)", "(d.B)", "(d.A.0.false)"});
            case Type::pair:
                return "(x, y)";
            case Type::sequence:
                return pick_one({"<>", "<0, 1>", "<0..1>"});
            case Type::set:
                return pick_one({"{}", "{0, 1}", "{0..1}"});
            case Type::events:
                return pick_one({"{| c |}", "{e}", "{| d.A |}", "{}"});
            case Type::function:
                return pick_one({"(\\ z @ z)", "(\\ z @ z + 1)"});
            case Type::process:
                return pick_one({"STOP", "SKIP"});
        }
        return "";
    }

    std::string build_term(Type type, int n) {
        const auto some = [&](Type part) { return term_of(part, n); };
        const std::string number = some(Type::integer);
        switch (type) {
            case Type::integer:
                return choose({"(" + number + " + " + some(Type::integer) + ")", "depth(" + some(Type::tree) + ")",
                               "#" + some(Type::sequence), "card(" + some(Type::set) + ")",
                               "first(" + some(Type::pair) + ")", "sum(" + some(Type::sequence) + ")",
                               "twice(" + some(Type::function) + ", " + number + ")",
                               "apply(" + some(Type::function) + ")(" + number + ")"});
            case Type::boolean:
                return choose({"(" + number + " < " + some(Type::integer) + ")",
                               "(" + some(Type::data) + " == " + some(Type::data) + ")",
                               "member(" + number + ", " + some(Type::set) + ")", "flag(" + some(Type::data) + ")",
                               "(not " + some(Type::boolean) + ")",
                               "(" + some(Type::set) + " <= " + some(Type::set) + ")",
                               "(" + some(Type::event) + " == " + some(Type::event) + ")"});
            case Type::tree:
                return "(Node.(" + some(Type::tree) + ").0.(" + some(Type::tree) + "))";
            case Type::data:
                return choose({"(A.1.(" + some(Type::boolean) + "))", "(W.(" + some(Type::inner) + "))"});
            case Type::inner:
                return choose({"(V.1)", "(let k = V within k.0)"});
            case Type::event:
                return choose({"(c.0.(" + some(Type::boolean) + "))", "(d.(" + some(Type::data) + "))",
                               "(let k = c.1 within k.true)"});
            case Type::pair:
                return "(" + number + ", " + some(Type::boolean) + ")";
            case Type::sequence:
                return choose({"(" + some(Type::sequence) + " ^ <" + number + ">)",
                               "< z | z <- " + some(Type::sequence) + ", 0 < z >"});
            case Type::set:
                return choose({"union(" + some(Type::set) + ", {" + number + "})",
                               "{ z + 1 | z <- " + some(Type::set) + " }", "set(" + some(Type::sequence) + ")",
                               "{ z | c.z.w <- {| c |}, w }"});
            case Type::events:
                return choose({"union(" + some(Type::events) + ", {" + some(Type::event) + "})", "events(c)",
                               "events(c.0)", "events(d.A.1)", "productions(d)"});
            case Type::function:
                return choose({"(\\ z @ " + number + ")", "(\\ z @ z + " + number + ")"});
            case Type::process:
                return process(n);
        }
        return "";
    }

    std::string process(int n) {
        const auto some = [&](Type part) { return term_of(part, n); };
        return "(" +
               choose({some(Type::event) + " -> " + some(Type::process), "c?z?w -> " + some(Type::process),
                       "d?A.z.w -> " + some(Type::process), "d?W.V.z -> " + some(Type::process),
                       "c!(0)?w:{true} -> " + some(Type::process), some(Type::process) + " [] " + some(Type::process),
                       some(Type::boolean) + " & " + some(Type::process),
                       some(Type::process) + " [| " + some(Type::events) + " |] " + some(Type::process),
                       some(Type::process) + " \\ " + some(Type::events),
                       some(Type::process) + " [[ c.0 <- c.1, e <- d.B ]]",
                       "[] z : " + some(Type::set) + " @ " + some(Type::process),
                       "; z : " + some(Type::sequence) + " @ SKIP"}) +
               ")";
    }

    std::string choose(std::vector<std::string> choices) { return choices[pick_number(choices.size())]; }

    std::mt19937 random_;
    bool mixed_;
};

std::string script_for(Type type, unsigned seed, bool mixed) {
    Terms terms(seed, mixed);
    return std::string(declarations) + "x = 0\ny = true\nv = " + terms.term_of(type, 4) + "\n";
}

// Returns true for errors that the type checker should have found. Other errors (an infinite set, the head of an empty
// sequence) depend on values.
bool about_types(const std::string& message) {
    for (const char* start : {"expected ", "cannot compare", "values like", "productions of"}) {
        if (message.starts_with(start)) return true;
    }
    return message.find(" arguments") != std::string::npos || message.find("no clause of") != std::string::npos;
}

// Returns the error from evaluating `v`, with a short exploration of processes, or "" if there is none.
std::string fault_of(const Script& script, Type type) {
    try {
        Session session(script);
        if (type != Type::process) {
            (void)session.evaluate(build::name("v"));
            return "";
        }
        refine::Limits limits;
        limits.max_states = 200;
        const auto system = session.system(build::name("v"));
        (void)refine::deadlock_free(*system, refine::Model::failures, limits);
        return "";
    } catch (const EvaluationError& error) {
        return error.what();
    }
}

TEST(TypeSoundness, TermsBuiltByTypeAreAcceptedAndEvaluate) {
    for (unsigned seed = 0; seed < 1'200; ++seed) {
        const Type type = all_types[seed % all_types.size()];
        Reading reading(script_for(type, seed, false));
        ASSERT_TRUE(reading.ok()) << reading.report();
        check_types(reading.script, reading.diagnostics);
        ASSERT_TRUE(reading.ok()) << "seed " << seed << script_for(type, seed, false) << reading.report();
        EXPECT_EQ(fault_of(reading.script, type), "") << "seed " << seed << script_for(type, seed, false);
    }
}

TEST(TypeSoundness, WhatIsAcceptedHasNoErrorOfTypes) {
    unsigned accepted = 0;
    for (unsigned seed = 0; seed < 4'000; ++seed) {
        const Type type = all_types[seed % all_types.size()];
        Reading reading(script_for(type, seed, true));
        ASSERT_TRUE(reading.ok()) << reading.report();
        const std::vector<NamedType> types = check_types(reading.script, reading.diagnostics);
        if (!reading.ok()) continue;
        ++accepted;
        const bool process = types.back().name == "v" && types.back().type == "Proc";
        const std::string fault = fault_of(reading.script, process ? Type::process : Type::integer);
        EXPECT_FALSE(about_types(fault)) << "seed " << seed << script_for(type, seed, true) << fault;
    }
    // Some scripts pass and some do not, so the property is not vacuous.
    EXPECT_GT(accepted, 400U);
    EXPECT_LT(accepted, 3'600U);
}

}  // namespace
}  // namespace robochart::cspm::test
