// SPDX-License-Identifier: Apache-2.0
// Highlights names semantically. The editor's grammar highlights keywords and literals.
#include "editors/server/features/models.hpp"

namespace robochart::lsp {

namespace {

using frontend::DeclKind;
using frontend::NameKind;
using frontend::Occurrence;

// The index of a type is its number in the protocol.
constexpr const char* types[] = {"namespace", "type",     "enum",     "enumMember", "struct",
                                 "interface", "class",    "function", "method",     "parameter",
                                 "variable",  "property", "event",    "label",      "typeParameter"};
enum Type {
    namespace_,
    type,
    enum_,
    enum_member,
    struct_,
    interface,
    class_,
    function,
    method,
    parameter,
    variable,
    property,
    event,
    label,
    type_parameter
};
constexpr const char* modifiers[] = {"declaration", "readonly", "modification", "defaultLibrary"};
enum Modifier { declaration = 1, readonly = 2, modification = 4, default_library = 8 };

Type type_of(DeclKind kind) {
    switch (kind) {
        case DeclKind::package:
            return namespace_;
        case DeclKind::primitive_type:
            return type;
        case DeclKind::record_type:
            return struct_;
        case DeclKind::enumeration:
            return enum_;
        case DeclKind::enum_literal:
            return enum_member;
        case DeclKind::interface:
            return interface;
        case DeclKind::function:
            return function;
        case DeclKind::operation_signature:
        case DeclKind::operation:
            return method;
        case DeclKind::parameter:
        case DeclKind::bound_variable:
            return parameter;
        case DeclKind::variable:
        case DeclKind::constant:
        case DeclKind::clock:
            return variable;
        case DeclKind::field:
            return property;
        case DeclKind::event:
            return event;
        case DeclKind::platform:
        case DeclKind::state_machine:
        case DeclKind::controller:
        case DeclKind::module:
        case DeclKind::reference:
        case DeclKind::simulation:
            return class_;
        case DeclKind::connection:
        case DeclKind::state:
        case DeclKind::initial:
        case DeclKind::final:
        case DeclKind::junction:
        case DeclKind::probabilistic:
        case DeclKind::transition:
        case DeclKind::input_context:
        case DeclKind::output_context:
            break;
    }
    return label;
}

Type type_of(const Occurrence& name) {
    switch (name.kind) {
        case NameKind::declaration:
            return type_of(name.target->kind);
        case NameKind::package:
            return namespace_;
        case NameKind::core_type:
            return type;
        case NameKind::type_variable:
            return type_parameter;
        case NameKind::process:
            return function;
        case NameKind::assertion:
        case NameKind::definition:
        case NameKind::unknown:
            break;
    }
    return label;
}

int modifiers_of(const Occurrence& name) {
    int result = name.declares ? declaration : 0;
    if (name.target != nullptr && name.target->kind == DeclKind::constant) result |= readonly;
    if (name.access == frontend::Access::write && !name.declares) result |= modification;
    if (name.kind == NameKind::core_type) result |= default_library;
    return result;
}

}  // namespace

Json semantic_legend() {
    Json names = Json::array();
    for (const char* type : types) names.push_back(type);
    Json extras = Json::array();
    for (const char* modifier : modifiers) extras.push_back(modifier);
    return Json::object({{"tokenTypes", std::move(names)}, {"tokenModifiers", std::move(extras)}});
}

/// Returns five numbers per name: line and column relative to the previous name, length, type, modifiers.
Json Models::semantic_tokens(const Request& request) {
    const Target target = target_of(request);
    const PositionTable positions(target.project.sources(), target.document.source, session_.client.encoding);
    Json data = Json::array();
    std::int64_t last_line = 0;
    std::int64_t last_column = 0;
    for (const Occurrence& name : target.project.current_occurrences()) {
        if (name.span.source != target.document.source || name.kind == NameKind::unknown) continue;
        const Json whole = positions.lsp_range(name.span);
        const View place = whole;
        const std::int64_t line = place["start"]["line"].number_or();
        const std::int64_t column = place["start"]["character"].number_or();
        for (const std::int64_t number :
             {line - last_line, line == last_line ? column - last_column : column,
              place["end"]["character"].number_or() - column, static_cast<std::int64_t>(type_of(name)),
              static_cast<std::int64_t>(modifiers_of(name))})
            data.push_back(number);
        last_line = line;
        last_column = column;
    }
    return Json::object({{"data", std::move(data)}});
}

}  // namespace robochart::lsp
