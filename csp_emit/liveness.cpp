// A parameter is live if its name occurs in the body outside the arguments of calls within the family, or in an
// argument for a live parameter. The least such set is found by going backwards along the calls.
#include "csp_emit/liveness.hpp"

#include <map>
#include <set>

namespace robochart::csp_emit {

using cspm::Expr;
using cspm::ExprKind;
using cspm::ExprPtr;

namespace {

class Family {
public:
    explicit Family(const std::vector<Function>& functions)
        : functions_(functions), index_(index_of(functions)), uses_(functions.size()) {
        for (const Function& function : functions) live_.emplace_back(function.parameters.size(), false);
        for (std::size_t i = 0; i < functions.size(); ++i) survey(i, *functions[i].body);
        spread();
    }

    std::vector<std::vector<bool>> live() const { return live_; }
    ExprPtr without_dead(const ExprPtr& expr) const;

private:
    void survey(std::size_t caller, const Expr& expr);
    void names(const Expr& expr, std::set<std::string>& result) const;
    void mark(std::size_t function, const std::set<std::string>& names);
    void spread();

    /// Callers that pass something for a parameter, and the names in what they pass.
    struct Use {
        std::size_t caller;
        std::set<std::string> names;
    };

    const std::vector<Function>& functions_;
    FamilyIndex index_;
    std::vector<std::map<std::size_t, std::vector<Use>>> uses_;
    std::vector<std::vector<bool>> live_;
    std::vector<std::pair<std::size_t, std::size_t>> work_;
};

void Family::names(const Expr& expr, std::set<std::string>& result) const {
    if (expr.kind == ExprKind::name) result.insert(expr.text);
    for_each_part(expr, [&](const Expr& part) { names(part, result); });
}

void Family::survey(std::size_t caller, const Expr& expr) {
    if (expr.kind == ExprKind::name) mark(caller, {expr.text});
    const std::size_t* target = called(index_, expr);
    if (target == nullptr) {
        for_each_part(expr, [&](const Expr& part) { survey(caller, part); });
        return;
    }
    for (std::size_t i = 1; i < expr.args.size(); ++i) {
        Use use{caller, {}};
        names(*expr.args[i], use.names);
        uses_[*target][i - 1].push_back(std::move(use));
    }
}

void Family::mark(std::size_t function, const std::set<std::string>& names) {
    const auto& parameters = functions_[function].parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (live_[function][i] || names.count(parameters[i]) == 0) continue;
        live_[function][i] = true;
        work_.emplace_back(function, i);
    }
}

void Family::spread() {
    while (!work_.empty()) {
        const auto [function, parameter] = work_.back();
        work_.pop_back();
        for (const Use& use : uses_[function][parameter]) mark(use.caller, use.names);
    }
}

ExprPtr Family::without_dead(const ExprPtr& expr) const {
    if (!expr) return expr;
    auto result = std::make_shared<Expr>(*expr);
    if (const std::size_t* target = called(index_, *expr)) {
        if (expr->kind == ExprKind::name) return expr;
        result->args.resize(1);
        for (std::size_t i = 1; i < expr->args.size(); ++i)
            if (live_[*target][i - 1]) result->args.push_back(expr->args[i]);
        return result->args.size() == 1 ? result->args[0] : result;
    }
    for (auto& part : result->args) part = without_dead(part);
    return result;
}

}  // namespace

FamilyIndex index_of(const std::vector<Function>& functions) {
    FamilyIndex result;
    for (std::size_t i = 0; i < functions.size(); ++i) result[functions[i].name] = i;
    return result;
}

const std::size_t* called(const FamilyIndex& index, const Expr& expr) {
    const bool applied = expr.kind == ExprKind::apply && expr.args[0]->kind == ExprKind::name;
    if (!applied && expr.kind != ExprKind::name) return nullptr;
    const auto found = index.find(applied ? expr.args[0]->text : expr.text);
    return found == index.end() ? nullptr : &found->second;
}

void for_each_part(const Expr& expr, const std::function<void(const Expr&)>& visit) {
    for (const auto& part : expr.args)
        if (part) visit(*part);
    for (const auto& field : expr.fields)
        if (field.value) visit(*field.value);
    for (const auto& clause : expr.clauses)
        if (clause.value) visit(*clause.value);
}

void drop_dead_parameters(std::vector<Function>& functions, ExprPtr& initial) {
    const Family family(functions);
    const std::vector<std::vector<bool>> live = family.live();
    std::vector<ExprPtr> bodies;
    for (const Function& function : functions) bodies.push_back(family.without_dead(function.body));
    initial = family.without_dead(initial);
    for (std::size_t i = 0; i < functions.size(); ++i) {
        functions[i].body = bodies[i];
        std::vector<std::string> kept;
        for (std::size_t p = 0; p < live[i].size(); ++p)
            if (live[i][p]) kept.push_back(functions[i].parameters[p]);
        functions[i].parameters = kept;
    }
}

}  // namespace robochart::csp_emit
