// SPDX-License-Identifier: Apache-2.0
// Constructs and accesses composed values. evaluate.hpp states how they are represented.
#include "semantics/evaluate/evaluate_composed.hpp"

#include <algorithm>

#include "base/diagnostics/containers.hpp"
#include "semantics/ir/arithmetic.hpp"

namespace robochart::ir {
namespace {
constexpr std::int64_t longest_range = 1 << 20;
}

std::strong_ordering operator<=>(const Value& left, const Value& right) {
    if (left.number != right.number) return left.number <=> right.number;
    const std::size_t common = std::min(left.parts.size(), right.parts.size());
    for (std::size_t i = 0; i < common; ++i)
        if (const auto order = left.parts[i] <=> right.parts[i]; order != 0) return order;
    return left.parts.size() <=> right.parts.size();
}

bool operator==(const Value& left, const Value& right) {
    return (left <=> right) == 0;
}

Value set_of(std::vector<Value> members) {
    diagnostics::sort_unique(members);
    return {0, std::move(members)};
}

Value matrix_of(std::vector<Value> elements, std::int64_t columns) {
    Value matrix;
    const auto width = static_cast<std::size_t>(std::max<std::int64_t>(columns, 1));
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (i % width == 0) matrix.parts.emplace_back();
        matrix.parts.back().parts.push_back(std::move(elements[i]));
    }
    return matrix;
}

Value range_set(std::int64_t low, std::int64_t high, diagnostics::Span where) {
    Value set;
    if (low > high) return set;
    const auto span = checked_subtract(high, low);
    if (!span || *span >= longest_range) throw EvaluationFault("the range has too many members", where);
    for (std::int64_t offset = 0; offset <= *span; ++offset) set.parts.push_back({low + offset, {}});
    return set;
}

Value pairs_of(const Value& sequence) {
    Value pairs;
    for (const Value& item : sequence.parts)
        pairs.parts.push_back({0, {{static_cast<std::int64_t>(pairs.parts.size()) + 1, {}}, item}});
    return pairs;
}

Value string_value(const diagnostics::ForeignText& text) {
    Value result;
    for (const char c : text.unescaped()) result.parts.push_back({static_cast<unsigned char>(c), {}});
    return result;
}

Value part_at(const Value& whole, std::int64_t place, diagnostics::Span where) {
    if (place < 1 || static_cast<std::uint64_t>(place) > whole.parts.size())
        throw EvaluationFault("index " + std::to_string(place) + " is outside 1.." + std::to_string(whole.parts.size()),
                              where);
    return whole.parts[static_cast<std::size_t>(place - 1)];
}

Value apply_function(const Value& function, const std::vector<Value>& arguments, diagnostics::Span where) {
    const Value argument = arguments.size() == 1 ? arguments.front() : Value{0, arguments};
    for (const Value& pair : function.parts)
        if (pair.parts.size() == 2 && pair.parts[0] == argument) return pair.parts[1];
    throw EvaluationFault("the function is not defined for this argument", where);
}

bool is_part(const Value& whole, const Value& item) {
    return std::ranges::find(whole.parts, item) != whole.parts.end();
}

Value bound_tuple(const std::vector<std::pair<std::string, Value>>& bindings, std::size_t from) {
    if (bindings.size() == from + 1) return bindings[from].second;
    Value tuple;
    for (std::size_t i = from; i < bindings.size(); ++i) tuple.parts.push_back(bindings[i].second);
    return tuple;
}

}  // namespace robochart::ir
