// Few values for all: finite carriers for a component that only passes values on. Docs: docs/conformance.md, "Few
// values for all".
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// A type of which few values are looked at.
struct RepresentedType {
    ir::TypeId type;
    std::string name;        ///< as the model writes it
    std::size_t values = 0;  ///< that stand for all
};

/// An instantiation with fewer values, and the types that have fewer. No types: nothing is represented.
struct Representatives {
    ir::Instantiation instantiation;
    std::vector<RepresentedType> types;
};

/// For a component whose inputs or outputs have more values than can be explored: of each data independent type, those
/// of the constants and initial values, and two more. The two differ from all of these, from each other in every part,
/// and have parts that differ where the carriers of the parts allow it, so that parts which are lost or exchanged show.
[[nodiscard]] Representatives representatives(const ir::System&, const ir::Instantiation&, const cpp_emit::Component&);

/// Whether values of the type are, or have parts that are, represented by few.
[[nodiscard]] bool represented(const ir::System&, const Representatives&, ir::TypeId);

}  // namespace robochart::conformance
