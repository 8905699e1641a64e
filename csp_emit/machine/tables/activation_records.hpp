// SPDX-License-Identifier: Apache-2.0
// Stores the parameters for the variables, clocks and counters of a machine and of each called operation. An operation
// uses the variables, clocks and events of its caller with the same names (semantics 3.8).
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

/// The frame of the machine, or of an operation that the machine calls in one place.
struct Frame {
    const ir::Machine* machine = nullptr;
    std::uint32_t parent = 0;
    std::string prefix;                         ///< prefix of its names: "Turn_"
    std::vector<CellId> variables;              ///< by VariableId; required variables share the caller's cell
    std::vector<std::optional<CellId>> clocks;  ///< by ClockId; no cell if nothing reads the clock
    std::optional<ir::ClockId> watched;         ///< the clock MachineContext::watched
    std::vector<std::string> announced;         ///< by ClockId: CLID_C if a reset is an event; otherwise empty
    std::vector<cspm::ExprPtr> constants;       ///< by ConstantId: the value
    std::vector<std::string> events;            ///< by EventId: the channel of the event
    std::vector<CellId> own;                    ///< cells whose lifetime is that of the frame
    std::map<std::uint32_t, CellId> monitors;   ///< by TransitionId: the counter of the deadline
};

/// Owns the frames: number 0 is the machine, the others are called operations.
class ActivationRecords {
public:
    /// Opens the frame of the machine.
    ActivationRecords(const MachineContext&, const CallGraph&, ParameterTable&, ClockLimits&);

    [[nodiscard]] const Frame& operator[](std::uint32_t frame) const { return frames_[frame]; }
    [[nodiscard]] const Frame& root_frame() const { return frames_.front(); }
    /// Returns the frame of the operation that the statement of `caller` calls.
    std::uint32_t frame_of_call(std::uint32_t caller, const ir::Stmt& call, const ir::Machine& operation);
    /// Returns a frame of the operation. Callers share the frame if the operation's required variables and clocks
    /// denote the same cells for all of them.
    std::uint32_t shared_frame(std::uint32_t caller, const ir::Machine& operation);

    /// Returns the meanings of the names in expressions of a frame.
    [[nodiscard]] Scope make_scope(std::uint32_t frame, const Values&, cspm::ExprPtr trigger_value = nullptr) const;
    /// Returns the definition of the operation in the context of the frame's machine, or null if the call is an event.
    [[nodiscard]] const ir::Machine* find_definition(std::uint32_t frame, ir::OperationId) const;
    /// Returns the constructor for the clock in its event clockReset, or null if a reset is not an event.
    [[nodiscard]] const std::string* reset_constructor(std::uint32_t frame, ir::ClockId) const;
    /// Returns the full duration of a transition's deadline, identified by the cell that counts it down (semantics
    /// 3.10).
    [[nodiscard]] cspm::ExprPtr full_time(CellId monitor, const Values&) const;
    /// Returns the statement for a clock reset on a transition, if the reset is an event.
    [[nodiscard]] const ir::Stmt* reset_statement(std::uint32_t frame, ir::TransitionId, ir::ClockId);

private:
    std::uint32_t open_frame(const ir::Machine&, std::uint32_t parent, const std::string& prefix);
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
    std::map<std::string, std::uint32_t> shared_;  ///< by a key of the caller's required elements
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, ir::Stmt> reset_statements_;
};

/// True if the clock belongs to the caller of an operation that is checked on its own.
[[nodiscard]] bool is_callers(const ir::Machine&, const ir::Clock&);

}  // namespace robochart::csp_emit
