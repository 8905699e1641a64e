// SPDX-License-Identifier: Apache-2.0
// Computes the states that stepping by hand can reach, breadth first and up to a limit. A page uses these data for
// stepping without the checker. Offers, machines and absences are those of Stepper.
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "counterexample/stepper.hpp"

namespace robochart::runs {

/// Part of the state space of a process. Data that several states share are stored once; the states refer to them by
/// index.
struct Exploration {
    /// An offer without its source and target states.
    struct Label {
        Happening happening;
        std::string name;  ///< the name of the event, as in Offer
        bool hidden = false;

        friend auto operator<=>(const Label&, const Label&) = default;
    };
    struct Transition {
        std::size_t label = 0;
        std::optional<std::size_t> target;  ///< no value if the state after the transition was not explored
    };
    /// A part of the structure of a process: an operator with its operands, or a component.
    struct Part {
        std::string text;                ///< part_text() of structure.hpp
        std::string offers;              ///< offers_text() of a component; "" for an operator
        std::vector<std::size_t> parts;  ///< operands of an operator

        friend auto operator<=>(const Part&, const Part&) = default;
    };
    struct State {
        std::vector<std::size_t> machines;  ///< indices of the machines in the state
        std::string process;                ///< the text of the process, if the state has no machine
        std::vector<Transition> offers;     ///< all offers, in the order of Stepper::offers
        std::vector<std::size_t> absences;
        std::optional<std::size_t> structure;  ///< index of the root; no value if the structure cannot be evaluated
        std::string error;  ///< why the definitions cannot be evaluated; the state then has no offers
    };

    std::vector<State> states;  ///< the first is the initial one
    std::vector<Label> labels;
    std::vector<Machine> machines;
    std::vector<Absence> absences;
    std::vector<Part> parts;
    std::size_t left_out = 0;  ///< number of states that were found but not explored
    std::string limit;         ///< the limit that ended the exploration, or ""
};

/// The limits of an exploration.
struct ExplorationLimits {
    std::size_t states = 5000;
    std::size_t transitions = 200'000;
};

/// Explores the states that can be reached from a state. Polls the budget. If a limit of the budget is reached, the
/// result contains what was explored until then.
[[nodiscard]] Exploration explore_process(StepReader&, process::TermId initial, const ExplorationLimits&,
                                          diagnostics::Budget&);

}  // namespace robochart::runs
