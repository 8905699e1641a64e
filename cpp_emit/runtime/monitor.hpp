// Implements a runtime monitor for a controller. It follows the controller's inputs and outputs in the normal form of
// its model, and reports the first event that the model does not allow. It consists of a state number and dense tables;
// it uses no heap and no exceptions. Delivered with generated monitors. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_MONITOR_HPP
#define ROBOCHART_MONITOR_HPP

#include <cstddef>
#include <cstdint>

namespace robochart {

/// The values of an argument, ascending. They are numbers of the model times `scale`.
struct MonitorValues {
    const std::int64_t* value;
    std::uint32_t count;
    std::int64_t scale;
    bool consecutive;  ///< value[i] is value[0] + i
    bool passed_on;    ///< a value may represent other values, because the model only passes them on
};

/// An input or output.
struct MonitorChannel {
    const char* name;             ///< name in the model: "seeRobot", "MoveForward"
    const char* element;          ///< element with file and line
    const MonitorValues* values;  ///< values of each argument
    std::uint32_t arguments;
    /// The columns of the table. For inputs: absent, then present with each value. For outputs: by the indices of the
    /// arguments' values; the last argument varies fastest.
    const std::uint16_t* column;
};

struct MonitorTables {
    const char* component;
    std::uint32_t cycle_length;  ///< number of tocks in a cycle
    std::uint32_t states;
    std::uint32_t columns;
    const std::uint16_t* next;  ///< [state * columns + column]
    std::uint32_t inputs;
    const MonitorChannel* input;
    std::uint32_t outputs;
    const MonitorChannel* output;
    std::uint16_t tock;  ///< the column of tock
    std::uint16_t tick;
    const char* const* where;  ///< for states in which cycles begin: the possible elements of the model; otherwise null
};

enum class MonitorVerdict : std::uint8_t {
    allowed,   ///< all observed events are a run of the model
    violated,  ///< the last observed event is not allowed
    unknown,   ///< a value outside the finite instantiation on which the model depends: later events cannot be checked
};

/// The monitor is a value of a few bytes. Call it in every cycle: with each input in the order of the table, with the
/// writes in their order, and then with the time units.
class Monitor {
public:
    static constexpr std::uint16_t dead = 0xffff;

    explicit constexpr Monitor(const MonitorTables& tables) noexcept : tables_(&tables) {}

    constexpr void absent(std::uint32_t input) noexcept { take(tables_->input[input].column[0], input, 'r'); }
    constexpr void read(std::uint32_t input) noexcept { take(tables_->input[input].column[1], input, 'r'); }
    template <class Value>
    constexpr void read(std::uint32_t input, Value value) noexcept {
        const std::uint32_t place = place_of(tables_->input[input].values[0], value);
        if (place == no_place) return lose();
        take(tables_->input[input].column[1 + place], input, 'r');
    }
    template <class... Values>
    constexpr void wrote(std::uint32_t output, Values... values) noexcept {
        std::uint32_t place = 0;
        std::uint32_t argument = 0;
        const MonitorChannel& channel = tables_->output[output];
        ((place = add(place, channel.values[argument++], values)), ...);
        if (place == no_place) return lose();
        take(channel.column[place], output, 'w');
    }
    /// To report a write, call `start`, then `argument` for each argument, then `wrote_at`.
    static constexpr std::uint32_t start() noexcept { return 0; }
    template <class Value>
    constexpr std::uint32_t argument(std::uint32_t place, std::uint32_t output, std::uint32_t number,
                                     Value value) noexcept {
        return add(place, tables_->output[output].values[number], value);
    }
    constexpr void wrote_at(std::uint32_t output, std::uint32_t place) noexcept {
        if (place == no_place) return lose();
        take(tables_->output[output].column[place], output, 'w');
    }
    /// Ends the cycle, so that its time units pass.
    constexpr void end_of_cycle() noexcept {
        for (std::uint32_t t = 0; t < tables_->cycle_length; ++t) take(tables_->tock, 0, 't');
        if (verdict_ == MonitorVerdict::allowed) begun_ = state_;
    }
    /// Replaces all calls for a cycle that is known to be allowed. The next cycle begins in `state`, as it did when the
    /// same events were observed from the same state.
    constexpr void continue_at(std::uint16_t state) noexcept {
        state_ = state;
        begun_ = state;
    }
    constexpr void terminated() noexcept { take(tables_->tick, 0, 'e'); }
    constexpr void reset() noexcept { *this = Monitor(*tables_); }

    [[nodiscard]] constexpr MonitorVerdict verdict() const noexcept { return verdict_; }
    /// After a violation: returns the name of the input or output, or "the end of the cycle", "termination".
    [[nodiscard]] constexpr const char* event() const noexcept {
        if (kind_ == 'r') return tables_->input[channel_].name;
        if (kind_ == 'w') return tables_->output[channel_].name;
        return kind_ == 't' ? "the end of the cycle" : "termination";
    }
    /// After a violation: returns the element of the event in the model; "" for time and termination.
    [[nodiscard]] constexpr const char* element() const noexcept {
        if (kind_ == 'r') return tables_->input[channel_].element;
        return kind_ == 'w' ? tables_->output[channel_].element : "";
    }
    /// Returns the possible elements of the model, with file and line, when the cycle began.
    [[nodiscard]] constexpr const char* where() const noexcept {
        return tables_->where[begun_] == nullptr ? "" : tables_->where[begun_];
    }
    [[nodiscard]] constexpr std::uint16_t state() const noexcept { return state_; }

    /// The functions below return the index of a value among those of an argument, or the index of the value that
    /// represents it. They return `no_place` for values outside the finite instantiation.
    static constexpr std::uint32_t no_place = 0xffffffffU;
    static constexpr std::uint32_t place_of(const MonitorValues& values, bool value) noexcept {
        return among(values, value ? 1 : 0, value ? 1U : 0U);
    }
    static constexpr std::uint32_t place_of(const MonitorValues& values, std::int64_t value) noexcept {
        const auto bits = static_cast<std::uint64_t>(value);
        if (values.scale == 1) return among(values, value, bits);
        const std::int64_t most = 4000000000000000 / values.scale;
        return value < -most || value > most ? outside(values, bits) : among(values, value * values.scale, bits);
    }
    /// The relative error of a decimal of the model in binary floating point is less than 1e-9.
    static constexpr std::uint32_t place_of(const MonitorValues& values, double value) noexcept {
        const double scaled = value * static_cast<double>(values.scale);
        if (!(scaled > -9e15 && scaled < 9e15)) return outside(values, 1);
        const auto near = static_cast<std::int64_t>(scaled < 0 ? scaled - 0.5 : scaled + 0.5);
        const double rest = scaled - static_cast<double>(near);
        const double size = scaled < 0 ? -scaled : scaled;
        const bool whole = (rest < 0 ? -rest : rest) <= 1e-9 * (size < 1 ? 1 : size);
        const auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(value * 1e3));
        return whole ? among(values, near, bits) : outside(values, bits);
    }

private:
    constexpr void take(std::uint16_t column, std::uint32_t channel, char kind) noexcept {
        if (verdict_ != MonitorVerdict::allowed) return;
        const std::uint16_t next =
            column == dead ? dead : tables_->next[std::size_t{state_} * tables_->columns + column];
        if (next != dead) {
            state_ = next;
            return;
        }
        verdict_ = MonitorVerdict::violated;
        channel_ = static_cast<std::uint16_t>(channel);
        kind_ = kind;
    }

    constexpr void lose() noexcept {
        if (verdict_ == MonitorVerdict::allowed) verdict_ = MonitorVerdict::unknown;
    }

    template <class Value>
    static constexpr std::uint32_t add(std::uint32_t place, const MonitorValues& values, Value value) noexcept {
        const std::uint32_t here = place == no_place ? no_place : place_of(values, value);
        return here == no_place ? no_place : place * values.count + here;
    }

    static constexpr std::uint32_t among(const MonitorValues& values, std::int64_t value, std::uint64_t bits) noexcept {
        if (values.consecutive) {
            // The difference is unsigned, so values before the first one get an index far beyond the last.
            const std::uint64_t place = static_cast<std::uint64_t>(value) - static_cast<std::uint64_t>(values.value[0]);
            return place < values.count ? static_cast<std::uint32_t>(place) : outside(values, bits);
        }
        std::uint32_t low = 0;
        std::uint32_t high = values.count;
        while (low < high) {
            const std::uint32_t middle = low + (high - low) / 2;
            if (values.value[middle] < value)
                low = middle + 1;
            else
                high = middle;
        }
        return low < values.count && values.value[low] == value ? low : outside(values, bits);
    }

    static constexpr std::uint32_t outside(const MonitorValues& values, std::uint64_t bits) noexcept {
        if (values.passed_on && values.count > 0)
            return static_cast<std::uint32_t>((bits * 0x9E3779B97F4A7C15ULL >> 32U) % values.count);
        return no_place;
    }

    const MonitorTables* tables_;
    std::uint16_t state_ = 0;
    std::uint16_t begun_ = 0;
    std::uint16_t channel_ = 0;
    char kind_ = ' ';
    MonitorVerdict verdict_ = MonitorVerdict::allowed;
};

}  // namespace robochart

#endif
