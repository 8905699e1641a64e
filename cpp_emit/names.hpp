// Names of generated C++: every name of the model becomes a legal identifier that is used once in its scope.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace robochart::cpp_emit {

/// True for C++20 keywords, alternative tokens and names the language or its macros reserve.
[[nodiscard]] bool reserved_in_cpp(std::string_view name);

/// Turns any text into an identifier: other characters become '_', doubled and leading underscores go.
[[nodiscard]] std::string identifier(std::string_view text);

/// Hands out names that collide neither with each other nor with C++.
class NameScope {
public:
    NameScope() = default;
    /// Names the generated code itself uses in this scope.
    explicit NameScope(std::set<std::string> taken) : taken_(std::move(taken)) {}

    /// `wanted`, made an identifier; with a number behind it if the scope has it already.
    [[nodiscard]] std::string unique(std::string_view wanted);
    /// `stem`_1, `stem`_2, ...: the first that is free.
    [[nodiscard]] std::string numbered(std::string_view stem);

private:
    std::set<std::string> taken_;
};

}  // namespace robochart::cpp_emit
