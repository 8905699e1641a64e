// SPDX-License-Identifier: Apache-2.0
// Lists the occurrences of all names of a project with their targets, for go-to-definition, references and renaming.
#pragma once

#include <string>
#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// The kind of the target of a name.
enum class NameKind {
    declaration,    ///< `target`
    package,        ///< a package or the first parts of its name; `text` is the name up to here, such as `A::B`
    core_type,      ///< nat, int, real, boolean, string: `target` in package core
    type_variable,  ///< ?X
    assertion,      ///< the name of an assertion: `text`
    process,        ///< a CSP process or block: `text`
    definition,     ///< a definition for probabilistic assertions; `text` is its keyword and name, `label l`
    unknown,        ///< the target was not found; a finding reports this
};

/// How an occurrence uses a variable, clock or event.
enum class Access { none, read, write };

/// A name at a place in a text. Each part of a qualified name is a separate occurrence.
struct Occurrence {
    Span span;
    NameKind kind = NameKind::unknown;
    const Declaration* target = nullptr;
    std::string text = {};  ///< package, assertion, process, definition
    bool declares = false;
    Access access = Access::none;
};

/// Returns all names of a resolved model outside its libraries, by place. Names inside CSP blocks and in parts for
/// other tools are not included.
[[nodiscard]] std::vector<Occurrence> find_occurrences(const Model& model);

/// Returns the member of a declaration with this name: components and nodes inside it, literals, fields, and members of
/// its interfaces. References are followed. Returns null if there is no such member.
[[nodiscard]] const Declaration* member_of(const Declaration& declaration, std::string_view name);
/// Returns all members: first the declaration's own members, then those of its interfaces, each in textual order.
[[nodiscard]] std::vector<const Declaration*> members_of(const Declaration& declaration);

}  // namespace robochart::frontend
