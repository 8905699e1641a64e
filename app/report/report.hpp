// What a run found, as data; drawn as text or JSON.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/command/options.hpp"
#include "app/report/basis.hpp"
#include "checker/refine/verdict/check.hpp"
#include "conformance/check/conform.hpp"
#include "probability/experiments/experiment.hpp"
#include "runs/run.hpp"

namespace robochart::app {

/// The answer to one assertion.
enum class Answer {
    holds,
    fails,
    inconclusive,
    no_check,   ///< the claim has no check in this semantics; said, not counted as holding
    error,      ///< the claim could not be evaluated: bad input
    unchecked,  ///< a claim of a kind that is not decided here: nothing is known of it
    computed,   ///< a value was asked for, and is there
};

/// As data: "holds", "fails".
[[nodiscard]] std::string_view name_of(Answer);
[[nodiscard]] std::string_view name_of(conformance::Outcome);
/// For people: "holds", "FAILS".
[[nodiscard]] std::string_view answer_word(Answer);

/// Why something that was to be decided is inconclusive while nothing is known of it.
inline constexpr const char* undecided_at_limit = "it was not decided before the limit";

/// What makes an assertion one of the core properties, which every component is asked about.
struct CoreReport {
    std::string component;     ///< "state machine P::S"
    std::string property;      ///< "deadlock-free"
    bool information = false;  ///< nothing is wrong where it does not hold, and nothing missing where it is not known
    /// The transitions or states of the resolved model that are asked about, where it is asked which are exercised.
    std::vector<std::string> elements = {};
    std::vector<std::string> unexercised = {};  ///< those of them that no run exercises
};

/// Said of a counterexample to which there may be a shorter one.
inline constexpr const char* not_shortest = "the run may not be a shortest one: a limit ended the search for it";

/// What a probabilistic assertion was decided on, and what was found for each combination of values of its constants.
struct ProbabilityReport {
    std::string encoding;   ///< "robotool"
    std::string scheduler;  ///< "any", "urgent", "uniform"; "" where the encoding leaves no choices
    std::vector<probability::Row> rows;
};

/// One assertion with its answer.
struct AssertionReport {
    std::string title;  ///< "A1 [timed] AggregationFSM is deadlock-free"
    std::string place;  ///< "aggregation.assertions:12"
    /// The same with its end; of a core property without place the component's declaration.
    std::optional<runs::Place> region;
    std::optional<CoreReport> core;                ///< none: the model's or the script's own
    std::optional<ProbabilityReport> probability;  ///< of probabilistic assertions
    Answer answer = Answer::inconclusive;
    std::string reason;  ///< inconclusive, no_check, error
    Basis basis;         ///< what the answer rests on beside the model
    refine::Statistics statistics;
    bool searched = false;         ///< now: not all of the answer is an earlier run's, from the cache
    std::optional<runs::Run> run;  ///< a model's counterexample
    std::string counterexample;    ///< a script's, as text
};

/// Where the finite instantiation limited a value while assertions were checked.
struct BoundReport {
    std::string element;  ///< "P::S::t1", with the part of the run in front as elsewhere
    std::string place;    ///< "model.rct:12"
    std::string text;     ///< the expression, and what was made of it
    std::string time;     ///< "untimed", "timed", or both
};

/// How large a component's process is. Where a bound was reached: what was known then.
struct SizeReport {
    struct Size {
        std::size_t states = 0;
        std::size_t transitions = 0;
        bool whole = true;
    };
    std::string component;  ///< "P::C::stm_ref0"
    std::string time;       ///< "untimed", "timed"
    Size process;           ///< D__
    Size compressed;        ///< O__
};

/// One component with the answer about its code.
struct ConformanceReport {
    std::string component;
    std::optional<runs::Place> region;  ///< where it is declared
    conformance::Result result;
    double seconds = 0;
};

/// A file that was written.
struct FileReport {
    std::string path;
    std::size_t bytes = 0;
};

/// A model among several that has errors: nothing is said of it, and the others are judged without it.
struct RefusedReport {
    std::string model;
    std::string diagnostics;  ///< schema "robochart-verify/diagnostics/1"
    std::string text;         ///< the same for people
};

/// All results of one command; text and JSON are made from it.
struct Report {
    std::string model;    ///< the inputs as given
    std::string file;     ///< the first text of the model; "" before it is read
    std::string summary;  ///< "1 state machine, 2 operations, …"
    double load_seconds = 0;
    std::vector<std::string> notes;  ///< scale of reals, carriers
    std::string subject = "model";   ///< the subject of the sentences of a counterexample
    std::vector<AssertionReport> assertions;
    std::vector<BoundReport> bounds;
    std::vector<SizeReport> sizes;
    std::vector<ConformanceReport> conformance;
    std::vector<FileReport> csp_files, cpp_files, prism_files, monitor_files, test_files;
    std::vector<std::string> remarks;  ///< on the files written
    std::vector<RefusedReport> refused;
    std::string unclaimed;         ///< said where no assertion was checked, though some were to be; "": some were
    bool nothing_checked = false;  ///< and nothing else was done either
    std::string limit;             ///< why the run ended before everything was looked at; "" if it did not

    [[nodiscard]] Exit exit() const;
    /// What may help where a limit ended a claim or the run; "" where none did.
    [[nodiscard]] std::string advice() const;
    /// Whether each assertion was looked at and has an answer: nothing was refused or left out at a limit.
    [[nodiscard]] bool all_decided() const;
    /// Assertions with this answer, without those that are information.
    [[nodiscard]] std::size_t count(Answer) const;
};

/// In front of the lines of a counterexample.
extern const std::string_view indent_of_runs;

/// Text for people, in which what others wrote is shown already; verdicts are coloured as the options ask.
[[nodiscard]] std::string render_text(const Report&, const Options&);
/// One assertion, one component in that text, without colours.
[[nodiscard]] std::string assertion_text(const AssertionReport&, const std::string& subject);
[[nodiscard]] std::string conformance_text(const ConformanceReport&);
/// Schema "robochart-verify/report/1" (docs/cli.md).
[[nodiscard]] std::string render_json(const Report&);
/// SARIF 2.1.0: what does not hold or is not known, with its run as a code flow.
[[nodiscard]] std::string render_sarif(const Report&, const std::string& verb = "check");
/// JUnit's XML: a case for each assertion and each component.
[[nodiscard]] std::string render_junit(const Report&);

}  // namespace robochart::app
