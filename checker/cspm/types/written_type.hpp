// SPDX-License-Identifier: Apache-2.0
// Parses types in annotations, which the reader stores as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "checker/cspm/types/type.hpp"

namespace robochart::cspm::types {

/// A type with its names as text. The kind `variable` stands for any name. The parts of an extendable are the variable
/// and then the result. The last part of a function is the result.
struct WrittenType {
    TypeKind kind = TypeKind::variable;
    std::string name;
    std::vector<WrittenType> args;
};
struct WrittenScheme {
    std::vector<std::pair<Constraint, std::string>> constraints;
    WrittenType type;
};

/// The reader must have accepted the text (parse_type.cpp).
[[nodiscard]] WrittenScheme read_type(std::string_view text);

}  // namespace robochart::cspm::types
