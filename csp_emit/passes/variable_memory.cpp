// SPDX-License-Identifier: Apache-2.0
// See variable_memory.hpp. A function holds a remembered variable if its body does more with the variable than pass it
// on unchanged. Variables that a called function holds and the caller does not are read immediately before the call.
#include "csp_emit/passes/variable_memory.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "checker/cspm/syntax/build.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::Expr;
using cspm::ExprKind;
using cspm::ExprPtr;

namespace {

const char* const end_event = "end__";
const char* const value_name = "x__";

bool passes_on(const Expr& argument, const std::string& parameter) {
    return argument.kind == ExprKind::name && argument.text == parameter;
}

std::set<std::string> parameters_of(const std::vector<Remembered>& variables) {
    std::set<std::string> result;
    for (const Remembered& variable : variables) result.insert(variable.parameter);
    return result;
}

/// Replaces parameters of functions by reads and writes of memories.
class Memories {
public:
    Memories(const std::vector<Function>& functions, const FamilyCalls& calls,
             const std::vector<Remembered>& variables);
    /// The context of a call: the variables that the caller holds. At the start, each memory has its initial value.
    struct Place {
        std::set<std::string> held;
        bool start = false;
    };
    ExprPtr rewrite(const ExprPtr& expr, const Place& place) const;
    const std::set<std::string>& held_by(std::size_t function) const { return held_[function]; }
    bool is_remembered(const std::string& parameter) const { return variables_.count(parameter) != 0; }

private:
    ExprPtr rewritten_call(const Expr& expr, std::size_t target, const Place& place) const;

    /// A parameter of a function: the remembered variable that it contains, if any, and whether the function holds this
    /// variable.
    struct Parameter {
        const Remembered* variable = nullptr;
        bool held = false;
    };

    const std::vector<Function>& functions_;
    const FamilyCalls& calls_;
    std::map<std::string, const Remembered*> variables_;
    FamilyIndex index_;
    std::vector<std::set<std::string>> held_;
    std::vector<std::vector<Parameter>> parameters_;  ///< the parameters of each function
};

Memories::Memories(const std::vector<Function>& functions, const FamilyCalls& calls,
                   const std::vector<Remembered>& variables)
    : functions_(functions), calls_(calls), index_(index_of(functions)) {
    for (const Remembered& variable : variables) variables_[variable.parameter] = &variable;
    held_ = Evaluations(functions, parameters_of(variables)).held_variables(variables);
    for (std::size_t i = 0; i < functions.size(); ++i) {
        std::vector<Parameter>& parameters = parameters_.emplace_back();
        for (const std::string& name : functions[i].parameters) {
            const auto found = variables_.find(name);
            parameters.push_back({found == variables_.end() ? nullptr : found->second, held_[i].count(name) != 0});
        }
    }
}

ExprPtr Memories::rewrite(const ExprPtr& expr, const Place& place) const {
    if (!expr) return expr;
    if (const std::size_t* target = called_function(index_, *expr)) return rewritten_call(*expr, *target, place);
    if (expr->kind == ExprKind::name && expr->text == "SKIP") return b::prefix(b::name(end_event), expr);
    return with_parts(expr, [&](const ExprPtr& part) { return rewrite(part, place); });
}

/// Returns the writes, followed by the reads, followed by the call.
ExprPtr Memories::rewritten_call(const Expr& expr, std::size_t target, const Place& place) const {
    b::Exprs arguments;
    std::vector<const Remembered*> reads;
    std::vector<std::pair<const Remembered*, ExprPtr>> writes;
    for (std::size_t i = 1; i < expr.args.size(); ++i) {
        const auto [variable, held] = parameters_[target][i - 1];
        if (variable == nullptr) {
            arguments.push_back(expr.args[i]);
            continue;
        }
        if (calls_.is_unneeded(expr.args[i])) {
            if (held) arguments.push_back(expr.args[i]);
            continue;
        }
        const bool same = passes_on(*expr.args[i], variable->parameter);
        const bool there =
            same || !variable->shared.empty() || (place.start && cspm::equal(expr.args[i], variable->initial));
        if (!there) writes.emplace_back(variable, expr.args[i]);
        if (!held) continue;
        if (same && place.held.count(variable->parameter) == 0) reads.push_back(variable);
        arguments.push_back(expr.args[i]);
    }
    ExprPtr result = b::call(functions_[target].name, arguments);
    for (auto read = reads.rbegin(); read != reads.rend(); ++read)
        result = b::prefix(b::name("get_" + (*read)->channel), {b::input((*read)->parameter)}, result);
    for (auto write = writes.rbegin(); write != writes.rend(); ++write)
        result = b::prefix(b::name("setL_" + write->first->channel), {b::output(write->second)}, result);
    return result;
}

b::Exprs own_events(const Remembered& variable) {
    b::Exprs result{b::name("get_" + variable.channel)};
    if (variable.shared.empty()) result.push_back(b::name("setL_" + variable.channel));
    return result;
}

b::Exprs shared_events(const Remembered& variable) {
    if (variable.shared.empty()) return {};
    return {b::name("set_" + variable.shared), b::name("set_EXT_" + variable.shared)};
}

}  // namespace

Evaluations::Evaluations(const std::vector<Function>& functions, const std::set<std::string>& parameters)
    : functions_(functions), parameters_(parameters), index_(index_of(functions)), uses_(functions.size()) {
    for (const Function& function : functions) {
        std::vector<bool>& selected = selected_.emplace_back();
        for (const std::string& parameter : function.parameters) selected.push_back(parameters.count(parameter) != 0);
    }
    for (std::size_t i = 0; i < functions.size(); ++i) survey_expression(*functions[i].body, uses_[i]);
}

void Evaluations::collect_mentions(const Expr& expr, std::set<std::string>& found) const {
    if (expr.kind == ExprKind::name && parameters_.count(expr.text) != 0) found.insert(expr.text);
    for_each_part(expr, [&](const Expr& part) { collect_mentions(part, found); });
}

void Evaluations::survey_expression(const Expr& expr, Use& use) const {
    if (const std::size_t* target = called_function(index_, expr)) return survey_call(expr, *target, use);
    if (expr.kind == ExprKind::name && parameters_.count(expr.text) != 0) use.names.insert(expr.text);
    for_each_part(expr, [&](const Expr& part) { survey_expression(part, use); });
}

void Evaluations::survey_call(const Expr& expr, std::size_t target, Use& use) const {
    for (std::size_t i = 1; i < expr.args.size(); ++i) {
        const std::string& parameter = functions_[target].parameters[i - 1];
        if (selected_[target][i - 1] && passes_on(*expr.args[i], parameter)) continue;
        Changed changed{target, parameter, {}};
        collect_mentions(*expr.args[i], changed.names);
        if (!changed.names.empty()) use.changed.push_back(std::move(changed));
    }
}

std::vector<std::set<std::string>> Evaluations::held_variables(const std::vector<Remembered>& variables) const {
    const std::set<std::string> remembered = parameters_of(variables);
    std::set<std::string> shared;
    for (const Remembered& variable : variables)
        if (!variable.shared.empty()) shared.insert(variable.parameter);
    std::vector<std::set<std::string>> result(uses_.size());
    const auto add = [&](std::size_t function, const std::set<std::string>& names) {
        bool grown = false;
        for (const std::string& name : names)
            if (remembered.count(name) != 0) grown = result[function].insert(name).second || grown;
        return grown;
    };
    for (bool grown = true; grown;) {
        grown = false;
        for (std::size_t i = 0; i < uses_.size(); ++i) {
            grown = add(i, uses_[i].names) || grown;
            for (const Changed& changed : uses_[i].changed)
                if (shared.count(changed.parameter) == 0 || result[changed.target].count(changed.parameter) != 0)
                    grown = add(i, changed.names) || grown;
        }
    }
    return result;
}

void move_to_memories(std::vector<Function>& functions, ExprPtr& initial, const FamilyCalls& calls,
                      const std::vector<Remembered>& variables) {
    if (variables.empty()) return;
    const Memories memories(functions, calls, variables);
    std::vector<ExprPtr> bodies;
    for (std::size_t i = 0; i < functions.size(); ++i)
        bodies.push_back(memories.rewrite(functions[i].body, {memories.held_by(i)}));
    initial = memories.rewrite(initial, {{}, true});
    for (std::size_t i = 0; i < functions.size(); ++i) {
        functions[i].body = bodies[i];
        std::erase_if(functions[i].parameters, [&](const std::string& parameter) {
            return memories.is_remembered(parameter) && memories.held_by(i).count(parameter) == 0;
        });
    }
}

std::vector<cspm::DeclPtr> memory_definitions(const std::vector<Remembered>& variables, bool timed) {
    std::vector<cspm::DeclPtr> result;
    for (const Remembered& variable : variables) {
        const ExprPtr same = b::call(variable.memory, {b::name(value_name)});
        const ExprPtr changed = b::call(variable.memory, {b::name("in__")});
        b::Exprs branches{b::prefix(b::name("get_" + variable.channel), {b::output(b::name(value_name))}, same)};
        b::Exprs writes = shared_events(variable);
        if (writes.empty()) writes.push_back(b::name("setL_" + variable.channel));
        for (const ExprPtr& write : writes) branches.push_back(b::prefix(write, {b::input("in__")}, changed));
        if (timed) branches.push_back(b::prefix(b::name("tock"), same));
        branches.push_back(b::prefix(b::name(end_event), b::skip()));
        result.push_back(b::function_decl(variable.memory, b::variables({value_name}), b::choice(branches),
                                          "the memory of " + variable.channel));
    }
    return result;
}

std::vector<cspm::DeclPtr> memory_channels(const std::vector<Remembered>& variables) {
    std::vector<cspm::DeclPtr> result;
    for (const Remembered& variable : variables) {
        std::vector<std::string> names;
        for (const ExprPtr& event : own_events(variable)) names.push_back(event->text);
        result.push_back(b::channel(names, variable.type));
    }
    if (!variables.empty()) result.push_back(b::channel({end_event}));
    return result;
}

ExprPtr with_memories(const ExprPtr& machine, const std::vector<Remembered>& variables, bool timed) {
    if (variables.empty()) return machine;
    b::Exprs together{b::name(end_event)};
    if (timed) together.push_back(b::name("tock"));
    b::Exprs hidden{b::name(end_event)};
    b::Exprs common = together;
    ExprPtr memories;
    for (const Remembered& variable : variables) {
        const ExprPtr memory = b::call(variable.memory, {variable.initial});
        memories = memories ? b::parallel(memories, b::productions(together), memory) : memory;
        for (const ExprPtr& event : own_events(variable)) {
            hidden.push_back(event);
            common.push_back(event);
        }
        for (const ExprPtr& event : shared_events(variable)) common.push_back(event);
    }
    return b::hide(b::parallel(machine, b::productions(common), memories), b::productions(hidden));
}

}  // namespace robochart::csp_emit
