// The names of a project and how they are found (language reference 1.3): private to the front end.
#pragma once

#include <initializer_list>
#include <map>
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
        for (const DeclKind kind : kinds) bits_ |= 1U << static_cast<unsigned>(kind);
    }
    [[nodiscard]] bool has(DeclKind kind) const { return (bits_ >> static_cast<unsigned>(kind) & 1U) != 0; }

private:
    std::uint64_t bits_ = 0;
};

/// Where a name is written: its file and the declaration around it (may be null).
struct Place {
    const File* file = nullptr;
    const Declaration* inside = nullptr;
};

/// How near two files are: all for a file itself, else the folders that both lie in; toolkits are farther than any
/// file.
[[nodiscard]] std::size_t nearness(const File& a, const File& b);

/// All names declared at package level or inside components, by their full name `P::C::S`.
class Names {
public:
    /// Enters every file and sets the `parent` of every declaration.
    explicit Names(const Model& model);

    /// What a name stands for at a place: the enclosing declarations, the package, its imports, unnamed packages.
    /// Null if there is nothing of these kinds. Of several declarations of one name that of the nearest file is meant
    /// (`nearness`): projects that lie side by side may use the same names.
    [[nodiscard]] const Declaration* find(const Place& place, const QualifiedName& name, const Kinds& kinds) const;
    /// All declarations entered under a full name.
    [[nodiscard]] const std::vector<const Declaration*>& all(const std::string& full_name) const;
    /// Simple names of everything of these kinds, for suggestions.
    [[nodiscard]] std::vector<std::string> candidates(const Kinds& kinds) const;
    /// Any declaration with this simple name and kind, wherever it is; the first by full name.
    [[nodiscard]] const Declaration* anywhere(std::string_view simple_name, const Kinds& kinds) const;
    /// The first interface, by its full name, that declares an event, clock, variable (or constant) or operation
    /// signature of this name; null if there is none.
    [[nodiscard]] const Context* interface_with(std::string_view name, DeclKind kind) const;
    /// The name of a type in messages: with its package where another type has its name.
    [[nodiscard]] std::string type_name(const TypeDeclaration& type) const;
    /// `P::C::S` of an entered declaration.
    [[nodiscard]] std::string full_name(const Declaration* declaration) const;
    /// Do the parts before the last name what the declaration is in: `I::v` or `P::I::v` for `v` of `P::I`?
    [[nodiscard]] bool qualifies(const QualifiedName& name, const Declaration& member) const;
    /// Is there a file of this package?
    [[nodiscard]] bool has_package(const std::string& name) const;
    /// Is it a package, or does one begin with it (`A` of `A::B`)?
    [[nodiscard]] bool leads_to_package(const std::string& name) const;
    /// The packages that have files, sorted; "" is the unnamed one.
    [[nodiscard]] const std::vector<std::string>& packages() const { return packages_; }
    /// May it be declared in text that was not understood? Then nothing is known about it.
    [[nodiscard]] bool is_lost(const QualifiedName& name) const;
    /// Was that asked since this was last called?
    [[nodiscard]] bool take_asked_lost() const { return std::exchange(asked_lost_, false); }
    /// Parts of the longest full name or package: what is written with more names no declaration as a whole.
    [[nodiscard]] std::size_t most_parts() const { return most_parts_; }
    [[nodiscard]] const std::map<std::string, std::vector<const Declaration*>>& entries() const { return by_name_; }

private:
    void enter_file(File& file);
    void lose(const Context& interface);
    void enter(Declaration& declaration, const Declaration* parent, const std::string& prefix);
    void enter_type(TypeDeclaration& type, const std::string& prefix);
    void enter_component(Component& component, const std::string& full);
    [[nodiscard]] const Declaration* at(const std::string& full, const Kinds& kinds, const File* file,
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
