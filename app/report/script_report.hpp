// SPDX-License-Identifier: Apache-2.0
// Defines the results of the verb `cspm` for one script as data, and prints them in the formats of FDR's `refines`:
// plain text and JSON.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/command/options.hpp"
#include "app/report/report.hpp"
#include "base/diagnostics/json.hpp"
#include "checker/cspm/session.hpp"

namespace robochart::app {

/// A decided assertion of a script.
struct ScriptAssertion {
    std::size_t number = 0;  ///< number in the script, from 1
    std::string text;        ///< without `assert`
    std::string place;
    std::string specification;  ///< specification of a refinement
    std::string process;        ///< the implementation, or the subject of a property
    driver::Answer answer = driver::Answer::inconclusive;
    std::vector<std::string> errors;  ///< reasons why there is no answer
    driver::Basis basis = {};         ///< basis of the answer
    std::optional<driver::CertificateReport> certificate = {};
    cspm::AssertionResult result;
    std::map<process::Event, std::string> events = {};  ///< names of the events in its JSON
    std::optional<process::Behaviour> behaviour;        ///< behaviour of each part at the end of a counterexample
};

struct ScriptPrint {
    std::string expression;
    std::string value;
    std::string error;
    bool failed = false;  ///< true if an error prevents a value, false if a limit does
};

struct ScriptReport {
    std::string path;
    std::vector<std::string> errors, warnings;
    std::vector<ScriptPrint> prints;
    std::vector<ScriptAssertion> assertions;
};

/// Returns the basis of a verdict in JSON, in the form that all reports use.
[[nodiscard]] diagnostics::Json grounds_json(const driver::Basis&);
[[nodiscard]] diagnostics::Json certificate_json(const driver::CertificateReport&);
/// Stores the names of the events that the JSON of an assertion contains. They are copied because another thread may
/// add events to the table while the JSON is printed.
void name_events(ScriptAssertion&, const process::EventTable&, const Options&);
/// Returns one JSON object on one line, with the fields of FDR 4's `refines --format json` and additional fields
/// (docs/cli.md).
[[nodiscard]] std::string refines_json(const ScriptReport&, const Options&);
/// Returns the output of FDR 4's `refines` for one assertion.
[[nodiscard]] std::string refines_plain(const ScriptAssertion&, const process::EventTable&, const Options&);
/// Returns the counterexample in our own format, with the behaviour of its parts. Every line is indented.
[[nodiscard]] std::string counterexample_text(const ScriptAssertion&, const process::EventTable&, const Options&);

}  // namespace robochart::app
