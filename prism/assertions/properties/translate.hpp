// SPDX-License-Identifier: Apache-2.0
// Translates probabilistic assertions (RoboTool's language, docs/assertions.md) to PRISM's language. The translation
// follows RoboTool's: `Finally` becomes F, `a::b::x` becomes a variable, `M is in S` becomes a comparison. Labels,
// formulas and functions are expanded where they are used.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "frontend/names/names.hpp"
#include "prism/assertions/properties/elements.hpp"
#include "prism/assertions/properties/question.hpp"

namespace robochart::probability {

/// The data that all assertions of a project share.
struct Assertions {
    explicit Assertions(const frontend::Model& of) : model(of), names(of) {}
    const frontend::Model& model;
    frontend::Names names;
};

/// The first parts of a name, and the path to which they lead through references. `used` is the number of these parts.
struct Beginning {
    std::vector<std::string> parts;
    std::size_t used = 0;
    const frontend::Declaration* end = nullptr;  ///< the element at the end of the path
};
[[nodiscard]] Beginning path_beginning(const Assertions&, const frontend::File&, const frontend::QualifiedName&);

/// Returns the components that an assertion refers to: the outermost parts of its paths, without duplicates.
[[nodiscard]] std::vector<std::string> subjects_of(const Assertions&, const frontend::File&,
                                                   const frontend::ProbabilisticAssertion&);

/// Returns true if the assertion is answered by random paths: `using sim with`, `prob generate path`.
[[nodiscard]] bool is_simulated(const frontend::ProbabilisticAssertion&);

/// Returns the translated property. Throws NotExpressed, and Wrong if a simulation has wrong parameters.
[[nodiscard]] Question translate_assertion(const Assertions&, const frontend::File&,
                                           const frontend::ProbabilisticAssertion&, Elements&);

/// Applies a function that assertions define to arguments. The function must not use elements of the model. Throws
/// NotExpressed.
using Function = std::function<prism::ExprPtr(const std::vector<prism::ExprPtr>&)>;
/// Returns the functions in the `with` clauses of an assertion, by name. The result keeps references to the arguments.
[[nodiscard]] std::map<std::string, Function> functions_of(const Assertions&, const frontend::File&,
                                                           const frontend::ProbabilisticAssertion&);

}  // namespace robochart::probability
