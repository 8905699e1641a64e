// SPDX-License-Identifier: Apache-2.0
#include "simulation/trial/controller.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "base/diagnostics/splitmix64.hpp"

namespace robochart::simulation {

namespace {

/// Compares the description in the loaded object with the emitted one. Returns the first difference, or "".
std::string find_fault(const rc_drive* drive, const cpp_emit::DriveEmission& emission) {
    if (drive == nullptr) return "its interface is null";
    if (drive->abi_version != ROBOCHART_DRIVE_ABI_VERSION)
        return fmt::format("interface version {} where {} is needed", drive->abi_version, ROBOCHART_DRIVE_ABI_VERSION);
    if (drive->inputs != emission.inputs.size() || drive->outputs != emission.outputs.size() ||
        drive->machines != emission.machines.size())
        return "its inputs, outputs or machines are not those that were emitted";
    return "";
}

}  // namespace

std::vector<std::uint16_t> states_named(const Machines& machines, std::string_view name) {
    std::vector<std::uint16_t> numbers;
    if (machines.empty()) return numbers;
    const std::vector<std::string>& states = machines.front().states;
    for (std::size_t s = 0; s < states.size(); ++s)
        if (states[s] == name || states[s].starts_with(std::string(name) + "::"))
            numbers.push_back(static_cast<std::uint16_t>(s));
    return numbers;
}

Machines machines_of(const rc_drive& drive) {
    Machines result;
    for (std::uint32_t m = 0; m < drive.machines; ++m) {
        const rc_machine& machine = drive.machine[m];
        result.push_back({machine.name, {}});
        for (std::uint32_t s = 0; s < machine.states; ++s) result.back().states.emplace_back(machine.state[s]);
    }
    return result;
}

Machines machines_of(const Scenario& scenario, const Drives& drives) {
    if (drives.kinds.size() == 1) return machines_of(*drives.kinds.front());
    Machines all;
    for (std::size_t kind = 0; kind < drives.kinds.size(); ++kind) {
        const std::string& name = scenario.kind_at(kind).kind.text;
        const Machines own = machines_of(*drives.kinds[kind]);
        if (all.size() < own.size()) all.resize(own.size());
        for (std::size_t m = 0; m < own.size(); ++m) {
            if (all[m].name.empty()) all[m].name = own[m].name;
            for (const std::string& state : own[m].states)
                all[m].states.push_back(name.empty() ? state : fmt::format("{}::{}", name, state));
        }
    }
    return all;
}

StateNumbers::StateNumbers(const Drives& drives) : drives_(drives) {
    for (const rc_drive* drive : drives.kinds) {
        first_.emplace_back();
        if (total_.size() < drive->machines) total_.resize(drive->machines);
        for (std::uint32_t m = 0; m < drive->machines; ++m) {
            first_.back().push_back(total_[m]);
            total_[m] += drive->machine[m].states;
        }
    }
}

std::uint16_t StateNumbers::state_number(std::size_t kind, std::uint32_t machine, const void* controller) const {
    const rc_drive& drive = *drives_.kinds[kind];
    const std::uint32_t state = machine < drive.machines ? drive.state_of(controller, machine) : 0;
    const bool known = machine < drive.machines && state < drive.machine[machine].states;
    return static_cast<std::uint16_t>(known ? first_[kind][machine] + state : total_[machine]);
}

std::unique_ptr<Controller> Controller::build(const cpp_emit::DriveEmission& emission, const std::string& compiler,
                                              std::string& error, diagnostics::Budget* budget,
                                              diagnostics::Cache* cache) {
    cpp_emit::BuildOptions options;
    options.budget = budget;
    options.cache = cache;
    if (!compiler.empty()) options.compiler = compiler;
    // Fused multiply-add is disabled, so that results are bitwise equal wherever the controller is built.
    options.flags = "-std=c++20 -O2 -DNDEBUG -ffp-contract=off";
    auto controller = std::make_unique<Controller>();
    controller->library_ = cpp_emit::SharedLibrary::build(emission.files, emission.sources, options, error);
    if (controller->library_ == nullptr) return nullptr;
    void* const symbol = controller->library_->find_symbol("robochart_drive");
    if (symbol != nullptr) controller->drive_ = reinterpret_cast<const rc_drive* (*)()>(symbol)();
    error = find_fault(controller->drive_, emission);
    if (!error.empty()) return nullptr;
    return controller;
}

ControllerArray::ControllerArray(const rc_drive& drive, std::size_t robots, std::uint64_t seed) {
    const std::size_t alignment = std::max<std::size_t>(drive.state_alignment, 1);
    stride_ = (drive.state_size + alignment - 1) / alignment * alignment;
    block_.resize(stride_ * robots + alignment);
    const auto address = reinterpret_cast<std::uintptr_t>(block_.data());
    first_ = (alignment - address % alignment) % alignment;
    for (std::size_t robot = 0; robot < robots; ++robot) drive.initial((*this)[robot], diagnostics::splitmix64(seed));
}

}  // namespace robochart::simulation
