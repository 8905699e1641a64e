// SPDX-License-Identifier: Apache-2.0
// Prepares a model given as text for checks of controllers: parses and lowers it, instantiates it, loads its timed
// script, and checks its schedulability.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "checker/cspm/session.hpp"
#include "conformance/check/conformance_check.hpp"
#include "conformance/code/shared_object.hpp"
#include "conformance/model/component.hpp"
#include "csp_emit/emit.hpp"
#include "frontend/project/project.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"
#include "semantics/lower/lower.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::conformance::test {

/// A temporary folder with a model.
class ModelFolder : public tests::TemporaryFolder {
public:
    explicit ModelFolder(const std::string& model) { write("model.rct", model); }
};

/// Loads a project from an absolute path, or from a path relative to the source folder.
struct Model {
    explicit Model(const std::string& folder, const ir::InstantiationOptions& options = {});

    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    ir::System system;
    ir::Instantiation instantiation;

    [[nodiscard]] ir::ComponentRef first_module() const;      ///< the first module
    [[nodiscard]] ir::ComponentRef first_controller() const;  ///< the first controller
    [[nodiscard]] ir::ComponentRef machine_named(const std::string& name) const;
};

/// Returns a copy of a file of the corpus with every `from` replaced by `to`.
[[nodiscard]] ModelFolder changed_copy(const std::string& file, const std::string& from, const std::string& to);

class Bench {
public:
    Bench(Model& model, ir::ComponentRef component);

    /// Generates, compiles and checks one controller. Does not repeat the check of schedulability.
    [[nodiscard]] Result check_code(cpp_emit::Fault fault = cpp_emit::Fault::none, std::uint32_t site = 0);
    [[nodiscard]] std::unique_ptr<SharedObject> compile_fault(cpp_emit::Fault fault, std::uint32_t site);
    /// Checks a controller that was compiled elsewhere.
    [[nodiscard]] Result check_code(const rc_interface& code, Relation relation = Relation::failures_divergences);
    /// Checks schedulability for the interface of the generated code.
    [[nodiscard]] Result judge_schedulability();
    [[nodiscard]] std::uint32_t site_count(cpp_emit::Fault fault);
    /// Makes the generated code ask its platform at each choice of the model. The checks then explore every answer.
    void explore_choices() {
        choices_ = true;
        interface_.reset();
    }
    [[nodiscard]] const csp_emit::Emission& script() const { return script_; }
    [[nodiscard]] cspm::ExprPtr process() const { return component_process(script_.definitions, component_); }
    /// Returns the interface of the generated code, with events of the session. Compiles the code once.
    [[nodiscard]] const Interface& interface();
    [[nodiscard]] cspm::Session& session() { return *session_; }
    [[nodiscard]] lts::TransitionSystem& system() { return *system_; }

private:
    [[nodiscard]] cpp_emit::Emission emit(cpp_emit::Fault fault, std::uint32_t site);

    Model& model_;
    ir::ComponentRef component_;
    csp_emit::Emission script_;
    std::unique_ptr<cspm::Session> session_;
    std::unique_ptr<lts::TransitionSystem> system_;
    bool choices_ = false;
    std::optional<Interface> interface_;
};

}  // namespace robochart::conformance::test
