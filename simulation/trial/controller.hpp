// SPDX-License-Identifier: Apache-2.0
// Builds and loads a generated controller. The controllers of a trial are values of its state type in one array.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cpp_emit/load/shared_library.hpp"
#include "cpp_emit/runtime/drive_abi.h"
#include "cpp_emit/simulator_api.hpp"
#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

/// A state machine of a controller, with its states. `name` is its name in the component, or "" if it is the only
/// machine.
struct MachineStates {
    std::string name;
    std::vector<std::string> states;

    /// Returns the name of the state with this number, or "" between states.
    [[nodiscard]] std::string state_name(std::size_t number) const {
        return number < states.size() ? states[number] : "";
    }
};
/// The machines of a controller. Reports that show only one machine show the first.
using Machines = std::vector<MachineStates>;
[[nodiscard]] Machines machines_of(const rc_drive&);

/// The loaded controllers of a scenario: those of its kinds of robots, in order, and that of its environment.
struct Drives {
    Drives(const rc_drive& only) : kinds{&only} {}
    Drives(std::vector<const rc_drive*> of_kinds, const rc_drive* of_environment)
        : kinds(std::move(of_kinds)), environment(of_environment) {}

    std::vector<const rc_drive*> kinds;
    const rc_drive* environment = nullptr;  ///< null: no environment
};

/// Returns machines that represent the robots of all kinds: as many as the kind with the most machines has. The i-th
/// has the states of the i-th machine of each kind, one kind after another. If there are several kinds, the states of
/// kinds with a name are named "KIND::STATE".
[[nodiscard]] Machines machines_of(const Scenario&, const Drives&);

/// Numbers the states of all kinds as in the result of machines_of(Scenario, Drives).
class StateNumbers {
public:
    explicit StateNumbers(const Drives&);
    [[nodiscard]] std::uint32_t machine_count() const { return static_cast<std::uint32_t>(total_.size()); }
    /// Returns the number of the state in which a controller's machine is. If the machine is between states or does not
    /// exist, returns the number of states.
    [[nodiscard]] std::uint16_t state_number(std::size_t kind, std::uint32_t machine, const void* controller) const;

private:
    const Drives& drives_;
    std::vector<std::vector<std::uint32_t>> first_;  ///< by kind and machine
    std::vector<std::uint32_t> total_;
};

/// Returns the numbers of the state with this name in the first machine, and of its inner states; empty if there is no
/// such state.
[[nodiscard]] std::vector<std::uint16_t> states_named(const Machines&, std::string_view name);

class Controller {
public:
    /// Compiles and loads the result of emit_drive. On failure returns no value and sets `error`. `cache` stores
    /// compiled controllers; it may be null. Throws cpp_emit::NoCompiler and diagnostics::LimitReached.
    static std::unique_ptr<Controller> build(const cpp_emit::DriveEmission&, const std::string& compiler,
                                             std::string& error, diagnostics::Budget* budget = nullptr,
                                             diagnostics::Cache* cache = nullptr);

    [[nodiscard]] const rc_drive& drive() const { return *drive_; }

private:
    std::unique_ptr<cpp_emit::SharedLibrary> library_;
    const rc_drive* drive_ = nullptr;
};

/// The controllers of all robots of a trial: one aligned block, with one value per robot.
class ControllerArray {
public:
    /// `seed` is for random choices of the controllers. Each controller gets its own seed, which is derived from it.
    ControllerArray(const rc_drive&, std::size_t robots, std::uint64_t seed = 1);

    [[nodiscard]] void* operator[](std::size_t robot) { return block_.data() + first_ + robot * stride_; }
    [[nodiscard]] const void* operator[](std::size_t robot) const { return block_.data() + first_ + robot * stride_; }

private:
    std::vector<unsigned char> block_;
    std::size_t first_ = 0;
    std::size_t stride_ = 0;
};

}  // namespace robochart::simulation
