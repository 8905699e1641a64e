// SPDX-License-Identifier: Apache-2.0
// The results of a run as data, printed as text or JSON.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/command/options.hpp"
#include "app/report/basis.hpp"
#include "checker/refine/verdict/check.hpp"
#include "conformance/check/conform.hpp"
#include "counterexample/run.hpp"
#include "prism/assertions/experiments/experiment.hpp"

namespace robochart::app {

/// The answer to one assertion.
enum class Answer {
    holds,
    fails,
    inconclusive,
    no_check,   ///< the claim has no check in this semantics; it is listed, but does not count as true
    error,      ///< the claim could not be evaluated because of wrong input
    unchecked,  ///< a claim of a kind that is not decided here, so its answer is unknown
    computed,   ///< a value was requested and computed
};

/// The answer in data formats: "holds", "fails".
[[nodiscard]] std::string_view name_of(Answer);
[[nodiscard]] std::string_view name_of(conformance::Outcome);
/// The answer for people: "holds", "FAILS".
[[nodiscard]] std::string_view answer_word(Answer);

/// The reason of a claim that is inconclusive because its decision has not begun.
inline constexpr const char* undecided_at_limit = "it was not decided before the limit";

/// Additional data of an assertion that is a core property, which is checked for every component.
struct CoreReport {
    std::string component;     ///< "state machine P::S"
    std::string property;      ///< "deadlock-free"
    bool information = false;  ///< informative only: neither a false nor an unknown answer is a problem
    /// If the question is which elements are exercised: the transitions or states of the resolved model that it is
    /// about.
    std::vector<std::string> elements = {};
    std::vector<std::string> unexercised = {};  ///< those that no run exercises
};

/// Printed with a counterexample that may not be shortest.
inline constexpr const char* not_shortest = "the run may not be a shortest one: a limit ended the search for it";

/// The model that decided a probabilistic assertion, and the result for each combination of values of its constants.
struct ProbabilityReport {
    std::string encoding;   ///< "robotool"
    std::string scheduler;  ///< "any", "urgent", "uniform"; "" if the encoding has no choices
    std::vector<probability::Row> rows;
};

/// One assertion with its answer.
struct AssertionReport {
    std::string title;  ///< "A1 [timed] AggregationFSM is deadlock-free"
    std::string place;  ///< "aggregation.assertions:12"
    /// The same place with its end. For a core property without a place, the declaration of the component.
    std::optional<runs::Place> region;
    std::optional<CoreReport> core;                ///< no value: an assertion of the model or the script
    std::optional<ProbabilityReport> probability;  ///< for probabilistic assertions
    Answer answer = Answer::inconclusive;
    std::string reason;  ///< inconclusive, no_check, error
    Basis basis;         ///< the basis of the answer, apart from the model
    refine::Statistics statistics;
    bool searched = false;         ///< in this run: the answer is not entirely from the cache
    std::optional<runs::Run> run;  ///< the counterexample of a model
    std::string counterexample;    ///< the counterexample of a script, as text
};

/// A place where the finite instantiation limited a value while assertions were checked.
struct BoundReport {
    std::string element;  ///< "P::S::t1", preceded by the name of the part if there are several
    std::string place;    ///< "model.rct:12"
    std::string text;     ///< the expression and how it was limited
    std::string time;     ///< "untimed", "timed", or both
};

/// The size of a component's process. If a bound was reached, the size known then.
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

/// A component with the answer about its code.
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

/// A model with errors among several models. Its claims are not decided; the other models are checked without it.
struct RefusedReport {
    std::string model;
    std::string diagnostics;  ///< schema "robochart-verify/diagnostics/1"
    std::string text;         ///< the diagnostics for people
};

/// All results of one command. Text and JSON are made from it.
struct Report {
    std::string model;    ///< the inputs as given
    std::string file;     ///< the first text of the model; "" before it has been read
    std::string summary;  ///< "1 state machine, 2 operations, …"
    double load_seconds = 0;
    std::vector<std::string> notes;  ///< scale of reals, carriers
    std::string subject = "model";   ///< the grammatical subject in the text of a counterexample
    std::vector<AssertionReport> assertions;
    std::vector<BoundReport> bounds;
    std::vector<SizeReport> sizes;
    std::vector<ConformanceReport> conformance;
    std::vector<FileReport> csp_files, cpp_files, prism_files, monitor_files, test_files;
    std::vector<std::string> remarks;  ///< about the files written
    std::vector<RefusedReport> refused;
    std::string unclaimed;         ///< printed if no assertion was checked although some should be; "" otherwise
    bool nothing_checked = false;  ///< and nothing else was done, either
    std::string limit;             ///< why the run ended early; "" if it did not

    [[nodiscard]] Exit exit_code() const;
    /// A suggestion if a limit ended a claim or the run; "" otherwise.
    [[nodiscard]] std::string limit_advice() const;
    /// True if every assertion has an answer: none was rejected, and none was left out because of a limit.
    [[nodiscard]] bool all_decided() const;
    /// The number of assertions with this answer, without informative ones.
    [[nodiscard]] std::size_t count_answers(Answer) const;
};

/// The indentation of counterexamples.
extern const std::string_view indent_of_runs;

/// Text for people, in which foreign text is escaped already; verdicts are coloured as the options require.
[[nodiscard]] std::string render_text(const Report&, const Options&);
/// The text of one assertion or one component, without colours.
[[nodiscard]] std::string assertion_text(const AssertionReport&, const std::string& subject);
[[nodiscard]] std::string conformance_text(const ConformanceReport&);
/// Schema "robochart-verify/report/1" (docs/cli.md).
[[nodiscard]] std::string render_json(const Report&);
/// SARIF 2.1.0: claims that are false or unknown, each with its run as a code flow.
[[nodiscard]] std::string render_sarif(const Report&, const std::string& verb = "check");
/// JUnit XML: one case per assertion and component.
[[nodiscard]] std::string render_junit(const Report&);

}  // namespace robochart::app
