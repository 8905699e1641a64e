// SPDX-License-Identifier: Apache-2.0
// Loads controllers, and validates their exploration interface before it is used.
#include "conformance/code/shared_object.hpp"

#include <fmt/format.h>

namespace robochart::conformance {

namespace {

/// The greatest plausible number in an interface. Larger ones are treated as garbage.
constexpr std::uint32_t sane_count = 1U << 20U;

std::string input_fault(const rc_input& input) {
    if (input.name == nullptr) return "an input has no name";
    if (input.values > sane_count) return fmt::format("input {} has too many values", input.name);
    if (input.values == 0) return "";
    if (input.value == nullptr || input.text == nullptr) return fmt::format("input {} has no values", input.name);
    for (std::uint32_t v = 0; v < input.values; ++v) {
        if (input.text[v] == nullptr) return fmt::format("input {} has a value without text", input.name);
    }
    return "";
}

std::string output_fault(const rc_output& output) {
    if (output.name == nullptr) return "an output has no name";
    if (output.arguments > ROBOCHART_MAX_ARGUMENTS) return fmt::format("output {} has too many arguments", output.name);
    return "";
}

}  // namespace

std::string interface_fault(const rc_interface& interface) {
    if (interface.abi_version != ROBOCHART_ABI_VERSION)
        return fmt::format("interface version {} where {} is needed", interface.abi_version, ROBOCHART_ABI_VERSION);
    if (interface.initial == nullptr || interface.step == nullptr || interface.print == nullptr)
        return "a function of the interface is missing";
    if ((interface.dispatch == nullptr) != (interface.pass == nullptr) || interface.events > interface.inputs)
        return "the event API is incomplete";
    if (interface.state_size > sane_count) return fmt::format("a state of {} bytes", interface.state_size);
    if (interface.inputs > sane_count || (interface.inputs > 0 && interface.input == nullptr))
        return "the inputs are missing";
    if (interface.outputs > sane_count || (interface.outputs > 0 && interface.output == nullptr))
        return "the outputs are missing";
    if (interface.scale < 1) return fmt::format("a scale of {}", interface.scale);
    std::string fault;
    for (std::uint32_t i = 0; fault.empty() && i < interface.inputs; ++i) fault = input_fault(interface.input[i]);
    for (std::uint32_t o = 0; fault.empty() && o < interface.outputs; ++o) fault = output_fault(interface.output[o]);
    return fault;
}

std::unique_ptr<SharedObject> SharedObject::build(const std::vector<cpp_emit::OutputFile>& files,
                                                  const std::vector<std::string>& sources, const BuildOptions& options,
                                                  std::string& error) {
    std::unique_ptr<SharedObject> object(new SharedObject);
    object->library_ = cpp_emit::SharedLibrary::build(files, sources, options, error);
    if (object->library_ == nullptr || !object->find_interface(error)) return nullptr;
    return object;
}

bool SharedObject::find_interface(std::string& error) {
    void* const symbol = library_->find_symbol("robochart_explore");
    if (symbol == nullptr) {
        error = "the generated code has no exploration interface";
        return false;
    }
    interface_ = reinterpret_cast<const rc_interface* (*)()>(symbol)();
    error = interface_ == nullptr ? "it is null" : interface_fault(*interface_);
    if (error.empty()) return true;
    error = "the exploration interface cannot be used: " + error;
    return false;
}

}  // namespace robochart::conformance
