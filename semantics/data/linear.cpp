// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/linear.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "semantics/ir/arithmetic.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

using Point = std::vector<std::int64_t>;
__extension__ using Wide = __int128;

constexpr std::size_t most_components = 3;
constexpr std::size_t most_means = 1'000'000;
/// Constants and coordinates stay below 2^56 and coefficients below 2^20, so that determinants of three rows, which are
/// sums of six products, and sums of three products fit into 128 bits.
constexpr std::int64_t greatest_coordinate = std::int64_t{1} << 56U;
constexpr std::int64_t greatest_coefficient = std::int64_t{1} << 20U;

/// sum + number * factor; no value if it is not between -limit and limit.
std::optional<std::int64_t> add_product(std::int64_t sum, std::int64_t number, std::int64_t factor,
                                        std::int64_t limit) {
    const auto product = checked_multiply(number, factor);
    const auto total = product ? checked_add(sum, *product) : std::nullopt;
    const bool fits = total && *total > -limit && *total < limit;
    return fits ? total : std::nullopt;
}

/// The determinant of a matrix with at most three rows.
Wide determinant(const std::vector<std::vector<Wide>>& m) {
    if (m.size() == 1) return m[0][0];
    if (m.size() == 2) return m[0][0] * m[1][1] - m[0][1] * m[1][0];
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Calls the function for every choice of `count` numbers below `size`, in ascending order; with repetition if
/// `repeat`.
template <class Visit>
void visit_choices(std::size_t size, std::size_t count, bool repeat, const Visit& visit) {
    std::vector<std::size_t> choice;
    const auto extend = [&](const auto& self, std::size_t from) -> void {
        if (choice.size() == count) {
            visit(choice);
            return;
        }
        for (std::size_t i = from; i < size; ++i) {
            choice.push_back(i);
            self(self, repeat ? i : i + 1);
            choice.pop_back();
        }
    };
    extend(extend, 0);
}

bool too_many_choices(std::size_t size, std::size_t count) {
    double choices = 1;
    for (std::size_t i = 0; i < count; ++i) choices *= static_cast<double>(size);
    return choices > static_cast<double>(most_means);
}

}  // namespace

bool LinearConditions::add(const Expr& condition, const ClosedValue& closed) {
    closed_ = closed;
    return add_condition(condition);
}

bool LinearConditions::add_condition(const Expr& condition) {
    if (condition.kind == ExprKind::boolean) return true;
    if (is_connective(condition.kind))
        return std::ranges::all_of(condition.args, [&](const ExprPtr& part) { return part && add_condition(*part); });
    if (is_comparison(condition.kind) && condition.args.size() == 2)
        return add_comparison(*condition.args[0], *condition.args[1]);
    return condition.kind == ExprKind::is_in && add_membership(condition);
}

bool LinearConditions::add_comparison(const Expr& left, const Expr& right) {
    const auto a = read_form(left), b = read_form(right);
    const auto difference = a && b ? combine(*a, *b, -1) : std::nullopt;
    if (!difference) return false;
    if (std::ranges::find(forms_, *difference) == forms_.end()) forms_.push_back(*difference);
    return true;
}

/// A set of numbers, or of all whole numbers between two bounds for a whole number.
bool LinearConditions::add_membership(const Expr& condition) {
    const Expr& number = *condition.args.at(0);
    const Expr& set = *condition.args.at(1);
    const bool bounds = set.kind == ExprKind::range || set.kind == ExprKind::set_range;
    if (set.kind != ExprKind::set && (!bounds || system_.type(number.type).kind == TypeKind::real)) return false;
    return std::ranges::all_of(set.args,
                               [&](const ExprPtr& member) { return !member || add_comparison(number, *member); });
}

std::optional<LinearConditions::Form> LinearConditions::combine(const Form& a, const Form& b, std::int64_t factor) {
    Form result = a;
    const auto constant = add_product(a.constant, b.constant, factor, greatest_coordinate);
    if (!constant) return std::nullopt;
    result.constant = *constant;
    for (const auto& [component, coefficient] : b.coefficients) {
        const auto sum = add_product(result.coefficients[component], coefficient, factor, greatest_coefficient);
        if (!sum) return std::nullopt;
        result.coefficients[component] = *sum;
        if (*sum == 0) result.coefficients.erase(component);
    }
    return result;
}

std::optional<LinearConditions::Form> LinearConditions::read_closed(const Expr& expr) const {
    const TypeKind kind = system_.type(expr.type).kind;
    if (kind != TypeKind::real && kind != TypeKind::integer && kind != TypeKind::nat) return std::nullopt;
    const auto value = closed_(expr);
    if (!value) return std::nullopt;
    const auto units = kind == TypeKind::real ? std::optional(value->number) : checked_multiply(value->number, scale_);
    if (!units || *units >= greatest_coordinate || *units <= -greatest_coordinate) return std::nullopt;
    return Form{{}, *units};
}

std::optional<LinearConditions::Form> LinearConditions::read_component(const Expr& expr) {
    Component component;
    component.kind = system_.type(expr.type).kind;
    if (component.kind != TypeKind::real && component.kind != TypeKind::integer && component.kind != TypeKind::nat)
        return std::nullopt;
    const Expr* at = &expr;
    for (; at->kind == ExprKind::member; at = at->args.at(0).get()) {
        const bool record = system_.type(at->args.at(0)->type).kind == TypeKind::record;
        component.path.insert(component.path.begin(), static_cast<std::size_t>(at->number) - (record ? 0 : 1));
    }
    if (at->kind != ExprKind::variable && at->kind != ExprKind::trigger_value) return std::nullopt;
    auto found = std::ranges::find(components_, component);
    if (found == components_.end()) found = components_.insert(components_.end(), component);
    return Form{{{static_cast<std::size_t>(found - components_.begin()), 1}}, 0};
}

std::optional<LinearConditions::Form> LinearConditions::read_form(const Expr& expr) {
    if (auto closed = read_closed(expr)) return closed;
    const auto operand = [&](std::size_t i) { return read_form(*expr.args.at(i)); };
    const auto combined = [&](std::int64_t factor) -> std::optional<Form> {
        const auto a = operand(0), b = operand(1);
        return a && b ? combine(*a, *b, factor) : std::nullopt;
    };
    if (expr.kind == ExprKind::plus) return combined(1);
    if (expr.kind == ExprKind::minus) return combined(-1);
    if (expr.kind == ExprKind::negate) {
        const auto a = operand(0);
        return a ? combine({}, *a, -1) : std::nullopt;
    }
    if (expr.kind == ExprKind::cast && system_.type(expr.type).kind == TypeKind::real) return operand(0);
    if (expr.kind != ExprKind::times) return read_component(expr);
    for (const std::size_t side : {0U, 1U}) {
        const auto factor = read_closed(*expr.args.at(side));
        const auto other = factor ? operand(1 - side) : std::nullopt;
        if (other && factor->constant % scale_ == 0) return combine({}, *other, factor->constant / scale_);
    }
    return std::nullopt;
}

std::vector<int> LinearConditions::signs(const Point& point) const {
    std::vector<int> result;
    for (const Form& form : forms_) {
        Wide sum = form.constant;
        for (const auto& [component, coefficient] : form.coefficients)
            sum += static_cast<Wide>(coefficient) * point[component];
        result.push_back(sum > 0 ? 1 : sum < 0 ? -1 : 0);
    }
    return result;
}

/// The intersections of as many hyperplanes as there are components.
std::optional<std::vector<Point>> LinearConditions::vertices(const std::vector<Form>& forms) const {
    const std::size_t n = components_.size();
    if (too_many_choices(forms.size(), n)) return std::nullopt;
    std::set<Point> found;
    bool exact = true;
    visit_choices(forms.size(), n, false, [&](const std::vector<std::size_t>& choice) {
        instantiation_.poll();
        std::vector<std::vector<Wide>> rows(n, std::vector<Wide>(n, 0));
        for (std::size_t r = 0; r < n; ++r)
            for (const auto& [component, coefficient] : forms[choice[r]].coefficients) rows[r][component] = coefficient;
        const Wide whole = determinant(rows);
        if (whole == 0) return;
        Point point;
        for (std::size_t column = 0; column < n; ++column) {
            auto replaced = rows;
            for (std::size_t r = 0; r < n; ++r) replaced[r][column] = -static_cast<Wide>(forms[choice[r]].constant);
            const Wide part = determinant(replaced);
            exact = exact && part % whole == 0 && part / whole < greatest_coordinate &&
                    part / whole > -static_cast<Wide>(greatest_coordinate);
            point.push_back(static_cast<std::int64_t>(part / whole));
        }
        found.insert(point);
    });
    if (!exact) return std::nullopt;
    return std::vector<Point>(found.begin(), found.end());
}

/// The hyperplanes of the conditions, and those of a box around all their intersections.
std::optional<std::vector<LinearConditions::Form>> LinearConditions::with_box() const {
    std::vector<Form> forms;
    for (const Form& form : forms_)
        if (!form.coefficients.empty()) forms.push_back(form);
    std::vector<Form> axes = forms;
    for (std::size_t i = 0; i < components_.size(); ++i) axes.push_back({{{i, 1}}, 0});
    const auto inside = vertices(axes);
    if (!inside) return std::nullopt;
    std::int64_t greatest = 0;
    for (const Point& point : *inside)
        for (const std::int64_t coordinate : point)
            greatest = std::max(greatest, coordinate < 0 ? -coordinate : coordinate);
    const std::int64_t edge = (greatest / scale_ + 2) * scale_;
    for (std::size_t i = 0; i < components_.size(); ++i)
        for (const std::int64_t side : {edge, -edge}) forms.push_back({{{i, 1}}, side});
    return forms;
}

std::optional<std::vector<Point>> LinearConditions::real_points() const {
    const std::size_t n = components_.size();
    const auto forms = with_box();
    const auto corners = forms ? vertices(*forms) : std::nullopt;
    if (!corners || too_many_choices(corners->size(), n + 1)) return std::nullopt;
    const std::int64_t parts = n == 1 ? 2 : 4;  // the first vertex has the weight that the others leave
    std::vector<Point> result;
    std::set<std::vector<int>> known;
    bool exact = true;
    const auto take = [&](Point point) {
        if (known.insert(signs(point)).second) result.push_back(std::move(point));
    };
    for (const Point& corner : *corners) take(corner);
    visit_choices(corners->size(), n + 1, true, [&](const std::vector<std::size_t>& choice) {
        instantiation_.poll();
        Point mean;
        for (std::size_t i = 0; i < n; ++i) {
            Wide sum = static_cast<Wide>((*corners)[choice[0]][i]) * (parts - static_cast<std::int64_t>(n));
            for (std::size_t c = 1; c <= n; ++c) sum += (*corners)[choice[c]][i];
            exact = exact && sum % parts == 0;
            mean.push_back(static_cast<std::int64_t>(sum / parts));
        }
        take(std::move(mean));
    });
    if (!exact) return std::nullopt;
    return result;
}

/// For one whole number: the numbers at and beside every threshold.
std::optional<std::vector<Point>> LinearConditions::whole_points() const {
    if (components_.size() != 1) return std::nullopt;
    std::set<std::int64_t> numbers{0};
    for (const Form& form : forms_) {
        if (form.coefficients.empty()) continue;
        const auto down = floor_divide(-form.constant, form.coefficients.begin()->second);
        if (!down) return std::nullopt;
        const std::int64_t whole = *floor_divide(*down, scale_);
        for (const std::int64_t beside : {-1, 0, 1, 2}) numbers.insert(whole + beside);
    }
    std::vector<Point> result;
    std::set<std::vector<int>> known;
    for (const std::int64_t number : numbers) {
        const bool exists = components_[0].kind == TypeKind::integer || number >= 0;
        const auto units = checked_multiply(number, scale_);
        if (!units) return std::nullopt;
        if (exists && known.insert(signs({*units})).second) result.push_back({number});
    }
    return result;
}

std::optional<std::vector<Point>> LinearConditions::points() const {
    if (components_.size() > most_components) return std::nullopt;
    if (components_.empty()) return std::vector<Point>{{}};
    const bool whole =
        std::ranges::any_of(components_, [](const Component& component) { return component.kind != TypeKind::real; });
    return whole ? whole_points() : real_points();
}

}  // namespace robochart::ir
