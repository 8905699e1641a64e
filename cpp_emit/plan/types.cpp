// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/types.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <set>

#include "cpp_emit/plan/names.hpp"
#include "semantics/ir/number_parts.hpp"

namespace robochart::cpp_emit {

using ir::TypeKind;

bool is_numeric(TypeKind kind) {
    return kind == TypeKind::nat || kind == TypeKind::integer || kind == TypeKind::real;
}

bool is_struct(const ir::Type& type) {
    if (type.kind == TypeKind::record || type.kind == TypeKind::product) return true;
    return type.kind == TypeKind::enumeration &&
           std::ranges::any_of(type.literal_args, [](const auto& args) { return !args.empty(); });
}

bool is_declared(const ir::Type& type) {
    return is_struct(type) || type.kind == TypeKind::enumeration || type.kind == TypeKind::given;
}

bool is_composed(const ir::Type& type) {
    switch (type.kind) {
        case TypeKind::sequence:
        case TypeKind::set:
        case TypeKind::relation:
        case TypeKind::function:
        case TypeKind::vector:
        case TypeKind::matrix:
        case TypeKind::string:
            return true;
        case TypeKind::boolean:
        case TypeKind::nat:
        case TypeKind::integer:
        case TypeKind::real:
        case TypeKind::enumeration:
        case TypeKind::given:
        case TypeKind::product:
        case TypeKind::record:
        case TypeKind::unit:
            break;
    }
    return is_struct(type);
}

bool is_block_type(const ir::Type& type) {
    return type.kind == TypeKind::vector || type.kind == TypeKind::matrix;
}

bool has_pairs(const ir::Type& type) {
    return type.kind == TypeKind::relation || type.kind == TypeKind::function;
}

namespace {

/// The depth at which a type is taken as recursive. Types may be recursive, but values of such a type have no bounded
/// size.
constexpr std::size_t deepest_type = 16;

bool supported_below(const ir::System& system, ir::TypeId id, std::size_t depth) {
    const ir::Type& type = system.type(id);
    if (depth > deepest_type) return false;
    const auto parts = [&] {
        const std::vector<TypeMember> all = type_members(type);
        return std::ranges::all_of(
            all, [&](const TypeMember& member) { return supported_below(system, member.type, depth + 1); });
    };
    switch (type.kind) {
        case TypeKind::enumeration:
            return !type.labels.empty() && type.labels.size() <= 256 && parts();
        case TypeKind::record:
        case TypeKind::product:
            return !type.args.empty() && parts();
        case TypeKind::vector:
        case TypeKind::matrix:
        case TypeKind::sequence:
        case TypeKind::set:
            return supported_below(system, type.args.at(0), depth + 1);
        case TypeKind::relation:
        case TypeKind::function:
            return supported_below(system, type.args.at(0), depth + 1) &&
                   supported_below(system, type.args.at(1), depth + 1);
        case TypeKind::boolean:
        case TypeKind::nat:
        case TypeKind::integer:
        case TypeKind::real:
        case TypeKind::string:
        case TypeKind::given:
        case TypeKind::unit:
            break;
    }
    return is_numeric(type.kind) || type.kind == TypeKind::boolean || type.kind == TypeKind::given ||
           type.kind == TypeKind::string;
}

}  // namespace

bool is_supported(const ir::System& system, ir::TypeId id) {
    return supported_below(system, id, 0);
}

std::vector<TypeMember> type_members(const ir::Type& type) {
    std::vector<TypeMember> result;
    NameScope names({"filler", "kind", "Kind", "make", "of", "overflowed", "drop_overflow", "Real", "Nat", "Int",
                     "Types", "robochart", "std", "result", declared_name(type)});
    for (const std::string& label : type.labels)
        if (type.kind == TypeKind::enumeration) (void)names.unique_name(label);
    for (std::size_t i = 0; i < type.args.size() && type.kind != TypeKind::enumeration; ++i)
        result.push_back(
            {names.unique_name(type.kind == TypeKind::record ? type.labels[i] : fmt::format("item_{}", i + 1)),
             type.args[i], 0});
    for (std::size_t literal = 0; type.kind == TypeKind::enumeration && literal < type.literal_args.size(); ++literal)
        for (const ir::TypeId argument : type.literal_args[literal])
            result.push_back({names.numbered_name(type.labels[literal]), argument, literal});
    return result;
}

namespace {

bool contains_lists(const ir::System& system, ir::TypeId id) {
    const ir::Type& type = system.type(id);
    if (is_list(type) && ir::has_numbers(system, id)) return true;
    const auto part = [&](ir::TypeId inner) { return contains_lists(system, inner); };
    return std::ranges::any_of(type.args, part) || std::ranges::any_of(type.literal_args, [&](const auto& arguments) {
               return std::ranges::any_of(arguments, part);
           });
}

}  // namespace

bool is_list(const ir::Type& type) {
    return type.kind == TypeKind::sequence || type.kind == TypeKind::set || has_pairs(type);
}

bool has_lists(const ir::System& system, ir::TypeId id) {
    return is_supported(system, id) && contains_lists(system, id);
}

std::size_t given_capacity(const ir::Type& type) {
    return is_list(type) && !type.sizes.empty() ? static_cast<std::size_t>(type.sizes.front()) : 0;
}

namespace {

/// Returns whether the name has the form of the core's functions for elements of the model. A function with this name
/// would hide the type.
bool method_like(const std::string& name) {
    static constexpr const char* prefixes[] = {"accept_", "any_",   "await_", "cut_",   "during_", "enter_",
                                               "exit_",   "from_",  "leave_", "local_", "name_",   "offers_",
                                               "pass_",   "sites_", "take_",  "write_"};
    return std::any_of(std::begin(prefixes), std::end(prefixes),
                       [&](const char* prefix) { return name.starts_with(prefix); });
}

}  // namespace

/// Returns a name that differs from the core's own names.
std::string declared_name(const ir::Type& type) {
    static const std::set<std::string> taken = own_type_names();
    NameScope scope(taken);
    const std::string name = scope.unique_name(type.kind == TypeKind::product ? "Tuple_" + type.name : type.name);
    return method_like(name) ? name + "_type" : name;
}

namespace {

std::string sequence_capacity(const ir::System& system, const ir::Type& type, const Spelling& spelling) {
    if (const std::size_t given = given_capacity(type); given != 0)
        return fmt::format("robochart::capacity<{}>({})", spelling.types, given);
    if (has_lists(system, type.args.at(0))) return fmt::format("robochart::outer_capacity<{}>()", spelling.types);
    return spelling.types + "::longest";
}

}  // namespace

std::string cpp_type(const ir::System& system, ir::TypeId id, const Spelling& spelling) {
    const ir::Type& type = system.type(id);
    const auto part = [&](std::size_t place) { return cpp_type(system, type.args.at(place), spelling); };
    switch (type.kind) {
        case TypeKind::boolean:
            return "bool";
        case TypeKind::nat:
            return spelling.nat;
        case TypeKind::integer:
            return spelling.integer;
        case TypeKind::real:
            return spelling.real;
        case TypeKind::string:
            return fmt::format("robochart::String<{}>", longest_string);
        case TypeKind::sequence:
            return fmt::format("robochart::Sequence<{}, {}>", part(0), sequence_capacity(system, type, spelling));
        case TypeKind::set:
            return fmt::format("robochart::Set<{}, {}>", part(0), set_capacity(system, type, spelling));
        case TypeKind::relation:
        case TypeKind::function:
            return fmt::format("robochart::Set<{}, {}>", cpp_pair(system, type, spelling),
                               set_capacity(system, type, spelling));
        case TypeKind::vector:
            return fmt::format("robochart::Vector<{}, {}>", part(0), type.sizes.at(0));
        case TypeKind::matrix:
            return fmt::format("robochart::Matrix<{}, {}, {}>", part(0), type.sizes.at(0), type.sizes.at(1));
        case TypeKind::enumeration:
        case TypeKind::given:
        case TypeKind::product:
        case TypeKind::record:
        case TypeKind::unit:
            break;
    }
    return spelling.core + declared_name(type) + (is_struct(type) ? "<" + spelling.types + ">" : "");
}

std::string cpp_pair(const ir::System& system, const ir::Type& type, const Spelling& spelling) {
    return fmt::format("robochart::Pair<{}, {}>", cpp_type(system, type.args.at(0), spelling),
                       cpp_type(system, type.args.at(1), spelling));
}

namespace {

Extent pad_extent(Extent extent) {
    assert(extent.alignment > 0);
    extent.size = (extent.size + extent.alignment - 1) / extent.alignment * extent.alignment;
    return extent;
}

}  // namespace

namespace {

std::size_t entry_count(const ir::Type& type) {
    std::size_t result = 1;
    for (const std::int64_t size : type.sizes) result *= static_cast<std::size_t>(size);
    return result;
}

/// Returns the size of robochart::Pair, with padding between its parts and at its end.
Extent pair_extent(const ir::System& system, const ir::Instantiation& inst, const ir::Type& type) {
    const Extent first = cpp_extent(system, inst, type.args.at(0));
    const Extent second = cpp_extent(system, inst, type.args.at(1));
    const bool varies = first.varies || second.varies;
    if (first.alignment == second.alignment) return {first.size + second.size, first.alignment, varies};
    const bool wider = first.alignment > second.alignment;
    const std::size_t alignment = wider ? first.alignment : second.alignment;
    const std::size_t narrow = wider ? second.size : first.size;
    return {first.size + second.size + alignment - narrow % alignment, alignment, varies};
}

}  // namespace

std::size_t longest(const ir::Instantiation& inst) {
    const std::size_t numbers = std::max({inst.nat.size(), inst.integer.size(), inst.real.size()});
    const auto given = static_cast<std::size_t>(std::max<std::int64_t>(inst.given_size, 2));
    return std::max({static_cast<std::size_t>(std::max<std::int64_t>(inst.sequence_bound, 1)), numbers, given});
}

Extent cpp_extent(const ir::System& system, const ir::Instantiation& inst, ir::TypeId id) {
    const ir::Type& type = system.type(id);
    if (is_numeric(type.kind)) return {8, 8};
    if (!is_composed(type)) return {1, 1};
    if (type.kind == TypeKind::string) return {longest_string + 1, 1};
    if (!is_struct(type)) {
        const Extent part =
            has_pairs(type) ? pair_extent(system, inst, type) : cpp_extent(system, inst, type.args.at(0));
        if (is_block_type(type)) return {part.size * entry_count(type), part.alignment, part.varies};
        std::size_t places =
            type.kind == TypeKind::sequence ? longest(inst) : std::min(set_capacity(system, inst, type), largest_set);
        places = std::max(places, given_capacity(type));
        return {part.size * places + part.alignment, part.alignment, true};
    }
    Extent whole{type.kind == TypeKind::enumeration ? 1U : 0U};
    for (const TypeMember& member : type_members(type)) {
        const Extent part = cpp_extent(system, inst, member.type);
        whole.size += part.size;
        whole.alignment = std::max(whole.alignment, part.alignment);
        whole.varies = whole.varies || part.varies;
    }
    return pad_extent(whole);
}

std::string decimal_text(ir::Decimal decimal) {
    const bool negative = decimal.unscaled < 0;
    std::string digits = fmt::format("{}", decimal.unscaled);
    if (negative) digits.erase(0, 1);
    if (digits.size() <= decimal.decimals) digits.insert(0, decimal.decimals + 1 - digits.size(), '0');
    assert(digits.size() > decimal.decimals);
    const std::size_t point = digits.size() - decimal.decimals;
    std::string text = digits.substr(0, point) + "." + digits.substr(point);
    if (decimal.decimals == 0) text += '0';
    return (negative ? "-" : "") + text;
}

std::string literal_name(const ir::Type& type, std::size_t index) {
    assert(index < type.labels.size());
    NameScope scope;
    std::string name;
    for (std::size_t label = 0; label <= index; ++label) name = scope.unique_name(type.labels[label]);
    return name;
}

namespace {

std::uint32_t decimals_of(std::int64_t scale) {
    assert(scale > 0);
    std::uint32_t decimals = 0;
    for (; scale > 1; scale /= 10) ++decimals;
    return decimals;
}

/// Removes trailing zeros: 0.50 becomes 0.5.
ir::Decimal remove_trailing_zeros(ir::Decimal decimal) {
    while (decimal.decimals > 1 && decimal.unscaled % 10 == 0) {
        decimal.unscaled /= 10;
        --decimal.decimals;
    }
    return decimal;
}

}  // namespace

namespace {

std::string part_values(const ir::System& system, const ir::Instantiation& inst, const std::vector<ir::TypeId>& types,
                        const ir::Value& value, const Spelling& spelling) {
    std::string text;
    for (std::size_t i = 0; i < value.parts.size(); ++i)
        text += (i == 0 ? "" : ", ") +
                cpp_value(system, inst, types.at(types.size() > 1 ? i : 0), value.parts[i], spelling);
    return text;
}

std::string entry_values(const ir::System& system, const ir::Instantiation& inst, const ir::Type& type,
                         const ir::Value& matrix, const Spelling& spelling) {
    std::string text;
    for (const ir::Value& row : matrix.parts)
        text += (text.empty() ? "" : ", ") + part_values(system, inst, type.args, row, spelling);
    return text;
}

std::string pair_values(const ir::System& system, const ir::Instantiation& inst, const ir::Type& type,
                        const ir::Value& value, const Spelling& spelling) {
    std::string text;
    for (const ir::Value& pair : value.parts)
        text += fmt::format("{}{}::make({})", text.empty() ? "" : ", ", cpp_pair(system, type, spelling),
                            part_values(system, inst, type.args, pair, spelling));
    return text;
}

std::string enumeration_value(const ir::System& system, const ir::Instantiation& inst, ir::TypeId id,
                              const ir::Value& value, const Spelling& spelling) {
    const ir::Type& type = system.type(id);
    const auto index = static_cast<std::size_t>(value.number);
    const std::string name = fmt::format("{}::{}", cpp_type(system, id, spelling), literal_name(type, index));
    if (!is_struct(type)) return name;
    const std::vector<ir::TypeId> none;
    const auto& arguments = index < type.literal_args.size() ? type.literal_args[index] : none;
    return fmt::format("{}({})", name, part_values(system, inst, arguments, value, spelling));
}

}  // namespace

diagnostics::ForeignText string_text(const ir::Value& value) {
    std::string text;
    for (const ir::Value& part : value.parts) text += static_cast<char>(part.number);
    return text;
}

std::string cpp_value(const ir::System& system, const ir::Instantiation& inst, ir::TypeId id, const ir::Value& value,
                      const Spelling& spelling) {
    const ir::Type& type = system.type(id);
    const auto built = [&](const char* maker) {
        return fmt::format("{}::{}({})", cpp_type(system, id, spelling), maker,
                           part_values(system, inst, type.args, value, spelling));
    };
    switch (type.kind) {
        case TypeKind::boolean:
            return value.number != 0 ? "true" : "false";
        case TypeKind::real:
            return fmt::format("{}({})", spelling.real,
                               decimal_text(remove_trailing_zeros({value.number, decimals_of(inst.scale)})));
        case TypeKind::enumeration:
            return enumeration_value(system, inst, id, value, spelling);
        case TypeKind::string:
            return fmt::format("{}::of({})", cpp_type(system, id, spelling),
                               diagnostics::cpp_string(string_text(value)));
        case TypeKind::record:
        case TypeKind::product:
            return built("make");
        case TypeKind::sequence:
        case TypeKind::set:
        case TypeKind::vector:
            return built("of");
        case TypeKind::matrix:
            return fmt::format("{}::of({})", cpp_type(system, id, spelling),
                               entry_values(system, inst, type, value, spelling));
        case TypeKind::relation:
        case TypeKind::function:
            return fmt::format("{}::of({})", cpp_type(system, id, spelling),
                               pair_values(system, inst, type, value, spelling));
        case TypeKind::nat:
        case TypeKind::integer:
        case TypeKind::given:
        case TypeKind::unit:
            break;
    }
    return fmt::format("{}({})", cpp_type(system, id, spelling), value.number);
}

namespace {

std::string cspm_parts(const ir::System& system, const std::vector<ir::TypeId>& types, const ir::Value& value,
                       const char* separator) {
    std::string text;
    for (std::size_t i = 0; i < value.parts.size(); ++i)
        text += (i == 0 ? "" : separator) + cspm_value(system, types.at(types.size() > 1 ? i : 0), value.parts[i]);
    return text;
}

/// Returns the text of the parts if they are tuples themselves: pairs of a function, rows of a matrix.
std::string cspm_rows(const ir::System& system, const std::vector<ir::TypeId>& types, const ir::Value& value) {
    std::string text;
    for (const ir::Value& row : value.parts) {
        const std::string parts = cspm_parts(system, types, row, ", ");
        text += (text.empty() ? "" : ", ") + (row.parts.size() == 1 ? parts : "(" + parts + ")");
    }
    return text;
}

std::string cspm_literal(const ir::System& system, const ir::Type& type, const ir::Value& value) {
    const auto index = static_cast<std::size_t>(value.number);
    std::string package = type.package;
    for (std::size_t at = package.find("::"); at != std::string::npos; at = package.find("::"))
        package.replace(at, 2, "_");
    const std::string name = (package.empty() ? "" : package + "_") + type.name + "_" + type.labels[index];
    if (value.parts.empty()) return name;
    return name + "." + cspm_parts(system, type.literal_args[index], value, ".");
}

}  // namespace

std::string cspm_value(const ir::System& system, ir::TypeId id, const ir::Value& value) {
    const ir::Type& type = system.type(id);
    switch (type.kind) {
        case TypeKind::boolean:
            return value.number != 0 ? "true" : "false";
        case TypeKind::enumeration:
            return cspm_literal(system, type, value);
        case TypeKind::string:  // a sequence of characters; an empty string is an empty sequence
            return string_text(value).empty() ? "<>" : diagnostics::cspm_string(string_text(value));
        case TypeKind::sequence:
            return "<" + cspm_parts(system, type.args, value, ", ") + ">";
        case TypeKind::set:
            return "{" + cspm_parts(system, type.args, value, ", ") + "}";
        case TypeKind::relation:
        case TypeKind::function:
            return "{" + cspm_rows(system, type.args, value) + "}";
        case TypeKind::matrix: {
            const std::string rows = cspm_rows(system, type.args, value);
            return value.parts.size() == 1 ? rows : "(" + rows + ")";
        }
        case TypeKind::record:
        case TypeKind::product:
        case TypeKind::vector: {
            const std::string parts = cspm_parts(system, type.args, value, ", ");
            return value.parts.size() == 1 ? parts : "(" + parts + ")";
        }
        case TypeKind::nat:
        case TypeKind::integer:
        case TypeKind::real:
        case TypeKind::given:
        case TypeKind::unit:
            break;
    }
    return fmt::format("{}", value.number);
}

}  // namespace robochart::cpp_emit
