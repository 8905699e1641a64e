// SPDX-License-Identifier: Apache-2.0
// See monitor_file.hpp.
#include "claims/sleec/emit/monitor_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "base/diagnostics/escape.hpp"
#include "claims/sleec/obligations/open.hpp"
#include "claims/sleec/obligations/samples.hpp"
#include "claims/sleec/syntax/printer.hpp"
#include "cpp_emit/files/files.hpp"
#include "cpp_emit/plan/names.hpp"

namespace robochart::sleec {
namespace {

/// The names of a file as C++ identifiers.
struct CppNames {
    std::vector<std::string> events, measures, types;  ///< the type of a measure that is not a scale is "bool" or
                                                       ///< "std::int64_t"
    std::vector<std::vector<std::string>> literals;
};

/// Returns the C++ name of a case: "goTo_1", "goTo_minus_1", "goTo_other".
std::string case_name(const EventCase& event, const std::string& declared) {
    std::string result = declared;
    for (const std::string& value : event.values)
        result += "_" + (value.starts_with('-') ? "minus_" + value.substr(1) : value.empty() ? "other" : value);
    return result;
}

CppNames names_of(const CheckedRules& rules) {
    CppNames result;
    cpp_emit::NameScope events, measures;
    cpp_emit::NameScope types(
        {"Cases", "Demands", "Duties", "Duty", "Event", "Measures", "Monitor", "demands", "rules"});
    for (std::size_t i = 0; i < rules.events.size(); ++i)
        result.events.push_back(events.unique_name(case_name(rules.events[i], rules.declared_name(i))));
    for (const Measure& measure : rules.measures) {
        result.measures.push_back(measures.unique_name(measure.name.text));
        types.reserve_name(result.measures.back());
    }
    for (const Measure& measure : rules.measures) {
        result.literals.emplace_back();
        if (measure.type != MeasureType::scale) {
            result.types.emplace_back(measure.type == MeasureType::boolean ? "bool" : "std::int64_t");
            continue;
        }
        result.types.push_back(types.unique_name(measure.name.text + "_scale"));
        cpp_emit::NameScope literals;
        for (const Name& literal : measure.literals)
            result.literals.back().push_back(literals.unique_name(literal.text));
    }
    return result;
}

/// Writes conditions as C++. Parentheses are needed only between different operators.
class ConditionText {
public:
    ConditionText(const CheckedRules& rules, const CppNames& names) : rules_(rules), names_(names) {}

    [[nodiscard]] std::string condition_text(const Condition& condition) const {
        if (condition.op == Op::truth) return condition.value != 0 ? "true" : "false";
        if (condition.op == Op::number) return fmt::format("{}", condition.value);
        if (condition.op == Op::name) return "now." + names_.measures[condition.measure];
        if (condition.op == Op::negation) return "!" + operand_text(condition.parts[0], Op::negation);
        if (is_comparison(condition.op)) return comparison_text(condition);
        if (condition.op == Op::conjunction || condition.op == Op::disjunction)
            return fmt::format("{} {} {}", operand_text(condition.parts[0], condition.op),
                               condition.op == Op::conjunction ? "&&" : "||",
                               operand_text(condition.parts[1], Op::negation));
        return arithmetic_text(condition);
    }

private:
    [[nodiscard]] std::string operand_text(const Condition& part, Op behind) const {
        const bool plain = part.op == Op::truth || part.op == Op::name || part.op == behind;
        return plain && part.op != Op::negation ? condition_text(part) : "(" + condition_text(part) + ")";
    }

    /// Writes a comparison. Some comparisons are already evaluated here: compilers would warn about comparisons of a
    /// measure with itself and of two numbers, and a comparison of a scale with a number that is none of its literals
    /// has the same result for all literals.
    [[nodiscard]] std::string comparison_text(const Condition& condition) const {
        const Condition& left = condition.parts[0];
        const Condition& right = condition.parts[1];
        const bool same = left.op == right.op && (left.op == Op::number || left.measure == right.measure);
        const bool beyond = is_beyond_scale(left, right) || is_beyond_scale(right, left);
        if (beyond || (same && (left.op == Op::number || left.op == Op::name)))
            return evaluate_condition(condition, Valuation(rules_.measures.size(), 0)) != 0 ? "true" : "false";
        std::string op = symbol_of(condition.op);
        if (condition.op == Op::equal) op = "==";
        if (condition.op == Op::unequal) op = "!=";
        return fmt::format("{} {} {}", compared_operand(condition, 0), op, compared_operand(condition, 1));
    }
    [[nodiscard]] bool is_beyond_scale(const Condition& number, const Condition& measure) const {
        if (number.op != Op::number || measure.op != Op::name) return false;
        const auto literals = static_cast<std::int64_t>(names_.literals[measure.measure].size());
        return rules_.measure(measure.measure).type == MeasureType::scale &&
               (number.value < 0 || number.value >= literals);
    }
    /// Returns an operand of a comparison. A literal is compared with a measure of its scale.
    [[nodiscard]] std::string compared_operand(const Condition& condition, std::size_t side) const {
        const Condition& part = condition.parts[side];
        const Condition& other = condition.parts[1 - side];
        if (part.op != Op::number || other.op != Op::name) return condition_text(part);
        if (rules_.measure(other.measure).type != MeasureType::scale) return condition_text(part);
        return names_.types[other.measure] +
               "::" + names_.literals[other.measure].at(static_cast<std::size_t>(part.value));
    }

    [[nodiscard]] std::string arithmetic_text(const Condition& condition) const {
        std::string right = condition_text(condition.parts[1]);
        if (condition.op == Op::subtract) right = fmt::format("robochart::rule_product(-1, {})", right);
        return fmt::format("robochart::rule_{}({}, {})", condition.op == Op::multiply ? "product" : "sum",
                           condition_text(condition.parts[0]), right);
    }

    const CheckedRules& rules_;
    const CppNames& names_;
};

/// The size of the obligations of one duty. Counts are limited to `most_open`.
struct Shape {
    std::size_t demands = 0, endings = 0;
    std::size_t open = 0;  ///< the number of different duties that can be open
};

/// Computes the sizes of all obligations of a rule, for every combination of its defeaters.
class Shapes {
public:
    explicit Shapes(WithoutLimit without) : without_(without) {}

    Shape shape_of(const DutyPtr& duty) {
        visit(duty, {});
        return shape_;
    }

private:
    struct Way {
        std::size_t demands = 0, prohibitions = 0, endings = 0;
        std::int64_t seconds = 0;  ///< the time after which the obligation no longer changes
        std::int64_t begin = 0;
        bool at_once = true;  ///< true if its only window starts at the trigger
    };

    void end(const Way& way) {
        shape_.demands = std::max(shape_.demands, way.demands);
        shape_.endings = std::max(shape_.endings, way.endings);
        std::size_t open = 1;
        if (way.demands != 1 || !way.at_once) {
            const std::int64_t ages = std::min<std::int64_t>(way.seconds + 1, most_open);
            open = static_cast<std::size_t>(ages) << std::min<std::size_t>(way.prohibitions, 8);
        }
        shape_.open = std::min(shape_.open + open, most_open);
    }

    /// Visits a response. Responses form a tree, so each is visited once.
    void visit(const DutyPtr& duty, Way way) {
        for (const CheckedDefeater& defeater : duty->defeaters)
            way.endings += defeater.event ? defeater.event->size() : 0;
        for (const CheckedDefeater& defeater : duty->defeaters)
            if (defeater.duty) visit(defeater.duty, way);
        add_demand(*duty, way);
    }

    void add_demand(const Duty& duty, Way way) {
        if (duty.measured) throw NotDecided("monitors have no limits that a measure decides");
        if (duty.to && *duty.to < duty.from) return;
        const bool open = !duty.to && without_ == WithoutLimit::eventually;
        const std::int64_t length = duty.to.value_or(0);
        ++way.demands;
        way.prohibitions += duty.forbids ? 1U : 0U;
        way.at_once = way.at_once && duty.from == 0;
        way.seconds = std::max(way.seconds, way.begin + (open ? duty.from : length + 1));
        way.begin += length;
        if (!duty.otherwise || open) return end(way);
        visit(duty.otherwise, way);
    }

    WithoutLimit without_;
    Shape shape_;
};

class Writer {
public:
    Writer(const CheckedRules& rules, std::string path, const diagnostics::SourceManager& sources, WithoutLimit without)
        : rules_(rules), path_(std::move(path)), sources_(sources), without_(without), names_(names_of(rules)) {}

    std::string write() {
        for (std::size_t i = 0; i < rules_.rules.size(); ++i)
            if (!rules_.rules[i].assumed) measure_rule(i);
        write_head();
        write_types();
        write_monitor();
        return std::move(out_);
    }

private:
    [[nodiscard]] std::string file_name() const { return std::filesystem::path(path_).filename().string(); }

    void measure_rule(std::size_t rule) {
        const Shape shape = Shapes(without_).shape_of(rules_.rules[rule].duty);
        if (shape.demands > most_demands)
            throw NotDecided(
                fmt::format("{} has more than {} responses behind each other", rules_.name(rule), most_demands));
        all_.demands = std::max(all_.demands, shape.demands);
        all_.endings = std::max(all_.endings, shape.endings);
        all_.open = std::min(all_.open + shape.open, most_open_of_file);
    }

    void write_head() {
        out_ = fmt::format(
            "// Monitor of the rules in {}.\n"
            "// Generated by robochart-verify; change the rules, not this file.\n"
            "#pragma once\n\n#include <cstdint>\n{}\n#include \"robochart/rules.hpp\"\n\nnamespace {}_rules {{\n\n",
            diagnostics::comment_text(file_name()), compares_literals() ? "#include <string_view>\n" : "",
            monitor_name(path_));
    }
    [[nodiscard]] bool compares_literals() const {
        return std::ranges::any_of(rules_.arguments, [](const std::vector<Argument>& arguments) {
            return std::ranges::find(arguments, ArgumentKind::literal, &Argument::kind) != arguments.end();
        });
    }

    void write_types() {
        if (!names_.events.empty())
            out_ += fmt::format("enum class Event : std::uint32_t {{ {} }};\n", fmt::join(names_.events, ", "));
        write_case_functions();
        const std::vector<Measure>& measures = rules_.measures;
        for (std::size_t i = 0; i < measures.size(); ++i)
            if (measures[i].type == MeasureType::scale)
                out_ += fmt::format("enum class {} : std::uint32_t {{ {} }};\n", names_.types[i],
                                    fmt::join(names_.literals[i], ", "));
        out_ += "\n/// The values of the measures when an event comes.\nstruct Measures {\n";
        for (std::size_t i = 0; i < measures.size(); ++i)
            out_ += fmt::format("    {} {}{{}};\n", names_.types[i], names_.measures[i]);
        out_ += "};\n\n";
        if (rules_.rules.empty()) return;
        out_ += "inline constexpr robochart::RuleText rules[] = {\n";
        for (const CheckedRule& rule : rules_.rules)
            out_ += fmt::format("    {{{}, {}, {}}},\n", diagnostics::cpp_string(rule.written->name.text),
                                diagnostics::cpp_string(print(*rule.written)),
                                diagnostics::cpp_string(place_text(rule.written->span)));
        out_ += "};\n\n";
    }

    /// Writes, for each event with arguments, a function from values to the case.
    void write_case_functions() {
        for (std::size_t declared = 0; declared < rules_.arguments.size(); ++declared) {
            const std::vector<Argument>& arguments = rules_.arguments[declared];
            std::vector<std::string> parameters;
            for (std::size_t i = 0; i < arguments.size(); ++i)
                if (const char* type = parameter_type(arguments[i].kind); *type != '\0')
                    parameters.push_back(fmt::format("{} a{}", type, i));
            if (parameters.empty()) continue;
            const std::string& name = rules_.file->events[declared].name.text;
            out_ += fmt::format("/// The event {} with these values.\nconstexpr Event case_of_{}({}) noexcept {{\n",
                                name, cpp_emit::to_identifier(name), fmt::join(parameters, ", "));
            for (std::size_t i = 0; i < rules_.events.size(); ++i) {
                if (rules_.events[i].declared != declared) continue;
                const bool last = i + 1 == rules_.events.size() || rules_.events[i + 1].declared != declared;
                const std::string test = last ? "" : fmt::format("if ({}) ", case_test(arguments, rules_.events[i]));
                out_ += fmt::format("    {}return Event::{};\n", test, names_.events[i]);
            }
            out_ += "}\n";
        }
    }
    /// Returns the C++ type of a parameter; "" if no rule names a value.
    static const char* parameter_type(ArgumentKind kind) {
        switch (kind) {
            case ArgumentKind::any:
                break;
            case ArgumentKind::number:
                return "std::int64_t";
            case ArgumentKind::truth:
                return "bool";
            case ArgumentKind::literal:
                return "std::string_view";
        }
        return "";
    }
    /// Returns the test for a case. Cases with more values are tested before cases with fewer.
    static std::string case_test(const std::vector<Argument>& arguments, const EventCase& event) {
        std::vector<std::string> tests;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            const std::string& value = event.values[i];
            if (value.empty()) continue;
            if (arguments[i].kind == ArgumentKind::truth)
                tests.push_back(fmt::format("{}a{}", value == "true" ? "" : "!", i));
            else
                tests.push_back(fmt::format("a{} == {}", i,
                                            arguments[i].kind == ArgumentKind::number
                                                ? value
                                                : static_cast<std::string>(diagnostics::cpp_string(value))));
        }
        return fmt::format("{}", fmt::join(tests, " && "));
    }

    /// Returns the number by which demands refer to an event. A single case has the number of the case. A set of
    /// several cases gets a number above those of all cases.
    std::size_t number_of(const EventCases& cases) {
        if (cases.size() == 1) return *cases.begin();
        const auto found = std::ranges::find(several_, cases);
        const auto place = static_cast<std::size_t>(found - several_.begin());
        if (found == several_.end()) several_.push_back(cases);
        return rules_.events.size() + place;
    }
    /// Returns the generated struct that maps a number in a demand to its cases; "" if every demand has a single case.
    [[nodiscard]] std::string cases_text() const {
        if (several_.empty()) return "";
        std::string text =
            "    struct Cases {\n        static constexpr bool contains(std::uint32_t demanded, std::uint32_t event) "
            "noexcept {\n            switch (demanded) {\n";
        for (std::size_t i = 0; i < several_.size(); ++i) {
            std::vector<std::string> tests;
            for (const std::size_t event : several_[i]) tests.push_back(fmt::format("event == {}", event));
            text += fmt::format("                case {}:\n                    return {};\n", rules_.events.size() + i,
                                fmt::join(tests, " || "));
        }
        return text +
               "                default:\n                    return demanded == event;\n            }\n        }\n    "
               "};\n";
    }

    /// Returns the place without its folder, because the generated text must not depend on the folder of the rule file.
    [[nodiscard]] std::string place_text(diagnostics::Span span) const {
        const std::string text = sources_.path_and_line(span);
        return text.substr(text.rfind('/') + 1);
    }

    void write_monitor() {
        out_ += fmt::format(
            "/// event() for each event, with the values of the measures at it; second() at the end of each second. "
            "`report`\n"
            "/// is called with each robochart::RuleViolation. lost(): duties beyond the most that it keeps, which are "
            "not "
            "followed.\n"
            "class Monitor {{\npublic:\n"
            "    template <class Report>\n"
            "    void event({} event, [[maybe_unused]] const Measures& now, Report&& report) {{\n"
            "        duties_.event(static_cast<std::uint32_t>(event), report);\n{}    }}\n"
            "    template <class Report>\n"
            "    void second(Report&& report) {{\n        duties_.second(report);\n    }}\n"
            "    /// What was asked for until now is forgotten.\n"
            "    void forget() noexcept {{ duties_.forget(); }}\n"
            "    std::int64_t now() const noexcept {{ return duties_.now(); }}\n"
            "    std::uint64_t lost() const noexcept {{ return duties_.lost(); }}\n\nprivate:\n",
            names_.events.empty() ? "std::uint32_t" : "Event", trigger_cases());
        const std::size_t begin = out_.size();
        for (std::size_t i = 0; i < rules_.rules.size(); ++i)
            if (!rules_.rules[i].assumed) write_rule(i);
        out_.insert(begin, fmt::format("{}    using Duties = robochart::RuleDuties<{}, {}, {}{}>;\n"
                                       "    using Duty = Duties::Duty;\n\n",
                                       cases_text(), std::max<std::size_t>(all_.demands, 1), all_.endings,
                                       std::max<std::size_t>(all_.open, 1), several_.empty() ? "" : ", Cases"));
        out_ += fmt::format("    Duties duties_;\n}};\n\n}}  // namespace {}_rules\n", monitor_name(path_));
    }

    [[nodiscard]] std::string trigger_cases() const {
        std::map<std::size_t, std::string> triggered;
        for (std::size_t i = 0; i < rules_.rules.size(); ++i)
            if (!rules_.rules[i].assumed)
                for (const std::size_t event : rules_.rules[i].trigger)
                    triggered[event] += fmt::format("                begin_{}(now);\n", i);
        if (triggered.empty()) return "";
        std::string text = "        switch (event) {\n";
        for (const auto& [event, calls] : triggered)
            text += fmt::format("            case Event::{}:\n{}                break;\n", names_.events[event], calls);
        return text + "            default:\n                break;\n        }\n";
    }

    void write_rule(std::size_t index) {
        const CheckedRule& rule = rules_.rules[index];
        const std::size_t response = write_responses(rule.duty);
        out_ += fmt::format("    /// {}: {}\n    void begin_{}([[maybe_unused]] const Measures& now) noexcept {{\n",
                            rules_.name(index), diagnostics::comment_text(print(*rule.written)), index);
        if (rule.condition)
            out_ += fmt::format("        if (!({})) return;\n", conditions_.condition_text(*rule.condition));
        out_ += fmt::format(
            "        Duty duty({}, duties_.now());\n"
            "        if (response_{}(duty, now)) duties_.keep(duty);\n    }}\n\n",
            index, response);
    }

    /// Writes the responses that a response leads to, then the response itself; returns its number.
    std::size_t write_responses(const DutyPtr& duty) {
        std::vector<std::optional<std::size_t>> defeaters;
        for (const CheckedDefeater& defeater : duty->defeaters)
            defeaters.push_back(defeater.duty ? std::optional(write_responses(defeater.duty)) : std::nullopt);
        const bool open = !duty->to && without_ == WithoutLimit::eventually;
        std::optional<std::size_t> otherwise;
        if (duty->otherwise && !open) otherwise = write_responses(duty->otherwise);
        const std::size_t number = responses_++;
        out_ += fmt::format(
            "    static bool response_{}([[maybe_unused]] Duty& duty, [[maybe_unused]] const Measures& now) noexcept "
            "{{\n",
            number);
        for (const CheckedDefeater& defeater : duty->defeaters)
            if (defeater.event)
                for (const std::size_t event : *defeater.event)
                    out_ += fmt::format("        duty.ended_by({});\n", event);
        // If several defeaters are true, the last one decides, so it is tested first.
        for (std::size_t i = defeaters.size(); i-- > 0;)
            if (!duty->defeaters[i].event)
                out_ += fmt::format("        if ({}) return {};\n",
                                    conditions_.condition_text(duty->defeaters[i].condition),
                                    defeaters[i] ? fmt::format("response_{}(duty, now)", *defeaters[i]) : "false");
        write_demand(*duty, open, otherwise);
        out_ += "    }\n";
        return number;
    }

    void write_demand(const Duty& duty, bool open, std::optional<std::size_t> otherwise) {
        if (duty.to && *duty.to < duty.from) {  // "at least 0 seconds" demands nothing
            out_ += "        return false;\n";
            return;
        }
        out_ += fmt::format("        duty.ask({{{}, {}, {}, {}}});  // {}\n", duty.forbids, number_of(duty.event),
                            duty.from, open ? "robochart::rule_forever" : fmt::format("{}", duty.to.value_or(0)),
                            rules_.event_name(duty.event));
        out_ += otherwise ? fmt::format("        return response_{}(duty, now);\n", *otherwise)
                          : std::string("        return true;\n");
    }

    const CheckedRules& rules_;
    std::string path_;
    const diagnostics::SourceManager& sources_;
    WithoutLimit without_;
    CppNames names_;
    ConditionText conditions_{rules_, names_};
    Shape all_;
    std::vector<EventCases> several_;  ///< the events in demands that have several cases
    std::size_t responses_ = 0;
    std::string out_;
};

}  // namespace

std::string monitor_name(const std::string& path) {
    const std::string stem = std::filesystem::path(path).stem().string();
    return cpp_emit::to_identifier(stem == "-" ? "rules" : stem);
}

std::vector<cpp_emit::OutputFile> monitor_files(const CheckedRules& rules, const std::string& path,
                                                const diagnostics::SourceManager& sources, WithoutLimit without) {
    return {{monitor_name(path) + "_rules.hpp", Writer(rules, path, sources, without).write()},
            {"robochart/rules.hpp", cpp_emit::rules_header()}};
}

}  // namespace robochart::sleec
