// SPDX-License-Identifier: Apache-2.0
// The part of a budget that long loops use. It has few includes, because many headers name it.
#pragma once

namespace robochart::diagnostics {

/// The interface of budgets for long loops. It is implemented by the budget of the run (Budget), by the budget of a
/// check (refine::Budget), and by budgets that add limits to another budget.
class Pollable {
public:
    /// Must be called in every loop whose length depends on the input. Throws LimitReached to end the work.
    virtual void poll() = 0;

protected:
    ~Pollable() = default;
};

/// A budget without limits.
class Unlimited final : public Pollable {
public:
    void poll() override {}
};

/// For work that no budget limits. Any thread may poll it.
inline constinit Unlimited unlimited;

}  // namespace robochart::diagnostics
