// SPDX-License-Identifier: Apache-2.0
#include "conformance/code/deployed_code.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <set>

#include "conformance/code/watchdog.hpp"

namespace robochart::conformance {

namespace {

/// The greatest number of combinations of readings that are all tried. With more combinations, only one register is
/// full in a cycle.
constexpr std::uint64_t most_combinations = 1024;

/// Returns all combinations of readings, or those with at most one full register.
std::vector<std::vector<rc_register>> combinations_of(const Interface& interface, bool& all) {
    std::uint64_t count = 1;
    for (const Register& input : interface.inputs)
        count = std::min<std::uint64_t>(most_combinations + 1, count * input.reading_count());
    all = count <= most_combinations;
    std::vector<std::vector<rc_register>> result{std::vector<rc_register>(interface.inputs.size())};
    for (std::size_t i = 0; i < interface.inputs.size(); ++i) {
        std::size_t bases = 1;
        if (all) bases = result.size();
        for (std::size_t base = 0; base < bases; ++base) {
            for (std::uint32_t r = 1; r < interface.inputs[i].reading_count(); ++r) {
                std::vector<rc_register> registers = result[base];
                registers[i] = {1, r - 1};
                result.push_back(std::move(registers));
            }
        }
    }
    return result;
}

class Search {
public:
    Search(const rc_interface& code, std::size_t most, diagnostics::Pollable& budget)
        : code_(code), most_(most), budget_(budget), images_(code) {
        found_.reset = images_.reset();
    }

    TrackedCycles explore(const std::vector<std::vector<rc_register>>& combinations) {
        for (std::uint32_t image = 0; image < images_.size() && found_.all; ++image)
            for (std::size_t c = 0; c < combinations.size() && found_.all; ++c) add_cycles(image, combinations[c]);
        found_.images = static_cast<std::uint32_t>(images_.size());
        return std::move(found_);
    }

private:
    /// Adds one cycle for each combination of answers to the choices of the code.
    void add_cycles(std::uint32_t from, const std::vector<rc_register>& registers) {
        CycleLog log;
        do {
            budget_.poll();
            CodeImages::Bytes state = images_.bytes(from);
            Stepped stepped = step_watched(code_, state.data(), registers.data(), &log);
            while (!stepped.endless && log.is_cut() && log.grow()) {
                state = images_.bytes(from);
                stepped = step_watched(code_, state.data(), registers.data(), &log);
            }
            if (found_.cycles.size() == most_ || stepped.endless || log.overflow != 0) {
                found_.all = false;
                return;
            }
            TrackedCycle& cycle = found_.cycles.emplace_back();
            cycle.from = from;
            cycle.registers = registers;
            cycle.choices.assign(log.choice, log.choice + log.given);
            cycle.outcome = stepped.result;
            cycle.writes.assign(log.record, log.record + log.count);
            if (cycle.outcome != RC_QUIESCENT) continue;
            const std::uint64_t before = images_.size();
            cycle.next = images_.intern(state);
            cycle.first = images_.size() > before;
        } while (next_choices(log));
    }

    const rc_interface& code_;
    std::size_t most_;
    diagnostics::Pollable& budget_;
    CodeImages images_;
    TrackedCycles found_;
};

struct DeployedCall {
    const rc_deployed* code;
    void* state;
    const rc_register* registers;
    rc_log* log;
};

rc_result run_deployed(void* arguments) {
    const auto* const call = static_cast<const DeployedCall*>(arguments);
    return call->code->step(call->state, call->registers, call->log);
}

}  // namespace

TrackedCycles explore_tracked(const rc_interface& code, const Interface& interface, std::size_t most,
                              diagnostics::Pollable& budget) {
    bool all = false;
    const std::vector<std::vector<rc_register>> combinations = combinations_of(interface, all);
    TrackedCycles result = Search(code, most, budget).explore(combinations);
    result.all = result.all && all;
    return result;
}

DeployedCode::DeployedCode(const rc_interface& code, const TrackedCycles& explored, const PartsOfTypes& parts,
                           const OutputTypes& output_types, diagnostics::Pollable& budget)
    : code_(code),
      deployed_(*code.tracking->deployed),
      explored_(explored),
      parts_(parts),
      output_types_(output_types),
      budget_(budget),
      size_(deployed_.state_size),
      states_(explored.images * size_),
      first_(explored.images, explored.cycles.size()),
      after_(size_) {
    deployed_.initial(state(explored.reset));
    for (std::size_t c = 0; c < explored.cycles.size(); ++c) {
        const TrackedCycle& cycle = explored.cycles[c];
        if (cycle.first) first_[cycle.next] = c;
        while (begin_.size() <= cycle.from) begin_.push_back(c);
        for (std::uint32_t i = 0; i < cycle.registers.size(); ++i) {
            const std::int32_t type = code.tracking->input[i];
            if (type >= 0 && cycle.registers[i].present != 0)
                readers_[{static_cast<std::uint32_t>(type), cycle.registers[i].value}].push_back(c);
        }
    }
    begin_.resize(explored.images + 1, explored.cycles.size());
}

void DeployedCode::set_values(std::uint32_t type) {
    std::vector<std::int64_t>& flat = set_[type];
    flat.clear();
    for (const NumbersOfValue& value : numbers_[type]) {
        if (deployed_.capacity[type] > 0) flat.push_back(static_cast<std::int64_t>(value.size()));
        flat.insert(flat.end(), value.begin(), value.end());
    }
    deployed_.set_values(type, static_cast<std::uint32_t>(numbers_[type].size()), flat.data());
}

/// Makes a cycle from the state of the run. Returns true if its outputs, its result and its next state are the expected
/// ones. The first cycle to an image determines the state at this image.
bool DeployedCode::make_cycle(const TrackedCycle& cycle) {
    budget_.poll();
    std::memcpy(after_.data(), state(cycle.from), size_);
    log_.clear();
    log_.reserve(static_cast<std::uint32_t>(cycle.writes.size() + 1));
    log_.given = static_cast<std::uint32_t>(cycle.choices.size());
    std::ranges::copy(cycle.choices, log_.choice);
    DeployedCall call{&deployed_, after_.data(), cycle.registers.data(), &log_};
    const rc_result outcome = call_watched(run_deployed, &call).result;
    const bool same = outcome == cycle.outcome && same_writes(cycle);
    if (cycle.outcome != RC_QUIESCENT) return same;
    if (!cycle.first) return same && deployed_.equal(after_.data(), state(cycle.next)) != 0;
    std::memcpy(state(cycle.next), after_.data(), size_);
    return same;
}

bool DeployedCode::same_writes(const TrackedCycle& cycle) const {
    if (log_.count != cycle.writes.size() || log_.overflow != 0) return false;
    for (std::uint32_t w = 0; w < log_.count; ++w) {
        const rc_record& expected = cycle.writes[w];
        const rc_record& found = log_.record[w];
        if (expected.output != found.output) return false;
        for (std::uint32_t a = 0; a < expected.count; ++a) {
            const auto type = output_types_[expected.output][a];
            const bool same = type ? same_value(*type, expected.argument[a], found.argument[a])
                                   : expected.argument[a] == found.argument[a];
            if (!same) return false;
        }
    }
    return true;
}

/// Returns whether two places of a table contain equal values; -1 denotes no value. A constant of the code still has
/// its number of the baseline, so this number is accepted too.
bool DeployedCode::same_value(std::uint32_t type, std::int64_t expected, std::int64_t found) const {
    if (expected < 0 || found < 0) return false;
    const auto place = static_cast<std::size_t>(expected);
    const std::size_t count = numbers_[type].size();
    const std::size_t explored = baseline_.empty() ? count : baseline_[type].size();
    if (same_row(type, place, static_cast<std::size_t>(found))) return true;
    return count > explored && same_row(type, place + explored, static_cast<std::size_t>(found));
}

bool DeployedCode::same_row(std::uint32_t type, std::size_t one, std::size_t other) const {
    const std::vector<ir::NumberPart>& parts = parts_[type];
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const std::int64_t a = numbers_[type][one][p];
        const std::int64_t b = numbers_[type][other][p];
        const bool zeros = parts[p].kind == ir::TypeKind::real && std::bit_cast<double>(a) == std::bit_cast<double>(b);
        if (a != b && !zeros) return false;
    }
    return true;
}

std::optional<Deviation> DeployedCode::first_deviation(const NumberTables& numbers) {
    baseline_.clear();
    numbers_ = numbers;
    set_.resize(numbers.size());
    for (std::uint32_t type = 0; type < numbers.size(); ++type) set_values(type);
    for (std::size_t c = 0; c < explored_.cycles.size(); ++c)
        if (!make_cycle(explored_.cycles[c])) return deviation_at(c);
    baseline_ = numbers;
    baseline_states_ = states_;
    return std::nullopt;
}

/// Returns the deviation in the cycle that was made last.
Deviation DeployedCode::deviation_at(std::size_t cycle) {
    const TrackedCycle& made = explored_.cycles[cycle];
    Deviation result{cycle, {log_.record, log_.record + log_.count}, state_text(deployed_.print, after_.data()), ""};
    if (made.outcome == RC_QUIESCENT && !made.first)
        result.expected_state = state_text(deployed_.print, state(made.next));
    return result;
}

bool DeployedCode::is_changed(std::uint32_t image) const {
    const std::size_t at = image * size_;
    return std::memcmp(states_.data() + at, baseline_states_.data() + at, size_) != 0;
}

/// Returns the cycles that differ from the baseline. Only cycles that read the value, or begin in a state that depends
/// on it, can differ.
std::vector<std::size_t> DeployedCode::deviations(ValuePlace changed, const NumbersOfValue& numbers) {
    const std::vector<NumbersOfValue>& baseline = baseline_[changed.type];
    std::vector<NumbersOfValue>& table = numbers_[changed.type];
    table.at(changed.value) = numbers;
    // No output contains a sequence, so no search for an equal sequence follows.
    if (deployed_.capacity[changed.type] == 0) table.insert(table.end(), baseline.begin(), baseline.end());
    set_values(changed.type);
    states_ = baseline_states_;
    const std::vector<std::size_t>& reading = readers_[{changed.type, changed.value}];
    std::set<std::size_t> open(reading.begin(), reading.end());
    std::vector<std::size_t> result;
    while (!open.empty()) {
        const std::size_t number = *open.begin();
        open.erase(open.begin());
        const TrackedCycle& cycle = explored_.cycles[number];
        if (!make_cycle(cycle)) result.push_back(number);
        if (!cycle.first || !is_changed(cycle.next)) continue;
        for (std::size_t c = begin_[cycle.next]; c < begin_[cycle.next + 1]; ++c) open.insert(c);
    }
    table.resize(baseline.size());
    table[changed.value] = baseline[changed.value];
    set_values(changed.type);
    return result;
}

std::vector<std::uint32_t> DeployedCode::readers(std::size_t cycle, ValuePlace value) const {
    std::vector<std::uint32_t> result;
    const std::vector<rc_register>& registers = explored_.cycles[cycle].registers;
    for (std::uint32_t i = 0; i < registers.size(); ++i) {
        const bool typed = code_.tracking->input[i] == static_cast<std::int32_t>(value.type);
        if (typed && registers[i].present != 0 && registers[i].value == value.value) result.push_back(i);
    }
    return result;
}

std::vector<std::size_t> DeployedCode::path_to(std::size_t cycle) const {
    std::vector<std::size_t> result{cycle};
    while (explored_.cycles[result.back()].from != explored_.reset)
        result.push_back(first_[explored_.cycles[result.back()].from]);
    std::ranges::reverse(result);
    return result;
}

}  // namespace robochart::conformance
