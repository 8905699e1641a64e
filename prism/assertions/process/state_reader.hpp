// SPDX-License-Identifier: Apache-2.0
// Reads the states of a process: which definitions its components are in, with the values of the parameters.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "checker/lts/transition_system.hpp"
#include "checker/machine/supercombinator_system.hpp"
#include "counterexample/step_reader.hpp"

namespace robochart::probability {

/// A value of a parameter, as the checker prints it.
struct Held {
    std::string text;
    ir::TypeId type;
};

/// The state of a component, as calls of its definitions. The parameter `machine` is the name of a machine in the CSP
/// semantics.
struct Part {
    std::vector<runs::Call> calls;

    [[nodiscard]] bool in_state(const std::string& machine, const std::string& element) const;
    /// Returns the value of a variable or constant; no value if there is none, or if two values are possible.
    [[nodiscard]] std::optional<Held> find_variable(const std::string& machine, const std::string& name) const;
};

/// Reads packed states. A component has few states compared with the whole process, so each of its states is read once
/// and cached.
class StateReader {
public:
    /// Both arguments must outlive the object.
    StateReader(const lts::TransitionSystem& system, runs::StepReader& reader);

    /// Returns the indices of the parts in a state. Equal parts have the same index in every state. The result is valid
    /// until the next call.
    [[nodiscard]] const std::vector<std::size_t>& parts_of_state(lts::StateView state);
    [[nodiscard]] const Part& part(std::size_t number) const { return parts_[number]; }

private:
    [[nodiscard]] std::size_t number_of(process::TermId term);
    void collect_calls(process::TermId term, int levels, std::vector<runs::Call>& calls);

    const machine::SupercombinatorSystem* compiled_;  ///< null: the states are terms
    runs::StepReader& reader_;
    std::map<process::TermId, std::size_t> numbers_;
    std::vector<Part> parts_;
    std::vector<std::size_t> found_;
};

/// Converts a truth value to 0 or 1, a literal to its index, and a real to its units. Returns no value for other types.
[[nodiscard]] std::optional<std::int64_t> number_of(const ir::System&, const ir::Instantiation&, const Held&);

}  // namespace robochart::probability
