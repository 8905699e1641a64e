// The states that stepping by hand can reach, breadth first and up to a limit, as data: for a reader that steps without
// the checker. Offers, machines and absences are the Stepper's. Types and the function that makes them.
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/budget.hpp"
#include "runs/stepper.hpp"

namespace robochart::runs {

/// Part of the state space of a process. What states have in common is listed once and named by its place in the list.
struct Exploration {
    /// What an offer is, whatever states it connects.
    struct Label {
        Happening happening;
        std::string name;  ///< as in Offer
        bool hidden = false;

        friend auto operator<=>(const Label&, const Label&) = default;
    };
    struct Transition {
        std::size_t label = 0;
        std::optional<std::size_t> target;  ///< none: the state behind it was not explored
    };
    /// Of the structure of a process: an operator with its operands, or a component.
    struct Part {
        std::string text;                ///< part_text() of structure.hpp
        std::string offers;              ///< of a component: offers_text()
        std::vector<std::size_t> parts;  ///< of an operator

        friend auto operator<=>(const Part&, const Part&) = default;
    };
    struct State {
        std::vector<std::size_t> machines;  ///< where they are
        std::string process;                ///< its text; only where there is no machine
        std::vector<Transition> offers;     ///< all of them, in the order of Stepper::offers
        std::vector<std::size_t> absences;
        std::optional<std::size_t> structure;  ///< the part that is the whole; none where it cannot be evaluated
        std::string error;                     ///< why its definitions cannot be evaluated; then it has no offers
    };

    std::vector<State> states;  ///< the first is the initial one
    std::vector<Label> labels;
    std::vector<Machine> machines;
    std::vector<Absence> absences;
    std::vector<Part> parts;
    std::size_t left_out = 0;  ///< states that were found and not explored
    std::string limit;         ///< which limit ended the exploration; "" if none did
};

/// Where an exploration ends.
struct ExplorationLimits {
    std::size_t states = 5000;
    std::size_t transitions = 200'000;
};

/// What of a process can be reached from a state. Polls the budget; what is explored when a limit of it is reached
/// stays.
[[nodiscard]] Exploration explore(StepReader&, process::TermId initial, const ExplorationLimits&, diagnostics::Budget&);

}  // namespace robochart::runs
