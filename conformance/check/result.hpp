// SPDX-License-Identifier: Apache-2.0
// Declares the options and the results of the check of a component and its code.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/cache/cache.hpp"
#include "base/diagnostics/diagnostic.hpp"
#include "checker/refine/verdict/verdict.hpp"
#include "counterexample/run.hpp"
#include "cpp_emit/plan/options.hpp"
#include "semantics/data/class_model.hpp"

namespace robochart::certify {
struct Certificate;  // checker/certify/certificate.hpp
}

namespace robochart::conformance {

struct CycleClaims;  // cycle_claims.hpp

/// The outcome of a check.
enum class Outcome {
    conforms,
    differs,          ///< the code has a behaviour that NF_c(M) does not allow
    rounds,           ///< the code conforms for ideal numbers, but behaves differently with the robot's numbers
    not_schedulable,  ///< the model cannot be run in cycles; the witness is a run of NF_c(M) alone
    not_generated,    ///< the generator rejected the component (see the diagnostics)
    error,            ///< the script of the model cannot be evaluated
    inconclusive,
};

/// One control cycle of a counterexample.
struct Cycle {
    std::vector<std::string> inputs;   ///< raised registers: "seeRobot", "heading = 0.1"
    std::vector<std::string> outputs;  ///< outputs of the code, in order
    std::string state;                 ///< state of the code after the cycle
};

/// Explains an outcome with the names and places of the model. If the model causes the outcome, the explanation
/// contains the rule, the place and a remedy. If the code differs, it contains the model's run up to the difference.
struct Explanation {
    const diagnostics::Rule* rule = nullptr;  ///< see its page in docs/rules; null: the model does not cause the
                                              ///< outcome
    std::vector<std::string> where;           ///< "t2: B -> B (loop.rct:9)"; empty if unknown
    std::string remedy;                       ///< a change that would make the model schedulable; "" if unknown
    /// The run of the model that shows the problem. For `differs`, the run that follows the code up to the difference.
    /// There is no value if the run was not found in time.
    std::optional<runs::Run> run;
};

/// The answer to a property of the model that is checked in addition to conformance. If the property fails, the answer
/// contains a shortest run that shows the violation.
struct Aside {
    bool holds = true;
    std::string reason;  ///< why the property fails
    std::vector<Cycle> cycles;
    const diagnostics::Rule* rule = nullptr;
    /// The trace of NF_c(M) up to the violation (as in Result::model_run), and the model's run with this trace. There
    /// is no value if the run was not found in time.
    std::optional<refine::Counterexample> model_run;
    std::optional<runs::Run> run;
};
/// Returns sentences that explain what the violation means for a robot; "" if there is no explanation.
[[nodiscard]] std::string_view meaning_of(const Aside&);

/// Why an event is not taken in cycles in which its register contains it.
enum class MissedWhile {
    busy,       ///< the machine that uses the event is executing an action
    condition,  ///< the machine rests, and all transitions that await the event have false conditions
};

/// An event of the platform that can arrive without effect (docs/conformance.md, "Events that can be missed").
struct MissedEvent {
    struct Reason {
        MissedWhile why = MissedWhile::busy;
        std::optional<std::uint64_t> cycles;  ///< maximal number of consecutive cycles; no value: unbounded
        std::vector<std::string> places;      ///< states of the machine in these cycles
    };
    std::string event;
    std::optional<std::uint64_t> cycles;  ///< maximal number of consecutive cycles, for either reason
    std::vector<Reason> reasons;
};

/// An event that a state takes only after its inner states have taken other events of the same cycle
/// (docs/conformance.md, "Events that come second").
struct OvertakenEvent {
    std::string event;
    std::vector<std::string> by;      ///< the events that come first
    bool due = false;                 ///< transitions without trigger (timeouts and conditions) come first
    std::vector<std::string> places;  ///< states of the machine at that time
};

/// What one API of the code does.
struct Behaviour {
    std::vector<std::string> outputs;  ///< in order
    std::string ends;                  ///< "at rest", "terminates", ...
    std::string state;                 ///< state after the call
};

/// A difference between the event API and the cycle. It occurs after the cycles in Result::cycles.
struct ApiDifference {
    std::string event;  ///< "heading = 90"; "": none
    std::string what;   ///< the violated property
    Behaviour cycle;
    Behaviour dispatched;
};

/// A type with few explored values, because the component only passes its values on.
struct FewValues {
    std::string type;  ///< name in the model
    std::size_t values = 0;
};

/// How the code behaves with numbers of the robot (docs/conformance.md, "Numbers on the robot").
struct RobotNumbers {
    /// A special value: a `double` that is not a number of the model, or a limit of a type.
    struct Special {
        std::string value;                ///< "nan", "inf", "-inf", "-0", "9223372036854775807"
        bool limit = false;               ///< true: the value is a number of the model and a limit of its type
        std::vector<std::string> unlike;  ///< inputs in which the value has an effect that no number of the model has;
                                          ///< for a limit: inputs in which its effect differs from that in the model
    };
    std::size_t numbers = 0;  ///< values with which the code was run
    std::size_t regions = 0;  ///< number of regions of the model's numbers
    std::string difference;   ///< the first difference that does not change the outcome; "" if none
    std::string limit;        ///< why not all cycles were run with these numbers; "" if all were
    std::vector<Special> special;
};

/// The answer to a claim about cycles, for the model in cycles or for the code.
struct CycleAnswer {
    Outcome outcome = Outcome::inconclusive;  ///< conforms: the claim holds; differs: it fails
    std::string reason;                       ///< how the claim is violated, or why it is not decided
    std::vector<Cycle> cycles;                ///< a shortest run that violates the claim
};
/// Both answers to a claim about cycles. The answer for the code is the verdict. If the claim holds for the code, the
/// answer for the model says whether every conforming controller satisfies the claim.
struct CycleAnswers {
    std::string claim;  ///< name of the claim
    std::string wording;
    diagnostics::Span span;
    CycleAnswer model, code;
    [[nodiscard]] bool holds() const { return code.outcome == Outcome::conforms; }
    bool asked = true;         ///< some cycle of the code is in the scope of the claim
    bool in_carriers = false;  ///< the claim compares values, and was decided for the finite instantiation
};

/// The result for one component, with the size of the exploration and, if the code differs, a shortest run.
struct Result {
    Outcome outcome = Outcome::inconclusive;
    std::string reason;
    std::vector<Cycle> cycles;  ///< for differs, not_schedulable: a shortest sequence of inputs
    std::string expected;       ///< events that the model allows at the difference
    Explanation explanation;    ///< for differs, not_schedulable
    /// The evidence for the explanation: the run of NF_c(M) that shows the problem, or the common trace of NF_c(M) and
    /// the code up to the difference (kind `no_trace`). The explanation uses this evidence to find the run of the model
    /// again.
    std::optional<refine::Counterexample> model_run;
    std::uint64_t code_states = 0;      ///< distinct state images of the code
    std::uint64_t code_cycles = 0;      ///< number of executed (state, input valuation) pairs
    std::uint64_t model_states = 0;     ///< states of M visited under the simulation assumptions
    refine::Statistics product;         ///< statistics of the refinement check
    refine::Statistics schedulability;  ///< statistics of the check of NF_c(M) alone
    /// Whether no cycle makes an output twice. In this case, the strict relation holds too, because it only adds this
    /// requirement. There is no value if the question was not decided.
    std::optional<Aside> register_cycles;
    /// Whether no deadline passes while the model waits for an input that does not arrive. There is no value if the
    /// question was not decided.
    std::optional<Aside> deadlines;
    std::vector<FewValues> represented;  ///< types of which only some values are explored
    /// The data of the component, if the result is valid for all ideal numbers. Otherwise the list is empty. The
    /// conditions of the model define the classes of values.
    std::vector<ir::ReplacedData> all_values;
    bool lists_of_any_length = false;  ///< the explored lists represent lists of any length
    /// The test with numbers of the robot, if the code conforms and the result is valid for all values.
    std::optional<RobotNumbers> robot;
    /// Why the check for all values did not decide. The text is empty if the check decided, or if there was no such
    /// check.
    std::string not_for_all;
    std::vector<MissedEvent> missed;        ///< if it conforms: events missed in some state of the code
    std::vector<OvertakenEvent> overtaken;  ///< if it conforms: events that come second in some state of the code
    std::uint64_t dispatched = 0;           ///< number of (state, event or none) pairs in which both APIs were compared
    std::optional<ApiDifference> api_difference;
    std::vector<CycleAnswers> claims;   ///< the answers to claims about cycles
    std::vector<std::string> raw;       ///< the trace in events of NF_c(M)
    std::string normal_form;            ///< NF_c(M) as CSPM declarations that follow the model's timed script
    std::vector<std::string> warnings;  ///< about the code, for example if its states are not canonical
    std::string exported;               ///< L(G) in the requested format (Options::exported)
    std::string export_failure;         ///< why a requested export was not made
    /// The certificate, if it was requested and the code conforms; null if there is none.
    std::shared_ptr<const certify::Certificate> certificate;
    std::string certificate_failure;  ///< why there is no certificate of code that conforms
};

/// The relation between NF_c(M) and L(G).
enum class Relation {
    failures_divergences,  ///< [FD=
    tick_tock,             ///< [TT=, which observes refusals before each tock; the code must also have no divergence
};

/// How the inputs of the code are tried. This does not affect verdicts.
enum class InputSearch {
    automatic,   ///< chosen by the number of valuations of all inputs
    all_inputs,  ///< all valuations in each state
    on_demand,   ///< only registers that the code reads; inconclusive if this cannot decide
};

/// The numbers for which a result is valid.
enum class Numbers {
    carriers,  ///< the numbers of the finite instantiation
    all,       ///< all numbers, if the component only compares and copies them; otherwise like `carriers`
};

/// A format of L(G) for other tools: Aldebaran, Graphviz, or a script that repeats NF_c(M) [FD= L(G) in FDR.
enum class Export { none, aut, dot, csp };

/// Guided random walks for systems that are too large for a search (random_walk.hpp).
struct WalkOptions {
    std::uint64_t cycles = 200'000;  ///< total of all walks; 0: no walks
    double seconds = 20;
    std::uint64_t seed = 1;
};

/// Options for generating and compiling code and for comparing it with its model.
struct Options {
    std::uint32_t cycle_length = 1;  ///< c: the number of tocks in a cycle
    Relation relation = Relation::failures_divergences;
    InputSearch inputs = InputSearch::automatic;
    Numbers numbers = Numbers::carriers;
    bool rounding_allowed = false;  ///< code that differs only with numbers of the robot conforms
    WalkOptions walks;
    Export exported = Export::none;
    cpp_emit::Options generator;   ///< seeded faults, for tests
    std::string compiler = "c++";  ///< must accept g++'s options
    std::string flags = "-std=c++17 -O1 -Wall -Wextra -Wpedantic -Wconversion -Werror";
    std::string work_dir;  ///< folder for sources and the shared object; "": a new folder, which is deleted afterwards
    diagnostics::Cache* cache = nullptr;  ///< cache of compiled code; may be null
    refine::Limits limits;
    std::string certified;  ///< the claim of a certificate, with its place; "": no certificate
    std::shared_ptr<const CycleClaims> claims = nullptr;  ///< claims about cycles of the component; may be null
};

}  // namespace robochart::conformance
