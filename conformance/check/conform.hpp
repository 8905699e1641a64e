// SPDX-License-Identifier: Apache-2.0
// Checks whether generated code refines its model, NF_c(M) [FD= L(G). Explores the compiled code over all inputs
// (docs/conformance.md). NF_c(M) is RoboTool's NormalForm with its three simulation assumptions.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "conformance/check/conformance_check.hpp"
#include "conformance/check/result.hpp"
#include "conformance/model/renamed_model.hpp"
#include "cpp_emit/runtime/explore_abi.h"
#include "csp_emit/base/emission.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// Checks loaded code against the timed script of its model.
[[nodiscard]] Result judge_code(const csp_emit::Emission& script, const ir::System&, const ir::Instantiation&,
                                const ir::ComponentRef&, const rc_interface& code, const Options&);

/// The timed semantics of a model. All components of the model use it.
struct TimedModel {
    RenamedSystem model;
    csp_emit::Emission script;
    diagnostics::SourceManager* sources = nullptr;  ///< must outlive the object
    bool sound = false;                             ///< false if there are errors; then no code is generated
};

/// Emits the timed semantics. Reports findings to the diagnostics.
[[nodiscard]] TimedModel timed_model(const ir::System&, const ir::Instantiation&, diagnostics::SourceManager&,
                                     diagnostics::Diagnostics&);

/// The answer of a check for all values.
struct ForAllValues {
    std::optional<Result> result;  ///< no value: not decided
    std::string reason;            ///< why the check did not decide; "": nothing to report
    /// True if the code computes with values that the model only copies or compares with constants, or compares them
    /// with constants that the model does not use.
    bool code_tests_values = false;
};
/// Checks code with tracked numbers (cpp_emit::Options::tracked_scale) for all values of ideal numbers
/// (docs/conformance.md, "All values").
[[nodiscard]] ForAllValues judge_for_all_values(const TimedModel&, const ir::ComponentRef& component,
                                                const rc_interface& code, const Options&, const EventPlaces&);

/// Generates, compiles, explores and checks one component.
[[nodiscard]] Result conform(const TimedModel&, const ir::ComponentRef& component, const Options&,
                             diagnostics::Diagnostics&);
/// Like the function above, but for a model whose other components are not checked. The timed semantics then need not
/// be shared.
[[nodiscard]] Result conform(const ir::System&, const ir::Instantiation&, const ir::ComponentRef& component,
                             const Options&, diagnostics::SourceManager&, diagnostics::Diagnostics&);

}  // namespace robochart::conformance
