// SPDX-License-Identifier: Apache-2.0
// Steps a process by hand. The object contains its current state, the offers in this state, and the steps so far. The
// steps are those of the operational semantics, which is also used to replay counterexamples. The probe of FDR and the
// simulator of UPPAAL are similar.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "checker/process/behaviour.hpp"
#include "checker/process/term.hpp"
#include "counterexample/run.hpp"
#include "counterexample/step_reader.hpp"
#include "csp_emit/emit.hpp"

namespace robochart::runs {

/// A possible next step.
struct Offer {
    process::Transition step;
    Happening happening;
    std::string name;     ///< the name of the event, even if the event is hidden
    bool hidden = false;  ///< whether the environment cannot see the step
};

/// A transition that leaves an active state but is not offered. For a process without a model: an event that one of its
/// components offers but the whole process does not.
struct Absence {
    std::string component;
    std::string text;    ///< such as "met: Driving -> Turning" or "a.1"
    std::string reason;  ///< such as "its condition `x > 1` does not hold (x = 0)"
    std::optional<Place> place;

    friend auto operator<=>(const Absence&, const Absence&) = default;
};

/// A step that was taken.
struct Taken {
    process::TermId before{};
    Offer offer;
};

/// One sequential component of the process in its current state.
struct Standing {
    process::TermId term{};
    std::vector<Call> calls;  ///< the known definitions that the component executes
    Machine machine;          ///< empty if the component is not a machine
};

class Stepper {
public:
    Stepper(StepReader& reader, process::TermId initial) : reader_(reader), initial_(initial), here_(initial) {}

    [[nodiscard]] StepReader& reader() { return reader_; }
    [[nodiscard]] process::TermId current_term() const { return here_; }
    [[nodiscard]] const std::vector<Taken>& steps_taken() const { return way_; }
    /// Returns the time units that have passed so far.
    [[nodiscard]] std::int64_t elapsed_time() const;

    /// Returns the possible steps in a state that was visited.
    [[nodiscard]] std::vector<Offer> offers_at(process::TermId state) const;
    /// Returns the possible steps in the order of the semantics; the passing of time is last. Throws the same
    /// exceptions as cspm::Session::transitions. The result is valid until the next step.
    const std::vector<Offer>& current_offers();
    /// Takes the offer with this number, counted from 0.
    void take_offer(std::size_t offer);
    /// Returns to the state after this number of steps.
    void back_to(std::size_t steps);
    /// Takes hidden steps as long as no other step is possible, but at most `most`. Also stops if a state repeats.
    /// Returns the number of steps.
    std::size_t take_forced_steps(std::size_t most);

    /// Returns the machines in the current state.
    [[nodiscard]] std::vector<Machine> current_machines();
    /// Returns the components of the process in the current state.
    [[nodiscard]] std::vector<Standing> current_components();
    /// Returns the transitions that leave active states but are not offered, each with the reason. For a process that
    /// is not a component of a model, returns at most 200 events that its components offer but the process does not.
    [[nodiscard]] std::vector<Absence> explain_absences();
    /// Returns the structure of the process in the current state: its operators down to the components. It has no value
    /// if it cannot be evaluated. The result is valid until the next step.
    const std::optional<process::Behaviour>& current_structure();
    /// Returns the steps so far as a run without a violation at its end.
    [[nodiscard]] Run run(csp_emit::Time time) const;

private:
    StepReader& reader_;
    process::TermId initial_, here_;
    std::vector<Taken> way_;
    std::optional<std::vector<Offer>> offers_;
    std::optional<std::optional<process::Behaviour>> structure_;

    static constexpr std::size_t most_blocked = 200;

    void move_to(process::TermId state);
    [[nodiscard]] std::vector<Absence> blocked_by_process();

    [[nodiscard]] std::vector<Machine> machines_of(const std::vector<Standing>&) const;
    [[nodiscard]] std::set<std::string> offered_elements();
    [[nodiscard]] std::set<std::string> ready_elements(const Standing&);
    [[nodiscard]] std::string absence_reason(const ir::Transition&, const Standing&, bool ready) const;
};

}  // namespace robochart::runs
