// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <functional>
#include <limits>
#include <new>

#include "base/diagnostics/ending.hpp"
#include "base/diagnostics/utf8.hpp"
#include "checker/cspm/earlier_answers.hpp"
#include "checker/cspm/packed/loaded_script.hpp"
#include "checker/cspm/packed/not_packed.hpp"
#include "checker/cspm/packed/packed_system.hpp"
#include "checker/cspm/syntax/lookup.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/cspm/types/deep_stack.hpp"
#include "checker/cspm/whole_run.hpp"
#include "checker/machine/compiler.hpp"
#include "checker/machine/not_compiled.hpp"
#include "checker/process/term_system.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/verdict/level_strategy.hpp"
#include "checker/symbolic/stage.hpp"

namespace robochart::cspm {

namespace {

/// Thrown by a SessionSystem when it has created too many terms to continue with terms.
struct ManyTerms {};

// A process that is not compiled: its states are terms.
class SessionSystem final : public lts::TransitionSystem {
public:
    /// An error is reported at the definition that causes it. If that definition is unknown, it is reported at `span`.
    SessionSystem(LoadedScript& loaded, process::TermId term, Span span)
        : loaded_(loaded), system_(loaded.semantics, term), term_(term), span_(span) {}

    /// Adds the number of created terms to `made`. Throws ManyTerms when `made` reaches `most`.
    void limit_terms(std::size_t& made, std::size_t most) {
        made_ = &made;
        most_made_ = most;
    }
    void count_no_more() { made_ = nullptr; }
    [[nodiscard]] process::TermId term() const { return term_; }
    [[nodiscard]] Span span() const { return span_; }

    [[nodiscard]] std::size_t width() const override { return system_.width(); }
    void initial(std::span<lts::Word> state) override { system_.initial(state); }
    void successors(lts::StateView state, lts::SuccessorSink& sink) override {
        const std::size_t before = loaded_.terms.size();
        loaded_.evaluated_at(span_, [&] { system_.successors(state, sink); });
        if (made_ == nullptr) return;
        *made_ += loaded_.terms.size() - before;
        if (*made_ >= most_made_) throw ManyTerms{};
    }
    [[nodiscard]] std::vector<std::vector<lts::Word>> choice_operands(lts::StateView state) override {
        return loaded_.evaluated_at(span_, [&] { return system_.choice_operands(state); });
    }
    [[nodiscard]] const process::EventTable& events() const override { return system_.events(); }
    [[nodiscard]] bool states_are_terms() const override { return true; }
    [[nodiscard]] std::string describe(lts::StateView state) const override { return system_.describe(state); }
    void set_budget(diagnostics::Pollable& budget) override { system_.set_budget(budget); }

private:
    LoadedScript& loaded_;
    process::TermSystem system_;
    process::TermId term_;
    Span span_;
    std::size_t* made_ = nullptr;
    std::size_t most_made_ = 0;
};

/// Lets evaluations poll the budget of a check. An evaluation polls only once in many small steps, so each poll is
/// charged as many.
class EvaluationBudget final : public diagnostics::Pollable {
public:
    explicit EvaluationBudget(refine::Budget& budget) : budget_(budget) {}
    void poll() override {
        constexpr std::uint64_t at_once = 1024;
        budget_.charge(at_once);
    }

private:
    refine::Budget& budget_;
};

/// Lets the computation of transitions poll the budget of a check, and limits the states of compressed operands.
class SemanticsBudget final : public diagnostics::Pollable {
public:
    SemanticsBudget(const process::OperationalSemantics& semantics, refine::Budget& budget)
        : semantics_(semantics), budget_(budget) {}
    void poll() override {
        budget_.states(semantics_.states_explored());
        budget_.charge();
    }

private:
    const process::OperationalSemantics& semantics_;
    refine::Budget& budget_;
};

/// Lets a compilation poll the budget of a check. A component with more states than the limit of the check is not
/// compiled; the process is then searched as terms. This need not exceed the limit, because it only counts states that
/// the whole process reaches.
class CompilationBudget final : public diagnostics::Pollable {
public:
    CompilationBudget(const machine::Compiler& compiler, refine::Budget& budget)
        : compiler_(compiler), budget_(budget), most_states_(budget.limits().max_states) {}
    void poll() override {
        budget_.charge();
        if (compiler_.current_stage().states > most_states_)
            throw machine::NotCompiled("a component has too many states");
    }

private:
    const machine::Compiler& compiler_;
    refine::Budget& budget_;
    std::uint64_t most_states_;
};

/// If a search reaches this many states without an answer, the assertion is checked with compressed parts. If that
/// gives no answer either, all states are searched.
constexpr std::uint64_t first_states = 500'000;

/// Shortens a description to 80 bytes. Never splits a character.
std::string truncate_description(std::string text) {
    constexpr std::size_t longest = 80;
    if (text.size() <= longest) return text;
    return std::string(diagnostics::beginning_of(text, longest)) + "…";
}

std::string assertion_text(const Decl& assertion) {
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
    Impl(Script given, diagnostics::Budget* budget, bool keeps_states)
        : script(std::move(given)),
          whole_states(keeps_states),
          loaded(script, &compressor, budget, whole_states),
          compiler(loaded.semantics) {
        compressor.set_compiler(compiler);
    }

    static machine::Bounds bounds_of_parts() {
        machine::Bounds bounds;
        bounds.compressed_states = 20'000;
        bounds.compress_parts = true;
        return bounds;
    }

    std::unique_ptr<SessionSystem> term_system(process::TermId term, Span span) {
        return std::make_unique<SessionSystem>(loaded, term, span);
    }

    std::unique_ptr<lts::TransitionSystem> system(process::TermId term, Span span, diagnostics::Pollable& budget) {
        auto terms_alone = term_system(term, span);
        auto compiled = compiler.compile(term, budget);
        if (!compiled) return terms_alone;
        compiled->set_reference(std::move(terms_alone));
        return compiled;
    }

    std::unique_ptr<lts::TransitionSystem> whole_system(process::TermId term, Span span,
                                                        diagnostics::Pollable& budget) {
        machine::Bounds bounds;
        bounds.component_states *= 10;  // components are larger without minimisation
        bounds.minimised_states = 0;
        bounds.region_states = 0;
        auto compiled = machine::Compiler(loaded.semantics, bounds).compile(term, budget);
        if (compiled) return compiled;
        return term_system(term, span);
    }

    std::unique_ptr<lts::TransitionSystem> compile_side(const ExprPtr& expr, const Decl& assertion,
                                                        diagnostics::Pollable& budget) {
        return system(loaded.term_of(loaded.compile_side(expr, assertion)), expr->span, budget);
    }

    /// Replaces the descriptions in the run by complete ones with all values. Returns the run of terms behind them.
    std::optional<WholeRun> with_values(process::TermId process, std::string& initial, std::vector<refine::Step>& run) {
        std::optional<WholeRun> found =
            whole_run(whole->loaded.semantics, whole->loaded.events, process, initial, run, loaded.events);
        if (!found) return std::nullopt;
        initial = process::describe(whole->loaded.terms, found->initial);
        for (std::size_t i = 0; i < run.size(); ++i)
            run[i].state = process::describe(whole->loaded.terms, found->steps[i].target);
        return found;
    }

    std::optional<process::Behaviour> behaviour_with_values(const Decl& decl, refine::Counterexample& shown,
                                                            const refine::Limits& limits) {
        if (!whole) whole = std::make_unique<Impl>(script, nullptr, true);
        refine::Budget budget(limits);
        const Polling polling(*whole, budget);
        const Assertion& assertion = decl.assertion;
        const bool refinement = assertion.kind == AssertionKind::refinement;
        const process::TermId process = whole->loaded.term_of(
            whole->loaded.compile_side(refinement ? assertion.implementation : assertion.specification, decl));
        if (!shown.accepting.empty()) (void)with_values(process, shown.accepting_initial, shown.accepting);
        const std::optional<WholeRun> run = with_values(process, shown.initial, shown.steps);
        if (!run) return std::nullopt;
        process::Behaviour result = process::behaviour(whole->loaded.semantics, run->initial, run->steps);
        translate(result, [&](process::Event event) { return loaded.events.intern(whole->loaded.events.name(event)); });
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
            case Model::refusals:
            case Model::refusals_divergences:
            case Model::revivals:
            case Model::revivals_divergences:
                break;
        }
        throw EvaluationError("the models R, RD, V and VD are not supported", assertion.span, {});
    }

    /// While the object exists, evaluations of definitions poll the limits of the check that needs them.
    class Polling {
    public:
        Polling(Impl& impl, refine::Budget& budget)
            : impl_(impl), evaluation_budget_(budget), semantics_budget_(impl.loaded.semantics, budget) {
            impl_.loaded.evaluator.set_budget(evaluation_budget_);
            impl_.loaded.semantics.set_budget(semantics_budget_);
        }
        Polling(const Polling&) = delete;
        Polling& operator=(const Polling&) = delete;
        ~Polling() {
            impl_.loaded.evaluator.set_budget(diagnostics::unlimited);
            impl_.loaded.semantics.set_budget(diagnostics::unlimited);
        }

    private:
        Impl& impl_;
        EvaluationBudget evaluation_budget_;
        SemanticsBudget semantics_budget_;
    };

    void tell_stage(refine::Progress& progress) const {
        const machine::Compiler::Stage& stage = compiler.current_stage();
        if (stage.component) progress.part = truncate_description(process::describe(loaded.terms, *stage.component));
        progress.component = stage.number;
        progress.components = stage.of;
        progress.states = stage.states;
    }

    std::vector<process::Event> trace(const Decl& assertion) {
        const LoadedScript::Ready events = loaded.compile_expression(assertion.assertion.implementation, &assertion);
        return loaded.evaluator.trace(*events.code, *events.unit);
    }

    struct Sides {
        /// `second` is null unless the assertion is a refinement.
        std::unique_ptr<lts::TransitionSystem> first, second;
    };

    Sides compile_sides(const Decl& assertion, const refine::Limits& limits) {
        refine::Budget budget(limits, refine::Progress::Phase::compiling);
        budget.report_by([this](refine::Progress& progress) { tell_stage(progress); });
        const Polling polling(*this, budget);
        CompilationBudget compilation_budget(compiler, budget);
        Sides result;
        result.first = compile_side(assertion.assertion.specification, assertion, compilation_budget);
        if (assertion.assertion.kind == AssertionKind::refinement)
            result.second = compile_side(assertion.assertion.implementation, assertion, compilation_budget);
        return result;
    }

    /// Returns text about the component that was compiled when a limit stopped the compilation.
    std::string stage_reached() const {
        const machine::Compiler::Stage& stage = compiler.current_stage();
        if (!stage.component) return "";
        std::string text = fmt::format("; {} states of {}", stage.states,
                                       truncate_description(process::describe(loaded.terms, *stage.component)));
        if (stage.of > 0) text += fmt::format(", component {} of {}", stage.number, stage.of);
        return text;
    }

    /// Decides an assertion. Notifies a strategy by levels before the evaluation of the assertion and after it.
    refine::Verdict decide(const Decl& assertion, const refine::Limits& limits, AssertionResult& result) {
        refine::LevelStrategy* const strategy = limits.by_levels;
        if (strategy == nullptr) return decide_begun(assertion, limits, result);
        strategy->begin_question(assertion_text(assertion));
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
        (void)model(assertion);
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t work = std::clock();
        Sides both = compile_sides(assertion, limits);
        result.compile_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        result.compile_cpu_seconds = static_cast<double>(std::clock() - work) / CLOCKS_PER_SEC;
        refine::Limits quiet = limits;
        quiet.progress = {};
        refine::Budget evaluation(quiet);
        const Polling polling(*this, evaluation);
        return decide_packing(both, assertion, limits,
                              [&] { return decide_once(both, assertion, limits, evaluation); });
    }

    [[nodiscard]] static AssertionResult begin_result(const Decl& assertion) {
        AssertionResult result;
        result.text = assertion_text(assertion);
        result.span = assertion.span;
        result.negated = assertion.assertion.negated;
        return result;
    }

    /// Stores the result of `verdict`. If `verdict` reaches a limit, the stored verdict is inconclusive.
    void decide_result(const Decl& assertion, AssertionResult& result,
                       const std::function<refine::Verdict()>& verdict) {
        try {
            result.verdict = loaded.evaluated_at(assertion.span, verdict);
        } catch (const process::Interrupted& stopped) {
            result.verdict = {};
            result.verdict.reason = stopped.what() + stage_reached();
        } catch (const std::bad_alloc&) {
            result.verdict = {};
            result.verdict.reason = "there is no more memory";
        }
        if (result.negated) negate(result.verdict);
    }

    refine::Verdict decide_with_terms(const Decl& assertion, const refine::Limits& limits) {
        refine::Budget evaluation(limits);
        const Polling polling(*this, evaluation);
        const auto side = [&](const ExprPtr& expr) {
            return term_system(loaded.term_of(loaded.compile_side(expr, assertion)), expr->span);
        };
        Sides both{side(assertion.assertion.specification), nullptr};
        if (assertion.assertion.kind == AssertionKind::refinement)
            both.second = side(assertion.assertion.implementation);
        return ask_of(both, assertion, model(assertion), limits, nullptr);
    }

    /// Decides the assertion for these systems without changing the representation of their states.
    refine::Verdict decide_once(const Sides& both, const Decl& assertion, const refine::Limits& limits,
                                refine::Budget& evaluation) {
        const refine::Model in = model(assertion);
        const auto ask = [&](refine::Earlier earlier) { return ask_in_turns(both, assertion, in, limits, earlier); };
        if (limits.by_levels != nullptr) return decide_by_levels(both, assertion, limits, evaluation, ask);
        if (memory.cache == nullptr || assertion.assertion.kind == AssertionKind::has_trace) return ask(nullptr);
        const Question question = question_of(both, assertion, limits);
        const auto key = key_of(question, evaluation, longest_look);
        return key ? check_with_memory(question, *key, memory, ask) : ask(nullptr);
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

    /// Decides the assertion by a search by levels. This search may continue one that an earlier run could not finish.
    /// Its answers are stored separately from those of other searches, because its statistics differ when it finds a
    /// violation.
    refine::Verdict decide_by_levels(const Sides& both, const Decl& assertion, const refine::Limits& limits,
                                     refine::Budget& evaluation,
                                     const std::function<refine::Verdict(refine::Earlier)>& ask) {
        refine::LevelStrategy& strategy = *limits.by_levels;
        Question question = question_of(both, assertion, limits);
        question.max_states = 0;
        const PackedSystem* const process = packed_side(both.second ? both.second : both.first);
        std::optional<QuestionKey> key;
        if (question.kind != AssertionKind::has_trace) {
            if (process != nullptr && all_events)
                key = key_of_packed(question, script, assertion, *all_events);
            else
                key = key_of(question, evaluation, std::nullopt);
        }
        strategy.identify_question(key ? std::optional(key->digest) : std::nullopt);
        const Memory earlier{strategy.answers(), 0};
        if (!key || earlier.cache == nullptr) return ask(nullptr);
        if (process == nullptr) return check_with_memory(question, *key, earlier, ask);
        return answer_of_width(question, *key, earlier, ask);
    }

    static PackedSystem* packed_side(const std::unique_ptr<lts::TransitionSystem>& side) {
        return dynamic_cast<PackedSystem*>(side.get());
    }
    static SessionSystem* terms_side(const std::unique_ptr<lts::TransitionSystem>& side) {
        return dynamic_cast<SessionSystem*>(side.get());
    }

    /// Decides the assertion. If a search with terms creates many of them, restarts the check with packed states. If a
    /// packed state does not fit into a row, restarts it with wider rows. If a state cannot be packed, restarts it with
    /// terms.
    refine::Verdict decide_packing(Sides& both, const Decl& assertion, const refine::Limits& limits,
                                   const std::function<refine::Verdict()>& attempt) {
        enum class Before { nothing, pack, widen, unpack };
        Before before = Before::nothing;
        all_events.reset();
        const bool terms = terms_side(both.first) != nullptr || terms_side(both.second) != nullptr;
        if (terms && !observed) {
            count_terms(both, most_terms(true));
            if (limits.by_levels != nullptr) before = Before::pack;
        }
        for (;;) {
            try {
                if (before == Before::pack) pack_sides(both, assertion, limits);
                if (before == Before::widen) widen_sides(both);
                if (before == Before::unpack) unpack_sides(both);
                return attempt();
            } catch (const ManyTerms&) {
                before = Before::pack;
            } catch (const RowsTooNarrow&) {
                before = Before::widen;
            } catch (const NotPacked&) {
                before = Before::unpack;
            }
        }
    }

    /// Returns the number of terms after which the search switches to packed states. Switching loads the script again,
    /// so this number is large enough that loading takes only a small part of the time.
    [[nodiscard]] std::size_t most_terms(bool direct) const {
        constexpr std::size_t few = 5'000, many = 1'000'000;
        if (packing.from_terms) return *packing.from_terms;
        return std::max(direct ? few : many, loaded.program.codes.size() / 4);
    }

    void count_terms(Sides& both, std::size_t most) {
        for (auto* const side : {&both.first, &both.second})
            if (SessionSystem* const terms = terms_side(*side)) terms->limit_terms(terms_made, most);
    }

    /// Replaces terms by packed states in each process that is not compiled. The system of terms becomes the reference
    /// that replays counterexamples.
    void pack_sides(Sides& both, const Decl& decl, const refine::Limits& limits) {
        const Assertion& assertion = decl.assertion;
        // Event numbers must be the same in every run. A search would number events in the order in which it finds
        // them, so all events are numbered before it starts.
        if (limits.by_levels != nullptr) all_events = events_of_script();
        const std::shared_ptr<PackedProcesses> processes = processes_for(limits);
        std::vector<std::pair<std::unique_ptr<lts::TransitionSystem>*, std::size_t>> sides;
        if (terms_side(both.first) != nullptr)
            sides.emplace_back(&both.first, processes->add(assertion.specification, decl));
        if (terms_side(both.second) != nullptr)
            sides.emplace_back(&both.second, processes->add(assertion.implementation, decl));
        const auto is_direct = [&](const auto& side) { return processes->is_direct(side.second); };
        const bool few = !packing.from_terms && limits.by_levels == nullptr && terms_made < most_terms(false);
        if (few && !std::ranges::all_of(sides, is_direct)) return count_terms(both, most_terms(false));
        for (const auto& [place, number] : sides) {
            SessionSystem& terms = *terms_side(*place);
            terms.count_no_more();
            auto packed = std::make_unique<PackedSystem>(processes, number, terms.span());
            packed->set_reference(std::move(*place));
            *place = std::move(packed);
        }
        if (all_events) processes->fix_parts();
    }

    /// Returns the packed processes for a check. Checks share them, so that evaluated data are used again. Only a
    /// search by levels gets new ones, because its rows must be the same in every run.
    std::shared_ptr<PackedProcesses> processes_for(const refine::Limits& limits) {
        PackedProcesses::Settings settings;
        settings.whole_states = whole_states;
        settings.most_kept = packing.most_kept.value_or(most_kept_in(limits.memory_bytes));
        settings.terms_alone = packing.terms_alone;
        settings.forget_each_state = packing.most_kept == 0U;
        if (packed_processes == nullptr || limits.by_levels != nullptr)
            packed_processes = std::make_shared<PackedProcesses>(script, loaded.events, settings);
        return packed_processes;
    }

    static void widen_sides(const Sides& both) {
        for (const auto* const side : {&both.first, &both.second})
            if (PackedSystem* const packed = packed_side(*side)) packed->widen_rows();
    }

    void unpack_sides(Sides& both) {
        for (auto* const side : {&both.first, &both.second}) {
            if (SessionSystem* const terms = terms_side(*side)) terms->count_no_more();
            if (packed_side(*side) == nullptr) continue;
            const auto& terms = dynamic_cast<const SessionSystem&>(*(*side)->reference());
            *side = term_system(terms.term(), terms.span());
        }
    }

    /// Returns all events of the script, or no value if they cannot be listed or are too many.
    std::optional<process::EventSet> events_of_script() {
        constexpr std::uint64_t most = 200'000;
        try {
            return loaded.evaluator.all_events(most);
        } catch (const EvaluationError&) {
            return std::nullopt;
        }
    }

    /// Limits how many values and terms are stored, so that they use only a small part of the memory. Each of them
    /// takes a few hundred bytes.
    static std::size_t most_kept_in(std::uint64_t memory_bytes) {
        constexpr std::uint64_t fewest = 20'000, most = 400'000;
        return static_cast<std::size_t>(std::clamp(memory_bytes / 2048, fewest, most));
    }

    /// Decides the assertion in up to three stages (docs/search.md, "Compressed parts"). First searches a limited
    /// number of states. Without an answer, searches with compressed parts, which preserve T, F and FD. Uses only the
    /// answer `holds` of this search: a violation needs a run of the whole process. Finally searches all states.
    refine::Verdict ask_in_turns(const Sides& both, const Decl& assertion, refine::Model in,
                                 const refine::Limits& limits, refine::Earlier earlier) {
        const bool known = earlier != nullptr && *earlier;
        if (known || !limits.reduction || limits.by_levels != nullptr || limits.max_states <= first_states ||
            assertion.assertion.kind == AssertionKind::has_trace)
            return ask_of(both, assertion, in, limits, earlier);
        refine::Limits first = limits;
        first.max_states = first_states;
        first.first_of_two = true;
        refine::Verdict verdict = ask_of(both, assertion, in, first, earlier);
        if (verdict.outcome != refine::Outcome::inconclusive) return verdict;
        if (auto found = ask_of_parts(assertion, in, first)) {
            found->statistics.seconds += verdict.statistics.seconds;
            if (earlier != nullptr) *earlier = refine::Findings{found->statistics, std::nullopt};
            return *found;
        }
        return ask_of(both, assertion, in, limits, earlier);
    }

    /// Decides the assertion with compressed parts. Returns no value if the assertion does not hold, a limit is
    /// reached, or the compression is too weak.
    std::optional<refine::Verdict> ask_of_parts(const Decl& assertion, refine::Model in, refine::Limits limits) {
        constexpr double least_shrinkage = 16;
        limits.progress = {};
        refine::Budget budget(limits);
        machine::Compiler parts(loaded.semantics, bounds_of_parts());
        parts.add_components_of(compiler);
        CompilationBudget compilation_budget(parts, budget);
        const ExprPtr& first = assertion.assertion.specification;
        const ExprPtr& second = assertion.assertion.implementation;
        const auto term_of = [&](const ExprPtr& expr) -> std::optional<process::TermId> {
            if (!expr) return std::nullopt;
            return loaded.term_of(loaded.compile_side(expr, assertion));
        };
        const auto side = [&](const ExprPtr& expr,
                              std::optional<process::TermId> term) -> std::unique_ptr<lts::TransitionSystem> {
            if (!term) return nullptr;
            if (auto compiled = parts.compile(*term, compilation_budget)) return compiled;
            return system(*term, expr->span, compilation_budget);
        };
        try {
            const std::array terms{term_of(first), term_of(second)};
            for (const auto& term : terms)
                if (term) parts.compress_parts(*term, compilation_budget);
            if (parts.shrinkage() < least_shrinkage) return std::nullopt;
            const Sides both{side(first, terms[0]), side(second, terms[1])};
            refine::Limits few = limits;
            few.max_states = first_states / 4;  // the parts are much smaller than the process
            refine::Verdict verdict = ask_of(both, assertion, in, few, nullptr);
            if (verdict.outcome != refine::Outcome::holds) return std::nullopt;
            verdict.statistics.decided_by = refine::DecidedBy::compressed_parts;
            verdict.statistics.seconds = budget.seconds();
            return verdict;
        } catch (const process::Interrupted&) {
            return std::nullopt;  // a limit of the whole check will also stop the next search
        }
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
            case AssertionKind::has_trace:
                return refine::has_trace(first, trace(assertion), in, limits);
        }
        throw EvaluationError("an assertion of no kind", assertion.span, {});
    }

    Script script;
    bool whole_states;
    /// True if calls are observed. Each call must be reported once, so nothing may be evaluated again.
    bool observed = false;
    Packing packing;
    std::size_t terms_made = 0;                         ///< number of terms made by searches
    std::shared_ptr<PackedProcesses> packed_processes;  ///< null until a process is packed
    std::optional<process::EventSet> all_events;        ///< has a value if rows must be the same in every run
    machine::MachineCompressor compressor;
    LoadedScript loaded;
    machine::Compiler compiler;
    Memory memory;
    std::unique_ptr<Impl> whole;  ///< the same script with all arguments, to display runs; null until needed
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

void Session::set_observer(CallObserver observer) {
    impl_->observed = true;
    impl_->loaded.evaluator.set_observer(std::move(observer));
}

void Session::set_packing(const Packing& packing) {
    impl_->packing = packing;
    impl_->packed_processes.reset();
}

void Session::set_cache(diagnostics::Cache& cache, std::uint64_t fewest_states) {
    impl_->memory = {&cache, fewest_states};
}

AssertionResult Session::check(const Decl& assertion, const refine::Limits& limits) {
    AssertionResult result = impl_->begin_result(assertion);
    refine::Limits own = limits;
    symbolic::DiagramStage stage;
    if (own.symbolic == nullptr) own.symbolic = &stage;
    impl_->decide_result(assertion, result, [&] { return impl_->decide(assertion, own, result); });
    return result;
}

AssertionResult Session::check_with_terms(const Decl& assertion, const refine::Limits& limits) {
    refine::Limits plain = limits;
    plain.by_levels = nullptr;
    AssertionResult result = impl_->begin_result(assertion);
    impl_->decide_result(assertion, result, [&] { return impl_->decide_with_terms(assertion, plain); });
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
        return process::behaviour(impl_->loaded.semantics, counterexample.terms.front(), run, offers);
    } catch (const EvaluationError&) {
        // To explain the run, terms inside a compression may be evaluated for the first time. If this fails, the
        // verdict is reported without an explanation.
    } catch (const process::SemanticsError&) {
    }
    return std::nullopt;
}

std::vector<process::Transition> Session::transitions(process::TermId term) {
    return impl_->loaded.evaluated_at({}, [&] {
        const auto found = impl_->loaded.semantics.successors(term);
        return std::vector<process::Transition>(found.begin(), found.end());
    });
}

std::vector<process::Move> Session::split_transition(process::TermId term, const process::Transition& step) {
    return impl_->loaded.evaluated_at({},
                                      [&] { return process::split_transition(impl_->loaded.semantics, term, step); });
}

process::TermId Session::process(const ExprPtr& expr) {
    const LoadedScript::Ready ready = impl_->loaded.compile_expression(expr);
    return impl_->loaded.evaluated_at(expr->span,
                                      [&] { return impl_->loaded.evaluator.process(*ready.code, *ready.unit); });
}

process::TermId Session::process(const ExprPtr& expr, const refine::Limits& limits) {
    refine::Budget budget(limits, refine::Progress::Phase::compiling);
    const Impl::Polling polling(*impl_, budget);
    return process(expr);
}

std::unique_ptr<lts::TransitionSystem> Session::system(const ExprPtr& expr) {
    return impl_->loaded.evaluated_at(expr->span,
                                      [&] { return impl_->system(process(expr), expr->span, diagnostics::unlimited); });
}

std::unique_ptr<lts::TransitionSystem> Session::system(const ExprPtr& expr, const refine::Limits& limits) {
    refine::Budget budget(limits, refine::Progress::Phase::compiling);
    budget.report_by([this](refine::Progress& progress) { impl_->tell_stage(progress); });
    const Impl::Polling polling(*impl_, budget);
    CompilationBudget compilation_budget(impl_->compiler, budget);
    return impl_->loaded.evaluated_at(expr->span,
                                      [&] { return impl_->system(process(expr), expr->span, compilation_budget); });
}

std::unique_ptr<lts::TransitionSystem> Session::whole_system(const ExprPtr& expr, const refine::Limits& limits) {
    refine::Budget budget(limits, refine::Progress::Phase::compiling);
    const Impl::Polling polling(*impl_, budget);
    return impl_->loaded.evaluated_at(expr->span,
                                      [&] { return impl_->whole_system(process(expr), expr->span, budget); });
}

std::unique_ptr<lts::TransitionSystem> Session::whole_system(process::TermId term, Span span,
                                                             const refine::Limits& limits) {
    refine::Budget budget(limits, refine::Progress::Phase::compiling);
    const Impl::Polling polling(*impl_, budget);
    return impl_->loaded.evaluated_at(span, [&] { return impl_->whole_system(term, span, budget); });
}

process::TermId Session::side(const ExprPtr& expr, const Decl& assertion, const refine::Limits& limits) {
    refine::Budget budget(limits, refine::Progress::Phase::compiling);
    const Impl::Polling polling(*impl_, budget);
    LoadedScript& loaded = impl_->loaded;
    return loaded.evaluated_at(expr->span, [&] { return loaded.term_of(loaded.compile_side(expr, assertion)); });
}

std::vector<process::Event> Session::trace(const Decl& assertion) {
    return impl_->loaded.evaluated_at(assertion.span, [&] { return impl_->trace(assertion); });
}

process::EventSet Session::events(const ExprPtr& expr) {
    const LoadedScript::Ready ready = impl_->loaded.compile_expression(expr);
    return impl_->loaded.evaluator.event_set(*ready.code, *ready.unit);
}

std::optional<process::Behaviour> Session::behaviour_with_values(const Decl& assertion,
                                                                 refine::Counterexample& counterexample,
                                                                 const refine::Limits& limits) {
    const auto lacks = [](const std::vector<refine::Step>& run) {
        return std::ranges::any_of(run, [](const refine::Step& step) { return leaves_values_out(step.state); });
    };
    const bool values =
        leaves_values_out(counterexample.initial) || lacks(counterexample.steps) || lacks(counterexample.accepting);
    // Each round of a loop may have different omitted values, even if its states are equal. So no values are added.
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
    const LoadedScript::Ready ready = impl_->loaded.compile_expression(expr);
    return impl_->loaded.evaluator.print(*ready.code, *ready.unit);
}

std::optional<EvaluationError> Session::take_stopped_evaluation() {
    return impl_->loaded.evaluator.take_stopped();
}

process::EventTable& Session::event_table() {
    return impl_->loaded.events;
}
process::TermStore& Session::terms() {
    return impl_->loaded.terms;
}

}  // namespace robochart::cspm
