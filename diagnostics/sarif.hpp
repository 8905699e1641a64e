// The frame of a SARIF 2.1.0 log of this program, and its parts.
#pragma once

#include <string>
#include <string_view>

#include "diagnostics/json.hpp"
#include "diagnostics/source.hpp"

namespace robochart::diagnostics {

/// A message object.
[[nodiscard]] Json sarif_text(std::string_view message);
/// An artifact location: relative to the current folder where it is below that, as readers of SARIF take paths to be
/// relative to the root of the repository.
[[nodiscard]] Json sarif_file(std::string_view path);
/// A physical location: a path, and a region from `begin` to the exclusive `end`, in code points.
[[nodiscard]] Json sarif_place(std::string_view path, Position begin, Position end);
/// A rule: what is wrong as a phrase, which its name is made of, and in sentences.
[[nodiscard]] Json sarif_rule(std::string_view id, std::string_view title, std::string_view text,
                              std::string_view level);
/// What tells a result from the others of its file wherever it stands: the rule, and what it is about.
[[nodiscard]] Json sarif_fingerprint(std::string_view rule, std::string_view subject);

/// One run of the program.
struct SarifRun {
    std::string version;
    std::string what;  ///< verb and input: a later log of the same replaces this one where both are kept
    Json rules = Json::array();
    Json results = Json::array();
    Json notifications = Json::array();  ///< findings without a place: they are no results
    std::string limit;                   ///< why not everything was looked at; "" if it was
    Json properties = Json::object();
};
/// What is no result: about the command line, or a file that cannot be read.
[[nodiscard]] Json sarif_notification(std::string_view rule, std::string_view level, std::string_view message);
/// One log with one run, as text.
[[nodiscard]] std::string sarif_log(const SarifRun&);

}  // namespace robochart::diagnostics
