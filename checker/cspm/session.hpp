// A script made ready: evaluates expressions, builds processes, decides assertions.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "checker/cspm/eval/evaluation_error.hpp"
#include "checker/cspm/syntax/observed_call.hpp"
#include "checker/cspm/syntax/syntax.hpp"
#include "checker/lts/transition_system.hpp"
#include "checker/process/behaviour.hpp"
#include "checker/process/term.hpp"
#include "checker/refine/verdict/check.hpp"
#include "diagnostics/cache/cache.hpp"
#include "diagnostics/diagnostic.hpp"

namespace robochart::cspm {

/// An assertion of a script and its verdict.
struct AssertionResult {
    std::string text;  ///< the assertion as printed
    Span span;
    bool negated = false;
    refine::Verdict verdict;         ///< already turned round for `not`: holds means the assertion as worded holds
    double compile_seconds = 0;      ///< evaluating and compiling, before the search
    double compile_cpu_seconds = 0;  ///< processor time of that, of all threads
};

/// One loaded script with its events, terms and definitions. Not thread-safe.
class Session {
public:
    /// The budget is polled while the script is made ready: instances of modules copy what they are made of.
    /// `whole_states`: processes keep also those arguments that nothing reads, for whoever asks a state for them.
    explicit Session(Script script, diagnostics::Budget* budget = nullptr, bool whole_states = false);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    [[nodiscard]] const Script& script() const;
    /// Places of the assertions in the script, in order (inside modules and timed sections too).
    [[nodiscard]] std::vector<DeclPtr> assertions() const;
    /// Decides one assertion. Evaluation errors are thrown; limits give inconclusive.
    [[nodiscard]] AssertionResult check(const Decl& assertion, const refine::Limits&);

    /// Takes answers of earlier runs from this cache, and keeps those of this one there whose search had so many
    /// states; a smaller search is done again sooner than it is looked up. The cache has to outlive the session.
    void remember(diagnostics::Cache& cache, std::uint64_t fewest_states = 1000);

    /// Reports calls of these functions while processes are evaluated. Each state's calls are reported once, whichever
    /// assertion asks first; so it is to be set before the first check.
    void observe(CallObserver observer);

    /// The run of a counterexample taken apart down to the components; the loop of a divergence follows the trace. None
    /// where its states are not terms. Without `offers` no state behind the run's is looked into.
    [[nodiscard]] std::optional<process::Behaviour> behaviour(const refine::Counterexample&, bool offers = true);
    /// The same within limits; none where one is reached.
    [[nodiscard]] std::optional<process::Behaviour> behaviour(const refine::Counterexample&, const refine::Limits&);
    /// The same for people: the descriptions in the counterexample get the values of arguments that nothing reads,
    /// which the terms of states do not have. The terms of this behaviour are not the session's.
    [[nodiscard]] std::optional<process::Behaviour> behaviour_with_values(const Decl& assertion,
                                                                          refine::Counterexample&,
                                                                          const refine::Limits&);
    /// What a term can do. Throws EvaluationError or process::SemanticsError where its definitions cannot be evaluated.
    [[nodiscard]] std::vector<process::Transition> transitions(process::TermId term);
    /// One of these taken apart: what each component does in it.
    [[nodiscard]] std::vector<process::Move> moves(process::TermId term, const process::Transition& step);

    /// An expression in the script's global scope as a process.
    [[nodiscard]] process::TermId process(const ExprPtr&);
    /// The same as a transition system that shares this session's events; valid while the session lives.
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> system(const ExprPtr&);
    /// The same within limits; throws process::Interrupted where one is reached while compiling.
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> system(const ExprPtr&, const refine::Limits&);
    /// The same, with every component as it is: none is replaced by a smaller one that behaves like it, so that a state
    /// tells where each component is, and hidden events keep their names.
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> whole_system(const ExprPtr&, const refine::Limits&);
    /// An expression that denotes an event or a set of events.
    [[nodiscard]] process::EventSet events(const ExprPtr&);
    /// An expression of any other type, printed as FDR's `print` does.
    [[nodiscard]] std::string evaluate(const ExprPtr&);
    /// The same within limits; throws process::Interrupted where one is reached.
    [[nodiscard]] std::string evaluate(const ExprPtr&, const refine::Limits&);

    [[nodiscard]] process::EventTable& event_table();
    [[nodiscard]] process::TermStore& terms();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace robochart::cspm
