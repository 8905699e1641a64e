// SPDX-License-Identifier: Apache-2.0
// Makes names that are not reserved. Reserved words are those of the FDR manual (CSPM: definitions, built-in
// definitions) and of library.cpp.
#include "csp_emit/base/names.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/diagnostics/scanner.hpp"
#include "checker/cspm/types/builtins.hpp"
#include "csp_emit/base/library.hpp"

namespace robochart::csp_emit {
namespace {

// Keywords and predefined names that the generated text uses.
constexpr std::array reserved_names{"and",
                                    "or",
                                    "not",
                                    "if",
                                    "then",
                                    "else",
                                    "let",
                                    "within",
                                    "channel",
                                    "datatype",
                                    "subtype",
                                    "nametype",
                                    "module",
                                    "exports",
                                    "endmodule",
                                    "instance",
                                    "assert",
                                    "print",
                                    "include",
                                    "transparent",
                                    "external",
                                    "Timed",
                                    "true",
                                    "false",
                                    "STOP",
                                    "SKIP",
                                    "DIV",
                                    "RUN",
                                    "CHAOS",
                                    "WAIT",
                                    "Events",
                                    "Int",
                                    "Bool",
                                    "Char",
                                    "Proc",
                                    "Set",
                                    "Seq",
                                    "union",
                                    "inter",
                                    "diff",
                                    "Union",
                                    "Inter",
                                    "member",
                                    "card",
                                    "empty",
                                    "set",
                                    "seq",
                                    "head",
                                    "tail",
                                    "concat",
                                    "elem",
                                    "length",
                                    "null",
                                    "error",
                                    "show",
                                    "extensions",
                                    "productions",
                                    "Map",
                                    "prioritise",
                                    "timed_priority",
                                    "sbisim",
                                    "dbisim",
                                    "diamond",
                                    "in",
                                    "out",
                                    "InOut",
                                    "tock",
                                    "Plus",
                                    "Minus",
                                    "Mult",
                                    "Div",
                                    "Modulus",
                                    "Neg",
                                    "RealMult",
                                    "RealDiv",
                                    "LSeq",
                                    "Relation",
                                    "Function",
                                    "callFunc",
                                    "funcToSet",
                                    "pairs_",
                                    "access_",
                                    "update_",
                                    "no_zero_div",
                                    "clock_type_plus",
                                    "core_nat",
                                    "core_int",
                                    "core_real",
                                    "core_boolean",
                                    "core_string",
                                    "core_clock_type",
                                    "clockReset",
                                    "ClockSet",
                                    "localClockResets",
                                    "USTOP",
                                    "TSKIP",
                                    "StartBy",
                                    "EndBy",
                                    "Deadline",
                                    "EDeadline",
                                    "TimeOut",
                                    "TimeOut_1",
                                    "OneStep",
                                    "wait",
                                    "terminate",
                                    "internal__",
                                    "step__",
                                    "id__",
                                    "r__",
                                    "D__",
                                    "O__",
                                    "VS__",
                                    "VS_O__",
                                    "FVS__",
                                    "FVS_C__",
                                    "HEXT__",
                                    "HEXT",
                                    "HUP__",
                                    "AS_O__",
                                    "STM__",
                                    "TIDS",
                                    "sem__events",
                                    "shared_variable_events",
                                    "enteredSS",
                                    "internal_events",
                                    "Memory",
                                    "MemoryStart__",
                                    "in__",
                                    "d__",
                                    "part__",
                                    "entered",
                                    "real_scale"};

// Predefined functions that only the library and the instantiations call. Both are outside the modules.
constexpr std::array only_at_top{"inter",  "diff", "Union",  "Inter", "set",  "seq",        "head", "tail",
                                 "concat", "elem", "length", "null",  "show", "extensions", "Map",  "productions"};

bool relied_on(const std::string& name) {
    return has_generated_suffix(name) || std::ranges::find(reserved_names, name) != reserved_names.end();
}

}  // namespace

std::string NameManager::unique_name(const std::string& name) {
    // Identifiers in CSPM begin with a letter.
    const bool begins = !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0;
    const std::string proposed = begins ? name : "n" + name;
    if (taken_.insert(proposed).second) return proposed;
    int& suffix = last_suffix_.try_emplace(proposed, 1).first->second;
    for (;;) {
        const std::string result = proposed + "_" + std::to_string(++suffix);
        if (taken_.insert(result).second) return result;
    }
}

std::string bound_name(const std::string& name) {
    return is_identifier(name) ? name + "__q" : "n" + name + "__r";
}

bool has_generated_suffix(const std::string& name) {
    return name.size() > 2 && (name.ends_with("__") || name.ends_with("__q") || name.ends_with("__r"));
}

std::string flatten_name(std::string_view name) {
    std::string result;
    for (std::size_t i = 0; i < name.size(); ++i) {
        if (name[i] == ':' && i + 1 < name.size() && name[i + 1] == ':') ++i;
        const bool plain = std::isalnum(static_cast<unsigned char>(name[i])) != 0;
        result += plain ? name[i] : '_';
    }
    return result;
}

std::string qualified_name(const std::string& package, const std::string& name) {
    return package.empty() ? name : flatten_name(package) + "::" + name;
}

std::string module_name(const ir::Machine& machine) {
    return machine.kind == ir::MachineKind::operation ? "OP_" + machine.name : machine.name;
}

bool is_identifier(const std::string& name) {
    return !name.empty() && diagnostics::begins_name(name.front()) && name.front() != '_' &&
           std::ranges::all_of(name, diagnostics::continues_name);
}

bool is_reserved(const std::string& name) {
    return relied_on(name) || !is_identifier(name) || is_predefined(name) || library_names().contains(name);
}

bool is_reserved_inside(const std::string& name) {
    if (!is_identifier(name) || library_names().contains(name)) return true;
    const cspm::BuiltinName* builtin = cspm::find_builtin(name);
    if (builtin != nullptr && builtin->arguments < 0)
        return true;  // a value: only its name distinguishes it from an event
    return relied_on(name) && std::ranges::find(only_at_top, name) == only_at_top.end();
}

bool is_predefined(const std::string& name) {
    const cspm::BuiltinName* builtin = cspm::find_builtin(name);
    return builtin != nullptr &&
           (builtin->visibility == cspm::Visibility::always || builtin->visibility == cspm::Visibility::timed_sections);
}

void reserve_all(NameManager& names) {
    for (const char* name : reserved_names) names.reserve(name);
    for (const std::string& name : library_names()) names.reserve(name);
    for (const cspm::BuiltinName& builtin : cspm::builtin_names()) names.reserve(std::string(builtin.name));
}

}  // namespace robochart::csp_emit
