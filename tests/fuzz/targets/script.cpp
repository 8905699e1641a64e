// SPDX-License-Identifier: Apache-2.0
// Tests CSPM scripts with any input. If a script can be parsed, it is printed and parsed again, and the trees must be
// equal.
#include "checker/cspm/syntax/reader.hpp"
#include "tests/fuzz/targets/findings.hpp"
#include "tests/fuzz/targets/targets.hpp"

namespace robochart::fuzz {

namespace {

struct ScriptReading {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    cspm::Script script;

    explicit ScriptReading(std::string_view text) {
        const auto id = sources.add("t.csp", std::string(text));
        script = cspm::read(sources, id, findings);
    }
};

}  // namespace

std::string run_script(std::string_view bytes) {
    const ScriptReading first(bytes);
    if (std::string complaint = check_findings(first.sources, first.findings); !complaint.empty()) return complaint;
    const std::string text = cspm::print(first.script);
    if (!first.findings.ok()) return {};
    const ScriptReading second(text);
    if (!second.findings.ok()) return "a printed script is not read back:\n" + text;
    if (!cspm::equal(first.script, second.script)) return "a printed script is read back as another:\n" + text;
    const std::string again = cspm::print(second.script);
    return again == text ? "" : "a printed script prints differently when read back:\n" + text + "\n/\n" + again;
}

}  // namespace robochart::fuzz
