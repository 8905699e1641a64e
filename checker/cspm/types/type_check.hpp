// The static types of CSPM scripts, by FDR's rules (FDR manual, chapter CSPM, "Type system"): Hindley-Milner with
// constraints, dotted types that channels and constructors extend to, and modules. A script that passes evaluates
// without a dynamic error of types.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "diagnostics/diagnostic.hpp"

namespace robochart::cspm {

/// A name of the script's top (or of a module, qualified) with its type in FDR's notation: `Eq a => ({a}, a) -> Bool`.
struct NamedType {
    std::string name;
    Span span;
    std::string type;
};

/// A declared or predefined name.
struct KnownName {
    std::string name;  ///< qualified
    Span span;         ///< of its declaration, or of the name alone if it is a variable; unknown if it is predefined
    std::string type;  ///< in FDR's notation; "" if the declaration is wrong
};

/// A place where a name stands; so does the beginning of each equation of a function.
struct NameUse {
    Span span;
    std::size_t name = 0;  ///< number in `NameTable::names`
};

/// Which declaration each name of a script means, by place: for editors.
struct NameTable {
    std::vector<KnownName> names;
    std::vector<NameUse> uses;  ///< by place
};

/// Checks names and types of a whole script (files with their includes read in place, `read_file`); findings are
/// CSPM-T rules. Returns the types of its names in the order of declaration; a name whose declaration is wrong has
/// none. Never throws for bad input; deep or enormous types are findings too. `table`, if there is one, is filled with
/// all names by place.
std::vector<NamedType> check_types(const Script& script, diagnostics::Diagnostics& diagnostics,
                                   NameTable* table = nullptr);

}  // namespace robochart::cspm
