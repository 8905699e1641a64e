// SPDX-License-Identifier: Apache-2.0
#include "driver/claims/related_values.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "semantics/ir/arithmetic.hpp"
#include "semantics/ir/numbers.hpp"

namespace robochart::driver {
namespace {

/// The values of related variables in one instance of their machine.
class RelatedState {
public:
    explicit RelatedState(const ir::RelatedVariables& related) : related_(related) {
        for (const ir::RelatedVariable& variable : related.variables) values_[variable.name] = variable.initial;
        known_ = !related.assigned;
    }

    /// Replaces the class in an input that this machine receives.
    void receive(runs::Event& input) {
        if (input.values.size() != 1) return;
        const auto term = related_.term_values.find(input.values[0].text);
        if (term == related_.term_values.end()) return;
        const auto variable = related_.stored_by.find(input.element);
        std::optional<std::int64_t> value;
        if (known_ && variable != related_.stored_by.end()) value = solve(variable->second, term->second);
        known_ = value.has_value();
        if (!known_) return;
        class_ = term->first;
        values_[variable->second] = *value;
        const std::string text = ir::decimal_text(*value, related_.scale);
        if (const auto at = input.text.find(term->first); at != std::string::npos)
            input.text.replace(at, term->first.size(), text);
        input.values[0].text = text;
    }

    [[nodiscard]] bool is_class(const runs::Event& event) const {
        return event.values.size() == 1 && related_.term_values.contains(event.values[0].text);
    }
    void forget() { known_ = false; }

    /// Shows the related variables in place of their holder. In the class model, the holder is the variable that stores
    /// the class of the term. If the values of these variables are not in the holder's class, they are treated as
    /// unknown.
    void show(runs::Machine& machine) {
        const auto holder = std::ranges::find(machine.variables, related_.holder, &runs::Variable::name);
        if (holder == machine.variables.end()) return;
        if (class_.empty()) class_ = holder->value.value_or("");
        known_ = known_ && holder->value.value_or(class_) == class_;
        runs::Variable shown = *holder;
        auto place = machine.variables.erase(holder);
        if (!known_) {
            machine.variables.insert(place, std::move(shown));
        } else {
            for (const ir::RelatedVariable& variable : related_.variables) {
                shown.name = variable.name;
                if (shown.value) shown.value = text_of(variable.name);
                place = std::next(machine.variables.insert(place, shown));
            }
        }
    }

    /// Shows the change of the variable whose value differs from `before`, instead of the change of the class.
    void show(std::vector<runs::Change>& changes, const std::string& component, const RelatedState& before) const {
        std::vector<runs::Change> result;
        for (runs::Change& change : changes) {
            const bool is_class = change.component == component && change.name == related_.holder;
            if (!is_class || !known_) {
                result.push_back(std::move(change));
                continue;
            }
            for (const auto& [name, value] : values_)
                if (before.values_.at(name) != value)
                    result.push_back({component, name, before.text_of(name), text_of(name)});
        }
        changes = std::move(result);
    }

    [[nodiscard]] bool is_unused(const std::string& variable) const {
        return variable != related_.holder && values_.contains(variable);
    }

private:
    [[nodiscard]] std::string text_of(const std::string& variable) const {
        return ir::decimal_text(values_.at(variable), related_.scale);
    }

    /// Solves the equation for the variable `unknown`: returns its value if the term has the value `term`.
    [[nodiscard]] std::optional<std::int64_t> solve(const std::string& unknown, std::int64_t term) const {
        std::int64_t rest = term, factor = 0;
        for (const ir::RelatedVariable& variable : related_.variables) {
            if (variable.name == unknown) {
                factor = variable.coefficient;
                continue;
            }
            const auto product = ir::checked_multiply(variable.coefficient, values_.at(variable.name));
            const auto difference = product ? ir::checked_subtract(rest, *product) : std::nullopt;
            if (!difference) return std::nullopt;
            rest = *difference;
        }
        if (factor == 0 || rest % factor != 0) return std::nullopt;
        const std::int64_t value = rest / factor;
        if (related_.whole && value % related_.scale != 0) return std::nullopt;
        return value;
    }

    const ir::RelatedVariables& related_;
    std::map<std::string, std::int64_t> values_;  ///< in units
    std::string class_;                           ///< the class of the term; "" if not yet known
    bool known_ = true;
};

/// Goes through the run and shows the relations of one instance of a machine.
class RelatedRun {
public:
    RelatedRun(const ir::RelatedVariables& related, std::string component)
        : state_(related), component_(std::move(component)) {}

    void show(runs::Run& run) {
        show(run.initial);
        for (runs::Step& step : run.steps) {
            const RelatedState before = state_;
            receive(step.event);
            for (runs::Event& other : step.with) receive(other);
            show(step.machines);
            drop_unused(step.changes);
            state_.show(step.changes, component_, before);
        }
    }

private:
    void receive(runs::Event& event) {
        const bool sends = event.kind == runs::Kind::output || event.kind == runs::Kind::call;
        if (event.component == component_ && event.kind == runs::Kind::input)
            state_.receive(event);
        else if (!sends && state_.is_class(event))
            state_.forget();
    }
    void show(std::vector<runs::Machine>& machines) {
        for (runs::Machine& machine : machines) {
            if (machine.component != component_) continue;
            std::erase_if(machine.variables,
                          [&](const runs::Variable& variable) { return state_.is_unused(variable.name); });
            state_.show(machine);
        }
    }
    void drop_unused(std::vector<runs::Change>& changes) const {
        std::erase_if(changes, [&](const runs::Change& change) {
            return change.component == component_ && state_.is_unused(change.name);
        });
    }

    RelatedState state_;
    std::string component_;
};

}  // namespace

void show_related_values(runs::Run& run, const std::vector<ir::RelatedVariables>& related) {
    for (const ir::RelatedVariables& variables : related) {
        std::vector<std::string> components;
        for (const runs::Machine& machine : run.initial)
            if (machine.machine == variables.machine) components.push_back(machine.component);
        for (const std::string& component : components) RelatedRun(variables, component).show(run);
    }
}

}  // namespace robochart::driver
