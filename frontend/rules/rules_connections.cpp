// SPDX-License-Identifier: Apache-2.0
// Rules about connections.
#include "frontend/rules/rules.hpp"

namespace robochart::frontend::rules {

using enum diagnostics::Severity;

const Rule cn1{"Cn1", error, "`{}` is neither the platform nor a controller of module `{}`",
               "A connection of a module joins its platform and its controllers."};
const Rule cn2{"Cn2", error, "the connection of `{}` and `{}` involves the platform and must be asynchronous",
               "Platforms and controllers do not wait for each other. Write `( _async )` after the connection."};
const Rule cn3{"Cn3", error, "`{}` is neither the controller `{}` nor one of its state machines",
               "A connection of a controller joins its machines with each other and with the controller itself."};
const Rule cn4{"Cn4", error, "`{}` is a broadcast event, but `{}` is not",
               "Either both ends of a connection are broadcast events, or neither is."};
const Rule cn4_levels{
    "Cn4", error, "a broadcast connection joins two {}s; it must join components of different levels",
    "A broadcast connection joins a machine with its controller, or a controller with the platform. Components of the "
    "same level receive the broadcast events of each other through the component that contains them."};
const Rule cn_types{
    "RC-T32", error, "event `{}` carries {} but event `{}` carries {}",
    "The events at the two ends of a connection must carry values of compatible types, or both carry no value."};
const Rule cn10{"Cn10", error, "`{}` has no event `{}`",
                "Each end of a connection names an event of the component at that end."};
const Rule cn11{
    "Cn11", warning, "the asynchronous connection of two machines is treated as a synchronous one",
    "RoboTool generates the same semantics for both. There are no buffers between machines of one controller."};
const Rule c6{"C6", error, "event `{}` of `{}` already has a connection{}",
              "In a controller, an event is the start of at most one connection and the end of at most one."};
const Rule m3{"M3", error, "event `{}` of `{}` already has a connection{}",
              "In a module, an event is the start of at most one connection and the end of at most one."};
const Rule cn5{"Cn5", error,
               "a bidirectional connection ends at `{}` of `{}`, but no bidirectional connection continues it inside",
               "A connection of the module to an event of a controller must continue inside the controller in the same "
               "direction."};
const Rule cn6{"Cn6", error, "a connection ends at `{}` of `{}`, but the connection inside is bidirectional",
               "A connection of the module to an event of a controller must continue inside the controller in the same "
               "direction."};
const Rule cn6_direction{"Cn6", error, "a connection ends at `{}` of `{}`, but the connection inside ends there too",
                         "An event that arrives at a controller continues inside from the event of the controller to a "
                         "machine, not from a machine to this event."};
const Rule cn7{"Cn7", error, "a connection starts at `{}` of `{}`, but the connection inside is bidirectional",
               "A connection of the module from an event of a controller must come from inside the controller in the "
               "same direction."};
const Rule cn7_direction{"Cn7", error,
                         "a connection starts at `{}` of `{}`, but the connection inside starts there too",
                         "An event that leaves a controller comes from a machine to the event of the controller, not "
                         "from this event to a machine."};
const Rule cn8{"Cn8", error, "a connection ends at `{}` of `{}`, but `{}` sends on it{}",
               "The machine at the end of a connection receives. Reverse the connection, or let the machine receive."};
const Rule cn9{"Cn9", error, "a connection starts at `{}` of `{}`, but `{}` receives on it{}",
               "The machine at the start of a connection sends. Reverse the connection, or let the machine send."};

const std::vector<const Rule*>& of_connections() {
    static const std::vector<const Rule*> rules = {&cn1,           &cn2, &cn3, &cn4, &cn4_levels, &cn_types,      &cn10,
                                                   &cn11,          &c6,  &m3,  &cn5, &cn6,        &cn6_direction, &cn7,
                                                   &cn7_direction, &cn8, &cn9};
    return rules;
}

}  // namespace robochart::frontend::rules
