// SPDX-License-Identifier: Apache-2.0
// Computes live parameters. A parameter is live if its name occurs in the body outside calls within the family, or in
// an argument for a live parameter. A parameter that a call does not mention keeps its value. A backward analysis along
// the calls finds the least such set. A shared function has the parameters that any of its calls need. A call passes on
// only the parameters that the function itself reads or that are read after this call. The values of other parameters
// are arbitrary.
#include "csp_emit/passes/liveness.hpp"

#include <optional>
#include <set>

#include "checker/cspm/syntax/build.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::Expr;
using cspm::ExprPtr;

namespace {

using Names = std::vector<std::size_t>;

class Family {
public:
    Family(const std::vector<Function>& functions, const ExprPtr& initial, const FamilyCalls& sparse,
           const Candidates& candidates);

    std::vector<std::string> live_parameters(std::size_t function) const;
    ExprPtr make_dense(const ExprPtr& expr) const;

private:
    struct Call {
        std::size_t caller, target;
        std::map<std::size_t, Names> given;
        bool after_tock;
        std::vector<std::size_t> behind;  ///< functions that continue after the calls made here, the innermost first
    };
    /// Parameters by function.
    using Live = std::vector<std::set<std::size_t>>;

    void survey_expression(std::size_t caller, const Expr& expr);
    void survey_call(std::size_t caller, const Expr& expr, const SparseCall& sparse);
    std::vector<std::size_t> continuations_after(const Expr& value) const;
    void names_in(const Expr& expr, std::set<std::size_t>& result) const;
    Names names_in(const Expr& expr) const;
    const Expr* ticking_value(std::size_t parameter) const;
    const Names& passed_names(const Call& call, std::size_t parameter, Names& storage) const;
    void mark_live(Live& live, std::size_t function, const Names& names);
    void spread_liveness();
    void spread_liveness(const Call& call, std::size_t parameter);
    bool is_needed(const Call& call, std::size_t parameter) const;
    ExprPtr dense_call(const SparseCall& sparse, const Call& call) const;
    ExprPtr argument_of(const SparseCall& sparse, const Call& call, std::size_t parameter) const;

    const FamilyCalls& sparse_;
    const Candidates& candidates_;
    std::vector<ExprPtr> read_;  ///< a tree for each candidate's name, shared because most arguments of most calls are
                                 ///< such names
    FamilyIndex index_;
    std::unordered_map<std::string, std::size_t> number_;  ///< index of each candidate; never iterated
    std::vector<Names> used_;                              ///< by function, then the initial process
    std::vector<Call> calls_;
    std::map<const Expr*, std::size_t> call_of_;
    std::vector<std::vector<std::size_t>> calls_to_;    ///< by function: the calls of it
    std::vector<std::vector<std::size_t>> calls_over_;  ///< by function: the calls after which it continues
    std::set<std::size_t> returning_;                   ///< functions that continue after calls
    Live live_, within_;                                ///< live; live before the current operation returns
    std::vector<std::pair<std::size_t, std::size_t>> work_;
};

Family::Family(const std::vector<Function>& functions, const ExprPtr& initial, const FamilyCalls& sparse,
               const Candidates& candidates)
    : sparse_(sparse),
      candidates_(candidates),
      index_(index_of(functions)),
      used_(functions.size() + 1),
      calls_to_(functions.size()),
      calls_over_(functions.size()) {
    for (const std::string& name : candidates.names) {
        number_.emplace(name, number_.size());
        read_.push_back(b::name(name));
    }
    for (const std::string& name : candidates.fixed)
        for (std::size_t i = 0; i < functions.size(); ++i) used_[i].push_back(number_.at(name));
    for (std::size_t i = 0; i < candidates.read.size(); ++i)
        for (const std::string& name : candidates.read[i]) used_[i].push_back(number_.at(name));
    for (const auto& [value, entry] : candidates.entries) returning_.insert(index_.at(entry.behind));
    for (std::size_t i = 0; i < functions.size(); ++i) survey_expression(i, *functions[i].body);
    survey_expression(functions.size(), *initial);
    live_.resize(used_.size());
    within_.resize(used_.size());
    spread_liveness();
}

void Family::names_in(const Expr& expr, std::set<std::size_t>& result) const {
    if (expr.kind == cspm::ExprKind::name)
        if (const auto found = number_.find(expr.text); found != number_.end()) result.insert(found->second);
    for_each_part(expr, [&](const Expr& part) { names_in(part, result); });
}

Names Family::names_in(const Expr& expr) const {
    std::set<std::size_t> result;
    names_in(expr, result);
    return {result.begin(), result.end()};
}

void Family::survey_expression(std::size_t caller, const Expr& expr) {
    if (const SparseCall* call = sparse_.find_call(expr)) return survey_call(caller, expr, *call);
    if (expr.kind == cspm::ExprKind::name)
        if (const auto found = number_.find(expr.text); found != number_.end()) used_[caller].push_back(found->second);
    for_each_part(expr, [&](const Expr& part) { survey_expression(caller, part); });
}

/// Returns, for a value of the stack, the functions that continue at the return addresses in the value.
std::vector<std::size_t> Family::continuations_after(const Expr& value) const {
    std::vector<std::size_t> result;
    for (auto found = candidates_.entries.find(&value); found != candidates_.entries.end();
         found = candidates_.entries.find(found->second.outer.get()))
        result.push_back(index_.at(found->second.behind));
    return result;
}

void Family::survey_call(std::size_t caller, const Expr& expr, const SparseCall& sparse) {
    if (call_of_.count(&expr) != 0) return;  // visited already: a tree may occur in several places of a body
    Call call{caller, index_.at(sparse.function), {}, sparse.after_tock, {}};
    for (const auto& [name, value] : sparse.changed) {
        const auto found = number_.find(name);
        if (found == number_.end()) continue;
        call.given[found->second] = names_in(*value);
        if (found->first == candidates_.returns) call.behind = continuations_after(*value);
    }
    call_of_[&expr] = calls_.size();
    calls_to_[call.target].push_back(calls_.size());
    for (const std::size_t function : call.behind) calls_over_[function].push_back(calls_.size());
    calls_.push_back(std::move(call));
}

const Expr* Family::ticking_value(std::size_t parameter) const {
    const auto found = candidates_.ticking.find(candidates_.names[parameter]);
    return found == candidates_.ticking.end() ? nullptr : found->second.get();
}

/// Returns the parameters that the caller must have in order to pass this parameter.
const Names& Family::passed_names(const Call& call, std::size_t parameter, Names& storage) const {
    if (const auto found = call.given.find(parameter); found != call.given.end()) return found->second;
    const Expr* counting = call.after_tock ? ticking_value(parameter) : nullptr;
    storage = counting != nullptr ? names_in(*counting) : Names{parameter};
    return storage;
}

void Family::mark_live(Live& live, std::size_t function, const Names& names) {
    for (const std::size_t name : names)
        if (live[function].insert(name).second) work_.emplace_back(function, name);
}

void Family::spread_liveness() {
    for (std::size_t i = 0; i < used_.size(); ++i) {
        mark_live(within_, i, used_[i]);
        mark_live(live_, i, used_[i]);
    }
    while (!work_.empty()) {
        const auto [function, parameter] = work_.back();
        work_.pop_back();
        if (function == calls_to_.size()) continue;  // no function calls the initial process
        for (const std::size_t call : calls_to_[function]) spread_liveness(calls_[call], parameter);
        for (const std::size_t call : calls_over_[function]) spread_liveness(calls_[call], parameter);
    }
}

/// Propagates liveness from a called function to its caller. The caller needs the parameters that are live in the
/// called function. It also needs the parameters that are live after the call and that the called function does not
/// overwrite.
void Family::spread_liveness(const Call& call, std::size_t parameter) {
    if (live_[call.target].count(parameter) == 0) return;
    const bool returns = returning_.count(call.target) != 0;
    bool within = !returns && within_[call.target].count(parameter) != 0;
    for (const std::size_t function : call.behind) within = within || within_[function].count(parameter) != 0;
    if (!within && !is_needed(call, parameter)) return;
    Names storage;
    const Names& names = passed_names(call, parameter, storage);
    mark_live(live_, call.caller, names);
    // The caller evaluates an expression for a changed parameter before the operation returns, even if the parameter is
    // read only later.
    const bool given = call.given.count(parameter) != 0;
    if (within || given) mark_live(within_, call.caller, names);
}

/// True if the parameter is read in the called function, or after this call.
bool Family::is_needed(const Call& call, std::size_t parameter) const {
    if (call.behind.empty() || within_[call.target].count(parameter) != 0) return true;
    for (const std::size_t function : call.behind) {
        const bool outermost = function == call.behind.back();
        if ((outermost ? live_ : within_)[function].count(parameter) != 0) return true;
    }
    return false;
}

std::vector<std::string> Family::live_parameters(std::size_t function) const {
    std::vector<std::string> result;
    for (const std::size_t parameter : live_[function]) result.push_back(candidates_.names[parameter]);
    return result;
}

ExprPtr Family::argument_of(const SparseCall& sparse, const Call& call, std::size_t parameter) const {
    const std::string& name = candidates_.names[parameter];
    if (name != candidates_.returns && !is_needed(call, parameter)) return sparse_.unneeded_argument();
    for (const auto& [given, value] : sparse.changed)
        if (given == name) return value;
    if (call.after_tock && ticking_value(parameter) != nullptr) return candidates_.ticking.at(name);
    return read_[parameter];
}

ExprPtr Family::dense_call(const SparseCall& sparse, const Call& call) const {
    b::Exprs arguments;
    for (const std::size_t parameter : live_[call.target]) arguments.push_back(argument_of(sparse, call, parameter));
    return b::call(sparse.function, arguments);
}

ExprPtr Family::make_dense(const ExprPtr& expr) const {
    if (!expr) return expr;
    if (const SparseCall* call = sparse_.find_call(*expr)) return dense_call(*call, calls_[call_of_.at(expr.get())]);
    return with_parts(expr, [&](const ExprPtr& part) { return make_dense(part); });
}

}  // namespace

FamilyIndex index_of(const std::vector<Function>& functions) {
    FamilyIndex result;
    for (std::size_t i = 0; i < functions.size(); ++i) result[functions[i].name] = i;
    return result;
}

const std::size_t* called_function(const FamilyIndex& index, const Expr& expr) {
    const bool applied = expr.kind == cspm::ExprKind::apply && expr.args[0]->kind == cspm::ExprKind::name;
    if (!applied && expr.kind != cspm::ExprKind::name) return nullptr;
    const auto found = index.find(applied ? expr.args[0]->text : expr.text);
    return found == index.end() ? nullptr : &found->second;
}

ExprPtr FamilyCalls::add_call(std::string function, Arguments changed, bool after_tock) {
    ExprPtr node = b::name(function);
    calls_[node.get()] = {node, {std::move(function), std::move(changed), after_tock}};
    return node;
}

const SparseCall* FamilyCalls::find_call(const Expr& expr) const {
    const auto found = calls_.find(&expr);
    return found == calls_.end() ? nullptr : &found->second.call;
}

const std::string* FamilyCalls::only_calls(const Expr& expr) const {
    const SparseCall* call = find_call(expr);
    if (call == nullptr || call->after_tock) return nullptr;
    for (const auto& [parameter, value] : call->changed)
        if (value->kind != cspm::ExprKind::name || value->text != parameter) return nullptr;
    return &call->function;
}

void FamilyCalls::redirect_call(const Expr& call, const std::string& function) {
    calls_.at(&call).call.function = function;
}

std::vector<std::string> find_parameters(std::vector<Function>& functions, ExprPtr& initial, const FamilyCalls& calls,
                                         const Candidates& candidates) {
    const Family family(functions, initial, calls, candidates);
    initial = family.make_dense(initial);
    for (std::size_t i = 0; i < functions.size(); ++i) {
        functions[i].body = family.make_dense(functions[i].body);
        functions[i].parameters = family.live_parameters(i);
    }
    return family.live_parameters(functions.size());
}

namespace {

ExprPtr fill_arguments(const ExprPtr& expr, const std::vector<Function>& functions, const FamilyIndex& index,
                       const FamilyCalls& calls, const std::map<std::string, ExprPtr>& values) {
    if (!expr) return expr;
    const std::size_t* target = called_function(index, *expr);
    std::size_t place = 0;
    return with_parts(expr, [&](const ExprPtr& part) {
        const std::size_t i = place++;
        return target != nullptr && i > 0 && calls.is_unneeded(part)
                   ? values.at(functions[*target].parameters.at(i - 1))
                   : fill_arguments(part, functions, index, calls, values);
    });
}

}  // namespace

void fill_unneeded(std::vector<Function>& functions, const FamilyCalls& calls,
                   const std::map<std::string, ExprPtr>& values) {
    const FamilyIndex index = index_of(functions);
    for (Function& function : functions) function.body = fill_arguments(function.body, functions, index, calls, values);
}

}  // namespace robochart::csp_emit
