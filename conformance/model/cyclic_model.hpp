// SPDX-License-Identifier: Apache-2.0
// Loads a component, so that its behaviour in control cycles can be queried without generated code. The result consists
// of the process in the script, the alphabet, and a transition system: NF_c(M) or, in RoboSim, S(M)
// (docs/conformance.md).
#pragma once

#include <memory>
#include <string>

#include "checker/cspm/session.hpp"
#include "conformance/model/cycle_system.hpp"
#include "conformance/model/model_graph.hpp"
#include "conformance/model/model_interface.hpp"
#include "csp_emit/emit.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

class CyclicModel {
public:
    /// Returns null if the component has no timed semantics or no cyclic form; the diagnostics or `error` contain the
    /// reason. Throws process::Interrupted at a limit, and cspm::EvaluationError if the script cannot be evaluated. If
    /// `order` drops an event, the model treats this event as not raised. In RoboSim, the cycle length replaces
    /// `cycleDef`.
    [[nodiscard]] static std::unique_ptr<CyclicModel> load(const ir::System&, const ir::Instantiation&,
                                                           const ir::ComponentRef&, std::uint32_t cycle_length,
                                                           const refine::Limits&, diagnostics::SourceManager&,
                                                           diagnostics::Diagnostics&, std::string& error,
                                                           const cpp_emit::EventOrder& order = {});

    [[nodiscard]] const Alphabet& alphabet() const { return *alphabet_; }
    [[nodiscard]] const Interface& interface() const { return alphabet_->interface(); }
    /// Returns the interface in the same order, with the names of the model and of generated code. If elements were
    /// renamed (csp_emit/passes/safe_names.hpp), these names differ from the names in the script.
    [[nodiscard]] const Interface& outside_interface() const { return outside_; }
    [[nodiscard]] const ModelInterface& boundary() const { return boundary_; }
    [[nodiscard]] const csp_emit::Provenance& provenance() const { return script_.provenance; }
    [[nodiscard]] const csp_emit::Emission& script() const { return script_; }
    [[nodiscard]] cspm::Session& session() { return *session_; }
    [[nodiscard]] const cspm::ExprPtr& process() const { return process_; }  ///< the component in the script
    /// Returns NF_c(M), or S(M) for a RoboSim component, which needs no normal form.
    [[nodiscard]] CycleSystem& normal_form() { return *normal_form_; }
    [[nodiscard]] ModelGraph& graph() { return *graph_; }
    [[nodiscard]] std::uint32_t cycle_length() const { return cycle_length_; }
    [[nodiscard]] const ir::System& system() const { return *system_; }
    [[nodiscard]] const ir::Instantiation& instantiation() const { return *instantiation_; }

private:
    CyclicModel() = default;

    const ir::System* system_ = nullptr;
    const ir::Instantiation* instantiation_ = nullptr;
    Interface outside_;
    std::uint32_t cycle_length_ = 1;
    csp_emit::Emission script_;
    ModelInterface boundary_;
    std::unique_ptr<cspm::Session> session_;
    cspm::ExprPtr process_;
    std::unique_ptr<lts::TransitionSystem> model_;
    std::unique_ptr<Alphabet> alphabet_;
    std::unique_ptr<ModelGraph> graph_;
    std::unique_ptr<CycleSystem> normal_form_;
};

}  // namespace robochart::conformance
