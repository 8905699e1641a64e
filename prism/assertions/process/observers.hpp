// SPDX-License-Identifier: Apache-2.0
// Makes the events in properties visible in the states of a process. An observer runs in parallel with the machine or
// module that has the event. It takes part in the event and never refuses it:
//    Observer(n)    = e -> Observer(1 - n)
//    Observer(n, x) = e?y -> Observer(1 - n, y)
// The observer terminates together with the component, at the component's event `terminate`. A module has no such
// event, so its process P is replaced by
//    (P ; terminate -> SKIP) [| {e, terminate} |] (Observer(n) with [] terminate -> SKIP) \ {terminate}
// A step is the event e exactly if the step changes n. The process behaves as before; only its states contain more
// data.
#pragma once

#include <string>
#include <vector>

#include "csp_emit/base/emission.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::probability {

struct ObservedEvent {
    std::string component;  ///< the component of the event, in the CSP semantics: "P::M::c::s"
    std::string event;      ///< relative to the component, as in the model: "e.in"
    ir::Origin origin;      ///< the origin of the event
    ir::TypeId type;        ///< the type of the event's values; invalid if no value is needed or carried
    bool valued = false;    ///< true: the event carries values
    bool module = false;    ///< true: the component is a module, which has no event for termination

    /// Returns the name of the observer's definition in the provenance. It is used if the observer is a separate
    /// component.
    [[nodiscard]] std::string name() const { return component + " " + event; }
};

/// The names of the observers' parameters in the provenance.
inline constexpr const char* observed_parity = "n";
inline constexpr const char* observed_value = "x";

/// Adds the observers to the definitions D__ of their components, and adds their meanings to the provenance. The script
/// must contain the definitions of every component in full (Options::share_modules). Throws Wrong if there is no such
/// component or event.
void add_observers(csp_emit::Emission& emission, const std::vector<ObservedEvent>& events);

}  // namespace robochart::probability
