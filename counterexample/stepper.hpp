// SPDX-License-Identifier: Apache-2.0
// A process that is stepped by hand: its current state, the offers in this state, and the steps so far. The steps are
// those of the operational semantics, which is also used to replay counterexamples. Similar to the probe of FDR and the
// simulator of UPPAAL.
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
    std::string name;     ///< the name of the event, also if it is hidden
    bool hidden = false;  ///< invisible to the environment
};

/// A transition that leaves an active state but is not on offer. For a process without a model: an event that one of
/// its components offers but the whole process does not.
struct Absence {
    std::string component;
    std::string text;    ///< "met: Driving -> Turning", "a.1"
    std::string reason;  ///< "its condition `x > 1` does not hold (x = 0)"
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
    std::vector<Call> calls;  ///< the known definitions that the component currently executes
    Machine machine;          ///< empty if it is not a machine
};

class Stepper {
public:
    Stepper(StepReader& reader, process::TermId initial) : reader_(reader), initial_(initial), here_(initial) {}

    [[nodiscard]] StepReader& reader() { return reader_; }
    [[nodiscard]] process::TermId current_term() const { return here_; }
    [[nodiscard]] const std::vector<Taken>& steps_taken() const { return way_; }
    /// The time units that have passed so far.
    [[nodiscard]] std::int64_t elapsed_time() const;

    /// The possible steps in a state that was visited.
    [[nodiscard]] std::vector<Offer> offers_at(process::TermId state) const;
    /// The possible steps, in the order of the semantics, with the passing of time last. Throws like
    /// cspm::Session::transitions. Valid until the next step.
    const std::vector<Offer>& current_offers();
    /// Takes the offer with this number, from 0.
    void take_offer(std::size_t offer);
    /// Returns to the state after this number of steps.
    void back_to(std::size_t steps);
    /// Takes hidden steps while no other step is possible, at most `most`, and stops if a state repeats. Returns the
    /// number of steps.
    std::size_t take_forced_steps(std::size_t most);

    /// The machines in the current state.
    [[nodiscard]] std::vector<Machine> current_machines();
    /// The components of the process in the current state.
    [[nodiscard]] std::vector<Standing> current_components();
    /// The transitions that leave active states but are not on offer, each with the reason. For a process that is not a
    /// component of a model: at most 200 events that its components offer but the process does not.
    [[nodiscard]] std::vector<Absence> explain_absences();
    /// The structure of the process in the current state, its operators down to the components; no value if it cannot
    /// be evaluated. Valid until the next step.
    const std::optional<process::Behaviour>& current_structure();
    /// The steps so far as a run, without a violation at its end.
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
