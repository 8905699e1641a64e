// SPDX-License-Identifier: Apache-2.0
// Tests that read(print(tree)) == tree for random trees over the whole language.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "checker/cspm/syntax/build.hpp"
#include "tests/checker/cspm/support.hpp"

namespace robochart::cspm::test {
namespace {

using namespace build;

// Generates random trees whose height is at most the size.
class Trees {
public:
    ExprPtr expr(int size) {
        if (size <= 0) return leaf();
        const int next = size - 1;
        switch (pick(30)) {
            case 0:
                return tuple({expr(next), expr(next)});
            case 1:
                return sequence(exprs(next));
            case 2:
                return set(exprs(next));
            case 3:
                return range(pick(4), next);
            case 4:
                return comprehension(next);
            case 5:
                return dot({expr(next), expr(next)});
            case 6:
                return apply(expr(next), exprs(next));
            case 7:
                return lambda({pattern(next)}, expr(next));
            case 8:
                return let_({decl(next), decl(next)}, expr(next));
            case 9:
                return if_(expr(next), expr(next), expr(next));
            case 10:
                return negate(expr(next));
            case 11:
                return logical_not(expr(next));
            case 12:
                return node(ExprKind::length, {expr(next)});
            case 13:
                return node(ExprKind::map, {expr(next), expr(next)});
            case 14:
            case 15:
                return prefix(expr(next), fields(next), expr(next));
            case 16:
                return parallel(expr(next), expr(next), expr(next));
            case 17:
                return exception(expr(next), expr(next), expr(next));
            case 18:
                return alphabetised(expr(next), expr(next), expr(next), expr(next));
            case 19:
                return synchronising_choice(expr(next), expr(next), expr(next));
            case 20:
                return synchronising_interrupt(expr(next), expr(next), expr(next));
            case 21:
                return rename(expr(next), {{expr(next), expr(next)}}, maybe_clauses(next));
            case 22:
                return linked(expr(next), {{expr(next), expr(next)}, {expr(next), expr(next)}}, expr(next));
            case 23:
                return replication(next);
            default:
                return binary(operators[pick(std::size(operators))], expr(next), expr(next));
        }
    }

    DeclPtr decl(int size) {
        switch (pick(4)) {
            case 0:
                return function_decl("f", {pattern(size), pattern(size)}, expr(size));
            case 1:
                return value("v", expr(size));
            case 2:
                return timed(expr(size), {value("w", expr(size))});
            default:
                return transparent({"chase", "diamond"});
        }
    }

    DeclPtr top(int size) {
        switch (pick(8)) {
            case 0:
                return channel({"c", "d"}, expr(size), "two channels\nof one type");
            case 1:
                return datatype("D", {constructor("A"), constructor("B", expr(size))});
            case 2:
                return nametype("N", expr(size));
            case 3:
                return module_("M", {"k"}, {decl(size)}, {decl(size), channel({"e"})});
            case 4:
                return instance("I", "M", exprs(size));
            case 5:
                return assert_refines(expr(size), Model::failures, expr(size), pick(2) == 0);
            case 6:
                return assert_has_trace(expr(size), sequence(exprs(size)), Model::traces);
            default:
                return decl(size);
        }
    }

private:
    static constexpr ExprKind operators[] = {ExprKind::plus,
                                             ExprKind::minus,
                                             ExprKind::times,
                                             ExprKind::divide,
                                             ExprKind::modulus,
                                             ExprKind::equal,
                                             ExprKind::not_equal,
                                             ExprKind::less,
                                             ExprKind::less_equal,
                                             ExprKind::greater,
                                             ExprKind::greater_equal,
                                             ExprKind::logical_and,
                                             ExprKind::logical_or,
                                             ExprKind::concat,
                                             ExprKind::guard,
                                             ExprKind::external_choice,
                                             ExprKind::internal_choice,
                                             ExprKind::sequential,
                                             ExprKind::interrupt,
                                             ExprKind::sliding_choice,
                                             ExprKind::interleave,
                                             ExprKind::hide,
                                             ExprKind::project};

    static std::size_t pick(std::size_t count) {
        return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, count));
    }

    static ExprPtr node(ExprKind kind, Exprs args, std::vector<Clause> clauses = {}) {
        Expr result;
        result.kind = kind;
        result.args = std::move(args);
        result.clauses = std::move(clauses);
        return std::make_shared<const Expr>(std::move(result));
    }

    static ExprPtr leaf() {
        switch (pick(8)) {
            case 0:
                return number(static_cast<std::int64_t>(pick(20)) - 10);
            case 1:
                return boolean(pick(2) == 0);
            case 2:
                return string(pick(2) == 0 ? "a \"quoted\" \\ text\n" : "");
            case 3:
                return name("P::S::e");
            case 4:
                return node(ExprKind::productions, {name("c")});
            case 5:
                return set({});
            case 6:
                return sequence({});
            default:
                return name(pick(2) == 0 ? "x" : "y'");
        }
    }

    Exprs exprs(int size) {
        Exprs result;
        for (std::size_t i = pick(3); i > 0; --i) result.push_back(expr(size));
        return result;
    }

    ExprPtr range(std::size_t kind, int size) {
        const ExprKind kinds[] = {ExprKind::set_range, ExprKind::sequence_range, ExprKind::set_range_comprehension,
                                  ExprKind::sequence_range_comprehension};
        return node(kinds[kind], {expr(size), pick(3) == 0 ? nullptr : expr(size)},
                    kind < 2 ? std::vector<Clause>{} : clauses(size));
    }

    ExprPtr comprehension(int size) {
        const ExprKind kinds[] = {ExprKind::set_comprehension, ExprKind::sequence_comprehension,
                                  ExprKind::productions_comprehension};
        return node(kinds[pick(3)], {expr(size)}, clauses(size));
    }

    ExprPtr replication(int size) {
        const ExprKind plain[] = {ExprKind::replicated_external, ExprKind::replicated_internal,
                                  ExprKind::replicated_sequential, ExprKind::replicated_interleave};
        const ExprKind with_set[] = {ExprKind::replicated_parallel, ExprKind::replicated_alphabetised,
                                     ExprKind::replicated_synchronising};
        if (pick(2) == 0) return replicated(plain[pick(4)], clauses(size), expr(size));
        return replicated(with_set[pick(3)], clauses(size), expr(size), expr(size));
    }

    std::vector<Clause> clauses(int size) {
        std::vector<Clause> result{generator(pattern(size), expr(size))};
        if (pick(2) == 0) result.push_back(condition(expr(size)));
        return result;
    }

    std::vector<Clause> maybe_clauses(int size) { return pick(2) == 0 ? clauses(size) : std::vector<Clause>{}; }

    std::vector<Field> fields(int size) {
        std::vector<Field> result;
        for (std::size_t i = pick(3); i > 0; --i) {
            switch (pick(3)) {
                case 0:
                    result.push_back(output(expr(size)));
                    break;
                case 1:
                    result.push_back(input(pattern(size), pick(2) == 0 ? nullptr : expr(size)));
                    break;
                default:
                    result.push_back(nondeterministic(pattern(size), expr(size)));
                    break;
            }
        }
        return result;
    }

    PatternPtr pattern(int size) {
        if (size <= 0) return pick(2) == 0 ? wildcard() : variable("p");
        const int next = size - 1;
        switch (pick(8)) {
            case 0:
                return tuple_pattern({pattern(next), pattern(next)});
            case 1:
                return dot_pattern({pattern(next), pattern(next)});
            case 2:
                return sequence_pattern({pattern(next)});
            case 3:
                return combined(PatternKind::concat, next);
            case 4:
                return combined(PatternKind::both, next);
            case 5:
                return integer_pattern(static_cast<std::int64_t>(pick(9)) - 4);
            case 6:
                return boolean_pattern(pick(2) == 0);
            default:
                return variable("q");
        }
    }

    PatternPtr combined(PatternKind kind, int size) {
        Pattern result;
        result.kind = kind;
        result.args = {pattern(size), pattern(size)};
        return std::make_shared<const Pattern>(std::move(result));
    }
};

TEST(RoundTripTest, RandomTreesReadBackEqual) {
    const bool holds = rc::check("read(print(tree)) == tree", [] {
        Trees trees;
        Script script;
        const int height = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 5));
        for (int i = 0; i < 10; ++i) script.decls.push_back(trees.top(height));
        const std::string text = print(script);
        const Reading reading(text);
        RC_LOG(text + "\n" + reading.report() + (reading.ok() ? print(reading.script) : ""));
        RC_ASSERT(reading.ok());
        RC_ASSERT(equal(reading.script, script));
    });
    EXPECT_TRUE(holds);
}

}  // namespace
}  // namespace robochart::cspm::test
