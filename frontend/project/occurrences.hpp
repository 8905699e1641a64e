// SPDX-License-Identifier: Apache-2.0
// The occurrences of every name of a project with their targets. Go-to-definition, references and renaming use them.
#pragma once

#include <string>
#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// The kind of the target of a name, as far as it is known.
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

/// The use of a variable, clock or event.
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

/// All names of a resolved model outside its libraries, by place. Names inside CSP blocks and parts of other tools are
/// not resolved.
[[nodiscard]] std::vector<Occurrence> find_occurrences(const Model& model);

/// The member of a declaration with this name: components and nodes inside it, literals, fields, and members of its
/// interfaces. References are followed. Null if there is none.
[[nodiscard]] const Declaration* member_of(const Declaration& declaration, std::string_view name);
/// All members in textual order; own members come first.
[[nodiscard]] std::vector<const Declaration*> members_of(const Declaration& declaration);

}  // namespace robochart::frontend
