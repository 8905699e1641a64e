// SPDX-License-Identifier: Apache-2.0
// Defines the state that all steps of lowering share: the System under construction, and the ids of declarations of the
// syntax tree. Private to semantics/lower*.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/source.hpp"
#include "frontend/syntax/ast.hpp"
#include "frontend/types/types.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// A map keyed by declarations. It is only used for lookup and never iterated.
template <class T>
using ByDeclaration = std::map<const frontend::Declaration*, T>;

/// Returns the id of a declaration, or an invalid id if the map has none.
template <class Id>
[[nodiscard]] Id look_up(const ByDeclaration<Id>& map, const frontend::Declaration* declaration) {
    const auto it = map.find(declaration);
    return it == map.end() ? Id{} : it->second;
}

struct Lowering {
    const frontend::Model& model;
    const diagnostics::SourceManager& sources;
    diagnostics::Diagnostics& diagnostics;
    System system{};
    std::vector<const frontend::File*> files{};   ///< sorted by path
    ByDeclaration<const frontend::File*> home{};  ///< the file of every declaration at package level
    ByDeclaration<TypeId> declared_types{};
    std::map<std::string, TypeId> types{};  ///< structural key -> id
    ByDeclaration<FunctionId> functions{};
    ByDeclaration<std::vector<FunctionId>> instances{};       ///< instances of generic functions
    std::map<std::string, TypeId> type_variables{};           ///< type variables of the generic function being lowered
    ByDeclaration<MachineId> machines{};                      ///< keyed by frontend::Machine
    ByDeclaration<ControllerId> controllers{};                ///< keyed by frontend::Component
    std::vector<const frontend::Machine*> machine_sources{};  ///< indexed by MachineId
    std::vector<const frontend::Component*> controller_sources{};  ///< indexed by ControllerId
    std::vector<const frontend::Component*> module_sources{};      ///< indexed as System::modules

    /// Returns the package of a declaration ("" if unnamed), taken from the file of its outermost parent.
    [[nodiscard]] std::string package_of(const frontend::Declaration&) const;
    /// Reports RC-S01: "X is not supported yet".
    void report_unsupported(const std::string& what, diagnostics::Span where) const;
    /// Reports RC-S05: "X does not lead to a declaration".
    void report_unresolved(const std::string& what, diagnostics::Span where) const;
    /// Reports RC-S22 if two of these declarations have the same name.
    void check_unique(const std::vector<const frontend::Declaration*>& declarations, const std::string& owner,
                      const std::string& kind) const;
};

/// Returns the declarations that a list owns.
template <class Owners>
[[nodiscard]] std::vector<const frontend::Declaration*> pointers(const Owners& owners) {
    std::vector<const frontend::Declaration*> result;
    for (const auto& owner : owners) result.push_back(owner.get());
    return result;
}

/// Returns the element and place of a declaration.
[[nodiscard]] Origin origin_of(const std::string& element, diagnostics::Span span);

}  // namespace robochart::ir
