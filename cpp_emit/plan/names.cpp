// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/names.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "cpp_emit/plan/reserved.hpp"

namespace robochart::cpp_emit {

namespace {

// The keywords of ISO C++20 [lex.key], [lex.digraph], [lex.name], and then the macros that compilers define without a
// header.
constexpr std::array keywords = {
    "alignas",     "alignof",  "and",        "and_eq",    "asm",       "auto",         "bitand",
    "bitor",       "bool",     "break",      "case",      "catch",     "char",         "char16_t",
    "char32_t",    "char8_t",  "class",      "co_await",  "co_return", "co_yield",     "compl",
    "concept",     "const",    "const_cast", "consteval", "constexpr", "constinit",    "continue",
    "decltype",    "default",  "delete",     "do",        "double",    "dynamic_cast", "else",
    "enum",        "explicit", "export",     "extern",    "false",     "float",        "for",
    "friend",      "goto",     "if",         "inline",    "int",       "long",         "mutable",
    "namespace",   "new",      "noexcept",   "not",       "not_eq",    "nullptr",      "operator",
    "or",          "or_eq",    "private",    "protected", "public",    "register",     "reinterpret_cast",
    "requires",    "return",   "short",      "signed",    "sizeof",    "static",       "static_assert",
    "static_cast", "struct",   "switch",     "template",  "this",      "thread_local", "throw",
    "true",        "try",      "typedef",    "typeid",    "typename",  "union",        "unsigned",
    "using",       "virtual",  "void",       "volatile",  "wchar_t",   "while",        "xor",
    "xor_eq",      "import",   "module",     "linux",     "unix",      "i386",         "main",
    "std",         "final",    "override",
};

bool is_listed(std::span<const std::string_view> names, std::string_view name) {
    return std::ranges::binary_search(names, name);
}

/// Returns whether the name is a macro of the headers that are delivered with generated code.
bool is_runtime_macro(std::string_view name) {
    return name.starts_with("ROBOCHART_") || name.starts_with("RC_");
}

/// Returns an identifier that becomes unique if a suffix is appended.
std::string stem_of(std::string_view text) {
    const std::string name = to_identifier(text);
    return is_runtime_macro(name) ? "model_" + name : name;
}

bool identifier_character(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

}  // namespace

bool reserved_in_cpp(std::string_view name) {
    return std::ranges::find(keywords, name) != keywords.end() || is_listed(reserved_macros(), name) ||
           is_runtime_macro(name);
}

bool reserved_below_global_scope(std::string_view name) {
    // The namespace of the runtime, and then names that the projects' own code declares or includes.
    static constexpr std::array outside = {"robochart", "rclcpp", "Body", "CVector2", "Eigen",
                                           "Enki",      "Eye",    "Puck", "argos",    "testing"};
    return reserved_in_cpp(name) || std::ranges::find(outside, name) != outside.end();
}

bool reserved_at_global_scope(std::string_view name) {
    return reserved_below_global_scope(name) || is_listed(reserved_globals(), name) ||
           is_listed(reserved_own_types(), name) || is_listed(reserved_own_members(), name);
}

std::set<std::string> own_type_names() {
    return {reserved_own_types().begin(), reserved_own_types().end()};
}

std::set<std::string> own_member_names() {
    return {reserved_own_members().begin(), reserved_own_members().end()};
}

std::string to_identifier(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (identifier_character(c)) {
            result += c;
        } else if (!result.empty() && result.back() != '_') {
            result += '_';
        }
    }
    if (result.empty()) result = "unnamed";
    if (std::isdigit(static_cast<unsigned char>(result.front())) != 0) result.insert(0, "n");
    return result;
}

std::vector<std::string> parameter_identifiers(const std::vector<std::string>& names) {
    NameScope scope(own_member_names());
    std::vector<std::string> result;
    for (const std::string& name : names) result.push_back(scope.unique_name(name));
    return result;
}

/// Returns the identifier of a bound variable. If the underscores of the name make it invalid as an identifier, they
/// are encoded after the prefix "bound_0". This is unique, because no name begins with a digit.
std::string bound_identifier(std::string_view name) {
    if (to_identifier(name) == name) return "bound_" + std::string(name);
    std::string result = "bound_0";
    for (const char c : name) result += c == '_' ? "_u" : std::string(1, c);
    return result;
}

std::string NameScope::unique_name(std::string_view text) {
    const std::string base = stem_of(text);
    std::string name = reserved_(base) ? base + "_" : base;
    for (unsigned number = 2; reserved_(name) || !taken_.insert(name).second; ++number)
        name = base + "_" + std::to_string(number);
    return name;
}

std::string NameScope::numbered_name(std::string_view stem) {
    const std::string base = stem_of(stem) + "_";
    for (unsigned number = 1;; ++number) {
        std::string name = base + std::to_string(number);
        if (!reserved_(name) && taken_.insert(name).second) return name;
    }
}

}  // namespace robochart::cpp_emit
