// The elements of a model that diagrams show, numbered in the order of the text: an element has one id in all diagrams
// of a run, made of its number and never of its name.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::diagrams {

/// What an id stands for.
struct Element {
    std::string id;    ///< "e17"
    std::string kind;  ///< "state", "entry action", "connection"
    std::string name;  ///< as it is shown; "" where it has none
    diagnostics::Span span;
    diagnostics::Span name_span;
};

/// All elements of a model, but those of the toolkits.
class Elements {
public:
    /// The first has the number `first`: where several models are drawn, none of their elements have the same.
    explicit Elements(const frontend::Model& model, std::size_t first = 1);

    [[nodiscard]] const std::vector<Element>& all() const { return elements_; }
    /// By place in `all`: a declaration, an action, a clause with an interface, a precondition; `none` for other nodes
    /// of the tree.
    [[nodiscard]] std::size_t find(const void* node) const;

private:
    std::vector<Element> elements_;
    std::unordered_map<const void*, std::size_t> places_;  ///< asked only, never walked
};

}  // namespace robochart::diagrams
