// SPDX-License-Identifier: Apache-2.0
// Defines the part of a budget that long loops use. This header has few includes, because many headers include it.
#pragma once

namespace robochart::diagnostics {

/// The interface of budgets for long loops. Its implementations are the budget of the run (Budget), the budget of a
/// check (refine::Budget), and budgets that add limits to another budget.
class Pollable {
public:
    /// Every loop whose length depends on the input must call this function. Throws LimitReached to end the work.
    virtual void poll() = 0;

protected:
    ~Pollable() = default;
};

/// A budget without limits.
class Unlimited final : public Pollable {
public:
    void poll() override {}
};

/// The budget for work without limits. Any thread may poll it.
inline constinit Unlimited unlimited;

}  // namespace robochart::diagnostics
