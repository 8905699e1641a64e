// SPDX-License-Identifier: Apache-2.0
#include "example.hpp"
#include "app/command/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "app/command/options.hpp"
#include "app/command/run.hpp"
#include "app/verbs/simulate.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/render.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "claims/sleec/checks/check.hpp"
#include "claims/sleec/syntax/reader.hpp"
#include "conformance/model/rules.hpp"
#include "driver/model/claim_files.hpp"
#include "driver/model/pipeline.hpp"
#include "frontend/project/project.hpp"
#include "prism/checks/check.hpp"
#include "prism/session/session.hpp"
#include "prism/syntax/reader.hpp"
#include "simulation/chain/chain.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::testing {
namespace {

namespace fs = std::filesystem;

std::string file_name(const diagnostics::Block& block, std::size_t number) {
    if (!block.file.empty()) return block.file;
    const std::string suffix = number == 0 ? "" : std::to_string(number + 1);
    if (block.language == "assertions") return "claims" + suffix + ".assertions";
    if (block.language == "cspm") return "script" + suffix + ".csp";
    if (block.language == "robosim") return "model" + suffix + ".rst";
    if (block.language == "robosim-assertions") return "claims" + suffix + ".rsa";
    if (block.language == "prism" || block.language == "props") return "model" + suffix + "." + block.language;
    if (block.language == "claims") return "claims" + suffix + ".claims";
    if (block.language == "sleec") return "rules" + suffix + ".sleec";
    return "model" + suffix + ".rct";
}

void add_expectations(const std::string& file, const std::string& text, std::multiset<std::string>& expected) {
    std::istringstream lines(text);
    std::string line;
    const std::string marker = " expect: ";
    for (int number = 1; std::getline(lines, line); ++number) {
        const std::size_t at = line.find(marker);
        if (at == std::string::npos) continue;
        std::istringstream codes(line.substr(at + marker.size()));
        for (std::string code; codes >> code;) expected.insert(fmt::format("{}:{} {}", file, number, code));
    }
}

void take(const diagnostics::SourceManager& sources, const diagnostics::Diagnostics& diagnostics, Judgement& result) {
    for (const diagnostics::Diagnostic& d : diagnostics.sorted_findings()) {
        const bool known = d.span.is_known();
        const std::string file = known ? fs::path(sources.path(d.span.source)).filename().string() : "";
        const std::uint32_t line = known ? sources.position(d.span.source, d.span.begin).line : 0;
        result.findings.insert(fmt::format("{}:{} {}", file, line, d.rule->code));
        result.rules.insert(d.rule);
    }
    result.report += diagnostics::render_text(sources, diagnostics);
}

void read_model(const std::vector<std::string>& paths, Judgement& result) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const auto model = frontend::load_project(sources, paths, diagnostics);
    take(sources, diagnostics, result);
}

void read_script(const std::string& path, Judgement& result) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const auto script = cspm::read_file(sources, path, diagnostics);
    if (diagnostics.ok()) (void)cspm::check_types(script, diagnostics);
    take(sources, diagnostics, result);
}

/// Explores the model and decides the properties.
void evaluate(const prism::CheckedModel& model, const prism::CheckedProperties& properties,
              diagnostics::Diagnostics& diagnostics) {
    try {
        const prism::StateSpace space(model, {}, {}, diagnostics);
        prism::Session session(space, properties, {});
        for (std::size_t i = 0; i < properties.properties.size(); ++i) (void)session.check(i, {});
    } catch (const prism::EvaluationError& error) {
        error.report(diagnostics);
    }
}

/// Reads the files of a PRISM example. The first file is the model, the others are its properties.
void read_prism(const std::vector<std::string>& paths, Judgement& result) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    std::string error;
    const auto source = sources.load_file(paths.front(), error).value();
    const auto model = prism::check_model(prism::read_model(sources, source, diagnostics), diagnostics);
    prism::PropertyFile file;
    if (paths.size() > 1)
        file = prism::read_properties(sources, sources.load_file(paths[1], error).value(), diagnostics);
    if (model && diagnostics.ok()) {
        const prism::CheckedProperties properties = prism::check_properties(*model, file, diagnostics);
        if (diagnostics.ok()) evaluate(*model, properties, diagnostics);
    }
    take(sources, diagnostics, result);
}

void read_rules(const std::string& path, Judgement& result) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    std::string error;
    const sleec::RuleFile file = sleec::read(sources, sources.load_file(path, error).value(), diagnostics);
    const auto unit = driver::unit_beside({path}, sources, diagnostics);
    if (diagnostics.ok())
        (void)sleec::check_rules(file, diagnostics, unit ? durations::Unit(unit->nanoseconds) : std::nullopt);
    take(sources, diagnostics, result);
}

/// Returns the words of `$ robochart-verify emit cpp MODEL`, with MODEL and FILE names replaced by paths in the folder.
std::vector<std::string> words_of(const std::string& console, const fs::path& folder) {
    std::istringstream text(console);
    std::vector<std::string> words;
    for (std::string word; text >> word;) {
        if (word == "$") continue;
        if (word == "MODEL")
            word = folder.string();
        else if (word.find('=') == std::string::npos &&
                 (word.ends_with(".rct") || word.ends_with(".csp") || word.ends_with(".scenario") ||
                  word.ends_with(".ros2") || word.ends_with(".swarm")))
            word = (folder / word).string();
        words.push_back(word);
    }
    return words;
}

void add_rule(const diagnostics::Rule* rule, Judgement& result) {
    if (rule == nullptr) return;
    result.findings.insert(fmt::format(":0 {}", rule->code));
    result.rules.insert(rule);
}

/// Adds the rules that a report on conformance names. Rules on additional properties only count if the model is
/// schedulable.
void take(const app::ConformanceReport& report, Judgement& result) {
    const conformance::Result& found = report.result;
    add_rule(found.explanation.rule, result);
    result.report += fmt::format("{}: {}\n", report.component, found.reason);
    if (found.outcome == conformance::Outcome::not_schedulable) return;
    if (found.outcome != conformance::Outcome::conforms && !found.explanation.rule)
        result.findings.insert(":0 neither schedulable nor not");
    if (!found.missed.empty()) add_rule(&conformance::rules::event_missed, result);
    if (!found.overtaken.empty()) add_rule(&conformance::rules::event_overtaken, result);
    for (const auto& aside : {found.register_cycles, found.deadlines})
        if (aside) add_rule(aside->rule, result);
}

/// Runs every phase of a verb that may report findings: parsing, lowering, writing, and the search of `conform`.
void run(const app::Options& given, Judgement& result) {
    if (given.verb == app::Verb::cspm) return read_script(given.load.inputs.front(), result);
    if (given.verb == app::Verb::simulate) {
        const auto simulation = app::load_simulation(given);
        if (simulation->project->diagnostics.ok() && simulation->scenario.abstraction)
            (void)simulation::find_chain_questions(simulation->scenario,
                                                   simulation::ChainStates(simulation->scenario, {}),
                                                   simulation->project->diagnostics);
        return take(simulation->project->sources, simulation->project->diagnostics, result);
    }
    app::Options options = given;
    driver::add_swarm(options);
    const auto project = driver::load_project(options, options.run->budget());
    app::Report report;
    const bool all = options.verb == app::Verb::verify || options.verb == app::Verb::check;
    bool good = project->diagnostics.ok();
    if (good && (all || options.verb == app::Verb::emit_csp)) good = app::write_csp(*project, options, report);
    if (good && options.verb == app::Verb::emit_cpp) good = app::write_cpp(*project, options, report);
    if (good && options.verb == app::Verb::emit_prism) good = app::write_prism(*project, options, report);
    if (good && options.verb == app::Verb::emit_rst) good = app::write_robosim(*project, options, report);
    if (good && options.verb == app::Verb::conform) {
        app::check_conformance(*project, options, report);
        for (const app::ConformanceReport& conformance : report.conformance) take(conformance, result);
    }
    take(project->sources, project->diagnostics, result);
}

void run_command(const std::string& console, const fs::path& folder, Judgement& result) {
    const std::vector<std::string> words = words_of(console, folder);
    std::vector<const char*> argv;
    for (const std::string& word : words) argv.push_back(word.c_str());
    const app::Parsed parsed = app::parse_command_line(static_cast<int>(argv.size()), argv.data());
    if (!parsed.options) {
        result.report += parsed.message;
        return;
    }
    app::Options options = *parsed.options;
    if (!options.output.folder_given) options.output.folder = (folder / "out").string();
    app::Run whole(options);
    options.run = &whole;
    run(options, result);
}

}  // namespace

std::set<std::string> Judgement::codes() const {
    std::set<std::string> codes;
    for (const std::string& finding : findings) codes.insert(finding.substr(finding.rfind(' ') + 1));
    return codes;
}

Judgement judge(const std::vector<diagnostics::Block>& example) {
    const tests::TemporaryFolder folder;
    Judgement result;
    std::string console;
    std::vector<std::string> scripts;
    std::vector<std::string> prism;
    std::vector<std::string> rules;
    bool has_model = false, claims = false;
    std::size_t number = 0;
    for (const diagnostics::Block& block : example) {
        if (block.language == "text") continue;
        if (block.language == "console") {
            console = block.text;
            continue;
        }
        const fs::path path = folder.write(file_name(block, number++), block.text);
        add_expectations(path.filename().string(), block.text, result.expected);
        if (block.language == "cspm") scripts.push_back(path.string());
        if (block.language == "prism" || block.language == "props") {
            prism.push_back(path.string());
            continue;
        }
        if (block.language == "sleec") {
            rules.push_back(path.string());
            continue;
        }
        if (block.language == "claims")
            claims = true;
        else
            has_model = has_model || block.language != "cspm";
    }
    for (const std::string& path : rules) read_rules(path, result);
    if (claims && has_model && console.empty()) console = "$ robochart-verify check MODEL";
    if (!console.empty()) {
        run_command(console, folder.path(), result);
    } else {
        if (has_model) read_model({folder.path()}, result);
        if (!scripts.empty()) read_script(scripts.front(), result);
        if (!prism.empty()) read_prism(prism, result);
    }
    return result;
}

Judgement judge_file(const std::string& path) {
    Judgement result;
    // The fixture is copied into a separate folder, so that other fixtures are not loaded with it.
    const tests::TemporaryFolder folder;
    fs::copy_file(path, folder.in(fs::path(path).filename().string()));
    read_model({folder.path()}, result);
    return result;
}

}  // namespace robochart::testing
