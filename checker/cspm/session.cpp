// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>
#include <new>

#include "checker/cspm/earlier_answers.hpp"
#include "checker/cspm/eval/evaluator.hpp"
#include "checker/cspm/resolve/resolver.hpp"
#include "checker/cspm/resolve/unread_parameters.hpp"
#include "checker/cspm/syntax/lookup.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/cspm/types/deep_stack.hpp"
#include "checker/cspm/whole_run.hpp"
#include "checker/machine/compiler.hpp"
#include "checker/machine/not_compiled.hpp"
#include "checker/process/operational_semantics.hpp"
#include "checker/process/term_system.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/verdict/level_strategy.hpp"
#include "diagnostics/ending.hpp"
#include "diagnostics/utf8.hpp"

namespace robochart::cspm {

namespace {

using PlaceOfTerm = std::function<Span(process::TermId)>;

// Converts errors of the firing rules to evaluation errors, so that users of a session see one kind: at the erroneous
// definition, if `place_of` knows it, otherwise at `span`.
template <class Work>
auto evaluated(Span span, const PlaceOfTerm& place_of, const Work& work) {
    try {
        return work();
    } catch (const process::SemanticsError& error) {
        const Span place = error.term ? place_of(*error.term) : Span{};
        throw EvaluationError(error.what(), place.known() ? place : span, {});
    }
}

// A process that stays a term.
class SessionSystem final : public lts::TransitionSystem {
public:
    /// Errors are placed at the erroneous definition, which `place` returns, or otherwise at `span`.
    SessionSystem(process::OperationalSemantics& semantics, process::TermId term, Span span, PlaceOfTerm place)
        : system_(semantics, term), span_(span), place_(std::move(place)) {}

    [[nodiscard]] std::size_t width() const override { return system_.width(); }
    void initial(std::span<lts::Word> state) override { system_.initial(state); }
    void successors(lts::StateView state, lts::SuccessorSink& sink) override {
        evaluated(span_, place_, [&] { system_.successors(state, sink); });
    }
    [[nodiscard]] const process::EventTable& events() const override { return system_.events(); }
    [[nodiscard]] bool states_are_terms() const override { return true; }
    [[nodiscard]] std::string describe(lts::StateView state) const override { return system_.describe(state); }
    void watch(const std::function<void()>& poll) override { system_.watch(poll); }

private:
    process::TermSystem system_;
    Span span_;
    PlaceOfTerm place_;
};

/// Truncates a description to one line, without splitting characters.
std::string brief(std::string text) {
    constexpr std::size_t longest = 80;
    if (text.size() <= longest) return text;
    std::size_t end = longest;
    while (diagnostics::is_continuation(text[end])) --end;
    return text.substr(0, end) + "…";
}

std::string written(const Decl& assertion) {
    std::string text = print(Script{{std::make_shared<const Decl>(assertion)}});
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

void negate(refine::Verdict& verdict) {
    if (verdict.outcome == refine::Outcome::holds)
        verdict.outcome = refine::Outcome::fails;
    else if (verdict.outcome == refine::Outcome::fails)
        verdict.outcome = refine::Outcome::holds;
}

}  // namespace

struct Session::Impl {
    Impl(Script given, diagnostics::Budget* budget, bool whole_states)
        : script(std::move(given)),
          terms(events),
          semantics(terms, &compressor),
          compiler(semantics),
          resolver(program, store),
          evaluator(program, store, events, terms) {
        compressor.use(compiler);
        if (budget != nullptr) resolver.watch([budget] { budget->poll(); });
        on_deep_stack([this, whole_states] {
            resolver.script(script);
            if (!whole_states) find_unread_parameters(program);
        });
        resolver.watch({});
    }

    struct Ready {
        const Code* code = nullptr;
        const Unit* unit = nullptr;
    };
    Ready ready(const ExprPtr& expr, const Decl* place = nullptr) {
        Unit* unit = nullptr;
        const Code* code = nullptr;
        on_deep_stack([&] { code = resolver.expression(expr, place, unit); });
        return {code, unit};
    }

    template <class Work>
    auto evaluated_at(Span span, const Work& work) {
        return evaluated(
            span, [this](process::TermId at) { return place_of(at); }, work);
    }

    /// The definition of the first call in the term.
    Span place_of(process::TermId term) {
        const process::Term& at = terms[term];
        if (at.op == process::Op::call) return evaluator.place_of_call(at.payload);
        for (const process::TermId child : at.children)
            if (const Span place = place_of(child); place.known()) return place;
        return {};
    }

    std::unique_ptr<SessionSystem> term_system(process::TermId term, Span span) {
        return std::make_unique<SessionSystem>(semantics, term, span,
                                               [this](process::TermId at) { return place_of(at); });
    }

    std::unique_ptr<lts::TransitionSystem> system(process::TermId term, Span span, const std::function<void()>& poll) {
        auto terms_alone = term_system(term, span);
        auto compiled = compiler.compile(term, poll);
        if (!compiled) return terms_alone;
        compiled->set_reference(std::move(terms_alone));
        return compiled;
    }

    std::unique_ptr<lts::TransitionSystem> whole_system(process::TermId term, Span span,
                                                        const std::function<void()>& poll) {
        machine::Bounds bounds;
        bounds.component_states *= 10;  // because they are not minimised
        bounds.minimised_states = 0;
        bounds.region_states = 0;
        auto compiled = machine::Compiler(semantics, bounds).compile(term, poll);
        if (compiled) return compiled;
        return term_system(term, span);
    }

    /// One side of an assertion as a term.
    process::TermId term_of(const ExprPtr& expr, const Decl& assertion) {
        const Ready code = ready(expr, &assertion);
        const process::TermId term = evaluator.process(*code.code, *code.unit);
        if (!assertion.assertion.tau_priority) return term;
        const Ready set = ready(assertion.assertion.tau_priority, &assertion);
        return evaluator.tau_priority(term, evaluator.event_set(*set.code, *set.unit));
    }

    std::unique_ptr<lts::TransitionSystem> side(const ExprPtr& expr, const Decl& assertion,
                                                const std::function<void()>& poll) {
        return system(term_of(expr, assertion), expr->span, poll);
    }

    /// Adds the omitted values to the run's descriptions; returns the run of terms in `whole`.
    std::optional<WholeRun> with_values(process::TermId process, std::string& initial, std::vector<refine::Step>& run) {
        std::optional<WholeRun> found = whole_run(whole->semantics, whole->events, process, initial, run, events);
        if (!found) return std::nullopt;
        initial = process::describe(whole->terms, found->initial);
        for (std::size_t i = 0; i < run.size(); ++i)
            run[i].state = process::describe(whole->terms, found->steps[i].target);
        return found;
    }

    std::optional<process::Behaviour> behaviour_with_values(const Decl& assertion, refine::Counterexample& shown,
                                                            const refine::Limits& limits) {
        if (!whole) whole = std::make_unique<Impl>(script, nullptr, true);
        refine::Budget budget(limits);
        const Polling polling(*whole, budget);
        const Assertion& asked = assertion.assertion;
        const bool refinement = asked.kind == AssertionKind::refinement;
        const process::TermId process =
            whole->term_of(refinement ? asked.implementation : asked.specification, assertion);
        if (!shown.accepting.empty()) (void)with_values(process, shown.accepting_initial, shown.accepting);
        const std::optional<WholeRun> run = with_values(process, shown.initial, shown.steps);
        if (!run) return std::nullopt;
        process::Behaviour result = process::behaviour(whole->semantics, run->initial, run->steps);
        translate(result, [&](process::Event event) { return events.intern(whole->events.name(event)); });
        return result;
    }

    refine::Model model(const Decl& assertion) const {
        switch (assertion.assertion.model) {
            case Model::traces:
                return refine::Model::traces;
            case Model::failures:
                return refine::Model::failures;
            case Model::none:
            case Model::failures_divergences:
                return refine::Model::failures_divergences;
            default:
                throw EvaluationError("the models R, RD, V and VD are not supported", assertion.span, {});
        }
    }

    /// During its lifetime, definitions are evaluated within the limits of the check that needs them.
    class Polling {
    public:
        Polling(Impl& impl, refine::Budget& budget) : impl_(impl) {
            // The evaluator polls seldom, since its steps are small.
            constexpr std::uint64_t at_once = 1024;
            impl_.evaluator.watch([&budget] { budget.charge(at_once); });
            impl_.semantics.watch([this, &budget] {
                budget.states(impl_.semantics.states_explored());
                budget.charge();
            });
        }
        Polling(const Polling&) = delete;
        Polling& operator=(const Polling&) = delete;
        ~Polling() {
            impl_.evaluator.watch({});
            impl_.semantics.watch({});
        }

    private:
        Impl& impl_;
    };

    void tell_stage(refine::Progress& progress) const {
        const machine::Compiler::Stage& stage = compiler.stage();
        if (stage.component) progress.part = brief(process::describe(terms, *stage.component));
        progress.component = stage.number;
        progress.components = stage.of;
        progress.states = stage.states;
    }

    /// Used during compilation. A component with more states than the check's limit is not compiled: it runs as a term,
    /// of which only the states that the whole process reaches count.
    std::function<void()> polling_within(refine::Budget& budget, const refine::Limits& limits) const {
        return [this, &budget, most = limits.max_states] {
            budget.charge();
            if (compiler.stage().states > most) throw machine::NotCompiled("a component has too many states");
        };
    }

    struct Sides {
        std::unique_ptr<lts::TransitionSystem> first, second;  ///< second: only for a refinement
    };

    Sides sides(const Decl& assertion, const refine::Limits& limits) {
        refine::Budget budget(limits, refine::Progress::Phase::compiling);
        budget.report_by([this](refine::Progress& progress) { tell_stage(progress); });
        const Polling polling(*this, budget);
        const std::function<void()> poll = polling_within(budget, limits);
        Sides result;
        result.first = side(assertion.assertion.specification, assertion, poll);
        if (assertion.assertion.kind == AssertionKind::refinement)
            result.second = side(assertion.assertion.implementation, assertion, poll);
        return result;
    }

    /// The stage of the compilation when it was stopped.
    std::string stage_reached() const {
        const machine::Compiler::Stage& stage = compiler.stage();
        if (!stage.component) return "";
        std::string text =
            fmt::format("; {} states of {}", stage.states, brief(process::describe(terms, *stage.component)));
        if (stage.of > 0) text += fmt::format(", component {} of {}", stage.number, stage.of);
        return text;
    }

    /// A strategy by levels is notified of each assertion before it is evaluated.
    refine::Verdict decide(const Decl& assertion, const refine::Limits& limits, AssertionResult& result) {
        refine::LevelStrategy* const strategy = limits.by_levels;
        if (strategy == nullptr) return decide_begun(assertion, limits, result);
        strategy->begin_question(written(assertion));
        refine::Verdict verdict;
        try {
            verdict = decide_begun(assertion, limits, result);
        } catch (...) {
            strategy->end_question(false);
            throw;
        }
        strategy->end_question(verdict.outcome != refine::Outcome::inconclusive);
        return verdict;
    }

    refine::Verdict decide_begun(const Decl& assertion, const refine::Limits& limits, AssertionResult& result) {
        const Assertion& asked = assertion.assertion;
        const refine::Model in = model(assertion);
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t work = std::clock();
        const Sides both = sides(assertion, limits);
        result.compile_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        result.compile_cpu_seconds = static_cast<double>(std::clock() - work) / CLOCKS_PER_SEC;
        refine::Limits quiet = limits;
        quiet.progress = {};
        refine::Budget evaluation(quiet);
        const Polling polling(*this, evaluation);
        const auto ask = [&](refine::Earlier earlier) { return ask_of(both, assertion, in, limits, earlier); };
        if (limits.by_levels != nullptr)
            return decide_by_levels(question_of(both, assertion, limits), *limits.by_levels, evaluation, ask);
        if (memory.cache == nullptr || asked.kind == AssertionKind::has_trace) return ask(nullptr);
        const Question question = question_of(both, assertion, limits);
        const auto key = key_of(
            question, [&evaluation] { evaluation.charge(); }, longest_look);
        return key ? answer(question, *key, memory, ask) : ask(nullptr);
    }

    Question question_of(const Sides& both, const Decl& assertion, const refine::Limits& limits) const {
        const bool two = assertion.assertion.kind == AssertionKind::refinement;
        return {assertion.assertion.kind,
                model(assertion),
                two ? both.first.get() : nullptr,
                two ? both.second.get() : both.first.get(),
                limits.max_states,
                limits.reduction};
    }

    /// Such a search may continue an earlier run's, independently of the limit that ended it. Its answers are stored
    /// separately, since the statistics of a search that finds a violation differ.
    refine::Verdict decide_by_levels(Question question, refine::LevelStrategy& strategy, refine::Budget& evaluation,
                                     const std::function<refine::Verdict(refine::Earlier)>& ask) {
        question.max_states = 0;
        std::optional<QuestionKey> key;
        if (question.kind != AssertionKind::has_trace)
            key = key_of(
                question, [&evaluation] { evaluation.charge(); }, std::nullopt);
        strategy.identify_question(key ? std::optional(key->digest) : std::nullopt);
        const Memory kept{strategy.answers(), 0};
        return key && kept.cache != nullptr ? answer(question, *key, kept, ask) : ask(nullptr);
    }

    refine::Verdict ask_of(const Sides& both, const Decl& assertion, refine::Model in, const refine::Limits& limits,
                           refine::Earlier earlier) {
        auto& first = *both.first;
        switch (assertion.assertion.kind) {
            case AssertionKind::refinement:
                return refine::refines(first, *both.second, in, limits, earlier);
            case AssertionKind::deadlock_free:
                return refine::deadlock_free(first, in, limits, earlier);
            case AssertionKind::divergence_free:
                return refine::divergence_free(first, limits, earlier);
            case AssertionKind::deterministic:
                return refine::deterministic(first, in, limits, earlier);
            case AssertionKind::has_trace: {
                const Ready trace = ready(assertion.assertion.implementation, &assertion);
                return refine::has_trace(first, evaluator.trace(*trace.code, *trace.unit), in, limits);
            }
        }
        throw EvaluationError("an assertion of no kind", assertion.span, {});
    }

    Script script;
    Program program;
    ValueStore store;
    process::EventTable events;
    process::TermStore terms;
    machine::MachineCompressor compressor;
    process::OperationalSemantics semantics;
    machine::Compiler compiler;
    Resolver resolver;
    Evaluator evaluator;
    Memory memory;
    std::unique_ptr<Impl> whole;  ///< the same script with all arguments kept; null until it is needed to display a run
};

Session::Session(Script script, diagnostics::Budget* budget, bool whole_states)
    : impl_(std::make_unique<Impl>(std::move(script), budget, whole_states)) {}
Session::~Session() {
    diagnostics::discard(impl_);
}

const Script& Session::script() const {
    return impl_->script;
}

std::vector<DeclPtr> Session::assertions() const {
    return assertions_in(impl_->script.decls);
}

void Session::observe(CallObserver observer) {
    impl_->evaluator.observe(std::move(observer));
}

void Session::remember(diagnostics::Cache& cache, std::uint64_t fewest_states) {
    impl_->memory = {&cache, fewest_states};
}

AssertionResult Session::check(const Decl& assertion, const refine::Limits& limits) {
    AssertionResult result;
    result.text = written(assertion);
    result.span = assertion.span;
    result.negated = assertion.assertion.negated;
    try {
        result.verdict = impl_->evaluated_at(assertion.span, [&] { return impl_->decide(assertion, limits, result); });
    } catch (const process::Interrupted& stopped) {
        result.verdict = {};
        result.verdict.reason = stopped.what() + impl_->stage_reached();
    } catch (const std::bad_alloc&) {
        result.verdict = {};
        result.verdict.reason = "there is no more memory";
    }
    if (result.negated) negate(result.verdict);
    return result;
}

std::optional<process::Behaviour> Session::behaviour(const refine::Counterexample& counterexample, bool offers) {
    if (counterexample.terms.empty()) return std::nullopt;
    std::vector<process::Transition> run;
    const auto append = [&run](const std::vector<refine::Step>& steps, const std::vector<process::TermId>& reached) {
        for (std::size_t i = 0; i < steps.size(); ++i)
            run.push_back({steps[i].event, steps[i].revealed, reached[i + 1]});
    };
    append(counterexample.steps, counterexample.terms);
    append(counterexample.loop, counterexample.loop_terms);
    try {
        return process::behaviour(impl_->semantics, counterexample.terms.front(), run, offers);
    } catch (const EvaluationError&) {
        // Terms inside a compression may be visited that the search has not evaluated; the verdict is given without
        // them.
    } catch (const process::SemanticsError&) {
    }
    return std::nullopt;
}

std::vector<process::Transition> Session::transitions(process::TermId term) {
    return impl_->evaluated_at({}, [&] {
        const auto found = impl_->semantics.successors(term);
        return std::vector<process::Transition>(found.begin(), found.end());
    });
}

std::vector<process::Move> Session::moves(process::TermId term, const process::Transition& step) {
    return impl_->evaluated_at({}, [&] { return process::moves(impl_->semantics, term, step); });
}

process::TermId Session::process(const ExprPtr& expr) {
    const Impl::Ready ready = impl_->ready(expr);
    return impl_->evaluated_at(expr->span, [&] { return impl_->evaluator.process(*ready.code, *ready.unit); });
}

std::unique_ptr<lts::TransitionSystem> Session::system(const ExprPtr& expr) {
    return impl_->evaluated_at(expr->span, [&] { return impl_->system(process(expr), expr->span, {}); });
}

std::unique_ptr<lts::TransitionSystem> Session::system(const ExprPtr& expr, const refine::Limits& limits) {
    refine::Budget budget(limits, refine::Progress::Phase::compiling);
    budget.report_by([this](refine::Progress& progress) { impl_->tell_stage(progress); });
    const Impl::Polling polling(*impl_, budget);
    return impl_->evaluated_at(
        expr->span, [&] { return impl_->system(process(expr), expr->span, impl_->polling_within(budget, limits)); });
}

std::unique_ptr<lts::TransitionSystem> Session::whole_system(const ExprPtr& expr, const refine::Limits& limits) {
    refine::Budget budget(limits, refine::Progress::Phase::compiling);
    const Impl::Polling polling(*impl_, budget);
    return impl_->evaluated_at(
        expr->span, [&] { return impl_->whole_system(process(expr), expr->span, [&budget] { budget.charge(); }); });
}

process::EventSet Session::events(const ExprPtr& expr) {
    const Impl::Ready ready = impl_->ready(expr);
    return impl_->evaluator.event_set(*ready.code, *ready.unit);
}

std::optional<process::Behaviour> Session::behaviour_with_values(const Decl& assertion,
                                                                 refine::Counterexample& counterexample,
                                                                 const refine::Limits& limits) {
    const auto lacks = [](const std::vector<refine::Step>& run) {
        return std::ranges::any_of(run, [](const refine::Step& step) { return leaves_values_out(step.state); });
    };
    const bool values =
        leaves_values_out(counterexample.initial) || lacks(counterexample.steps) || lacks(counterexample.accepting);
    // In a loop, values may change in every round, although the state without them repeats.
    if (!values || counterexample.terms.empty() || !counterexample.loop.empty())
        return behaviour(counterexample, limits);
    try {
        if (auto found = impl_->behaviour_with_values(assertion, counterexample, limits)) return found;
    } catch (const process::Interrupted&) {
    } catch (const EvaluationError&) {
    } catch (const process::SemanticsError&) {
    }
    return behaviour(counterexample, limits);
}

std::optional<process::Behaviour> Session::behaviour(const refine::Counterexample& counterexample,
                                                     const refine::Limits& limits) {
    refine::Budget budget(limits);
    const Impl::Polling polling(*impl_, budget);
    try {
        return behaviour(counterexample);
    } catch (const process::Interrupted&) {
        return std::nullopt;
    }
}

std::string Session::evaluate(const ExprPtr& expr, const refine::Limits& limits) {
    refine::Budget budget(limits);
    const Impl::Polling polling(*impl_, budget);
    return evaluate(expr);
}

std::string Session::evaluate(const ExprPtr& expr) {
    const Impl::Ready ready = impl_->ready(expr);
    return impl_->evaluator.print(*ready.code, *ready.unit);
}

process::EventTable& Session::event_table() {
    return impl_->events;
}
process::TermStore& Session::terms() {
    return impl_->terms;
}

}  // namespace robochart::cspm
