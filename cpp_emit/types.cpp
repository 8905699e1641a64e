#include "cpp_emit/types.hpp"

#include <fmt/format.h>

#include "cpp_emit/names.hpp"

namespace robochart::cpp_emit {

using ir::TypeKind;

bool numeric(TypeKind kind) {
    return kind == TypeKind::nat || kind == TypeKind::integer || kind == TypeKind::real;
}

bool supported(const ir::Type& type) {
    if (type.kind == TypeKind::enumeration) {
        for (const auto& args : type.literal_args)
            if (!args.empty()) return false;
        return !type.labels.empty() && type.labels.size() <= 256;
    }
    return numeric(type.kind) || type.kind == TypeKind::boolean || type.kind == TypeKind::given;
}

std::string cpp_type(const ir::System& system, ir::TypeId id) {
    const ir::Type& type = system.type(id);
    switch (type.kind) {
        case TypeKind::boolean:
            return "bool";
        case TypeKind::nat:
            return "Nat";
        case TypeKind::integer:
            return "Int";
        case TypeKind::real:
            return "Real";
        default:
            return identifier(type.name);
    }
}

std::size_t cpp_size(const ir::Type& type) {
    return numeric(type.kind) ? 8 : 1;
}

std::string decimal_text(ir::Decimal decimal) {
    const bool negative = decimal.unscaled < 0;
    std::string digits = fmt::format("{}", decimal.unscaled);
    if (negative) digits.erase(0, 1);
    if (digits.size() <= decimal.decimals) digits.insert(0, decimal.decimals + 1 - digits.size(), '0');
    const std::size_t point = digits.size() - decimal.decimals;
    std::string text = digits.substr(0, point) + "." + digits.substr(point);
    if (decimal.decimals == 0) text += '0';
    return (negative ? "-" : "") + text;
}

std::string literal_name(const ir::Type& type, std::size_t index) {
    NameScope scope;
    std::string name;
    for (std::size_t label = 0; label <= index; ++label) name = scope.unique(type.labels[label]);
    return name;
}

namespace {

std::uint32_t decimals_of(std::int64_t scale) {
    std::uint32_t decimals = 0;
    for (; scale > 1; scale /= 10) ++decimals;
    return decimals;
}

/// Drops zeros at the end: 0.50 is 0.5.
ir::Decimal shortest(ir::Decimal decimal) {
    while (decimal.decimals > 1 && decimal.unscaled % 10 == 0) {
        decimal.unscaled /= 10;
        --decimal.decimals;
    }
    return decimal;
}

}  // namespace

std::string cpp_value(const ir::System& system, const ir::Instantiation& inst, ir::TypeId id, const ir::Value& value) {
    const ir::Type& type = system.type(id);
    switch (type.kind) {
        case TypeKind::boolean:
            return value.number != 0 ? "true" : "false";
        case TypeKind::real:
            return fmt::format("Real({})", decimal_text(shortest({value.number, decimals_of(inst.scale)})));
        case TypeKind::enumeration:
            return fmt::format("{}::{}", identifier(type.name),
                               literal_name(type, static_cast<std::size_t>(value.number)));
        default:
            return fmt::format("{}({})", cpp_type(system, id), value.number);
    }
}

std::string cspm_value(const ir::System& system, ir::TypeId id, const ir::Value& value) {
    const ir::Type& type = system.type(id);
    if (type.kind == TypeKind::boolean) return value.number != 0 ? "true" : "false";
    if (type.kind != TypeKind::enumeration) return fmt::format("{}", value.number);
    const std::string& label = type.labels[static_cast<std::size_t>(value.number)];
    return type.package.empty() ? fmt::format("{}_{}", type.name, label)
                                : fmt::format("{}_{}_{}", type.package, type.name, label);
}

}  // namespace robochart::cpp_emit
