// What the verb `cspm` found in one script, as data; drawn as FDR's `refines` does: its plain text, its JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/command/options.hpp"
#include "app/report/report.hpp"
#include "checker/cspm/session.hpp"

namespace robochart::app {

/// One assertion of a script, decided.
struct ScriptAssertion {
    std::size_t number = 0;  ///< in its script, from 1
    std::string text;        ///< without `assert`
    std::string place;
    std::string specification;  ///< of a refinement: the expression
    std::string process;        ///< the implementation, or what a property is about
    Answer answer = Answer::inconclusive;
    std::vector<std::string> errors;  ///< why there is no answer
    cspm::AssertionResult result;
    std::optional<process::Behaviour> behaviour;  ///< of a counterexample that is to be shown: what each part did
};

struct ScriptPrint {
    std::string expression;
    std::string value;
    std::string error;
    bool failed = false;  ///< it has no value; else the error is a limit
};

struct ScriptReport {
    std::string path;
    std::vector<std::string> errors, warnings;
    std::vector<ScriptPrint> prints;
    std::vector<ScriptAssertion> assertions;
};

/// One object on one line, with the fields of FDR 4's `refines --format json` and some of our own (docs/cli.md).
[[nodiscard]] std::string refines_json(const ScriptReport&, const process::EventTable&, const Options&);
/// As FDR 4's `refines` prints one assertion.
[[nodiscard]] std::string refines_plain(const ScriptAssertion&, const process::EventTable&, const Options&);
/// The counterexample in our own words, with its split; each line indented.
[[nodiscard]] std::string counterexample_text(const ScriptAssertion&, const process::EventTable&, const Options&);

}  // namespace robochart::app
