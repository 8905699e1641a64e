// SPDX-License-Identifier: Apache-2.0
// Lists names that identifiers from the model must not have in C++ (cpp_emit/reserved). scripts/reserved_names.sh
// generates the first two lists. The keywords of C++ are in names.cpp.
#pragma once

#include <span>
#include <string_view>

namespace robochart::cpp_emit {

/// Returns the macros of the headers of C, C++ and POSIX for both compilers, except those that begin with an
/// underscore.
[[nodiscard]] std::span<const std::string_view> reserved_macros();
/// Returns names that the headers of C and POSIX declare at global scope.
[[nodiscard]] std::span<const std::string_view> reserved_globals();
/// Return names that generated cores, and the classes around them, declare themselves.
[[nodiscard]] std::span<const std::string_view> reserved_own_types();
[[nodiscard]] std::span<const std::string_view> reserved_own_members();

}  // namespace robochart::cpp_emit
