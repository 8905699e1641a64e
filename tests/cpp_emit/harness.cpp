// SPDX-License-Identifier: Apache-2.0
#include "tests/cpp_emit/harness.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <stdexcept>

#include "semantics/instantiate/instantiate.hpp"

namespace robochart::cpp_emit::testing {

void Folder::write(const Emission& emission) const {
    for (const OutputFile& file : emission.files) write(file.path, file.text);
}

int Folder::status(const std::string& command, std::string& output) const {
    FILE* pipe = popen(("cd '" + path() + "' && (" + command + ") 2>&1").c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("no shell");
    std::array<char, 4096> chunk{};
    for (std::size_t got = 0; (got = fread(chunk.data(), 1, chunk.size(), pipe)) > 0;) output.append(chunk.data(), got);
    return pclose(pipe);
}

std::string Folder::run(const std::string& command) const {
    std::string output;
    EXPECT_EQ(status(command, output), 0) << command << "\n" << output;
    return output;
}

ir::ComponentRef component_named(const ir::System& system, const std::string& name) {
    ir::ComponentRef ref;
    ref.path = name;
    const auto look = [&](const auto& items, ir::ComponentKind kind) {
        for (std::uint32_t i = 0; i < items.size(); ++i) {
            if (items[i].name != name) continue;
            ref.kind = kind;
            ref.definition = i;
        }
    };
    look(system.machines, ir::ComponentKind::machine);
    look(system.controllers, ir::ComponentKind::controller);
    look(system.modules, ir::ComponentKind::module);
    return ref;
}

Emission emit_ok(const ir::System& system, const ir::ComponentRef& ref, const Options& options,
                 const ir::InstantiationOptions& instantiation) {
    diagnostics::Diagnostics diagnostics;
    const ir::Instantiation inst = ir::instantiate_system(system, instantiation, diagnostics);
    Emission emission = emit(system, inst, ref, options, diagnostics);
    for (const auto& finding : diagnostics.sorted_findings())
        if (finding.rule->severity != diagnostics::Severity::note)
            ADD_FAILURE() << finding.rule->code << ": " << finding.message();
    return emission;
}

Controller::Controller(const ir::System& system, const ir::ComponentRef& ref, const Options& options,
                       const ir::InstantiationOptions& instantiation)
    : emission_(emit_ok(system, ref, options, instantiation)) {
    folder_.write(emission_);
    folder_.run(
        "${CXX:-c++} -std=c++17 -O0 -Wall -Wextra -Wpedantic -Wconversion -Werror -fno-exceptions -fno-rtti -fPIC "
        "-shared -I. "
        "-o c.so " +
        emission_.shim);
    library_ = dlopen((folder_.path() + "/c.so").c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library_ == nullptr) throw std::runtime_error(dlerror());
    const auto explore = reinterpret_cast<const rc_interface* (*)()>(dlsym(library_, "robochart_explore"));
    interface_ = explore();
    reset();
}

Controller::~Controller() {
    if (library_ != nullptr) dlclose(library_);
}

void Controller::reset() {
    state_.assign(interface_->state_size, 0xAA);
    interface_->initial(state_.data());
}

std::vector<std::string> Controller::cycle(const Registers& raised) {
    std::vector<rc_register> registers(interface_->inputs);
    std::size_t found = 0;
    for (std::uint32_t i = 0; i < interface_->inputs; ++i) {
        const rc_input& input = interface_->input[i];
        const auto entry = raised.find(input.name);
        if (entry == raised.end()) continue;
        registers[i].present = 1;
        found += input.values == 0 ? 1 : 0;
        for (std::uint32_t value = 0; value < input.values; ++value) {
            if (entry->second != input.text[value]) continue;
            registers[i].value = value;
            ++found;
        }
    }
    EXPECT_EQ(found, raised.size()) << "unknown input or value";
    std::array<rc_record, 64> records{};
    rc_log log{0, 0, 64, records.data(), 0, 0, {}, {}};
    result_ = interface_->step(state_.data(), registers.data(), &log);
    EXPECT_EQ(log.overflow, 0U);
    std::vector<std::string> texts;
    for (std::uint32_t i = 0; i < log.count; ++i) {
        const rc_record& record = log.record[i];
        EXPECT_EQ(record.count, interface_->output[record.output].arguments);
        std::string text = interface_->output[record.output].name;
        for (std::uint32_t a = 0; a < record.count; ++a)
            text += (a == 0 ? "(" : ",") + std::to_string(record.argument[a]);
        texts.push_back(record.count == 0 ? text : text + ")");
    }
    return texts;
}

std::string Controller::state() const {
    std::array<char, 1024> buffer{};
    interface_->print(state_.data(), buffer.data(), buffer.size());
    return buffer.data();
}

}  // namespace robochart::cpp_emit::testing
