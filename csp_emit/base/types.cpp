// SPDX-License-Identifier: Apache-2.0
// Writes carriers and values. Basic types are named sets of the instantiation. Composed types are constructed from
// their parts (semantics 3.13: records, products and vectors are tuples, functions are sets of pairs).
#include "csp_emit/base/types.hpp"

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/names.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using ir::TypeKind;

namespace {

/// Returns `{(x1__,x2__) | x1__ <- A, x2__ <- B}`, or a single set unchanged.
ExprPtr tuples_of(const std::vector<ExprPtr>& sets) {
    if (sets.size() == 1) return sets[0];
    b::Exprs parts;
    std::vector<cspm::Clause> clauses;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const std::string variable = "x" + std::to_string(i + 1) + "__";
        parts.push_back(b::name(variable));
        clauses.push_back(b::generator(variable, sets[i]));
    }
    return b::set_comprehension({b::tuple(parts)}, clauses);
}

ExprPtr composed_set(const Project& project, const ir::Type& type) {
    std::vector<ExprPtr> args;
    for (const ir::TypeId arg : type.args) args.push_back(type_set(project, arg));
    switch (type.kind) {
        case TypeKind::sequence:
            return b::call("LSeq", {args.at(0), b::number(project.instantiation.sequence_bound)});
        case TypeKind::set:
            return b::call("Set", {args.at(0)});
        case TypeKind::function:
            return b::call("Function", args);
        case TypeKind::relation:
            return b::call("Relation", args);
        case TypeKind::vector:
            return tuples_of(std::vector<ExprPtr>(static_cast<std::size_t>(type.sizes.at(0)), args.at(0)));
        case TypeKind::matrix: {
            const auto rows = static_cast<std::size_t>(type.sizes.at(0));
            const auto columns = static_cast<std::size_t>(type.sizes.at(1));
            return tuples_of(std::vector<ExprPtr>(rows, tuples_of(std::vector<ExprPtr>(columns, args.at(0)))));
        }
        case TypeKind::boolean:
        case TypeKind::nat:
        case TypeKind::integer:
        case TypeKind::real:
        case TypeKind::string:
        case TypeKind::enumeration:
        case TypeKind::given:
        case TypeKind::product:
        case TypeKind::record:
        case TypeKind::unit:
            break;
    }
    return tuples_of(args);
}

ExprPtr string_literal(const ir::Value& value) {
    std::string text;
    for (const ir::Value& part : value.parts) text += static_cast<char>(part.number);
    return b::string(text);
}

b::Exprs part_literals(const Project& project, const ir::Type& type, const ir::Value& value) {
    b::Exprs parts;
    for (std::size_t i = 0; i < value.parts.size(); ++i)
        parts.push_back(value_literal(project, type.args.at(type.args.size() > 1 ? i : 0), value.parts[i]));
    return parts;
}

/// Returns the set of pairs of a function or relation.
ExprPtr pairs_literal(const Project& project, const ir::Type& type, const ir::Value& value) {
    b::Exprs pairs;
    for (const ir::Value& pair : value.parts) pairs.push_back(b::tuple(part_literals(project, type, pair)));
    return b::set(pairs);
}

ExprPtr enumeration_literal(const Project& project, const ir::Type& type, const ir::Value& value) {
    const auto index = static_cast<std::size_t>(value.number);
    b::Exprs parts{b::name(literal_name(type, index))};
    for (std::size_t i = 0; i < value.parts.size(); ++i)
        parts.push_back(value_literal(project, type.literal_args.at(index).at(i), value.parts[i]));
    return b::dot(parts);
}

}  // namespace

ExprPtr tuple_or_one(const std::vector<ExprPtr>& parts) {
    return parts.size() == 1 ? parts[0] : b::tuple(parts);
}

bool is_numeric(const ir::Type& type) {
    return type.kind == TypeKind::nat || type.kind == TypeKind::integer || type.kind == TypeKind::real;
}

std::string type_name(const ir::Type& type) {
    return type.package.empty() ? type.name : flatten_name(type.package) + "_" + type.name;
}

std::string literal_name(const ir::Type& type, std::size_t literal) {
    return type_name(type) + "_" + type.labels.at(literal);
}

ExprPtr type_set(const Project& project, ir::TypeId id) {
    const ir::Type& type = project.system.type(id);
    const auto few = project.instantiation.representatives.find(id.index);
    if (few != project.instantiation.representatives.end()) {
        b::Exprs values;
        for (const ir::Value& value : few->second) values.push_back(value_literal(project, id, value));
        return b::set(values);
    }
    switch (type.kind) {
        case TypeKind::boolean:
            return b::name("core_boolean");
        case TypeKind::nat:
            return b::name("core_nat");
        case TypeKind::integer:
            return b::name("core_int");
        case TypeKind::real:
            return b::name("core_real");
        case TypeKind::string:
            return b::name("core_string");
        case TypeKind::enumeration:
        case TypeKind::given:
            return b::name(type_name(type));
        case TypeKind::unit:
            return b::set({b::number(0)});
        case TypeKind::sequence:
        case TypeKind::set:
        case TypeKind::product:
        case TypeKind::record:
        case TypeKind::function:
        case TypeKind::relation:
        case TypeKind::vector:
        case TypeKind::matrix:
            break;
    }
    return composed_set(project, type);
}

ExprPtr value_literal(const Project& project, ir::TypeId id, const ir::Value& value) {
    const ir::Type& type = project.system.type(id);
    switch (type.kind) {
        case TypeKind::boolean:
            return b::boolean(value.number != 0);
        case TypeKind::enumeration:
            return enumeration_literal(project, type, value);
        case TypeKind::sequence:
            return b::sequence(part_literals(project, type, value));
        case TypeKind::string:
            return string_literal(value);
        case TypeKind::matrix: {
            b::Exprs rows;
            for (const ir::Value& row : value.parts) rows.push_back(tuple_or_one(part_literals(project, type, row)));
            return tuple_or_one(rows);
        }
        case TypeKind::set:
            return b::set(part_literals(project, type, value));
        case TypeKind::function:
        case TypeKind::relation:
            return pairs_literal(project, type, value);
        case TypeKind::product:
        case TypeKind::record:
        case TypeKind::vector:
            return tuple_or_one(part_literals(project, type, value));
        case TypeKind::nat:
        case TypeKind::integer:
        case TypeKind::real:
        case TypeKind::given:
        case TypeKind::unit:
            break;
    }
    return b::number(value.number);
}

ExprPtr default_literal(const Project& project, ir::TypeId type) {
    return value_literal(project, type, ir::default_value(project.system, project.instantiation, type));
}

}  // namespace robochart::csp_emit
