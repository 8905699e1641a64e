// The interface of a component read off the model, before or without any generated code: for recorded runs, monitors
// and test suites. Registers and outputs come in the order of the code's own interface
// (cpp_emit/runtime/explore_abi.h).
#pragma once

#include <optional>
#include <vector>

#include "conformance/interface.hpp"
#include "csp_emit/emit.hpp"
#include "diagnostics/diagnostic.hpp"
#include "semantics/instantiation.hpp"
#include "semantics/ir.hpp"

namespace robochart::conformance {

/// Kinds of numbers whose values the component only passes on: it stores, sends and hands them to operations, and no
/// operator, comparison, index or wait depends on them ("data independent": Lazić 1999; Roscoe UCS 17.2).
struct PassedOn {
    bool nat = true;
    bool integer = true;
    bool real = true;

    [[nodiscard]] bool of(ir::TypeKind) const;
};

struct Boundary {
    Interface interface;
    std::vector<std::optional<ir::TypeId>> input_types;  ///< none: the register carries no value
    std::vector<std::vector<ir::TypeId>> output_types;
    PassedOn passed_on;
};

/// Nothing, with diagnostics, where no C++ could be generated for the component.
[[nodiscard]] std::optional<Boundary> boundary(const ir::System&, const ir::Instantiation&, const ir::ComponentRef&,
                                               const csp_emit::Provenance&, diagnostics::Diagnostics&);

}  // namespace robochart::conformance
