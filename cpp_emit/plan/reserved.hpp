// Names that a model's may not become in C++, as lists (cpp_emit/reserved); scripts/reserved_names.sh makes the first
// two.
#pragma once

#include <span>
#include <string_view>

namespace robochart::cpp_emit {

/// Macros of the headers of C, C++ and POSIX, of both compilers; without those that begin with an underscore.
[[nodiscard]] std::span<const std::string_view> reserved_macros();
/// What the headers of C and POSIX declare at global scope.
[[nodiscard]] std::span<const std::string_view> reserved_globals();
/// What the cores of generated code call their own things, and the classes around them.
[[nodiscard]] std::span<const std::string_view> reserved_own_types();
[[nodiscard]] std::span<const std::string_view> reserved_own_members();

}  // namespace robochart::cpp_emit
