// SPDX-License-Identifier: Apache-2.0
// Builds and loads a generated controller. The controllers of a simulation are state values in one array.
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

/// A state machine of the controllers by its name in the component ("" if it is the only one), and its states.
struct MachineStates {
    std::string name;
    std::vector<std::string> states;

    /// The name of a state by its number; "" between states.
    [[nodiscard]] std::string state_name(std::size_t number) const {
        return number < states.size() ? states[number] : "";
    }
};
/// The machines of the controllers. If only one is shown, it is the first.
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

/// The machines of robots of all kinds. There are as many as in the kind with the most machines; each has the states of
/// that machine in all kinds, one after another. If there are several kinds, the states are named "KIND::STATE" (for
/// kinds with a name).
[[nodiscard]] Machines machines_of(const Scenario&, const Drives&);

/// The offsets of the states of each kind's machines in the list of machines_of(Scenario, Drives).
class StateNumbers {
public:
    explicit StateNumbers(const Drives&);
    [[nodiscard]] std::uint32_t machine_count() const { return static_cast<std::uint32_t>(total_.size()); }
    /// The state of a machine of a controller of this kind. The result is the number of states if the machine is
    /// between states, or if there is no such machine.
    [[nodiscard]] std::uint16_t state_number(std::size_t kind, std::uint32_t machine, const void* controller) const;

private:
    const Drives& drives_;
    std::vector<std::vector<std::uint32_t>> first_;  ///< by kind and machine
    std::vector<std::uint32_t> total_;
};

/// The numbers of a state and of its inner states, by its name in the first machine; empty if there is no such state.
[[nodiscard]] std::vector<std::uint16_t> states_named(const Machines&, std::string_view name);

class Controller {
public:
    /// Compiles and loads the result of emit_drive. On failure returns no value and sets `error`. Throws
    /// cpp_emit::NoCompiler and diagnostics::LimitReached. `cache`: for compiled controllers; null: none.
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
    /// `seed`: for random choices of the controllers; each controller gets its own derived seed.
    ControllerArray(const rc_drive&, std::size_t robots, std::uint64_t seed = 1);

    [[nodiscard]] void* operator[](std::size_t robot) { return block_.data() + first_ + robot * stride_; }
    [[nodiscard]] const void* operator[](std::size_t robot) const { return block_.data() + first_ + robot * stride_; }

private:
    std::vector<unsigned char> block_;
    std::size_t first_ = 0;
    std::size_t stride_ = 0;
};

}  // namespace robochart::simulation
