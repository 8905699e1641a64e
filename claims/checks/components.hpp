// SPDX-License-Identifier: Apache-2.0
// Lists the components of a model, with the events and calls that are visible from outside.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::claims {

enum class ChannelKind : std::uint8_t { input, output, call };

/// An event in one direction, or the calls of an operation.
struct Channel {
    std::string name;
    ChannelKind kind = ChannelKind::input;
    std::vector<ir::TypeId> types;  ///< types of the values that it carries

    friend bool operator==(const Channel&, const Channel&) = default;
};

/// A machine in a component, or the component itself.
struct MachinePart {
    std::string path;  ///< path as in the script
    ir::MachineId machine;
};

/// A constant of a component that a claim can set.
struct ComponentConstant {
    std::string name;
    std::string source;  ///< the constant that determines its value, as in ir::Property::constants
    ir::TypeId type;
};

/// An event that triggers transitions of a machine although no other element raises it. These transitions fire
/// spontaneously.
struct Spontaneous {
    std::string event, machine;
    diagnostics::Span span;  ///< place of the event
};

/// A module, a controller or a machine, alone or as a part of another component.
struct Component {
    ir::ComponentKind kind = ir::ComponentKind::module;
    std::string path;      ///< path as in the script: "warehouse::Warehouse::brain::patrol"
    std::string package;   ///< "" if unnamed
    bool part = false;     ///< true for a part of another component
    bool robosim = false;  ///< true if it is written in RoboSim
    std::vector<Channel> channels;
    std::vector<std::string> defined = {};  ///< operations that the model defines for this component
    std::vector<MachinePart> machines = {};
    std::vector<Spontaneous> spontaneous = {};
    std::vector<ComponentConstant> constants = {};  ///< of the component itself, without those of its parts
    std::set<std::string> sources = {};             ///< the constants that determine its behaviour; with those of parts
};

/// Returns the components of a system, each before its parts.
[[nodiscard]] std::vector<Component> components_of(const ir::System& system);

}  // namespace robochart::claims
