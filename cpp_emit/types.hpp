// The model's types and values as C++ text.
#pragma once

#include <string>

#include "semantics/instantiation.hpp"
#include "semantics/ir.hpp"

namespace robochart::cpp_emit {

/// Whether values of the type can be generated.
[[nodiscard]] bool supported(const ir::Type&);
[[nodiscard]] bool numeric(ir::TypeKind);
/// bool, Nat, Int, Real or the declared type's name.
[[nodiscard]] std::string cpp_type(const ir::System&, ir::TypeId);
/// Bytes of a value in State: numbers 8, others 1.
[[nodiscard]] std::size_t cpp_size(const ir::Type&);
/// A value as C++ text: `Real(-0.75)`, `Nat(25)`, `true`, `Light::Red`.
[[nodiscard]] std::string cpp_value(const ir::System&, const ir::Instantiation&, ir::TypeId, const ir::Value&);
/// A decimal as it is written in C++: always with a point.
[[nodiscard]] std::string decimal_text(ir::Decimal);
/// The C++ name of an enumeration's literal.
[[nodiscard]] std::string literal_name(const ir::Type&, std::size_t index);
/// A value as CSPM text: "-70" (scaled), "true", "P_T_Red".
[[nodiscard]] std::string cspm_value(const ir::System&, ir::TypeId, const ir::Value&);

}  // namespace robochart::cpp_emit
