// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/faults/code_faults.hpp"

#include <algorithm>
#include <regex>
#include <string_view>
#include <vector>

namespace robochart::cpp_emit {

namespace {

/// A fault that changes lines: which lines, and how. Patterns are those of std::regex and must match the whole line.
struct LineRule {
    Fault fault;
    const char* function;  ///< pattern for the name of the function in Step
    const char* line;      ///< pattern for the line, without its indentation
    const char* wrong;     ///< the replacement, as in std::regex_replace; "" deletes the line
};

/// A pattern for the functions that do not belong to the event API.
constexpr const char* of_cycle = "(?!dispatch$|begin$|pass$).*";
constexpr const char* of_events = "dispatch|begin|pass";

constexpr LineRule line_rules[] = {
    {Fault::single_transition_step, "run", R"(while \((.*)\) \{)", "if ($1) {"},
    {Fault::during_not_cut, of_cycle, R"(cut_\w+\(f\);)", ""},
    {Fault::input_not_awaited, of_cycle, R"(if \(!\(inputs_\.\w+\.present.*\)\) \{)", "if (false) {"},
    {Fault::event_not_consumed, of_cycle, R"(inputs_\.\w+\.present = false;)", ""},
    {Fault::offer_kept, "accept_.*", R"(.* = \w+::\w+;)", "static_cast<void>(f);"},
    {Fault::buffer_kept, of_cycle, R"(state_\.\w+ = \{\};)", ""},
    {Fault::buffer_first, of_cycle, R"((state_\.\w+)(\.fill\(.*\);))", "if (!$1.full()) $1$2"},
    {Fault::operation_not_awaited, of_cycle, R"(if \(!(run\(.*\))\) \{)", "if (static_cast<void>($1), false) {"},
    {Fault::operation_kept, of_cycle, R"(f\.\w+ = \{\};)", ""},
    {Fault::ended_by_one, "finished", R"(return (finished\(.*\)) && (finished\(.*\));)", "return $1 || $2;"},
    {Fault::end_unnoticed, "finished|run", R"(return \w+\.at == .*;)", "return false;"},
    {Fault::outside_write_lost, "cycle", R"(if \(inputs_\.\w+\.present\) state_\.[\w.]+ = .*;)", ""},
    {Fault::clock_off_by_one, of_cycle, R"((.*\.(?!deadline_|wait)\w+) = 0;)", "$1 = 1;"},
    {Fault::clock_twice, "advance", R"(advance_clock\(.*\);)", "$& $&"},
    {Fault::clock_stopped, "advance", R"(advance_clock\(.*\);)", ""},
    {Fault::clock_saturated, "advance", R"((advance_clock\(.*)\);)", "$1 - 1);"},
    {Fault::deadline_kept, of_cycle, R"(f\.deadline_\w+ = 0;)", ""},
    {Fault::deadline_not_restarted, "watch", R"(if \(f\.\w+ > 0 && !\(.*\)\) .*;)", ""},
    {Fault::dispatch_guard_dropped, of_events, R"(if \((?!f\.at).*\) \{)", "if (true) {"},
    {Fault::dispatch_exits_dropped, of_events, R"((leave|exit)_\w+\(f\);)", ""},
    {Fault::dispatch_deadline_kept, of_events, R"(f\.deadline_\w+ = 0;)", ""},
    {Fault::dispatch_event_kept, of_events, R"(event = nothing;)", ""},
    {Fault::dispatch_other_value, "dispatch", R"(inputs_\.\w+\.value = values\..*;)", ""},
    {Fault::dispatch_others_read, "dispatch", R"(inputs_ = \{\};)", ""},
    {Fault::dispatch_end_unnoticed, "dispatch", R"(return this->result\(finished\(.*\)\);)",
     "return this->result(false);"},
    {Fault::pass_not_quiet, "pass", R"((const robochart::StepResult result = )begin\(\);)",
     "$1robochart::StepResult::quiescent;"},
    {Fault::pass_timeless, "pass", R"(if \(result == robochart::StepResult::quiescent\) advance\(f\);)", ""},
};

/// A fault of order, which changes lines whose middle is a list of calls, joined by ` || `.
struct OrderRule {
    Fault fault;
    const char* function;
    const char* line;  ///< pattern with three groups: the text before the list, the list, the text after it
};

constexpr OrderRule order_rules[] = {
    {Fault::outer_first, "transition|attempt", R"((case .*: return )(.* \|\| .*)(;))"},
    {Fault::machines_reversed, "run", R"((while \(.*\()(round\(.* \|\| .*\))(\)\) \{))"},
};

std::string reverse_calls(std::string_view list) {
    constexpr std::string_view joint = " || ";
    std::string result;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(joint, begin), list.size());
        const std::string call(list.substr(begin, end - begin));
        result = result.empty() ? call : call + std::string(joint) + result;
        begin = end + joint.size();
    }
    return result;
}

/// Changes lines in the functions of the class Step, whose heads are indented once.
class FaultyCode {
public:
    explicit FaultyCode(Mutation& mutation) : mutation_(mutation) {}

    std::string write_faulty(std::string_view text) {
        std::string result;
        while (!text.empty()) {
            const std::size_t end = text.find('\n');
            const std::string line(text.substr(0, end));
            text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
            note_function(line);
            append_line(result, line);
        }
        return result;
    }

private:
    void note_function(const std::string& line) {
        static const std::regex head(R"(    (?:\[\[nodiscard\]\] )?(?:static )?[\w:]+ (\w+)\(.*noexcept \{)");
        std::smatch found;
        if (std::regex_match(line, found, head)) function_ = found[1];
        if (line == "    }") function_.clear();
    }

    void append_line(std::string& result, const std::string& line) {
        const std::size_t depth = std::min(line.find_first_not_of(' '), line.size());
        const std::string changed = apply_fault(line.substr(depth));
        if (!changed.empty() || depth == line.size()) result += line.substr(0, depth) + changed + "\n";
    }

    [[nodiscard]] bool in_function(const char* functions) const {
        return !function_.empty() && std::regex_match(function_, std::regex(functions));
    }

    std::string apply_fault(const std::string& line) {
        for (const LineRule& rule : line_rules) {
            if (!mutation_.is_seeded(rule.fault) || !in_function(rule.function)) continue;
            const std::regex pattern(rule.line);
            if (std::regex_match(line, pattern) && mutation_.hits(rule.fault))
                return std::regex_replace(line, pattern, rule.wrong);
        }
        for (const OrderRule& rule : order_rules) {
            std::smatch parts;
            if (!mutation_.is_seeded(rule.fault) || !in_function(rule.function)) continue;
            if (std::regex_match(line, parts, std::regex(rule.line)) && mutation_.hits(rule.fault))
                return parts[1].str() + reverse_calls(parts[2].str()) + parts[3].str();
        }
        return line;
    }

    Mutation& mutation_;
    std::string function_;
};

bool of_lines(const Mutation& mutation) {
    const auto seeded = [&](const auto& rule) { return mutation.is_seeded(rule.fault); };
    return std::any_of(std::begin(line_rules), std::end(line_rules), seeded) ||
           std::any_of(std::begin(order_rules), std::end(order_rules), seeded);
}

}  // namespace

std::string faulty_code(std::string text, Mutation& mutation) {
    return of_lines(mutation) ? FaultyCode(mutation).write_faulty(text) : text;
}

}  // namespace robochart::cpp_emit
