// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/mutants/mutants.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "checker/process/operational_semantics.hpp"
#include "conformance/check/dispatch_equivalence.hpp"
#include "conformance/model/normal_form_system.hpp"

namespace robochart::conformance::test {

namespace {

constexpr std::size_t at_once = 40;  ///< the number of mutants that are compiled together

cpp_emit::BuildOptions build_options(const std::string& more = "") {
    return {"c++", "-std=c++17 -O0 -w -fno-exceptions -fno-rtti" + more, ""};
}

refine::Limits limits() {
    refine::Limits limits;
    limits.max_states = 400'000;
    limits.threads = 1;
    return limits;
}

/// Keeps only the files that a batch needs.
void strip_files(cpp_emit::Emission& code) {
    std::erase_if(code.files, [&](const cpp_emit::OutputFile& file) {
        return !file.path.ends_with("_core.hpp") && !file.path.ends_with("_trace.hpp") && file.path != code.shim;
    });
}

bool is_same_code(const cpp_emit::Emission& a, const cpp_emit::Emission& b) {
    return std::equal(a.files.begin(), a.files.end(), b.files.begin(), b.files.end(),
                      [](const auto& one, const auto& other) { return one.text == other.text; });
}

/// Returns the kind of evidence that distinguished a mutant from the model.
std::string means_of_detection(const Result& result) {
    constexpr std::pair<const char*, const char*> words[] = {
        {"event API", "the event API"},
        {"does not return", "watchdog"},
        {"step bound", "step bound"},
        {"misses a deadline", "deadline"},
        {"precondition", "precondition"},
        {"two results", "not a function"},
        {"time stops", "where time stops"},
        {"ends its cycle", "refinement: something is missing"},
        {"writes", "refinement: something else is written"},
    };
    for (const auto& [phrase, word] : words)
        if (result.reason.find(phrase) != std::string::npos) return word;
    return "refinement: " + result.reason;
}

}  // namespace

Study::Study(Model& model, ir::ComponentRef component, cpp_emit::Strategy strategy)
    : model_(model), component_(component), strategy_(strategy), bench_(model, std::move(component)) {
    code_ = emit(cpp_emit::Fault::none, 0);
    std::string error;
    original_ = CodeBatch::build({&code_}, build_options(), error);
    EXPECT_TRUE(original_) << error;
    if (!original_) return;
    original_code_ = original_->code_at(0, error);
    EXPECT_NE(original_code_, nullptr) << error;
    if (original_code_ == nullptr) return;
    Interface interface = interface_of(*original_code_);
    complete_interface(interface, model_.system, model_.instantiation, component_, bench_.script().provenance);
    alphabet_.emplace(interface, bench_.session().event_table());
    graph_.emplace(bench_.system(), *alphabet_);
}

cpp_emit::Emission Study::emit(cpp_emit::Fault fault, std::uint32_t site) {
    cpp_emit::Options options;
    options.fault = fault;
    options.fault_site = site;
    options.strategy = strategy_;
    cpp_emit::Emission code =
        cpp_emit::emit(model_.system, model_.instantiation, component_, options, model_.diagnostics);
    strip_files(code);
    return code;
}

Result Study::check_original() {
    if (original_code_ == nullptr) return {};
    const Result result = check_schedulability(*graph_, *alphabet_, 1, limits());
    return result.outcome == Outcome::conforms ? check_refinement(*original_code_) : result;
}

Result Study::check_refinement(const rc_interface& code) {
    return refined_by(*graph_, *alphabet_, code, 1, limits());
}

std::vector<Study::Seeded> Study::seed_faults(std::size_t sites, bool event_api_only,
                                              const std::set<cpp_emit::Fault>& omitted) {
    std::vector<Seeded> all;
    for (const cpp_emit::FaultKind& kind : cpp_emit::all_faults()) {
        if ((event_api_only && !cpp_emit::in_event_api(kind.fault)) || omitted.contains(kind.fault)) continue;
        const std::uint32_t there = emit(kind.fault, 0).fault_sites;
        const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(there, sites));
        for (std::uint32_t n = 0; n < count; ++n) {
            const std::uint32_t site = n * there / count;
            Seeded seeded{{kind, site, Fate::undecided, "", 0, ""}, emit(kind.fault, site)};
            if (!is_same_code(seeded.code, code_)) all.push_back(std::move(seeded));
        }
    }
    return all;
}

std::vector<Mutant> Study::mutants(std::size_t sites, bool event_api_only, const std::set<cpp_emit::Fault>& omitted) {
    if (original_code_ == nullptr) return {};
    std::vector<Seeded> all = seed_faults(sites, event_api_only, omitted);
    for (std::size_t first = 0; first < all.size(); first += at_once) {
        std::vector<Seeded*> together;
        for (std::size_t i = first; i < std::min(first + at_once, all.size()); ++i) together.push_back(&all[i]);
        judge_together(std::move(together));
    }
    std::vector<Mutant> mutants;
    for (Seeded& seeded : all) mutants.push_back(std::move(seeded.mutant));
    return mutants;
}

/// Removes mutants that do not compile from the batch. Such mutants count as killed.
void Study::drop_uncompilable(std::vector<Seeded*>& together) {
    std::vector<const cpp_emit::Emission*> codes;
    for (const Seeded* seeded : together) codes.push_back(&seeded->code);
    std::string error;
    (void)CodeBatch::build(codes, build_options(" -fsyntax-only -fmax-errors=0"), error);
    const std::vector<std::string> errors = errors_by_candidate(error, together.size());
    std::vector<Seeded*> rest;
    for (std::size_t i = 0; i < together.size(); ++i) {
        if (errors[i].empty()) {
            rest.push_back(together[i]);
            continue;
        }
        together[i]->mutant.fate = Fate::killed;
        together[i]->mutant.by = "compiler";
        together[i]->mutant.reported = errors[i];
    }
    together = std::move(rest);
}

void Study::judge_together(std::vector<Seeded*> together) {
    const auto uncompilable = [](const Seeded* seeded) {
        return seeded->mutant.kind.fault == cpp_emit::Fault::undeclared_member ||
               seeded->mutant.kind.fault == cpp_emit::Fault::name_collision;
    };
    if (std::ranges::any_of(together, uncompilable)) drop_uncompilable(together);
    if (together.empty()) return;
    std::vector<const cpp_emit::Emission*> codes;
    for (const Seeded* seeded : together) codes.push_back(&seeded->code);
    std::string error;
    const auto batch = CodeBatch::build(codes, build_options(), error);
    ASSERT_TRUE(batch) << error.substr(0, 4000);
    for (std::size_t i = 0; i < together.size(); ++i) {
        std::string fault;
        const rc_interface* const code = batch->code_at(i, fault);
        ASSERT_NE(code, nullptr) << fault;
        judge(together[i]->mutant, *code);
    }
}

void Study::judge(Mutant& mutant, const rc_interface& code) {
    try {
        const Result result = check_refinement(code);
        mutant.reported = result.reason;
        if (result.outcome == Outcome::conforms) return compare_with_original(mutant, code);
        if (result.outcome != Outcome::differs) return;
        mutant.fate = Fate::killed;
        mutant.by = means_of_detection(result);
        mutant.cycles = std::max<std::size_t>(1, result.cycles.size());
    } catch (const AlphabetError& mismatch) {
        mutant.fate = Fate::killed;
        mutant.by = "interface";
        mutant.reported = mismatch.what();
    }
}

void Study::compare_with_original(Mutant& mutant, const rc_interface& code) {
    try {
        const CodeEquality equality = compare_code(*original_code_, code, *alphabet_, 1, limits());
        mutant.fate = equality.same ? Fate::equivalent : Fate::variant;
        mutant.cycles = equality.cycles;
        mutant.reported = equality.difference;
    } catch (const process::Interrupted& limit) {
        mutant.reported = limit.what();
    }
}

}  // namespace robochart::conformance::test
