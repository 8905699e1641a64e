// SPDX-License-Identifier: Apache-2.0
// Parses and checks SLEEC texts for tests.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics/render.hpp"
#include "claims/sleec/checks/check.hpp"
#include "claims/sleec/syntax/reader.hpp"

namespace robochart::sleec::testing {

/// A parsed text with its findings.
struct Read {
    explicit Read(const std::string& text, const std::string& path = "rules.sleec") {
        file = read(sources, sources.add(path, text), diagnostics);
    }
    /// Resolves names and checks types, too.
    Read& checked_too() {
        if (diagnostics.ok()) checked = check_rules(file, diagnostics);
        return *this;
    }
    /// Returns codes with lines, in the order of the text: "SLEEC-P01:3 SLEEC-P02:7".
    [[nodiscard]] std::string findings() const {
        std::string text;
        for (const diagnostics::Diagnostic& finding : diagnostics.sorted_findings()) {
            if (!text.empty()) text += " ";
            text += finding.rule->code;
            if (finding.span.is_known())
                text += ":" + std::to_string(sources.position(finding.span.source, finding.span.begin).line);
        }
        return text;
    }
    [[nodiscard]] std::string report() const { return diagnostics::render_text(sources, diagnostics); }

    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    RuleFile file;
    std::optional<CheckedRules> checked;
};

/// Returns a file with these rules over the events Go, Stop, Halt, Alarm, Help, the measures near, safe (boolean),
/// level (numeric), load (low, mid, high), and the constant MAX = 5.
inline std::string with_definitions(const std::string& rules) {
    return "def_start\nevent Go event Stop event Halt event Alarm event Help\n"
           "measure near : boolean measure safe : boolean measure level : numeric\n"
           "measure load : scale(low, mid, high) constant MAX = 5\ndef_end\nrule_start\n" +
           rules + "\nrule_end\n";
}

}  // namespace robochart::sleec::testing
