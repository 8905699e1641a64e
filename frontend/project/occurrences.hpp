// The occurrences of every name of a project with their targets: the basis of go-to-definition, references and
// renaming.
#pragma once

#include <string>
#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// What a name stands for, as far as it is known.
enum class NameKind {
    declaration,    ///< `target`
    package,        ///< a package or the first parts of its name: `text` is the name so far, `A::B`
    core_type,      ///< nat, int, real, boolean, string: `target` in package core
    type_variable,  ///< ?X
    assertion,      ///< the name of an assertion: `text`
    process,        ///< a CSP process or block: `text`
    definition,     ///< what serves probabilistic assertions: `text` is its word and name, `label l`
    unknown,        ///< found nowhere; a finding says so
};

/// How a variable, clock or event is used.
enum class Access { none, read, write };

/// One name at one place. Each part of a qualified name is an occurrence of its own.
struct Occurrence {
    Span span;
    NameKind kind = NameKind::unknown;
    const Declaration* target = nullptr;
    std::string text = {};  ///< package, assertion, process, definition
    bool declares = false;
    Access access = Access::none;
};

/// All names of a resolved model outside its libraries, by place. Inside CSP blocks and parts of other tools
/// nothing is resolved.
[[nodiscard]] std::vector<Occurrence> occurrences(const Model& model);

/// The member of a declaration with this name: parts and nodes inside it, literals, fields, and what its interfaces
/// bring; references are followed. Null if there is none.
[[nodiscard]] const Declaration* member_of(const Declaration& declaration, std::string_view name);
/// All such members, in textual order, own ones first.
[[nodiscard]] std::vector<const Declaration*> members_of(const Declaration& declaration);

}  // namespace robochart::frontend
