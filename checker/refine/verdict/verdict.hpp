// SPDX-License-Identifier: Apache-2.0
// Defines the result of an assertion, and the run that violates it.
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

/// One step of a run of the implementation.
struct Step {
    process::Event event = process::tau;
    process::Event revealed = process::tau;  ///< the hidden event of a tau, if known
    std::string state;                       ///< describe() of the state after the step
};

/// A run that violates an assertion, and its fault.
struct Counterexample {
    ViolationKind kind = ViolationKind::trace;
    std::vector<Step> steps;  ///< run of the implementation, which includes taus
    std::string initial;      ///< describe() of the initial state
    /// For refusal, deadlock and nondeterminism: the least acceptance of the last state. If the state can terminate,
    /// this set contains only ✓.
    std::vector<process::Event> offered;
    /// For a refusal: the minimal acceptances of the specification. The list is empty if the specification has no
    /// stable state after the trace. For a forbidden event: one set, which contains the events that the specification
    /// allows.
    std::vector<process::EventSet> required;
    std::vector<Step> loop;               ///< divergence: the loop of taus
    std::optional<process::Event> event;  ///< nondeterminism: the event; trace: the forbidden event
    /// For nondeterminism: another run with the same events, followed by the event that this run refuses. The list is
    /// empty if a limit ended the search for the other run.
    std::vector<Step> accepting;
    std::string accepting_initial;  ///< describe() of its initial state
    /// The terms of the initial state and of the states after the steps, the terms of the loop, and the terms of the
    /// accepting run. These lists are empty if states are not terms.
    std::vector<process::TermId> terms, loop_terms, accepting_terms;
    /// True if the operational semantics of terms has replayed the run. Otherwise only the compiled rules have replayed
    /// the run, because there were too many terms or no terms.
    bool replayed_by_terms = false;
    /// True if the run is known to be a shortest one. False if a limit ended the search for a shorter run
    /// (docs/search.md, "Confluent taus").
    bool shortest = true;
};

/// The result of an assertion, with its counterexample and the size of the search.
struct Verdict {
    Outcome outcome = Outcome::inconclusive;
    /// Inconclusive: the limit that was reached, or the evaluation error.
    std::string reason;
    /// Present iff the assertion fails; for `has trace`, present iff the trace is impossible.
    std::optional<Counterexample> counterexample;
    Statistics statistics;
    bool known = false;  ///< whether answer and statistics are from an earlier search of the same systems
};

}  // namespace robochart::refine
