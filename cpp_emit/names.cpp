#include "cpp_emit/names.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace robochart::cpp_emit {

namespace {

// ISO C++20 [lex.key], [lex.digraph]; then macros of the headers that generated code includes.
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
    "xor_eq",      "assert",   "errno",      "linux",     "unix",      "main",         "NULL",
    "EOF",         "stdin",    "stdout",     "stderr",    "std",       "final",        "override",
};

bool identifier_character(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

}  // namespace

bool reserved_in_cpp(std::string_view name) {
    return std::find(keywords.begin(), keywords.end(), name) != keywords.end();
}

std::string identifier(std::string_view text) {
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

std::string NameScope::unique(std::string_view wanted) {
    const std::string base = identifier(wanted);
    std::string name = reserved_in_cpp(base) ? base + "_" : base;
    for (unsigned number = 2; !taken_.insert(name).second; ++number) name = base + "_" + std::to_string(number);
    return name;
}

std::string NameScope::numbered(std::string_view stem) {
    const std::string base = identifier(stem) + "_";
    for (unsigned number = 1;; ++number) {
        const std::string name = base + std::to_string(number);
        if (taken_.insert(name).second) return name;
    }
}

}  // namespace robochart::cpp_emit
