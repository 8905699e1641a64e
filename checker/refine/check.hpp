// The questions: refinement in traces, failures, failures-divergences; deadlock, divergence, determinism,
// traces; and their answers. Roscoe, Understanding Concurrent Systems (2010), chapters 10, 11, 16; FDR manual.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "checker/lts/transition_system.hpp"
#include "diagnostics/budget.hpp"

namespace robochart::refine {

enum class Model { traces, failures, failures_divergences };

/// How far a check has come, for those who wait.
struct Progress {
    enum class Phase { compiling, searching };
    Phase phase = Phase::searching;
    std::string part;                             ///< compiling: the component at work
    std::uint64_t component = 0, components = 0;  ///< compiling: its number, and of how many; 0 if not known
    std::uint64_t states = 0;                     ///< known so far
    std::uint64_t transitions = 0;
    std::uint64_t frontier = 0;  ///< searching: states that wait to be expanded
    std::uint64_t depth = 0;
    std::uint64_t resident_bytes = 0;  ///< of the whole program
    std::uint64_t grown_bytes = 0;     ///< of these, since the phase began
    double seconds = 0;                ///< since the phase began
};

/// Bounds of one check: those of the run, and its own. A bound reached gives Outcome::inconclusive, never a wrong answer.
struct Limits : diagnostics::Limits {
    std::uint64_t max_states = 500'000'000;
    unsigned threads = 0;  ///< at most so many, where a space is wide; 0: one a core. Verdicts do not depend on it
    std::size_t wide_level =
        2048;  ///< levels of fewer states are done by one thread, as it is sooner done than others woken
    /// Told a few times a second, by the thread that called the check.
    std::function<void(const Progress&)> progress;
};

struct Statistics {
    std::uint64_t states = 0;  ///< pairs (specification node, implementation state) or states visited
    std::uint64_t transitions = 0;
    std::uint64_t depth = 0;       ///< breadth-first level of the last state
    std::uint64_t spec_nodes = 0;  ///< normalised specification nodes made
    double seconds = 0;
};

enum class Outcome { holds, fails, inconclusive };

/// One step of the implementation's run.
struct Step {
    process::Event event = process::tau;
    process::Event revealed = process::tau;  ///< the hidden event behind a tau, if known
    std::string state;                       ///< describe() of the state reached
};

enum class ViolationKind {
    trace,           ///< the last step's event is not allowed by the specification
    refusal,         ///< the reached stable state offers too little
    divergence,      ///< the reached state can do taus for ever (loop), where the specification may not
    deadlock,        ///< nothing is possible in the reached state
    nondeterminism,  ///< after the trace, `event` may be both accepted and refused
    no_trace,        ///< has trace: the process cannot perform it; steps hold the longest possible prefix
};

struct Counterexample {
    ViolationKind kind = ViolationKind::trace;
    std::vector<Step> steps;              ///< shortest run of the implementation, taus included
    std::string initial;                  ///< describe() of the initial state
    std::vector<process::Event> offered;  ///< refusal, deadlock: what the last state offers
    std::vector<process::EventSet>
        required;  ///< refusal: the specification's minimal acceptances; trace: one set, the events it allowed
    std::vector<Step> loop;               ///< divergence: the tau loop
    std::optional<process::Event> event;  ///< nondeterminism: the event; trace: the offending one
    /// The initial state and those after the steps, then those of the loop; empty where states are not terms.
    std::vector<process::TermId> terms, loop_terms;
    /// Whether the run was replayed by the operational semantics of terms; else by the compiled rules alone, because
    /// the terms were too many or there are none.
    bool replayed_by_terms = false;
};

struct Verdict {
    Outcome outcome = Outcome::inconclusive;
    std::string reason;                            ///< inconclusive: which limit, or the evaluation error
    std::optional<Counterexample> counterexample;  ///< present iff fails (for has trace: iff the trace is impossible)
    Statistics statistics;
};

/// specification [M= implementation. The two share one EventTable.
[[nodiscard]] Verdict refines(lts::TransitionSystem& specification, lts::TransitionSystem& implementation, Model,
                              const Limits&);
/// :[deadlock free [M]]. M is failures (divergence ignored) or failures_divergences (a divergence fails it).
/// A terminated process counts as deadlocked, as FDR has it.
[[nodiscard]] Verdict deadlock_free(lts::TransitionSystem&, Model, const Limits&);
[[nodiscard]] Verdict divergence_free(lts::TransitionSystem&, const Limits&);
[[nodiscard]] Verdict deterministic(lts::TransitionSystem&, Model, const Limits&);
/// :[has trace [M]]: the process can perform these visible events in order. In the other models than T inconclusive
/// where it could also refuse one of them, or in FD diverge, since what they ask then is laid down nowhere.
[[nodiscard]] Verdict has_trace(lts::TransitionSystem&, const std::vector<process::Event>& trace, Model, const Limits&);

}  // namespace robochart::refine
