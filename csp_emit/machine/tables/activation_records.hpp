// Machines and called operations: which parameter holds which variable, clock and counter of each.
// An operation works on its caller's variables, clocks and events of the same name (semantics 3.8).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "csp_emit/expressions/expressions.hpp"
#include "csp_emit/machine/tables/call_graph.hpp"
#include "csp_emit/machine/tables/clock_limits.hpp"
#include "csp_emit/machine/tables/parameters.hpp"

namespace robochart::csp_emit {

/// A machine, or an operation called at one place of it.
struct Frame {
    const ir::Machine* machine = nullptr;
    std::uint32_t parent = 0;
    std::string prefix;                         ///< in front of its names: "Turn_"
    std::vector<CellId> variables;              ///< by VariableId; required ones are the caller's
    std::vector<std::optional<CellId>> clocks;  ///< by ClockId; those that nothing reads have none
    std::optional<ir::ClockId> watched;         ///< the clock MachineContext::watched
    std::vector<std::string> announced;         ///< by ClockId: CLID_C where a reset is an event; empty otherwise
    std::vector<cspm::ExprPtr> constants;       ///< by ConstantId
    std::vector<std::string> events;            ///< by EventId: the channel
    std::vector<CellId> own;                    ///< cells that live while the frame does
    std::map<std::uint32_t, CellId> monitors;   ///< by TransitionId: deadlines of transitions
};

/// Owns the frames: number 0 is the machine, the others are operations where they are called.
class ActivationRecords {
public:
    /// Opens the frame of the machine.
    ActivationRecords(const MachineContext&, const CallGraph&, ParameterTable&, ClockLimits&);

    [[nodiscard]] const Frame& operator[](std::uint32_t frame) const { return frames_[frame]; }
    [[nodiscard]] const Frame& root() const { return frames_.front(); }
    /// The frame of the operation that the statement of `caller` calls.
    std::uint32_t called(std::uint32_t caller, const ir::Stmt& call, const ir::Machine& operation);
    /// One frame of the operation for all callers that mean the same by the names of variables and clocks that it
    /// requires.
    std::uint32_t shared(std::uint32_t caller, const ir::Machine& operation);

    /// What the names of expressions stand for in a frame.
    [[nodiscard]] Scope scope(std::uint32_t frame, const Values&, cspm::ExprPtr trigger_value = nullptr) const;
    /// The definition of the operation where the frame's machine calls it; null if the call is an event.
    [[nodiscard]] const ir::Machine* definition(std::uint32_t frame, ir::OperationId) const;
    /// The constructor of the event clockReset that a reset of the clock is; null if it is no event.
    [[nodiscard]] const std::string* announced(std::uint32_t frame, ir::ClockId) const;
    /// The full time of a transition's deadline, by the cell that counts it down (semantics 3.10).
    [[nodiscard]] cspm::ExprPtr full_time(CellId monitor, const Values&) const;
    /// A reset on a transition as a statement, where it is an event.
    [[nodiscard]] const ir::Stmt* reset_statement(std::uint32_t frame, ir::TransitionId, ir::ClockId);

private:
    std::uint32_t open(const ir::Machine&, std::uint32_t parent, const std::string& prefix);
    void add_variables(Frame&, bool root);
    void add_constants(Frame&) const;
    void add_events(Frame&, bool root) const;
    void add_clocks(Frame&, bool root);
    void add_clock(Frame&, ir::ClockId, bool outside);
    bool read_somewhere(const ir::Machine& opened, ir::ClockId) const;
    void add_monitors(Frame&);
    void find_watched(Frame&, bool root) const;
    const Project& project() const { return *context_.project; }

    const MachineContext& context_;
    const CallGraph& calls_;
    ParameterTable& cells_;
    ClockLimits& limits_;
    std::vector<Frame> frames_;
    std::map<std::pair<std::uint32_t, const ir::Stmt*>, std::uint32_t> called_;
    std::map<std::string, std::uint32_t> shared_;  ///< by what the caller means by the required names
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, ir::Stmt> reset_statements_;
};

/// Whether the clock is that of the caller, and the machine is an operation on its own.
[[nodiscard]] bool is_callers(const ir::Machine&, const ir::Clock&);

}  // namespace robochart::csp_emit
