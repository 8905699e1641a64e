// SPDX-License-Identifier: Apache-2.0
// Parses the types in annotations, which the reader of scripts stores as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "checker/cspm/types/type.hpp"

namespace robochart::cspm::types {

/// A type as an annotation contains it. Kind `variable`: any name. An extendable has two parts: its variable and its
/// result. The last part of a function is its result.
struct WrittenType {
    TypeKind kind = TypeKind::variable;
    std::string name;
    std::vector<WrittenType> args;
};
struct WrittenScheme {
    std::vector<std::pair<Constraint, std::string>> constraints;
    WrittenType type;
};

/// Parses a text that the reader of scripts has accepted (parse_type.cpp).
[[nodiscard]] WrittenScheme read_type(std::string_view text);

}  // namespace robochart::cspm::types
