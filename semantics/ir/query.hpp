// Questions about a System that several readers of the IR ask: who defines an operation here, what is a constant
// called.
#pragma once

#include <string>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// `package::path`, or the path alone where the package has no name.
[[nodiscard]] std::string qualified(const ComponentRef&);

/// The definition that a call of this operation runs inside a controller: same name, same parameter types
/// (semantics 3.8); invalid: the call leaves the controller.
[[nodiscard]] MachineId definition_in(const System&, const Controller&, const OperationSignature&);

/// The operations a machine's own statements call, ascending, each once.
[[nodiscard]] std::vector<OperationId> called_operations(const Machine&);

/// For people: "t1: S1 -> S2".
[[nodiscard]] std::string text_of(const Machine&, const Transition&);

/// RoboTool's name of a constant that a process takes as a parameter: `const_<package>_<path>_<constant>`, the path
/// being the defining component's (`S`, `C`), then the reference's inside a controller (`C::stm_ref`, `C::op_ref`).
[[nodiscard]] std::string constant_name(const std::string& package, const std::string& path,
                                        const std::string& constant);

/// Where the value of a machine's constant comes from when the machine runs as `part` of a controller (the name of its
/// MachineInstance, or of its entry in Controller::definition_names):
/// * a required constant (semantics 3.7: process parameters, not memory) of an operation is the constant of that name
/// of
///   the machine or operation that calls it;
/// * any other required constant is the controller's of that name, and if the controller requires it too and runs in a
///   module, the platform's;
/// * all others, and required ones that nobody provides, are the part's own: `const_P_C_part_c`.
/// `controller` null: the machine alone, `const_P_S_c`. `module` null: the controller alone.
struct ConstantSource {
    std::string name;                    ///< as in Instantiation::constants
    const Constant* constant = nullptr;  ///< the declaration whose `value` counts if the instantiation has none
};
[[nodiscard]] ConstantSource constant_source(const System&, const Module* module, const Controller* controller,
                                             const std::string& part, const Machine&, ConstantId);

/// All of them where callers of an operation provide different ones; lowering refuses such models (RC-S19).
[[nodiscard]] std::vector<ConstantSource> constant_sources(const System&, const Module* module, const Controller&,
                                                           const std::string& part, const Machine&, ConstantId);
/// The same for a constant of a controller: the platform's if the controller requires it and runs in a module.
[[nodiscard]] ConstantSource constant_source(const Module* module, const Controller&, ConstantId);

/// One constant that a user or an assertion may set: every distinct name in the system, in order of declaration.
struct NamedConstant {
    std::string name;  ///< `const_P_C_ref_c`
    std::string path;  ///< "P::C::ref::c" for people and options
    TypeId type;
    bool has_value = false;  ///< the model gives one
};
[[nodiscard]] std::vector<NamedConstant> named_constants(const System&);

}  // namespace robochart::ir
