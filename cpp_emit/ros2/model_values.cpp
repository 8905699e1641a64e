// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/ros2/model_values.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit::ros2 {

using ir::TypeKind;

std::optional<ScalarKind> scalar_kind(const ir::Type& type) {
    switch (type.kind) {
        case TypeKind::boolean:
            return ScalarKind::truth;
        case TypeKind::nat:
            return ScalarKind::nat;
        case TypeKind::integer:
            return ScalarKind::integer;
        case TypeKind::real:
            return ScalarKind::real;
        case TypeKind::enumeration:
            if (!is_struct(type)) return ScalarKind::enumeration;
            break;
        case TypeKind::string:
        case TypeKind::given:
        case TypeKind::sequence:
        case TypeKind::set:
        case TypeKind::product:
        case TypeKind::record:
        case TypeKind::function:
        case TypeKind::relation:
        case TypeKind::vector:
        case TypeKind::matrix:
        case TypeKind::unit:
            break;
    }
    return std::nullopt;
}

std::string message_of(ScalarKind kind) {
    if (kind == ScalarKind::truth) return "Bool";
    return kind == ScalarKind::real ? "Float64" : "Int64";
}

std::string describe_type(const ir::Type& type) {
    const char* const article = type.kind == TypeKind::integer || type.kind == TypeKind::enumeration ? "an" : "a";
    const char* kind = "";
    if (type.kind == TypeKind::enumeration) kind = "enumeration ";
    if (type.kind == TypeKind::record) kind = "record ";
    return fmt::format("{} {}{}", article, kind, type.name);
}

namespace {

/// Returns the value as a scalar or a sequence of scalars.
std::optional<Scalar> scalar_of(const ir::System& system, const ModelValue& value) {
    const ir::Type& type = system.type(value.type);
    const bool list = type.kind == TypeKind::sequence;
    const ir::TypeId item = list ? type.args.at(0) : value.type;
    const auto kind = scalar_kind(system.type(item));
    return kind ? std::optional<Scalar>({*kind, item, value.place, value.name, list}) : std::nullopt;
}

}  // namespace

bool scalars_of(const ir::System& system, const ModelValue& value, std::vector<Scalar>& scalars) {
    const ir::Type& type = system.type(value.type);
    if (const auto scalar = scalar_of(system, value)) {
        scalars.push_back(*scalar);
        return true;
    }
    if (type.kind != TypeKind::record) return false;
    const std::vector<TypeMember> parts = type_members(type);
    bool all = true;
    for (std::size_t i = 0; i < parts.size(); ++i)
        all = scalars_of(system, {value.name + "." + type.labels[i], value.place + "." + parts[i].name, parts[i].type},
                         scalars) &&
              all;
    return all;
}

FoundScalar find_scalar(const ir::System& system, const std::vector<ModelValue>& values, const Path& path) {
    FoundScalar found;
    for (const ModelValue& value : values) found.known.push_back(value.name);
    const auto root =
        std::ranges::find_if(values, [&](const ModelValue& value) { return value.name == path.words.front().text; });
    if (root == values.end()) return found;
    ModelValue at = *root;
    for (found.missing = 1; found.missing < path.words.size(); ++found.missing) {
        const ir::Type& type = system.type(at.type);
        found.type = at.type;
        found.known.clear();
        if (type.kind != TypeKind::record) return found;
        found.known = type.labels;
        const auto label = std::ranges::find(type.labels, path.words[found.missing].text);
        if (label == type.labels.end()) return found;
        const TypeMember member = type_members(type)[static_cast<std::size_t>(label - type.labels.begin())];
        at = {at.name + "." + *label, at.place + "." + member.name, member.type};
    }
    found.type = at.type;
    found.scalar = scalar_of(system, at);
    return found;
}

bool fits_field(const FieldType& field, const Scalar& scalar, bool published) {
    const ScalarKind kind = scalar.kind;
    if (scalar.list) {
        if (published || field.kind == FieldKind::unknown) return !published;
        Scalar item = scalar;
        item.list = false;
        return field.kind == FieldKind::several && fits_field(item_type(field), item, published);
    }
    switch (field.kind) {
        case FieldKind::truth:
            return kind == ScalarKind::truth;
        case FieldKind::whole:
            return kind != ScalarKind::truth && (!published || kind != ScalarKind::real);
        case FieldKind::real:
            return kind == ScalarKind::real || (published && (kind == ScalarKind::nat || kind == ScalarKind::integer));
        case FieldKind::text:
        case FieldKind::time:
        case FieldKind::message:
        case FieldKind::several:
            return false;
        case FieldKind::unknown:
            break;
    }
    return true;
}

}  // namespace robochart::cpp_emit::ros2
