// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/files/explore_adapter_printers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit {

using diagnostics::cpp_string;

namespace {

constexpr std::string_view buffer = "robochart::Buffer<";

/// Returns the type inside the brackets of a buffer. If the field is not a buffer, returns its type.
std::string held_type(const std::string& type) {
    return type.starts_with(buffer) ? type.substr(buffer.size(), type.size() - buffer.size() - 1) : type;
}

/// Returns whether the field has parts. Sequences, sets, vectors, matrices and strings are types of the runtime;
/// records and similar types have the carriers as template argument.
bool is_compound(const std::string& type) {
    return type != "robochart::Flag" && (type.starts_with("robochart::") || type.ends_with(">"));
}

bool is_filler(const Field& field) {
    return field.name.starts_with("filler[");
}

/// Returns whether values of the type have a name in the model and no parts.
bool named_type(const ir::Type& type) {
    return type.kind == ir::TypeKind::enumeration && !is_struct(type);
}

void name_function(CodeWriter& out, const std::string& type,
                   const std::vector<std::pair<std::string, std::string>>& names) {
    out.gap();
    out.open(fmt::format("[[maybe_unused]] const char* name(core::{} place) noexcept {{", type));
    out.open("switch (place) {");
    for (const auto& [value, name] : names)
        out.line(fmt::format("case core::{}::{}: return {};", type, value, cpp_string(name)));
    out.close();
    out.line("return \"?\";");
    out.close();
}

}  // namespace

bool StatePrinters::is_frame_type(const std::string& type) const {
    const auto& units = generation_.component.units;
    return std::ranges::any_of(units, [&](const Unit& unit) { return unit.frame + "<Types>" == type; });
}

bool StatePrinters::words_of_logs() const {
    const auto any = [&](const FrameLayout& layout) {
        return std::ranges::any_of(layout.fields, [&](const Field& field) {
            return !is_frame_type(field.type) && is_compound(held_type(field.type));
        });
    };
    return any(core_.layout) ||
           std::ranges::any_of(core_.machines, [&](const MachineCode& machine) { return any(machine.layout); });
}

/// Returns whether the type is an enumeration of the machines' code, or one of the model.
bool StatePrinters::is_named_type(const std::string& type) const {
    const auto of_code = [&](const MachineCode& machine) {
        return std::ranges::any_of(machine.enumerations,
                                   [&](const Enumeration& enumeration) { return enumeration.name == type; });
    };
    const auto of_model = [&](ir::TypeId id) {
        return named_type(generation_.system.type(id)) && cpp_type(generation_.system, id) == type;
    };
    const auto& declared = generation_.component.enumerations;
    return std::ranges::any_of(core_.machines, of_code) || std::ranges::any_of(declared, of_model);
}

std::string StatePrinters::value_printer(const std::string& type, const std::string& value) const {
    if (type == "bool") return fmt::format("text.add({} ? \"true\" : \"false\");", value);
    const bool number = type == "Real" || type == "Nat" || type == "Int";
    if (number && numbers_ == Numbers::deployed) return fmt::format("robochart::add_number(text, {});", value);
    if (number) return fmt::format("text.add({}.raw(), {}Carrier::scale);", value, type);
    if (is_compound(type)) return fmt::format("robochart::add_value(text, {});", value);
    if (is_named_type(type)) return fmt::format("text.add(name({}));", value);
    return fmt::format("text.add(static_cast<std::int64_t>({}), 1);", value);
}

/// Prints a frame. An operation that does not run is in its initial state.
void StatePrinters::print_frame(CodeWriter& out, const Field& field) const {
    out.open(fmt::format("if (!(f.{} == core::{}<Checking>{{}})) {{", field.name,
                         field.type.substr(0, field.type.size() - std::string_view("<Types>").size())));
    out.line(fmt::format("print(text, \"{}.\", f.{});", field.name, field.name));
    out.close();
}

void StatePrinters::print_field(CodeWriter& out, const Field& field) const {
    if (is_filler(field)) return;
    if (is_frame_type(field.type)) return print_frame(out, field);
    out.line(fmt::format("text.item(prefix, \"{}\");", field.name == "at" ? "state" : field.name));
    if (field.type == "robochart::Flag")
        return out.line(fmt::format("text.add(f.{}.full() ? \"full\" : \"-\");", field.name));
    if (!field.type.starts_with(buffer)) return out.line(value_printer(field.type, "f." + field.name));
    out.open(fmt::format("if (f.{}.full()) {{", field.name));
    out.line(value_printer(held_type(field.type), fmt::format("f.{}.value", field.name)));
    out.reopen_block("} else {");
    out.line("text.add(\"-\");");
    out.close();
}

void StatePrinters::name_functions(CodeWriter& out) const {
    std::vector<std::pair<std::string, std::string>> names;
    for (const MachineCode& machine : core_.machines) {
        for (const Enumeration& enumeration : machine.enumerations) {
            names.clear();
            for (const Enumerator& value : enumeration.values) names.emplace_back(value.name, value.name);
            name_function(out, enumeration.name, names);
        }
    }
    for (const ir::TypeId id : generation_.component.enumerations) {
        const ir::Type& type = generation_.system.type(id);
        if (!named_type(type)) continue;
        names.clear();
        for (std::size_t literal = 0; literal < type.labels.size(); ++literal)
            names.emplace_back(literal_name(type, literal), type.labels[literal]);
        name_function(out, cpp_type(generation_.system, id), names);
    }
}

void StatePrinters::print_unit(CodeWriter& out, std::size_t unit) const {
    out.gap();
    out.open(
        fmt::format("[[maybe_unused]] void print(robochart::Text& text, const char* prefix, const "
                    "core::{}<Checking>& f) noexcept {{",
                    generation_.component.units[unit].frame));
    const std::vector<Field>& fields = core_.machines[unit].layout.fields;
    for (const Field& field : fields)
        if (field.name == "at") print_field(out, field);
    for (const Field& field : fields)
        if (field.name != "at") print_field(out, field);
    out.close();
}

void StatePrinters::print_composed(CodeWriter& out) const {
    out.gap();
    out.open("void print(robochart::Text& text, [[maybe_unused]] const char* prefix, const State& f) noexcept {");
    for (const Part& part : generation_.component.parts)
        out.line(fmt::format("print(text, \"{0}.\", f.{0});", part.tag));
    for (const Field& field : core_.layout.fields)
        if (!is_frame_type(field.type)) print_field(out, field);
    out.close();
}

void StatePrinters::write(CodeWriter& out, Numbers numbers) {
    numbers_ = numbers;
    name_functions(out);
    for (std::size_t unit = 0; unit < core_.machines.size(); ++unit) print_unit(out, unit);
    if (generation_.component.is_composed()) print_composed(out);
}

}  // namespace robochart::cpp_emit
