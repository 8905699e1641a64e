// The component to generate, in its context: the machine that runs, the operations it calls, and how
// its events, calls and shared variables look from outside (semantics 3.2 "visible alphabet per level", 3.7-3.9).
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cpp_emit/emit.hpp"
#include "cpp_emit/names.hpp"

namespace robochart::cpp_emit {

/// An event of the machine (and of its operations, which use the caller's events by name).
struct EventPort {
    std::string model_name;  ///< in the machine
    std::string interface;
    std::optional<std::string> outside;  ///< at the component's boundary; none: connected to nothing
    std::optional<ir::TypeId> type;
    bool received = false;
    bool sent = false;
    std::string input;   ///< member of Inputs
    std::string output;  ///< method of the platform
};

/// A variable of the machine or one that it shares (semantics 3.7: the machine keeps a copy).
struct StoredVariable {
    const ir::Variable* variable = nullptr;
    bool shared = false;    ///< of a required interface
    bool visible = false;   ///< writes are seen outside: set_x
    bool external = false;  ///< may be written from outside: set_EXT_x
    bool read = false;      ///< some expression depends on it
    ir::Value initial;
    std::string field;   ///< member of State
    std::string input;   ///< member of Inputs, if external and read
    std::string output;  ///< method of the platform, if visible

    /// A shared variable that nothing reads has no place in the state.
    [[nodiscard]] bool stored() const { return read || !shared; }
};

/// An operation that the platform implements.
struct PlatformCall {
    const ir::OperationSignature* signature = nullptr;
    std::string method;
};

/// An operation that the model defines. The platform may still do it instead.
struct ModelledCall {
    const ir::OperationSignature* signature = nullptr;
    ir::MachineId definition;
    std::string method;  ///< of the platform: true if it has done the operation itself
};

/// A machine whose code is generated: the component's own, or an operation it calls.
struct Unit {
    ir::MachineId id;
    const ir::Machine* machine = nullptr;
    bool root = false;
    std::string frame;                         ///< struct of its state: "State", "TurnFrame"
    std::string points;                        ///< enumeration of its places: "At", "TurnAt"
    std::vector<ir::MachineId> definitions;    ///< for each Machine::operations entry
    std::vector<std::string> variable_fields;  ///< operations: members of the frame for their own variables
    std::vector<ir::Value> constants;          ///< in this context
    std::vector<ir::Value> initials;           ///< of its variables; shared ones: the default of their type
    std::vector<std::string> clock_fields;     ///< members of the frame; "" for clocks of the caller
    std::vector<bool> clock_read;              ///< by this machine or by operations that share the clock
};

struct Component {
    ir::ComponentRef ref;
    std::string name;  ///< of the model's element
    std::string kind;  ///< "state machine", "controller", "module"
    std::string cpp_name;
    std::string package;
    ir::Origin origin;
    std::vector<Unit> units;        ///< callees before callers; the component's machine last
    std::vector<EventPort> events;  ///< as the machine declares them
    std::vector<StoredVariable> variables;
    std::vector<PlatformCall> calls;
    std::vector<ModelledCall> modelled;
    std::vector<ir::TypeId> enumerations;  ///< declared types used, in order of first use

    [[nodiscard]] const Unit& root() const { return units.back(); }
    [[nodiscard]] const Unit& unit(ir::MachineId) const;
    [[nodiscard]] const EventPort& event(const Unit&, ir::EventId) const;
    /// The machine's or shared variable behind a unit's variable; null: the operation's own.
    [[nodiscard]] const StoredVariable* stored(const Unit&, ir::VariableId) const;
    [[nodiscard]] const PlatformCall& call(const Unit&, ir::OperationId) const;
    [[nodiscard]] const ModelledCall& modelled_call(ir::MachineId definition) const;
    /// The unit whose state holds a clock, and its number there: operations may require the caller's.
    [[nodiscard]] std::pair<const Unit*, ir::ClockId> clock(const Unit&, ir::ClockId) const;
};

/// Follows the reference and collects the above. Reports what can't be generated; nothing on errors.
[[nodiscard]] std::optional<Component> resolve(const ir::System&, const ir::Instantiation&, const ir::ComponentRef&,
                                               diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
