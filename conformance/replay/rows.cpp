// SPDX-License-Identifier: Apache-2.0
// Walks through the process of the table and the code together. A pair is a state of the process in which a cycle
// begins, and the bytes of the code's state. The first pair is the initial state of the process and the state that
// `initial` writes. From each pair, the code runs one cycle for every combination of readings. The process must have
// exactly the transitions of these cycles, and each cycle leads to another pair.
//
// Claim: if no difference is found, the process and the code, as docs/conformance.md ("The code") defines its
// behaviour, are strongly bisimilar. Proof: the relation consists of the pairs, and of the states between them, which
// are visited with the progress of the cycle. The walk compares all transitions of each visited state, and visits all
// targets. QED
//
// The states in code.txt are not needed for this argument. They limit the number of pairs, and they show a wrong target
// in the row that has it.
#include "conformance/replay/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <string_view>
#include <unordered_map>

namespace robochart::replay {

namespace {

constexpr std::uint32_t no_event = UINT32_MAX;
constexpr std::uint32_t most_records = 1U << 18U;
constexpr std::size_t longest_text = 1U << 20U;
constexpr std::string_view write_prefix = "registerWrite.wrote__";

/// Thrown to end the walk at a difference.
struct Difference {
    std::string words;
};

/// The names of registers and outputs in events: without `.in` or `.out` at the end, with `_` for `:` and `.`, and with
/// a number if an earlier name is equal.
template <class Port>
std::vector<std::string> event_names(const std::vector<Port>& ports) {
    std::set<std::string> taken;
    std::vector<std::string> result;
    for (const Port& port : ports) {
        std::string name = port.name;
        for (const std::string_view direction : {".in", ".out"})
            if (name.size() > direction.size() && name.ends_with(direction))
                name.resize(name.size() - direction.size());
        std::ranges::replace_if(
            name, [](char c) { return c == ':' || c == '.'; }, '_');
        result.push_back(name);
        for (unsigned n = 2; !taken.insert(result.back()).second; ++n) result.back() = fmt::format("{}__{}", name, n);
    }
    return result;
}

/// One result of a cycle.
struct Result {
    rc_result outcome = RC_QUIESCENT;
    std::vector<std::string> writes;  ///< names of events
    std::string next;                 ///< bytes of the state
    friend auto operator<=>(const Result&, const Result&) = default;
};

class Walk {
public:
    Walk(const Table& table, const rc_interface& code, Progress& progress)
        : table_(table),
          code_(code),
          progress_(progress),
          input_names_(event_names(table.inputs)),
          output_names_(event_names(table.outputs)),
          records_(64) {
        for (std::uint32_t event = 2; event < table.events.size(); ++event)
            numbers_.emplace(table.events[event], event);
        for (std::size_t i = 0; i < table.inputs.size(); ++i) {
            const Input& input = table.inputs[i];
            std::vector<std::uint32_t>& events = reads_.emplace_back();
            events.push_back(number_of("registerRead.absent__" + input_names_[i]));
            const std::string present = "registerRead.present__" + input_names_[i];
            if (input.values.empty()) events.push_back(number_of(present));
            for (const std::string& value : input.values) events.push_back(number_of(present + "." + value));
        }
        for (std::uint32_t line = 0; line < table.states.size(); ++line)
            unreached_.emplace(std::pair{table.states[line].state, table.states[line].text}, line);
    }

    void run() {
        compare_interfaces();
        const std::string first = fresh_state('\0');
        if (first != fresh_state('\xa5')) throw Difference{"`initial` does not write the whole state"};
        if (!enter(table_.initial, first))
            throw Difference{
                fmt::format("the code begins in {}, and the table in {}", print(first), state_text(table_.initial))};
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            const Pair pair = pairs_[i];
            progress_.state = pair.line;
            read_registers(pair, pair.state, 0);
        }
        if (!unreached_.empty())
            throw Difference{
                fmt::format("the code does not reach {}, which the table contains", unreached_.begin()->first.second)};
    }

private:
    struct Pair {
        std::uint32_t state;
        std::string bytes;
        std::uint32_t line;  ///< index of Table::states
    };

    [[nodiscard]] std::uint32_t number_of(const std::string& name) const {
        const auto found = numbers_.find(name);
        return found == numbers_.end() ? no_event : found->second;
    }

    void compare_interfaces() const {
        const auto names = [](std::uint32_t count, const auto* ports) {
            std::vector<std::string> result;
            for (std::uint32_t i = 0; i < count; ++i) result.emplace_back(ports[i].name);
            return result;
        };
        const auto expected = [](const auto& ports) {
            std::vector<std::string> result;
            for (const auto& port : ports) result.push_back(port.name);
            return result;
        };
        if (names(code_.inputs, code_.input) != expected(table_.inputs) ||
            names(code_.outputs, code_.output) != expected(table_.outputs))
            throw Difference{"the code has other inputs or outputs than the table"};
        for (std::uint32_t i = 0; i < code_.inputs; ++i) {
            const rc_input& input = code_.input[i];
            if (!std::equal(input.text, input.text + input.values, table_.inputs[i].values.begin(),
                            table_.inputs[i].values.end()))
                throw Difference{fmt::format("the code has other values of {} than the table", input.name)};
        }
        for (std::uint32_t o = 0; o < code_.outputs; ++o)
            if (code_.output[o].arguments != table_.outputs[o].arguments.size())
                throw Difference{
                    fmt::format("the code has other arguments of {} than the table", code_.output[o].name)};
    }

    [[nodiscard]] std::string fresh_state(char fill) const {
        std::string state(code_.state_size, fill);
        code_.initial(state.data());
        return state;
    }

    [[nodiscard]] std::string print(const std::string& state) {
        text_.assign(longest_text, '\0');
        code_.print(state.data(), text_.data(), text_.size());
        text_.back() = '\0';
        std::string text = text_.c_str();
        std::ranges::replace_if(
            text, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, '?');
        return text;
    }

    /// Adds a pair if it is new. Returns false if the table does not contain it.
    bool enter(std::uint32_t state, const std::string& bytes) {
        if (known_.contains({state, bytes})) return true;
        const auto line = unreached_.find(std::pair{state, print(bytes)});
        if (line == unreached_.end()) return false;
        pairs_.push_back({state, bytes, line->second});
        known_.insert({state, bytes});
        unreached_.erase(line);
        return true;
    }

    /// Reads the registers from `input` on, in all combinations. Recursion depth: the number of registers.
    void read_registers(const Pair& pair, std::uint32_t state, std::size_t input) {
        if (input == table_.inputs.size()) return run_row(pair, state);
        const std::vector<Edge>& edges = table_.edges[state];
        for (std::uint32_t reading = 0; reading < table_.inputs[input].readings(); ++reading) {
            progress_.registers[input] = {reading == 0 ? 0U : 1U, reading == 0 ? 0U : reading - 1};
            const Edge wanted{reads_[input][reading], 0};
            const auto edge = std::ranges::lower_bound(edges, wanted);
            if (edge == edges.end() || edge->event != wanted.event || edges.size() != table_.inputs[input].readings())
                throw Difference{fmt::format("{}: the table does not have one transition for each reading of {}",
                                             row_words(table_, progress_), input_names_[input])};
            read_registers(pair, edge->target, input + 1);
        }
    }

    void run_row(const Pair& pair, std::uint32_t state) {
        progress_.rows = progress_.rows + 1;
        const std::set<Result> results = all_results(pair.bytes);
        std::vector<std::uint32_t> ways;
        for (const Edge& edge : table_.edges[state])
            if (edge.event == tau) ways.push_back(edge.target);
        // Several results are a choice, in which each way of the table is the way of a result, and vice versa.
        const bool choice = ways.size() > 1 && ways.size() == table_.edges[state].size();
        if (!choice) ways = {state};
        std::set<std::uint32_t> taken;
        for (const Result& result : results) {
            const auto way = std::ranges::find_if(
                ways, [&](std::uint32_t start) { return !taken.contains(start) && does(result, start); });
            if (way == ways.end()) throw Difference{difference_text(result, ways)};
            taken.insert(*way);
        }
        if (taken.size() == ways.size()) return;
        throw Difference{fmt::format("{}: the table has a choice of {} results, the code has {}",
                                     row_words(table_, progress_), ways.size(), results.size())};
    }

    /// Returns the results of the cycle for all answers to the questions of the code.
    [[nodiscard]] std::set<Result> all_results(const std::string& from) {
        std::set<Result> results;
        rc_log log{};
        do {
            results.insert(run_cycle(from, log));
        } while (next_answers(log));
        return results;
    }

    [[nodiscard]] Result run_cycle(const std::string& from, rc_log& log) {
        for (;;) {
            log.count = log.overflow = log.asked = 0;
            log.record = records_.data();
            log.capacity = static_cast<std::uint32_t>(records_.size());
            Result result;
            result.next = from;
            result.outcome = code_.step(result.next.data(), progress_.registers, &log);
            if ((log.overflow & ROBOCHART_OVERFLOW_CHOICES) != 0 || records_.size() > most_records)
                throw Difference{row_words(table_, progress_) + ": the code makes too many outputs or choices"};
            if (log.overflow == 0) {
                for (std::uint32_t r = 0; r < log.count; ++r) result.writes.push_back(write_name(log.record[r]));
                return result;
            }
            records_.resize(2 * records_.size());
        }
    }

    [[nodiscard]] std::string write_name(const rc_record& record) const {
        if (record.output >= table_.outputs.size()) return "an unknown output";
        std::string name = fmt::format("{}{}", write_prefix, output_names_[record.output]);
        const auto& arguments = table_.outputs[record.output].arguments;
        for (std::uint32_t a = 0; a < record.count && a < ROBOCHART_MAX_ARGUMENTS; ++a) {
            const std::int64_t value = record.argument[a];
            const bool named =
                a < arguments.size() && value >= 0 && static_cast<std::uint64_t>(value) < arguments[a].size();
            name += named ? "." + arguments[a][static_cast<std::size_t>(value)] : fmt::format(".{}", value);
        }
        return name;
    }

    /// Advances to the next combination of answers. Returns false after the last one.
    static bool next_answers(rc_log& log) {
        for (std::uint32_t k = log.asked; k > 0; --k) {
            const std::uint32_t taken = k - 1 < log.given ? log.choice[k - 1] : 0;
            if (taken + 1 >= log.ways[k - 1]) continue;
            for (std::uint32_t earlier = log.given; earlier < k - 1; ++earlier) log.choice[earlier] = 0;
            log.choice[k - 1] = taken + 1;
            log.given = k;
            return true;
        }
        return false;
    }

    /// Follows the only transition of a state. Returns false if the state has others, or none with this event.
    bool follow(std::uint32_t event, std::uint32_t& state) const {
        const std::vector<Edge>& edges = table_.edges[state];
        if (edges.size() != 1 || edges.front().event != event) return false;
        state = edges.front().target;
        return true;
    }

    /// Returns whether the process does the rest of the cycle from this state, and enters the next pair.
    bool does(const Result& result, std::uint32_t state) {
        for (const std::string& write : result.writes) {
            const std::uint32_t event = number_of(write);
            if (event == no_event || !follow(event, state)) return false;
        }
        const std::uint32_t tock = number_of("tock");
        switch (result.outcome) {
            case RC_QUIESCENT:
                for (std::uint32_t t = 0; t < table_.cycle; ++t)
                    if (!follow(tock, state)) return false;
                return enter(state, result.next);
            case RC_TERMINATED:
                return follow(tick, state) && table_.edges[state].empty();
            case RC_DEADLINE:
                return table_.edges[state].empty();
            case RC_STEP_BOUND:
            case RC_PRECONDITION:
                break;  // code that conforms has no such results
        }
        return false;
    }

    [[nodiscard]] std::string difference_text(const Result& result, const std::vector<std::uint32_t>& ways) {
        std::vector<std::string> stated;
        for (const std::uint32_t way : ways) stated.push_back(table_text(way));
        return fmt::format("{}: the table states {}, but the code does {}", row_words(table_, progress_),
                           fmt::join(stated, " or "), code_text(result));
    }

    [[nodiscard]] static std::string short_name(const std::string& event) {
        return event.starts_with(write_prefix) ? event.substr(write_prefix.size()) : event;
    }

    [[nodiscard]] std::string code_text(const Result& result) {
        std::vector<std::string> writes;
        for (const std::string& write : result.writes) writes.push_back(short_name(write));
        std::string end = "an unknown result";
        if (result.outcome == RC_QUIESCENT) end = print(result.next);
        if (result.outcome == RC_TERMINATED) end = "termination";
        if (result.outcome == RC_DEADLINE) end = "a missed deadline";
        if (result.outcome == RC_STEP_BOUND) end = "an endless cycle";
        if (result.outcome == RC_PRECONDITION) end = "a violated precondition";
        return fmt::format("<{}>, then {}", fmt::join(writes, ", "), end);
    }

    /// Returns the text of a state of the process in which a cycle begins.
    [[nodiscard]] std::string state_text(std::uint32_t state) const {
        const auto found = std::ranges::find(table_.states, state, &StartState::state);
        return found == table_.states.end() ? "an unknown state" : found->text;
    }

    /// Describes the rest of a cycle as the table states it.
    [[nodiscard]] std::string table_text(std::uint32_t state) const {
        const std::uint32_t tock = number_of("tock");
        std::vector<std::string> writes;
        std::uint32_t tocks = 0;
        std::string end = "a missed deadline";
        for (std::size_t steps = 0; steps <= table_.edges.size() && tocks < table_.cycle; ++steps) {
            if (table_.edges[state].empty()) break;
            const Edge& edge = table_.edges[state].front();
            if (table_.edges[state].size() > 1) end = "several events";
            if (edge.event == tick) end = "termination";
            if (edge.event <= tick || table_.edges[state].size() > 1) break;
            if (edge.event == tock)
                ++tocks;
            else
                writes.push_back(short_name(table_.events[edge.event]));
            state = edge.target;
        }
        if (tocks == table_.cycle) end = state_text(state);
        return fmt::format("<{}>, then {}", fmt::join(writes, ", "), end);
    }

    const Table& table_;
    const rc_interface& code_;
    Progress& progress_;
    std::vector<std::string> input_names_, output_names_;
    std::unordered_map<std::string, std::uint32_t> numbers_;  ///< of events; never iterated
    std::vector<std::vector<std::uint32_t>> reads_;           ///< events by input and reading
    std::vector<Pair> pairs_;
    std::set<std::pair<std::uint32_t, std::string>> known_;
    std::multimap<std::pair<std::uint32_t, std::string>, std::uint32_t> unreached_;  ///< lines of Table::states
    std::vector<rc_record> records_;
    std::string text_;
};

}  // namespace

std::string row_words(const Table& table, const Progress& progress) {
    const std::vector<std::string> names = event_names(table.inputs);
    std::vector<std::string> present;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const rc_register& reading = progress.registers[i];
        if (reading.present == 0) continue;
        const std::vector<std::string>& values = table.inputs[i].values;
        present.push_back(reading.value < values.size() ? fmt::format("{} = {}", names[i], values[reading.value])
                                                        : names[i]);
    }
    return fmt::format("row {}, in {} with {{{}}}", progress.rows, table.states.at(progress.state).text,
                       fmt::join(present, ", "));
}

std::optional<std::string> first_difference(const Table& table, const rc_interface& code, Progress& progress) {
    if (code.abi_version != ROBOCHART_ABI_VERSION)
        throw Unusable(fmt::format("the object has version {} of the interface; version {} is needed", code.abi_version,
                                   ROBOCHART_ABI_VERSION));
    if (code.initial == nullptr || code.step == nullptr || code.print == nullptr || code.component == nullptr)
        throw Unusable("a function of the object is missing");
    if (table.component != code.component)
        throw Unusable(
            fmt::format("the object is the code of {}, but the table is of {}", code.component, table.component));
    try {
        Walk(table, code, progress).run();
        return std::nullopt;
    } catch (const Difference& difference) {
        return difference.words;
    }
}

}  // namespace robochart::replay
