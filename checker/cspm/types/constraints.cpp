// SPDX-License-Identifier: Apache-2.0
// Decides which types satisfy which constraint (FDR manual, "Type system", type constraints). Instantiates schemes.
#include <algorithm>
#include <optional>

#include "checker/cspm/types/rules.hpp"
#include "checker/cspm/types/unify.hpp"

namespace robochart::cspm::types {

namespace {

bool is_implied(Constraint constraint, Constraints held) {
    return (held & constraint) != 0 || (constraint == can_collect && (held & can_equal) != 0);
}

std::string in_words(Constraint constraint) {
    switch (constraint) {
        case can_equal:
            return "cannot be compared for equality";
        case can_order:
            return "cannot be ordered";
        case can_input:
            return "cannot be a field of a channel or datatype, or be input";
        case can_collect:
            return "cannot be an element of a set";
        case can_yield:
            return "is not an event or a value of a datatype, with or without its last fields";
    }
    return "";
}

}  // namespace

void Unifier::constrain_all(Constraints constraints, TypeId type) {
    for (const Constraint constraint : {can_equal, can_order, can_input, can_collect, can_yield}) {
        if ((constraints & constraint) != 0) constrain(constraint, type);
    }
}

void Unifier::fail_constraint(Constraint constraint, TypeId type) {
    TypeWriter writer(store_);
    const TypeId outer = constrained_.empty() ? type : constrained_.front();
    TypeFault fault{
        &rules::lacks_constraint, {writer.type_text(type_to_display(type)), in_words(constraint)}, {}, here_};
    if (store_.head(outer) != store_.head(type)) {
        fault.notes.push_back({here_, "it is a part of " + writer.type_text(type_to_display(outer))});
    }
    if (has_kind(type, TypeKind::variable)) {
        const std::string name = writer.type_text(type);
        fault.notes.push_back({here_, "the annotation says that '" + name + "' is any type; write `" +
                                          constraint_name(constraint) + " " + name + " => ...`"});
    }
    throw TypeFault(std::move(fault));
}

void Unifier::constrain(Constraint constraint, TypeId type) {
    const TypeStore::Depth guard(store_);
    type = store_.head(type);
    constrained_.push_back(type);
    try {
        if (has_kind(type, TypeKind::variable)) {
            constrain_variable(constraint, type);
        } else if (!constrain_parts(constraint, type)) {
            fail_constraint(constraint, type);
        }
    } catch (...) {
        constrained_.pop_back();
        throw;
    }
    constrained_.pop_back();
}

void Unifier::constrain_variable(Constraint constraint, TypeId variable) {
    if (is_implied(constraint, store_.node(variable).constraints)) return;
    if (store_.node(variable).rigid) fail_constraint(constraint, variable);
    store_.constrain(variable, constraint);
}

// Returns true if a type with this constructor can satisfy the constraint. Imposes the constraint on its parts.
bool Unifier::constrain_parts(Constraint constraint, TypeId type) {
    const TypeNode node = store_.node(type);
    const auto all = [&](Constraint required) {
        for (const TypeId argument : store_.arguments(type)) constrain(required, argument);
        return true;
    };
    switch (node.kind) {
        case TypeKind::extendable:
            if (constraint == can_input) constrain(constraint, store_.argument(type, 0));
            if (constraint == can_input || constraint == can_yield) {
                set_arguments(store_.argument(type, 1), store_.atom(TypeKind::complete));
            }
            return constraint != can_order;
        case TypeKind::dot: {
            if (constraint != can_input && constraint != can_yield) return constraint != can_order && all(constraint);
            const TypeId evaluated = evaluate_dots(type);
            if (!has_kind(evaluated, TypeKind::dot)) {
                constrain(constraint, evaluated);
                return true;
            }
            if (constraint == can_yield) return false;
            for (const TypeId part : store_.dot_parts(evaluated)) constrain(constraint, part);
            return true;
        }
        case TypeKind::datatype:
            if (constraint == can_equal) return store_.is_comparable(node.first);
            return constraint != can_order;
        case TypeKind::event:
            return constraint != can_order;
        case TypeKind::process:
            return constraint == can_collect || constraint == can_input;
        case TypeKind::integer:
        case TypeKind::character:
            return constraint != can_yield;
        case TypeKind::boolean:
            return constraint != can_yield && constraint != can_order;
        case TypeKind::sequence:
        case TypeKind::set:
            // Sequences are ordered by prefix and sets by inclusion, so only equality of elements is needed.
            if (constraint == can_yield) return false;
            return constraint == can_input || all(constraint == can_order ? can_equal : constraint);
        case TypeKind::tuple:
        case TypeKind::map:
            if (constraint == can_yield) return false;
            return constraint == can_input || all(constraint);
        case TypeKind::dotable:
            return (constraint == can_equal || constraint == can_collect) && all(constraint);
        case TypeKind::variable:
        case TypeKind::function:
        case TypeKind::complete:
            break;
    }
    return false;
}

// ---------------------------------------------------------------- schemes

namespace {

using Replacements = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

std::optional<std::uint32_t> replacement(const Replacements& sorted, std::uint32_t key) {
    const auto found = std::ranges::lower_bound(sorted, key, {}, &Replacements::value_type::first);
    if (found == sorted.end() || found->first != key) return std::nullopt;
    return found->second;
}

}  // namespace

TypeId Unifier::instantiate(const Scheme& scheme) {
    if (scheme.quantified.empty()) return scheme.type;
    std::vector<std::pair<TypeId, TypeId>> variables;
    for (const TypeId variable : scheme.quantified) {
        store_.count_step();
        variables.emplace_back(variable, store_.fresh_variable(store_.node(variable).constraints));
    }
    std::ranges::sort(variables);
    return copy_type(scheme.type, variables, {});
}

TypeId Unifier::copy_type(TypeId type, const std::vector<std::pair<TypeId, TypeId>>& variables,
                          const std::vector<std::pair<std::uint32_t, std::uint32_t>>& datatypes) {
    const TypeStore::Depth guard(store_);
    type = store_.head(type);
    const TypeNode node = store_.node(type);
    if (node.closed && datatypes.empty()) return type;
    if (node.kind == TypeKind::variable) {
        return replacement(variables, type).value_or(type);
    }
    if (node.kind == TypeKind::datatype) {
        const auto found = replacement(datatypes, node.first);
        return found ? store_.datatype(*found) : type;
    }
    const Parts before = store_.arguments(type);
    Parts after;
    for (const TypeId argument : before) after.push_back(copy_type(argument, variables, datatypes));
    return before == after ? type : store_.make_type(node.kind, after);
}

}  // namespace robochart::cspm::types
