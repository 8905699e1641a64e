// SPDX-License-Identifier: Apache-2.0
// See translate.hpp.
#include "prism/assertions/properties/translate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "frontend/resolve/component_paths.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/typer.hpp"
#include "frontend/types/types.hpp"
#include "prism/syntax/lexer.hpp"
#include "prism/syntax/printer.hpp"

namespace robochart::probability {
namespace {

namespace ast = frontend;
using ast::BinaryOp;
using ast::ExprKind;
using ast::PathOp;
using ast::ProbabilisticDefinition;
using ast::ProbabilisticKind;
using prism::ExprPtr;
using prism::Op;

/// Limits the nesting of definitions. A deeper nesting means that a definition uses itself.
constexpr unsigned most_definition_depth = 50;

[[noreturn]] void throw_not_expressed(const std::string& what) {
    throw NotExpressed(what);
}

std::string join_parts(const std::vector<std::string>& parts) {
    std::string result;
    for (const std::string& part : parts) result += (result.empty() ? "" : "::") + part;
    return result;
}

Op operator_of(BinaryOp op) {
    switch (op) {
        case BinaryOp::iff:
            return Op::iff;
        case BinaryOp::implies:
            return Op::implies;
        case BinaryOp::disjunction:
            return Op::disjunction;
        case BinaryOp::conjunction:
            return Op::conjunction;
        case BinaryOp::equal:
            return Op::equal;
        case BinaryOp::not_equal:
            return Op::unequal;
        case BinaryOp::greater:
            return Op::greater;
        case BinaryOp::greater_equal:
            return Op::greater_equal;
        case BinaryOp::less:
            return Op::less;
        case BinaryOp::less_equal:
            return Op::less_equal;
        case BinaryOp::plus:
            return Op::add;
        case BinaryOp::minus:
            return Op::subtract;
        case BinaryOp::times:
            return Op::multiply;
        case BinaryOp::divide:
            return Op::divide;
        case BinaryOp::modulus:
        case BinaryOp::in:
        case BinaryOp::concat:
            break;
    }
    throw_not_expressed(fmt::format("the operator `{}`", ast::to_text(op)));
}

Op relation_of(const std::string& text) {
    if (text == "<") return Op::less;
    if (text == "<=") return Op::less_equal;
    return text == ">" ? Op::greater : Op::greater_equal;
}

/// Finds definitions. It searches the definitions of the assertion first, then those of its file, then those of other
/// files.
class Definitions {
public:
    Definitions(const Assertions& all, const ast::File& file, const ast::ProbabilisticAssertion& assertion) {
        for (const ast::ProbabilisticClause& clause : assertion.clauses)
            if (clause.name.empty()) found_.push_back(&clause.definition);
        add(file);
        for (const auto& other : all.model.files)
            if (other.get() != &file) add(*other);
    }

    [[nodiscard]] const std::vector<const ProbabilisticDefinition*>& all_definitions() const { return found_; }
    /// Returns null if there is no such definition.
    [[nodiscard]] const ProbabilisticDefinition* find(ProbabilisticKind kind, const std::string& name) const {
        for (const ProbabilisticDefinition* definition : found_)
            if (definition->kind == kind && (name.empty() || definition->name == name)) return definition;
        return nullptr;
    }
    /// Returns the definition that a clause names or contains.
    [[nodiscard]] const ProbabilisticDefinition* definition_of(const ast::ProbabilisticClause& clause) const {
        return clause.name.empty() ? &clause.definition : find(clause.definition.kind, clause.name.parts.back());
    }
    [[nodiscard]] const ast::ProbabilisticFunction* find_function(const std::string& name) const {
        for (const ProbabilisticDefinition* definition : found_)
            for (const ast::ProbabilisticFunction& function : definition->functions)
                if (function.name == name && function.result) return &function;
        return nullptr;
    }
    /// True if an assertion file declares the constant.
    [[nodiscard]] bool defines_constant(const ast::Declaration* constant) const {
        return std::ranges::any_of(found_,
                                   [&](const auto* definition) { return definition->constant.get() == constant; });
    }

private:
    void add(const ast::File& file) {
        for (const ProbabilisticDefinition& definition : file.probabilistic_definitions) found_.push_back(&definition);
    }
    std::vector<const ProbabilisticDefinition*> found_;
};

class Translator {
public:
    Translator(const Assertions& all, const ast::File& file, const Definitions& definitions, Elements& elements)
        : all_(all), file_(file), definitions_(definitions), elements_(elements) {}

    Question operator()(const ast::ProbabilisticAssertion& assertion) {
        for (const ast::ProbabilisticClause& clause : assertion.clauses) {
            const ProbabilisticDefinition* const definition = definitions_.definition_of(clause);
            if (definition == nullptr) continue;  // reported by the resolver
            if (definition->kind == ProbabilisticKind::constants) add_settings(*definition);
            if (definition->kind == ProbabilisticKind::modules) add_modules(*definition);
        }
        if (!assertion.property) return translate_generation(assertion.path);
        question_.property = translate_expression(*assertion.property);
        if (question_.simulation && question_.property != simulated_)
            throw_not_expressed("`using sim` inside another expression: random paths answer one probability or reward");
        return std::move(question_);
    }

    Question translate_generation(const ast::PathGeneration& path) {
        const auto number = [&](const char* what, const ast::ExprPtr& expr) {
            return expr ? this->add_number(what, *expr) : "";
        };
        question_.path =
            Generation{number("for", path.steps), number("repeats", path.repeats), number("up to", path.limit)};
        return std::move(question_);
    }

    ExprPtr apply_function(const ast::ProbabilisticFunction& function, std::vector<ExprPtr> arguments) {
        if (arguments.size() != function.parameters.size())
            throw_not_expressed(fmt::format("`&{}` with {} arguments, which has {} parameters", function.name,
                                            arguments.size(), function.parameters.size()));
        const Deeper deeper(depth_);
        std::map<const ast::Declaration*, ExprPtr> bound;
        for (std::size_t i = 0; i < arguments.size(); ++i) bound[function.parameters[i].get()] = arguments[i];
        std::swap(bound, bound_);
        ExprPtr result = translate_expression(*function.result);
        std::swap(bound, bound_);
        return result;
    }

private:
    class Deeper {
    public:
        explicit Deeper(unsigned& depth) : depth_(depth) {
            if (++depth_ > most_definition_depth) throw_not_expressed("a definition that uses itself");
        }
        ~Deeper() { --depth_; }
        Deeper(const Deeper&) = delete;
        Deeper& operator=(const Deeper&) = delete;

    private:
        unsigned& depth_;
    };

    // expressions
    ExprPtr translate_expression(const ast::Expr& expr);
    ExprPtr make_node(const ast::Expr& expr, Op op, std::vector<ExprPtr> parts, std::string text = {}) {
        return prism::make_expr(op, expr.span, std::move(parts), std::move(text));
    }
    std::vector<ExprPtr> translate_operands(const ast::Expr& expr) {
        std::vector<ExprPtr> result;
        for (const auto& operand : expr.args) result.push_back(translate_expression(*operand));
        return result;
    }
    ExprPtr translate_unary(const ast::Expr& expr);
    ExprPtr translate_binary(const ast::Expr& expr);
    ExprPtr name(const ast::Expr& expr);
    ExprPtr translate_constant(const ast::Expr& expr);
    ExprPtr translate_marked(const ast::Expr& expr);
    ExprPtr translate_call(const ast::Expr& expr);
    ExprPtr translate_defined(const ast::Expr& expr, ProbabilisticKind kind);
    ExprPtr in_state(const ast::Expr& expr);
    ExprPtr translate_path(const ast::Expr& expr);
    ExprPtr translate_quantitative(const ast::Expr& expr);
    std::string add_number(const std::string& what, const ast::Expr& expr);
    void read_simulation(const ast::Expr& simulation);
    std::shared_ptr<const prism::StepBound> step_bound(const ast::Expr& path);

    // names
    std::string full_path(const ast::QualifiedName& name);
    static std::string event_direction(const ast::Expr& event) { return event.text.substr(0, event.text.find('.')); }
    std::string translate_event(const ast::ExprPtr& event);
    std::string free_name(const std::string& preferred) const;

    // definitions
    void add_settings(const ProbabilisticDefinition& definition);
    std::vector<std::string> constant_values(const ast::Expr& value);
    void add_rewards(const ProbabilisticDefinition& definition);
    void add_modules(const ProbabilisticDefinition& definition);
    prism::Module translate_module(const ast::ProbabilisticModule& module);
    prism::Command translate_command(const ast::Command& command);
    prism::Assignment translate_assignment(const ast::Update& update);

    const Assertions& all_;
    const ast::File& file_;
    const Definitions& definitions_;
    Elements& elements_;
    Question question_;
    std::map<const ast::Declaration*, ExprPtr> bound_;      ///< parameters of the function being expanded
    std::map<const ast::Declaration*, std::string> known_;  ///< constants of assertion files
    ExprPtr simulated_;                                     ///< the expression before `using sim`
    bool in_model_ = false;                                 ///< inside rewards or modules
    unsigned depth_ = 0;
};

ExprPtr Translator::translate_expression(const ast::Expr& expr) {
    switch (expr.kind) {
        case ExprKind::integer:
            return make_node(expr, Op::integer, {}, expr.text);
        case ExprKind::real:
            return make_node(expr, Op::real, {}, expr.text);
        case ExprKind::boolean:
            return make_node(expr, Op::boolean, {}, expr.text);
        case ExprKind::parenthesised:
            return translate_expression(*expr.args.front());
        case ExprKind::unary:
            return translate_unary(expr);
        case ExprKind::binary:
            return translate_binary(expr);
        case ExprKind::if_then_else:
            return make_node(expr, Op::conditional, translate_operands(expr));
        case ExprKind::name:
            return name(expr);
        case ExprKind::marked:
            return translate_marked(expr);
        case ExprKind::call:
            return translate_call(expr);
        case ExprKind::in_state:
            return in_state(expr);
        case ExprKind::event:
            if (!expr.text.ends_with(".val"))
                throw_not_expressed(fmt::format("the event `{}` as a value", ast::to_text(expr)));
            return elements_.event_value(full_path(expr.name), event_direction(expr));
        case ExprKind::path:
            return translate_path(expr);
        case ExprKind::probability:
        case ExprKind::reward:
            return translate_quantitative(expr);
        case ExprKind::all_paths:
        case ExprKind::some_path:
            return make_node(expr, expr.kind == ExprKind::all_paths ? Op::forall_paths : Op::exists_path,
                             translate_operands(expr));
        // clang-format off
        case ExprKind::string: case ExprKind::result: case ExprKind::to: case ExprKind::from: case ExprKind::let:
        case ExprKind::forall: case ExprKind::exists: case ExprKind::exists_unique: case ExprKind::lambda:
        case ExprKind::the: case ExprKind::cast: case ExprKind::is_type: case ExprKind::member: case ExprKind::index:
        case ExprKind::tuple: case ExprKind::record: case ExprKind::sequence: case ExprKind::set:
        case ExprKind::set_range: case ExprKind::set_comprehension: case ExprKind::range: case ExprKind::matrix:
        case ExprKind::inverse: case ExprKind::transpose: case ExprKind::since: case ExprKind::since_entry:
        case ExprKind::simulation: case ExprKind::register_: case ExprKind::cycle: case ExprKind::error:
            break;
    }
    // clang-format on
    throw_not_expressed(fmt::format("`{}`", ast::to_text(expr)));
}

ExprPtr Translator::translate_unary(const ast::Expr& expr) {
    return make_node(expr, expr.unary == ast::UnaryOp::negate ? Op::minus : Op::negation, translate_operands(expr));
}

ExprPtr Translator::translate_binary(const ast::Expr& expr) {
    if (expr.binary == BinaryOp::modulus) return make_node(expr, Op::call, translate_operands(expr), "mod");
    return make_node(expr, operator_of(*expr.binary), translate_operands(expr));
}

// ---------------------------------------------------------------- names

std::string Translator::full_path(const ast::QualifiedName& name) {
    Beginning begin = path_beginning(all_, file_, name);
    if (begin.used == 0) throw_not_expressed(fmt::format("`{}`, which begins with no component", name.text()));
    for (std::size_t i = begin.used; i < name.parts.size(); ++i) {
        // In a path, a platform has its own name and not that of the reference.
        const ast::Context* const platform = i == begin.used ? ast::platform_of(begin.end, name.parts[i]) : nullptr;
        begin.parts.push_back(platform != nullptr ? platform->name : name.parts[i]);
    }
    return join_parts(begin.parts);
}

/// Returns a name that is neither used in the model nor a keyword of PRISM.
std::string Translator::free_name(const std::string& preferred) const {
    std::string name = preferred;
    while (prism::is_reserved(name) || elements_.is_name_taken(name)) name += "_";
    return name;
}

ExprPtr Translator::name(const ast::Expr& expr) {
    const ast::Declaration* const target = expr.target;
    if (target == nullptr) {
        const std::string& label = expr.name.parts.front();
        if (expr.name.parts.size() == 1 && (label == "deadlock" || label == "init"))
            return make_node(expr, Op::label, {}, label);
        throw_not_expressed(fmt::format("`{}`", expr.name.text()));
    }
    if (target->kind == ast::DeclKind::enum_literal) {
        // In every encoding, literals are numbered in the order of their declaration.
        const auto* type = dynamic_cast<const ast::TypeDeclaration*>(target->parent);
        for (std::size_t i = 0; type != nullptr && i < type->literals.size(); ++i)
            if (type->literals[i].get() == target) return make_node(expr, Op::integer, {}, fmt::format("{}", i));
        throw_not_expressed(fmt::format("the literal `{}`", expr.name.text()));
    }
    if (definitions_.defines_constant(target)) return translate_constant(expr);
    const std::string path = full_path(expr.name);
    return target->kind == ast::DeclKind::constant ? elements_.constant_expression(path)
                                                   : elements_.variable_expression(path);
}

/// Translates `const t : T` of an assertion file to an open constant.
ExprPtr Translator::translate_constant(const ast::Expr& expr) {
    const auto* declared = static_cast<const ast::Variable*>(expr.target);
    const auto [known, added] = known_.try_emplace(declared);
    if (added) known->second = free_name(declared->name);
    prism::Constant made{prism::Type::integer, {known->second, expr.span}, nullptr};
    const ast::TypeForm form = declared->type ? declared->type->form : ast::TypeForm::any;
    if (form == ast::TypeForm::boolean)
        made.type = prism::Type::boolean;
    else if (form == ast::TypeForm::real)
        made.type = prism::Type::real;
    else if (form != ast::TypeForm::nat && form != ast::TypeForm::integer)
        throw_not_expressed(
            fmt::format("the constant `{}` of type {}", declared->name, ast::to_string(declared->type)));
    const auto same = [&](const prism::Constant& constant) { return constant.name.text == made.name.text; };
    auto& model = question_.model_constants;
    auto& own = question_.constants;
    if (std::ranges::none_of(model, same)) {
        if (in_model_) std::erase_if(own, same);
        auto& list = in_model_ ? model : own;
        if (std::ranges::none_of(list, same)) list.push_back(made);
    }
    return make_node(expr, Op::name, {}, made.name.text);
}

ExprPtr Translator::translate_defined(const ast::Expr& expr, ProbabilisticKind kind) {
    const ProbabilisticDefinition* const found = definitions_.find(kind, expr.name.parts.back());
    if (found == nullptr || !found->value) throw_not_expressed(fmt::format("`{}`", ast::to_text(expr)));
    const Deeper deeper(depth_);
    return translate_expression(*found->value);
}

ExprPtr Translator::translate_marked(const ast::Expr& expr) {
    if (expr.text == "#") return translate_defined(expr, ProbabilisticKind::label);
    if (expr.text == "$") return translate_defined(expr, ProbabilisticKind::formula);
    if (expr.text == "@") return make_node(expr, Op::name, {}, expr.name.parts.back());
    if (expr.text == "$$") {
        const auto found = bound_.find(expr.target);
        if (found != bound_.end()) return found->second;
    }
    throw_not_expressed(fmt::format("`{}`", ast::to_text(expr)));
}

ExprPtr Translator::translate_call(const ast::Expr& expr) {
    const bool function = expr.callee && expr.callee->kind == ExprKind::marked && expr.callee->text == "&";
    const ast::ProbabilisticFunction* const found =
        function ? definitions_.find_function(expr.callee->name.parts.back()) : nullptr;
    if (found == nullptr) throw_not_expressed(fmt::format("`{}`", ast::to_text(expr)));
    return apply_function(*found, translate_operands(expr));
}

/// Translates `M is in S`. The path of the state begins at the top of its machine.
ExprPtr Translator::in_state(const ast::Expr& expr) {
    const auto* state = dynamic_cast<const ast::State*>(expr.args.front()->target);
    const Beginning machine = path_beginning(all_, file_, expr.name);
    if (state == nullptr || machine.used == 0) throw_not_expressed(fmt::format("`{}`", ast::to_text(expr)));
    std::string path = state->name;
    for (const auto* above = dynamic_cast<const ast::State*>(state->parent); above != nullptr;
         above = dynamic_cast<const ast::State*>(above->parent))
        path = above->name + "::" + path;
    return elements_.in_state(join_parts(machine.parts), path);
}

std::string Translator::translate_event(const ast::ExprPtr& event) {
    if (!event) return "";
    if (event->kind != ExprKind::event || event->text.ends_with(".val"))
        throw_not_expressed(fmt::format("the event `{}` without `.in` or `.out`", ast::to_text(*event)));
    return elements_.event_action(full_path(event->name), event_direction(*event));
}

// ---------------------------------------------------------------- questions

/// Translates `<=n`, `[a, b]`.
std::shared_ptr<const prism::StepBound> Translator::step_bound(const ast::Expr& path) {
    const ast::ExprPtr& bound = path.args.front();
    if (!bound) return nullptr;
    auto result = std::make_shared<prism::StepBound>();
    if (bound->kind == ExprKind::range) {
        result->low = translate_expression(*bound->args[0]);
        result->high = translate_expression(*bound->args[1]);
        return result;
    }
    const Op relation = relation_of(path.text);
    const bool upper = relation == Op::less || relation == Op::less_equal;
    (upper ? result->high : result->low) = translate_expression(*bound);
    (upper ? result->high_strict : result->low_strict) = relation == Op::less || relation == Op::greater;
    return result;
}

ExprPtr Translator::translate_path(const ast::Expr& expr) {
    std::vector<ExprPtr> parts;
    for (std::size_t i = 1; i < expr.args.size(); ++i) parts.push_back(translate_expression(*expr.args[i]));
    prism::Expr made;
    made.span = expr.span;
    switch (*expr.path) {
        case PathOp::eventually:
        case PathOp::reachable:
            made.op = Op::eventually;
            break;
        case PathOp::globally:
            made.op = Op::globally;
            break;
        case PathOp::next:
            made.op = Op::next;
            break;
        case PathOp::until:
            made.op = Op::until;
            break;
        case PathOp::cumulative:
            made.op = Op::cumulative;
            break;
        case PathOp::total:
            made.op = Op::total;
            break;
        case PathOp::linear_time:
            return parts.front();
        case PathOp::weak_until:
        case PathOp::release:
            throw_not_expressed(fmt::format("`{}` with one formula", ast::to_text(*expr.path)));
    }
    made.parts = std::move(parts);
    made.steps = step_bound(expr);
    return prism::make_expr(std::move(made));
}

ExprPtr Translator::translate_quantitative(const ast::Expr& expr) {
    const bool reward = expr.kind == ExprKind::reward;
    auto query = std::make_shared<prism::Query>();
    if (expr.args[1]) {
        query->relation = relation_of(expr.text);
        query->bound = translate_expression(*expr.args[1]);
    } else if (expr.text != "=?") {
        query->optimum = expr.text == "min=?" ? prism::Optimum::minimum : prism::Optimum::maximum;
    }
    if (reward) {
        const std::string reward_name = expr.name.empty() ? "" : expr.name.parts.back();
        const ProbabilisticDefinition* const found = definitions_.find(ProbabilisticKind::rewards, reward_name);
        if (found == nullptr) throw_not_expressed(fmt::format("`{}`: there is no such reward", ast::to_text(expr)));
        add_rewards(*found);
        query->reward = {found->name, expr.span};
    }
    prism::Expr made;
    made.op = reward ? Op::reward : Op::probability;
    made.span = expr.span;
    made.parts = {translate_expression(*expr.args[0])};
    made.query = std::move(query);
    ExprPtr result = prism::make_expr(std::move(made));
    if (expr.args[2]) {
        read_simulation(*expr.args[2]);
        simulated_ = result;
    }
    return result;
}

/// Adds a constant with the value of a number in `using`. The name of the constant cannot clash with PRISM's names.
std::string Translator::add_number(const std::string& what, const ast::Expr& expr) {
    std::string name = fmt::format("`{} {}`", what, ast::to_text(expr));
    question_.constants.push_back({prism::Type::real, {name, expr.span}, translate_expression(expr)});
    return name;
}

/// Reads one of PRISM's methods, with RoboTool's parameter names: `-simwidth` is `w` or `epsilon`, `-simconf` is
/// `alpha` or `delta`, `-simsamples` is `n`, `-simpathlen` is `pathlen`. For SPRT, `delta` is half of the indifference
/// region.
void Translator::read_simulation(const ast::Expr& simulation) {
    using Names = std::map<std::string, std::string>;
    static const std::map<std::string, Names> parameters{
        {"CI", {{"w", "width"}, {"alpha", "confidence"}, {"n", "samples"}, {"pathlen", "path"}}},
        {"ACI", {{"w", "width"}, {"alpha", "confidence"}, {"n", "samples"}, {"pathlen", "path"}}},
        {"APMC", {{"epsilon", "width"}, {"delta", "confidence"}, {"n", "samples"}, {"pathlen", "path"}}},
        {"SPRT", {{"delta", "width"}, {"alpha", "confidence"}, {"pathlen", "path"}}}};
    const Names& names = parameters.at(simulation.text);
    Sampling sampling{simulation.text, {}};
    std::ranges::transform(sampling.method, sampling.method.begin(),
                           [](char letter) { return static_cast<char>(letter - 'A' + 'a'); });
    std::set<std::string> given;
    for (const ast::Binding& binding : simulation.bindings) {
        const std::string& name = binding.variable->name;
        const auto known = names.find(name);
        if (known == names.end()) {
            std::string all;
            for (const auto& [one, other] : names) all += (all.empty() ? "" : ", ") + one;
            throw Wrong(fmt::format("`sim with {}` has no parameter `{}`: {}", simulation.text, name, all));
        }
        if (!given.insert(name).second)
            throw Wrong(fmt::format("`sim with {}`: `{}` is given twice", simulation.text, name));
        sampling.parameters.emplace_back(known->second, add_number(name + " =", *binding.value));
    }
    question_.simulation = std::move(sampling);
}

// ---------------------------------------------------------------- definitions

void Translator::add_settings(const ProbabilisticDefinition& definition) {
    for (const ast::ConstantValues& source : definition.constants) {
        Setting setting;
        setting.name = source.constant->name.text();
        if (definitions_.defines_constant(source.constant->target)) {
            const auto [known, added] = known_.try_emplace(source.constant->target);
            if (added) known->second = free_name(source.constant->target->name);
            setting.constant = known->second;
        } else {
            setting.path = full_path(source.constant->name);
        }
        setting.values = source.from_set ? constant_values(*source.value)
                                         : std::vector<std::string>{prism::print(translate_expression(*source.value))};
        question_.settings.push_back(std::move(setting));
    }
}

/// Returns the values of `{1, 2, 5}` or `{1 to 9 by step 2}`.
std::vector<std::string> Translator::constant_values(const ast::Expr& value) {
    std::vector<std::string> result;
    if (value.kind == ExprKind::set_range) {
        const std::string low = prism::print(translate_expression(*value.args[0]));
        const std::string high = prism::print(translate_expression(*value.args[1]));
        const bool step = value.args.size() > 2 && value.args[2];
        return {fmt::format("{}:{}:{}", low, step ? prism::print(translate_expression(*value.args[2])) : "1", high)};
    }
    if (value.kind != ExprKind::set || value.args.empty())
        throw_not_expressed(fmt::format("`{}` as a set of values", ast::to_text(value)));
    for (const auto& element : value.args) result.push_back(prism::print(translate_expression(*element)));
    return result;
}

void Translator::add_rewards(const ProbabilisticDefinition& definition) {
    const auto same = [&](const auto& structure) { return structure.name.text == definition.name; };
    if (std::ranges::any_of(question_.rewards, same)) return;
    prism::RewardStructure made{{definition.name, definition.name_span}, {}};
    const bool before = std::exchange(in_model_, true);
    for (const ast::RewardItem& source : definition.rewards) {
        prism::RewardItem item;
        item.transition = source.of_step;
        item.span = source.guard->span;
        item.action = {source.of_step ? translate_event(source.event) : "", item.span};
        item.guard = translate_expression(*source.guard);
        item.value = translate_expression(*source.value);
        made.items.push_back(source.of_step ? std::move(item) : elements_.of_state(std::move(item)));
    }
    in_model_ = before;
    question_.rewards.push_back(std::move(made));
}

void Translator::add_modules(const ProbabilisticDefinition& definition) {
    const bool before = std::exchange(in_model_, true);
    for (const ast::ProbabilisticModule& module : definition.modules)
        question_.modules.push_back(translate_module(module));
    in_model_ = before;
}

prism::Module Translator::translate_module(const ast::ProbabilisticModule& source) {
    prism::Module made;
    made.name = {source.name, source.name_span};
    for (const ast::ModuleVariable& declared : source.variables) {
        prism::Variable variable{
            {declared.variable->name, declared.variable->name_span}, prism::Type::boolean, {}, {}, {}};
        if (declared.low) {
            variable.type = prism::Type::integer;
            variable.low = translate_expression(*declared.low);
            variable.high = translate_expression(*declared.high);
        }
        if (declared.variable->initial) variable.initial = translate_expression(*declared.variable->initial);
        made.variables.push_back(std::move(variable));
    }
    for (const ast::Command& command : source.commands) made.commands.push_back(translate_command(command));
    return made;
}

/// Translates a command. `(p : @x = e)` begins a branch. Updates without a probability belong to the branch before
/// them.
prism::Command Translator::translate_command(const ast::Command& source) {
    prism::Command made;
    made.span = source.guard->span;
    made.action = {translate_event(source.event), made.span};
    made.guard = translate_expression(*source.guard);
    for (const ast::Update& update : source.updates) {
        const bool begins = made.branches.empty() || update.probability;
        if (begins && !made.branches.empty() && !made.branches.front().probability)
            throw_not_expressed("a probability behind an update without one");
        if (begins)
            made.branches.push_back(
                {update.probability ? translate_expression(*update.probability) : nullptr, {}, made.span});
        made.branches.back().assignments.push_back(translate_assignment(update));
    }
    if (made.branches.empty()) made.branches.push_back({nullptr, {}, made.span});
    return made;
}

prism::Assignment Translator::translate_assignment(const ast::Update& update) {
    return {{update.variable->name.parts.back(), update.variable->span}, translate_expression(*update.value)};
}

/// Records the components with which the paths in an assertion begin.
class Recorder final : public Elements {
public:
    ExprPtr variable_expression(const std::string& path) override { return record_number(path); }
    ExprPtr constant_expression(const std::string& path) override { return record_number(path); }
    ExprPtr in_state(const std::string& machine, const std::string& /*state*/) override {
        return record_number(machine);
    }
    std::string event_action(const std::string& path, const std::string& /*direction*/) override {
        record_path(path);
        return "";
    }
    ExprPtr event_value(const std::string& path, const std::string& /*direction*/) override {
        return record_number(path);
    }
    [[nodiscard]] bool is_name_taken(const std::string& /*name*/) const override { return false; }

    void record_path(const std::string& path) {
        const std::string first = path.substr(0, path.find("::"));
        if (std::ranges::find(found, first) == found.end()) found.push_back(first);
    }
    std::vector<std::string> found;

private:
    ExprPtr record_number(const std::string& path) {
        record_path(path);
        return prism::make_expr(Op::integer, {}, {}, "0");
    }
};

/// Rejects all elements of the model.
class NoElements final : public Elements {
public:
    ExprPtr variable_expression(const std::string& path) override { throw_absent(path); }
    ExprPtr constant_expression(const std::string& path) override { throw_absent(path); }
    ExprPtr in_state(const std::string& machine, const std::string& /*state*/) override { throw_absent(machine); }
    std::string event_action(const std::string& path, const std::string& /*direction*/) override { throw_absent(path); }
    ExprPtr event_value(const std::string& path, const std::string& /*direction*/) override { throw_absent(path); }
    [[nodiscard]] bool is_name_taken(const std::string& /*name*/) const override { return false; }

private:
    [[noreturn]] static void throw_absent(const std::string& path) {
        throw_not_expressed(fmt::format("`{}` in a function that the model calls", path));
    }
};

}  // namespace

Beginning path_beginning(const Assertions& all, const ast::File& file, const ast::QualifiedName& name) {
    const ast::Way way = ast::component_way(all.model, all.names, file, name);
    Beginning result{{}, way.used, way.end()};
    for (const ast::Declaration* step : way.path.steps) result.parts.push_back(step->name);
    return result;
}

namespace {

bool has_simulation(const ast::Expr& expr) {
    return expr.kind == ExprKind::simulation ||
           std::ranges::any_of(expr.args, [](const auto& part) { return part && has_simulation(*part); });
}

}  // namespace

bool is_simulated(const ast::ProbabilisticAssertion& assertion) {
    return !assertion.property || has_simulation(*assertion.property);
}

std::vector<std::string> subjects_of(const Assertions& all, const ast::File& file,
                                     const ast::ProbabilisticAssertion& assertion) {
    const Definitions definitions(all, file, assertion);
    Recorder recorder;
    const Question question = Translator(all, file, definitions, recorder)(assertion);
    for (const Setting& setting : question.settings)
        if (!setting.path.empty()) recorder.record_path(setting.path);
    return recorder.found;
}

Question translate_assertion(const Assertions& all, const ast::File& file, const ast::ProbabilisticAssertion& assertion,
                             Elements& elements) {
    const Definitions definitions(all, file, assertion);
    return Translator(all, file, definitions, elements)(assertion);
}

std::map<std::string, Function> functions_of(const Assertions& all, const ast::File& file,
                                             const ast::ProbabilisticAssertion& assertion) {
    std::map<std::string, Function> result;
    const auto definitions = std::make_shared<const Definitions>(all, file, assertion);
    for (const ast::ProbabilisticClause& clause : assertion.clauses) {
        const ProbabilisticDefinition* const definition = definitions->definition_of(clause);
        if (definition == nullptr || definition->kind != ProbabilisticKind::definitions) continue;
        for (const ast::ProbabilisticFunction& function : definition->functions)
            if (function.result)
                result[function.name] = [&all, &file, definitions, &function](const std::vector<ExprPtr>& arguments) {
                    NoElements nothing;
                    return Translator(all, file, *definitions, nothing).apply_function(function, arguments);
                };
    }
    return result;
}

}  // namespace robochart::probability
