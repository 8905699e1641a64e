// SPDX-License-Identifier: Apache-2.0
// Computes the interface of a component from the model, without generated code, for recorded runs, monitors and test
// suites. Registers and outputs have the same order as in the code's own interface (cpp_emit/runtime/explore_abi.h).
#pragma once

#include <optional>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "conformance/code/interface.hpp"
#include "conformance/model/logged_value.hpp"
#include "csp_emit/emit.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

struct ModelInterface {
    Interface interface;
    std::vector<std::optional<ir::TypeId>> input_types;  ///< no value: the register carries no value
    std::vector<std::vector<ir::TypeId>> output_types;
    TestedNumbers numbers;
};

/// Returns no value and reports findings if no C++ can be generated for the component.
[[nodiscard]] std::optional<ModelInterface> model_interface(const ir::System&, const ir::Instantiation&,
                                                            const ir::ComponentRef&, const csp_emit::Provenance&,
                                                            diagnostics::Diagnostics&);

/// Returns only the interface, without an analysis of the component's numbers.
[[nodiscard]] std::optional<Interface> component_interface(const ir::System&, const ir::Instantiation&,
                                                           const ir::ComponentRef&, const csp_emit::Provenance&,
                                                           diagnostics::Diagnostics&);

/// Returns how the component uses numbers, or no value if no C++ can be generated for it.
[[nodiscard]] std::optional<TestedNumbers> tested_numbers(const ir::System&, const ir::Instantiation&,
                                                          const ir::ComponentRef&);

}  // namespace robochart::conformance
