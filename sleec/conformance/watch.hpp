// Whether a component obeys a rule, as a question to the checker of scripts: a process beside the component picks one
// trigger, whichever it likes, and follows what becomes of its obligation. The component obeys the rule iff no run of
// both leads to `broken`. One obligation at a time is enough: a rule is broken iff some trigger's obligation is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "sleec/obligations/samples.hpp"

namespace robochart::sleec {

/// A measure as the script has it: a channel with a direction and a value.
struct LinkedMeasure {
    std::string channel;
    std::vector<std::string> literals;  ///< of a scale: the script's constructors, least first
};

/// Where the names of a file of rules are found in a script; nothing for those that are not. The rule's events have to
/// be; a measure that is not may have any value at any time.
struct Linking {
    std::vector<std::optional<std::string>> events;  ///< channels
    std::vector<std::optional<LinkedMeasure>> measures;
};

/// One way in which the rule is asked something: the values of its measures, by their classes, and what it asks for.
struct Asked {
    Valuation values;
    std::size_t obligation = 0;
};

/// What is judged where the component reads different values of a measure within one instant.
enum class Readings : std::uint8_t {
    one_value,  ///< a trigger of this instant is not judged: a measure has one value at each instant, as in SLEEC-TK
    any,        ///< the last value before the trigger counts; without one, that behind it
};

/// The script about one rule and one component.
class Watch {
public:
    /// `process`: the component, in time. Throws NotDecided where the rule cannot be followed so.
    Watch(const CheckedRules& rules, std::size_t rule, const Linking& linking, cspm::ExprPtr process,
          Readings readings = Readings::one_value);

    /// Channels and processes; names begin with "sleec_".
    [[nodiscard]] std::vector<cspm::DeclPtr> declarations() const;
    /// Holds iff no obligation is broken.
    [[nodiscard]] cspm::DeclPtr obeyed() const;
    /// Fails iff some run asks for something; of those ways alone.
    [[nodiscard]] cspm::DeclPtr never_asked(const std::vector<std::size_t>& ways) const;
    /// Whether something is asked for that has to come and has no limit.
    [[nodiscard]] bool has_demand_without_limit() const;
    /// Component and rule together, where a second that passes while such a demand is open is the event `waiting`. The
    /// component obeys the rule iff it is never broken, and no run has this event without end (endless.hpp).
    [[nodiscard]] cspm::ExprPtr waiting_process() const;
    /// Component and rule together, with all that they do.
    [[nodiscard]] cspm::ExprPtr process() const { return both(); }
    static constexpr const char* waiting = "sleec_waiting";
    /// Whether a measure is asked for that the component reads.
    [[nodiscard]] bool reads() const;

    [[nodiscard]] const std::vector<Obligation>& obligations() const { return obligations_; }
    [[nodiscard]] const std::vector<Asked>& ways() const { return ways_; }
    /// The way, where this is the event by which the process says that it follows an obligation.
    [[nodiscard]] static std::optional<std::size_t> way_of(const std::string& event);

private:
    struct Followed {
        std::size_t measure = 0;
        std::vector<std::int64_t> constants;        ///< ascending; what numbers are compared with
        std::vector<std::int64_t> representatives;  ///< of each class; classes that are empty have none
        std::vector<std::int64_t> classes;          ///< their numbers
    };

    void find_classes();
    void find_ways();
    [[nodiscard]] std::size_t obligation(const Obligation& obligation);
    [[nodiscard]] cspm::ExprPtr class_of(const Followed& followed, const cspm::ExprPtr& value) const;
    [[nodiscard]] cspm::ExprPtr started(std::size_t from, Valuation classes) const;
    [[nodiscard]] std::vector<cspm::DeclPtr> starting() const;
    [[nodiscard]] std::vector<cspm::DeclPtr> idle() const;
    [[nodiscard]] std::vector<cspm::DeclPtr> open(std::size_t obligation) const;
    [[nodiscard]] cspm::ExprPtr on_event(std::size_t obligation, bool broken, std::size_t event) const;
    [[nodiscard]] cspm::ExprPtr on_tock(std::size_t obligation, bool broken) const;
    [[nodiscard]] cspm::ExprPtr against() const;
    [[nodiscard]] cspm::ExprPtr compared(std::size_t place, const cspm::ExprPtr& then) const;
    [[nodiscard]] std::vector<cspm::ExprPtr> behind_reading(std::size_t place) const;
    [[nodiscard]] std::vector<cspm::DeclPtr> wrong() const;
    [[nodiscard]] cspm::ExprPtr reading(std::size_t place) const;
    [[nodiscard]] cspm::ExprPtr passing(std::size_t obligation) const;
    [[nodiscard]] cspm::ExprPtr named_events() const;
    [[nodiscard]] std::vector<std::size_t> event_indices() const;
    [[nodiscard]] cspm::ExprPtr both() const;
    [[nodiscard]] cspm::ExprPtr both_showing(const cspm::ExprPtr& events) const;

    const CheckedRules& rules_;
    std::size_t rule_;
    const Linking& linking_;
    cspm::ExprPtr process_;
    Readings readings_;
    std::vector<Followed> followed_;
    std::vector<Obligation> obligations_;
    std::vector<Asked> ways_;
};

}  // namespace robochart::sleec
