// SPDX-License-Identifier: Apache-2.0
// Defines the results of a run as data, and renders them as text, JSON, SARIF and JUnit XML.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/command/options.hpp"
#include "conformance/check/conform.hpp"
#include "counterexample/run.hpp"
#include "driver/results/basis.hpp"
#include "driver/results/results.hpp"

namespace robochart::app {

/// Returns the answer as a word for data formats, such as "conforms".
[[nodiscard]] std::string_view name_of(conformance::Outcome);
/// Returns how an answer was found, as a word for data formats, such as "search".
[[nodiscard]] std::string_view proof_name(refine::DecidedBy);
/// Returns why an answer needed no search, as a sentence without its full stop; "" if a search was needed.
[[nodiscard]] std::string_view proof_reason(refine::DecidedBy);
/// Returns the number of states and nodes of an answer that decision diagrams found.
[[nodiscard]] std::string diagrams_text(const refine::Statistics& size);

/// A component, and the answer to the question whether its code conforms.
struct ConformanceReport {
    std::string component;
    std::optional<runs::Place> region;  ///< where the component is declared
    conformance::Result result;
    double seconds = 0;
    std::string order = {};  ///< the declared order of events in a cycle: "estop first"; "" if there is none
    std::vector<std::optional<runs::Place>> claim_regions = {};  ///< places of Result::claims
    std::optional<driver::CertificateReport> certificate = {};   ///< no value if none was requested or it differs
};
/// Returns a sentence that says what must still be trusted if the component has this certificate; "" without one.
[[nodiscard]] std::string still_trusted(const ConformanceReport&);

/// The two subjects for which a claim about control cycles is decided.
inline constexpr std::string_view model_in_cycles = "the model in cycles", this_code = "this code";

/// A file that was written.
struct FileReport {
    std::string path;
    std::size_t bytes = 0;
};

/// A model with errors among several models. Its claims are not decided, and the other models are checked without it.
struct RefusedReport {
    std::string model;
    std::string diagnostics;  ///< schema "robochart-verify/diagnostics/1"
    std::string text;         ///< its diagnostics as text for people
};

/// All results of one command. All output formats are made from this data.
struct Report : driver::ClaimResults {
    std::string model;    ///< the inputs as given
    std::string file;     ///< the first text of the model; "" before it has been read
    std::string summary;  ///< "1 state machine, 2 operations, …"
    double load_seconds = 0;
    std::vector<std::string> notes;  ///< notes about the instantiation: scale of reals, carriers
    std::string subject = "model";   ///< the grammatical subject in the text of a counterexample
    std::vector<ConformanceReport> conformance;
    std::vector<FileReport> csp_files, cpp_files, prism_files, monitor_files, test_files, rst_files;
    std::vector<RefusedReport> refused;
    std::string unclaimed;         ///< printed if no assertion was checked although some should be; "" otherwise
    bool nothing_checked = false;  ///< true if nothing was checked and the run had no other task
    std::string limit;             ///< why the run ended early; "" if it did not

    [[nodiscard]] Exit exit_code() const;
    /// Returns a suggestion if a limit ended a check or the run; otherwise "".
    [[nodiscard]] std::string limit_advice() const;
    /// True if every assertion has an answer. An assertion has none if it was rejected, or if a limit was reached.
    [[nodiscard]] bool all_decided() const;
    /// Returns the number of assertions with this answer, without informative ones.
    [[nodiscard]] std::size_t count_answers(driver::Answer) const;
};

/// The indentation of counterexamples.
extern const std::string_view indent_of_runs;

/// Renders the text for people. Foreign text in the report must be escaped already. Verdicts are coloured as the
/// options require.
[[nodiscard]] std::string render_text(const Report&, const Options&);
/// Returns the text of one assertion or one component, without colours.
[[nodiscard]] std::string assertion_text(const driver::AssertionReport&, const std::string& subject);
[[nodiscard]] std::string conformance_text(const ConformanceReport&);
/// Returns one answer to a claim about control cycles as text.
[[nodiscard]] std::string cycle_answer_text(const conformance::CycleAnswers&, std::string_view subject,
                                            const conformance::CycleAnswer&);
/// Renders JSON with the schema "robochart-verify/report/1" (docs/cli.md).
[[nodiscard]] std::string render_json(const Report&);
/// Renders SARIF 2.1.0: the claims that are false or unknown, each with its run as a code flow.
[[nodiscard]] std::string render_sarif(const Report&, const std::string& verb = "check");
/// Renders JUnit XML with one case per assertion and component.
[[nodiscard]] std::string render_junit(const Report&);

}  // namespace robochart::app
