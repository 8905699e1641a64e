// SPDX-License-Identifier: Apache-2.0
// Gives names in properties a meaning in the states of a process.
#pragma once

#include <string>
#include <vector>

#include "prism/assertions/process/observers.hpp"
#include "prism/assertions/process/seats.hpp"
#include "prism/assertions/properties/elements.hpp"

namespace robochart::probability {

/// A value that is read from the states of a process, and becomes a variable of the PRISM model.
struct Observable {
    std::string name;       ///< name in PRISM
    std::string component;  ///< the component of the machine, in the CSP semantics
    std::string variable;   ///< "" if a state is read
    std::string state;      ///< the path of the state
    bool boolean = false;
    bool carried = false;  ///< true for the last value that an event carried; 0 before the first event
};

/// A constant of the model, with the machine that uses it.
struct ConstantHere {
    std::string name;  ///< name in PRISM
    const Seat* seat = nullptr;
    ir::ConstantId id;
    bool real = false;
};

class ProcessNames final : public Elements {
public:
    ProcessNames(const ir::System& system, const ir::ComponentRef& subject);

    [[nodiscard]] prism::ExprPtr variable_expression(const std::string& path) override;
    [[nodiscard]] prism::ExprPtr constant_expression(const std::string& path) override;
    [[nodiscard]] prism::ExprPtr in_state(const std::string& machine, const std::string& state) override;
    [[nodiscard]] std::string event_action(const std::string& path, const std::string& direction) override;
    [[nodiscard]] prism::ExprPtr event_value(const std::string& path, const std::string& direction) override;
    /// State rewards are earned per time unit that begins in the state.
    [[nodiscard]] prism::RewardItem of_state(prism::RewardItem item) override;
    [[nodiscard]] bool is_name_taken(const std::string& name) const override;

    [[nodiscard]] const std::vector<Seat>& seats() const { return seats_; }
    [[nodiscard]] const std::vector<Observable>& observables() const { return observables_; }
    [[nodiscard]] const std::vector<ConstantHere>& constants() const { return constants_; }
    [[nodiscard]] const std::vector<ObservedEvent>& observed() const { return observed_; }
    /// Returns the machine's constant with this path. Throws NotExpressed.
    [[nodiscard]] ConstantHere find_constant(const std::string& path) const;

    /// The name of the PRISM constant that contains the scale of reals.
    static constexpr const char* units = "units__";

private:
    [[nodiscard]] const Seat* find_seat(const std::string& path) const;
    [[nodiscard]] std::string free_name(const std::string& path) const;
    [[nodiscard]] prism::ExprPtr observed(Observable observable);
    /// Returns the index of an event in `observed`. `valued` is true if the property uses the values of the event.
    [[nodiscard]] std::size_t observed_event(const std::string& path, const std::string& direction, bool valued);
    [[nodiscard]] prism::ExprPtr shared_variable(const std::string& path, const std::string& name);

    const ir::System& system_;
    const ir::ComponentRef& subject_;
    std::vector<Seat> seats_;
    std::vector<Observable> observables_;
    std::vector<ConstantHere> constants_;
    std::vector<ObservedEvent> observed_;
};

}  // namespace robochart::probability
