// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/random/random_campaign.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cstdlib>
#include <set>

#include "semantics/instantiate/instantiate.hpp"
#include "semantics/lower/lower.hpp"
#include "tests/conformance/random/constructs.hpp"
#include "tests/random_models/changes/shrink.hpp"
#include "tests/random_models/models/well_formed.hpp"

namespace robochart::conformance::test {

namespace {

using std::chrono::steady_clock;

constexpr std::size_t at_once = 100;
constexpr std::chrono::seconds patience{4};

std::string error_codes(const diagnostics::Diagnostics& findings) {
    std::set<std::string> codes;
    for (const auto& finding : findings.sorted_findings())
        if (finding.rule->severity == diagnostics::Severity::error) codes.emplace(finding.rule->code);
    return fmt::format("refused: {}", fmt::join(codes, " "));
}

std::string kind_of(const Result& result) {
    switch (result.outcome) {
        case Outcome::conforms:
            return "conforms";
        case Outcome::differs:
            return "DIFFERS";
        case Outcome::rounds:
            return "rounds";
        case Outcome::not_schedulable:
            return "not schedulable";
        case Outcome::not_generated:
        case Outcome::error:
        case Outcome::inconclusive:
            break;
    }
    return "inconclusive: " + result.reason.substr(0, 60);
}

/// Describes the difference, or returns "" if there is none.
std::string describe_difference(const Result& result) {
    if (!result.warnings.empty()) return fmt::format("{}", fmt::join(result.warnings, "\n"));
    if (result.outcome != Outcome::differs) return {};
    std::string text = fmt::format("{}\nexpected: {}\n", result.reason, result.expected);
    for (const Cycle& cycle : result.cycles)
        text += fmt::format("in {} out {} state {}\n", fmt::join(cycle.inputs, ", "), fmt::join(cycle.outputs, ", "),
                            cycle.state);
    return text;
}

std::string without_blank_lines(const std::string& text) {
    std::string out;
    for (const char c : text)
        if (c != '\n' || !out.ends_with('\n')) out += c;
    return out;
}

/// Returns the kind of a disagreement: the code does not compile, or it differs.
std::string kind_of(const std::string& disagreement) {
    if (disagreement.empty()) return "";
    return disagreement.starts_with("error: ") ? "error" : "differs";
}

}  // namespace

Options Campaign::options() const {
    Options options;
    options.generator.choices = all_choices_;
    options.flags = "-std=c++17 -O0 -fno-exceptions -fno-rtti -Wall -Wextra -Wpedantic -Wconversion -Werror";
    if (const char* compiler = std::getenv("ROBOCHART_COMPILER")) options.compiler = compiler;
    options.limits.max_states = 30'000;
    options.walks.cycles = 0;  // no random walks: models that are too large are only counted
    return options;
}

Campaign::Prepared Campaign::prepare_candidate(const random_models::Project& project) const {
    const auto loaded = random_models::load(project);
    diagnostics::Diagnostics& findings = loaded->findings;
    if (findings.error_count() > 0) return {nullptr, error_codes(findings)};
    const ir::System system = ir::lower(loaded->model, loaded->sources, findings);
    const ir::Instantiation instantiation = ir::instantiate_system(system, {}, findings);
    if (!findings.ok() || system.modules.empty()) return {nullptr, error_codes(findings)};
    const ir::Module& module = system.modules.at(0);
    const ir::ComponentRef ref{ir::ComponentKind::module, module.name, module.package, 0};
    auto ready = candidate(system, instantiation, ref, options(), loaded->sources, findings);
    return {std::move(ready), error_codes(findings)};
}

void Campaign::add_model(std::uint64_t seed) {
    ++tally_.models;
    Prepared prepared = prepare_candidate(random_models::well_formed(seed, shape_of_(seed)));
    if (!prepared.candidate) {
        ++tally_.outcomes[prepared.refusal];
        return;
    }
    candidates_.push_back(std::move(prepared.candidate));
    seeds_.push_back(seed);
    if (candidates_.size() == at_once) judge_remaining();
}

void Campaign::judge_remaining() {
    if (!candidates_.empty()) judge_batch(std::exchange(seeds_, {}), std::exchange(candidates_, {}));
}

/// Judges the candidates. Those that do not compile are recorded and excluded from the batch.
void Campaign::judge_batch(std::vector<std::uint64_t> seeds, std::vector<std::unique_ptr<Candidate>> candidates) {
    std::string error;
    const auto batch = Batch::build(std::move(candidates), options(), error);
    if (batch) {
        for (std::size_t i = 0; i < batch->size(); ++i)
            count_result(seeds[i], batch->candidate(i), batch->judge_candidate(i, steady_clock::now() + patience));
        return;
    }
    const std::vector<std::string> errors = errors_by_candidate(error, seeds.size());
    std::vector<std::uint64_t> others;
    std::vector<std::unique_ptr<Candidate>> again;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        if (errors[i].empty() && seeds.size() > 1) {
            others.push_back(seeds[i]);
            again.push_back(prepare_candidate(random_models::well_formed(seeds[i], shape_of_(seeds[i]))).candidate);
            continue;
        }
        ++tally_.outcomes["DOES NOT COMPILE"];
        tally_.disagreements.push_back({seeds[i], errors[i].empty() ? "error: " + error.substr(0, 300) : errors[i]});
    }
    if (others.size() == seeds.size()) {  // the compiler's message names no candidate: compile them one by one
        for (std::size_t i = 0; i < others.size(); ++i) {
            std::vector<std::unique_ptr<Candidate>> alone;
            alone.push_back(std::move(again[i]));
            judge_batch({others[i]}, std::move(alone));
        }
    } else if (!others.empty()) {
        judge_batch(std::move(others), std::move(again));
    }
}

void Campaign::count_result(std::uint64_t seed, const Candidate& candidate, const Result& result) {
    ++tally_.outcomes[kind_of(result)];
    const std::string found = describe_difference(result);
    if (!found.empty()) tally_.disagreements.push_back({seed, found});
    if (result.outcome != Outcome::conforms) return;
    ++tally_.conforming;
    tally_.cycles += result.code_cycles;
    for (const std::string& word : constructs_in(candidate.system)) ++tally_.constructs[word];
}

std::string Campaign::find_disagreement(const random_models::Project& project) const {
    Prepared prepared = prepare_candidate(project);
    if (!prepared.candidate) return {};
    std::vector<std::unique_ptr<Candidate>> alone;
    alone.push_back(std::move(prepared.candidate));
    std::string error;
    const auto batch = Batch::build(std::move(alone), options(), error);
    if (!batch) return "error: " + errors_by_candidate(error, 1)[0];
    return describe_difference(batch->judge_candidate(0, steady_clock::now() + patience));
}

std::string Campaign::shrink_disagreement(const Disagreement& found, std::size_t budget) const {
    const std::string kind = kind_of(found.what);
    const auto fails = [&](const random_models::Project& project) {
        return kind_of(find_disagreement(project)) == kind;
    };
    const random_models::Project small =
        random_models::shrink(random_models::well_formed(found.seed, shape_of_(found.seed)), fails, budget);
    return fmt::format("seed {}: {}\n{}", found.seed, find_disagreement(small),
                       without_blank_lines(random_models::listing(small)));
}

}  // namespace robochart::conformance::test
