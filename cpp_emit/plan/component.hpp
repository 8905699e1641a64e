// The component to generate, in its context: the machine that runs, the operations it calls, and how
// its events, calls and shared variables look from outside (semantics 3.2 "visible alphabet per level", 3.7-3.9).
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

/// An event at the component's boundary: raised by the platform or sent to it.
struct EventPort {
    std::string outside;     ///< at the boundary
    std::string model_name;  ///< in the machine; with several machines: at the boundary
    std::string interface;
    std::optional<ir::TypeId> type;
    bool received = false;
    bool sent = false;
    std::string input;   ///< member of Inputs
    std::string output;  ///< method of the platform
};

/// An asynchronous connection between controllers: one place, overwritten by the writer, emptied by the reader
/// (semantics 3.9).
struct Buffer {
    std::size_t connection = 0;  ///< of the module
    std::string name;            ///< of the writer's event
    std::optional<ir::TypeId> type;
    std::string field;  ///< member of State
};

/// The other end of a synchronous connection between machines.
struct Peer {
    std::size_t part = 0;
    std::string event;
    friend bool operator==(const Peer&, const Peer&) = default;
};

/// An event of a part's machine (and of its operations, which use the caller's events by name), and where it leads.
struct EventUse {
    std::string name;
    std::string interface;
    std::optional<ir::TypeId> type;
    bool received = false;
    bool sent = false;
    std::vector<std::size_t> ports;    ///< Component::events
    std::vector<Peer> peers;           ///< rendezvous
    std::vector<std::size_t> filled;   ///< Component::buffers that sending fills
    std::vector<std::size_t> emptied;  ///< Component::buffers that receiving empties
    std::string channel;               ///< names the functions of a rendezvous: offers_CHANNEL, accept_CHANNEL

    /// Received and connected to nothing: the semantics lets it happen on its own (semantics 3.9).
    [[nodiscard]] bool spontaneous() const { return ports.empty() && peers.empty() && emptied.empty(); }
    /// Sent to another machine, which has to take it: the sender may have to wait. The platform takes always.
    [[nodiscard]] bool waits_to_send() const { return filled.empty() && ports.empty() && !peers.empty(); }
};

inline constexpr std::size_t no_part = static_cast<std::size_t>(-1);

/// A machine that may hold up what is propagated to it: nothing is while one of its threads waits for a communication
/// with a deadline (semantics 3.7).
struct PropagationHolder {
    std::size_t part = 0;
    std::string field;  ///< member of State: how many writes wait to be propagated to it
};

/// A variable of a machine or one that machines share. The semantics gives each machine a copy and propagates writes
/// (semantics 3.7); immediate propagation keeps all copies equal, so there is one. Where the environment propagates
/// (the variable is declared outside of the component), a machine does not see the others' writes before the outside
/// tells them: then each machine has its copy, and all take what is written from outside.
struct StoredVariable {
    const ir::Variable* variable = nullptr;
    std::size_t home = no_part;   ///< the part whose frame holds it; no_part: State
    const void* level = nullptr;  ///< shared: the controller instance or module that declares it; null: outside
    bool shared = false;          ///< of a required interface
    bool visible = false;         ///< writes are seen outside: set_x
    bool external = false;        ///< may be written from outside: set_EXT_x
    bool read = false;            ///< some expression depends on it
    bool copy = false;            ///< of an entry before it, which has the names at the boundary
    ir::Value initial;
    std::string field;         ///< member of the frame that holds it
    std::string path;          ///< below State: "x", "stm0.x"
    std::string writer;        ///< method of Step, if visible
    std::string input;         ///< member of Inputs, if external and read
    std::string output;        ///< method of the platform, if visible
    std::size_t memories = 0;  ///< shared: between a write and the machines, each of which takes one write at a time
    std::vector<PropagationHolder> holders;
    std::string held_up;    ///< method of Step, if there are holders: whether the next write has to wait
    std::string propagate;  ///< method of Step, if there are holders: what follows a write

    /// A shared variable that nothing reads has no place in the state.
    [[nodiscard]] bool stored() const { return read || !shared; }
};

/// An operation that the platform implements.
struct PlatformCall {
    const ir::OperationSignature* signature = nullptr;
    std::string method;
};

/// A function of the model, specified by contract only: the platform computes it.
struct FunctionHook {
    ir::FunctionId id;
    std::string method;
    bool guarded = false;      ///< calls ask its precondition first, which may be false
    std::string precondition;  ///< method of Step that does
};

/// A type whose values the code visits: of bound variables, of functions as values, of toolkit functions.
struct CarrierUse {
    ir::TypeId type;
    std::string method;  ///< of Step: any_Nat
};

/// An operation that the model defines. The platform may still do it instead.
struct ModelledCall {
    const ir::OperationSignature* signature = nullptr;
    ir::MachineId definition;
    std::string method;  ///< of the platform: true if it has done the operation itself
};

/// Whose variable or clock a name refers to: an operation works on what its caller means by the names that it
/// requires, which may be the caller's caller's (semantics 3.8).
struct Owner {
    std::size_t unit = 0;     ///< Unit::number
    std::uint32_t place = 0;  ///< among the variables or clocks of its machine
    friend bool operator==(const Owner&, const Owner&) = default;
};

/// A machine whose code is generated: the component's own, or an operation it calls. An operation whose callers mean
/// different things by the names that it requires is a unit for each meaning.
struct Unit {
    ir::MachineId id;
    std::size_t number = 0;  ///< in the order in which calls are followed; Component::unit
    std::size_t part = 0;
    const ir::Machine* machine = nullptr;
    bool root = false;
    std::size_t first_transition = 0;          ///< number of its first transition (transition_numbers.hpp)
    std::string frame;                         ///< struct of its state: "State", "TurnFrame"
    std::string points;                        ///< enumeration of its places: "At", "TurnAt"
    std::string prefix;                        ///< of its other enumerations: "", "Turn"
    std::vector<ir::MachineId> definitions;    ///< for each Machine::operations entry
    std::vector<std::size_t> callees;          ///< for each Machine::operations entry that is defined: its unit
    std::vector<Owner> variable_owners;        ///< for each variable
    std::vector<Owner> clock_owners;           ///< for each clock
    std::vector<std::size_t> lenders;          ///< the other operations among the owners, ascending
    std::vector<std::string> variable_fields;  ///< operations: members of the frame for their own variables
    std::vector<ir::Value> constants;          ///< in this context
    std::vector<ir::Value> initials;           ///< of its variables; shared ones: the default of their type
    std::vector<std::string> clock_fields;     ///< members of the frame; "" for clocks of others
    std::vector<bool> clock_read;              ///< by this machine or by operations that share the clock
};

/// A machine in the place where it runs, with the operations it calls.
struct Part {
    std::string name;            ///< "stm0", in a module "ctrl0::stm0"; "" for a machine alone
    std::size_t controller = 0;  ///< ir::Module::controllers
    std::size_t machine = 0;     ///< ir::Controller::machines
    std::size_t root = 0;        ///< Component::units
    std::string tag;             ///< identifier in names of members and functions; "" if there is one part
    std::vector<EventUse> events;
    std::map<std::string, std::size_t> variables;  ///< by name in the machine -> Component::variables

    /// How the code refers to the frame of its machine: "state_", "state_.stm0".
    [[nodiscard]] std::string place() const { return tag.empty() ? "state_" : "state_." + tag; }
};

struct Component {
    ir::ComponentRef ref;
    std::string name;  ///< of the model's element
    std::string kind;  ///< "state machine", "controller", "module"
    std::string cpp_name;
    std::string package;
    ir::Origin origin;
    std::vector<Part> parts;               ///< the machines, in textual order
    std::vector<Unit> units;               ///< part by part; callees before callers; each part's machine last
    std::vector<std::size_t> unit_places;  ///< by Unit::number -> units
    std::vector<EventPort> events;         ///< at the boundary
    std::vector<Buffer> buffers;
    std::vector<StoredVariable> variables;
    std::vector<PlatformCall> calls;
    std::vector<ModelledCall> modelled;
    std::vector<FunctionHook> functions;
    std::vector<CarrierUse> carriers;
    std::vector<ir::TypeId> enumerations;  ///< declared types used, parts before the whole
    bool probabilistic = false;            ///< there are probabilistic junctions
    bool matrices = false;                 ///< vectors or matrices are used: robochart/matrix.hpp
    bool toolkit = false;  ///< functions or relations, conversions, sets of values with parts: robochart/toolkit.hpp
    bool strings = false;  ///< robochart/text.hpp
    bool ordered = false;  ///< values with parts are members of sets

    /// Several machines side by side.
    [[nodiscard]] bool composed() const { return parts.size() > 1; }
    /// The machine of a component that has one.
    [[nodiscard]] const Unit& root() const { return units.back(); }
    [[nodiscard]] const Part& part(const Unit& unit) const { return parts[unit.part]; }
    [[nodiscard]] const Unit& root(std::size_t part) const { return units[parts[part].root]; }
    [[nodiscard]] const Unit& unit(std::size_t number) const { return units[unit_places[number]]; }
    /// The unit that a call of a defined operation runs.
    [[nodiscard]] const Unit& callee(const Unit& of, ir::OperationId id) const { return unit(of.callees[id.index]); }
    [[nodiscard]] const EventUse& event(const Unit&, ir::EventId) const;
    /// An event of a part; null if its machine does not use it.
    [[nodiscard]] const EventUse* event(const Peer&) const;
    /// The machine's or shared variable behind a unit's variable; null: an operation's, Unit::variable_owners has
    /// whose.
    [[nodiscard]] const StoredVariable* stored(const Unit&, ir::VariableId) const;
    [[nodiscard]] const PlatformCall& call(const Unit&, ir::OperationId) const;
    [[nodiscard]] const ModelledCall& modelled_call(ir::MachineId definition) const;
    [[nodiscard]] const CarrierUse& carrier(ir::TypeId) const;
    /// The unit whose state holds a clock, and its number there.
    [[nodiscard]] std::pair<const Unit*, ir::ClockId> clock(const Unit&, ir::ClockId) const;
};

/// Names that no member of a state may have: those of other members and of types, the units' as far as they have them.
[[nodiscard]] std::set<std::string> never_members(const ir::System&, const Component&);
/// Names for what a core declares for its machines: none of its own things, nor of what is a member somewhere.
[[nodiscard]] NameScope core_type_scope(const Component&);

}  // namespace robochart::cpp_emit
