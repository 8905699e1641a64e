// SPDX-License-Identifier: Apache-2.0
// Numbers the elements of a model that diagrams show, in textual order. An element has one id in all diagrams of a run.
// The id contains the number of the element and not its name.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::diagrams {

/// The element that an id denotes.
struct Element {
    std::string id;    ///< "e17"
    std::string kind;  ///< "state", "entry action", "connection"
    std::string name;  ///< as shown; "" if it has none
    diagnostics::Span span;
    diagnostics::Span name_span;
};

/// All elements of a model, without those of the toolkits.
class Elements {
public:
    /// Numbers the elements from `first` on, so that the elements of several models can get different numbers.
    explicit Elements(const frontend::Model& model, std::size_t first = 1);

    [[nodiscard]] const std::vector<Element>& all_elements() const { return elements_; }
    /// Returns the index in `all_elements` of a declaration, an action, an interface clause or a precondition, or
    /// `none` for other nodes of the tree.
    [[nodiscard]] std::size_t find(const void* node) const;

private:
    std::vector<Element> elements_;
    std::unordered_map<const void*, std::size_t> places_;  ///< for lookup only; the order of pointers is never used
};

}  // namespace robochart::diagrams
