// SPDX-License-Identifier: Apache-2.0
// Defines the common parts of emitted machines, controllers and modules: a CSPM module and the parameters of its
// process variants (semantics 3.12).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "csp_emit/base/project.hpp"
#include "csp_emit/base/shown.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// A constant that a component takes as a parameter (semantics 3.12).
struct ConstantParameter {
    std::string parameter;  ///< const_P_C_part_c
    std::string constant;   ///< name in the model
    std::string value;  ///< the global definition that is passed as the argument unless an assertion sets another value
    const ir::Machine* owner = nullptr;  ///< the machine that declares it; null if the component itself declares it
    ir::ConstantId id;                   ///< index in `owner`
    ir::TypeId type;
    std::string inside = {};  ///< for machines: the short name of the constant in the processes of the machine
    std::string source = {};  ///< the element that determines the value in this context (ir::constant_source);
                              ///< assertions set the value there
};

/// A parameter of a standalone operation.
struct ArgumentParameter {
    std::string name;
    ir::TypeId type;
};

struct ComponentEmission {
    cspm::DeclPtr module;
    std::vector<ArgumentParameter> arguments;  ///< operations: the parameters between id__ and the constants
    std::vector<ConstantParameter> constants;
    std::vector<std::string> visible;                  ///< channels of sem__events, relative to the component
    std::size_t reads_of_watched = 0;                  ///< number of guards that read MachineContext::watched
    const ir::Machine* machine = nullptr;              ///< machines and operations
    std::map<std::string, ir::MachineId> definitions;  ///< machines: the definitions of the operations that they call
    bool large = false;  ///< the component may have too many states to be compressed separately
};

/// Records the meaning of an event of a component. `event` is the qualified CSPM name of the event.
void mean(Provenance&, const std::string& component, const std::string& event, EventMeaning);
/// Returns the call of a function whose arguments are variables named like its parameters.
[[nodiscard]] cspm::ExprPtr call_of(const std::string& function, const std::vector<std::string>& parameters);

/// Declares the channels of a component, one by one (semantics 3.2). Records the meaning of each event in the
/// provenance.
class ChannelDeclarations {
public:
    /// `owner` is the qualified CSPM name of the component.
    ChannelDeclarations(const Project& project, std::string owner, Provenance& provenance,
                        std::vector<cspm::DeclPtr>& decls)
        : project_(project), owner_(std::move(owner)), provenance_(provenance), decls_(decls) {}

    /// Declares `e : InOut` or `e : InOut.T`. `in` receives and `out` sends.
    void declare_event(const ir::Event&);
    /// Declares `opCall.args`, a call of an operation that has no definition in the context.
    void declare_call(const ir::OperationSignature&);
    /// Declares `set_x`, and also `set_EXT_x` if other components may write the variable.
    void declare_variable(const std::string& name, ir::TypeId, bool written_by_others, const ir::Origin&);

private:
    void mean(const std::string& event, EventMeaning meaning);

    const Project& project_;
    std::string owner_;
    Provenance& provenance_;
    std::vector<cspm::DeclPtr>& decls_;
};

/// A machine that was emitted in one place, and the meaning of its names in this place.
struct EmittedMachine {
    std::string path;  ///< the qualified CSPM name of the place
    ComponentEmission emission;
    Provenance provenance;
};

/// All data emitted so far. The components, including nested ones, are keyed by their qualified CSPM names.
struct Emitted {
    Shown shown = {};  ///< the facts that machines show; empty unless there are claims about states and variables
    Provenance provenance;
    std::map<std::string, ComponentEmission> components;
    /// Machines by their key: the path in the model, and the definitions of the operations that they call. Equal keys
    /// have equal emitted machines everywhere.
    std::map<std::string, EmittedMachine> machines = {};
    /// For each file: the new names of declarations in its CSP blocks that had to be renamed (name_clashes.hpp).
    std::map<std::string, std::map<std::string, std::string>> names_of_blocks = {};
};

}  // namespace robochart::csp_emit
