// SPDX-License-Identifier: Apache-2.0
#include "tests/random_models/models/hostile.hpp"

namespace robochart::random_models {

const std::vector<std::string_view>& hostile_names() {
    static const std::vector<std::string_view> names = {
        // CSPM: keywords, and functions and processes that exist in every script.
        "CHAOS", "DIV", "RUN", "SKIP", "STOP", "WAIT", "USTOP", "TRUE", "Bool", "Int", "Char", "Events", "Proc",
        "Timed", "assert", "channel", "subtype", "nametype", "external", "transparent", "normal", "within", "and", "or",
        "card", "head", "tail", "length", "member", "diff", "union", "Union", "inter", "Inter", "null", "elem", "set",
        "seq", "Map", "concat", "empty", "extensions", "productions", "error", "show", "mapLookup", "tock", "terminate",
        "timed_priority", "print", "explicate", "loop_", "TIDS", "step", "OneStep",
        // Declarations of generated scripts.
        "D__", "O__", "AS_O__", "STM", "HEXT__", "core_nat", "core_int", "core_clock_type", "Plus", "Minus", "NIDS",
        "SIDS", "IIDS", "FVS", "internal__", "Timer", "clockReset", "enter", "entered", "interrupt", "instantiations",
        "const_x", "get_v", "set_v", "sharedVar", "x__", "M__1", "a__b", "_x", "__y", "_", "__", "x_1", "S_1",
        // C++: keywords, headers, and names that generated code uses.
        "class", "template", "typename", "namespace", "new", "delete", "this", "bool", "operator", "static", "virtual",
        "private", "public", "return", "switch", "default", "auto", "register", "volatile", "xor", "bitand", "not_eq",
        "co_await", "concept", "constexpr", "thread_local", "char8_t", "alignas", "asm", "goto", "union_", "std",
        "main", "abort", "exit_", "time", "read", "write", "open", "close", "printf", "signal", "size_t", "uint8_t",
        "int32_t", "errno", "stdin", "EOF", "NULL", "NAN", "INFINITY", "BUFSIZ", "EXIT_SUCCESS", "SEEK_SET", "RAND_MAX",
        "INT_MAX", "UINT8_MAX", "assert_", "M_PI", "HUGE_VAL", "unix", "linux", "signbit", "robochart", "Nat", "Real",
        "Boolean", "Types", "State", "Inputs", "Outputs", "Platform", "Controller", "Step", "inputs", "outputs",
        "state_", "value", "values", "it", "core", "explore", "reset", "init", "spend", "pick", "wait_", "since_",
        "none", "other", "self", "data", "size", "begin", "make", "at", "index", "Checking", "Module0_core", "Carrier",
        "NatCarrier", "Finite", "Logged", "rc_interface", "robochart_explore",
        // Other languages.
        "con", "nul", "aux", "CMakeLists", "all", "clean", "test", "install", "package_", "a", "A", "ID", "id", "Self"};
    return names;
}

const std::vector<std::string_view>& hostile_strings() {
    static const std::vector<std::string_view> strings = {
        R"("")",
        R"("\"")",
        R"("\\")",
        R"("\\\"")",
        R"("a\nb")",
        R"("a\tb\rc")",
        R"('it\'s')",
        R"('say "go"')",
        R"("*/ int x; /*")",
        R"("// gone")",
        R"("{- open")",
        R"("-- gone")",
        R"("${CMAKE_SOURCE_DIR}")",
        R"x("$(touch PWNED)")x",
        R"("`touch PWNED`")",
        R"("\"); std::abort(); (\"")",
        R"("%s%n{}{0}")",
        R"("</text><script>")",
        R"("??/")",
        R"x(")\"")x",
        R"("#include <x>")",
        R"("csp-end")",
        R"("é€𝄞")",
        R"("a;b;c")",
    };
    return strings;
}

}  // namespace robochart::random_models
