// SPDX-License-Identifier: Apache-2.0
// Checks models. See check.hpp.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/diagnostics/spelling.hpp"
#include "prism/checks/check.hpp"
#include "prism/checks/compose.hpp"
#include "prism/checks/definitions.hpp"
#include "prism/checks/rules.hpp"
#include "prism/checks/scope.hpp"
#include "prism/checks/types.hpp"

namespace robochart::prism {
namespace {

class ModelChecker {
public:
    ModelChecker(const ModelFile& file, diagnostics::Diagnostics& diagnostics)
        : file_(file), diagnostics_(diagnostics) {}

    std::optional<CheckedModel> operator()() {
        const std::size_t errors = diagnostics_.error_count();
        model_.kind = file_.kind;
        model_.formulas = expand_formulas(file_.formulas, formulas_, diagnostics_);
        expand_declarations();
        for (const Module& module : file_.modules) add_module(module);
        collect_variables();
        declare();
        if (diagnostics_.error_count() == errors) check();
        if (diagnostics_.error_count() == errors)
            model_.synchronisations = compose(model_.modules, file_.system, diagnostics_);
        if (diagnostics_.error_count() != errors) return std::nullopt;
        return std::move(model_);
    }

private:
    ExprPtr expand_if_manageable(const ExprPtr& expr) {
        ExprPtr result = formulas_(expr);
        if (result && !is_manageable(result, expr->span, diagnostics_)) return expr;
        return result;
    }

    void expand_variable(Variable& variable) {
        for (ExprPtr* expr : {&variable.low, &variable.high, &variable.initial}) *expr = expand_if_manageable(*expr);
    }

    void expand_declarations() {
        model_.constants = file_.constants;
        for (Constant& constant : model_.constants) constant.value = expand_if_manageable(constant.value);
        model_.labels = file_.labels;
        for (Definition& label : model_.labels) label.body = expand_if_manageable(label.body);
        model_.rewards = file_.rewards;
        for (RewardStructure& structure : model_.rewards)
            for (RewardItem& item : structure.items) {
                item.guard = expand_if_manageable(item.guard);
                item.value = expand_if_manageable(item.value);
            }
        model_.variables = file_.globals;
        for (Variable& variable : model_.variables) expand_variable(variable);
        model_.initial = expand_if_manageable(file_.initial);
    }

    void add_module(const Module& written) {
        if (written.base.text.empty()) {
            Module module = written;
            for (Variable& variable : module.variables) expand_variable(variable);
            for (Command& command : module.commands) expand_command(command);
            model_.modules.push_back(std::move(module));
            return;
        }
        // A base that is itself renamed must be declared before the renamed module. Any other base may also be declared
        // after it.
        const auto named = [&](const Module& module) { return module.name.text == written.base.text; };
        const auto above = std::ranges::find_if(model_.modules, named);
        if (above != model_.modules.end()) return add_renamed(written, *above);
        const auto below = std::ranges::find_if(file_.modules, named);
        if (below == file_.modules.end()) {
            diagnostics_.report(rules::not_declared, written.base.span, {"module", written.base.text});
        } else if (!below->base.text.empty()) {
            diagnostics_.report(
                rules::bad_renaming, written.base.span,
                {written.name.text,
                 fmt::format("its base '{}' is a renamed module that is not declared before it", written.base.text)});
        } else {
            Module base = *below;
            for (Variable& variable : base.variables) expand_variable(variable);
            for (Command& command : base.commands) expand_command(command);
            add_renamed(written, base);
        }
    }

    void expand_command(Command& command) {
        command.guard = expand_if_manageable(command.guard);
        for (Branch& branch : command.branches) {
            branch.probability = expand_if_manageable(branch.probability);
            for (Assignment& assignment : branch.assignments) assignment.value = expand_if_manageable(assignment.value);
        }
    }

    /// Adds a copy of a module, with names replaced after the expansion of formulas. Functions and actions can be
    /// renamed too.
    void add_renamed(const Module& written, Module base) {
        std::map<std::string, std::string, std::less<>> names;
        Rewriter rewriter;
        for (const Renaming& renaming : written.renamings) {
            if (!names.emplace(renaming.from.text, renaming.to.text).second)
                diagnostics_.report(rules::bad_renaming, renaming.from.span,
                                    {written.name.text, fmt::format("'{}' is renamed twice", renaming.from.text)});
            rewriter.expressions[renaming.from.text] = make_expr(Op::name, renaming.to.span, {}, renaming.to.text);
            rewriter.functions[renaming.from.text] = renaming.to.text;
        }
        for (const Variable& variable : base.variables)
            if (!names.contains(variable.name.text))
                diagnostics_.report(
                    rules::bad_renaming, written.name.span,
                    {written.name.text, fmt::format("the variable '{}' of its base '{}' has no new name",
                                                    variable.name.text, base.name.text)});
        const auto rename = [&](Name& name) {
            if (const auto found = names.find(name.text); found != names.end()) name.text = found->second;
        };
        std::erase_if(base.variables, [&](const Variable& variable) { return !names.contains(variable.name.text); });
        base.name = written.name;
        base.base = written.base;
        for (Variable& variable : base.variables) {
            rename(variable.name);
            for (ExprPtr* expr : {&variable.low, &variable.high, &variable.initial}) *expr = rewriter(*expr);
        }
        for (Command& command : base.commands) {
            rename(command.action);
            command.guard = rewriter(command.guard);
            for (Branch& branch : command.branches) {
                branch.probability = rewriter(branch.probability);
                for (Assignment& assignment : branch.assignments) {
                    rename(assignment.variable);
                    assignment.value = rewriter(assignment.value);
                }
            }
        }
        model_.modules.push_back(std::move(base));
    }

    void collect_variables() {
        for (const Variable& variable : model_.variables) writer_[variable.name.text] = {};
        for (const Module& module : model_.modules)
            for (const Variable& variable : module.variables) {
                model_.variables.push_back(variable);
                writer_[variable.name.text] = module.name.text;
            }
        const Span place = file_.modules.empty() ? file_.end : file_.modules.front().name.span;
        if (model_.variables.empty()) diagnostics_.report(rules::no_module, place);
    }

    void declare() {
        declare_names(model_, scope_, diagnostics_);
        std::set<std::string> modules;
        for (const Module& module : model_.modules)
            if (!modules.insert(module.name.text).second)
                diagnostics_.report(rules::declared_twice, module.name.span, {module.name.text});
        std::set<std::string> labels;
        for (const Definition& label : model_.labels) {
            if (label.name.text == "deadlock" || label.name.text == "init")
                diagnostics_.report(rules::own_label, label.name.span, {label.name.text});
            if (!labels.insert(label.name.text).second)
                diagnostics_.report(rules::declared_twice, label.name.span, {label.name.text});
        }
        std::set<std::string> rewards;
        for (const RewardStructure& structure : model_.rewards)
            if (!structure.name.text.empty() && !rewards.insert(structure.name.text).second)
                diagnostics_.report(rules::declared_twice, structure.name.span, {structure.name.text});
        std::vector<Defined> constants;
        for (const Constant& constant : model_.constants) constants.push_back({constant.name, constant.value});
        (void)definition_order(constants, diagnostics_);
    }

    void check() {
        TypeChecker types(scope_, diagnostics_);
        for (const Definition& formula : model_.formulas) (void)types.type(formula.body);
        for (const Constant& constant : model_.constants)
            types.expect_type(constant.value, constant.type, true, "a constant");
        for (const Definition& label : model_.labels) types.expect_type(label.body, Type::boolean);
        for (const Variable& variable : model_.variables) check_variable(variable, types);
        if (model_.initial) types.expect_type(model_.initial, Type::boolean);
        for (const RewardStructure& structure : model_.rewards)
            for (const RewardItem& item : structure.items) {
                types.expect_type(item.guard, Type::boolean);
                types.expect_type(item.value, Type::real);
            }
        check_actions();
        // Errors in a base are reported only for the base.
        const std::size_t errors = diagnostics_.error_count();
        for (const bool renamed : {false, true})
            for (const Module& module : model_.modules)
                for (const Command& command : module.commands)
                    if (renamed != module.base.text.empty() && (!renamed || diagnostics_.error_count() == errors))
                        check_command(module, command, types);
    }

    /// Collects the actions of the model: those of its commands, and new names in the composition. A model without
    /// commands gets its transitions from elsewhere (GivenSpace).
    void check_actions() {
        std::set<std::string> actions;
        bool commands = false;
        for (const Module& module : model_.modules)
            for (const Command& command : module.commands) {
                commands = true;
                if (!command.action.text.empty()) actions.insert(command.action.text);
            }
        if (!commands) return;
        if (file_.system) add_new_names(*file_.system, actions);
        const std::vector<std::string> known(actions.begin(), actions.end());
        if (file_.system) check_actions(*file_.system, known);
        for (const RewardStructure& structure : model_.rewards)
            for (const RewardItem& item : structure.items) check_action(item.action, known);
    }

    static void add_new_names(const Composition& system, std::set<std::string>& actions) {
        for (const Renaming& renaming : system.renamings) actions.insert(renaming.to.text);
        for (const CompositionPtr& part : system.parts) add_new_names(*part, actions);
    }

    void check_actions(const Composition& system, const std::vector<std::string>& known) {
        for (const Name& action : system.actions) check_action(action, known);
        for (const Renaming& renaming : system.renamings) check_action(renaming.from, known);
        for (const CompositionPtr& part : system.parts) check_actions(*part, known);
    }

    void check_action(const Name& action, const std::vector<std::string>& known) {
        if (action.text.empty() || std::ranges::binary_search(known, action.text)) return;
        auto& finding = diagnostics_.report(rules::not_declared, action.span, {"action", action.text});
        if (const std::string meant = diagnostics::nearest_spelling(action.text, known); !meant.empty())
            finding.notes.push_back({{}, fmt::format("did you mean '{}'?", meant)});
        else if (known.empty())
            finding.notes.push_back({{}, "no command has an action"});
        else
            finding.notes.push_back(
                {{},
                 fmt::format("commands have the action{} {}", known.size() == 1 ? "" : "s", fmt::join(known, ", "))});
    }

    void check_variable(const Variable& variable, TypeChecker& types) {
        types.expect_type(variable.low, Type::integer, true, "the bound of a range");
        types.expect_type(variable.high, Type::integer, true, "the bound of a range");
        types.expect_type(variable.initial, variable.type, true, "an initial value");
        if (variable.initial && model_.initial)
            diagnostics_.report(rules::two_initials, variable.initial->span, {variable.name.text});
    }

    void check_command(const Module& module, const Command& command, TypeChecker& types) {
        types.expect_type(command.guard, Type::boolean);
        for (const Branch& branch : command.branches) {
            if (branch.probability) types.expect_type(branch.probability, Type::real);
            std::set<std::string_view> written;
            for (const Assignment& assignment : branch.assignments) {
                if (!written.insert(assignment.variable.text).second)
                    diagnostics_.report(rules::assigned_twice, assignment.variable.span, {assignment.variable.text});
                check_assignment(module, command, assignment, types);
            }
        }
    }

    void check_assignment(const Module& module, const Command& command, const Assignment& assignment,
                          TypeChecker& types) {
        const Name& name = assignment.variable;
        const auto writer = writer_.find(name.text);
        if (writer == writer_.end()) {
            diagnostics_.report(rules::not_declared, name.span, {"variable", name.text});
            return;
        }
        if (writer->second && *writer->second != module.name.text)
            diagnostics_.report(rules::foreign_variable, name.span, {module.name.text, name.text, *writer->second});
        if (!writer->second && !command.action.text.empty())
            diagnostics_.report(rules::global_written, name.span, {name.text});
        types.expect_type(assignment.value, scope_.symbols.find(name.text)->second.type);
    }

    const ModelFile& file_;
    diagnostics::Diagnostics& diagnostics_;
    CheckedModel model_;
    Rewriter formulas_;
    Scope scope_;
    /// For each variable, the module that may write it, or no value for a global variable.
    std::map<std::string, std::optional<std::string>, std::less<>> writer_;
};

}  // namespace

std::optional<CheckedModel> check_model(const ModelFile& file, diagnostics::Diagnostics& diagnostics) {
    return ModelChecker(file, diagnostics)();
}

}  // namespace robochart::prism
