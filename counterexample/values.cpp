// SPDX-License-Identifier: Apache-2.0
// Reads values that checker/cspm/eval/value_text.cpp has printed. csp_emit/base/types.cpp defines how they represent
// values of the model.
#include "counterexample/values.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "semantics/ir/numbers.hpp"

namespace robochart::runs {
namespace {

using ir::TypeId;
using ir::TypeKind;

/// Returns the name of the type in the model.
std::string type_name(const ir::Type& type) {
    return type.values_of.empty() ? type.name : type.values_of;
}

class Reader {
public:
    Reader(const ir::System& system, const ir::Instantiation& instantiation)
        : system_(system), instantiation_(instantiation) {}

    [[nodiscard]] std::string read_value(TypeId id, std::string_view text) const;
    /// Returns the literal with which a value of an enumeration begins. Returns no value for other values.
    [[nodiscard]] std::optional<std::size_t> find_literal(const ir::Type& type, std::string_view text) const;

private:
    [[nodiscard]] std::string real_text(std::string_view text) const;
    [[nodiscard]] std::string enumeration_text(const ir::Type& type, std::string_view text) const;
    [[nodiscard]] std::string collection_text(const std::vector<TypeId>& elements, std::string_view text) const;
    [[nodiscard]] std::string record_text(const ir::Type& type, std::string_view text) const;
    [[nodiscard]] std::string element_text(const std::vector<TypeId>& types, std::string_view text) const;

    const ir::System& system_;
    const ir::Instantiation& instantiation_;
};

std::string Reader::real_text(std::string_view text) const {
    std::int64_t number = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = code == std::errc() && end == text.data() + text.size();
    return whole ? ir::decimal_text(number, instantiation_.scale) : std::string(text);
}

std::optional<std::size_t> Reader::find_literal(const ir::Type& type, std::string_view text) const {
    const std::string_view name = text.substr(0, text.find('.'));
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < type.labels.size(); ++i) {
        const std::string& label = type.labels[i];
        const bool ends = name == label || name.ends_with("_" + label);
        if (ends && (!found || label.size() > type.labels[*found].size())) found = i;
    }
    return found;
}

std::string Reader::enumeration_text(const ir::Type& type, std::string_view text) const {
    const auto found = find_literal(type, text);
    if (!found) return std::string(text);
    const auto dot = text.find('.');
    if (dot == std::string_view::npos) return type.shown.empty() ? type.labels[*found] : type.shown[*found];
    std::vector<std::string> arguments;
    const std::vector<TypeId> types =
        *found < type.literal_args.size() ? type.literal_args[*found] : std::vector<TypeId>{};
    for (const Value& argument : values_of_event(system_, instantiation_, types, text.substr(dot + 1)))
        arguments.push_back(argument.text);
    return fmt::format("{}({})", type.labels[*found], fmt::join(arguments, ", "));
}

/// Converts an element of a collection: a pair of a function or relation, or a value of the common type.
std::string Reader::element_text(const std::vector<TypeId>& types, std::string_view text) const {
    if (types.size() == 1) return read_value(types[0], text);
    return collection_text(types, text);
}

/// Converts `<a, b>`, `{a, b}` and `(a, b)`. Their elements have one type, or one type per element.
std::string Reader::collection_text(const std::vector<TypeId>& elements, std::string_view text) const {
    if (text.size() < 3 || elements.empty()) return std::string(text);
    std::vector<std::string> shown;
    const std::vector<std::string> parts = split_outside_brackets(text.substr(1, text.size() - 2), ",");
    for (std::size_t i = 0; i < parts.size(); ++i)
        shown.push_back(read_value(i < elements.size() ? elements[i] : elements.back(), trim_blanks(parts[i])));
    return fmt::format("{}{}{}", text.front(), fmt::join(shown, ", "), text.back());
}

std::string Reader::record_text(const ir::Type& type, std::string_view text) const {
    std::vector<std::string> parts;
    if (type.labels.size() == 1)
        parts.emplace_back(text);
    else if (text.size() > 2)
        parts = split_outside_brackets(text.substr(1, text.size() - 2), ",");
    if (parts.size() != type.labels.size() || type.args.size() != type.labels.size()) return std::string(text);
    std::vector<std::string> fields;
    for (std::size_t i = 0; i < parts.size(); ++i)
        fields.push_back(fmt::format("{} = {}", type.labels[i], read_value(type.args[i], trim_blanks(parts[i]))));
    return fmt::format("{} (| {} |)", type.name, fmt::join(fields, ", "));
}

std::string Reader::read_value(TypeId id, std::string_view text) const {
    if (!id.is_valid() || text.empty()) return std::string(text);
    const ir::Type& type = system_.type(id);
    switch (type.kind) {
        case TypeKind::real:
            return real_text(text);
        case TypeKind::enumeration:
            return enumeration_text(type, text);
        case TypeKind::record:
            return record_text(type, text);
        case TypeKind::sequence:
        case TypeKind::set: {
            if (text.front() != '<' && text.front() != '{') return std::string(text);
            if (text.size() < 3) return std::string(text);
            std::vector<std::string> shown;
            for (const std::string& part : split_outside_brackets(text.substr(1, text.size() - 2), ","))
                shown.push_back(element_text(type.args, trim_blanks(part)));
            return fmt::format("{}{}{}", text.front(), fmt::join(shown, ", "), text.back());
        }
        case TypeKind::function:
        case TypeKind::relation: {
            if (text.size() < 3 || text.front() != '{') return std::string(text);
            std::vector<std::string> shown;
            for (const std::string& part : split_outside_brackets(text.substr(1, text.size() - 2), ","))
                shown.push_back(collection_text(type.args, trim_blanks(part)));
            return fmt::format("{{{}}}", fmt::join(shown, ", "));
        }
        case TypeKind::product:
        case TypeKind::vector:
            return text.front() == '(' ? collection_text(type.args, text) : element_text(type.args, text);
        case TypeKind::boolean:
        case TypeKind::nat:
        case TypeKind::integer:
        case TypeKind::string:
        case TypeKind::given:
        case TypeKind::matrix:
        case TypeKind::unit:
            break;
    }
    return std::string(text);
}

}  // namespace

std::vector<std::string> split_outside_brackets(std::string_view text, std::string_view separator) {
    std::vector<std::string> parts;
    int depth = 0;
    bool quoted = false;
    std::size_t start = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        if (c == '(' || c == '{' || c == '<') ++depth;
        // The `>` in `=>` of a map is not a bracket.
        if (c == ')' || c == '}' || (c == '>' && (i == 0 || text[i - 1] != '='))) --depth;
        if (depth == 0 && text.substr(i, separator.size()) == separator) {
            parts.emplace_back(text.substr(start, i - start));
            i += separator.size() - 1;
            start = i + 1;
        }
    }
    parts.emplace_back(text.substr(start));
    return parts;
}

std::string_view trim_blanks(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

std::string value_text(const ir::System& system, const ir::Instantiation& instantiation, TypeId type,
                       std::string_view text) {
    return Reader(system, instantiation).read_value(type, text);
}

std::vector<Value> values_of_event(const ir::System& system, const ir::Instantiation& instantiation,
                                   const std::vector<TypeId>& types, std::string_view text) {
    std::vector<Value> result;
    if (text.empty()) return result;
    const Reader reader(system, instantiation);
    const std::vector<std::string> parts = split_outside_brackets(text, ".");
    for (std::size_t at = 0, place = 0; at < parts.size(); ++place) {
        const TypeId type = place < types.size() ? types[place] : TypeId{};
        std::string value = parts[at++];
        if (type.is_valid() && system.type(type).kind == TypeKind::enumeration) {
            const ir::Type& enumeration = system.type(type);
            const auto literal = reader.find_literal(enumeration, value);
            const bool has_arguments = literal && *literal < enumeration.literal_args.size();
            std::size_t more = has_arguments ? enumeration.literal_args[*literal].size() : 0;
            for (; more > 0 && at < parts.size(); --more) value += "." + parts[at++];
        }
        result.push_back({reader.read_value(type, value), type.is_valid() ? type_name(system.type(type)) : ""});
    }
    return result;
}

}  // namespace robochart::runs
