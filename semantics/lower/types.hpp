// SPDX-License-Identifier: Apache-2.0
// Maps the front end's semantic types to interned ids. Private to semantics/lower*.
#pragma once

#include "semantics/lower/lowering.hpp"

namespace robochart::ir {

/// Interns the core types. Must be called once, before any other function.
void intern_core_types(Lowering&);
/// Returns the id of a type. Equal types have equal ids. A type that cannot be made finite is reported.
[[nodiscard]] TypeId lower_type(Lowering&, const frontend::TypePtr&, diagnostics::Span where);
/// Returns the id of a declared type (given, enumeration, record).
[[nodiscard]] TypeId lower_declared_type(Lowering&, const frontend::TypeDeclaration&, diagnostics::Span where);
/// Interns a composed type that lowering constructs.
[[nodiscard]] TypeId intern_type(Lowering&, Type);
/// Returns the wider of two number types. For other types, returns `a`.
[[nodiscard]] TypeId wider_type(TypeId a, TypeId b);
[[nodiscard]] bool is_number(TypeId);
/// True if a part of the type is unknown, such as the element type of `{}`.
[[nodiscard]] bool is_open(const System&, TypeId);
/// Returns the type in which values of both types are compared. It combines the wider number type with the element
/// types that are known. A sequence is compared as a set of pairs.
[[nodiscard]] TypeId common_type(Lowering&, TypeId, TypeId);

}  // namespace robochart::ir
