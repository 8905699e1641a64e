// SPDX-License-Identifier: Apache-2.0
// Declares the component to generate, in its context: the machine that runs, the operations that it calls, and its
// events, calls and shared variables as they appear at its boundary (semantics 3.2 "visible alphabet per level",
// 3.7-3.9).
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cpp_emit/plan/names.hpp"
#include "cpp_emit/plan/options.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// An event at the component's boundary, which the platform raises or receives.
struct EventPort {
    std::string outside;     ///< name at the boundary
    std::string model_name;  ///< name in the machine; if there are several machines, at the boundary
    std::string interface;
    std::optional<ir::TypeId> type;
    bool received = false;
    bool sent = false;
    std::string input;   ///< member of Inputs
    std::string output;  ///< method of the platform
    std::string raised;  ///< member of State, if a declared order lets the event drop others
};

/// A buffer with one place for an asynchronous connection between controllers. The writer overwrites it, and the reader
/// empties it (semantics 3.9).
struct Buffer {
    std::size_t connection = 0;  ///< index in the module
    std::string name;            ///< name of the writer's event
    std::optional<ir::TypeId> type;
    std::string field;  ///< member of State
};

/// The other end of a synchronous connection between machines.
struct Peer {
    std::size_t part = 0;
    std::string event;
    friend bool operator==(const Peer&, const Peer&) = default;
};

/// An event of a part's machine, and its connections. Operations of the machine use its events by name.
struct EventUse {
    std::string name;
    std::string interface;
    std::optional<ir::TypeId> type;
    bool received = false;
    bool sent = false;
    std::vector<std::size_t> ports;    ///< indices into Component::events
    std::vector<Peer> peers;           ///< machines at the other ends of synchronous connections
    std::vector<std::size_t> filled;   ///< indices into Component::buffers: buffers that sending fills
    std::vector<std::size_t> emptied;  ///< indices into Component::buffers: buffers that receiving empties
    std::vector<std::size_t>
        outlets;          ///< RoboSim: indices into Component::events that sending writes; `ports` are read
    std::string once;     ///< RoboSim: the output that a cycle writes at most once, if it has no outlet
    std::string channel;  ///< suffix of the functions of a rendezvous: offers_CHANNEL, accept_CHANNEL

    /// Returns whether the event is an input that is not connected. In the semantics, such an event can happen
    /// spontaneously (semantics 3.9).
    [[nodiscard]] bool is_spontaneous() const { return ports.empty() && peers.empty() && emptied.empty(); }
    /// Returns whether the event is sent to another machine, so that the sender may have to wait. The platform always
    /// accepts.
    [[nodiscard]] bool waits_to_send() const { return filled.empty() && ports.empty() && !peers.empty(); }
};

inline constexpr std::size_t no_part = static_cast<std::size_t>(-1);
inline constexpr std::size_t no_memory = static_cast<std::size_t>(-1);

/// A machine that may hold up writes: no write is propagated to the machine while one of its threads waits for a
/// communication with a deadline (semantics 3.7).
struct PropagationHolder {
    std::size_t part = 0;
    std::string field;  ///< member of State: the number of writes that wait to be propagated to it
};

/// A variable of a machine, or a variable that machines share. The semantics gives each machine a copy and propagates
/// writes (semantics 3.7). Immediate propagation keeps all copies equal, so the code usually has a single copy. If the
/// variable is declared outside the component, the environment propagates its writes, and a machine does not see writes
/// of other machines before the environment passes them on. Then each machine has its own copy, and all copies receive
/// external writes.
///
/// In RoboSim, a variable of a controller or platform is a register of the composition. Each machine that has the
/// variable in its contexts has a copy. The beginning of a cycle copies the register, and a write changes both.
struct StoredVariable {
    const ir::Variable* variable = nullptr;
    std::size_t home = no_part;   ///< the part whose frame contains it; no_part: it is a member of State
    const void* level = nullptr;  ///< shared: the controller instance or module that declares it; null: declared
                                  ///< outside
    bool shared = false;          ///< belongs to a required interface
    bool visible = false;         ///< whether writes are visible outside: set_x
    bool external = false;        ///< whether it may be written from outside: set_EXT_x
    bool read = false;            ///< whether some expression depends on it
    bool local = false;           ///< whether no later cycle reads it: a member of Step instead of State
    bool copy = false;            ///< whether this is a copy of another entry; that entry has the names at the boundary
    ir::Value initial;
    std::string field;               ///< name of the member of the frame
    std::string path;                ///< path in State: "x", "stm0.x"
    std::string writer;              ///< method of Step, if visible
    std::string input;               ///< member of Inputs, if external and read
    std::string output;              ///< method of the platform, if visible
    std::size_t memory = no_memory;  ///< RoboSim: index of the register of the composition that this is a copy of
    std::string once;                ///< RoboSim: the output that a cycle writes at most once, if it is not `output`
    std::size_t memories = 0;  ///< shared: number of memories between a write and the machines; each accepts one write
                               ///< at a time
    std::vector<PropagationHolder> holders;
    std::string held_up;    ///< method of Step, if there are holders: whether the next write has to wait
    std::string propagate;  ///< method of Step, if there are holders: the steps after a write

    /// Returns the name in the model; for registers of RoboSim, without `$`.
    [[nodiscard]] std::string name() const {
        return variable->scope == ir::VariableScope::reg ? variable->name.substr(1) : variable->name;
    }
    /// Returns whether the variable is a member of the state or of Step. A shared variable that is never read is not a
    /// member.
    [[nodiscard]] bool has_member() const { return read || !(shared || copy); }
    /// Returns whether the variable is a member of the state.
    [[nodiscard]] bool in_state() const { return has_member() && !local; }
};

/// An operation that the platform implements.
struct PlatformCall {
    const ir::OperationSignature* signature = nullptr;
    std::string method;
};

/// A function that the model specifies only by a contract: the platform computes it.
struct FunctionHook {
    ir::FunctionId id;
    std::string method;
    bool guarded = false;      ///< calls first test its precondition, which may be false
    std::string precondition;  ///< method of Step that tests the precondition
};

/// A type whose values the code enumerates, for bound variables, functions as values, or toolkit functions.
struct CarrierUse {
    ir::TypeId type;
    std::string method;  ///< method of Step: any_Nat
};

/// An operation that the model defines. The platform may perform it instead of the model's definition.
struct ModelledCall {
    const ir::OperationSignature* signature = nullptr;
    ir::MachineId definition;
    std::string method;  ///< method of the platform: returns true if it has performed the operation
};

/// The owner of the variable or clock that a name denotes. A required name in an operation denotes the caller's element
/// with this name. That element may in turn belong to the caller's caller (semantics 3.8).
struct Owner {
    std::size_t unit = 0;     ///< Unit::number
    std::uint32_t place = 0;  ///< index among the variables or clocks of its machine
    friend bool operator==(const Owner&, const Owner&) = default;
};

/// A machine whose code is generated: the component's machine, or an operation that it calls. If required names of an
/// operation denote different elements for different callers, there is a unit for each case.
struct Unit {
    ir::MachineId id;
    std::size_t number = 0;  ///< number in the order in which calls are visited; index into Component::unit_places
    std::size_t part = 0;
    const ir::Machine* machine = nullptr;
    bool root = false;
    std::size_t first_transition = 0;          ///< number of its first transition (transition_numbers.hpp)
    std::string frame;                         ///< struct of its state: "State", "TurnFrame"
    std::string points;                        ///< enumeration of its places: "At", "TurnAt"
    std::string prefix;                        ///< prefix of its other enumerations: "", "Turn"
    std::vector<ir::MachineId> definitions;    ///< by index into Machine::operations
    std::vector<std::size_t> callees;          ///< by index into Machine::operations: the unit of a defined operation
    std::vector<Owner> variable_owners;        ///< by variable
    std::vector<Owner> clock_owners;           ///< by clock
    std::vector<std::size_t> lenders;          ///< the units among the owners, except this one, ascending
    std::vector<std::string> variable_fields;  ///< for operations: members of the frame for their own variables
    std::vector<ir::Value> constants;          ///< values of the constants in this context
    std::vector<ir::Value> initials;           ///< initial values of its variables; for shared ones the default of
                                               ///< their type
    std::vector<std::string> clock_fields;     ///< members of the frame; "" for clocks of other units
    /// By node: the local variables (StoredVariable::local) that control needs to leave the node. Control stays in the
    /// node unless the cycle has written them.
    std::vector<std::vector<ir::VariableId>> awaited_locals;
    std::vector<bool> clock_read;  ///< whether this machine, or an operation that shares the clock, reads
                                   ///< it
};

/// A machine in its context, with the operations that it calls.
struct Part {
    std::string name;            ///< "stm0", in a module "ctrl0::stm0"; "" for a single machine
    std::size_t controller = 0;  ///< index into ir::Module::controllers
    std::size_t machine = 0;     ///< index into ir::Controller::machines
    std::size_t root = 0;        ///< index into Component::units
    std::string tag;             ///< identifier in names of members and functions; "" if there is only one part
    std::vector<EventUse> events;
    std::map<std::string, std::size_t> variables;  ///< by name in the machine: index into Component::variables

    /// Returns the expression for the frame of its machine: "state_", "state_.stm0".
    [[nodiscard]] std::string frame_expression() const { return tag.empty() ? "state_" : "state_." + tag; }
};

struct Component {
    ir::ComponentRef ref;
    std::string name;  ///< name of the model's element
    std::string kind;  ///< "state machine", "controller", "module"
    std::string cpp_name;
    std::string package;
    ir::Origin origin;
    std::vector<Part> parts;               ///< the machines, in textual order
    std::vector<Unit> units;               ///< by part; callees come before callers, and each part's machine is last
    std::vector<std::size_t> unit_places;  ///< index into `units` by Unit::number
    std::vector<EventPort> events;         ///< events at the boundary
    std::vector<Buffer> buffers;
    std::vector<StoredVariable> variables;
    std::vector<PlatformCall> calls;
    std::vector<ModelledCall> modelled;
    std::vector<FunctionHook> functions;
    std::vector<CarrierUse> carriers;
    std::vector<ir::TypeId> enumerations;  ///< declared types that are used; types of parts before the types that
                                           ///< contain them
    bool probabilistic = false;            ///< whether there are probabilistic junctions
    bool matrices = false;                 ///< whether vectors or matrices are used: robochart/matrix.hpp
    bool toolkit = false;    ///< whether functions or relations, conversions, or sets of composed values are used:
                             ///< robochart/toolkit.hpp
    bool views = false;      ///< whether collections may be visited in place: robochart/views.hpp
    bool lists = false;      ///< whether values contain lists that may be longer than their capacity (has_lists)
    bool sequences = false;  ///< whether sequences are used
    bool strings = false;    ///< whether strings are used: robochart/text.hpp
    bool ordered = false;    ///< whether composed values are elements of sets
    bool robosim = false;    ///< whether the component is written in RoboSim: it ends its cycles itself

    /// Returns whether several machines run in parallel.
    [[nodiscard]] bool is_composed() const { return parts.size() > 1; }
    /// Returns the machine of a component with only one machine.
    [[nodiscard]] const Unit& root_unit() const { return units.back(); }
    [[nodiscard]] const Part& part_of(const Unit& unit) const { return parts[unit.part]; }
    [[nodiscard]] const Unit& root_unit(std::size_t part) const { return units[parts[part].root]; }
    [[nodiscard]] const Unit& unit_at(std::size_t number) const { return units[unit_places[number]]; }
    /// Returns the unit that a call of a defined operation runs.
    [[nodiscard]] const Unit& called_unit(const Unit& of, ir::OperationId id) const {
        return unit_at(of.callees[id.index]);
    }
    [[nodiscard]] const EventUse& find_event(const Unit&, ir::EventId) const;
    /// Returns the part's event at one end of a connection, or null if its machine does not use the event.
    [[nodiscard]] const EventUse* find_event(const Peer&) const;
    /// Returns the variable of the machine, or the shared variable, that a unit's variable denotes. Returns null for
    /// variables of operations, whose owner is in Unit::variable_owners.
    [[nodiscard]] const StoredVariable* stored_variable(const Unit&, ir::VariableId) const;
    /// For RoboSim: returns the register of the composition that the variable of a machine is a copy of, or null.
    [[nodiscard]] const StoredVariable* memory_of(const StoredVariable&) const;
    /// For RoboSim: returns the input event whose register a unit's variable is, or null for other variables.
    [[nodiscard]] const EventUse* find_register(const Unit&, ir::VariableId) const;
    [[nodiscard]] const PlatformCall& find_platform_call(const Unit&, ir::OperationId) const;
    [[nodiscard]] const ModelledCall& modelled_call(ir::MachineId definition) const;
    [[nodiscard]] const CarrierUse& find_carrier(ir::TypeId) const;
    /// Returns the unit whose frame contains a clock, and the clock's number in that unit.
    [[nodiscard]] std::pair<const Unit*, ir::ClockId> clock_owner(const Unit&, ir::ClockId) const;
};

/// Returns names that members of a state must not have: names of other members, of types and of units.
[[nodiscard]] std::set<std::string> never_members(const ir::System&, const Component&);
/// Returns a scope for the names of declarations that a core makes for its machines. The names differ from the core's
/// own names and from all members.
[[nodiscard]] NameScope core_type_scope(const Component&);

}  // namespace robochart::cpp_emit
