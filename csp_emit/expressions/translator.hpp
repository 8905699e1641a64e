// SPDX-License-Identifier: Apache-2.0
// Declares the class that implements expressions.hpp. It has one member function for each family of ir::ExprKind, in
// three sources. Private to csp_emit. Its templates bind only names that end in `__`. These names are reserved
// (names.cpp), so an expression inserted into a template never contains them as free names.
#pragma once

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/expressions/expressions.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

class Translator {
public:
    Translator(const Project& project, const Scope& scope) : project_(project), scope_(scope) {}

    cspm::ExprPtr translate(const ir::Expr& expr) const;
    cspm::ExprPtr as_type(const ir::Expr& expr, ir::TypeId type) const;
    cspm::build::Exprs preconditions(const ir::Expr& expr) const;
    /// Returns `whole` with the part at `path[from..]` replaced by `value`.
    cspm::ExprPtr replace_part(ir::TypeId type, const cspm::ExprPtr& whole, const cspm::build::Exprs& path,
                               std::size_t from, const cspm::ExprPtr& value) const;
    /// True if the conversion would turn reals into whole numbers, which is undefined for some reals.
    bool narrows_numbers(ir::TypeId from, ir::TypeId to) const;
    cspm::ExprPtr convert_value(const cspm::ExprPtr& value, ir::TypeId from, ir::TypeId to) const;

private:
    using ExprPtr = cspm::ExprPtr;
    using Exprs = cspm::build::Exprs;

    const ir::Type* find_type(ir::TypeId id) const { return id.is_valid() ? &project_.system.type(id) : nullptr; }
    bool is_real(ir::TypeId id) const { return id.is_valid() && project_.system.type(id).kind == ir::TypeKind::real; }
    bool is_whole(ir::TypeId id) const;
    std::int64_t scale() const { return project_.instantiation.scale; }

    // expressions.cpp
    ExprPtr translate_operand(const ir::Expr& expr, std::size_t index) const { return translate(*expr.args.at(index)); }
    Exprs translate_operands(const ir::Expr& expr) const;
    ExprPtr enum_literal(const ir::Expr& expr) const;
    ExprPtr real_literal(const ir::Expr& expr) const;
    ExprPtr trigger_value(const ir::Expr& expr) const;
    ExprPtr translate_comparison(const ir::Expr& expr, cspm::ExprKind op) const;
    ExprPtr clipped_operation(ir::ExprKind kind, Exprs operands, ir::TypeId type) const;
    ExprPtr translate_arithmetic(const ir::Expr& expr) const;
    ExprPtr translate_member(const ir::Expr& expr) const;
    ExprPtr translate_index(const ir::Expr& expr) const;
    ExprPtr translate_cast(const ir::Expr& expr) const;
    ExprPtr type_test(const ir::Expr& expr) const;
    ExprPtr translate_range(const ir::Expr& expr) const;
    ExprPtr translate_call(const ir::Expr& expr) const;
    bool is_open(ir::TypeId id) const;  ///< whether a part of the type is unknown
    ExprPtr translate_toolkit_call(const ir::Expr& expr) const;
    ExprPtr translate_application(const ir::Expr& expr) const;
    ExprPtr function_value(const ir::Expr& expr) const;
    std::vector<cspm::Clause> satisfying_clauses(const ir::Expr& expr) const;
    ExprPtr witness_set(const ir::Expr& expr, bool negated) const;
    ExprPtr translate_comprehension(const ir::Expr& expr) const;
    ExprPtr translate_lambda(const ir::Expr& expr) const;
    ExprPtr translate_let(const ir::Expr& expr) const;
    ExprPtr bind_let(const ir::Expr& expr, std::size_t count, ExprPtr body) const;
    Exprs call_arguments(const ir::Expr& expr) const;
    std::vector<cspm::Clause> make_generators(const ir::Expr& expr) const;
    static ExprPtr bound_tuple(const ir::Expr& expr);
    Exprs bound_preconditions(const ir::Expr& expr) const;  // expression_conditions.cpp
    ExprPtr report_unsupported(const std::string& what, const ir::Expr& expr) const;

    // expression_parts.cpp: components of values, conversions between types
    struct Block {  ///< size of a matrix, or of a vector as one column
        std::size_t rows = 0, columns = 0;
        bool vector = false;
    };
    bool is_block(ir::TypeId id) const;
    Block block_shape(ir::TypeId id) const;
    cspm::PatternPtr block_pattern(const Block& block, const std::string& prefix) const;
    ExprPtr block_value(const Block& block, const Exprs& entries) const;
    static ExprPtr entry_of_block(const std::string& prefix, std::size_t row, std::size_t column);
    ExprPtr block_literal(const ir::Expr& expr) const;
    ExprPtr block_arithmetic(const ir::Expr& expr) const;
    ExprPtr block_product(const ir::Expr& expr, const Block& left, const Block& right, ir::TypeId number) const;
    ExprPtr transpose_block(const ir::Expr& expr) const;
    ExprPtr tuple_part(const ExprPtr& whole, std::size_t size, std::size_t place) const;
    ExprPtr index_value(ir::TypeId type, const ExprPtr& whole, const Exprs& places) const;
    ExprPtr replaced_field(const ir::Type& type, const ExprPtr& whole, const Exprs& path, std::size_t from,
                           const ExprPtr& value) const;
    ExprPtr replaced_entry(ir::TypeId type, const ExprPtr& whole, const Exprs& path, std::size_t from,
                           const ExprPtr& value) const;
    bool written_differently(ir::TypeId from, ir::TypeId to) const;
    ExprPtr converted_elements(const ExprPtr& value, const ir::Type& from, const ir::Type& to) const;
    ExprPtr converted_tuple(const ExprPtr& value, const std::vector<ir::TypeId>& from,
                            const std::vector<ir::TypeId>& to) const;
    std::vector<ir::TypeId> pair_types(const ir::Type& type) const;

    const Project& project_;
    const Scope& scope_;
};

}  // namespace robochart::csp_emit
