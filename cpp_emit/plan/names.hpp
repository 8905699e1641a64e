// SPDX-License-Identifier: Apache-2.0
// Chooses names in generated C++. Every name of the model becomes a valid identifier that is unique in its scope.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace robochart::cpp_emit {

/// Returns whether a name of the model must be changed in generated code. This is so if it is a keyword or alternative
/// token of C++20, or a macro in a header of C, C++ or POSIX (reserved.hpp).
[[nodiscard]] bool reserved_in_cpp(std::string_view name);
/// Returns whether a namespace with this name would hide names that the generated code inside it uses.
[[nodiscard]] bool reserved_below_global_scope(std::string_view name);
/// Returns whether a namespace with this name at global scope would hide such names, or clash with a name that the
/// headers of C or POSIX declare there.
[[nodiscard]] bool reserved_at_global_scope(std::string_view name);

/// Converts any text to an identifier: other characters become '_', and doubled and leading underscores are removed.
[[nodiscard]] std::string to_identifier(std::string_view text);

/// Returns names for the parameters of one function.
[[nodiscard]] std::vector<std::string> parameter_identifiers(const std::vector<std::string>& names);
/// Returns the identifier of a variable that a quantifier, a lambda or a `let` of the model binds: "bound_x".
[[nodiscard]] std::string bound_identifier(std::string_view name);

/// Return the names that the generated code itself declares. They are reserved in the scopes of the model's types or
/// members.
[[nodiscard]] std::set<std::string> own_type_names();
[[nodiscard]] std::set<std::string> own_member_names();

/// Generates names that differ from each other and from reserved names. If a name is reserved, an underscore is
/// appended, and then a number until the name is unique.
class NameScope {
public:
    using Reserved = bool (*)(std::string_view);

    NameScope(Reserved reserved = reserved_in_cpp) : reserved_(reserved) {}  // NOLINT: the rule of most scopes
    /// `taken` contains names that the generated code itself uses in this scope.
    explicit NameScope(std::set<std::string> taken) : taken_(std::move(taken)) {}

    /// Converts `text` to an identifier, and appends a number if the identifier is in use.
    [[nodiscard]] std::string unique_name(std::string_view text);
    /// Returns the first of `stem`_1, `stem`_2, ... that is not in use.
    [[nodiscard]] std::string numbered_name(std::string_view stem);
    /// Reserves the name.
    void reserve_name(std::string name) { taken_.insert(std::move(name)); }
    [[nodiscard]] bool is_taken(const std::string& name) const { return taken_.count(name) != 0; }

private:
    std::set<std::string> taken_;
    Reserved reserved_ = reserved_in_cpp;
};

}  // namespace robochart::cpp_emit
