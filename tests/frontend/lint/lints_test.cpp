// SPDX-License-Identifier: Apache-2.0
// Tests warnings that go beyond the rules, in cases that the fixtures do not show. Compares the decision procedure for
// guards with an enumeration of small values.
#include "frontend/lint/lints.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "frontend/lint/lint_logic.hpp"
#include "frontend/syntax/parse.hpp"
#include "tests/frontend/fixture.hpp"
#include "tests/source_folder.hpp"

namespace robochart::frontend {
namespace {

using testing::resolved;

// ---------------------------------------------------------------- the decision procedure

/// Returns the only guard in a machine with x, y : int, n : nat, p, q : boolean, c : Colour in scope.
const Expr& guard_of(const testing::Reading& reading) {
    const auto& machine = dynamic_cast<const Machine&>(*reading.file().declarations.back());
    return *machine.transitions.back()->condition;
}

std::unique_ptr<testing::Reading> guarded(const std::string& guard) {
    auto reading = resolved(
        "enumeration Colour { red green blue } interface World { var x:int, y:int, n:nat, p:boolean, q:boolean, "
        "c:Colour } stm S { requires World event e initial i state A { } transition t0 { from i to A } transition t1 "
        "{ from A to A trigger e condition " +
        guard + " } }");
    EXPECT_TRUE(reading->findings.ok()) << guard << "\n" << reading->report();
    return reading;
}

logic::Finding decided(const std::string& guard, bool negated = false) {
    const auto reading = guarded(guard);
    logic::Reasoner reasoner(false);
    logic::Formula formula = reasoner.read(guard_of(*reading));
    if (negated) formula = logic::negate_formula(std::move(formula));
    return reasoner.decide(formula);
}

/// Values of the variables, for the evaluation of expressions.
struct Values {
    int x = 0, y = 0, n = 0, p = 0, q = 0, c = 0;

    [[nodiscard]] int of(const std::string& name) const {
        switch (name.front()) {
            case 'x':
                return x;
            case 'y':
                return y;
            case 'n':
                return n;
            case 'p':
                return p;
            case 'q':
                return q;
            case 'c':
                return c;
            default:
                if (name == "red") return 0;
                return name == "green" ? 1 : 2;
        }
    }

    [[nodiscard]] int of(const Expr& expr) const {
        const auto arg = [&](std::size_t i) { return of(*expr.args[i]); };
        if (expr.kind == ExprKind::integer) return std::stoi(expr.text);
        if (expr.kind == ExprKind::boolean) return expr.text == "true" ? 1 : 0;
        if (expr.kind == ExprKind::name) return of(expr.name.parts.back());
        if (expr.kind == ExprKind::parenthesised) return arg(0);
        if (expr.kind == ExprKind::if_then_else) return arg(0) != 0 ? arg(1) : arg(2);
        if (expr.kind == ExprKind::unary) return expr.unary == UnaryOp::negate ? -arg(0) : 1 - arg(0);
        if (expr.binary == BinaryOp::in) return contains(*expr.args[1], arg(0));
        return binary(*expr.binary, arg(0), arg(1));
    }

private:
    [[nodiscard]] int contains(const Expr& set, int value) const {
        for (const ExprPtr& element : set.args)
            if (of(*element) == value) return 1;
        return 0;
    }

    static int binary(BinaryOp op, int a, int b) {
        switch (op) {
            case BinaryOp::iff:
            case BinaryOp::equal:
                return a == b ? 1 : 0;
            case BinaryOp::not_equal:
                return a != b ? 1 : 0;
            case BinaryOp::implies:
                return a <= b ? 1 : 0;
            case BinaryOp::conjunction:
                return a & b;
            case BinaryOp::disjunction:
                return a | b;
            case BinaryOp::less:
                return a < b ? 1 : 0;
            case BinaryOp::less_equal:
                return a <= b ? 1 : 0;
            case BinaryOp::greater:
                return a > b ? 1 : 0;
            case BinaryOp::greater_equal:
                return a >= b ? 1 : 0;
            case BinaryOp::plus:
                return a + b;
            case BinaryOp::minus:
                return a - b;
            case BinaryOp::times:
                return a * b;
            case BinaryOp::in:
            case BinaryOp::divide:
            case BinaryOp::modulus:
            case BinaryOp::concat:
                break;
        }
        throw std::logic_error("not in these tests");
    }
};

/// Returns whether some enumerated values satisfy the guard. The formulas below contain at most 3 comparisons with
/// numbers up to 3, so if there is a solution, there is one within the bounds of the enumeration.
bool some_values_satisfy(const Expr& guard) {
    constexpr int most = 7;
    Values v;
    for (v.x = -most; v.x <= most; ++v.x)
        for (v.y = -most; v.y <= most; ++v.y)
            for (v.n = 0; v.n <= most; ++v.n)
                for (int rest = 0; rest < 12; ++rest) {
                    v.p = rest & 1;
                    v.q = rest >> 1 & 1;
                    v.c = rest >> 2;
                    if (v.of(guard) != 0) return true;
                }
    return false;
}

class RandomGuard {
public:
    explicit RandomGuard(unsigned seed) : random_(seed) {}

    std::string formula(int depth) {
        const int kind = pick(depth > 0 ? 9 : 4);
        if (kind < 4) return atom(kind);
        const std::string a = formula(depth - 1);
        const std::string b = formula(depth - 1);
        if (kind == 4) return "( not " + a + " )";
        if (kind == 5) return "( " + a + " /\\ " + b + " )";
        if (kind == 6) return "( " + a + " \\/ " + b + " )";
        if (kind == 7) return "( " + a + " => " + b + " )";
        return "( if " + a + " then " + b + " else not " + b + " end )";
    }

private:
    int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

    std::string atom(int kind) {
        const char* colours[] = {"red", "green", "blue"};
        const char* relations[] = {" < ", " <= ", " > ", " >= ", " == ", " != "};
        if (kind == 0) return pick(2) == 0 ? "p" : "q";
        // Each statement draws only one random number, because compilers evaluate operands in different orders.
        if (kind == 1) {
            const char* relation = pick(2) == 0 ? "==" : "!=";
            return std::string("c ") + relation + " Colour::" + colours[pick(3)];
        }
        if (kind == 2) return "x in { 1, " + std::to_string(pick(4)) + " }";
        const std::string left = term();
        const std::string relation = relations[pick(6)];
        return "( " + left + relation + term() + " )";
    }

    std::string term() {
        const char* terms[] = {"x", "y", "n", "x + y", "2 * x", "n - x", "- y"};
        const int kind = pick(10);
        return kind < 7 ? terms[kind] : std::to_string(pick(4));
    }

    std::mt19937 random_;
};

TEST(GuardLogic, AgreesWithTryingAllSmallValues) {
    std::size_t impossible = 0;
    std::size_t possible = 0;
    for (unsigned seed = 0; seed < 600; ++seed) {
        const std::string text = RandomGuard(seed).formula(2);
        const auto reading = guarded(text);
        logic::Reasoner reasoner(false);
        const logic::Finding finding = reasoner.decide(reasoner.read(guard_of(*reading)));
        const bool exists = some_values_satisfy(guard_of(*reading));
        if (exists) {
            EXPECT_NE(finding.answer, logic::Answer::impossible) << text;
        }
        if (finding.answer == logic::Answer::possible && finding.trusted) {
            EXPECT_TRUE(exists) << text << "\n" << finding.example;
        }
        impossible += finding.answer == logic::Answer::impossible ? 1 : 0;
        possible += finding.answer == logic::Answer::possible ? 1 : 0;
    }
    EXPECT_GT(impossible, 5U);
    EXPECT_GT(possible, 150U);
}

TEST(GuardLogic, ProvesWhatLinearArithmeticProves) {
    const auto never = [](const char* guard) { return decided(guard).answer == logic::Answer::impossible; };
    EXPECT_TRUE(never("x > 3 /\\ x < 4"));
    EXPECT_TRUE(never("x < y /\\ y < x"));
    EXPECT_TRUE(never("x < y /\\ y < n /\\ n <= x"));
    EXPECT_TRUE(never("2 * x + 3 < 1 /\\ x > -1"));
    EXPECT_TRUE(never("n < 0"));
    EXPECT_TRUE(never("x in { 1, 2 } /\\ x > 2"));
    EXPECT_TRUE(never("c != Colour::red /\\ c != Colour::green /\\ c != Colour::blue"));
    EXPECT_TRUE(never("p == q /\\ p /\\ not q"));
    EXPECT_TRUE(never("p iff not p"));
    EXPECT_FALSE(never("x > 3 /\\ x < 5"));
    EXPECT_FALSE(never("x / 2 > 1 /\\ x / 2 < 1.5"));
    EXPECT_EQ(decided("x <= y \\/ y < x", true).answer, logic::Answer::impossible);
}

TEST(GuardLogic, ShowsValues) {
    EXPECT_EQ(decided("x > 3 /\\ not p").example, "`x` is 4 and `p` is false");
    EXPECT_EQ(decided("x == 2 /\\ c != Colour::red").example, "`x` is 2 and `c` is green");
    EXPECT_EQ(decided("x < y").example, "`x < y` is true");
}

TEST(GuardLogic, TrustsNoValuesOfCalls) {
    const auto reading = resolved(
        "function f(a:nat):boolean { } stm S { event e initial i state A { } transition t0 { from i to A } "
        "transition t1 { from A to A trigger e condition not f(1) } }");
    logic::Reasoner reasoner(false);
    const logic::Finding finding = reasoner.decide(reasoner.read(guard_of(*reading)));
    EXPECT_EQ(finding.answer, logic::Answer::possible);
    EXPECT_FALSE(finding.trusted);
}

TEST(GuardLogic, GivesUpInsteadOfRunningForEver) {
    std::string guard = "p";
    for (int i = 0; i < 40; ++i) guard += " /\\ ( x + " + std::to_string(i) + " * y < n \\/ q )";
    guard += " /\\ not p";
    EXPECT_EQ(decided(guard).answer, logic::Answer::impossible);
    std::string wide = "n < 0";
    for (int i = 0; i < 24; ++i)
        wide += " \\/ ( x + " + std::to_string(i) + " * y == n /\\ x * x > " + std::to_string(i) + " * y )";
    static_cast<void>(decided(wide));
}

// ---------------------------------------------------------------- messages

TEST(Lints, SayForWhichValuesAJunctionIsStuck) {
    const auto reading =
        resolved(testing::read_contents(tests::source_folder().string() + "/tests/frontend/fixtures/RC-W02/bad.rct"));
    EXPECT_NE(reading->report().find("junction `j` has no enabled transition: when `x` is 3, none of its guards holds"),
              std::string::npos)
        << reading->report();
    EXPECT_NE(reading->report().find("`t2` needs this"), std::string::npos) << reading->report();
}

TEST(Lints, SayTheDefaultOfWhatIsNotSet) {
    const auto expect_value = [](const std::string& type, const std::string& value) {
        const auto reading = resolved("enumeration E { first second } stm S { var v:" + type + " event out:" + type +
                                      " initial i state A { entry out!v } transition t { from i to A } }");
        EXPECT_NE(reading->report().find("its value is " + value + " then"), std::string::npos) << reading->report();
    };
    expect_value("boolean", "true");
    expect_value("nat", "0");
    expect_value("E", "first");
    expect_value("Seq(nat)", "the empty sequence");
}

TEST(Lints, PointAtTheUseOfALooseEvent) {
    const auto reading =
        resolved(testing::read_contents(tests::source_folder().string() + "/tests/frontend/fixtures/RC-W01/bad.rct"));
    const auto findings = reading->findings.sorted_findings();
    ASSERT_EQ(findings.size(), 1U) << reading->report();
    ASSERT_EQ(findings.front().notes.size(), 1U);
    EXPECT_EQ(
        reading->sources.position(findings.front().notes.front().span.source, findings.front().notes.front().span.begin)
            .line,
        13U);
}

// ---------------------------------------------------------------- cases without warnings

/// A machine with an unused variable and an unreachable node.
const std::string careless = "stm S { var v:nat initial i state A { } state B { } transition t { from i to A } }";

TEST(Lints, LeaveFilesWithErrorsAlone) {
    EXPECT_EQ(resolved(careless)->codes(), "RC-W07@1 RC-W03@1");
    EXPECT_EQ(resolved(careless + "\ninterface I { var w:Nonsense }")->codes(), "RC-N01@2");
}

TEST(Lints, LookAtOtherFilesOfAProjectWithErrorsOneByOne) {
    testing::Reading reading;
    for (const std::string& text : {careless, std::string("interface I { var w:Nonsense }")}) {
        const auto id = reading.sources.add("t" + std::to_string(reading.sources.size()), text);
        reading.model.files.push_back(parse(reading.sources, id, false, reading.findings));
    }
    resolve(reading.model, reading.findings);
    // It is unknown whether the variable is used, because the other file has errors.
    EXPECT_EQ(reading.codes(), "RC-W03@1 RC-N01@1") << reading.report();
}

TEST(Lints, CanBeSwitchedOff) {
    testing::Reading reading;
    reading.findings.allow_code("RC-W07");
    reading.findings.allow_code("RC-N01");
    const auto id = reading.sources.add("t", careless);
    reading.model.files.push_back(parse(reading.sources, id, false, reading.findings));
    resolve(reading.model, reading.findings);
    EXPECT_EQ(reading.codes(), "RC-W03@1");
    EXPECT_EQ(reading.findings.warning_count(), 1U);
}

/// The project's own models cause no warnings, with two exceptions. One is the note that untimed checks ignore clocks.
/// The other is the published swarm model, in which components that call no operation require the only interface of
/// operations.
TEST(Lints, HaveNothingToSayAboutTheCorpus) {
    std::size_t models = 0;
    for (const auto& entry : std::filesystem::directory_iterator(tests::source_folder().string() + "/corpus")) {
        testing::Reading reading;
        reading.findings.allow_code("RC-U01");
        reading.findings.allow_code("STM8");
        const auto model = load_project(reading.sources, entry.path().string(), reading.findings);
        if (!reading.findings.ok()) continue;  // the assertions are about models of another folder
        ++models;
        EXPECT_TRUE(reading.findings.empty()) << reading.report();
    }
    EXPECT_GE(models, 2U);
}

}  // namespace
}  // namespace robochart::frontend
