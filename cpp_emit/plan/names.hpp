// SPDX-License-Identifier: Apache-2.0
// Names in generated C++. Every name of the model becomes a valid identifier that is unique in its scope.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace robochart::cpp_emit {

/// Whether a name of the model must be changed in generated code, because it is a keyword or alternative token of
/// C++20, or a macro in a header of C, C++ or POSIX (reserved.hpp).
[[nodiscard]] bool reserved_in_cpp(std::string_view name);
/// Whether a namespace with this name would hide names that the generated code inside it uses.
[[nodiscard]] bool reserved_below_global_scope(std::string_view name);
/// Whether a namespace with this name at global scope would hide such names, or clash with a name that those headers
/// declare at global scope.
[[nodiscard]] bool reserved_at_global_scope(std::string_view name);

/// Converts any text to an identifier: other characters become '_', doubled and leading underscores are removed.
[[nodiscard]] std::string to_identifier(std::string_view text);

/// Names for the parameters of one function.
[[nodiscard]] std::vector<std::string> parameter_identifiers(const std::vector<std::string>& names);
/// The identifier of a variable that a quantifier, a lambda or a `let` of the model binds: "bound_x".
[[nodiscard]] std::string bound_identifier(std::string_view name);

/// The names that the generated code declares itself. They are reserved in the scopes of the model's types or members.
[[nodiscard]] std::set<std::string> own_type_names();
[[nodiscard]] std::set<std::string> own_member_names();

/// Generates names that differ from each other and from reserved names. A reserved name gets an underscore appended,
/// then a number until it is unique.
class NameScope {
public:
    using Reserved = bool (*)(std::string_view);

    NameScope(Reserved reserved = reserved_in_cpp) : reserved_(reserved) {}  // NOLINT: the rule of most scopes
    /// `taken`: names that the generated code itself uses in this scope.
    explicit NameScope(std::set<std::string> taken) : taken_(std::move(taken)) {}

    /// Converts `text` to an identifier, and appends a number if it is in use.
    [[nodiscard]] std::string unique_name(std::string_view text);
    /// The first of `stem`_1, `stem`_2, ... that is not in use.
    [[nodiscard]] std::string numbered_name(std::string_view stem);
    /// Reserves the name.
    void reserve_name(std::string name) { taken_.insert(std::move(name)); }
    [[nodiscard]] bool is_taken(const std::string& name) const { return taken_.count(name) != 0; }

private:
    std::set<std::string> taken_;
    Reserved reserved_ = reserved_in_cpp;
};

}  // namespace robochart::cpp_emit
