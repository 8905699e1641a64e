// The static types of CSPM scripts, by FDR's rules (FDR manual, chapter CSPM, "Type system"): Hindley-Milner with
// constraints, dotted types that channels and constructors extend to, and modules. A script that passes evaluates
// without a dynamic error of types.
#pragma once

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

/// Checks names and types of a whole script (files with their includes read in place, `read_file`); findings are
/// CSPM-T rules. Returns the types of its names in the order of declaration; a name whose declaration is wrong has
/// none. Never throws for bad input; deep or enormous types are findings too.
std::vector<NamedType> check_types(const Script& script, diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::cspm
