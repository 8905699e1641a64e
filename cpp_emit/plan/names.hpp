// Names of generated C++: every name of the model becomes a legal identifier that is used once in its scope.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace robochart::cpp_emit {

/// True for what no name of the model may be in generated code: keywords and alternative tokens of C++20, and macros of
/// the headers of C, C++ and POSIX (reserved.hpp).
[[nodiscard]] bool reserved_in_cpp(std::string_view name);
/// A namespace of this name would hide what generated code inside it refers to.
[[nodiscard]] bool reserved_below_global_scope(std::string_view name);
/// The same and what those headers declare at global scope, for namespaces there.
[[nodiscard]] bool reserved_at_global_scope(std::string_view name);

/// Turns any text into an identifier: other characters become '_', doubled and leading underscores go.
[[nodiscard]] std::string identifier(std::string_view text);

/// Names for the parameters of one function.
[[nodiscard]] std::vector<std::string> parameter_identifiers(const std::vector<std::string>& names);
/// A variable that a quantifier, a lambda or a let of the model binds: "bound_x".
[[nodiscard]] std::string bound_identifier(std::string_view name);

/// What generated code calls its own things, which is taken in the scopes where the model's types or members are.
[[nodiscard]] std::set<std::string> own_type_names();
[[nodiscard]] std::set<std::string> own_member_names();

/// Hands out names that collide neither with each other nor with what is reserved. A reserved name gets an underscore
/// behind it, then a number until it is free.
class NameScope {
public:
    using Reserved = bool (*)(std::string_view);

    NameScope(Reserved reserved = reserved_in_cpp) : reserved_(reserved) {}  // NOLINT: the rule of most scopes
    /// Names the generated code itself uses in this scope.
    explicit NameScope(std::set<std::string> taken) : taken_(std::move(taken)) {}

    /// `wanted`, made an identifier; with a number behind it if the scope has it already.
    [[nodiscard]] std::string unique(std::string_view wanted);
    /// `stem`_1, `stem`_2, ...: the first that is free.
    [[nodiscard]] std::string numbered(std::string_view stem);
    /// Nobody gets the name from now on.
    void take(std::string name) { taken_.insert(std::move(name)); }
    [[nodiscard]] bool has(const std::string& name) const { return taken_.count(name) != 0; }

private:
    std::set<std::string> taken_;
    Reserved reserved_ = reserved_in_cpp;
};

}  // namespace robochart::cpp_emit
