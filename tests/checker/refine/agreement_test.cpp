// The checker against the naive reference on random processes over all operators, in every model. The number of
// random pairs comes from RC_PARAMS (max_success); each gives thirteen checks, by every engine.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>

#include "checker/machine/compiler.hpp"
#include "checker/refine/check.hpp"
#include "naive.hpp"
#include "random_process.hpp"
#include "translate.hpp"

namespace robochart::refine {
namespace {

using naive::Behaviour;
using naive::Semantics;

constexpr std::size_t largest_graph = 120;
constexpr auto models = {std::pair{Semantics::T, Model::traces}, std::pair{Semantics::F, Model::failures},
                         std::pair{Semantics::FD, Model::failures_divergences}};

/// How often each answer was seen, so that the test cannot become empty.
struct Seen {
    int checks = 0;
    int holds = 0;
    int fails = 0;
    void count(bool held) { ++checks, ++(held ? holds : fails); }
};

struct Pair;

class Agreement : public testing::Test {
protected:
    void expect(const Verdict& verdict, bool holds, const char* question) {
        seen_[question].count(holds);
        RC_LOG() << question << (holds ? ": should hold" : ": should fail") << std::endl;
        RC_ASSERT(verdict.outcome == (holds ? Outcome::holds : Outcome::fails));
        RC_ASSERT(verdict.counterexample.has_value() == !holds);
    }
    enum class Engine { terms, compressing_terms, machines };
    void compare(const Pair& pair, Engine engine);
    std::unique_ptr<lts::TransitionSystem> system(Translation& translation, const naive::Process& process,
                                                  Engine engine);
    std::map<std::string, Seen> seen_;
    int plain_ = 0;
    int compressed_ = 0;
    int compiled_ = 0;
    int left_as_terms_ = 0;
};

/// Whether the process uses the operator anywhere, its definitions left aside: those use neither of the two asked for.
bool uses(const naive::Process& process, naive::Kind kind) {
    if (process->kind == kind) return true;
    return std::any_of(process->operands.begin(), process->operands.end(),
                       [kind](const naive::Process& operand) { return uses(operand, kind); });
}

/// One random pair of processes, and what the definitions say of them.
struct Pair {
    naive::Script script;
    naive::Graph first;
    naive::Graph second;
    std::vector<naive::Letter> trace;

    [[nodiscard]] Behaviour a() const { return {first, naive::letters_used}; }
    [[nodiscard]] Behaviour b() const { return {second, naive::letters_used}; }
    /// Compressions may change what chase follows.
    [[nodiscard]] bool compressible() const {
        const bool chases = uses(script.mains[0], naive::Kind::chase) || uses(script.mains[1], naive::Kind::chase);
        return !chases &&
               (uses(script.mains[0], naive::Kind::compress) || uses(script.mains[1], naive::Kind::compress));
    }
};

Pair random_pair() {
    const std::vector<unsigned> list = *rc::gen::container<std::vector<unsigned>>(rc::gen::inRange<unsigned>(0, 2520));
    naive::Script script = naive::Decoder(list).script(2);
    // A quarter of the pairs are related, so that refinements hold often enough.
    if (!list.empty() && list[0] % 4 == 0)
        script.mains[0] = std::make_shared<const naive::Tree>(
            naive::Tree{naive::Kind::internal, {script.mains[0], script.mains[1]}, {}, {}, {}, {}, 0});
    auto first = naive::explore(script, script.mains[0], largest_graph);
    auto second = naive::explore(script, script.mains[1], largest_graph);
    RC_PRE(first && second);
    RC_LOG() << show(script) << std::endl;
    return {
        script, *first, *second, {static_cast<int>(list.size() % 3), list.empty() ? 0 : static_cast<int>(list[0] % 3)}};
}

std::unique_ptr<lts::TransitionSystem> Agreement::system(Translation& translation, const naive::Process& process,
                                                         Engine engine) {
    if (engine == Engine::machines) {
        machine::Compiler compiler(translation.semantics());
        if (auto compiled = compiler.compile(translation.term(process), {})) return ++compiled_, std::move(compiled);
        ++left_as_terms_;
    }
    return std::make_unique<lts::TermSystem>(translation.system(process));
}

void Agreement::compare(const Pair& pair, Engine engine) {
    const bool compressing = engine == Engine::compressing_terms;
    RC_LOG() << (compressing ? "with compressions" : engine == Engine::terms ? "as terms" : "compiled") << std::endl;
    const Behaviour a = pair.a();
    const Behaviour b = pair.b();
    Translation translation(pair.script, compressing);
    const auto first = system(translation, pair.script.mains[0], engine);
    const auto second = system(translation, pair.script.mains[1], engine);
    lts::TransitionSystem& sa = *first;
    lts::TransitionSystem& sb = *second;
    const Limits limits{};
    for (const auto& [semantics, model] : models) {
        const char* const name = semantics == Semantics::T ? "[T=" : semantics == Semantics::F ? "[F=" : "[FD=";
        const Verdict forth = refines(sa, sb, model, limits);
        expect(forth, naive::refines(a, b, semantics), name);
        expect(refines(sb, sa, model, limits), naive::refines(b, a, semantics), name);
        if (!compressing && semantics != Semantics::FD && forth.counterexample)
            RC_ASSERT(forth.counterexample->steps.size() == *naive::shortest_violation(a, b, semantics));
        if (semantics == Semantics::T) continue;
        expect(deadlock_free(sb, model, limits), naive::deadlock_free(b, semantics), "deadlock free");
        expect(deterministic(sb, model, limits), naive::deterministic(b, semantics), "deterministic");
    }
    expect(divergence_free(sb, limits), naive::divergence_free(b), "divergence free");
    expect(has_trace(sb, {translation.event(pair.trace[0]), translation.event(pair.trace[1])}, Model::traces, limits),
           naive::has_trace(b, pair.trace), "has trace");
    expect(refines(sb, sb, Model::failures_divergences, limits), true, "reflexive");
    ++(compressing ? compressed_ : plain_);
}

TEST_F(Agreement, OnRandomProcesses) {
    const bool agreed = rc::check("the checker agrees with the definitions", [this] {
        const Pair pair = random_pair();
        compare(pair, Engine::terms);
        compare(pair, Engine::machines);
        if (pair.compressible()) compare(pair, Engine::compressing_terms);
    });
    EXPECT_TRUE(agreed);
    int checks = 0;
    for (const auto& [question, seen] : seen_) {
        checks += seen.checks;
        RecordProperty(question, std::to_string(seen.holds) + " hold, " + std::to_string(seen.fails) + " fail");
        EXPECT_GT(seen.holds * 20, seen.checks) << question << " held too rarely to be tested: " << seen.holds;
        if (question != "reflexive") {
            EXPECT_GT(seen.fails * 20, seen.checks) << question << " failed too rarely to be tested: " << seen.fails;
        }
    }
    EXPECT_GE(checks, 5000);
    EXPECT_GT(compiled_ * 15, left_as_terms_) << "too few processes were compiled: " << compiled_;
    EXPECT_GT(compressed_ * 30, plain_) << "too few pairs with compressions: " << compressed_;
}

}  // namespace
}  // namespace robochart::refine
