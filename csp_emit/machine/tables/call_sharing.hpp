// One definition of an operation for all calls of it (semantics 3.8). While an operation runs that the control thread
// has called, its caller only waits: the configuration is the operation's alone, and the return addresses are the value
// of a parameter, a sequence of numbers with the innermost call first: a stack. An operation that is called
// concurrently with during actions, or under a deadline, is inlined: it runs in a configuration with its caller.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "csp_emit/machine/tables/point_table.hpp"

namespace robochart::csp_emit {

/// Where a call of a shared operation returns to.
struct Continuation {
    std::uint32_t frame = 0;  ///< of the operation
    Activation config;        ///< once it has returned
    std::string name;         ///< of its function
};

/// Owns the continuations of shared calls, and the values of the stack. Whether a value needs a number at all is known
/// once all calls are: until then its node is empty.
class CallSharing {
public:
    CallSharing(ParameterTable& cells, PointTable& points, FamilyCalls& calls)
        : cells_(cells), points_(points), calls_(calls) {}

    /// Gives the stack its value inside a call: this return address pushed.
    void push(std::uint32_t frame, const Activation& returned, const Values& values, Values& inside);
    /// The call of the operation's end.
    [[nodiscard]] cspm::ExprPtr return_from(std::uint32_t frame, const Values&, bool after_tock);
    /// The stack once a call has returned.
    [[nodiscard]] Values behind(const Continuation&);
    [[nodiscard]] const std::vector<Continuation>& continuations() const { return continuations_; }

    /// At the end of an operation: the continuation that the top of the stack chooses.
    [[nodiscard]] cspm::ExprPtr dispatch(std::uint32_t frame);
    /// Fills in the values. Operations with one continuation only need no number for it.
    void settle();
    /// Where an operation has one continuation only, which only calls a point, its end is that point: takes the
    /// function of the end away. `behind`: the functions of the continuations.
    void skip_returns(std::vector<Function>& functions, const std::vector<Function>& behind);
    /// Says which parameter is the stack, and what the values given to it mean.
    void describe(Candidates&) const;
    /// The functions `top` and `rest` of the stack, if some operation has several continuations.
    void declare(std::vector<cspm::DeclPtr>& decls) const;

private:
    /// The continuations of a shared operation: indices into `continuations_`, and by key the index in that list.
    struct Returns {
        std::map<std::string, std::size_t> number;
        std::vector<std::size_t> continuations;
        std::vector<cspm::ExprPtr> calls;  ///< of its end
    };
    /// A value of the stack whose form depends on whether the operation has one continuation only.
    struct Pending {
        std::uint32_t frame;
        std::shared_ptr<cspm::Expr> value;
        std::optional<std::size_t> pushed;  ///< the number of the continuation; none: one is popped
        cspm::ExprPtr outer;
    };

    ParameterTable& cells_;
    PointTable& points_;
    FamilyCalls& calls_;
    std::optional<CellId> return_stack_;        ///< of the calls under way
    std::map<std::uint32_t, Returns> returns_;  ///< by frame
    std::vector<Continuation> continuations_;
    std::vector<Pending> pending_;
};

/// Replaces calls of continuations, the functions from `first` on, by their bodies.
void inline_continuations(std::vector<Function>& functions, std::size_t first);

}  // namespace robochart::csp_emit
