// SPDX-License-Identifier: Apache-2.0
#include "semantics/ir/number_parts.hpp"

#include <algorithm>

namespace robochart::ir {
namespace {

bool is_number(TypeKind kind) {
    return kind == TypeKind::nat || kind == TypeKind::integer || kind == TypeKind::real;
}

/// Collects the numbers of a value. Returns false if a part is not a number. The recursion is as deep as the type.
bool collect_parts(const System& system, TypeId id, std::vector<std::size_t>& path, std::vector<NumberPart>& parts) {
    const Type& type = system.type(id);
    if (is_number(type.kind)) {
        parts.push_back({path, type.kind});
        return true;
    }
    if (type.kind != TypeKind::product && type.kind != TypeKind::record) return false;
    for (std::size_t i = 0; i < type.args.size(); ++i) {
        path.push_back(i);
        if (!collect_parts(system, type.args[i], path, parts)) return false;
        path.pop_back();
    }
    return true;
}

}  // namespace

std::vector<NumberPart> number_parts(const System& system, TypeId type) {
    std::vector<NumberPart> parts;
    std::vector<std::size_t> path;
    if (!collect_parts(system, type, path, parts)) parts.clear();
    return parts;
}

bool is_number_sequence(const System& system, TypeId type) {
    const Type& whole = system.type(type);
    return whole.kind == TypeKind::sequence && is_number(system.type(whole.args.at(0)).kind);
}

/// See number_parts.hpp. The recursion is as deep as the type.
bool has_numbers(const System& system, TypeId id) {
    const Type& type = system.type(id);
    switch (type.kind) {
        case TypeKind::boolean:
        case TypeKind::unit:
            return false;
        case TypeKind::nat:
        case TypeKind::integer:
        case TypeKind::real:
        case TypeKind::string:
        case TypeKind::given:
        case TypeKind::sequence:
            return true;
        case TypeKind::enumeration:
        case TypeKind::set:
        case TypeKind::product:
        case TypeKind::record:
        case TypeKind::function:
        case TypeKind::relation:
        case TypeKind::vector:
        case TypeKind::matrix:
            break;
    }
    const auto inside = [&](TypeId part) { return has_numbers(system, part); };
    return std::ranges::any_of(type.args, inside) ||
           std::ranges::any_of(type.literal_args,
                               [&](const std::vector<TypeId>& parts) { return std::ranges::any_of(parts, inside); });
}

}  // namespace robochart::ir
