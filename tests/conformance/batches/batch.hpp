// SPDX-License-Identifier: Apache-2.0
// Checks many small components at once: compiles their generated code as one translation unit, then checks each
// component separately. The tests use it for random models and surveys.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "conformance/check/conform.hpp"
#include "csp_emit/emit.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"
#include "tests/conformance/batches/code_batch.hpp"

namespace robochart::conformance {

/// A model and its component, ready to be checked.
struct Candidate {
    ir::System system;
    ir::Instantiation instantiation;
    ir::ComponentRef component;
    csp_emit::Emission script;
    cpp_emit::Emission code;
};

/// Generates the model's timed script and the component's code. Returns null, with diagnostics, if the generator
/// rejects the component.
[[nodiscard]] std::unique_ptr<Candidate> candidate(const ir::System&, const ir::Instantiation&, const ir::ComponentRef&,
                                                   const Options&, diagnostics::SourceManager&,
                                                   diagnostics::Diagnostics&);

/// Candidates that were compiled together.
class Batch {
public:
    /// Compiles the candidates. On failure returns null and sets `error` to the compiler's output.
    static std::unique_ptr<Batch> build(std::vector<std::unique_ptr<Candidate>>, const Options&, std::string& error);

    [[nodiscard]] std::size_t size() const { return candidates_.size(); }
    [[nodiscard]] const Candidate& candidate(std::size_t index) const { return *candidates_.at(index); }
    /// Checks schedulability and refinement of one candidate.
    [[nodiscard]] Result judge_candidate(std::size_t index,
                                         std::optional<std::chrono::steady_clock::time_point> deadline = {},
                                         InputSearch = InputSearch::automatic) const;

private:
    Batch() = default;

    std::vector<std::unique_ptr<Candidate>> candidates_;
    Options options_;
    std::unique_ptr<CodeBatch> code_;
};

}  // namespace robochart::conformance
