// SPDX-License-Identifier: Apache-2.0
// The results of the verb `cspm` for one script as data; printed in the formats of FDR's `refines`: plain text and
// JSON.
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
    std::size_t number = 0;  ///< in its script, from 1
    std::string text;        ///< without `assert`
    std::string place;
    std::string specification;  ///< of a refinement
    std::string process;        ///< the implementation, or the subject of a property
    driver::Answer answer = driver::Answer::inconclusive;
    std::vector<std::string> errors;  ///< why there is no answer
    driver::Basis basis = {};         ///< what the answer rests on
    cspm::AssertionResult result;
    std::map<process::Event, std::string> events = {};  ///< names of the events in its JSON
    std::optional<process::Behaviour> behaviour;        ///< of a counterexample to show: the behaviour of each part
};

struct ScriptPrint {
    std::string expression;
    std::string value;
    std::string error;
    bool failed = false;  ///< it has no value because of an error; otherwise because of a limit
};

struct ScriptReport {
    std::string path;
    std::vector<std::string> errors, warnings;
    std::vector<ScriptPrint> prints;
    std::vector<ScriptAssertion> assertions;
};

/// The grounds of a verdict in JSON, as in every report.
[[nodiscard]] diagnostics::Json grounds_json(const driver::Basis&);
/// Stores the names of the events in the JSON of an assertion, because the JSON may be printed while the table grows.
void name_events(ScriptAssertion&, const process::EventTable&, const Options&);
/// One JSON object on one line, with the fields of FDR 4's `refines --format json` and additional ones (docs/cli.md).
[[nodiscard]] std::string refines_json(const ScriptReport&, const Options&);
/// The output of FDR 4's `refines` for one assertion.
[[nodiscard]] std::string refines_plain(const ScriptAssertion&, const process::EventTable&, const Options&);
/// The counterexample in our own format, with its split; each line is indented.
[[nodiscard]] std::string counterexample_text(const ScriptAssertion&, const process::EventTable&, const Options&);

}  // namespace robochart::app
