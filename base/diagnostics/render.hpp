// SPDX-License-Identifier: Apache-2.0
// Draws diagnostics: for people (excerpt, caret, notes) and for programs (JSON).
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::diagnostics {

/// The appearance of findings as text.
struct TextStyle {
    bool color = false;           ///< ANSI colours
    std::size_t max_width = 160;  ///< longer source lines are cut around the caret
};

/// Draws one diagnostic with excerpt and caret:
///   error[J1]: message
///     --> path:line:column
///      |
///    7 |   junction j
///      |            ^
///      = note: ...
[[nodiscard]] std::string render_text(const SourceManager&, const Diagnostic&, const TextStyle& = {});
/// Draws all findings in sorted order, then their number ("2 errors, 1 warning"). Returns "" if there are none.
[[nodiscard]] std::string render_text(const SourceManager&, const Diagnostics&, const TextStyle& = {});
/// Returns the findings as {"schema":"robochart-verify/diagnostics/1","diagnostics":[...]}. Each finding is an object
/// {code,severity,message,file,line,column,endLine,endColumn,notes,fixes}; docs/cli.md describes the fields. `limit` is
/// the reason why the check is incomplete, or "" if it is complete.
[[nodiscard]] std::string render_json(const SourceManager&, const Diagnostics&, std::string_view limit = "");
/// The data that a SARIF log needs besides the findings.
struct SarifRules {
    std::string version;                             ///< the version of the program
    std::string what;                                ///< verb and input
    std::function<std::string(const Rule&)> title;   ///< the mistake, as a phrase
    std::function<std::string(const Rule&)> reason;  ///< why it is a mistake, in sentences
    std::string limit = {};                          ///< why the check is incomplete; "" if it is complete
};
/// Returns a SARIF 2.1.0 log with one run. It contains the rules that occur, regions with columns, related places and
/// fixes. Findings without a place are notifications. If there is a limit, an invocation states it and is marked as
/// unsuccessful.
[[nodiscard]] std::string render_sarif(const SourceManager&, const Diagnostics&, const SarifRules&);

}  // namespace robochart::diagnostics
