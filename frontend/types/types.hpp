// SPDX-License-Identifier: Apache-2.0
// Defines the types of RoboChart expressions, and the compatibility relation of RoboTool's RoboChartTypeProvider
// (reference: RoboChart manual, type system; rules RC-T in docs/rules).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// The form of a type. `any` is the element type of `<>` and `{}`.
enum class TypeForm {
    any,
    boolean,
    nat,
    integer,
    real,
    string,
    given,
    enumeration,
    record,
    variable,
    sequence,
    set,
    product,
    function,
    relation,
    vector,
    matrix
};

/// A type of the language, as the type checker uses it.
struct Type {
    TypeForm form = TypeForm::any;
    std::string name;                              ///< variable ?X; declared types: Names::type_name
    const TypeDeclaration* declaration = nullptr;  ///< the declaration of a given type, enumeration or record
    std::vector<TypePtr> args;                     ///< operands; function: {argument, result}
    std::vector<long> sizes;                       ///< vector: {n}, matrix: {rows, columns}; -1 unknown
    bool numeric = false;  ///< variable: ?Number of a toolkit, which stands for nat, int or real
};

/// Returns the type as RoboChart writes it, e.g. "Seq(nat)", "nat * boolean".
[[nodiscard]] std::string to_string(const TypePtr&);
/// True if a value of type `from` may be used where `to` is expected: the relation compat(from, to) of the type
/// provider.
[[nodiscard]] bool is_compatible(const TypePtr& from, const TypePtr& to);

}  // namespace robochart::frontend
