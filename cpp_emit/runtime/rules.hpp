// Tracks obligations of SLEEC rules at run time: the demands of a trigger, and the effect of events and seconds on
// them. Uses no heap and no exceptions. Delivered with generated monitors of rules. Copyright: see LICENSE
// (Apache-2.0).
#ifndef ROBOCHART_RULES_HPP
#define ROBOCHART_RULES_HPP

#include <cstddef>
#include <cstdint>

namespace robochart {

/// The end of a window without a limit.
inline constexpr std::int64_t rule_forever = INT64_MAX;
/// The value that represents the end of a second instead of an event.
inline constexpr std::uint32_t rule_no_event = 0xffffffffU;

/// The events that match an event without `_`: only the event itself.
struct RuleSameEvent {
    static constexpr bool contains(std::uint32_t demanded, std::uint32_t event) noexcept { return demanded == event; }
};

/// A demand of a response. Its event must happen, or must not happen, `from` to `to` seconds after the instant at which
/// the response begins.
struct RuleDemand {
    bool forbids;
    std::uint32_t event;
    std::int64_t from;
    std::int64_t to;  ///< inclusive; rule_forever: no limit
};

/// The text of a rule.
struct RuleText {
    const char* name;
    const char* text;   ///< "when Go then Stop within 5 seconds"
    const char* place;  ///< "rules.sleec:11"
};

/// A violated obligation.
struct RuleViolation {
    std::uint32_t rule;   ///< index in the file
    std::int64_t began;   ///< second of its trigger
    std::int64_t second;  ///< second of the violation
    std::uint32_t event;  ///< the event that violated it, or rule_no_event: the second ended without the demanded event
};

/// The bounds of sums and products in conditions.
inline constexpr std::int64_t rule_largest = 4000000000000000000;
constexpr std::int64_t rule_bounded(std::int64_t value) noexcept {
    return value > rule_largest ? rule_largest : value < -rule_largest ? -rule_largest : value;
}
constexpr std::int64_t rule_sum(std::int64_t a, std::int64_t b) noexcept {
    std::int64_t result = 0;
    if (__builtin_add_overflow(a, b, &result)) return a < 0 ? -rule_largest : rule_largest;
    return rule_bounded(result);
}
constexpr std::int64_t rule_product(std::int64_t a, std::int64_t b) noexcept {
    std::int64_t result = 0;
    if (__builtin_mul_overflow(a, b, &result)) return (a < 0) != (b < 0) ? -rule_largest : rule_largest;
    return rule_bounded(result);
}

/// The obligation of a trigger. At most one of `Demands` demands is active; a demand after `otherwise` begins when the
/// window of the previous one ends. `Endings` is the number of events that may end the obligation (`unless EVENT`).
/// `Cases` decides which events fulfil or break a demand.
template <std::size_t Demands, std::size_t Endings, class Cases = RuleSameEvent>
class RuleDuty {
    static_assert(Demands > 0 && Demands <= 32);

public:
    enum class Effect : std::uint8_t { open, fulfilled, broken };

    constexpr RuleDuty() noexcept = default;
    constexpr RuleDuty(std::uint32_t rule, std::int64_t began) noexcept : rule_(rule), began_(began) {}

    constexpr void ended_by(std::uint32_t event) noexcept { ends_[endings_++] = event; }
    /// Adds the next alternative.
    constexpr void ask(const RuleDemand& demand) noexcept {
        const bool open = demand.to == rule_forever;
        const std::int64_t end = open ? rule_forever : next_ + demand.to;
        any_[demands_++] = {demand.forbids, demand.event, next_ + demand.from, end};
        const std::int64_t settled = open ? next_ + demand.from : end + 1;
        if (settled > horizon_) horizon_ = settled;
        if (!open) next_ += demand.to;
    }

    /// Processes an event after the trigger, at the current instant.
    constexpr Effect event(std::uint32_t event) noexcept {
        for (std::size_t i = 0; i < endings_; ++i)
            if (ends_[i] == event) return Effect::fulfilled;
        for (std::size_t i = 0; i < demands_; ++i) {
            const RuleDemand& demand = any_[i];
            if (!Cases::contains(demand.event, event) || elapsed_ < demand.from || elapsed_ > demand.to) continue;
            if (!demand.forbids) return Effect::fulfilled;
            broken_ |= std::uint32_t{1} << i;
        }
        return fate();
    }
    /// Lets a second pass.
    constexpr Effect second() noexcept {
        if (elapsed_ < horizon_) ++elapsed_;
        for (std::size_t i = 0; i < demands_; ++i)
            if (any_[i].forbids && !is_broken(i) && any_[i].to < elapsed_) return Effect::fulfilled;
        return fate();
    }

    /// Returns whether both obligations have the same demands, and every history fulfils both or neither.
    constexpr bool same_as(const RuleDuty& other) const noexcept {
        return asks_as(other) && elapsed_ == other.elapsed_ && broken_ == other.broken_;
    }
    /// Returns whether every history that fulfils this obligation also fulfils the other one. Both must have the same
    /// demands. If an event is demanded from the trigger on, the older obligation implies the younger. If an event is
    /// forbidden, the younger implies the older.
    constexpr bool stands_for(const RuleDuty& other) const noexcept {
        if (same_as(other)) return true;
        if (demands_ != 1 || any_[0].from != 0 || !asks_as(other)) return false;
        return any_[0].forbids ? elapsed_ < other.elapsed_ : elapsed_ > other.elapsed_;
    }

    constexpr std::uint32_t rule() const noexcept { return rule_; }
    constexpr std::int64_t began() const noexcept { return began_; }

private:
    constexpr bool is_broken(std::size_t place) const noexcept { return (broken_ >> place & 1U) != 0; }
    constexpr Effect fate() const noexcept {
        for (std::size_t i = 0; i < demands_; ++i)
            if (any_[i].forbids ? !is_broken(i) : any_[i].to >= elapsed_) return Effect::open;
        return Effect::broken;
    }
    constexpr bool asks_as(const RuleDuty& other) const noexcept {
        if (rule_ != other.rule_ || demands_ != other.demands_ || endings_ != other.endings_) return false;
        for (std::size_t i = 0; i < demands_; ++i) {
            const RuleDemand& a = any_[i];
            const RuleDemand& b = other.any_[i];
            if (a.forbids != b.forbids || a.event != b.event || a.from != b.from || a.to != b.to) return false;
        }
        for (std::size_t i = 0; i < endings_; ++i)
            if (ends_[i] != other.ends_[i]) return false;
        return true;
    }

    std::uint32_t rule_ = 0;
    std::uint32_t broken_ = 0;  ///< violated prohibitions, by index
    std::int64_t began_ = 0;
    std::int64_t elapsed_ = 0;  ///< seconds since the trigger, counted up to the horizon
    std::int64_t horizon_ = 0;  ///< after this second, only windows without a limit can change
    std::int64_t next_ = 0;     ///< start of the demand after `otherwise`
    std::size_t demands_ = 0;
    std::size_t endings_ = 0;
    RuleDemand any_[Demands] = {};  ///< windows counted from the trigger
    std::uint32_t ends_[Endings == 0 ? 1 : Endings] = {};
};

/// The open obligations; there are at most `Slots`.
template <std::size_t Demands, std::size_t Endings, std::size_t Slots, class Cases = RuleSameEvent>
class RuleDuties {
public:
    using Duty = RuleDuty<Demands, Endings, Cases>;

    /// Adds an obligation, unless an open one implies it.
    constexpr void keep(const Duty& duty) noexcept {
        std::size_t left = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            if (open_[i].stands_for(duty)) return;
            left += duty.stands_for(open_[i]) ? 0U : 1U;
        }
        if (left < count_) {
            left = 0;
            for (std::size_t i = 0; i < count_; ++i)
                if (!duty.stands_for(open_[i])) open_[left++] = open_[i];
            count_ = left;
        }
        if (count_ == Slots)
            ++lost_;
        else
            open_[count_++] = duty;
    }

    /// Calls `report` with each RuleViolation.
    template <class Report>
    constexpr void event(std::uint32_t event, Report& report) {
        settle(event, report);
    }
    template <class Report>
    constexpr void second(Report& report) {
        settle(rule_no_event, report);
        ++now_;
    }
    constexpr void forget() noexcept { count_ = 0; }

    constexpr std::int64_t now() const noexcept { return now_; }
    constexpr std::uint64_t lost() const noexcept { return lost_; }
    constexpr std::size_t open() const noexcept { return count_; }

private:
    template <class Report>
    constexpr void settle(std::uint32_t event, Report& report) {
        std::size_t left = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            Duty duty = open_[i];
            const auto effect = event == rule_no_event ? duty.second() : duty.event(event);
            if (effect == Duty::Effect::broken) report(RuleViolation{duty.rule(), duty.began(), now_, event});
            if (effect != Duty::Effect::open) continue;
            bool known = false;
            for (std::size_t k = 0; k < left && !known; ++k) known = open_[k].same_as(duty);
            if (!known) open_[left++] = duty;
        }
        count_ = left;
    }

    Duty open_[Slots] = {};
    std::size_t count_ = 0;
    std::int64_t now_ = 0;
    std::uint64_t lost_ = 0;
};

}  // namespace robochart

#endif
