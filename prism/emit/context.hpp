// SPDX-License-Identifier: Apache-2.0
// Declares the data that all parts of one emission share: the module, the model under construction, and its names.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "prism/emit/emission.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::prism_emit {

/// The values of a variable: false and true, or low..high.
struct Carrier {
    bool boolean = false;
    std::int64_t low = 0, high = 1;
};

class Context {
public:
    Context(const ir::System& whole, const Preferences& preferences, const ir::Module& encoded, const Functions& given,
            diagnostics::Diagnostics& findings)
        : system(whole), module(encoded), functions(given), diagnostics(findings), preferences_(preferences) {}

    const ir::System& system;
    const ir::Module& module;
    const Functions& functions;  ///< functions that assertions define
    diagnostics::Diagnostics& diagnostics;
    Emission emission;

    /// Returns a name that begins with `preferred` and is neither reserved nor in use.
    [[nodiscard]] std::string unique_name(const std::string& preferred);
    /// Records the PRISM name of a variable of the model.
    void record_name(const ir::Variable& variable, const std::string& element, const std::string& name);
    /// Records the PRISM name of an element.
    void record_name(const std::string& kind, const std::string& element, const std::string& name);
    /// Makes a numbered name, such as "tick_16" or "Action_20". The numbers increase over the whole model.
    [[nodiscard]] std::string numbered_name(const std::string& stem) {
        return unique_name(stem + "_" + std::to_string(next_++));
    }
    /// Makes a numbered name for an element that the normal form adds.
    [[nodiscard]] std::string added_name(const std::string& stem) { return stem + "_" + std::to_string(next_added_++); }

    /// Returns the range of a type (R3). Returns no value and reports a finding about `element` if the type has no
    /// encoding.
    [[nodiscard]] std::optional<Carrier> find_carrier(ir::TypeId type, const std::string& element,
                                                      const diagnostics::Span& span);
    /// Returns the declaration of a variable with this range.
    [[nodiscard]] static prism::Variable declare_variable(const std::string& name, const Carrier& carrier,
                                                          prism::ExprPtr initial);
    /// Returns the PRISM name of a literal. R1: enumerations are constants, `SHuman_inRed`.
    [[nodiscard]] const std::string& literal_name(ir::TypeId type, std::int64_t index);

private:
    const Preferences& preferences_;
    std::set<std::string> taken_;
    std::map<std::pair<std::uint32_t, std::int64_t>, std::string> literals_;
    unsigned next_ = 16;  ///< RoboTool's own counters use the numbers below 16
    unsigned next_added_ = 1;
};

}  // namespace robochart::prism_emit
