// Which parts of the shipped headers a component needs, and whose types' values its expressions visit.
#pragma once

#include "cpp_emit/component.hpp"

namespace robochart::cpp_emit {

/// Fills Component::carriers, matrices, toolkit, strings and ordered from the types and expressions of its units.
void collect_uses(Component&, const ir::System&);

class CodeWriter;
struct Generation;
/// `any_Nat` and the like: functions of Step that visit the values of a type.
void write_carriers(const Generation&, CodeWriter&);

}  // namespace robochart::cpp_emit
