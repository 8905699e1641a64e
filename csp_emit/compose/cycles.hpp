// SPDX-License-Identifier: Apache-2.0
// Emits RoboSim's controllers and modules in cycles (docs/robosim.md). Their cycle has the same phases as that of a
// machine. First the composition reads its inputs and passes them to the parts. Then it passes on the writes of the
// parts, one by one. Its execution ends when the executions of all parts have ended. A part sees an event of another
// part only in the next cycle.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "csp_emit/base/registers.hpp"
#include "csp_emit/compose/composition.hpp"

namespace robochart::csp_emit {

/// A register of a part.
struct RegisterOfPart {
    std::size_t part = 0;
    std::string name;
};

/// A register inside the composition: an event between parts, or a variable that the composition declares.
struct InnerRegister {
    std::string name;
    bool event = false;
    ir::TypeId type;        ///< invalid for an event without a type
    cspm::ExprPtr initial;  ///< the initial value of a variable
    std::vector<RegisterOfPart> writers, readers;
};

/// The registers of a composition, and their connections to registers of its parts. If no member contains a register
/// of a part, it is not connected: as an input it has an arbitrary value in each cycle, and as an output it is
/// discarded.
struct CycleLinks {
    std::vector<Registers> parts;
    Registers registers;
    std::vector<Register> also_named;                            ///< outputs that occur only in the type of outputs
    std::map<std::string, std::vector<RegisterOfPart>> inputs;   ///< by the composition's input
    std::map<std::string, std::vector<RegisterOfPart>> outputs;  ///< by the composition's output
    std::vector<InnerRegister> inner;
};

[[nodiscard]] CycleLinks cycle_links(const Project&, const ir::Controller&);
[[nodiscard]] CycleLinks cycle_links(const Project&, const ir::Module&);

/// Declares the channels and sets of the composition. Returns its visible channels.
[[nodiscard]] std::vector<std::string> declare_cycle_channels(const Project&, const std::string& path,
                                                              const CycleLinks&, const ir::Origin&, bool module,
                                                              Provenance&, std::vector<cspm::DeclPtr>&);
/// Defines the processes. The first constant of the composition is the length of its cycles.
void define_cycles(const Composition&, const CycleLinks&, std::vector<cspm::DeclPtr>&);

}  // namespace robochart::csp_emit
