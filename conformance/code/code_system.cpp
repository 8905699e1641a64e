// SPDX-License-Identifier: Apache-2.0
// See code_system.hpp. Registers are read in one fixed order, which gives a tree of readings whose leaves are results
// of `step`. Equal subtrees are shared, as in a decision diagram, so a register without effect in a state costs
// nothing. docs/conformance.md, "One order of reading", explains why one order suffices.
#include "conformance/code/code_system.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <set>
#include <stdexcept>

#include "conformance/code/watchdog.hpp"

namespace robochart::conformance {

namespace {

// The layout of a packed state.
enum Place : std::size_t { phase_place, number_place, detail_place, places };
enum CodePhase : lts::Word {
    code_reads,    ///< number: node of the tree of readings; detail: number of registers that have been read
    code_acts,     ///< number: result; detail: number of writes done, then of tocks done
    code_stopped,  ///< terminated
};

/// The maximal number of results of one cycle, and of calls of `step` to find them.
constexpr std::size_t max_ways = 4096;
constexpr std::size_t max_trials = 1U << 16U;

/// Returns the event that L(G) performs if the outcome of a cycle is not allowed by the relation. No NF allows this
/// event.
const char* violation_event(const CycleResult& result) {
    switch (result.outcome) {
        case RC_PRECONDITION:
            return "code.precondition";
        case RC_QUIESCENT:
        case RC_DEADLINE:
        case RC_TERMINATED:
        case RC_STEP_BOUND:
            return nullptr;
    }
    return "code.unknown_result";
}

}  // namespace

Interface interface_of(const rc_interface& code) {
    Interface interface;
    interface.component = code.component == nullptr ? "" : code.component;
    interface.scale = code.scale;
    for (std::uint32_t i = 0; i < code.inputs; ++i) {
        const rc_input& input = code.input[i];
        Register& shown = interface.inputs.emplace_back();
        shown.name = input.name;
        shown.values.assign(input.value, input.value + input.values);
        shown.texts.assign(input.text, input.text + input.values);
    }
    for (std::uint32_t o = 0; o < code.outputs; ++o)
        interface.outputs.push_back({code.output[o].name, std::vector<Carrier>(code.output[o].arguments)});
    return interface;
}

CodeSystem::CodeSystem(const rc_interface& code, const Alphabet& alphabet, std::uint32_t cycle_length)
    : code_(&code), alphabet_(&alphabet), cycle_length_(cycle_length == 0 ? 1 : cycle_length), images_(code) {
    std::uint64_t valuations = 1;
    for (const Register& input : alphabet.interface().inputs) {
        valuations *= input.reading_count();
        if (valuations > max_valuations)
            throw std::length_error(fmt::format("the inputs have more than {} valuations together", max_valuations));
    }
    if (!images_.reset_writes_all()) unsound_ = "`initial` does not write the whole state";
}

std::size_t CodeSystem::width() const {
    return places;
}

void CodeSystem::initial(std::span<lts::Word> state) {
    enter_cycle(state, reset_image());
}

void CodeSystem::enter_cycle(std::span<lts::Word> state, std::uint32_t image) {
    state[phase_place] = alphabet_->interface().inputs.empty() ? code_acts : code_reads;
    state[number_place] = reading_tree(image);
    state[detail_place] = 0;
}

void CodeSystem::successors(lts::StateView state, lts::SuccessorSink& sink) {
    if (state[phase_place] == code_acts) add_writes(state, sink);
    if (state[phase_place] == code_reads) add_reads(state, sink);
}

void CodeSystem::add_reads(lts::StateView state, lts::SuccessorSink& sink) {
    const std::uint32_t input = state[detail_place];
    const bool last = input + 1 == alphabet_->interface().inputs.size();
    const Node& node = nodes_[state[number_place]];
    for (std::uint32_t r = 0; r < node.size(); ++r) {
        const std::array<lts::Word, places> next{last ? code_acts : code_reads, node[r], last ? 0 : input + 1};
        const process::Event event = alphabet_->read_event(input, r);
        sink.add(event, next, event);
    }
}

void CodeSystem::add_writes(lts::StateView state, lts::SuccessorSink& sink) {
    const CycleResult& result = results_[state[number_place]];
    for (const std::uint32_t way : result.ways)
        sink.add(process::tau, std::array<lts::Word, places>{code_acts, way, 0}, process::tau);
    if (!result.ways.empty()) return;
    if (state[detail_place] >= result.writes.size()) return add_end_of_cycle(state, result, sink);
    const std::array<lts::Word, places> next{code_acts, state[number_place], state[detail_place] + 1};
    const process::Event event = result.writes[state[detail_place]];
    sink.add(event, next, event);
}

void CodeSystem::add_end_of_cycle(lts::StateView state, const CycleResult& result, lts::SuccessorSink& sink) {
    std::array<lts::Word, places> next{code_stopped, 0, 0};
    if (const char* const wrong = violation_event(result)) {
        const process::Event event = alphabet_->events().intern(wrong);
        sink.add(event, next, event);
    } else if (result.outcome == RC_TERMINATED) {
        sink.add(process::tick, next, process::tick);
    } else if (result.outcome == RC_DEADLINE) {
        return;  // the code cannot stop time, only report that the model has stopped
    } else if (result.outcome == RC_STEP_BOUND) {
        sink.add(process::tau, state, process::tau);
    } else {
        if (state[detail_place] + 1 == result.writes.size() + cycle_length_)
            enter_cycle(next, result.next);
        else
            next = {code_acts, state[number_place], state[detail_place] + 1};
        sink.add(alphabet_->tock(), next, alphabet_->tock());
    }
}

std::string CodeSystem::describe(lts::StateView state) const {
    if (state[phase_place] == code_stopped) return "stopped";
    if (state[phase_place] == code_reads) return fmt::format("{} registers read", state[detail_place]);
    return "in the cycle that leads to " + print_image(results_[state[number_place]].next);
}

std::uint32_t CodeSystem::reading_tree(std::uint32_t image) {
    const auto found = roots_.find(image);
    if (found != roots_.end()) return found->second;
    std::vector<rc_register> registers(alphabet_->interface().inputs.size());
    const std::uint32_t made = build_tree(image_bytes(image), registers, 0);
    roots_.emplace(image, made);
    begun_.push_back(image);
    return made;
}

/// Builds the tree below the first `read` registers, whose readings are set. Recursion depth: the number of registers.
std::uint32_t CodeSystem::build_tree(const Bytes& from, std::vector<rc_register>& registers, std::size_t read) {
    if (read == registers.size()) return run_all_choices(from, registers);
    Node node;
    const std::uint32_t readings = alphabet_->interface().inputs[read].reading_count();
    for (std::uint32_t r = 0; r < readings; ++r) {
        registers[read] = {r == 0 ? 0U : 1U, r == 0 ? 0U : r - 1};
        node.push_back(build_tree(from, registers, read + 1));
    }
    return intern_node(read, std::move(node));
}

void CodeSystem::append_to_key(std::uint32_t number) {
    std::array<char, sizeof number> bytes{};
    std::memcpy(bytes.data(), &number, sizeof number);
    key_.append(bytes.data(), bytes.size());
}

std::uint32_t CodeSystem::intern_node(std::size_t level, Node node) {
    key_.clear();
    append_to_key(static_cast<std::uint32_t>(level));
    for (const std::uint32_t child : node) append_to_key(child);
    const auto [place, fresh] = node_ids_.try_emplace(key_, static_cast<std::uint32_t>(nodes_.size()));
    if (fresh) nodes_.push_back(std::move(node));
    return place->second;
}

/// Returns one result, or a choice between the results of all branches of probabilistic junctions.
std::uint32_t CodeSystem::run_all_choices(const Bytes& from, const std::vector<rc_register>& registers) {
    log_.clear();
    log_.given = 0;
    std::vector<std::uint32_t> ways;
    std::size_t trials = 0;
    do {
        if (++trials > max_trials) throw std::length_error("a cycle has too many choices");
        const std::uint32_t result = run_once(from, registers);
        if (std::ranges::find(ways, result) == ways.end()) ways.push_back(result);
        if (ways.size() > max_ways) throw std::length_error("a cycle has too many branches");
    } while (next_choices(log_));
    if (ways.size() == 1) return ways.front();
    CycleResult choice;
    choice.ways = std::move(ways);
    return intern_result(std::move(choice));
}

/// Calls `step` twice on copies of the state. This reveals a controller with memory outside its state.
std::uint32_t CodeSystem::run_once(const Bytes& from, const std::vector<rc_register>& registers) {
    ++cycles_;
    budget_->poll();
    once_ = from;
    twice_ = from;
    const Patience patience = endless_ ? Patience::short_ : Patience::seconds;
    Stepped stepped = step_watched(*code_, once_.data(), registers.data(), &log_, patience);
    while (!stepped.endless && log_.is_cut()) {
        if (!log_.grow()) throw std::length_error(fmt::format("a cycle makes more than {} outputs", log_.most_records));
        again_.reserve(log_.capacity);
        once_ = from;
        stepped = step_watched(*code_, once_.data(), registers.data(), &log_, patience);
    }
    if (stepped.endless) return endless(from);
    most_writes_ = std::max(most_writes_, log_.count);
    again_.clear();
    again_.given = log_.given;
    std::copy_n(log_.choice, log_.given, again_.choice);
    const rc_result outcome = stepped.result;
    if (outcome != code_->step(twice_.data(), registers.data(), &again_) || once_ != twice_ ||
        !same_writes(log_, again_))
        unsound_ = "`step` gives two results for one state and one set of inputs";
    return intern_result(result_of(outcome, log_, once_));
}

/// Treats a call that does not return as a divergence, like an exceeded step bound. The state that the call leaves is
/// ignored.
std::uint32_t CodeSystem::endless(const Bytes& from) {
    endless_ = true;
    CycleResult result;
    result.outcome = RC_STEP_BOUND;
    result.next = images_.intern(from);
    return intern_result(std::move(result));
}

CycleResult CodeSystem::result_of(rc_result outcome, const rc_log& log, const Bytes& after) {
    if ((log.overflow & ROBOCHART_OVERFLOW_CHOICES) != 0)
        throw std::length_error(fmt::format("a cycle makes more than {} choices", ROBOCHART_MAX_CHOICES));
    CycleResult result;
    result.outcome = outcome;
    for (std::uint32_t r = 0; r < log.count; ++r) {
        const rc_record& record = log.record[r];
        if (record.output >= code_->outputs || record.count > ROBOCHART_MAX_ARGUMENTS)
            throw AlphabetError("the code logs an output that its interface does not have");
        result.writes.push_back(
            alphabet_->write_event(record.output, {record.argument, record.argument + record.count}));
    }
    result.next = images_.intern(after);
    return result;
}

std::uint32_t CodeSystem::intern_result(CycleResult result) {
    key_.clear();
    append_to_key(static_cast<std::uint32_t>(result.outcome));
    append_to_key(result.next);
    append_to_key(static_cast<std::uint32_t>(result.writes.size()));
    for (const process::Event event : result.writes) append_to_key(event);
    for (const std::uint32_t way : result.ways) append_to_key(way);
    const auto [place, fresh] = result_ids_.try_emplace(key_, static_cast<std::uint32_t>(results_.size()));
    if (fresh) results_.push_back(std::move(result));
    return place->second;
}

/// For each image, the cycle by which it was first reached.
struct CodeSystem::Found {
    struct From {
        std::uint32_t image = 0;
        PassedCycle cycle;
    };
    std::unordered_map<std::uint32_t, From> from;  ///< never iterated
};

/// Visits the images to which one cycle from this image leads, and each node of the tree of readings once.
void CodeSystem::explore_cycles_from(std::uint32_t image, std::vector<std::uint32_t>& open, Found& found) const {
    const std::size_t inputs = alphabet_->interface().inputs.size();
    struct Place {
        std::uint32_t node;
        std::vector<std::uint32_t> readings;
    };
    std::vector<std::unordered_map<std::uint32_t, bool>> seen(inputs + 1);
    std::deque<Place> places{{roots_.at(image), {}}};
    while (!places.empty()) {
        const Place place = std::move(places.front());
        places.pop_front();
        if (!seen[place.readings.size()].emplace(place.node, true).second) continue;
        if (place.readings.size() < inputs) {
            for (std::uint32_t r = 0; r < nodes_[place.node].size(); ++r) {
                places.push_back({nodes_[place.node][r], place.readings});
                places.back().readings.push_back(r);
            }
            continue;
        }
        const CycleResult& result = results_[place.node];
        const std::vector<std::uint32_t> ways = result.ways.empty() ? std::vector{place.node} : result.ways;
        for (const std::uint32_t way : ways) {
            const std::uint32_t next = results_[way].next;
            if (results_[way].outcome != RC_QUIESCENT || next == reset_image() || roots_.count(next) == 0) continue;
            if (found.from.emplace(next, Found::From{image, {place.readings, &results_[way]}}).second)
                open.push_back(next);
        }
    }
}

std::vector<PassedCycle> CodeSystem::path_to_image(std::uint32_t image) const {
    Found found;
    std::vector<std::uint32_t> open{reset_image()};
    for (std::size_t i = 0; i < open.size() && found.from.count(image) == 0 && image != reset_image(); ++i)
        explore_cycles_from(open[i], open, found);
    std::vector<PassedCycle> way;
    while (image != reset_image() && found.from.count(image) != 0) {
        const Found::From& from = found.from.at(image);
        way.insert(way.begin(), from.cycle);
        image = from.image;
    }
    return way;
}

/// Returns which of the registers from this one on make no difference. Recursion depth: the number of registers.
const std::vector<bool>& CodeSystem::without_effect_below(std::uint32_t node, std::size_t level) const {
    const std::size_t inputs = alphabet_->interface().inputs.size();
    without_effect_.resize(inputs + 1);
    const auto found = without_effect_[level].find(node);
    if (found != without_effect_[level].end()) return found->second;
    std::vector<bool> lost(inputs + 1, true);
    if (level < inputs) {
        const Node& below = nodes_[node];
        lost[level] = std::ranges::all_of(below, [&](std::uint32_t child) { return child == below[0]; });
        for (const std::uint32_t child : std::set<std::uint32_t>(below.begin(), below.end())) {
            const std::vector<bool>& inner = without_effect_below(child, level + 1);
            for (std::size_t i = level + 1; i < inputs; ++i) lost[i] = lost[i] && inner[i];
        }
    }
    return without_effect_[level].emplace(node, std::move(lost)).first->second;
}

std::vector<bool> CodeSystem::without_effect(std::uint32_t image) const {
    return without_effect_below(roots_.at(image), 0);
}

std::vector<std::uint32_t> CodeSystem::next_images(std::uint32_t image) const {
    std::set<std::uint32_t> level{roots_.at(image)};
    for (std::size_t i = 0; i < alphabet_->interface().inputs.size(); ++i) {
        std::set<std::uint32_t> next;
        for (const std::uint32_t node : level) next.insert(nodes_[node].begin(), nodes_[node].end());
        level = std::move(next);
    }
    std::set<std::uint32_t> images;
    for (const std::uint32_t number : level) {
        const CycleResult& result = results_[number];
        if (result.ways.empty() && result.outcome == RC_QUIESCENT) images.insert(result.next);
        for (const std::uint32_t way : result.ways)
            if (results_[way].outcome == RC_QUIESCENT) images.insert(results_[way].next);
    }
    return {images.begin(), images.end()};
}

std::vector<process::Event> CodeSystem::writes(std::uint32_t image, const std::vector<Raised>& raised) const {
    std::uint32_t node = roots_.at(image);
    for (std::size_t input = 0; input < alphabet_->interface().inputs.size(); ++input) {
        const auto found = std::ranges::find(raised, input, &Raised::first);
        node = nodes_[node][found == raised.end() ? 0 : found->second];
    }
    return results_[node].ways.empty() ? results_[node].writes : std::vector<process::Event>();
}

const CycleResult& CodeSystem::step(std::uint32_t image, const std::vector<std::uint32_t>& readings,
                                    const std::vector<process::Event>& writes) {
    std::uint32_t at = reading_tree(image);
    for (std::size_t i = 0; i < alphabet_->interface().inputs.size(); ++i)
        at = nodes_[at][i < readings.size() ? readings[i] : 0];
    const std::vector<std::uint32_t>& ways = results_[at].ways;
    if (ways.empty()) return results_[at];
    const auto begins = [&](std::uint32_t way) {
        const std::vector<process::Event>& made = results_[way].writes;
        return made.size() >= writes.size() && std::equal(writes.begin(), writes.end(), made.begin());
    };
    const auto found = std::ranges::find_if(ways, begins);
    return results_[found == ways.end() ? ways.front() : *found];
}

}  // namespace robochart::conformance
