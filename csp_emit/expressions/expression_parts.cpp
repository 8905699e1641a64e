// SPDX-License-Identifier: Apache-2.0
// Translates composed values. A vector is a tuple, and a matrix is a tuple of rows. The functions select and replace
// parts, and convert values between types that CSPM represents differently (semantics 3.13).
#include <algorithm>

#include "csp_emit/base/types.hpp"
#include "csp_emit/expressions/translator.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using ir::ExprKind;
using ir::TypeKind;
using Op = cspm::ExprKind;

namespace {

std::string part_name(std::size_t place) {
    return "part" + std::to_string(place + 1) + "__";
}

cspm::PatternPtr pattern_of(b::Patterns parts) {
    return parts.size() == 1 ? parts[0] : b::tuple_pattern(std::move(parts));
}

/// Returns the number if the index is a literal, or null otherwise.
const std::int64_t* literal_place(const ExprPtr& place) {
    return place->kind == Op::integer ? &place->number : nullptr;
}

/// Returns `if index__ == 1 then first else ...`. An index out of range has no value.
ExprPtr choose_by_index(const std::string& index, const b::Exprs& alternatives) {
    ExprPtr result = b::call("error", {b::string("index outside 1.." + std::to_string(alternatives.size()))});
    for (std::size_t i = alternatives.size(); i-- > 0;)
        result = b::if_(b::binary(Op::equal, b::name(index), b::number(static_cast<std::int64_t>(i) + 1)),
                        alternatives[i], result);
    return result;
}

}  // namespace

// ---------------------------------------------------------------- vectors and matrices

bool Translator::is_block(ir::TypeId id) const {
    const ir::Type* found = find_type(id);
    return found != nullptr && (found->kind == TypeKind::vector || found->kind == TypeKind::matrix);
}

Translator::Block Translator::block_shape(ir::TypeId id) const {
    const ir::Type& found = *find_type(id);
    const bool vector = found.kind == TypeKind::vector;
    return {static_cast<std::size_t>(found.sizes.at(0)), vector ? 1 : static_cast<std::size_t>(found.sizes.at(1)),
            vector};
}

ExprPtr Translator::entry_of_block(const std::string& prefix, std::size_t row, std::size_t column) {
    return b::name(prefix + std::to_string(row + 1) + "_" + std::to_string(column + 1) + "__");
}

cspm::PatternPtr Translator::block_pattern(const Block& block, const std::string& prefix) const {
    b::Patterns rows;
    for (std::size_t row = 0; row < block.rows; ++row) {
        b::Patterns columns;
        for (std::size_t column = 0; column < block.columns; ++column)
            columns.push_back(b::variable(entry_of_block(prefix, row, column)->text));
        rows.push_back(pattern_of(std::move(columns)));
    }
    return pattern_of(std::move(rows));
}

ExprPtr Translator::block_value(const Block& block, const b::Exprs& entries) const {
    b::Exprs rows;
    for (std::size_t row = 0; row < block.rows; ++row) {
        const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(row * block.columns);
        rows.push_back(tuple_or_one({begin, begin + static_cast<std::ptrdiff_t>(block.columns)}));
    }
    return tuple_or_one(rows);
}

ExprPtr Translator::block_literal(const ir::Expr& expr) const {
    const Block shape = block_shape(expr.type);
    if (expr.args.size() != shape.rows * shape.columns)
        return report_unsupported("a matrix of another size than its type", expr);
    return block_value(shape, translate_operands(expr));
}

/// Translates arithmetic entry by entry: sums, differences, negation, products with a number.
ExprPtr Translator::block_arithmetic(const ir::Expr& expr) const {
    const bool left_block = is_block(expr.args.at(0)->type);
    const bool binary = expr.args.size() > 1;
    const bool right_block = binary && is_block(expr.args[1]->type);
    const ir::TypeId number = is_block(expr.type) ? find_type(expr.type)->args.at(0) : expr.type;
    if (expr.kind == ExprKind::times && left_block && right_block)
        return block_product(expr, block_shape(expr.args[0]->type), block_shape(expr.args[1]->type), number);
    const Block shape = block_shape(expr.type);
    b::Patterns patterns{left_block ? block_pattern(shape, "left") : b::variable("left__")};
    if (binary) patterns.push_back(right_block ? block_pattern(shape, "right") : b::variable("right__"));
    b::Exprs entries;
    for (std::size_t row = 0; row < shape.rows; ++row)
        for (std::size_t column = 0; column < shape.columns; ++column) {
            b::Exprs operands{left_block ? entry_of_block("left", row, column) : b::name("left__")};
            if (binary) operands.push_back(right_block ? entry_of_block("right", row, column) : b::name("right__"));
            entries.push_back(clipped_operation(expr.kind, operands, number));
        }
    return b::apply(b::lambda(patterns, block_value(shape, entries)), translate_operands(expr));
}

/// Returns the product of two matrices, or the dot product of two vectors. Sums are computed from the left.
ExprPtr Translator::block_product(const ir::Expr& expr, const Block& left, const Block& right,
                                  ir::TypeId number) const {
    const bool dot = left.vector && right.vector;
    const std::size_t inner = dot ? left.rows : left.columns;
    if (inner != right.rows) return report_unsupported("a product of matrices whose sizes do not fit", expr);
    const auto at = [&](std::size_t row, std::size_t column) {
        ExprPtr sum;
        for (std::size_t i = 0; i < inner; ++i) {
            const ExprPtr factor = dot ? entry_of_block("left", i, 0) : entry_of_block("left", row, i);
            const ExprPtr term =
                clipped_operation(ExprKind::times, {factor, entry_of_block("right", i, column)}, number);
            sum = sum ? clipped_operation(ExprKind::plus, {sum, term}, number) : term;
        }
        return sum;
    };
    const b::Patterns patterns{block_pattern(left, "left"), block_pattern(right, "right")};
    if (dot) return b::apply(b::lambda(patterns, at(0, 0)), translate_operands(expr));
    const Block shape = block_shape(expr.type);
    b::Exprs entries;
    for (std::size_t row = 0; row < shape.rows; ++row)
        for (std::size_t column = 0; column < shape.columns; ++column) entries.push_back(at(row, column));
    return b::apply(b::lambda(patterns, block_value(shape, entries)), translate_operands(expr));
}

ExprPtr Translator::transpose_block(const ir::Expr& expr) const {
    const Block from = block_shape(expr.args.at(0)->type);
    const Block to = block_shape(expr.type);
    b::Exprs entries;
    for (std::size_t row = 0; row < to.rows; ++row)
        for (std::size_t column = 0; column < to.columns; ++column)
            entries.push_back(entry_of_block("left", column, row));
    return b::apply(b::lambda({block_pattern(from, "left")}, block_value(to, entries)), translate_operands(expr));
}

// ---------------------------------------------------------------- components

/// Selects one component of a tuple by a lambda with a tuple pattern.
ExprPtr Translator::tuple_part(const ExprPtr& whole, std::size_t size, std::size_t place) const {
    if (size == 1) return whole;
    b::Patterns parts;
    for (std::size_t i = 0; i < size; ++i) parts.push_back(i == place ? b::variable("part__") : b::wildcard());
    return b::apply(b::lambda({b::tuple_pattern(parts)}, b::name("part__")), {whole});
}

/// Returns an element of a sequence, vector or matrix, counted from 1.
ExprPtr Translator::index_value(ir::TypeId id, const ExprPtr& whole, const b::Exprs& places) const {
    if (!is_block(id)) return b::call("access_", {whole, places.at(0)});
    const Block shape = block_shape(id);
    b::Exprs rows;
    for (std::size_t row = 0; row < shape.rows; ++row) {
        b::Exprs columns;
        for (std::size_t column = 0; column < shape.columns; ++column)
            columns.push_back(entry_of_block("left", row, column));
        rows.push_back(shape.vector ? columns.at(0) : choose_by_index("index2__", columns));
    }
    b::Patterns patterns{block_pattern(shape, "left"), b::variable("index1__")};
    b::Exprs arguments{whole, places.at(0)};
    if (!shape.vector) {
        patterns.push_back(b::variable("index2__"));
        arguments.push_back(places.at(1));
    }
    if (const std::int64_t* fixed = literal_place(places[0]);
        fixed != nullptr && shape.vector && *fixed >= 1 && *fixed <= static_cast<std::int64_t>(shape.rows))
        return tuple_part(whole, shape.rows, static_cast<std::size_t>(*fixed - 1));
    return b::apply(b::lambda(patterns, choose_by_index("index1__", rows)), arguments);
}

ExprPtr Translator::replace_part(ir::TypeId id, const ExprPtr& whole, const b::Exprs& path, std::size_t from,
                                 const ExprPtr& value) const {
    if (from >= path.size()) return value;
    const ir::Type& found = *find_type(id);
    if (found.kind == TypeKind::record || found.kind == TypeKind::product)
        return replaced_field(found, whole, path, from, value);
    if (is_block(id)) return replaced_entry(id, whole, path, from, value);
    const ExprPtr old = b::call("access_", {whole, path[from]});
    return b::call("update_", {whole, replace_part(found.args.at(0), old, path, from + 1, value), path[from]});
}

/// Replaces a field of a record or a part of a tuple. Fields are counted from 0, and parts of tuples from 1.
ExprPtr Translator::replaced_field(const ir::Type& found, const ExprPtr& whole, const b::Exprs& path, std::size_t from,
                                   const ExprPtr& value) const {
    const std::int64_t number = path[from]->number - (found.kind == TypeKind::record ? 0 : 1);
    const auto place = static_cast<std::size_t>(number);
    if (found.args.size() == 1) return replace_part(found.args[0], whole, path, from + 1, value);
    b::Patterns patterns;
    b::Exprs parts;
    const bool last = from + 1 == path.size();
    for (std::size_t i = 0; i < found.args.size(); ++i) {
        patterns.push_back(i == place && last ? b::wildcard() : b::variable(part_name(i)));
        parts.push_back(b::name(part_name(i)));
    }
    parts.at(place) = replace_part(found.args[place], parts[place], path, from + 1, value);
    return b::apply(b::lambda({b::tuple_pattern(patterns)}, b::tuple(parts)), {whole});
}

/// Replaces the entry of a vector or matrix at the indices. The new entry is computed once. If the path continues
/// inside the entry, only that part of it changes.
ExprPtr Translator::replaced_entry(ir::TypeId id, const ExprPtr& whole, const b::Exprs& path, std::size_t from,
                                   const ExprPtr& value) const {
    const Block shape = block_shape(id);
    b::Exprs places{path[from]};
    if (!shape.vector) places.push_back(path.at(from + 1));
    const std::size_t rest = from + places.size();
    const ExprPtr old = rest < path.size() ? index_value(id, whole, places) : nullptr;
    const ExprPtr changed = replace_part(find_type(id)->args.at(0), old, path, rest, value);
    const auto here = [&](std::size_t row, std::size_t column) {
        const ExprPtr in_row = b::binary(Op::equal, b::name("index1__"), b::number(static_cast<std::int64_t>(row) + 1));
        if (shape.vector) return in_row;
        return b::binary(Op::logical_and, in_row,
                         b::binary(Op::equal, b::name("index2__"), b::number(static_cast<std::int64_t>(column) + 1)));
    };
    b::Exprs entries;
    b::Exprs anywhere;
    for (std::size_t row = 0; row < shape.rows; ++row)
        for (std::size_t column = 0; column < shape.columns; ++column) {
            entries.push_back(b::if_(here(row, column), b::name("elem__"), entry_of_block("left", row, column)));
            anywhere.push_back(here(row, column));
        }
    b::Patterns patterns{block_pattern(shape, "left"), b::variable("elem__"), b::variable("index1__")};
    if (!shape.vector) patterns.push_back(b::variable("index2__"));
    b::Exprs arguments{whole, changed};
    arguments.insert(arguments.end(), places.begin(), places.end());
    const ExprPtr outside = b::call("error", {b::string("index outside the vector or matrix")});
    return b::apply(b::lambda(patterns, b::if_(b::any_of(anywhere), block_value(shape, entries), outside)), arguments);
}

// ---------------------------------------------------------------- conversions

namespace {

/// The types of a tuple's parts; empty for other types.
std::vector<ir::TypeId> tuple_types(const ir::Type& type) {
    if (type.kind == TypeKind::product || type.kind == TypeKind::record) return type.args;
    if (type.kind == TypeKind::vector)
        return std::vector<ir::TypeId>(static_cast<std::size_t>(type.sizes.at(0)), type.args.at(0));
    return {};
}

}  // namespace

/// Returns the two types of a relation, function or set of pairs, or an empty result for other types.
std::vector<ir::TypeId> Translator::pair_types(const ir::Type& found) const {
    if (found.kind == TypeKind::relation || found.kind == TypeKind::function) return found.args;
    if (found.kind != TypeKind::set) return {};
    const auto parts = tuple_types(*find_type(found.args.at(0)));
    return parts.size() == 2 ? parts : std::vector<ir::TypeId>{};
}

bool Translator::written_differently(ir::TypeId from, ir::TypeId to) const {
    if (from == to || find_type(from) == nullptr || find_type(to) == nullptr) return false;
    const ir::Type& source = *find_type(from);
    const ir::Type& target = *find_type(to);
    if (is_numeric(source) && is_numeric(target)) return scale() != 1 && is_real(from) != is_real(to);
    if (source.kind == TypeKind::sequence && is_set_like(target.kind)) return true;
    std::vector<ir::TypeId> a = pair_types(source);
    std::vector<ir::TypeId> b = pair_types(target);
    if (a.empty() || b.empty()) {
        a = source.args;
        b = target.args;
        if (!tuple_types(source).empty() && !tuple_types(target).empty()) {
            a = tuple_types(source);
            b = tuple_types(target);
        }
    }
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (written_differently(a[i], b[i])) return true;
    return false;
}

bool Translator::narrows_numbers(ir::TypeId from, ir::TypeId to) const {
    if (!written_differently(from, to)) return false;
    if (is_numeric(*find_type(from))) return is_real(from);
    const std::vector<ir::TypeId>& source = find_type(from)->args;
    const std::vector<ir::TypeId>& target = find_type(to)->args;
    for (std::size_t i = 0; i < std::min(source.size(), target.size()); ++i)
        if (narrows_numbers(source[i], target[i])) return true;
    return false;
}

ExprPtr Translator::convert_value(const ExprPtr& value, ir::TypeId from, ir::TypeId to) const {
    if (!written_differently(from, to)) return value;
    const ir::Type& source = *find_type(from);
    const ir::Type& target = *find_type(to);
    if (is_numeric(source)) {
        if (!is_real(to)) return b::binary(Op::divide, value, b::number(scale()));
        if (value->kind == Op::integer) return b::number(value->number * scale());
        return b::binary(Op::times, value, b::number(scale()));
    }
    const bool collection = source.kind == TypeKind::sequence || is_set_like(source.kind);
    if (collection) return converted_elements(value, source, target);
    if (source.kind == TypeKind::matrix) {
        const Block shape = block_shape(from);
        b::Exprs entries;
        for (std::size_t row = 0; row < shape.rows; ++row)
            for (std::size_t column = 0; column < shape.columns; ++column)
                entries.push_back(
                    convert_value(entry_of_block("left", row, column), source.args[0], target.args.at(0)));
        return b::apply(b::lambda({block_pattern(shape, "left")}, block_value(shape, entries)), {value});
    }
    return converted_tuple(value, tuple_types(source), tuple_types(target));
}

ExprPtr Translator::converted_tuple(const ExprPtr& value, const std::vector<ir::TypeId>& from,
                                    const std::vector<ir::TypeId>& to) const {
    if (from.size() != to.size() || from.empty()) return value;
    b::Patterns patterns;
    b::Exprs parts;
    for (std::size_t i = 0; i < from.size(); ++i) {
        patterns.push_back(b::variable(part_name(i)));
        parts.push_back(convert_value(b::name(part_name(i)), from[i], to[i]));
    }
    return b::apply(b::lambda({pattern_of(patterns)}, tuple_or_one(parts)), {value});
}

/// Converts each element. A sequence that is used as a set becomes the set of its pairs of index and element.
ExprPtr Translator::converted_elements(const ExprPtr& value, const ir::Type& source, const ir::Type& target) const {
    const ExprPtr elem = b::name("elem__");
    if (source.kind == TypeKind::sequence && target.kind == TypeKind::sequence)
        return b::sequence_comprehension({convert_value(elem, source.args.at(0), target.args.at(0))},
                                         {b::generator("elem__", value)});
    const auto to = pair_types(target);
    if (source.kind == TypeKind::sequence) {
        const ExprPtr pairs = b::call("pairs_", {value});
        if (to.empty() || (!written_differently(source.args.at(0), to[1]) && !(scale() != 1 && is_real(to[0]))))
            return pairs;
        ExprPtr place = b::name("part1__");
        if (scale() != 1 && is_real(to[0])) place = b::binary(Op::times, place, b::number(scale()));
        return b::set_comprehension(
            {b::tuple({place, convert_value(b::name("part2__"), source.args[0], to[1])})},
            {b::generator(b::tuple_pattern({b::variable("part1__"), b::variable("part2__")}), pairs)});
    }
    const auto from = pair_types(source);
    if (!from.empty() && !to.empty())
        return b::set_comprehension(
            {b::tuple({convert_value(b::name("part1__"), from[0], to[0]),
                       convert_value(b::name("part2__"), from[1], to[1])})},
            {b::generator(b::tuple_pattern({b::variable("part1__"), b::variable("part2__")}), value)});
    return b::set_comprehension({convert_value(elem, source.args.at(0), target.args.at(0))},
                                {b::generator("elem__", value)});
}

}  // namespace robochart::csp_emit
