// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/value_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/text.hpp"
#include "semantics/ir/numbers.hpp"

namespace robochart::ir {
namespace {

/// Returns a string in quotes. The parts of its value are its bytes.
std::string string_text(const Value& value) {
    std::string text;
    for (const Value& part : value.parts) text += static_cast<char>(static_cast<unsigned char>(part.number));
    return fmt::format("\"{}\"", diagnostics::escape_for_display(text));
}

}  // namespace

/// See value_text.hpp. The recursion is as deep as the type.
std::string value_text(const System& system, std::int64_t scale, TypeId id, const Value& value) {
    const Type& type = system.type(id);
    std::vector<std::string> parts;
    const auto add_parts = [&](const std::vector<TypeId>& types) {
        for (std::size_t i = 0; i < value.parts.size(); ++i)
            parts.push_back(value_text(system, scale, types.at(std::min(i, types.size() - 1)), value.parts[i]));
    };
    switch (type.kind) {
        case TypeKind::real:
            return decimal_text(value.number, scale);
        case TypeKind::boolean:
            return value.number != 0 ? "true" : "false";
        case TypeKind::sequence:
            add_parts(type.args);
            return fmt::format("<{}>", diagnostics::join_equal(parts));
        case TypeKind::enumeration: {
            const auto literal = static_cast<std::size_t>(value.number);
            if (value.parts.empty()) return type.labels.at(literal);
            add_parts(type.literal_args.at(literal));
            return fmt::format("{}({})", type.labels.at(literal), fmt::join(parts, ", "));
        }
        case TypeKind::record:
            add_parts(type.args);
            for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = type.labels.at(i) + " = " + parts[i];
            return fmt::format("{}(| {} |)", type.name, fmt::join(parts, ", "));
        case TypeKind::product:
        case TypeKind::vector:
            add_parts(type.args);
            return fmt::format("({})", fmt::join(parts, ", "));
        case TypeKind::set:
            add_parts(type.args);
            return fmt::format("{{{}}}", fmt::join(parts, ", "));
        case TypeKind::string:
            return string_text(value);
        case TypeKind::nat:
        case TypeKind::integer:
        case TypeKind::given:
        case TypeKind::function:
        case TypeKind::relation:
        case TypeKind::matrix:
        case TypeKind::unit:
            break;
    }
    return std::to_string(value.number);
}

}  // namespace robochart::ir
