// SPDX-License-Identifier: Apache-2.0
// Loads a script, evaluates its expressions, builds its processes, and decides its assertions.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/cache/cache.hpp"
#include "base/diagnostics/diagnostic.hpp"
#include "checker/cspm/eval/evaluation_error.hpp"
#include "checker/cspm/syntax/observed_call.hpp"
#include "checker/cspm/syntax/syntax.hpp"
#include "checker/lts/transition_system.hpp"
#include "checker/process/behaviour.hpp"
#include "checker/process/term.hpp"
#include "checker/refine/verdict/check.hpp"

namespace robochart::cspm {

/// An assertion of a script and its verdict.
struct AssertionResult {
    std::string text;  ///< the assertion as printed
    Span span;
    bool negated = false;
    refine::Verdict verdict;         ///< `holds` refers to the whole assertion, including its `not`
    double compile_seconds = 0;      ///< time to evaluate and compile the processes, before the search
    double compile_cpu_seconds = 0;  ///< the same as processor time of all threads
};

/// Controls when the states of a process that is not compiled are packed instead of stored as terms (docs/search.md).
/// Answers do not depend on these settings.
struct Packing {
    /// The search switches to packed states when it has this many terms. Default: 5,000 (more for long scripts) if
    /// steps can be computed without terms (packed/direct_steps.hpp), and 1,000,000 otherwise.
    std::optional<std::size_t> from_terms;
    std::optional<std::size_t>
        most_kept;             ///< maximal number of values and terms; 0: as for one state; none: by memory limit
    bool terms_alone = false;  ///< whether all steps are computed with terms
};

/// One loaded script with its events, terms and definitions. Not thread-safe.
class Session {
public:
    /// Compiles the script. Polls the budget while it does so, because copies of modules can make the script very long.
    /// With `whole_states`, the terms of calls also contain arguments that the called process never reads. A caller may
    /// need them to display states.
    explicit Session(Script script, diagnostics::Budget* budget = nullptr, bool whole_states = false);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    [[nodiscard]] const Script& script() const;
    /// Returns the assertions of the script in order, including those inside modules and timed sections.
    [[nodiscard]] std::vector<DeclPtr> assertions() const;
    /// Decides one assertion. Throws evaluation errors. If a limit is reached, the verdict is inconclusive.
    [[nodiscard]] AssertionResult check(const Decl& assertion, const refine::Limits&);

    /// Decides one assertion with terms only. Compilation evaluates all states of a component, and fails if one
    /// evaluation fails. This function evaluates only the states that the search reaches.
    [[nodiscard]] AssertionResult check_with_terms(const Decl& assertion, const refine::Limits&);

    /// Uses the answers of earlier runs in this cache. Adds the answers of this run if the search had at least
    /// `fewest_states` states, because a look-up is slower than a smaller search. The cache must outlive the session.
    void set_cache(diagnostics::Cache& cache, std::uint64_t fewest_states = 1000);

    /// Sets when packed states are used. Call it before the first check.
    void set_packing(const Packing& packing);

    /// Reports calls of these functions while processes are evaluated. Call it before the first check: a state is
    /// evaluated only for the first assertion that reaches it. Later assertions do not report its calls.
    void set_observer(CallObserver observer);

    /// Splits the run of a counterexample into the runs of its components. For a divergence, the loop follows the
    /// trace. Returns no value if the states are not terms. Without `offers`, no state after the run is computed.
    [[nodiscard]] std::optional<process::Behaviour> behaviour(const refine::Counterexample&, bool offers = true);
    /// Splits the run within limits. Returns no value if a limit is reached.
    [[nodiscard]] std::optional<process::Behaviour> behaviour(const refine::Counterexample&, const refine::Limits&);
    /// Splits the run for display. States do not contain the values of arguments that are never read; this function
    /// adds these values to the counterexample. The terms of the result belong to another session.
    [[nodiscard]] std::optional<process::Behaviour> behaviour_with_values(const Decl& assertion,
                                                                          refine::Counterexample&,
                                                                          const refine::Limits&);
    /// Returns the transitions of a term. Throws EvaluationError or process::SemanticsError if the evaluation of a
    /// definition fails.
    [[nodiscard]] std::vector<process::Transition> transitions(process::TermId term);
    /// Splits one of these transitions into the moves of the components.
    [[nodiscard]] std::vector<process::Move> split_transition(process::TermId term, const process::Transition& step);

    /// Returns the process that an expression in the script's global scope denotes.
    [[nodiscard]] process::TermId process(const ExprPtr&);
    /// Evaluates the process within limits. Throws process::Interrupted if a limit is reached.
    [[nodiscard]] process::TermId process(const ExprPtr&, const refine::Limits&);
    /// Returns the process as a transition system. The system uses the events of this session, so the session must
    /// outlive it.
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> system(const ExprPtr&);
    /// Returns the transition system and compiles it within limits. Throws process::Interrupted if a limit is reached.
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> system(const ExprPtr&, const refine::Limits&);
    /// Returns the transition system without minimising its components. So each of its states determines the states of
    /// all components, and hidden events keep their names.
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> whole_system(const ExprPtr&, const refine::Limits&);
    /// Does the same for a process that is already a term. Errors have the place `span`.
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> whole_system(process::TermId, Span span,
                                                                      const refine::Limits&);
    /// Returns the term of a process of an assertion. The expression is evaluated in the module or timed section of the
    /// assertion. With `tau priority`, the term prioritises tau over the events of the assertion.
    [[nodiscard]] process::TermId side(const ExprPtr&, const Decl& assertion, const refine::Limits&);
    /// Returns the events of a `has trace` assertion.
    [[nodiscard]] std::vector<process::Event> trace(const Decl& assertion);
    /// Returns the events that an expression denotes, which may be an event or a set of events.
    [[nodiscard]] process::EventSet events(const ExprPtr&);
    /// Returns the place and the calls of a long evaluation if a limit has ended one since the last call.
    [[nodiscard]] std::optional<EvaluationError> take_stopped_evaluation();
    /// Evaluates an expression of another type. Returns the value as FDR's `print` shows it.
    [[nodiscard]] std::string evaluate(const ExprPtr&);
    /// Evaluates the expression within limits. Throws process::Interrupted if a limit is reached.
    [[nodiscard]] std::string evaluate(const ExprPtr&, const refine::Limits&);

    [[nodiscard]] process::EventTable& event_table();
    [[nodiscard]] process::TermStore& terms();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace robochart::cspm
