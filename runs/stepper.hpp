// A process animated by hand: where it is, what it offers there, and the way that led there. Its steps are those of the
// operational semantics, which every counterexample is replayed by. After the probe of FDR and the simulator of UPPAAL.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "checker/process/behaviour.hpp"
#include "checker/process/term.hpp"
#include "csp_emit/emit.hpp"
#include "runs/run.hpp"
#include "runs/step_reader.hpp"

namespace robochart::runs {

/// Something that can happen next.
struct Offer {
    process::Transition step;
    Happening happening;
    std::string name;     ///< of the event; where it is hidden, the name behind it
    bool hidden = false;  ///< the environment does not see it
};

/// A transition that leaves an active state and is not on offer; of a process, an event that one of its components
/// offers and the whole does not.
struct Absence {
    std::string component;
    std::string text;    ///< "met: Driving -> Turning", "a.1"
    std::string reason;  ///< "its condition `x > 1` does not hold (x = 0)"
    std::optional<Place> place;

    friend auto operator<=>(const Absence&, const Absence&) = default;
};

/// A step of the way.
struct Taken {
    process::TermId before{};
    Offer offer;
};

/// One sequential component of the process where it stands.
struct Standing {
    process::TermId term{};
    std::vector<Call> calls;  ///< the known definitions that it is in
    Machine machine;          ///< empty where it is none
};

class Stepper {
public:
    Stepper(StepReader& reader, process::TermId initial) : reader_(reader), initial_(initial), here_(initial) {}

    [[nodiscard]] StepReader& reader() { return reader_; }
    [[nodiscard]] process::TermId here() const { return here_; }
    [[nodiscard]] const std::vector<Taken>& way() const { return way_; }
    /// Time units that have passed on the way.
    [[nodiscard]] std::int64_t time() const;

    /// What can happen at a state of the way.
    [[nodiscard]] std::vector<Offer> offers_at(process::TermId state) const;
    /// What can happen, the passing of time last, otherwise in the order of the semantics. Throws what
    /// cspm::Session::transitions throws. Good until the next step.
    const std::vector<Offer>& offers();
    /// Takes the offer of this number, from 0.
    void take(std::size_t offer);
    /// Goes back to where the way had so many steps.
    void back_to(std::size_t steps);
    /// Takes hidden steps while nothing else can happen, `most` at most, and ends where a state is met again; returns
    /// how many.
    std::size_t settle(std::size_t most);

    /// The machines where the process stands.
    [[nodiscard]] std::vector<Machine> machines();
    /// The components of the process where it stands.
    [[nodiscard]] std::vector<Standing> components();
    /// The transitions that leave active states and are not on offer, each with the reason; of a process that is no
    /// component of a model, the events that its parts offer and it does not, 200 at most.
    [[nodiscard]] std::vector<Absence> absences();
    /// The structure of the process where it stands, its operators down to the components; none where it cannot be
    /// evaluated. Good until the next step.
    const std::optional<process::Behaviour>& structure();
    /// The way as a run; its end says nothing.
    [[nodiscard]] Run run(csp_emit::Time time) const;

private:
    StepReader& reader_;
    process::TermId initial_, here_;
    std::vector<Taken> way_;
    std::optional<std::vector<Offer>> offers_;
    std::optional<std::optional<process::Behaviour>> structure_;

    static constexpr std::size_t most_blocked = 200;

    void move_to(process::TermId state);
    [[nodiscard]] std::vector<Absence> blocked();

    [[nodiscard]] std::vector<Machine> machines_of(const std::vector<Standing>&) const;
    [[nodiscard]] std::set<std::string> offered_elements();
    [[nodiscard]] std::set<std::string> ready_elements(const Standing&);
    [[nodiscard]] std::string reason(const ir::Transition&, const Standing&, bool ready) const;
};

}  // namespace robochart::runs
