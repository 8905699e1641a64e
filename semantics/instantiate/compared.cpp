// SPDX-License-Identifier: Apache-2.0
// Extends carriers beyond the numbers in comparisons. A comparison such as `n > limit` would never be true if the
// carrier ended at the limit.
#include "semantics/instantiate/compared.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/diagnostics/containers.hpp"
#include "base/diagnostics/scanner.hpp"
#include "semantics/ir/arithmetic.hpp"
#include "semantics/ir/numbers.hpp"
#include "semantics/ir/query.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

constexpr std::size_t most_of_expression = 64;  // limit on the values of one expression without variables
constexpr int most_depth = 16;                  // limit for chains of constants that are defined by constants

// ---------------------------------------------------------------- decimals

/// Two decimals with the same number of decimal places.
struct Aligned {
    std::int64_t left, right;
    std::uint32_t decimals;
};

std::optional<std::int64_t> in_units(const Decimal& value, std::uint32_t decimals) {
    const auto factor = power_of_ten(decimals - value.decimals);
    return factor ? checked_multiply(value.unscaled, *factor) : std::nullopt;
}

std::optional<Aligned> align_decimals(const Decimal& a, const Decimal& b) {
    const std::uint32_t decimals = std::max(a.decimals, b.decimals);
    const auto left = in_units(a, decimals), right = in_units(b, decimals);
    if (!left || !right) return std::nullopt;
    return Aligned{*left, *right, decimals};
}

std::int64_t floor_of(const Decimal& value) {
    return *floor_divide(value.unscaled, power_of_ten(value.decimals).value_or(1));
}

bool is_whole(const Decimal& value) {
    return *floor_modulus(value.unscaled, power_of_ten(value.decimals).value_or(1)) == 0;
}

/// Compares two decimals. If they cannot be given the same number of decimal places, no carrier contains them. Then
/// only their whole parts, rounded down, are compared.
bool is_less(const Decimal& a, const Decimal& b) {
    const auto both = align_decimals(a, b);
    return both ? both->left < both->right : floor_of(a) < floor_of(b);
}

Decimal negate_decimal(const Decimal& value) {
    return {checked_subtract(0, value.unscaled).value_or(value.unscaled), value.decimals};
}

using Operation = std::optional<Decimal> (*)(const Decimal&, const Decimal&);

std::optional<Decimal> add_decimals(const Decimal& a, const Decimal& b) {
    const auto both = align_decimals(a, b);
    const auto value = both ? checked_add(both->left, both->right) : std::nullopt;
    return value ? std::optional(Decimal{*value, both->decimals}) : std::nullopt;
}

std::optional<Decimal> subtract_decimals(const Decimal& a, const Decimal& b) {
    return add_decimals(a, negate_decimal(b));
}

std::optional<Decimal> multiply_decimals(const Decimal& a, const Decimal& b) {
    const auto value = checked_multiply(a.unscaled, b.unscaled);
    if (!value || a.decimals + b.decimals > 18) return std::nullopt;
    return Decimal{*value, a.decimals + b.decimals};
}

/// Returns the quotient, rounded down to a whole number.
std::optional<Decimal> divide_decimals(const Decimal& a, const Decimal& b) {
    const auto both = align_decimals(a, b);
    const auto value = both ? floor_divide(both->left, both->right) : std::nullopt;
    return value ? std::optional(Decimal{*value, 0}) : std::nullopt;
}

// ---------------------------------------------------------------- values without variables

using Decimals = std::vector<Decimal>;
using Chosen = std::map<std::string, ExprPtr>;

/// Returns the number that a block Instantiations assigns to a name, or no value if it is another expression.
std::optional<std::int64_t> defined_number(const std::string& text, const std::string& name) {
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        if (at > 0 && diagnostics::continues_name(text[at - 1])) continue;
        std::size_t next = text.find_first_not_of(" \t", at + name.size());
        if (next == std::string::npos || text[next] != '=') continue;
        next = text.find_first_not_of(" \t", next + 1);
        if (next == std::string::npos) continue;
        const std::size_t end = text.find_first_not_of("-0123456789", next);
        if (const auto number = parse_integer(text.substr(next, end == std::string::npos ? end : end - next)))
            return number;
    }
    return std::nullopt;
}

/// Computes the possible values of expressions without variables.
class KnownValues {
public:
    KnownValues(const System& system, const Chosen& chosen, std::int64_t longest)
        : system_(system), chosen_(chosen), longest_(longest) {}

    /// Returns no value if the value depends on the state of a machine. `machine` declares the constants in the
    /// expression, and is null if it has none.
    [[nodiscard]] std::optional<Decimals> find_values(const Expr&, const Machine*, int depth = 0) const;
    [[nodiscard]] bool is_length(const Expr& expr) const {
        const bool size = expr.kind == ExprKind::toolkit && expr.text == "sequence_toolkit_size";
        return size && !expr.args.empty() && is_sequence(*expr.args[0]);
    }

private:
    [[nodiscard]] bool is_sequence(const Expr& expr) const {
        if (expr.kind == ExprKind::cast) return is_sequence(*expr.args[0]);
        return expr.type.is_valid() && system_.type(expr.type).kind == TypeKind::sequence;
    }
    [[nodiscard]] std::optional<Decimals> combine_operands(const Expr&, const Machine*, int depth, Operation) const;
    [[nodiscard]] const Decimals& values_of_constant(const std::string& name, int depth) const;
    [[nodiscard]] Decimals values_of(const std::string& name, int depth) const;
    void add_declared(const std::vector<Constant>&, const std::string& name, const Machine*, int depth,
                      Decimals&) const;

    const System& system_;
    const Chosen& chosen_;
    std::int64_t longest_;
    mutable std::map<std::string, Decimals> constants_;
};

std::optional<Decimals> KnownValues::find_values(const Expr& expr, const Machine* machine, int depth) const {
    if (expr.kind == ExprKind::integer) return Decimals{{expr.number, 0}};
    if (expr.kind == ExprKind::real) return Decimals{expr.decimal};
    if (is_length(expr)) return Decimals{{longest_, 0}};
    if (expr.kind == ExprKind::constant) {
        if (machine == nullptr || expr.constant.index >= machine->constants.size()) return std::nullopt;
        return values_of_constant(machine->constants[expr.constant.index].name, depth);
    }
    if (expr.kind == ExprKind::plus) return combine_operands(expr, machine, depth, add_decimals);
    if (expr.kind == ExprKind::minus) return combine_operands(expr, machine, depth, subtract_decimals);
    if (expr.kind == ExprKind::times) return combine_operands(expr, machine, depth, multiply_decimals);
    if (expr.kind == ExprKind::divide) return combine_operands(expr, machine, depth, divide_decimals);
    if (expr.kind != ExprKind::negate && expr.kind != ExprKind::cast) return std::nullopt;
    auto inner = find_values(*expr.args[0], machine, depth);
    if (inner && expr.kind == ExprKind::negate)
        for (Decimal& value : *inner) value = negate_decimal(value);
    return inner;
}

std::optional<Decimals> KnownValues::combine_operands(const Expr& expr, const Machine* machine, int depth,
                                                      Operation operation) const {
    const auto left = find_values(*expr.args[0], machine, depth), right = find_values(*expr.args[1], machine, depth);
    if (!left || !right || left->size() * right->size() > most_of_expression) return std::nullopt;
    Decimals result;
    for (const Decimal& a : *left)
        for (const Decimal& b : *right)
            if (const auto value = operation(a, b)) result.push_back(*value);
    return result;
}

void KnownValues::add_declared(const std::vector<Constant>& constants, const std::string& name, const Machine* machine,
                               int depth, Decimals& values) const {
    for (const Constant& constant : constants) {
        if (constant.name != name) continue;
        if (!constant.value) {
            values.push_back({});
        } else if (const auto given = find_values(*constant.value, machine, depth)) {
            values.insert(values.end(), given->begin(), given->end());
        }
    }
}

const Decimals& KnownValues::values_of_constant(const std::string& name, int depth) const {
    const auto known = constants_.find(name);
    if (known != constants_.end()) return known->second;
    const Decimals found = depth < most_depth ? values_of(name, depth) : Decimals{};
    return constants_[name] = found;
}

/// Returns the values of all constants with this name. They count as one constant, because a required constant gets its
/// value from another constant of the same name.
Decimals KnownValues::values_of(const std::string& name, int depth) const {
    Decimals values;
    for (const Machine& machine : system_.machines) add_declared(machine.constants, name, &machine, depth + 1, values);
    for (const Controller& controller : system_.controllers)
        add_declared(controller.constants, name, nullptr, depth + 1, values);
    for (const Module& module : system_.modules)
        add_declared(module.platform.constants, name, nullptr, depth + 1, values);
    const auto add = [&](const Expr& expr) {
        if (const auto given = find_values(expr, nullptr, depth + 1))
            values.insert(values.end(), given->begin(), given->end());
    };
    for (const NamedConstant& named : named_constants(system_)) {
        if (!named.path.ends_with("::" + name)) continue;
        if (const auto option = chosen_.find(named.name); option != chosen_.end()) add(*option->second);
        for (const Property& property : system_.properties)
            for (const auto& [set, value] : property.constants)
                if (set == named.name) add(*value);
        for (const CspBlock& block : system_.csp_blocks)
            if (is_instantiations(block))
                if (const auto number = defined_number(block.text, named.name)) values.push_back({*number, 0});
    }
    std::ranges::sort(values, is_less);
    const auto same = [](const Decimal& a, const Decimal& b) { return !is_less(a, b) && !is_less(b, a); };
    diagnostics::erase_repeated(values, same);
    if (values.size() > most_of_expression) values.resize(most_of_expression);
    return values;
}

// ---------------------------------------------------------------- comparisons

class Comparisons {
public:
    Comparisons(const System& system, const KnownValues& known, Compared& result)
        : system_(system), known_(known), result_(result) {}

    void look_at(const Expr&, const Machine*);
    /// Records steps of counters: `n = n + 7`, `n = n - 7`.
    void look_at_assignment(const Stmt&, const Machine&);
    /// Adds the values that counters have one step after the numbers with which they are compared by order.
    void add_steps();
    /// Adds numbers for variables that are compared by order with each other. Their type must contain a greater and a
    /// smaller number for each value that one of them may have.
    void add_extremes(const Literals&);
    void add_between(const Literals&);
    /// Records the conversions of values that are stored or sent to reals: `q = x` for x : int and q : real.
    void look_at_written(const Expr& value);
    /// Records the conversion of a value to the type of the place that stores it: `q = x` for x : nat and q : int.
    void look_at_stored(TypeId value, TypeId place) {
        conversions_.emplace(system_.type(value).kind, system_.type(place).kind);
    }
    /// Adds numbers for conversions. If a value is converted to a wider type, it counts as compared with the numbers of
    /// that type.
    void add_converted();

private:
    void record_comparison(const Expr& subject, const Expr& with, const Machine*, bool ordered);
    void add(const Expr& subject, const Decimal& value, const Machine*, bool ordered);
    void add_operands(const Expr& subject, const Decimal& value, const Machine*, bool ordered);
    void add_beside(std::set<std::int64_t>& numbers, const Decimal& value, bool natural);
    void add_beyond(const Decimal& value);
    [[nodiscard]] TypeKind kind(const Expr& expr) const {
        return expr.type.is_valid() ? system_.type(expr.type).kind : TypeKind::unit;
    }

    /// A number that is added to a variable, or with which its values are compared by order.
    struct NumberOfVariable {
        const Machine* machine;
        VariableId variable;
        TypeKind kind;
        Decimal number;
    };

    const System& system_;
    const KnownValues& known_;
    Compared& result_;
    std::vector<NumberOfVariable> limits_, steps_;
    std::set<TypeKind> unlike_variables_;  // types with order comparisons of two values that can both change
    std::set<std::pair<TypeKind, TypeKind>> conversions_;  // the conversions of values that can change
    Decimals thresholds_;                                  // numbers with which reals are compared by order
};

void Comparisons::look_at(const Expr& expr, const Machine* machine) {
    const bool comparison = is_comparison(expr.kind) && expr.args.size() == 2;
    const bool among = expr.kind == ExprKind::is_in && expr.args.size() == 2;
    if (!comparison && !among) return;
    const Expr &left = *expr.args[0], &right = *expr.args[1];
    if (among) {
        const bool range = right.kind == ExprKind::range;
        if (!range && right.kind != ExprKind::set && right.kind != ExprKind::set_range) return;
        for (const ExprPtr& value : right.args)
            if (value) record_comparison(left, *value, machine, range);
        return;
    }
    if (reads_clock(left) || reads_clock(right)) return;
    const bool ordered = expr.kind != ExprKind::equal && expr.kind != ExprKind::not_equal;
    record_comparison(left, right, machine, ordered);
    record_comparison(right, left, machine, ordered);
}

/// Records the possible values of `with`, if they are known and the subject can change.
void Comparisons::record_comparison(const Expr& subject, const Expr& with, const Machine* machine, bool ordered) {
    const bool changes = known_.is_length(subject) || !known_.find_values(subject, machine);
    if (!changes) return;
    if (const auto values = known_.find_values(with, machine)) {
        for (const Decimal& value : *values) add(subject, value, machine, ordered);
    } else if (ordered) {
        unlike_variables_.insert(kind(subject));
    }
}

/// Records the values that the parts of the subject must have for the subject to reach both sides of `value`.
void Comparisons::add(const Expr& subject, const Decimal& value, const Machine* machine, bool ordered) {
    if (known_.is_length(subject) || known_.find_values(subject, machine)) return;
    const TypeKind type = kind(subject);
    if (type == TypeKind::nat)
        add_beside(result_.nat, value, true);
    else if (type == TypeKind::integer)
        add_beside(result_.integer, value, false);
    else if (type == TypeKind::real)
        add_beyond(value);
    else
        return;
    if (type == TypeKind::real && ordered) thresholds_.push_back(value);
    if (subject.kind == ExprKind::variable && ordered) limits_.push_back({machine, subject.variable, type, value});
    add_operands(subject, value, machine, ordered);
}

void Comparisons::look_at_assignment(const Stmt& stmt, const Machine& machine) {
    if (stmt.kind != StmtKind::assign || !stmt.path.empty()) return;
    const Expr* value = stmt.value.get();
    while (value->kind == ExprKind::cast) value = value->args[0].get();
    if (value->kind != ExprKind::plus && value->kind != ExprKind::minus) return;
    const Expr* counter = value->args[0].get();
    while (counter->kind == ExprKind::cast) counter = counter->args[0].get();
    if (counter->kind != ExprKind::variable || counter->variable != stmt.variable) return;
    const auto numbers = known_.find_values(*value->args[1], &machine);
    if (!numbers) return;
    for (const Decimal& number : *numbers)
        steps_.push_back(
            {&machine, stmt.variable, kind(*counter), value->kind == ExprKind::plus ? number : negate_decimal(number)});
}

void Comparisons::add_steps() {
    for (const NumberOfVariable& step : steps_) {
        for (const NumberOfVariable& limit : limits_) {
            const bool same = step.machine == limit.machine && step.variable == limit.variable;
            const auto beyond = add_decimals(limit.number, step.number);
            if (!same || !beyond) continue;
            if (step.kind == TypeKind::integer) result_.integer.insert(floor_of(*beyond));
            if (step.kind == TypeKind::nat && floor_of(*beyond) >= 0) result_.nat.insert(floor_of(*beyond));
        }
    }
}

void Comparisons::look_at_written(const Expr& value) {
    visit_operands(value, [&](const Expr& expr) {
        if (expr.kind != ExprKind::cast) return;
        const Expr& from = *expr.args[0];
        if (from.kind == ExprKind::variable || from.kind == ExprKind::trigger_value || from.kind == ExprKind::member)
            conversions_.emplace(kind(from), kind(expr));
    });
}

void Comparisons::add_converted() {
    const auto copy = [](const std::set<std::int64_t>& from, std::set<std::int64_t>& to, bool natural) {
        for (const std::int64_t number : from)
            if (!natural || number >= 0) to.insert(number);
    };
    if (conversions_.contains({TypeKind::integer, TypeKind::real})) copy(result_.real, result_.integer, false);
    if (conversions_.contains({TypeKind::nat, TypeKind::real})) copy(result_.real, result_.nat, true);
    if (conversions_.contains({TypeKind::nat, TypeKind::integer})) copy(result_.integer, result_.nat, true);
}

void Comparisons::add_operands(const Expr& subject, const Decimal& value, const Machine* machine, bool ordered) {
    const auto inverted = [&](const Expr& part, const std::optional<Decimal>& needed) {
        if (needed) add(part, *needed, machine, ordered);
    };
    const auto each_value = [&](std::size_t of, const auto& act) {
        if (const auto values = known_.find_values(*subject.args[of], machine))
            for (const Decimal& other : *values) act(*subject.args[1 - of], other);
    };
    const Decimal next = add_decimals(value, {1, 0}).value_or(value);
    if (subject.kind == ExprKind::cast) {
        inverted(*subject.args[0], value);
        if (kind(*subject.args[0]) == TypeKind::real) inverted(*subject.args[0], next);  // the cast rounds down
    } else if (subject.kind == ExprKind::negate) {
        inverted(*subject.args[0], negate_decimal(value));
    } else if (subject.kind == ExprKind::plus) {
        for (const std::size_t side : {0U, 1U})
            each_value(side, [&](const Expr& part, const Decimal& b) { inverted(part, subtract_decimals(value, b)); });
    } else if (subject.kind == ExprKind::minus) {
        each_value(1, [&](const Expr& part, const Decimal& b) { inverted(part, add_decimals(value, b)); });
        each_value(0, [&](const Expr& part, const Decimal& a) { inverted(part, subtract_decimals(a, value)); });
    } else if (subject.kind == ExprKind::times) {
        for (const std::size_t side : {0U, 1U})
            each_value(side, [&](const Expr& part, const Decimal& b) {
                inverted(part, divide_decimals(value, b));
                if (const auto down = divide_decimals(value, b)) inverted(part, add_decimals(*down, {1, 0}));
            });
    } else if (subject.kind == ExprKind::divide) {
        each_value(1, [&](const Expr& part, const Decimal& b) {
            inverted(part, multiply_decimals(value, b));
            inverted(part, multiply_decimals(next, b));
        });
    }
}

void Comparisons::add_beside(std::set<std::int64_t>& numbers, const Decimal& value, bool natural) {
    const std::int64_t down = floor_of(value);
    for (const auto number : {checked_subtract(down, is_whole(value) ? 1 : 0), checked_add(down, 1)})
        if (number && (!natural || *number >= 0)) numbers.insert(*number);
}

void Comparisons::add_beyond(const Decimal& value) {
    const std::int64_t down = floor_of(value);
    for (const auto number : {checked_subtract(down, is_whole(value) ? 1 : 0), checked_add(down, 1)})
        if (number) result_.real.insert(*number);
}

void Comparisons::add_extremes(const Literals& literals) {
    const auto extremes = [&](const std::set<std::int64_t>& written, std::set<std::int64_t>& numbers, bool natural) {
        if (written.empty()) return;
        add_beside(numbers, {*written.begin(), 0}, natural);
        add_beside(numbers, {*written.rbegin(), 0}, natural);
    };
    if (unlike_variables_.contains(TypeKind::nat)) extremes(literals.nat, result_.nat, true);
    if (unlike_variables_.contains(TypeKind::integer)) extremes(literals.integer, result_.integer, false);
    if (unlike_variables_.contains(TypeKind::real))
        for (const Decimal& value : literals.real) add_beyond(value);
}

/// Adds numbers between thresholds. The whole numbers around thresholds and all literals are already in the
/// carrier.
void Comparisons::add_between(const Literals& literals) {
    std::ranges::sort(thresholds_, is_less);
    for (std::size_t i = 1; i < thresholds_.size(); ++i) {
        const Decimal &low = thresholds_[i - 1], &high = thresholds_[i];
        if (!is_less(low, high)) continue;
        const Decimal whole{checked_add(floor_of(low), 1).value_or(floor_of(low)), 0};
        const auto inside = [&](const Decimal& value) { return is_less(low, value) && is_less(value, high); };
        if (inside(whole) || std::ranges::any_of(literals.real, inside)) continue;
        const auto both = align_decimals(low, high);
        const auto tenfold = both ? checked_multiply(both->left, 10) : std::nullopt;
        if (!tenfold) continue;
        if (both->right - both->left > 1)
            result_.between.push_back({both->left + (both->right - both->left) / 2, both->decimals});
        else if (both->decimals < 18)
            result_.between.push_back({*tenfold + 5, both->decimals + 1});
    }
}

}  // namespace

Compared compared_values(const System& system, const Chosen& chosen, const Literals& literals, std::int64_t longest) {
    Compared result;
    const KnownValues known(system, chosen, longest);
    Comparisons comparisons(system, known, result);
    const auto look_at = [&](const Expr& root, const Machine* machine) {
        visit_operands(root, [&](const Expr& expr) { comparisons.look_at(expr, machine); });
    };
    for (const Machine& machine : system.machines)
        visit_expressions(machine, [&](const Expr& root, ExprRole) { look_at(root, &machine); });
    for (const Function& function : system.functions)
        for (const auto* conditions : {&function.preconditions, &function.postconditions})
            for (const ExprPtr& condition : *conditions) look_at(*condition, nullptr);
    for (const Machine& machine : system.machines)
        visit_statements(machine, [&](const Stmt& stmt) {
            comparisons.look_at_assignment(stmt, machine);
            if (stmt.kind == StmtKind::assign && stmt.path.empty())
                comparisons.look_at_stored(stmt.value->type, machine.variables.at(stmt.variable.index).type);
            for (const ExprPtr& value : {stmt.value, stmt.communication.value})
                if (value) comparisons.look_at_written(*value);
            for (const ExprPtr& argument : stmt.args)
                if (argument) comparisons.look_at_written(*argument);
        });
    comparisons.add_steps();
    comparisons.add_extremes(literals);
    comparisons.add_converted();
    comparisons.add_between(literals);
    return result;
}

bool carriers_given(const System& system) {
    return std::ranges::any_of(system.csp_blocks, [](const CspBlock& block) {
        const auto defines = [&](const char* name) { return block.text.find(name) != std::string::npos; };
        return is_instantiations(block) && (defines("core_nat") || defines("core_int") || defines("core_real"));
    });
}

}  // namespace robochart::ir
