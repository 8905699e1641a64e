// Answers: whether an assertion holds, and the run that shows that it does not.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "checker/lts/transition_system.hpp"
#include "checker/process/term.hpp"
#include "checker/refine/search/limits.hpp"
#include "checker/refine/search/violation.hpp"

namespace robochart::refine {

/// The models of CSP in which processes are compared (UCS 10 to 12).
enum class Model { traces, failures, failures_divergences };

/// The answer to an assertion.
enum class Outcome { holds, fails, inconclusive };

/// One step of the implementation's run.
struct Step {
    process::Event event = process::tau;
    process::Event revealed = process::tau;  ///< the hidden event behind a tau, if known
    std::string state;                       ///< describe() of the state reached
};

/// A run that violates an assertion, and what is wrong with it.
struct Counterexample {
    ViolationKind kind = ViolationKind::trace;
    std::vector<Step> steps;  ///< run of the implementation, taus included
    std::string initial;      ///< describe() of the initial state
    /// Refusal, deadlock, nondeterminism: the least that the last state accepts, ✓ alone where it can terminate.
    std::vector<process::Event> offered;
    /// Refusal: the specification's minimal acceptances, none where it has no stable state; trace: one set, the events
    /// that it allowed.
    std::vector<process::EventSet> required;
    std::vector<Step> loop;               ///< divergence: the tau loop
    std::optional<process::Event> event;  ///< nondeterminism: the event; trace: the offending one
    /// Nondeterminism: another run with the same events, and the event that this one refuses as its last step. Empty
    /// where a limit ended the search for it.
    std::vector<Step> accepting;
    std::string accepting_initial;  ///< describe() of its initial state
    /// The initial state and those after the steps, then those of the loop, and of the accepting run; empty where
    /// states are not terms.
    std::vector<process::TermId> terms, loop_terms, accepting_terms;
    /// Whether the run was replayed by the operational semantics of terms; else by the compiled rules alone, because
    /// the terms were too many or there are none.
    bool replayed_by_terms = false;
    /// Whether there is no shorter one. Else a limit has ended the search for it (docs/search.md, "Confluent taus").
    bool shortest = true;
};

/// The answer to an assertion, with its counterexample and the size of the search.
struct Verdict {
    Outcome outcome = Outcome::inconclusive;
    std::string reason;                            ///< inconclusive: which limit, or the evaluation error
    std::optional<Counterexample> counterexample;  ///< present iff fails (for has trace: iff the trace is impossible)
    Statistics statistics;
    bool known = false;  ///< an earlier search of the same systems gave the answer; the statistics are its
};

}  // namespace robochart::refine
