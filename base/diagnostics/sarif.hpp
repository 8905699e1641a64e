// SPDX-License-Identifier: Apache-2.0
// Writes the frame and the parts of a SARIF 2.1.0 log of this program.
#pragma once

#include <string>
#include <string_view>

#include "base/diagnostics/json.hpp"
#include "base/diagnostics/source.hpp"

namespace robochart::diagnostics {

/// Returns a message object.
[[nodiscard]] Json sarif_text(std::string_view message);
/// Returns an artifact location. It is relative if the file is below the current folder, because readers of SARIF
/// resolve paths against the root of the repository.
[[nodiscard]] Json sarif_file(std::string_view path);
/// Returns a physical location: a path and a region from `begin` to `end` (exclusive), in code points.
[[nodiscard]] Json sarif_place(std::string_view path, Position begin, Position end);
/// Returns a rule. `title` describes the mistake as a phrase and determines the rule's name; `text` describes it in
/// sentences.
[[nodiscard]] Json sarif_rule(std::string_view id, std::string_view title, std::string_view text,
                              std::string_view level);
/// Returns the fingerprint of a result. Rule and subject distinguish the result from others in the same file,
/// independently of its position.
[[nodiscard]] Json sarif_fingerprint(std::string_view rule, std::string_view subject);

/// The data of one run of the program.
struct SarifRun {
    std::string version;
    std::string what;  ///< verb and input; if two logs have the same text, readers use only the later log
    Json rules = Json::array();
    Json results = Json::array();
    Json notifications = Json::array();  ///< findings without a place, which are not results
    std::string limit;                   ///< why the check is incomplete; "" if it is complete
    Json properties = Json::object();
};
/// Returns a finding that is not a result: a finding about the command line, or about a file that cannot be read.
[[nodiscard]] Json sarif_notification(std::string_view rule, std::string_view level, std::string_view message);
/// Returns the text of a log with one run.
[[nodiscard]] std::string sarif_log(const SarifRun&);

}  // namespace robochart::diagnostics
