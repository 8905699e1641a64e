// Many small components at once: their generated code is compiled as one translation unit, then each is judged by
// itself. For random models and surveys.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "conformance/check/conform.hpp"
#include "conformance/code/code_batch.hpp"
#include "csp_emit/emit.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// A model with its component, ready to be judged.
struct Candidate {
    ir::System system;
    ir::Instantiation instantiation;
    ir::ComponentRef component;
    csp_emit::Emission script;
    cpp_emit::Emission code;
};

/// The model's timed script and its generated code; nothing, with what was found, if it is refused.
[[nodiscard]] std::unique_ptr<Candidate> candidate(const ir::System&, const ir::Instantiation&, const ir::ComponentRef&,
                                                   const Options&, diagnostics::SourceManager&,
                                                   diagnostics::Diagnostics&);

/// Candidates compiled together.
class Batch {
public:
    /// On failure returns nothing and sets `error` to the compiler's words.
    static std::unique_ptr<Batch> build(std::vector<std::unique_ptr<Candidate>>, const Options&, std::string& error);

    [[nodiscard]] std::size_t size() const { return candidates_.size(); }
    [[nodiscard]] const Candidate& candidate(std::size_t index) const { return *candidates_.at(index); }
    /// Schedulability and refinement of one.
    [[nodiscard]] Result judge(std::size_t index,
                               std::optional<std::chrono::steady_clock::time_point> deadline = {}) const;

private:
    Batch() = default;

    std::vector<std::unique_ptr<Candidate>> candidates_;
    Options options_;
    std::unique_ptr<CodeBatch> code_;
};

}  // namespace robochart::conformance
