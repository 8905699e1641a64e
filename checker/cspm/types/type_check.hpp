// SPDX-License-Identifier: Apache-2.0
// Checks the types of CSPM scripts without running them, by FDR's rules (FDR manual, chapter CSPM, "Type system"):
// Hindley-Milner inference with constraints, dotted types for channels and constructors, and modules. The evaluation of
// a script without findings causes no type errors.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

/// A name at the script's top level, or a qualified name in a module, with its type in FDR's notation: `Eq a => ({a},
/// a) -> Bool`.
struct NamedType {
    std::string name;
    Span span;
    std::string type;
};

/// A declared or predefined name.
struct KnownName {
    std::string name;  ///< qualified
    Span span;         ///< its declaration; for a variable, only its name; unknown if predefined
    std::string type;  ///< in FDR's notation; "" if the declaration is ill-typed
};

/// A place where a name occurs. Each equation of a function is such a place, too.
struct NameUse {
    Span span;
    std::size_t name = 0;  ///< index into `NameTable::names`
};

/// Maps places in a script to declarations of names, for editors.
struct NameTable {
    std::vector<KnownName> names;
    std::vector<NameUse> uses;  ///< sorted by place
};

/// Checks the names and types of a whole script. `read_file` must already have replaced the includes. Findings are
/// CSPM-T rules. Returns the types of the names in the order of declaration; ill-typed declarations have none. Never
/// throws for wrong input: types that are too deep or too large are findings, too. If `table` is not null, it receives
/// all names by place.
std::vector<NamedType> check_types(const Script& script, diagnostics::Diagnostics& diagnostics,
                                   NameTable* table = nullptr);

}  // namespace robochart::cspm
