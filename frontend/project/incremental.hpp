// Resolution for editors: kept in step with a project whose files change one by one, at the cost of what changed.
#pragma once

#include <memory>

#include "diagnostics/diagnostic.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// Gives what `resolve` gives. A change inside the nodes and transitions of machines is seen by no other file, apart
/// from assertions and from rules that look at the whole project: then the names, types and warnings of the other
/// files are kept, and their trees stay as they are. After any other change, and with hundreds of findings, everything
/// is resolved anew.
class Resolution {
public:
    Resolution();
    ~Resolution();
    Resolution(const Resolution&) = delete;
    Resolution& operator=(const Resolution&) = delete;

    /// Puts the new tree of a file into the place of the old one in the model. The old one may live on with the
    /// contents of the new.
    void replace(std::unique_ptr<File>& place, std::unique_ptr<File> fresh);
    /// Files came to the model or left it: the next `resolve` begins anew.
    void forget();
    /// Fills the model and reports what is wrong, as the function of this name does. Where it is ended by the budget of
    /// `out`, `forget` has to follow.
    void resolve(Model& model, diagnostics::Diagnostics& out);
    /// How many files the last `resolve` looked into for names and types.
    [[nodiscard]] std::size_t files_resolved() const;

private:
    class State;
    std::unique_ptr<State> state_;
};

}  // namespace robochart::frontend
