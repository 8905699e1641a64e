// Types as written in annotations: the reader keeps their text, this takes it apart.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "checker/cspm/types/type.hpp"

namespace robochart::cspm::types {

/// A type with its names as text. Kind `variable` is any name; extendable: variable, then result; function: result
/// last.
struct WrittenType {
    TypeKind kind = TypeKind::variable;
    std::string name;
    std::vector<WrittenType> args;
};
struct WrittenScheme {
    std::vector<std::pair<Constraint, std::string>> constraints;
    WrittenType type;
};

/// The text must be one the reader has accepted (Parser::type_scheme).
[[nodiscard]] WrittenScheme read_type(std::string_view text);

}  // namespace robochart::cspm::types
