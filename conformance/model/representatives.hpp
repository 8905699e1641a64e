// SPDX-License-Identifier: Apache-2.0
// Few values for all: finite carriers for a component that only passes values on. See docs/conformance.md, "Few values
// for all".
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// A type of which few values are explored.
struct RepresentedType {
    ir::TypeId type;
    std::string name;        ///< name in the model
    std::size_t values = 0;  ///< number of values that represent all
};

/// An instantiation with fewer values, and the types that have fewer. No types: nothing is represented.
struct Representatives {
    ir::Instantiation instantiation;
    std::vector<RepresentedType> types;
};

/// For a component whose inputs or outputs have more values than can be explored: for each data independent type, the
/// values of constants and initial values, and two more. The two differ from all of these and from each other in every
/// part, and their parts differ if the carriers of the parts allow it, so that lost or exchanged parts are detected.
[[nodiscard]] Representatives representatives(const ir::System&, const ir::Instantiation&, const cpp_emit::Component&);

/// Whether few values represent the type, or one of its parts.
[[nodiscard]] bool represented(const ir::System&, const Representatives&, ir::TypeId);

}  // namespace robochart::conformance
