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
    refine::Verdict verdict;         ///< already negated for `not`: `holds` refers to the assertion as written
    double compile_seconds = 0;      ///< time for evaluation and compilation before the search
    double compile_cpu_seconds = 0;  ///< processor time of all threads for evaluation and compilation
};

/// Determines when the search represents processes that are not compiled by packed states instead of terms
/// (docs/search.md). Answers do not depend on these settings.
struct Packing {
    /// The number of terms after which a search switches to packed states. The default is 5,000 (more for long scripts)
    /// if steps can be computed without terms (packed/direct_steps.hpp), and 1,000,000 otherwise.
    std::optional<std::size_t> from_terms;
    std::optional<std::size_t>
        most_kept;             ///< maximal number of values and terms; 0: as for one state; none: by memory limit
    bool terms_alone = false;  ///< whether all steps are computed with terms
};

/// One loaded script with its events, terms and definitions. Not thread-safe.
class Session {
public:
    /// Compiles the script and polls the budget meanwhile, because instances copy their modules and may make the script
    /// long. With `whole_states`, calls in terms also contain the arguments that the called process never reads. A
    /// caller that displays states may need them.
    explicit Session(Script script, diagnostics::Budget* budget = nullptr, bool whole_states = false);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    [[nodiscard]] const Script& script() const;
    /// Returns the assertions of the script in order, including those inside modules and timed sections.
    [[nodiscard]] std::vector<DeclPtr> assertions() const;
    /// Decides one assertion. Throws evaluation errors. If a limit is reached, the verdict is inconclusive.
    [[nodiscard]] AssertionResult check(const Decl& assertion, const refine::Limits&);

    /// Decides one assertion without compiling components. Compilation evaluates all states of a component, and fails
    /// if one of these evaluations fails. This function only evaluates states that the search reaches.
    [[nodiscard]] AssertionResult check_with_terms(const Decl& assertion, const refine::Limits&);

    /// Uses answers of earlier runs from this cache. Stores the answers of this run whose searches had at least
    /// `fewest_states` states: a smaller search is faster than a look-up. The cache must outlive the session.
    void set_cache(diagnostics::Cache& cache, std::uint64_t fewest_states = 1000);

    /// Sets when packed states are used. Call it before the first check.
    void set_packing(const Packing& packing);

    /// Reports calls of these functions during the evaluation of processes. Call it before the first check: each state
    /// is evaluated only once, for the first assertion that needs it, so later assertions report no calls for it.
    void set_observer(CallObserver observer);

    /// Splits the run of a counterexample into the runs of its components. The loop of a divergence follows the trace.
    /// Returns no value if the states of the run are not terms. Without `offers`, no state after the run is computed.
    [[nodiscard]] std::optional<process::Behaviour> behaviour(const refine::Counterexample&, bool offers = true);
    /// Splits the run within limits. Returns no value if a limit is reached.
    [[nodiscard]] std::optional<process::Behaviour> behaviour(const refine::Counterexample&, const refine::Limits&);
    /// Splits the run for display. Adds the values of arguments that are never read to the counterexample, because the
    /// terms of its states do not contain these values. The terms of the result belong to another session.
    [[nodiscard]] std::optional<process::Behaviour> behaviour_with_values(const Decl& assertion,
                                                                          refine::Counterexample&,
                                                                          const refine::Limits&);
    /// Returns the transitions of a term. Throws EvaluationError or process::SemanticsError if its definitions cannot
    /// be evaluated.
    [[nodiscard]] std::vector<process::Transition> transitions(process::TermId term);
    /// Splits one of these transitions into the moves of the components.
    [[nodiscard]] std::vector<process::Move> split_transition(process::TermId term, const process::Transition& step);

    /// Returns the process that an expression in the script's global scope denotes.
    [[nodiscard]] process::TermId process(const ExprPtr&);
    /// Returns the process as a transition system. The system shares this session's events and is valid during the
    /// session's lifetime.
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> system(const ExprPtr&);
    /// Returns the transition system and compiles it within limits. Throws process::Interrupted if a limit is reached.
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> system(const ExprPtr&, const refine::Limits&);
    /// Returns the transition system with components that are not minimised. Its states then determine the state of
    /// each component, and hidden events keep their names.
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> whole_system(const ExprPtr&, const refine::Limits&);
    /// Returns the events that an expression denotes, which may be an event or a set of events.
    [[nodiscard]] process::EventSet events(const ExprPtr&);
    /// If a limit has ended a long evaluation since the last call: the place and the calls of this evaluation.
    [[nodiscard]] std::optional<EvaluationError> take_stopped_evaluation();
    /// Evaluates an expression of any other type. Returns its value, printed like FDR's `print`.
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
