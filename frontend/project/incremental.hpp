// SPDX-License-Identifier: Apache-2.0
// Resolves a project again after single files have changed, for editors. The cost depends on the size of the change.
#pragma once

#include <memory>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// Resolves a model with the same results as `resolve`. A change inside the nodes and transitions of machines affects
/// only assertions and rules about the whole project in other files. After such a change, the names, types and warnings
/// of the other files are reused, and their trees are not changed. After any other change, or if there are hundreds of
/// findings, everything is resolved again.
class Resolution {
public:
    Resolution();
    ~Resolution();
    Resolution(const Resolution&) = delete;
    Resolution& operator=(const Resolution&) = delete;

    /// Replaces the tree of a file in the model by a new one. If possible, the old tree remains and gets the contents
    /// of the new tree, so that pointers into it stay valid.
    void replace(std::unique_ptr<File>& place, std::unique_ptr<File> fresh);
    /// Makes the next `resolve` resolve everything. Must be called after files have been added to the model or removed
    /// from it.
    void forget_results();
    /// Fills the model and reports mistakes, like the function `resolve`. If the budget of `out` runs out during the
    /// call, `forget_results` must be called afterwards.
    void resolve(Model& model, diagnostics::Diagnostics& out);
    /// Returns the number of files whose names and types the last `resolve` resolved.
    [[nodiscard]] std::size_t files_resolved() const;

private:
    class State;
    std::unique_ptr<State> state_;
};

}  // namespace robochart::frontend
