// SPDX-License-Identifier: Apache-2.0
#include "conformance/monitor/cycle_cache.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace robochart::conformance {

namespace {

constexpr std::size_t slots = 2048;
constexpr std::size_t most_inputs = 48;  ///< number of bits of a key

/// Returns one of eight slots, which the exponent selects, because constants of a model usually differ in magnitude.
std::size_t slot_of(std::uint64_t bits) {
    return bits >> 52U & 7U;
}

}  // namespace

CycleCache::CycleCache(const MonitorTables& tables, const std::vector<cpp_emit::Port>& inputs,
                       const std::vector<cpp_emit::Port>& outputs)
    : slots_(slots) {
    for (std::uint32_t i = 0; i < tables.inputs; ++i) {
        inputs_.push_back(make_channel(tables.input[i], inputs.at(i)));
        if (inputs_.back().count > 0) valued_.push_back(i);
    }
    for (std::uint32_t o = 0; o < tables.outputs; ++o)
        outputs_.push_back(make_channel(tables.output[o], outputs.at(o)));
    input_count_ = inputs_.size();
    for (const std::uint32_t i : valued_)
        width_ = std::max(width_, static_cast<unsigned>(std::bit_width(tables.input[i].values[0].count)));
    has_keys_ = tables.inputs <= most_inputs && valued_.size() * width_ <= 64;
}

CycleCache::Channel CycleCache::make_channel(const MonitorChannel& table, const cpp_emit::Port& port) {
    Channel result{table.column, table.arguments};
    if (table.arguments == 0) result.alone = table.column[0];
    for (std::uint32_t a = 0; a < table.arguments; ++a)
        result.carriers.push_back(carrier_number(table.values[a], port.arguments.at(a) == cpp_emit::Carried::real));
    if (table.arguments > 0) result.carrier = result.carriers.front();
    return result;
}

/// Returns the number of a carrier. Arguments with the same range share a carrier.
std::uint32_t CycleCache::carrier_number(const MonitorValues& values, bool real) {
    const auto same = [&](const Carrier& other) {
        const MonitorValues& others = *other.values;
        return other.real == real && others.scale == values.scale && others.passed_on == values.passed_on &&
               std::equal(others.value, others.value + others.count, values.value, values.value + values.count);
    };
    const auto found = std::ranges::find_if(carriers_, same);
    if (found != carriers_.end()) return static_cast<std::uint32_t>(found - carriers_.begin());
    Carrier& made = carriers_.emplace_back();
    made.values = &values;
    made.real = real;
    if (values.count > 0) made.first = static_cast<std::uint64_t>(values.value[0]);
    made.consecutive = values.consecutive && values.scale == 1 ? values.count : 0;
    for (auto& known : made.known) known.place = Monitor::place_of(values, 0.0);  // zero has no bits set
    return static_cast<std::uint32_t>(carriers_.size() - 1);
}

inline std::uint32_t CycleCache::carrier_place(std::uint32_t number, rc_value value) {
    Carrier& carrier = carriers_[number];
    if (carrier.real) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value.real, sizeof bits);
        const auto& known = carrier.known[slot_of(bits)];
        if (bits == known.bits) return known.place;
    } else {
        const std::uint64_t after = static_cast<std::uint64_t>(value.whole) - carrier.first;
        if (after < carrier.consecutive) return static_cast<std::uint32_t>(after);
    }
    return new_place(carrier, value);
}

/// Computes a place that is not stored yet. Such calls are rare, so they are in a separate function, which keeps the
/// frequent path small.
[[gnu::noinline]] std::uint32_t CycleCache::new_place(Carrier& carrier, rc_value value) {
    if (!carrier.real) return Monitor::place_of(*carrier.values, value.whole);
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value.real, sizeof bits);
    auto& known = carrier.known[slot_of(bits)];
    known = {bits, Monitor::place_of(*carrier.values, value.real)};
    return known.place;
}

[[gnu::noinline]] std::uint32_t CycleCache::output_column(const rc_action& action) {
    const Channel& output = outputs_[action.output];
    if (output.count == 0) return output.alone;
    if (output.count > 1) return column_of_many(action);
    const std::uint32_t value = carrier_place(output.carrier, action.argument[0]);
    return value == Monitor::no_place ? value : output.column[value];
}

[[gnu::noinline]] std::uint32_t CycleCache::column_of_many(const rc_action& action) {
    const Channel& output = outputs_[action.output];
    std::uint32_t at = 0;
    for (std::uint32_t k = 0; k < output.count; ++k) {
        const std::uint32_t value = carrier_place(output.carriers[k], action.argument[k]);
        if (value == Monitor::no_place) return value;
        at = at * carriers_[output.carriers[k]].values->count + value;
    }
    return output.column[at];
}

/// Makes the key of a cycle. Returns false if a reading is not finite.
inline bool CycleCache::make_key(const rc_signal* inputs, Key& key) {
    std::uint64_t present = 0;
    for (const rc_signal* input = inputs; input != inputs + input_count_; ++input)
        present = present << 1U | std::uint64_t{input->present != 0};
    std::uint64_t values = 0;
    for (const std::uint32_t i : valued_) {
        if (inputs[i].present == 0) continue;
        const std::uint32_t value = carrier_place(inputs_[i].carrier, inputs[i].value);
        if (value == Monitor::no_place) return false;
        values = values << width_ | value;
    }
    key = {key.head | present << 16U, values};
    return true;
}

/// Hashes the key by multiplication by odd random constants. The upper bits of a product depend on all bits of its
/// factor.
inline CycleCache::Slot& CycleCache::slot_for_key(const Key& key) {
    const std::uint64_t mixed = key.head * 0x9E3779B97F4A7C15ULL + key.values * 0xC2B2AE3D27D4EB4FULL;
    static_assert(slots == std::size_t{1} << 11U);
    return slots_[mixed >> 53U];
}

/// Compares an output with a stored one. Most values are compared by their bits. Numbers that the model only passes on
/// are compared by the values that represent them.
inline bool CycleCache::matches_recorded(const Done& done, const rc_action& action) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &action.argument[0], sizeof bits);
    if ((((bits ^ done.bits) & done.mask) | (action.output ^ done.output) | done.many) == 0) return true;
    return action.output == done.output && output_column(action) == done.column;
}

inline bool CycleCache::matches_recorded(const Slot& known, const rc_actions& outputs) {
    if (known.count != outputs.count) return false;
    for (std::uint32_t a = 0; a < outputs.count; ++a)
        if (!matches_recorded(known.done[a], outputs.action[a])) return false;
    return true;
}

void CycleCache::store_cycle(Slot& known, const Key& key, const rc_actions& outputs, std::uint16_t next) {
    known.key = key;
    known.count = outputs.count;
    known.next = next;
    for (std::uint32_t a = 0; a < outputs.count; ++a) {
        const rc_action& action = outputs.action[a];
        const std::uint32_t arguments = outputs_[action.output].count;
        Done& done = known.done[a];
        std::memcpy(&done.bits, &action.argument[0], sizeof done.bits);
        done.mask = arguments == 0 ? 0 : ~std::uint64_t{0};
        done.output = action.output;
        done.column = static_cast<std::uint16_t>(output_column(action));
        done.many = arguments > 1 ? 1 : 0;
    }
}

void CycleCache::pass_cycle(Monitor& monitor, const rc_signal* inputs, const rc_actions& outputs,
                            rc_drive_result result) {
    Key key;
    key.head = monitor.state();
    const bool has_key = has_keys_ && result == RC_DRIVE_QUIESCENT && monitor.verdict() == MonitorVerdict::allowed &&
                         make_key(inputs, key);
    if (!has_key) return pass_events(monitor, inputs, outputs, result);
    Slot& first = slot_for_key(key);
    if (first.key == key && matches_recorded(first, outputs)) {
        ++remembered_;
        return monitor.continue_at(first.next);
    }
    try_second_slot(first, key, monitor, inputs, outputs);
}

/// Looks in the second slot of a pair. A pair of slots stores two outcomes, the latest first.
[[gnu::noinline]] void CycleCache::try_second_slot(Slot& first, const Key& key, Monitor& monitor,
                                                   const rc_signal* inputs, const rc_actions& outputs) {
    Slot& second = slots_[static_cast<std::size_t>(&first - slots_.data()) ^ 1U];
    if (second.key == key && matches_recorded(second, outputs)) {
        ++remembered_;
        return monitor.continue_at(second.next);
    }
    pass_events(monitor, inputs, outputs, RC_DRIVE_QUIESCENT);
    if (monitor.verdict() != MonitorVerdict::allowed || outputs.count > most_done) return;
    second = first;
    store_cycle(first, key, outputs, monitor.state());
}

[[gnu::noinline]] void CycleCache::pass_events(Monitor& monitor, const rc_signal* inputs, const rc_actions& outputs,
                                               rc_drive_result result) const {
    for (std::uint32_t i = 0; i < inputs_.size(); ++i) {
        if (inputs[i].present == 0)
            monitor.absent(i);
        else if (inputs_[i].count == 0)
            monitor.read(i);
        else if (carriers_[inputs_[i].carrier].real)
            monitor.read(i, inputs[i].value.real);
        else
            monitor.read(i, inputs[i].value.whole);
    }
    for (std::uint32_t a = 0; a < outputs.count; ++a) {
        const rc_action& action = outputs.action[a];
        const Channel& output = outputs_[action.output];
        std::uint32_t place = Monitor::start();
        for (std::uint32_t k = 0; k < output.count; ++k)
            place = carriers_[output.carriers[k]].real
                        ? monitor.argument(place, action.output, k, action.argument[k].real)
                        : monitor.argument(place, action.output, k, action.argument[k].whole);
        monitor.wrote_at(action.output, place);
    }
    if (result == RC_DRIVE_QUIESCENT) monitor.end_of_cycle();
    if (result == RC_DRIVE_TERMINATED) monitor.terminated();
}

}  // namespace robochart::conformance
