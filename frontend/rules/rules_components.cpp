// SPDX-License-Identifier: Apache-2.0
// Rules about what components, interfaces and types may contain.
#include "frontend/rules/rules.hpp"

namespace robochart::frontend::rules {

using enum diagnostics::Severity;

const Rule stm1{"STM1", error, "state machine `{}` cannot provide interface `{}`",
                "Only robotic platforms provide interfaces. A machine requires or uses them."};
const Rule stm6{
    "STM6", error, "state machine `{}` declares operation `{}`",
    "A machine does not declare operations itself. Declare the operation in an interface, and require this interface."};
const Rule stm7{"STM7", error, "state machine `{}` requires interface `{}`, which has clocks",
                "Clocks are never shared. Only operations may require the clocks of the machine that calls them. A "
                "machine uses an interface with clocks."};
const Rule stm8{"STM8", error, "`{}` calls `{}` but does not provide the variable{} it requires: {}",
                "An operation works on the variables that it requires. Its caller must have variables with the same "
                "names and compatible types."};
const Rule stm8_required{
    "STM8", warning,
    "`{0}` requires operation `{1}`, whose callers need {2}; RoboTool rejects this, although `{0}` never calls it",
    "A component that requires an operation should have the variables, events and clocks that the operation takes from "
    "its caller. Without a call, the model still has a meaning."};
const Rule stm9{"STM9", error, "operation `{}` uses event `{}`, which `{}` does not have{}",
                "The events of an operation are those of the machine that calls it."};
const Rule stm10{"STM10", error, "operation `{}` requires clock `{}`, which `{}` does not have",
                 "The clocks that an operation requires are those of the machine that calls it."};
const Rule rp1{"RP1", error, "robotic platform `{}` cannot require interface `{}`",
               "A platform provides services. No component of the model provides services to the platform."};
const Rule rp2{"RP2", error, "robotic platform `{}` uses interface `{}`, which has clocks",
               "A platform is not part of the software and has no clocks."};
const Rule rp3{"RP3", error, "robotic platform `{}` declares clock `{}`",
               "A platform is not part of the software and has no clocks."};
const Rule o1{"O1", error, "operation `{}` cannot provide interface `{}`",
              "Only robotic platforms provide interfaces."};
const Rule i1{"I1", error, "`{}` {} interface `{}`, which has {}",
              "Required interfaces contain variables and operations. Events are never required, and platforms provide "
              "neither events nor clocks. Declare events and clocks with `uses`."};
const Rule i2{"I2", error, "`{}` uses interface `{}`, which has operations",
              "Interfaces with operations are required, or provided by a platform. `uses` is for interfaces with "
              "events, variables and clocks."};
const Rule i_mixed{"I", error, "interface `{}` has both events and operations",
                   "Apart from variables and clocks, an interface contains either events or operations, because "
                   "components use events, but require or provide operations."};
const Rule c1{"C1", error, "controller `{}` has no state machine",
              "A controller does nothing by itself. Its machines determine its behaviour."};
const Rule c2{"C2", error, "controller `{}` cannot provide interface `{}`",
              "Only robotic platforms provide interfaces."};
const Rule c3{"C3", error, "controller `{}` does not provide the variable{} that `{}` requires: {}",
              "A controller must require or declare the variables that its machines require, with the same names and "
              "compatible types."};
const Rule c4{"C4", error, "controller `{}` does not provide the operation{} that `{}` requires: {}",
              "A controller must define the operations that its machines require (`operation`, `opref`), or require "
              "them itself."};
const Rule c4_operation{
    "C4w", error, "operation `{}` requires operation `{}`, which controller `{}` neither defines nor requires",
    "The operations that an operation calls are looked up in the controller, like those that its machines call."};
const Rule c7{"C7", error, "controller `{}` declares operation `{}` outside an interface",
              "A controller defines operations (`operation`, `opref`) or requires interfaces that declare them."};
const Rule c8{"C8", error, "controller `{}` defines operation `{}` more than once",
              "Each operation has one definition in a controller."};
const Rule c9{"C9", error, "controller `{}` declares clock `{}`", "Clocks belong to state machines and operations."};
const Rule c10{"C10", error, "controller `{}` uses interface `{}`, which has clocks",
               "Clocks belong to state machines and operations."};
const Rule c11{"C11", error, "controller `{}` requires interface `{}`, which has clocks",
               "Clocks belong to state machines and operations."};
const Rule m1{"M1", error, "module `{}` has {} robotic platforms, but it needs exactly one",
              "A module consists of the software and the platform on which it runs."};
const Rule m_controller{"M", error, "module `{}` has no controller",
                        "The software of a module consists of controllers."};
const Rule m_machine{
    "M", error, "module `{}` has state machine `{}` outside a controller",
    "A state machine belongs to a controller. Define it in a controller, or refer to it there by `sref`."};
const Rule m2_variables{"M2", error,
                        "the platform of module `{}` does not provide the variable{} that `{}` requires: {}",
                        "The platform of a module must provide the variables that its controllers require, with the "
                        "same names and compatible types."};
const Rule m2_operations{"M2", error,
                         "the platform of module `{}` does not provide the operation{} that `{}` requires: {}",
                         "The platform of a module must provide the operations that its controllers require."};
const Rule dt{"DT", error, "datatype `{}` has no field",
              "A datatype consists of its fields: `datatype Point { x : real y : real }`."};

const std::vector<const Rule*>& of_components() {
    static const std::vector<const Rule*> rules = {
        &stm1,         &stm6,      &stm7,         &stm8,          &stm8_required,
        &stm9,         &stm10,     &rp1,          &rp2,           &rp3,
        &o1,           &i1,        &i2,           &i_mixed,       &c1,
        &c2,           &c3,        &c4,           &c4_operation,  &c7,
        &c8,           &c9,        &c10,          &c11,           &m1,
        &m_controller, &m_machine, &m2_variables, &m2_operations, &dt};
    return rules;
}

}  // namespace robochart::frontend::rules
