// SPDX-License-Identifier: Apache-2.0
// Answers questions about a System for which several users of the IR need answers. Examples are the definition of an
// operation in a context, and the name of a constant.
#pragma once

#include <string>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Returns `package::path`, or only the path if the package has no name.
[[nodiscard]] std::string qualified_name(const ComponentRef&);

/// Returns the definition that a call of this operation runs inside a controller. The definition has the same name and
/// the same parameter types (semantics 3.8). The id is invalid if the call leaves the controller.
[[nodiscard]] MachineId definition_in(const System&, const Controller&, const OperationSignature&);

/// Returns the operations that a machine's own statements call, ascending, without duplicates.
[[nodiscard]] std::vector<OperationId> called_operations(const Machine&);

/// Returns the text of a transition for messages: "t1: S1 -> S2".
[[nodiscard]] std::string text_of(const Machine&, const Transition&);

/// Returns RoboTool's name of a constant that a process takes as a parameter: `const_<package>_<path>_<constant>`. The
/// path is the path of the defining component (`S`, `C`). If the component is a machine inside a controller, the path
/// consists of the path of the controller and the name of the reference (`C::stm_ref`, `C::op_ref`). The name for the
/// length of the cycles of a RoboSim component is `cycle_<package>_<path>_<component>`.
[[nodiscard]] std::string constant_name(const std::string& package, const std::string& path,
                                        const std::string& constant);
/// Returns true if a name made by constant_name denotes the length of a cycle.
[[nodiscard]] bool is_cycle_name(const std::string&);

/// The source of the value of a machine's constant when the machine runs as `part` of a controller. `part` is the name
/// of its MachineInstance, or of its entry in Controller::definition_names.
/// * If an operation requires the constant (semantics 3.7: process parameters, not memory), the source is the constant
///   with the same name of the machine or operation that calls the operation.
/// * If another machine requires the constant, the source is the controller's constant with the same name. If the
///   controller also requires this constant and runs in a module, the source is the platform's constant.
/// * In all other cases, and if nothing provides the constant, the source is the constant of the component itself:
///   `const_P_C_part_c`.
/// If `controller` is null, the machine is not in a controller, and the name of its constant is `const_P_S_c`. If
/// `module` is null, the controller is not in a module.
struct ConstantSource {
    std::string name;                    ///< as in Instantiation::constants
    const Constant* constant = nullptr;  ///< the declaration whose `value` is used if the instantiation has none
};
[[nodiscard]] ConstantSource constant_source(const System&, const Module* module, const Controller* controller,
                                             const std::string& part, const Machine&, ConstantId);

/// Returns all sources. There are several sources if callers of an operation provide different constants (RC-S19).
[[nodiscard]] std::vector<ConstantSource> constant_sources(const System&, const Module* module, const Controller&,
                                                           const std::string& part, const Machine&, ConstantId);
/// A constant that an operation of a controller requires from several callers.
struct SharedConstant {
    const Controller* controller = nullptr;
    const Machine* operation = nullptr;
    std::string constant;
    std::vector<ConstantSource> sources;  ///< at least two sources
    /// Returns true if all sources are the same constant of one machine that runs several times. Such sources have the
    /// same value unless an option or an assertion sets one of them. If the result is false, lowering rejects the
    /// model.
    [[nodiscard]] bool is_one_constant() const;
    [[nodiscard]] std::string source_names() const;
};
[[nodiscard]] std::vector<SharedConstant> shared_constants(const System&);

/// Returns the source of the value of a controller's constant. If the controller requires the constant and runs in a
/// module, the source is the platform's constant. Otherwise the source is the controller's constant.
[[nodiscard]] ConstantSource constant_source(const Module* module, const Controller&, ConstantId);

/// A constant that a user or an assertion may set. `named_constants` returns one such constant for every distinct name,
/// in order of declaration.
struct NamedConstant {
    std::string name;  ///< `const_P_C_ref_c`
    std::string path;  ///< "P::C::ref::c", for messages and options
    TypeId type;
    bool has_value = false;  ///< the model gives a value
};
[[nodiscard]] std::vector<NamedConstant> named_constants(const System&);
/// Returns true if a user may write `name` for the element with this path. `name` must be the path or the end of the
/// path after a `::`.
[[nodiscard]] bool is_named_by(const std::string& path, const std::string& name);

/// Returns the components of RoboSim, including inner ones: first machines, then controllers, then modules.
[[nodiscard]] std::vector<ComponentRef> robosim_components(const System&);
/// Returns true if the component is written in RoboSim.
[[nodiscard]] bool is_robosim(const System&, const ComponentRef&);
/// Returns the input event of RoboSim whose register the machine's variable represents. Returns null for other
/// variables.
[[nodiscard]] const Input* event_register(const Machine&, VariableId);
/// Returns true if the statement itself, without the statements inside it, reads or writes a register or ends the
/// cycle.
[[nodiscard]] bool touches_registers(const Machine&, const Stmt&);
/// Removes the components and simulations of RoboSim, and the claims about these. The indices of RoboChart's components
/// do not change.
void remove_robosim(System&);

/// Returns true if the block replaces carriers, constants and functions of the scripts: `csp Instantiations`.
[[nodiscard]] bool is_instantiations(const CspBlock&);

}  // namespace robochart::ir
