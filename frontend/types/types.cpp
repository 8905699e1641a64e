// SPDX-License-Identifier: Apache-2.0
// Prints types. The compatibility of types is in compatibility.cpp.
#include "frontend/types/types.hpp"

#include <fmt/format.h>

namespace robochart::frontend {

namespace {

std::string size_text(long size) {
    return size < 0 ? "?" : std::to_string(size);
}

bool is_open(const TypePtr& type) {
    return type &&
           (type->form == TypeForm::product || type->form == TypeForm::function || type->form == TypeForm::relation);
}

std::string operand_text(const TypePtr& type) {
    return is_open(type) ? "(" + to_string(type) + ")" : to_string(type);
}

std::string product_text(const Type& type) {
    std::string out;
    for (const TypePtr& arg : type.args) out += (out.empty() ? "" : " * ") + operand_text(arg);
    // The argument type of a function with one or no parameter is a product as well.
    return type.args.empty() ? "()" : out;
}

/// Prints an operand of an arrow. A product binds more tightly than arrows, so it needs no parentheses.
std::string beside_arrow(const TypePtr& type) {
    return type && type->form == TypeForm::product ? product_text(*type) : operand_text(type);
}

}  // namespace

std::string to_string(const TypePtr& type) {
    if (!type) return "unknown";
    const auto arg = [&](std::size_t i) { return to_string(type->args[i]); };
    switch (type->form) {
        case TypeForm::any:
            return "?";
        case TypeForm::boolean:
            return "boolean";
        case TypeForm::nat:
            return "nat";
        case TypeForm::integer:
            return "int";
        case TypeForm::real:
            return "real";
        case TypeForm::string:
            return "string";
        case TypeForm::given:
        case TypeForm::enumeration:
        case TypeForm::record:
            return type->name;
        case TypeForm::variable:
            return "?" + type->name;
        case TypeForm::sequence:
            return "Seq(" + arg(0) + ")";
        case TypeForm::set:
            return "Set(" + arg(0) + ")";
        case TypeForm::product:
            return product_text(*type);
        case TypeForm::function:
            return beside_arrow(type->args[0]) + " -> " + beside_arrow(type->args[1]);
        case TypeForm::relation:
            return beside_arrow(type->args[0]) + " <-> " + beside_arrow(type->args[1]);
        case TypeForm::vector:
            return fmt::format("vector({}, {})", arg(0), size_text(type->sizes[0]));
        case TypeForm::matrix:
            return fmt::format("matrix({}, {}, {})", arg(0), size_text(type->sizes[0]), size_text(type->sizes[1]));
    }
    return "unknown";
}

}  // namespace robochart::frontend
