// Types: from the front end's semantic types to interned ids. Private to semantics/lower*.
#pragma once

#include "semantics/lower/lowering.hpp"

namespace robochart::ir {

/// Interns the core types; call once, first.
void intern_core_types(Lowering&);
/// The id of a type; equal types have equal ids. What has no finite meaning here is reported.
[[nodiscard]] TypeId lower_type(Lowering&, const frontend::TypePtr&, diagnostics::Span where);
/// The id of a declared type (given, enumeration, record).
[[nodiscard]] TypeId lower_declared_type(Lowering&, const frontend::TypeDeclaration&, diagnostics::Span where);
/// Interns a composed type made here.
[[nodiscard]] TypeId intern(Lowering&, Type);
/// The wider of two number types; otherwise `a`.
[[nodiscard]] TypeId join(TypeId a, TypeId b);
[[nodiscard]] bool is_number(TypeId);
[[nodiscard]] bool is_set_like(TypeKind);
/// Whether a part of the type is not known, as that of the elements of `{}`.
[[nodiscard]] bool is_open(const System&, TypeId);
/// The type in which values of both are compared: the wider numbers, the known elements, a sequence as set of pairs.
[[nodiscard]] TypeId common_type(Lowering&, TypeId, TypeId);

}  // namespace robochart::ir
