// The controller for whoever runs many of them at once (simulators): the same core over the types it ships with, behind
// the plain C interface of runtime/drive_abi.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cpp_emit/emit.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// How a value crosses the interface: member `real` or `whole` of rc_value.
enum class Carried { boolean, whole, real, enumeration };

/// An input or output of the controller, as in the tables of the interface.
struct Port {
    enum class Kind { event, call, variable };
    Kind kind = Kind::event;
    std::string name;                ///< in the model: "seeRobot", "MoveForward", "reached"
    std::vector<Carried> arguments;  ///< at most one for inputs
    double initial = 0;              ///< variables: the value before the first write (truth values, literals: 0)
    std::string exported = {};       ///< in the interface: "seeRobot.in", "MoveForwardCall", "set_EXT_reached"
    std::vector<std::vector<std::string>> literals = {};  ///< of each argument: names of its enumeration's values
    std::vector<std::string> types = {};                  ///< of each argument: "nat", "Zone", "pack::Zone"
};

/// A constant of the model with its value in a machine of the controller.
struct DriveConstant {
    std::string name;   ///< "limit"
    std::string owner;  ///< the machine, "pack::Keep"
    std::string type;   ///< as Port::types
    Carried carried = Carried::whole;
    double value = 0;  ///< truth values: 0, 1; literals: the place in their enumeration
};

/// A state machine of the controller, as in the table of the interface.
struct DriveMachine {
    std::string name;  ///< where it is in the component: "ctrl0::stm0"; "" if it is the only one
    ir::MachineId machine;
    std::vector<ir::NodeId> states;  ///< final ones too
};

struct DriveEmission {
    std::vector<OutputFile> files;
    std::vector<std::string> sources;  ///< paths of the sources to compile; empty where nothing could be emitted
    std::vector<Port> inputs;          ///< events received, shared variables written from outside
    std::vector<Port> outputs;         ///< operations of the platform, events sent, shared variables written
    std::vector<DriveMachine> machines;
    std::vector<DriveConstant> constants;  ///< those whose values a port can carry, machine by machine
    std::uint32_t fault_sites = 0;         ///< how many places the requested fault applies to
};

/// Emits the controller of one component. What cannot be generated is refused by name, as by emit().
[[nodiscard]] DriveEmission emit_drive(const ir::System&, const ir::Instantiation&, const ir::ComponentRef& component,
                                       const Options&, diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
