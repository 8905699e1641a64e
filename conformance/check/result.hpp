// What is asked of a component and its code, and the answer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "checker/refine/verdict/verdict.hpp"
#include "cpp_emit/plan/options.hpp"
#include "diagnostics/cache/cache.hpp"
#include "diagnostics/diagnostic.hpp"
#include "runs/run.hpp"

namespace robochart::conformance {

/// The answer for one component.
enum class Outcome {
    conforms,
    differs,          ///< the code does something NF_c(M) does not allow
    not_schedulable,  ///< the model cannot be run in cycles: a witness of NF_c(M) alone
    not_generated,    ///< the generator refused the component (diagnostics say why)
    error,            ///< the script of the model cannot be evaluated
    inconclusive,
};

/// One control cycle of a counterexample.
struct Cycle {
    std::vector<std::string> inputs;   ///< registers raised, "seeRobot", "heading = 0.1"
    std::vector<std::string> outputs;  ///< what the code wrote, in order
    std::string state;                 ///< the code's state after it
};

/// What stands behind an outcome, in the words of the model: of one that is the model's its rule, where it shows and
/// what would help; of code that differs how far the model goes with it.
struct Explanation {
    const diagnostics::Rule* rule = nullptr;  ///< docs/rules has its page; null: the outcome is not the model's
    std::vector<std::string> where;           ///< "t2: B -> B (loop.rct:9)"; empty: not known
    std::string remedy;                       ///< what would make the model schedulable; "" : not known
    /// The run of the model that shows it, or differs: that does what the code does up to where they differ. Nothing:
    /// not found in time.
    std::optional<runs::Run> run;
};

/// A property of the model beside conformance: whether it has it, and if not, a shortest run that shows it.
struct Aside {
    bool holds = true;
    std::string reason;  ///< why it does not
    std::vector<Cycle> cycles;
    const diagnostics::Rule* rule = nullptr;  ///< what that means for a robot
    /// The trace of NF_c(M) up to where it shows (as Result::model_run), and the run of the model that has it; nothing:
    /// not found in time.
    std::optional<refine::Counterexample> model_run;
    std::optional<runs::Run> run;
};

/// Why an event is not taken in the cycles that its register holds it.
enum class MissedWhile {
    busy,       ///< an action of the machine that knows it is in progress
    condition,  ///< the machine rests, and no condition of the transitions that await it holds
};

/// An event of the platform that can come in vain (docs/conformance.md, "Events that can be missed").
struct MissedEvent {
    struct Reason {
        MissedWhile why = MissedWhile::busy;
        std::optional<std::uint64_t> cycles;  ///< the most in a row; nothing: without bound
        std::vector<std::string> places;      ///< where the machine is meanwhile
    };
    std::string event;
    std::optional<std::uint64_t> cycles;  ///< the most in a row, for either reason
    std::vector<Reason> reasons;
};

/// An event that a state takes only after what the states inside it take in the same cycle (docs/conformance.md,
/// "Events that come second").
struct OvertakenEvent {
    std::string event;
    std::vector<std::string> by;      ///< the events that come first
    bool due = false;                 ///< transitions without trigger come first, of timeouts and conditions
    std::vector<std::string> places;  ///< where the machine is then
};

/// What one API of the code did.
struct Behaviour {
    std::vector<std::string> outputs;  ///< in order
    std::string ends;                  ///< "at rest", "terminates", ...
    std::string state;                 ///< afterwards
};

/// Where the event API differs from the cycle: after Result::cycles.
struct ApiDifference {
    std::string event;  ///< "heading = 90"; "" : none
    std::string what;   ///< the promise that is not kept
    Behaviour cycle;
    Behaviour dispatched;
};

/// A type of which few values were explored, since the component only passes them on.
struct FewValues {
    std::string type;  ///< as the model writes it
    std::size_t values = 0;
};

/// The answer for one component, with what was explored and, where the code differs, a shortest run.
struct Result {
    Outcome outcome = Outcome::inconclusive;
    std::string reason;
    std::vector<Cycle> cycles;  ///< differs, not_schedulable: shortest input sequence
    std::string expected;       ///< what the model allows where the code differs
    Explanation explanation;    ///< differs, not_schedulable
    /// Behind the explanation: the run of NF_c(M) that shows it, or a trace of NF_c(M), the code's up to where it
    /// differs (kind `no_trace`); to be found again where more is known of the model.
    std::optional<refine::Counterexample> model_run;
    std::uint64_t code_states = 0;      ///< distinct state images of the code
    std::uint64_t code_cycles = 0;      ///< (state, input valuation) pairs stepped
    std::uint64_t model_states = 0;     ///< states of M met under the simulation assumptions
    refine::Statistics product;         ///< of the refinement check
    refine::Statistics schedulability;  ///< of the check of NF_c(M) alone
    /// No cycle makes an output twice: then the strict relation, in which it may not, holds too. Nothing: not decided.
    std::optional<Aside> register_cycles;
    /// No deadline passes while an input is awaited that does not come. Nothing: not decided.
    std::optional<Aside> deadlines;
    std::vector<FewValues> represented;
    std::vector<MissedEvent> missed;        ///< conforms: of all states of the code
    std::vector<OvertakenEvent> overtaken;  ///< the same
    std::uint64_t dispatched = 0;           ///< (state, event or none) pairs in which both APIs were compared
    std::optional<ApiDifference> api_difference;
    std::vector<std::string> raw;       ///< the trace in events of NF_c(M)
    std::string normal_form;            ///< NF_c(M) as CSPM declarations that follow the model's timed script
    std::vector<std::string> warnings;  ///< of the code: states that are not canonical
    std::string exported;               ///< L(G) in the format asked for (Options::exported)
    std::string export_failure;         ///< why there is none, where one was asked for
};

/// What is decided of NF_c(M) and L(G).
enum class Relation {
    failures_divergences,  ///< [FD=
    tick_tock,             ///< [TT=, with what is refused before each tock, and no divergence of the code
};

/// L(G) for other tools: Aldebaran's format, Graphviz's, or a script that repeats NF_c(M) [FD= L(G) in FDR.
enum class Export { none, aut, dot, csp };

/// Guided random walks where the whole is too large (random_walk.hpp).
struct WalkOptions {
    std::uint64_t cycles = 200'000;  ///< of all walks together; 0: none
    double seconds = 20;
    std::uint64_t seed = 1;
};

/// How code is generated, compiled and compared with its model.
struct Options {
    std::uint32_t cycle_length = 1;  ///< c: tocks per cycle
    Relation relation = Relation::failures_divergences;
    WalkOptions walks;
    Export exported = Export::none;
    cpp_emit::Options generator;   ///< seeded faults, for tests
    std::string compiler = "c++";  ///< must accept g++'s options
    std::string flags = "-std=c++17 -O1 -Wall -Wextra -Wpedantic -Wconversion -Werror";
    std::string
        work_dir;  ///< where sources and the shared object are put; "" : a fresh temporary folder, removed after
    diagnostics::Cache* cache = nullptr;  ///< of compiled code; null: none
    refine::Limits limits;
};

}  // namespace robochart::conformance
