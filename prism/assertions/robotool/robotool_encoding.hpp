// SPDX-License-Identifier: Apache-2.0
// Uses RoboTool's encoding of a module (prism_emit) as the model for properties. Everything that a property adds
// (rewards, modules, functions in place of calls) is added to a copy of the model, as in RoboTool.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "prism/assertions/experiments/encoding.hpp"
#include "prism/assertions/properties/translate.hpp"
#include "prism/emit/emit.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::probability {

struct RoboToolOptions {
    prism_emit::Preferences preferences;
    /// The user's values for constants that have no value in the model: maps the name, or the end of the path, to a
    /// literal.
    std::map<std::string, std::string> constants;
    std::uint64_t max_states = 500'000'000;
    bool exact = false;
    diagnostics::Budget* budget = nullptr;
};

class RoboToolEncoding final : public Encoding {
public:
    /// The system and the module must outlive the object. `functions` contains the functions that assertions define;
    /// they are used for calls in the model. Throws NotExpressed if the encoding does not support the module.
    RoboToolEncoding(const ir::System& system, const ir::Module& module, RoboToolOptions options,
                     const std::map<std::string, Function>& functions);
    ~RoboToolEncoding() override;

    [[nodiscard]] Elements& elements() override;
    [[nodiscard]] prism::Constant prism_constant(const std::string& path) override;
    [[nodiscard]] const prism::StateSpace& explore_space(const Question&, const prism::Values&) override;
    [[nodiscard]] Unexplored unexplored_model(const Question&, const prism::Values&) override;
    [[nodiscard]] bool one_value() const override { return false; }
    /// Returns the model, extended as the question needs it.
    [[nodiscard]] prism::ModelFile model_for(const Question&);

private:
    class Names;
    struct Prepared;

    Prepared& prepare_model(const Question&, const prism::Values&);
    /// Returns ranges that contain the values that a question gives to constants, and one more value, because counters
    /// must be able to exceed a limit.
    [[nodiscard]] prism_emit::Preferences ranges_for(const Question&);
    [[nodiscard]] prism::Values all_values(const prism::ModelFile&, const prism::Values&) const;

    const ir::System& system_;
    const ir::Module& module_;
    RoboToolOptions options_;
    std::map<std::string, Function> functions_;
    prism_emit::Emission emission_;
    prism_emit::Preferences emitted_for_;  ///< the ranges of `emission_`
    std::unique_ptr<Names> names_;
    Wording wording_;
    std::unique_ptr<Prepared> prepared_;  ///< the latest model; questions about one model come together
};

}  // namespace robochart::probability
