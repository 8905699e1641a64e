// SPDX-License-Identifier: Apache-2.0
// Computes the finite carriers of types, default values and membership in carriers (semantics 3.6, 3.13).
#include <algorithm>
#include <stdexcept>

#include "semantics/evaluate/carrier.hpp"
#include "semantics/evaluate/environment.hpp"
#include "semantics/evaluate/evaluate_composed.hpp"
#include "semantics/ir/instantiation.hpp"

namespace robochart::ir {
namespace {

using Values = std::vector<Value>;

class Carriers {
public:
    Carriers(const System& system, const Instantiation& instantiation, std::size_t limit)
        : system_(system), instantiation_(instantiation), limit_(limit) {}

    Values values_of(TypeId id);

private:
    [[nodiscard]] Values number_values(const std::vector<std::int64_t>& set) const;
    [[nodiscard]] Values values_up_to(std::int64_t count) const;
    Values enumeration_values(const Type& type);
    Values all_tuples(const std::vector<Values>& columns) const;
    Values columns_of(const std::vector<TypeId>& types);
    Values sequence_values(TypeId element);
    [[nodiscard]] Values all_subsets(const Values& base) const;
    Values function_values(const Type& type);
    Values repeated_tuples(const Values& base, std::size_t count) const;
    void check(std::size_t count) const {
        if (count > limit_) throw std::length_error("the type has more than " + std::to_string(limit_) + " values");
    }

    const System& system_;
    const Instantiation& instantiation_;
    std::size_t limit_;
};

Values Carriers::number_values(const std::vector<std::int64_t>& set) const {
    check(set.size());
    Values values;
    for (const auto number : set) values.push_back({number, {}});
    return values;
}

Values Carriers::values_up_to(std::int64_t count) const {
    Values values;
    for (std::int64_t i = 0; i < count; ++i) values.push_back({i, {}});
    return values;
}

/// Returns all tuples with one component from each column, in lexicographic order.
Values Carriers::all_tuples(const std::vector<Values>& columns) const {
    Values result{{}};
    for (const auto& column : columns) {
        Values longer;
        check(column.empty() ? 0 : result.size() * column.size());
        for (const auto& prefix : result)
            for (const auto& item : column) {
                instantiation_.poll();
                longer.push_back(prefix);
                longer.back().parts.push_back(item);
            }
        result = std::move(longer);
    }
    return result;
}

Values Carriers::columns_of(const std::vector<TypeId>& types) {
    std::vector<Values> columns;
    for (const auto type : types) columns.push_back(values_of(type));
    return all_tuples(columns);
}

Values Carriers::enumeration_values(const Type& type) {
    Values values;
    for (std::size_t i = 0; i < type.labels.size(); ++i) {
        const bool plain = i >= type.literal_args.size();
        for (Value literal : columns_of(plain ? std::vector<TypeId>{} : type.literal_args[i])) {
            literal.number = static_cast<std::int64_t>(i);
            values.push_back(std::move(literal));
            check(values.size());
        }
    }
    return values;
}

Values Carriers::sequence_values(TypeId element) {
    const Values items = values_of(element);
    Values all;
    for (std::int64_t length = 0; length <= instantiation_.sequence_bound; ++length) {
        const Values more = repeated_tuples(items, static_cast<std::size_t>(length));
        all.insert(all.end(), more.begin(), more.end());
        check(all.size());
    }
    std::ranges::sort(all);
    return all;
}

Values Carriers::repeated_tuples(const Values& base, std::size_t count) const {
    return all_tuples(std::vector<Values>(count, base));
}

/// Returns all subsets of `base`, which is ascending and has no duplicates.
Values Carriers::all_subsets(const Values& base) const {
    Values result{{}};
    for (const auto& item : base) {
        check(result.size() * 2);
        const std::size_t half = result.size();
        for (std::size_t i = 0; i < half; ++i) {
            instantiation_.poll();
            result.push_back(result[i]);
            result.back().parts.push_back(item);
        }
    }
    std::ranges::sort(result);
    return result;
}

/// Returns all total functions, as sets of pairs (RoboTool's Function(A, B)).
Values Carriers::function_values(const Type& type) {
    const Values domain = values_of(type.args.at(0));
    Values result = repeated_tuples(values_of(type.args.at(1)), domain.size());
    for (Value& images : result)
        for (std::size_t i = 0; i < domain.size(); ++i) images.parts[i] = {0, {domain[i], images.parts[i]}};
    return result;
}

Values Carriers::values_of(TypeId id) {
    instantiation_.poll();
    const auto few = instantiation_.representatives.find(id.index);
    if (few != instantiation_.representatives.end()) return few->second;
    const Type& type = system_.types.at(id.index);
    switch (type.kind) {
        case TypeKind::boolean:
            return values_up_to(2);
        case TypeKind::nat:
            return number_values(instantiation_.nat);
        case TypeKind::integer:
            return number_values(instantiation_.integer);
        case TypeKind::real:
            return number_values(instantiation_.real);
        case TypeKind::enumeration:
            return enumeration_values(type);
        case TypeKind::given:
            return values_up_to(instantiation_.given_size);
        case TypeKind::sequence:
            return sequence_values(type.args.at(0));
        case TypeKind::set:
            return all_subsets(values_of(type.args.at(0)));
        case TypeKind::product:
        case TypeKind::record:
            return columns_of(type.args);
        case TypeKind::function:
            return function_values(type);
        case TypeKind::relation:
            return all_subsets(columns_of(type.args));
        case TypeKind::vector:
            return repeated_tuples(values_of(type.args.at(0)), static_cast<std::size_t>(type.sizes.at(0)));
        case TypeKind::matrix: {
            const Values row = repeated_tuples(values_of(type.args.at(0)), static_cast<std::size_t>(type.sizes.at(1)));
            return repeated_tuples(row, static_cast<std::size_t>(type.sizes.at(0)));
        }
        case TypeKind::unit:
            return {{}};
        case TypeKind::string: {
            Values values;
            for (const diagnostics::ForeignText& text : instantiation_.strings) values.push_back(string_value(text));
            return values;
        }
    }
    throw std::length_error("type " + type.name + " has no finite carrier");
}

bool contains_number(const std::vector<std::int64_t>& set, const Value& value) {
    return std::ranges::binary_search(set, value.number);
}

bool all_in(const System& system, const Instantiation& instantiation, const std::vector<TypeId>& types,
            const Value& value) {
    if (types.size() != value.parts.size()) return false;
    for (std::size_t i = 0; i < types.size(); ++i)
        if (!in_carrier(system, instantiation, types[i], value.parts[i])) return false;
    return true;
}

bool each_in(const System& system, const Instantiation& instantiation, TypeId element, const Value& value) {
    return std::ranges::all_of(value.parts,
                               [&](const Value& part) { return in_carrier(system, instantiation, element, part); });
}

bool has_literal(const System& system, const Instantiation& instantiation, const Type& type, const Value& value) {
    if (value.number < 0 || value.number >= static_cast<std::int64_t>(type.labels.size())) return false;
    const auto index = static_cast<std::size_t>(value.number);
    return index >= type.literal_args.size() ? value.parts.empty()
                                             : all_in(system, instantiation, type.literal_args[index], value);
}

bool pairs_in(const System& system, const Instantiation& instantiation, const Type& type, const Value& value) {
    return std::ranges::all_of(value.parts,
                               [&](const Value& pair) { return all_in(system, instantiation, type.args, pair); });
}

bool rows_in(const System& system, const Instantiation& instantiation, const Type& type, const Value& value) {
    return static_cast<std::int64_t>(value.parts.size()) == type.sizes.at(0) &&
           std::ranges::all_of(value.parts, [&](const Value& row) {
               return static_cast<std::int64_t>(row.parts.size()) == type.sizes.at(1) &&
                      each_in(system, instantiation, type.args.at(0), row);
           });
}

/// Returns a vector of `count` components that are all equal to `item`.
Value filled_vector(std::int64_t count, const Value& item) {
    return {0, Values(static_cast<std::size_t>(std::max<std::int64_t>(count, 0)), item)};
}

}  // namespace

bool in_carrier(const System& system, const Instantiation& instantiation, TypeId id, const Value& value) {
    instantiation.poll();
    const auto few = instantiation.representatives.find(id.index);
    if (few != instantiation.representatives.end()) return std::ranges::binary_search(few->second, value);
    const Type& type = system.types.at(id.index);
    switch (type.kind) {
        case TypeKind::boolean:
            return value.number == 0 || value.number == 1;
        case TypeKind::nat:
            return instantiation.unbounded ? value.number >= 0 : contains_number(instantiation.nat, value);
        case TypeKind::integer:
            return instantiation.unbounded || contains_number(instantiation.integer, value);
        case TypeKind::real:
            return instantiation.unbounded || contains_number(instantiation.real, value);
        case TypeKind::enumeration:
            return has_literal(system, instantiation, type, value);
        case TypeKind::given:
            return value.number >= 0 && value.number < instantiation.given_size;
        case TypeKind::sequence:
            return static_cast<std::int64_t>(value.parts.size()) <= instantiation.sequence_bound &&
                   each_in(system, instantiation, type.args.at(0), value);
        case TypeKind::set:
            return each_in(system, instantiation, type.args.at(0), value);
        case TypeKind::product:
        case TypeKind::record:
            return all_in(system, instantiation, type.args, value);
        case TypeKind::function:
        case TypeKind::relation:
            return pairs_in(system, instantiation, type, value);
        case TypeKind::vector:
            return static_cast<std::int64_t>(value.parts.size()) == type.sizes.at(0) &&
                   each_in(system, instantiation, type.args.at(0), value);
        case TypeKind::matrix:
            return rows_in(system, instantiation, type, value);
        case TypeKind::unit:
            return value == Value{};
        case TypeKind::string:
            return std::ranges::any_of(instantiation.strings, [&](const diagnostics::ForeignText& text) {
                return string_value(text) == value;
            });
    }
    return false;
}

std::vector<Value> carrier_values(const System& system, const Instantiation& instantiation, TypeId type,
                                  std::size_t limit) {
    return Carriers(system, instantiation, limit).values_of(type);
}

Value default_value(const System& system, const Instantiation& instantiation, TypeId id) {
    instantiation.poll();
    const Type& type = system.types.at(id.index);
    Value value;
    switch (type.kind) {
        case TypeKind::boolean:
            return {1, {}};
        case TypeKind::enumeration:
            if (!type.literal_args.empty())
                for (const auto arg : type.literal_args.front())
                    value.parts.push_back(default_value(system, instantiation, arg));
            return value;
        case TypeKind::product:
        case TypeKind::record:
            for (const auto arg : type.args) value.parts.push_back(default_value(system, instantiation, arg));
            return value;
        case TypeKind::vector:
            return filled_vector(type.sizes.at(0), default_value(system, instantiation, type.args.at(0)));
        case TypeKind::matrix:
            return filled_vector(type.sizes.at(0), filled_vector(type.sizes.at(1), default_value(system, instantiation,
                                                                                                 type.args.at(0))));
        case TypeKind::function: {
            // The default value of a total function maps every argument to the default value of the result type.
            const Value image = default_value(system, instantiation, type.args.at(1));
            for (const Value& argument : carrier_values(system, instantiation, type.args.at(0)))
                value.parts.push_back({0, {argument, image}});
            return value;
        }
        case TypeKind::nat:
        case TypeKind::integer:
        case TypeKind::real:
        case TypeKind::string:
        case TypeKind::given:
        case TypeKind::sequence:
        case TypeKind::set:
        case TypeKind::relation:
        case TypeKind::unit:
            break;
    }
    return value;
}

}  // namespace robochart::ir
