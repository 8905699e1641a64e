// SPDX-License-Identifier: Apache-2.0
// Stores the names of a project and looks them up (language reference 1.3). Private to the front end.
#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// A set of declaration kinds.
class Kinds {
public:
    Kinds(std::initializer_list<DeclKind> kinds) {
        for (const DeclKind kind : kinds) bits_ |= std::uint64_t{1} << static_cast<unsigned>(kind);
    }
    [[nodiscard]] bool has(DeclKind kind) const { return (bits_ >> static_cast<unsigned>(kind) & 1U) != 0; }

private:
    std::uint64_t bits_ = 0;
};

/// The place of a name: its file and the declaration around it (may be null).
struct Place {
    const File* file = nullptr;
    const Declaration* inside = nullptr;
    std::optional<Dialect> dialect = std::nullopt;  ///< the dialect of the component; no value: the dialect of the file
};

/// Returns how near two files are: the number of folders that contain both, plus one. A file is nearest to itself.
/// Toolkits are farther away than any other file.
[[nodiscard]] std::size_t file_nearness(const File& a, const File& b);

/// All declarations at package level or inside components, by their full names such as `P::C::S`.
class Names {
public:
    /// Adds the declarations of all files and sets their `parent`.
    explicit Names(const Model& model);

    /// Returns the declaration that a name refers to at a place. Searches the enclosing declarations, then the package,
    /// the imports and unnamed packages. Returns null if no declaration of these kinds is found. If several
    /// declarations have the name, the result is the declaration in the nearest file (`file_nearness`), because
    /// neighbouring projects may use the same names. Components of the place's dialect are preferred to those of the
    /// other dialect.
    [[nodiscard]] const Declaration* find(const Place& place, const QualifiedName& name, const Kinds& kinds) const;
    /// Returns all declarations with this full name.
    [[nodiscard]] const std::vector<const Declaration*>& declarations_of(const std::string& full_name) const;
    /// Returns the simple names of all declarations of these kinds, for suggestions.
    [[nodiscard]] std::vector<std::string> names_of_kinds(const Kinds& kinds) const;
    /// Returns the declaration with this simple name and kind, wherever it is in the project. Of several, returns the
    /// one whose full name comes first in the alphabet.
    [[nodiscard]] const Declaration* find_anywhere(std::string_view simple_name, const Kinds& kinds) const;
    /// Returns the interface that declares an event, clock, variable (or constant) or operation signature of this name,
    /// or null if there is none. If there are several, the first full name in alphabetical order is taken.
    [[nodiscard]] const Context* interface_with(std::string_view name, DeclKind kind) const;
    /// Returns the name of a type in messages, qualified with its package if another type has the same name.
    [[nodiscard]] std::string type_name(const TypeDeclaration& type) const;
    /// Returns the full name of a declaration, such as `P::C::S`.
    [[nodiscard]] std::string full_name(const Declaration* declaration) const;
    /// True if the parts of `name` before the last one name the declaration around `member`: `I::v` or `P::I::v` for
    /// `v` of `P::I`.
    [[nodiscard]] bool is_qualified_by(const QualifiedName& name, const Declaration& member) const;
    /// True if some file belongs to this package.
    [[nodiscard]] bool has_package(const std::string& name) const;
    /// True if the name is a package or the beginning of a package name (`A` of `A::B`).
    [[nodiscard]] bool leads_to_package(const std::string& name) const;
    /// Returns the packages that have files, sorted. The unnamed package is "".
    [[nodiscard]] const std::vector<std::string>& packages() const { return packages_; }
    /// True if the name may be declared in text that could not be parsed, so that it must not be reported as unknown.
    [[nodiscard]] bool is_lost(const QualifiedName& name) const;
    /// True if `is_lost` returned true since the last call of this function.
    [[nodiscard]] bool take_asked_lost() const { return std::exchange(asked_lost_, false); }
    /// Returns how many parts the longest full name or package name has. A name with more parts cannot refer to a whole
    /// declaration.
    [[nodiscard]] std::size_t most_parts() const { return most_parts_; }
    [[nodiscard]] const std::map<std::string, std::vector<const Declaration*>>& entries() const { return by_name_; }

private:
    void enter_file(File& file);
    void mark_lost(const Context& interface);
    void enter_declaration(Declaration& declaration, const Declaration* parent, const std::string& prefix);
    void enter_type(TypeDeclaration& type, const std::string& prefix);
    void enter_component(Component& component, const std::string& full);
    [[nodiscard]] const Declaration* find_nearest(const std::string& full, const Kinds& kinds, const Place& place,
                                                  const Declaration* inside = nullptr) const;
    [[nodiscard]] const File* file_of(const Declaration& declaration) const;

    std::map<std::string, std::vector<const Declaration*>> by_name_;
    std::map<std::string, std::vector<const Declaration*>, std::less<>> by_simple_name_;
    std::map<const Declaration*, std::string> full_names_;
    std::map<const Declaration*, const File*> files_;
    const File* entering_ = nullptr;
    std::vector<std::string> packages_;
    std::set<std::string, std::less<>> lost_;
    bool lost_declarations_ = false;
    mutable bool asked_lost_ = false;
    std::size_t most_parts_ = 0;
};

}  // namespace robochart::frontend
