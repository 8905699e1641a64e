// SPDX-License-Identifier: Apache-2.0
// See robotool_encoding.hpp.
#include "prism/assertions/robotool/robotool_encoding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "prism/assertions/properties/names.hpp"
#include "prism/assertions/robotool/wording.hpp"
#include "prism/checks/check.hpp"
#include "prism/session/experiment.hpp"
#include "prism/syntax/printer.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::probability {
namespace {

using prism::ExprPtr;

std::set<std::string> names_of(const prism::ModelFile& model) {
    std::set<std::string> result;
    for (const prism::Constant& constant : model.constants) result.insert(constant.name.text);
    for (const prism::Variable& variable : model.globals) result.insert(variable.name.text);
    for (const prism::Module& module : model.modules)
        for (const prism::Variable& variable : module.variables) result.insert(variable.name.text);
    return result;
}

}  // namespace

/// Finds elements by the names recorded in the emission (R1).
class RoboToolEncoding::Names final : public Elements {
public:
    Names(const prism_emit::Emission& emission, const ir::Module& module)
        : taken_(names_of(emission.model)), module_(module.name), platform_(module.platform.name) {
        for (const prism_emit::NameOf& renaming : emission.names)
            names_[{renaming.kind, renaming.element}] = renaming.name;
    }

    ExprPtr variable_expression(const std::string& path) override {
        // A variable that a machine requires has the name of the platform's variable (R3).
        const std::string shared = module_ + "::" + platform_ + "::" + last_part(path);
        for (const std::string& element : {path, shared})
            if (const std::string* name = find("variable", element)) return name_expression(*name);
        throw_absent("variable", path);
    }

    ExprPtr constant_expression(const std::string& path) override { return name_expression(constant_name(path)); }

    const std::string& constant_name(const std::string& path) const {
        for (const std::string& element : {path, module_ + "::" + last_part(path)})
            if (const std::string* name = find("constant", element)) return *name;
        throw_absent("constant", path);
    }

    /// Compares the counter of the state's region with the state (R3, R4). The counter of an inactive region is at no
    /// state.
    ExprPtr in_state(const std::string& machine, const std::string& state) override {
        const std::size_t inner = state.rfind("::");
        const std::string region = inner == std::string::npos ? machine : machine + "::" + state.substr(0, inner);
        const std::string* const counter = find("variable", region + "::scpc_8");
        const std::string* const place = find("node", machine + "::" + state);
        if (counter == nullptr || place == nullptr) throw_absent("state", machine + "::" + state);
        return prism::make_expr(prism::Op::equal, {}, {name_expression(*counter), name_expression(*place)});
    }

    std::string event_action(const std::string& path, const std::string& direction) override {
        if (const std::string* name = find("event", path + (direction == "in" ? "::IN" : "::OUT"))) return *name;
        throw_absent("event", path + "." + direction);
    }

    /// Returns the variable with the event's value, which is named after the label (R13).
    ExprPtr event_value(const std::string& path, const std::string& direction) override {
        const std::string name = "EVT__" + event_action(path, direction);
        if (!taken_.contains(name)) throw_absent("value", path + "." + direction);
        return name_expression(name);
    }

    [[nodiscard]] bool is_name_taken(const std::string& name) const override { return taken_.contains(name); }

private:
    [[nodiscard]] static std::string last_part(const std::string& path) { return path.substr(path.rfind(':') + 1); }
    [[nodiscard]] const std::string* find(const std::string& kind, const std::string& element) const {
        const auto found = names_.find({kind, element});
        return found == names_.end() ? nullptr : &found->second;
    }
    [[noreturn]] static void throw_absent(const std::string& what, const std::string& path) {
        throw NotExpressed(fmt::format("RoboTool's encoding has no {} `{}`", what, path));
    }

    std::map<std::pair<std::string, std::string>, std::string> names_;
    std::set<std::string> taken_;
    std::string module_, platform_;
};

/// The model, extended as a question needs it, for some values of its constants. `space` (the explored states) and
/// `instance` (for random paths) are made on request.
struct RoboToolEncoding::Prepared {
    std::string text;
    std::optional<prism::CheckedModel> model;
    prism::Values values;
    diagnostics::Diagnostics findings;
    std::unique_ptr<prism::StateSpace> space;
    std::unique_ptr<prism::Instance> instance;
};

namespace {

prism_emit::Emission emit_model(const ir::System& system, const ir::Module& module,
                                const prism_emit::Preferences& preferences, diagnostics::Budget* budget,
                                const std::map<std::string, Function>& functions) {
    diagnostics::Diagnostics findings;
    if (budget != nullptr) findings.set_budget(budget);
    auto result = prism_emit::emit(system, module, preferences, findings, functions);
    if (!result) throw NotExpressed("RoboTool's encoding: " + findings.first_error());
    return std::move(*result);
}

}  // namespace

RoboToolEncoding::RoboToolEncoding(const ir::System& system, const ir::Module& module, RoboToolOptions options,
                                   const std::map<std::string, Function>& functions)
    : system_(system),
      module_(module),
      options_(std::move(options)),
      functions_(functions),
      emission_(emit_model(system, module, options_.preferences, options_.budget, functions)),
      emitted_for_(options_.preferences),
      names_(std::make_unique<Names>(emission_, module)),
      wording_(wording_of(emission_)) {}

RoboToolEncoding::~RoboToolEncoding() = default;

Elements& RoboToolEncoding::elements() {
    return *names_;
}

prism::Constant RoboToolEncoding::prism_constant(const std::string& path) {
    const std::string& name = names_->constant_name(path);
    const auto& all = emission_.model.constants;
    prism::Constant found =
        *std::ranges::find_if(all, [&](const prism::Constant& constant) { return constant.name.text == name; });
    found.value = nullptr;
    return found;
}

namespace {

/// Returns the values of a setting, rounded down. Invalid values are reported later, when they are used.
std::vector<std::int64_t> whole_values(prism::Constant constant, const std::vector<std::string>& texts) {
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max() - 1;
    constant.name.text = "c";
    std::vector<std::int64_t> result;
    for (const std::string& text : texts) {
        std::vector<prism::Series> series;
        try {
            series = prism::read_series("c=" + text, {constant});
        } catch (const prism::BadValue&) {
            continue;
        }
        for (const prism::Series& part : series)
            for (const prism::Value& value : part.values)
                if (const auto whole = prism::floor_of(value.number()); whole && abs(*whole) <= most)
                    result.push_back(whole->convert_to<std::int64_t>());
    }
    return result;
}

void widen_range(prism_emit::Range& range, std::int64_t value) {
    if (range.asked) return;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value + 1);
}

}  // namespace

prism_emit::Preferences RoboToolEncoding::ranges_for(const Question& question) {
    prism_emit::Preferences result = options_.preferences;
    for (const Setting& setting : question.settings) {
        if (setting.path.empty()) continue;
        const prism::Constant set = prism_constant(setting.path);
        if (set.type == prism::Type::boolean) continue;
        for (const std::int64_t value : whole_values(set, setting.values)) {
            widen_range(set.type == prism::Type::real ? result.real : result.integer, value);
            if (set.type == prism::Type::integer && value >= 0) widen_range(result.nat, value);
        }
    }
    return result;
}

/// Returns the model for a question. If the question gives values to a constant, the constant's value in the model is
/// removed.
prism::ModelFile RoboToolEncoding::model_for(const Question& question) {
    if (const prism_emit::Preferences preferences = ranges_for(question); preferences != emitted_for_) {
        emission_ = emit_model(system_, module_, preferences, options_.budget, functions_);
        emitted_for_ = preferences;
    }
    prism::ModelFile result = emission_.model;
    for (const Setting& setting : question.settings) {
        if (setting.path.empty()) continue;
        const std::string& name = names_->constant_name(setting.path);
        for (prism::Constant& constant : result.constants)
            if (constant.name.text == name) constant.value = nullptr;
    }
    result.constants.insert(result.constants.end(), question.model_constants.begin(), question.model_constants.end());
    result.rewards = question.rewards;
    result.modules.insert(result.modules.end(), question.modules.begin(), question.modules.end());
    return result;
}

/// Adds the user's values for constants that are still open.
prism::Values RoboToolEncoding::all_values(const prism::ModelFile& model, const prism::Values& given) const {
    prism::Values result = given;
    for (const prism::Constant& constant : prism::open_constants(model.constants)) {
        const std::string& name = constant.name.text;
        if (result.contains(name)) continue;
        std::string element = name;
        for (const prism_emit::NameOf& renaming : emission_.names)
            if (renaming.kind == "constant" && renaming.name == name) element = renaming.element;
        const auto meant = std::ranges::find_if(
            options_.constants, [&](const auto& option) { return ir::is_named_by(element, option.first); });
        if (meant == options_.constants.end())
            throw Wrong(
                fmt::format("the constant {} has no value: give it one `with constants` or by --const", element));
        try {
            result[name] = prism::read_series(name + "=" + meant->second, {constant}).front().values.front();
        } catch (const prism::BadValue& error) {
            throw Wrong(fmt::format("--const {}={}: {}", meant->first, meant->second, error.what()));
        }
    }
    return result;
}

RoboToolEncoding::Prepared& RoboToolEncoding::prepare_model(const Question& question, const prism::Values& constants) {
    const prism::ModelFile whole = model_for(question);
    prism::Values values = all_values(whole, constants);
    std::string text = prism::print(whole);
    for (const auto& [name, value] : values) text += fmt::format("{}={}\n", name, value.text());
    if (prepared_ && prepared_->text == text) return *prepared_;
    prepared_.reset();  // frees memory for the next model
    auto made = std::make_unique<Prepared>();
    made->text = std::move(text);
    made->values = std::move(values);
    made->model = prism::check_model(whole, made->findings);
    if (!made->model) throw Wrong(made->findings.first_error());
    prepared_ = std::move(made);
    return *prepared_;
}

const prism::StateSpace& RoboToolEncoding::explore_space(const Question& question, const prism::Values& constants) {
    Prepared& found = prepare_model(question, constants);
    if (!found.space)
        found.space = std::make_unique<prism::StateSpace>(
            *found.model, found.values, prism::ExploreOptions{options_.max_states, options_.exact, options_.budget},
            found.findings);
    return *found.space;
}

Unexplored RoboToolEncoding::unexplored_model(const Question& question, const prism::Values& constants) {
    if (emission_.model.kind != prism::ModelKind::dtmc)
        throw NotExpressed("random paths of an mdp, which the preferences ask for, depend on who chooses");
    Prepared& found = prepare_model(question, constants);
    if (!found.instance) found.instance = std::make_unique<prism::Instance>(*found.model, found.values);
    return {*found.instance, wording_};
}

}  // namespace robochart::probability
