// SPDX-License-Identifier: Apache-2.0
// Chooses finite carriers for a component that only passes values on: few values represent all. See
// docs/conformance.md, "Few values for all".
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

/// An instantiation with fewer values, and the types with fewer values. No types: all values are explored.
struct Representatives {
    ir::Instantiation instantiation;
    std::vector<RepresentedType> types;
};

/// Chooses representatives for a component whose inputs or outputs have more values than can be explored. For each data
/// independent type, the representatives are the values of constants, the initial values, and two further values. The
/// two further values differ from all others and from each other in every part. The parts of one value also differ from
/// each other if the carriers allow it, so that lost or exchanged parts are detected.
[[nodiscard]] Representatives choose_representatives(const ir::System&, const ir::Instantiation&,
                                                     const cpp_emit::Component&);

/// Whether few values represent the type or one of its parts.
[[nodiscard]] bool is_represented(const ir::System&, const Representatives&, ir::TypeId);

}  // namespace robochart::conformance
