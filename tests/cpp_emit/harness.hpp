// SPDX-License-Identifier: Apache-2.0
// Generates a component, compiles it as conformance does, loads it and runs it cycle by cycle.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cpp_emit/emit.hpp"
#include "cpp_emit/runtime/explore_abi.h"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::cpp_emit::testing {

/// A temporary folder for generated code.
class Folder : public tests::TemporaryFolder {
public:
    using tests::TemporaryFolder::write;
    void write(const Emission&) const;
    /// Runs a shell command in the folder and returns its output. A nonzero exit code fails the test.
    std::string run(const std::string& command) const;
    [[nodiscard]] int status(const std::string& command, std::string& output) const;
};

/// The inputs of one cycle. Maps a register's name to the text of its value as in rc_input::text ("" for inputs without
/// value).
using Registers = std::map<std::string, std::string>;

/// A controller that is loaded from a shared object.
class Controller {
public:
    Controller(const ir::System&, const ir::ComponentRef&, const Options& = {}, const ir::InstantiationOptions& = {});
    ~Controller();
    Controller(const Controller&) = delete;
    Controller& operator=(const Controller&) = delete;

    /// Runs one cycle and returns its outputs: "MoveClockwiseCall(-75,-1088)", "out.out(1)", "stop.out".
    std::vector<std::string> cycle(const Registers& = {});
    /// Returns to the initial state.
    void reset();
    [[nodiscard]] rc_result result() const { return result_; }
    [[nodiscard]] std::string state() const;
    /// Returns the bytes of the state.
    [[nodiscard]] const std::vector<unsigned char>& image() const { return state_; }
    void restore(const std::vector<unsigned char>& image) { state_ = image; }
    [[nodiscard]] const rc_interface& interface() const { return *interface_; }
    [[nodiscard]] std::uint32_t fault_sites() const { return emission_.fault_sites; }
    [[nodiscard]] const Emission& emission() const { return emission_; }

private:
    Folder folder_;
    Emission emission_;
    void* library_ = nullptr;
    const rc_interface* interface_ = nullptr;
    std::vector<unsigned char> state_;
    rc_result result_ = RC_QUIESCENT;
};

/// Returns a reference to a machine, controller or module by its name.
[[nodiscard]] ir::ComponentRef component_named(const ir::System&, const std::string& name);
/// Generates code. Findings other than notes fail the test.
[[nodiscard]] Emission emit_ok(const ir::System&, const ir::ComponentRef&, const Options& = {},
                               const ir::InstantiationOptions& = {});

}  // namespace robochart::cpp_emit::testing
