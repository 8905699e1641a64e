// Events that properties speak of, found in the states of a process: beside the machine or module that has the
// event a process takes part in it, which never refuses it.
//     Observer(n)    = e -> Observer(1 - n)
//     Observer(n, x) = e?y -> Observer(1 - n, y)
// When the component ends, so does the observer: at its event `terminate`; behind a module that has none,
//     (P ; terminate -> SKIP) [| {e, terminate} |] (Observer(n) with [] terminate -> SKIP) \ {terminate}
// So a step is the event exactly if n is another behind it; the process behaves as before but for what its states hold.
#pragma once

#include <string>
#include <vector>

#include "csp_emit/base/emission.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::probability {

struct ObservedEvent {
    std::string component;  ///< that has it, in the CSP semantics: "P::M::c::s"
    std::string event;      ///< relative to the component, as the model has it: "e.in"
    ir::Origin origin;      ///< of the event
    ir::TypeId type;        ///< of its values; invalid: they are not asked for, or it has none
    bool valued = false;    ///< it carries values
    bool module = false;    ///< the component is one: it has no event when it ends

    /// What the definition of the observer is called in the provenance: a component of its own.
    [[nodiscard]] std::string name() const { return component + " " + event; }
};

/// The names that the parameters of observers have in the provenance.
inline constexpr const char* observed_parity = "n";
inline constexpr const char* observed_value = "x";

/// Adds the observers to the definitions D__ of their components, and their meanings. The script has each component
/// written out (Options::share_modules). Throws Wrong where there is no such component or event.
void observe(csp_emit::Emission& emission, const std::vector<ObservedEvent>& events);

}  // namespace robochart::probability
