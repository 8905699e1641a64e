// SPDX-License-Identifier: Apache-2.0
// The static types of CSPM scripts by FDR's rules (FDR manual, chapter CSPM, "Type system"): Hindley-Milner with
// constraints, dotted types for channels and constructors, and modules. Evaluating a well-typed script causes no
// dynamic type errors.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

/// A name at the script's top level (or in a module, qualified) with its type in FDR's notation: `Eq a => ({a}, a) ->
/// Bool`.
struct NamedType {
    std::string name;
    Span span;
    std::string type;
};

/// A declared or predefined name.
struct KnownName {
    std::string name;  ///< qualified
    Span span;         ///< span of its declaration, or only of the name for a variable; unknown if it is predefined
    std::string type;  ///< in FDR's notation; "" if the declaration is ill-typed
};

/// A place where a name occurs, including the beginning of each equation of a function.
struct NameUse {
    Span span;
    std::size_t name = 0;  ///< index into `NameTable::names`
};

/// Maps places in a script to declarations of names, for editors.
struct NameTable {
    std::vector<KnownName> names;
    std::vector<NameUse> uses;  ///< sorted by place
};

/// Checks names and types of a whole script (files with their includes in place, `read_file`); findings are CSPM-T
/// rules. Returns the types of its names in the order of declaration. Names of ill-typed declarations have no type.
/// Wrong input causes findings and never exceptions. Types that are too deep or too large are findings too. `table`, if
/// not null, is filled with all names by place.
std::vector<NamedType> check_types(const Script& script, diagnostics::Diagnostics& diagnostics,
                                   NameTable* table = nullptr);

}  // namespace robochart::cspm
