// Probabilistic assertions (RoboTool's language, docs/assertions.md) in PRISM's language. The correspondence of both is
// that of RoboTool's translation: `Finally` is F, `a::b::x` a variable, `M is in S` a comparison. Labels, formulas and
// functions are written out where they are used.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "frontend/names/names.hpp"
#include "probability/properties/elements.hpp"
#include "probability/properties/question.hpp"

namespace robochart::probability {

/// What all assertions of a project are translated with.
struct Assertions {
    explicit Assertions(const frontend::Model& of) : model(of), names(of) {}
    const frontend::Model& model;
    frontend::Names names;
};

/// The path of what a name begins with, through references, and how many parts of the name it took.
struct Beginning {
    std::vector<std::string> parts;
    std::size_t used = 0;
    const frontend::Declaration* end = nullptr;  ///< what they lead to
};
[[nodiscard]] Beginning beginning(const Assertions&, const frontend::File&, const frontend::QualifiedName&);

/// The components that an assertion speaks of, outermost parts of paths, each once.
[[nodiscard]] std::vector<std::string> subjects(const Assertions&, const frontend::File&,
                                                const frontend::ProbabilisticAssertion&);

/// Whether it is answered by random paths: `using sim with`, `prob generate path`.
[[nodiscard]] bool simulated(const frontend::ProbabilisticAssertion&);

/// The property. Throws NotExpressed; Wrong where a simulation has wrong parameters.
[[nodiscard]] Question translate(const Assertions&, const frontend::File&, const frontend::ProbabilisticAssertion&,
                                 Elements&);

/// A function that assertions define, applied to arguments; nothing of the model may be in it. Throws NotExpressed.
using Function = std::function<prism::ExprPtr(const std::vector<prism::ExprPtr>&)>;
/// Those that an assertion is `with`, by name. They hold references to what they are made of.
[[nodiscard]] std::map<std::string, Function> functions(const Assertions&, const frontend::File&,
                                                        const frontend::ProbabilisticAssertion&);

}  // namespace robochart::probability
