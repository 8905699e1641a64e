// SPDX-License-Identifier: Apache-2.0
// Uses one definition of an operation for all its calls (semantics 3.8). While an operation called by the control
// thread runs, its caller only waits, so the configuration contains only the operation. One parameter is the stack of
// return addresses: a sequence of numbers, innermost call first. An operation that is called concurrently with during
// actions, or under a deadline, is inlined: it runs in a configuration with its caller.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "csp_emit/machine/tables/point_table.hpp"

namespace robochart::csp_emit {

/// The point where the machine continues after the call of a shared operation.
struct Continuation {
    std::uint32_t frame = 0;  ///< frame of the operation
    Activation config;        ///< the configuration after the return
    std::string name;         ///< name of its function
};

/// Owns the continuations of shared calls and the values of the stack. Calls are numbered after all have been
/// collected. Until then, the expression node for the number of a call is empty.
class CallSharing {
public:
    CallSharing(ParameterTable& cells, PointTable& points, FamilyCalls& calls)
        : cells_(cells), points_(points), calls_(calls) {}

    /// Pushes the return address of a call on the stack: sets the stack in `inside`.
    void push_return(std::uint32_t frame, const Activation& returned, const Values& values, Values& inside);
    /// Returns the call of the function for the end of the operation.
    [[nodiscard]] cspm::ExprPtr return_from(std::uint32_t frame, const Values&, bool after_tock);
    /// Returns the stack after a call has returned.
    [[nodiscard]] Values stack_after_call(const Continuation&);
    [[nodiscard]] const std::vector<Continuation>& continuations() const { return continuations_; }

    /// Returns the process at the end of an operation, which selects the continuation by the top of the stack.
    [[nodiscard]] cspm::ExprPtr select_continuation(std::uint32_t frame);
    /// Fills in the values of the stack. An operation with a single continuation needs no number.
    void fill_values();
    /// If an operation has a single continuation and this continuation only calls a point, replaces the end of the
    /// operation by that point, and removes the function for the end. `behind` contains the functions of the
    /// continuations.
    void skip_returns(std::vector<Function>& functions, const std::vector<Function>& behind);
    /// Records which parameter is the stack, and the meaning of its values.
    void describe_stack(Candidates&) const;
    /// Declares the functions `top` and `rest` of the stack, if some operation has several continuations.
    void declare_functions(std::vector<cspm::DeclPtr>& decls) const;

private:
    /// The continuations of a shared operation, as indices into `continuations_`. `number` maps the key of a
    /// continuation to its index in this list.
    struct Returns {
        std::map<std::string, std::size_t> number;
        std::vector<std::size_t> continuations;
        std::vector<cspm::ExprPtr> calls;  ///< calls of the function for the operation's end
    };
    /// A value of the stack. Its form depends on whether the operation has a single continuation.
    struct Pending {
        std::uint32_t frame;
        std::shared_ptr<cspm::Expr> value;
        std::optional<std::size_t> pushed;  ///< the number of the continuation; no value: the call pops the top
        cspm::ExprPtr outer;
    };

    ParameterTable& cells_;
    PointTable& points_;
    FamilyCalls& calls_;
    std::optional<CellId> return_stack_;        ///< the stack of active calls
    std::map<std::uint32_t, Returns> returns_;  ///< the returns of each frame
    std::vector<Continuation> continuations_;
    std::vector<Pending> pending_;
};

/// Replaces calls of continuations (the functions from `first` on) by their bodies.
void inline_continuations(std::vector<Function>& functions, std::size_t first);

}  // namespace robochart::csp_emit
