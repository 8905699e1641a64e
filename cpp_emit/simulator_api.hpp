// SPDX-License-Identifier: Apache-2.0
// Emits the controller for programs that run many instances at once (simulators): the same core with its deployed
// types, called through the C interface of runtime/drive_abi.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cpp_emit/emit.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// The kind of a value in the interface. It decides which member of rc_value is used: `real` or `whole`.
enum class Carried { boolean, whole, real, enumeration };

/// An input or output of the controller, as in the tables of the interface.
struct Port {
    enum class Kind { event, call, variable };
    Kind kind = Kind::event;
    std::string name;                ///< name in the model: "seeRobot", "MoveForward", "reached"
    std::vector<Carried> arguments;  ///< at most one for inputs
    double initial = 0;              ///< variables: the value before the first write (booleans and literals: 0)
    std::string exported = {};       ///< name in the interface: "seeRobot.in", "MoveForwardCall", "set_EXT_reached"
    std::vector<std::vector<std::string>> literals = {};  ///< for each argument: names of its enumeration's values
    std::vector<std::string> types = {};                  ///< for each argument: "nat", "Zone", "pack::Zone"
};

/// A constant of the model with its value in a machine of the controller.
struct DriveConstant {
    std::string name;   ///< "limit"
    std::string owner;  ///< the machine, "pack::Keep"
    std::string type;   ///< as in Port::types
    Carried carried = Carried::whole;
    double value = 0;  ///< booleans: 0, 1; literals: the index in their enumeration
};

/// A state machine of the controller, as in the table of the interface.
struct DriveMachine {
    std::string name;  ///< its path in the component: "ctrl0::stm0"; "" if it is the only one
    ir::MachineId machine;
    std::vector<ir::NodeId> states;  ///< including final ones
};

struct DriveEmission {
    std::vector<OutputFile> files;
    std::vector<std::string> sources;  ///< paths of the sources to compile; empty if nothing could be emitted
    std::vector<Port> inputs;          ///< received events, externally written shared variables
    std::vector<Port> outputs;         ///< operations of the platform, sent events, written shared variables
    std::vector<DriveMachine> machines;
    std::vector<DriveConstant> constants;  ///< constants whose values a port can carry, machine by machine
    std::uint32_t fault_sites = 0;         ///< number of places to which the requested fault applies
};

/// Emits the controller of one component. Like emit(), rejects constructs that have no translation to C++ by name.
[[nodiscard]] DriveEmission emit_drive(const ir::System&, const ir::Instantiation&, const ir::ComponentRef& component,
                                       const Options&, diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
