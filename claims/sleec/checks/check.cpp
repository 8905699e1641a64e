// SPDX-License-Identifier: Apache-2.0
// See check.hpp.
#include "claims/sleec/checks/check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/diagnostics/spelling.hpp"
#include "claims/sleec/checks/rules.hpp"
#include "claims/sleec/syntax/printer.hpp"
#include "claims/sleec/syntax/rules.hpp"

namespace robochart::sleec {
namespace {

/// The type of a part of a condition. The scale of a `literal` is determined by the other side of the comparison.
enum class Type { truth, number, scale, literal, wrong };

const char* type_text(Type type) {
    if (type == Type::truth) return "true or false";
    return type == Type::number ? "a number" : "a value of a scale";
}

struct Typed {
    Condition condition;
    Type type = Type::wrong;
};

class Checker {
public:
    Checker(const RuleFile& file, diagnostics::Diagnostics& diagnostics, durations::Unit unit)
        : diagnostics_(diagnostics),
          result_{std::make_shared<const RuleFile>(file), {}, {}, file.measures, {}, {}, {}, unit},
          file_(*result_.file) {}

    std::optional<CheckedRules> run() {
        declare();
        find_cases();
        for (const Rule& rule : file_.rules) result_.rules.push_back(check_clause(rule));
        for (const Property& concern : file_.concerns) result_.concerns.push_back(check_clause(concern));
        for (const Property& purpose : file_.purposes) result_.purposes.push_back(check_clause(purpose));
        check_mappings();
        if (!diagnostics_.ok()) return std::nullopt;
        return std::move(result_);
    }

private:
    // names

    void declare() {
        for (std::size_t i = 0; i < file_.events.size(); ++i) declare(file_.events[i].name, events_, i);
        for (std::size_t i = 0; i < file_.measures.size(); ++i) {
            const Measure& measure = file_.measures[i];
            declare(measure.name, measures_, i);
            std::set<std::string> own;
            for (const Name& literal : measure.literals) {
                literals_.insert(literal.text);
                if (!own.insert(literal.text).second)
                    diagnostics_.report(rules::declared_twice, literal.span, {literal.text});
            }
        }
        for (std::size_t i = 0; i < file_.constants.size(); ++i) declare(file_.constants[i].name, constants_, i);
        for (const Constant& constant : file_.constants) refuse_circle(constant);
        std::map<std::string, Span> named;
        for (const Rule& rule : file_.rules) {
            const auto [first, added] = named.emplace(rule.name.text, rule.name.span);
            if (added) continue;
            auto& finding = diagnostics_.report(rules::rule_named_twice, rule.name.span, {rule.name.text});
            finding.notes.push_back({first->second, "the other one"});
        }
    }

    void declare(const Name& name, std::map<std::string, std::size_t>& table, std::size_t index) {
        if (const auto [first, added] = declared_.emplace(name.text, name.span); !added) {
            auto& finding = diagnostics_.report(rules::declared_twice, name.span, {name.text});
            finding.notes.push_back({first->second, "declared here too"});
            return;
        }
        table.emplace(name.text, index);
    }

    [[nodiscard]] std::string kind_of(const std::string& name) const {
        if (events_.contains(name)) return "an event";
        if (measures_.contains(name)) return "a measure";
        if (constants_.contains(name)) return "a constant";
        return literals_.contains(name) ? "a value of a scale" : "";
    }

    /// Reports that a name is not of the required kind, with the nearest name that is.
    void not_found(const std::string& name, Span span, const std::string& kind,
                   std::initializer_list<const std::map<std::string, std::size_t>*> tables) {
        if (const std::string other = kind_of(name); !other.empty()) {
            diagnostics_.report(rules::wrong_kind, span, {name, other, kind});
            return;
        }
        std::vector<std::string> names;
        for (const auto* table : tables)
            for (const auto& [declared, index] : *table) names.push_back(declared);
        const std::string noun = kind.substr(kind.find(' ') + 1);
        auto& finding = diagnostics_.report(rules::unknown_name, span, {noun, name});
        const std::string meant = diagnostics::nearest_spelling(name, names);
        if (!meant.empty())
            finding.fixes.push_back(
                {span, meant, diagnostics::suggestion_verb(diagnostics::is_certain(name, meant, names))});
        else if (kind == "a measure")
            finding.notes.push_back({{}, fmt::format("write `in {}` if it is a state of the model", name)});
    }

    // events

    /// Finds the values that rules give to arguments, then the cases of each event.
    void find_cases() {
        result_.arguments.resize(file_.events.size());
        first_use_.resize(file_.events.size());
        for (const Rule& rule : file_.rules) note_events(rule.trigger, rule.response);
        for (const auto* properties : {&file_.concerns, &file_.purposes})
            for (const Property& property : *properties) {
                note_events(property.trigger, property.response);
                if (property.during) note_arguments(property.during->event);
            }
        for (std::size_t i = 0; i < file_.events.size(); ++i) add_cases(i, {});
    }

    void note_events(const Trigger& trigger, const ResponsePtr& response) {
        note_arguments(trigger.event);
        note_events(response);
    }
    void note_events(const ResponsePtr& response) {
        if (!response) return;
        note_arguments(response->event);
        note_events(response->otherwise);
        for (const Defeater& defeater : response->defeaters) {
            if (defeater.event) note_arguments(*defeater.event);
            note_events(defeater.response);
        }
    }

    void note_arguments(const EventName& event) {
        const auto found = events_.find(event.text);
        if (found == events_.end()) return;  // reported where it is resolved
        if (!event.arguments) return;        // any values
        std::vector<Argument>& places = result_.arguments[found->second];
        const std::size_t count = event.arguments->size();
        if (first_use_[found->second] == nullptr) {
            first_use_[found->second] = &event;
            places.resize(count);
        }
        if (count != places.size()) return report_count(event, places.size(), *first_use_[found->second]);
        for (std::size_t i = 0; i < count; ++i) note_argument(*(*event.arguments)[i], places[i]);
    }

    void report_count(const EventName& event, std::size_t expected, const Name& other) {
        auto& finding = diagnostics_.report(
            rules::wrong_arguments, event.span,
            {fmt::format("'{0}' has {1} argument{2} here and {3} in another place: write `{0}` or `_` for any value",
                         event.text, event.arguments->size(), event.arguments->size() == 1 ? "" : "s", expected)});
        finding.notes.push_back({other.span, "the other place"});
    }

    void note_argument(const Expr& written, Argument& place) {
        const std::string value = argument_value(written);
        if (value.empty()) return;
        if (written.op == Op::name && measures_.contains(written.text))
            diagnostics_.report(rules::wrong_kind, written.span,
                                {written.text, "a measure", "a value: an argument is a value of the model, or `_`"});
        const ArgumentKind kind = argument_kind(written);
        if (place.kind == ArgumentKind::any) place.kind = kind;
        if (place.kind != kind)
            diagnostics_.report(rules::wrong_arguments, written.span,
                                {fmt::format("'{}' is {}, but this argument is {} in another place", written.text,
                                             kind_text(kind), kind_text(place.kind))});
        if (kind == ArgumentKind::truth)
            place.values = {"false", "true"};
        else if (std::ranges::find(place.values, value) == place.values.end())
            place.values.push_back(value);
    }
    [[nodiscard]] ArgumentKind argument_kind(const Expr& written) const {
        if (written.op == Op::truth) return ArgumentKind::truth;
        const bool number = written.op == Op::number || constants_.contains(written.text);
        return number ? ArgumentKind::number : ArgumentKind::literal;
    }
    static const char* kind_text(ArgumentKind kind) {
        if (kind == ArgumentKind::truth) return "true or false";
        return kind == ArgumentKind::number ? "a number" : "a literal";
    }
    /// Returns the text of the value; "" for `_`.
    std::string argument_value(const Expr& written) {
        if (written.op == Op::truth) return written.text;
        if (written.op == Op::number) return fmt::format("{}", std::stoll(written.text));
        if (written.text == "_") return "";
        if (const auto constant = constants_.find(written.text); constant != constants_.end())
            return fmt::format("{}", constant_value(file_.constants[constant->second].value));
        return written.text.substr(written.text.rfind(':') + 1);
    }

    /// Adds all cases of an event that begin with these values.
    void add_cases(std::size_t event, std::vector<std::string> values) {
        constexpr std::size_t most_cases = 256;
        const std::vector<Argument>& places = result_.arguments[event];
        if (values.size() == places.size()) {
            first_case_.try_emplace(event, result_.events.size());
            if (result_.events.size() - first_case_[event] == most_cases)
                diagnostics_.report(rules::wrong_arguments, first_use_[event]->span,
                                    {fmt::format("'{}' has more than {} combinations of arguments: name fewer values",
                                                 file_.events[event].name.text, most_cases)});
            if (result_.events.size() - first_case_[event] > most_cases) return;
            result_.events.push_back({event, values, case_text(event, values)});
            return;
        }
        const Argument& place = places[values.size()];
        values.emplace_back();
        for (const std::string& value : place.values) {
            values.back() = value;
            add_cases(event, values);
        }
        values.back() = "";
        if (place.kind != ArgumentKind::truth) add_cases(event, values);
    }
    [[nodiscard]] std::string case_text(std::size_t event, const std::vector<std::string>& values) const {
        const std::string& name = file_.events[event].name.text;
        if (values.empty()) return name;
        std::vector<std::string> shown;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::string other = result_.arguments[event][i].values.empty() ? "_" : "other";
            shown.push_back(values[i].empty() ? other : values[i]);
        }
        return fmt::format("{}({})", name, fmt::join(shown, ", "));
    }

    EventCases find_event(const EventName& name) {
        const auto found = events_.find(name.text);
        if (found == events_.end()) {
            not_found(name.text, name.span, "an event", {&events_});
            return 0;
        }
        std::vector<std::string> values(result_.arguments[found->second].size());
        if (name.arguments && name.arguments->size() != values.size()) return 0;  // reported
        for (std::size_t i = 0; name.arguments && i < values.size(); ++i)
            values[i] = argument_value(*(*name.arguments)[i]);
        std::vector<std::size_t> cases;
        for (std::size_t i = 0; i < result_.events.size(); ++i)
            if (result_.events[i].declared == found->second && fits(values, result_.events[i].values))
                cases.push_back(i);
        return cases.empty() ? EventCases() : EventCases(std::move(cases));
    }
    static bool fits(const std::vector<std::string>& written, const std::vector<std::string>& values) {
        return std::ranges::equal(written, values, [](const std::string& pattern, const std::string& value) {
            return pattern.empty() || pattern == value;
        });
    }

    void check_mappings() {
        for (const Mapping& mapping : file_.mappings)
            if (!events_.contains(mapping.name.text) && !measures_.contains(mapping.name.text))
                not_found(mapping.name.text, mapping.name.span, "an event or measure", {&events_, &measures_});
    }

    // numbers

    /// Reports constants that are defined in terms of each other in a cycle. The cycle is reported once, at its first
    /// constant.
    void refuse_circle(const Constant& constant) {
        std::set<std::string> seen{constant.name.text};
        const Expr* at = constant.value.get();
        for (auto found = constants_.find(at->text); at->op == Op::name && found != constants_.end();
             found = constants_.find(at->text)) {
            if (!seen.insert(at->text).second) {
                if (at->text == constant.name.text && circles_.insert(at->text).second)
                    diagnostics_.report(rules::circular_constant, constant.value->span, {constant.name.text});
                circles_.insert(seen.begin(), seen.end());
                return;
            }
            at = file_.constants[found->second].value.get();
        }
        if (at == constant.value.get() && at->op == Op::name) (void)constant_value(constant.value);
    }

    /// Returns the value of a number or a constant.
    std::int64_t constant_value(const ExprPtr& expr) {
        std::set<std::string> seen;
        const Expr* at = expr.get();
        while (at->op == Op::name) {
            const auto found = constants_.find(at->text);
            if (found == constants_.end()) {
                not_found(at->text, at->span, "a constant", {&constants_});
                return 0;
            }
            if (!seen.insert(at->text).second) return 0;  // reported at the definition
            at = file_.constants[found->second].value.get();
        }
        // A number that is too large has been reported.
        return at->text.size() > 10 ? 0 : std::stoll(at->text);
    }

    void check_limit(const Limit& written, Duty& duty) {
        duty.to = limit_steps(written.to, written.unit, duty);
        if (written.from) duty.from = limit_steps(written.from, written.from_unit, duty);
        if (!duty.measured && *duty.to < duty.from) diagnostics_.report(rules::empty_interval, written.span);
    }

    /// Converts seconds to steps without rounding. A time that is not a multiple of the time unit is an error.
    std::int64_t steps_of(std::int64_t seconds, Span span) {
        if (!result_.unit) return seconds;
        if (std::abs(seconds) > durations::longest / durations::second) {
            diagnostics_.report(rules::wrong_duration, span, {"the time is longer than a century"});
            return 0;
        }
        const durations::UnitCount count = durations::count_units(std::abs(seconds) * durations::second, *result_.unit);
        if (!count.error.empty()) diagnostics_.report(rules::wrong_duration, span, {count.error});
        return seconds < 0 ? -count.units : count.units;
    }

    /// Returns one end of a limit, in steps. For an expression with measures, sets `measured` of the duty.
    std::int64_t limit_steps(const ExprPtr& expr, Unit unit, Duty& duty) {
        if (!expr->bracketed) return steps_of(constant_value(expr) * seconds_of(unit), expr->span);
        const Typed value = check_expression(expr);
        expect_type(value, Type::number, *expr);
        duty.measured = duty.measured || has_measure(value.condition);
        if (duty.measured || value.type != Type::number) return 0;
        constexpr std::int64_t longest = 10'000'000'000;  // the largest number that may be written
        const std::int64_t number = std::clamp(evaluate_condition(value.condition, {}), -longest, longest);
        return steps_of(number * seconds_of(unit), expr->span);
    }

    static bool has_measure(const Condition& condition) {
        return condition.op == Op::name || std::ranges::any_of(condition.parts, has_measure);
    }

    // conditions

    Typed check_expression(const ExprPtr& expr) {
        Typed result;
        result.condition.op = expr->op;
        result.condition.written = expr.get();
        switch (expr->op) {
            case Op::truth:
                result.condition.value = expr->text == "true" ? 1 : 0;
                result.type = Type::truth;
                return result;
            case Op::number:
                result.condition.value = constant_value(expr);
                result.type = Type::number;
                return result;
            case Op::name:
                return check_name(expr);
            case Op::in_state:
                return check_state(*expr);
            case Op::negation:
            case Op::conjunction:
            case Op::disjunction:
                return check_operands(expr, Type::truth, Type::truth);
            case Op::add:
            case Op::subtract:
            case Op::multiply:
                return check_operands(expr, Type::number, Type::number);
            case Op::less:
            case Op::less_equal:
            case Op::greater:
            case Op::greater_equal:
            case Op::equal:
            case Op::unequal:
                break;
        }
        return check_comparison(expr);
    }

    static Type type_of(MeasureType type) {
        if (type == MeasureType::boolean) return Type::truth;
        return type == MeasureType::numeric ? Type::number : Type::scale;
    }

    Typed check_name(const ExprPtr& expr) {
        Typed result;
        result.condition.written = expr.get();
        if (const auto found = measures_.find(expr->text); found != measures_.end()) {
            result.condition.op = Op::name;
            result.condition.measure = found->second;
            result.type = type_of(file_.measures[found->second].type);
        } else if (constants_.contains(expr->text)) {
            result.condition.value = constant_value(expr);
            result.type = Type::number;
        } else if (literals_.contains(expr->text)) {
            result.type = Type::literal;
        } else {
            not_found(expr->text, expr->span, "a measure", {&measures_, &constants_});
        }
        return result;
    }

    /// Checks a state, which is treated as a boolean measure of the model.
    Typed check_state(const Expr& expr) {
        const std::string name = "in " + expr.text;
        std::vector<Measure>& measures = result_.measures;
        auto found = std::ranges::find_if(measures, [&](const Measure& measure) { return measure.name.text == name; });
        if (found == measures.end()) {
            measures.push_back({{name, expr.span}, MeasureType::boolean, {}});
            found = measures.end() - 1;
        }
        Typed result;
        result.condition.op = Op::name;
        result.condition.measure = static_cast<std::size_t>(found - measures.begin());
        result.condition.written = &expr;
        result.type = Type::truth;
        return result;
    }

    Typed check_operands(const ExprPtr& expr, Type expected, Type made) {
        Typed result;
        result.condition.op = expr->op;
        result.condition.written = expr.get();
        result.type = made;
        for (const ExprPtr& part : expr->parts) {
            Typed operand = check_expression(part);
            expect_type(operand, expected, *part);
            result.condition.parts.push_back(std::move(operand.condition));
        }
        return result;
    }

    void expect_type(const Typed& part, Type expected, const Expr& written) {
        if (part.type == expected || part.type == Type::wrong) return;
        diagnostics_.report(rules::wrong_type, written.span,
                            {fmt::format("'{}' is {}, not {}", written.text.empty() ? "this" : written.text,
                                         type_text(part.type), type_text(expected))});
    }

    Typed check_comparison(const ExprPtr& expr) {
        Typed left = check_expression(expr->parts[0]);
        Typed right = check_expression(expr->parts[1]);
        Typed result;
        result.type = Type::truth;
        result.condition.op = expr->op;
        result.condition.written = expr.get();
        if (left.type == Type::scale && right.type == Type::literal)
            place_literal(right, left.condition.measure, *expr->parts[1]);
        else if (left.type == Type::literal && right.type == Type::scale)
            place_literal(left, right.condition.measure, *expr->parts[0]);
        else if (!are_comparable(left.type, right.type))
            diagnostics_.report(
                rules::wrong_type, expr->span,
                {fmt::format("{} cannot be compared with {}", type_text(left.type), type_text(right.type))});
        result.condition.parts = {std::move(left.condition), std::move(right.condition)};
        return result;
    }

    /// True for two numbers. In LEGOS, whose scales are numbers from 0, also true for a scale and a number. Wrong types
    /// have been reported.
    [[nodiscard]] bool are_comparable(Type left, Type right) const {
        const auto numeric = [&](Type type) {
            return type == Type::number || (type == Type::scale && file_.dialect == Dialect::legos);
        };
        if (left == Type::wrong || right == Type::wrong) return true;
        return numeric(left) && numeric(right) && (left == Type::number || right == Type::number);
    }

    /// Sets the literal's index on the scale of that measure.
    void place_literal(Typed& literal, std::size_t measure, const Expr& written) {
        const Measure& scale = file_.measures[measure];
        const auto index = place_on(scale, written.text);
        literal.condition.op = Op::number;
        if (index) {
            literal.condition.value = *index;
            return;
        }
        std::vector<std::string> values;
        for (const Name& candidate : scale.literals) values.push_back(candidate.text);
        for (const Measure& other : file_.measures) {
            const auto elsewhere = place_on(other, written.text);
            if (file_.dialect != Dialect::legos || !elsewhere || *elsewhere >= static_cast<int>(values.size()))
                continue;
            literal.condition.value = *elsewhere;
            diagnostics_.report(rules::literal_by_place, written.span,
                                {written.text, scale.name.text, fmt::format("{}", fmt::join(values, ", ")),
                                 values[static_cast<std::size_t>(*elsewhere)]});
            return;
        }
        diagnostics_.report(
            rules::wrong_type, written.span,
            {fmt::format("'{}' is no value of {} ({})", written.text, scale.name.text, fmt::join(values, ", "))});
    }

    static std::optional<int> place_on(const Measure& scale, const std::string& literal) {
        const auto found =
            std::ranges::find_if(scale.literals, [&](const Name& candidate) { return candidate.text == literal; });
        if (found == scale.literals.end()) return std::nullopt;
        return static_cast<int>(found - scale.literals.begin());
    }

    std::optional<Condition> check_condition(const ExprPtr& expr) {
        if (!expr) return std::nullopt;
        Typed whole = check_expression(expr);
        expect_type(whole, Type::truth, *expr);
        return std::move(whole.condition);
    }

    // rules

    DutyPtr check_duty(const Response& written) {
        Duty result;
        result.written = &written;
        result.forbids = written.negated;
        result.event = find_event(written.event);
        if (written.limit) check_limit(*written.limit, result);
        if (written.otherwise) result.otherwise = check_duty(*written.otherwise);
        for (const Defeater& defeater : written.defeaters) result.defeaters.push_back(check_defeater(defeater));
        return std::make_shared<const Duty>(std::move(result));
    }

    CheckedDefeater check_defeater(const Defeater& written) {
        CheckedDefeater result;
        result.written = &written;
        result.event = defeating_event(written);
        if (result.event)
            diagnostics_.report(rules::extension, written.span, {"unless EVENT"});
        else
            result.condition = *check_condition(written.condition);
        if (written.response) result.duty = check_duty(*written.response);
        return result;
    }

    std::optional<EventCases> defeating_event(const Defeater& written) {
        if (written.event) {
            if (written.response)
                diagnostics_.report(
                    rules::wrong_arguments, written.span,
                    {fmt::format("`unless {0}` ends a duty and has no `then`: write a rule `when {0} then ...` for it",
                                 written.event->text)});
            return find_event(*written.event);
        }
        const Expr& expr = *written.condition;
        if (expr.op != Op::name || expr.braced || written.response || !events_.contains(expr.text)) return std::nullopt;
        return find_event({{expr.text, expr.span}, std::nullopt});
    }

    CheckedRule check_clause(const Rule& written) {
        CheckedRule result;
        result.written = &written;
        result.assumed = written.assumed;
        result.trigger = find_event(written.trigger.event);
        result.condition = check_condition(written.trigger.condition);
        result.duty = check_duty(*written.response);
        if (written.form == RuleForm::at_least) {  // "no sooner than N" forbids the event in the N seconds before
            Duty before = *result.duty;
            before.to = *before.to - 1;
            result.duty = std::make_shared<const Duty>(std::move(before));
        }
        return result;
    }

    CheckedProperty check_clause(const Property& written) {
        CheckedProperty result;
        result.written = &written;
        result.exists = written.exists;
        result.trigger = find_event(written.trigger.event);
        result.condition = check_condition(written.trigger.condition);
        if (written.response) result.duty = check_duty(*written.response);
        if (written.during) {
            result.during = find_event(written.during->event);
            result.during_condition = check_condition(written.during->condition);
        }
        return result;
    }

    diagnostics::Diagnostics& diagnostics_;
    CheckedRules result_;
    const RuleFile& file_;
    std::map<std::string, Span> declared_;
    std::map<std::string, std::size_t> events_, measures_, constants_;
    std::set<std::string> literals_;
    std::vector<const EventName*> first_use_;        ///< index: the event
    std::map<std::size_t, std::size_t> first_case_;  ///< index: the event
    std::set<std::string> circles_;                  ///< constants of cycles that have been reported
};

}  // namespace

std::optional<CheckedRules> check_rules(const RuleFile& file, diagnostics::Diagnostics& diagnostics,
                                        durations::Unit unit) {
    return Checker(file, diagnostics, unit).run();
}

}  // namespace robochart::sleec
