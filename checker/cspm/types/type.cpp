// SPDX-License-Identifier: Apache-2.0
// Creates, reads and binds the types of the arena. Variables have levels (Rémy). The level shows the innermost open
// group of declarations that may still determine the variable.
#include "checker/cspm/types/type.hpp"

#include "base/diagnostics/containers.hpp"

namespace robochart::cspm::types {

namespace {
constexpr auto kinds = static_cast<std::uint32_t>(TypeKind::complete) + 1;
}

TypeKind primitive_kind(std::string_view name) {
    if (name == "Int") return TypeKind::integer;
    if (name == "Bool") return TypeKind::boolean;
    if (name == "Char") return TypeKind::character;
    if (name == "Proc") return TypeKind::process;
    if (name == "Event") return TypeKind::event;
    return TypeKind::variable;
}

// Creates the atoms. They are the first nodes, and the index of an atom is its kind.
TypeStore::TypeStore() {
    for (std::uint32_t kind = 0; kind < kinds; ++kind) {
        TypeNode node;
        node.kind = static_cast<TypeKind>(kind);
        node.closed = node.plain = true;
        nodes_.push_back(node);
    }
}

// ---------------------------------------------------------------- making

TypeId TypeStore::add(const TypeNode& node) {
    nodes_.push_back(node);
    return static_cast<TypeId>(nodes_.size() - 1);
}

TypeId TypeStore::fresh_variable(Constraints constraints) {
    TypeNode node;
    node.constraints = constraints;
    node.level = level_;
    return add(node);
}

TypeId TypeStore::rigid_variable(const std::string& name, Constraints constraints) {
    const TypeId result = fresh_variable(constraints);
    nodes_[result].rigid = true;
    nodes_[result].first = static_cast<std::uint32_t>(names_.size());
    names_.push_back(name);
    return result;
}

TypeId TypeStore::datatype(std::uint32_t number) {
    return datatypes_[number].type;
}

std::uint32_t TypeStore::new_datatype(const std::string& name) {
    TypeNode node;
    node.kind = TypeKind::datatype;
    node.closed = node.plain = true;
    node.first = static_cast<std::uint32_t>(datatypes_.size());
    datatypes_.push_back({name, false, add(node)});
    return node.first;
}

TypeId TypeStore::make_type(TypeKind kind, const std::vector<TypeId>& args) {
    TypeNode node;
    node.kind = kind;
    node.first = static_cast<std::uint32_t>(args_.size());
    node.count = static_cast<std::uint32_t>(args.size());
    node.closed = true;
    node.plain = kind != TypeKind::dot && kind != TypeKind::dotable && kind != TypeKind::extendable;
    for (const TypeId argument : args) {
        const TypeId end = follow_links(argument);
        args_.push_back(end);
        node.closed = node.closed && nodes_[end].closed;
        node.plain = node.plain && nodes_[end].plain;
    }
    return add(node);
}

TypeId TypeStore::dot_type(const std::vector<TypeId>& parts) {
    return parts.size() == 1 ? parts.front() : make_type(TypeKind::dot, parts);
}

TypeId TypeStore::dotable_type(const std::vector<TypeId>& arguments, std::size_t from, TypeId result) {
    for (std::size_t i = arguments.size(); i > from; --i) result = dotable_type(arguments[i - 1], result);
    return result;
}

// ---------------------------------------------------------------- looking

TypeId TypeStore::follow_links(TypeId type) {
    TypeId end = type;
    while (nodes_[end].link != no_type) end = nodes_[end].link;
    while (nodes_[type].link != no_type && nodes_[type].link != end) {
        const TypeId next = nodes_[type].link;
        record_change(type);
        nodes_[type].link = end;
        type = next;
    }
    return end;
}

// Follows all bindings of a type and returns the result. An extendable whose variable is bound to an argument and a
// rest is the same type as a dotable of that argument and that rest.
TypeId TypeStore::head(TypeId type) {
    for (;;) {
        type = follow_links(type);
        if (nodes_[type].kind != TypeKind::extendable) return type;
        const TypeId result = argument(type, 0);
        const TypeId given = follow_links(argument(type, 1));
        if (nodes_[given].kind == TypeKind::variable) {
            return given == argument(type, 1) ? type : extendable_type(result, given);
        }
        if (nodes_[given].kind == TypeKind::complete) {
            type = result;
        } else {
            return dotable_type(argument(given, 0), extendable_type(result, argument(given, 1)));
        }
    }
}

std::vector<TypeId> TypeStore::arguments(TypeId type) const {
    const TypeNode& node = nodes_[type];
    return {args_.begin() + node.first, args_.begin() + node.first + node.count};
}

std::vector<TypeId> TypeStore::dot_parts(TypeId type) {
    const Depth guard(*this);
    type = head(type);
    if (nodes_[type].kind != TypeKind::dot) return {type};
    std::vector<TypeId> result;
    for (const TypeId part : arguments(type)) {
        const std::vector<TypeId> inner = dot_parts(part);
        result.insert(result.end(), inner.begin(), inner.end());
    }
    return result;
}

TypeId TypeStore::split(TypeId type, std::vector<TypeId>& given) {
    for (;;) {
        count_step();
        type = head(type);
        if (nodes_[type].kind != TypeKind::dotable) return type;
        const TypeId result = argument(type, 1);
        const std::vector<TypeId> parts = dot_parts(argument(type, 0));
        given.insert(given.end(), parts.begin(), parts.end());
        type = result;
    }
}

// ---------------------------------------------------------------- changing

void TypeStore::record_change(TypeId type) {
    if (recording_) trail_.emplace_back(type, nodes_[type]);
}

void TypeStore::undo_to(std::size_t mark) {
    while (trail_.size() > mark) {
        nodes_[trail_.back().first] = trail_.back().second;
        trail_.pop_back();
    }
}

void TypeStore::bind(TypeId variable, TypeId type) {
    record_change(variable);
    nodes_[variable].link = type;
}

void TypeStore::constrain(TypeId variable, Constraints constraints) {
    record_change(variable);
    nodes_[variable].constraints |= constraints;
}

void TypeStore::lower_level(TypeId variable, std::uint32_t level) {
    if (nodes_[variable].level <= level) return;
    record_change(variable);
    nodes_[variable].level = level;
}

bool TypeStore::lower_and_find(TypeId type, TypeId sought, std::uint32_t level) {
    const Depth guard(*this);
    type = head(type);
    if (nodes_[type].closed) return false;
    if (nodes_[type].kind == TypeKind::variable) {
        lower_level(type, level);
        return type == sought;
    }
    bool found = false;
    for (std::uint32_t i = 0; i < nodes_[type].count; ++i)
        found = lower_and_find(argument(type, i), sought, level) || found;
    return found;
}

void TypeStore::gather_open(TypeId type, std::vector<TypeId>& out) {
    const Depth guard(*this);
    type = head(type);
    if (nodes_[type].closed) return;
    if (nodes_[type].kind == TypeKind::variable) {
        if (nodes_[type].level > level_) out.push_back(type);
        return;
    }
    for (std::uint32_t i = 0; i < nodes_[type].count; ++i) gather_open(argument(type, i), out);
}

std::vector<TypeId> TypeStore::open_variables(TypeId type) {
    std::vector<TypeId> result;
    gather_open(type, result);
    diagnostics::sort_unique(result);
    return result;
}

}  // namespace robochart::cspm::types
