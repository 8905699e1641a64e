// SPDX-License-Identifier: Apache-2.0
// Describes the steps of processes in terms of the model. A step is described by the actions of the sequential
// components that take part in it, with the components' own names of the event. Counterexamples, the search for
// transitions that never fire, and stepping by hand use this description.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics/source.hpp"
#include "checker/cspm/session.hpp"
#include "counterexample/meanings.hpp"
#include "counterexample/run.hpp"
#include "csp_emit/emit.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::runs {

/// The data that a reader needs. All of it must outlive the reader.
struct Context {
    const csp_emit::Provenance& provenance;
    const ir::System& system;
    const ir::Instantiation& instantiation;
    const diagnostics::SourceManager& sources;
    cspm::Session& session;
    durations::Unit unit = {};
};

/// The step of one sequential component.
struct ComponentStep {
    std::string name;          ///< the component's own name of the event, even if the component hides the event
    std::vector<Call> before;  ///< the definitions that the component executes before the step
    std::vector<Call> after;
};

/// Returns the text for an element of the resolved model in an instance of its machine: "P::M::c::s P::S::t1".
[[nodiscard]] std::string element_in(const std::string& component, const std::string& element);

/// The events of a step: the event of the machine for which the step is reported, and the events of the other machines
/// that take part.
struct Happening {
    Event event;
    std::vector<Event> with;

    friend auto operator<=>(const Happening&, const Happening&) = default;
};

/// Returns true if both events are the same in terms of the model.
[[nodiscard]] bool same_event(const Event& one, const Event& other);
[[nodiscard]] bool is_among(const std::vector<Event>& events, const Event& event);

class StepReader {
public:
    explicit StepReader(const Context& context)
        : context_(context), meanings_(context.provenance, context.system, context.instantiation, context.sources) {}

    [[nodiscard]] const Context& context() const { return context_; }
    [[nodiscard]] const Meanings& meanings() const { return meanings_; }
    [[nodiscard]] const std::string& name(process::Event event) const {
        return context_.session.event_table().name(event);
    }
    /// Returns the name of an event; for tau, returns the name of the hidden event.
    [[nodiscard]] const std::string& name_of(process::Event event, process::Event revealed) const {
        return name(event == process::tau ? revealed : event);
    }

    /// Returns the known definitions that a term executes. If the term is a call of a definition, it is unfolded.
    const std::vector<Call>& calls_of(process::TermId term);
    /// Returns the machines in these definitions; there is one list of definitions per component. Components with the
    /// same name are one machine, because a variable may be stored in a separate process.
    [[nodiscard]] std::vector<Machine> machines_of(const std::vector<std::vector<Call>>& components) const;
    /// Returns the machines of a whole process.
    [[nodiscard]] std::vector<Machine> machines_at(process::TermId whole) { return machines_of({calls_of(whole)}); }

    /// Describes the step of one component.
    [[nodiscard]] ComponentStep component_step(const process::Move& move);
    /// Returns the candidates (see element_in) for the cause of the step. There are several if the step does not
    /// determine its cause.
    [[nodiscard]] std::set<std::string> elements_of(const ComponentStep& step) const;
    /// Returns the step of each component in a step of a process.
    [[nodiscard]] std::vector<ComponentStep> taken_apart(process::TermId whole, const process::Transition& step);
    /// Selects the component for which a step is reported if several components move together. Machines have precedence
    /// over connections, and the component that acts has precedence over the others. `whole`: the name of the event in
    /// the whole process.
    [[nodiscard]] Happening happening_of(const std::vector<ComponentStep>& steps, const std::string& whole) const;
    /// Describes a step of a whole process in the same way.
    [[nodiscard]] Happening happening_of(process::TermId whole, const process::Transition& step);

private:
    const Context& context_;
    Meanings meanings_;
    std::map<process::TermId, std::vector<Call>> calls_;
};

}  // namespace robochart::runs
