// SPDX-License-Identifier: Apache-2.0
// Tests RoboChart's front end with any input, and then the properties of the printer.
#include <memory>

#include "frontend/format/format.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/toolkits/toolkits.hpp"
#include "tests/fuzz/targets/findings.hpp"
#include "tests/fuzz/targets/targets.hpp"

namespace robochart::fuzz {

namespace {

using namespace frontend;

/// The result of parsing a text alone.
struct Reading {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    std::unique_ptr<File> file;

    Reading(std::string_view text, bool is_assertions) {
        const auto id = sources.add(is_assertions ? "t.assertions" : "t.rct", std::string(text));
        file = parse(sources, id, is_assertions, findings);
    }
};

std::string dump_file(const Reading& reading, std::unique_ptr<File> file) {
    Model model;
    model.files.push_back(std::move(file));
    return dump_model(model, reading.sources, false);
}

/// Checks that printed text parses to the same tree and prints the same again.
std::string check_printing(const File& file, const std::string& tree) {
    const std::string text = to_text(file);
    if (file.has_syntax_errors) return {};
    Reading again(text, file.is_assertions);
    if (!again.findings.ok()) return "a printed file is not read back:\n" + text;
    if (to_text(*again.file) != text) return "a printed file prints differently when read back:\n" + text;
    if (file.is_assertions) return {};  // the dump of assertions quotes the text
    const std::string second = dump_file(again, std::move(again.file));
    return second == tree ? "" : "a printed file is read back as another:\n" + tree + "\n/\n" + second;
}

/// Checks that formatting keeps the words and is idempotent.
std::string check_formatting(std::string_view text, bool is_assertions) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto first = format(sources, sources.add("t", std::string(text)), is_assertions, findings);
    if (!first) return findings.ok() ? "a text is not formatted, and nothing says why" : "";
    if (!same_words(std::string(text), *first, is_assertions)) return "formatting changes words:\n" + *first;
    const auto second = format(sources, sources.add("t", *first), is_assertions, findings);
    if (!second) return "a formatted text is not formatted:\n" + *first;
    return *second == *first ? "" : "formatting again changes a text:\n" + *first + "\n/\n" + *second;
}

/// Checks names, types and rules, with the imported toolkits.
std::string check_meaning(Reading& reading, std::string_view beside) {
    Model model;
    model.files.push_back(std::move(reading.file));
    if (!beside.empty()) {
        const auto id = reading.sources.add("beside.rct", std::string(beside));
        model.files.push_back(parse(reading.sources, id, false, reading.findings));
    }
    add_toolkits(reading.sources, model, reading.findings);
    resolve(model, reading.findings);
    if (dump_model(model, reading.sources, true).empty()) return "a model is dumped as nothing";
    return check_findings(reading.sources, reading.findings);
}

std::string run(std::string_view bytes, bool is_assertions, std::string_view beside) {
    Reading reading(bytes, is_assertions);
    Reading same(bytes, is_assertions);
    const std::string tree = dump_file(same, std::move(same.file));
    std::string complaint = check_findings(reading.sources, reading.findings);
    if (complaint.empty()) complaint = check_printing(*reading.file, tree);
    if (complaint.empty()) complaint = check_formatting(bytes, is_assertions);
    if (complaint.empty()) complaint = check_meaning(reading, beside);
    return complaint;
}

/// A model whose names the assertions may use.
constexpr std::string_view model_beside = R"(package m
interface I { event e event v: nat }
interface O { const c: nat move(p: nat) }
stm S { uses I requires O clock T initial i state A { entry move(c) state B {} initial j transition t { from j to B } }
  state C {} final F transition t0 { from i to A } transition t1 { from A to C trigger e } transition t2 { from C to F } }
operation Op(p: nat) { requires O initial i final f transition t { from i to f } }
controller K { uses I requires O sref s = S opref o = Op connection K on e to s on e }
module M { robotic platform P { provides O uses I } cref k = K connection P on e to k on e (_async) }
)";

}  // namespace

std::string run_model(std::string_view bytes) {
    return run(bytes, false, {});
}

std::string run_assertions(std::string_view bytes) {
    return run(bytes, true, model_beside);
}

}  // namespace robochart::fuzz
