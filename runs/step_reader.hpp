// What processes do, step by step, in the words of the model: what a step means is read off what each sequential
// component does in it, under the name that the event has there. Runs, the search for transitions that never fire and
// whoever steps through a process by hand share it.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "checker/cspm/session.hpp"
#include "csp_emit/emit.hpp"
#include "diagnostics/source.hpp"
#include "runs/meanings.hpp"
#include "runs/run.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::runs {

/// What steps are read with; all of it outlives the reader.
struct Context {
    const csp_emit::Provenance& provenance;
    const ir::System& system;
    const ir::Instantiation& instantiation;
    const diagnostics::SourceManager& sources;
    cspm::Session& session;
};

/// What one sequential component does in a step.
struct ComponentStep {
    std::string name;          ///< of the event, as the component has it; of what it hides itself, the hidden event
    std::vector<Call> before;  ///< where the component was
    std::vector<Call> after;
};

/// An element of the resolved model in an instance of its machine: "P::M::c::s P::S::t1".
[[nodiscard]] std::string element_in(const std::string& component, const std::string& element);

/// What happens in a step: for the machine that it is reported for, and for the others that take part.
struct Happening {
    Event event;
    std::vector<Event> with;

    friend auto operator<=>(const Happening&, const Happening&) = default;
};

/// Whether two are the same for a reader of the model.
[[nodiscard]] bool same(const Event& one, const Event& other);
[[nodiscard]] bool among(const std::vector<Event>& events, const Event& event);

class StepReader {
public:
    explicit StepReader(const Context& context)
        : context_(context), meanings_(context.provenance, context.system, context.instantiation, context.sources) {}

    [[nodiscard]] const Context& context() const { return context_; }
    [[nodiscard]] const Meanings& meanings() const { return meanings_; }
    [[nodiscard]] const std::string& name(process::Event event) const {
        return context_.session.event_table().name(event);
    }
    /// For tau the event that hiding made invisible.
    [[nodiscard]] const std::string& name_of(process::Event event, process::Event revealed) const {
        return name(event == process::tau ? revealed : event);
    }

    /// The known definitions that a term is in. What stands for a machine's first definition in front of it is looked
    /// through.
    const std::vector<Call>& calls_of(process::TermId term);
    /// The machines that are in these definitions, a list for each component. Components of one name are one machine: a
    /// variable may be kept beside it.
    [[nodiscard]] std::vector<Machine> machines_of(const std::vector<std::vector<Call>>& components) const;
    /// The machines of a whole process.
    [[nodiscard]] std::vector<Machine> machines_at(process::TermId whole) { return machines_of({calls_of(whole)}); }

    /// What one component does.
    [[nodiscard]] ComponentStep component_step(const process::Move& move);
    /// The elements, as element_in has them, one of which is behind the step; more than one where it does not tell.
    [[nodiscard]] std::set<std::string> elements(const ComponentStep& step) const;
    /// What each component does in a step of a process.
    [[nodiscard]] std::vector<ComponentStep> taken_apart(process::TermId whole, const process::Transition& step);
    /// Which of several components that move together a step is reported for: a machine before what connects machines,
    /// who acts before who is acted on. `whole`: the name of the event for all of them.
    [[nodiscard]] Happening happens(const std::vector<ComponentStep>& steps, const std::string& whole) const;
    /// The same of a step of a process.
    [[nodiscard]] Happening happens(process::TermId whole, const process::Transition& step);

private:
    const Context& context_;
    Meanings meanings_;
    std::map<process::TermId, std::vector<Call>> calls_;
};

}  // namespace robochart::runs
