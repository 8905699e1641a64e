// SPDX-License-Identifier: Apache-2.0
// Analyses mutants of the generator: seeds every fault at every place of a model, compiles the mutants in batches and
// judges them. A mutant is killed, or the checker shows that it is equivalent, or it is a variant that the model
// allows.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "semantics/ir/ir.hpp"
#include "tests/conformance/batches/code_batch.hpp"
#include "tests/conformance/batches/code_equality.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance::test {

enum class Fate {
    killed,
    equivalent,  ///< L(G') and L(G) are strongly bisimilar
    variant,     ///< conforms, but behaves differently from the original
    undecided,   ///< a limit was reached
};

struct Mutant {
    cpp_emit::FaultKind kind;
    std::uint32_t site = 0;
    Fate fate = Fate::undecided;
    std::string by;          ///< if killed, what distinguished it from the model
    std::size_t cycles = 0;  ///< if killed or a variant, number of cycles of the shortest difference
    std::string reported;    ///< the difference
};

class Study {
public:
    Study(Model& model, ir::ComponentRef component, cpp_emit::Strategy strategy = cpp_emit::Strategy::automatic);

    /// Returns the result for the unchanged code. If it is not `conforms`, the analysis has no meaning.
    [[nodiscard]] Result check_original();
    /// Judges every mutant whose code differs from the original. Tries at most `sites` places of each kind, spread
    /// evenly. With `event_api_only`, tries only faults of the event API. `omitted` contains the kinds to omit.
    [[nodiscard]] std::vector<Mutant> mutants(std::size_t sites = 1000, bool event_api_only = false,
                                              const std::set<cpp_emit::Fault>& omitted = {});

private:
    struct Seeded {
        Mutant mutant;
        cpp_emit::Emission code;
    };

    [[nodiscard]] cpp_emit::Emission emit(cpp_emit::Fault, std::uint32_t site);
    [[nodiscard]] std::vector<Seeded> seed_faults(std::size_t sites, bool event_api_only,
                                                  const std::set<cpp_emit::Fault>& omitted);
    void judge_together(std::vector<Seeded*> together);
    void drop_uncompilable(std::vector<Seeded*>& together);
    void judge(Mutant&, const rc_interface& code);
    void compare_with_original(Mutant&, const rc_interface& code);
    [[nodiscard]] Result check_refinement(const rc_interface& code);

    Model& model_;
    ir::ComponentRef component_;
    cpp_emit::Strategy strategy_;
    Bench bench_;
    cpp_emit::Emission code_;
    std::unique_ptr<CodeBatch> original_;
    const rc_interface* original_code_ = nullptr;
    std::optional<Alphabet> alphabet_;
    std::optional<ModelGraph> graph_;
};

}  // namespace robochart::conformance::test
