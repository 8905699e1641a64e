// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/linear.hpp"

#include <algorithm>
#include <iterator>
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
constexpr std::size_t most_forms = 256;
constexpr std::size_t most_means = 1'000'000;
constexpr std::int64_t most_turns = 16;  ///< limit on the jumps of a remainder within a period

/// Returns the determinant of a matrix with at most three rows.
Wide determinant(const std::vector<std::vector<Wide>>& m) {
    if (m.size() == 1) return m[0][0];
    if (m.size() == 2) return m[0][0] * m[1][1] - m[0][1] * m[1][0];
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Calls the function for each choice of `count` numbers below `size`, in ascending order. With `repeat`, the same
/// number may occur several times in a choice.
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
    reader_.emplace(system_, scale_, closed, [this](const Expr& part) { return read_part(part); });
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

void LinearConditions::insert_form(const LinearForm& form) {
    if (std::ranges::find(forms_, form) == forms_.end()) forms_.push_back(form);
}

bool LinearConditions::add_comparison(const Expr& left, const Expr& right) {
    const auto a = reader_->read(left), b = reader_->read(right);
    if (!a || !b) return false;
    for (const LinearForm& one : *a)
        for (const LinearForm& other : *b) {
            const auto difference = add_multiple(one, other, -1);
            if (!difference) return false;
            insert_form(*difference);
        }
    return forms_.size() <= most_forms;
}

/// Adds a test of membership in a list of numbers, or, for a whole number, in the range between two bounds.
bool LinearConditions::add_membership(const Expr& condition) {
    const Expr& number = *condition.args.at(0);
    const Expr& set = *condition.args.at(1);
    const bool bounds = set.kind == ExprKind::range || set.kind == ExprKind::set_range;
    if (set.kind != ExprKind::set && (!bounds || system_.type(number.type).kind == TypeKind::real)) return false;
    return std::ranges::all_of(set.args,
                               [&](const ExprPtr& member) { return !member || add_comparison(number, *member); });
}

LinearReader::Forms LinearConditions::read_component(const Expr& expr) {
    NumberPart component;
    component.kind = system_.type(expr.type).kind;
    if (component.kind != TypeKind::real && component.kind != TypeKind::integer && component.kind != TypeKind::nat)
        return std::nullopt;
    const Expr* at = &expr;
    for (; at->kind == ExprKind::member; at = at->args.at(0).get()) {
        const bool record = system_.type(at->args.at(0)->type).kind == TypeKind::record;
        component.path.insert(component.path.begin(), static_cast<std::size_t>(at->number) - (record ? 0 : 1));
    }
    if (at->kind != ExprKind::variable && at->kind != ExprKind::trigger_value) return std::nullopt;
    is_periodic_ = is_periodic_ && remainders_open_ > 0;
    return std::set{LinearForm{{{index_of(component), 1}}, 0}};
}

std::size_t LinearConditions::index_of(const NumberPart& component) {
    auto found = std::ranges::find(components_, component);
    if (found == components_.end()) found = components_.insert(components_.end(), component);
    return static_cast<std::size_t>(found - components_.begin());
}

bool LinearConditions::add_form(const std::map<NumberPart, std::int64_t>& coefficients, std::int64_t constant) {
    LinearForm form{{}, constant};
    if (constant >= greatest_coordinate || constant <= -greatest_coordinate) return false;
    for (const auto& [component, coefficient] : coefficients) {
        if (coefficient >= greatest_coefficient || coefficient <= -greatest_coefficient) return false;
        if (coefficient != 0) form.coefficients[index_of(component)] = coefficient;
    }
    insert_form(form);
    return true;
}

std::vector<std::pair<std::map<NumberPart, std::int64_t>, std::int64_t>> LinearConditions::forms() const {
    std::vector<std::pair<std::map<NumberPart, std::int64_t>, std::int64_t>> result;
    for (const LinearForm& form : forms_) {
        if (form.coefficients.empty()) continue;
        auto& shown = result.emplace_back(std::map<NumberPart, std::int64_t>(), form.constant);
        for (const auto& [component, coefficient] : form.coefficients)
            shown.first.emplace(components_[component], coefficient);
    }
    return result;
}

/// Returns the signs of the forms at a point. For nat and int, coordinates are whole numbers and not units.
std::vector<int> LinearConditions::signs_at(const Point& point) const {
    Point units = point;
    for (std::size_t i = 0; i < units.size(); ++i)
        if (components_[i].kind != TypeKind::real) units[i] *= scale_;
    return signs(units);
}

LinearReader::Forms LinearConditions::read_choice(const Expr& expr) {
    if (!add_condition(*expr.args.at(0))) return std::nullopt;
    auto result = reader_->read(*expr.args.at(1));
    const auto otherwise = reader_->read(*expr.args.at(2));
    if (!result || !otherwise) return std::nullopt;
    result->insert(otherwise->begin(), otherwise->end());
    return result;
}

/// Returns the forms of the remainder of a form in one number x, for 0 <= x < period. The remainder starts again at 0
/// wherever the form is a multiple of the period.
LinearReader::Forms LinearConditions::remainders(const LinearForm& dividend) {
    if (dividend.coefficients.size() > 1) return std::nullopt;
    std::int64_t coefficient = 0;
    if (!dividend.coefficients.empty()) coefficient = dividend.coefficients.begin()->second;
    const auto turns = floor_divide(dividend.constant, *period_);
    if (!turns || coefficient > most_turns || coefficient < -most_turns) return std::nullopt;
    std::set<LinearForm> result;
    const std::int64_t first = *turns + std::min<std::int64_t>(coefficient, 0);
    const std::int64_t last = *turns + std::max<std::int64_t>(coefficient, 0) + 1;
    for (std::int64_t turn = first; turn <= last; ++turn) {
        const auto form = add_multiple(dividend, {{}, *period_}, -turn);
        if (!form) return std::nullopt;
        insert_form(*form);
        result.insert(*form);
    }
    return result;
}

LinearReader::Forms LinearConditions::read_remainder(const Expr& expr) {
    const auto divisor = reader_->read_closed(*expr.args.at(1));
    if (!divisor || divisor->constant <= 0 || system_.type(expr.type).kind == TypeKind::nat) return std::nullopt;
    if (period_ && *period_ != divisor->constant) return std::nullopt;
    period_ = divisor->constant;
    ++remainders_open_;
    const auto dividends = reader_->read(*expr.args.at(0));
    --remainders_open_;
    if (!dividends) return std::nullopt;
    std::set<LinearForm> result;
    for (const LinearForm& dividend : *dividends) {
        const auto forms = remainders(dividend);
        if (!forms) return std::nullopt;
        result.insert(forms->begin(), forms->end());
    }
    return result;
}

LinearReader::Forms LinearConditions::read_part(const Expr& expr) {
    if (expr.kind == ExprKind::if_then_else) return read_choice(expr);
    if (expr.kind == ExprKind::modulus) return read_remainder(expr);
    return read_component(expr);
}

std::vector<int> LinearConditions::signs(const Point& point) const {
    std::vector<int> result;
    for (const LinearForm& form : forms_) {
        Wide sum = form.constant;
        for (const auto& [component, coefficient] : form.coefficients)
            sum += static_cast<Wide>(coefficient) * point[component];
        result.push_back(sum > 0 ? 1 : sum < 0 ? -1 : 0);
    }
    return result;
}

/// Returns the points at which n of the hyperplanes intersect, where n is the number of components.
std::optional<std::vector<Point>> LinearConditions::vertices(const std::vector<LinearForm>& forms) const {
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

/// Returns the hyperplanes of the conditions. Adds a box that contains all their intersections.
std::optional<std::vector<LinearForm>> LinearConditions::with_box() const {
    std::vector<LinearForm> forms;
    for (const LinearForm& form : forms_)
        if (!form.coefficients.empty()) forms.push_back(form);
    std::vector<LinearForm> axes = forms;
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

/// Finds points for conditions that read one whole number. Tries the numbers near each threshold. Returns up to `count`
/// numbers for each combination of signs. If a region has fewer than `beside` numbers, all of them are near a
/// threshold, so none is missed.
std::optional<std::vector<Point>> LinearConditions::whole_points(std::int64_t beside, std::size_t count) const {
    if (components_.size() != 1) return std::nullopt;
    std::set<std::int64_t> numbers;
    for (std::int64_t number = 0; number < beside; ++number) numbers.insert(number);
    for (const LinearForm& form : forms_) {
        if (form.coefficients.empty()) continue;
        const auto down = floor_divide(-form.constant, form.coefficients.begin()->second);
        if (!down) return std::nullopt;
        const std::int64_t whole = *floor_divide(*down, scale_);
        for (std::int64_t number = whole - beside; number <= whole + beside + 1; ++number) numbers.insert(number);
    }
    std::vector<Point> result;
    std::map<std::vector<int>, std::size_t> known;
    for (const std::int64_t number : numbers) {
        const bool exists = components_[0].kind == TypeKind::integer || number >= 0;
        const auto units = checked_multiply(number, scale_);
        if (!units) return std::nullopt;
        if (exists && ++known[signs({*units})] <= count) result.push_back({number});
    }
    return result;
}

/// Returns true if the equations of a region have exactly one solution.
bool LinearConditions::is_only_point(const std::vector<int>& signs) const {
    const std::size_t n = components_.size();
    std::vector<std::vector<Wide>> equations;
    for (std::size_t f = 0; f < forms_.size(); ++f) {
        if (signs[f] != 0 || forms_[f].coefficients.empty()) continue;
        std::vector<Wide>& row = equations.emplace_back(n, 0);
        for (const auto& [component, coefficient] : forms_[f].coefficients) row[component] = coefficient;
    }
    bool independent = false;
    visit_choices(equations.size(), n, false, [&](const std::vector<std::size_t>& choice) {
        instantiation_.poll();
        std::vector<std::vector<Wide>> rows;
        for (const std::size_t row : choice) rows.push_back(equations[row]);
        independent = independent || determinant(rows) != 0;
    });
    return independent;
}

/// Finds further points in the region of `first`. A region is convex, so it contains the midpoint between one of its
/// points and a corner of its closure. Returns no value if fewer than `count` of these midpoints are decimal
/// numbers.
std::optional<std::vector<Point>> LinearConditions::fill_region(Point first, const std::vector<Point>& corners,
                                                                std::size_t count) const {
    const std::vector<int> region = signs(first);
    std::vector<Point> result{std::move(first)};
    if (is_only_point(region)) return result;
    for (std::size_t from = 0; from < result.size() && result.size() < count; ++from) {
        for (std::size_t c = 0; c < corners.size() && result.size() < count; ++c) {
            instantiation_.poll();
            Point middle;
            bool exact = true;
            for (std::size_t i = 0; i < components_.size(); ++i) {
                const std::int64_t sum = result[from][i] + corners[c][i];
                exact = exact && sum % 2 == 0;
                middle.push_back(sum / 2);
            }
            if (exact && signs(middle) == region && std::ranges::find(result, middle) == result.end())
                result.push_back(std::move(middle));
        }
    }
    if (result.size() < count) return std::nullopt;
    return result;
}

std::optional<std::vector<Point>> LinearConditions::points_in_regions(std::size_t count) const {
    if (period_ || components_.empty() || components_.size() > most_components) return std::nullopt;
    const auto is_whole = [](const NumberPart& component) { return component.kind != TypeKind::real; };
    if (std::ranges::any_of(components_, is_whole)) return whole_points(static_cast<std::int64_t>(count), count);
    const auto first_points = real_points();
    const auto forms = with_box();
    const auto corners = forms ? vertices(*forms) : std::nullopt;
    if (!first_points || !corners) return std::nullopt;
    std::vector<Point> result;
    for (const Point& first : *first_points) {
        auto points = fill_region(first, *corners, count);
        if (!points) return std::nullopt;
        std::ranges::move(*points, std::back_inserter(result));
    }
    return result;
}

std::optional<std::vector<Point>> LinearConditions::all_points() const {
    if (components_.size() > most_components) return std::nullopt;
    if (components_.empty()) return std::vector<Point>{{}};
    const bool whole =
        std::ranges::any_of(components_, [](const NumberPart& component) { return component.kind != TypeKind::real; });
    if (whole) return whole_points(1, 1);
    return real_points();
}

std::optional<std::vector<Point>> LinearConditions::points() const {
    if (!period_) return all_points();
    if (components_.size() != 1 || !is_periodic_) return std::nullopt;
    std::int64_t unit = scale_;
    if (components_[0].kind == TypeKind::real) unit = 1;
    if (*period_ % unit != 0) return std::nullopt;  // the period is not a whole number of steps
    LinearConditions within = *this;
    within.insert_form({{{0, 1}}, 0});
    within.insert_form({{{0, 1}}, -*period_});
    auto result = within.all_points();
    if (!result) return result;
    std::vector<Point> small;  // reports show the first point of a region, so small numbers come first
    for (std::int64_t number = 0; number < 10; ++number) small.push_back({number * (scale_ / unit)});
    result->insert(result->begin(), small.begin(), small.end());
    std::erase_if(*result, [&](const Point& point) { return point[0] < 0 || point[0] >= *period_ / unit; });
    return result;
}

}  // namespace robochart::ir
