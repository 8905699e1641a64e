// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/batches/batch.hpp"

#include "conformance/check/conformance_check.hpp"
#include "conformance/model/component.hpp"
#include "conformance/model/renamed_model.hpp"

namespace robochart::conformance {

std::unique_ptr<Candidate> candidate(const ir::System& system, const ir::Instantiation& instantiation,
                                     const ir::ComponentRef& component, const Options& options,
                                     diagnostics::SourceManager& sources, diagnostics::Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.error_count();
    auto result = std::make_unique<Candidate>();
    RenamedModel model = renamed_model(system, instantiation, component, diagnostics);
    result->system = std::move(model.system);
    result->instantiation = std::move(model.instantiation);
    result->component = std::move(model.component);
    cpp_emit::Options generator = options.generator;
    generator.cycle_length = options.cycle_length;
    result->code = cpp_emit::emit(result->system, result->instantiation, result->component, generator, diagnostics);
    if (diagnostics.error_count() != errors || result->code.shim.empty()) return nullptr;
    result->script =
        csp_emit::emit(result->system, result->instantiation, csp_emit::Time::timed, {}, sources, diagnostics);
    return diagnostics.error_count() == errors ? std::move(result) : nullptr;
}

std::unique_ptr<Batch> Batch::build(std::vector<std::unique_ptr<Candidate>> candidates, const Options& options,
                                    std::string& error) {
    std::unique_ptr<Batch> batch(new Batch);
    batch->candidates_ = std::move(candidates);
    batch->options_ = options;
    std::vector<const cpp_emit::Emission*> all;
    for (const auto& candidate : batch->candidates_) all.push_back(&candidate->code);
    batch->code_ = CodeBatch::build(all, {options.compiler, options.flags, options.work_dir}, error);
    return batch->code_ ? std::move(batch) : nullptr;
}

Result Batch::judge_candidate(std::size_t index, std::optional<std::chrono::steady_clock::time_point> deadline,
                              InputSearch inputs) const {
    const Candidate& candidate = *candidates_.at(index);
    Result result;
    std::string fault;
    const rc_interface* const code = code_->code_at(index, fault);
    if (code == nullptr) {
        result.outcome = Outcome::differs;
        result.reason = "the exploration interface cannot be used: " + fault;
        return result;
    }
    Options options = options_;
    options.inputs = inputs;
    if (deadline) options.limits.deadline = deadline;
    return judge_code(candidate.script, candidate.system, candidate.instantiation, candidate.component, *code, options);
}

}  // namespace robochart::conformance
