// SPDX-License-Identifier: Apache-2.0
// Decides whether a component obeys a rule, with the checker of scripts. A process in parallel with the component
// nondeterministically selects one trigger and follows its obligation. The component obeys the rule iff no run of this
// combination leads to `broken`. The process needs to follow only one obligation at a time, because a rule is broken
// iff the obligation of some trigger is broken.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/syntax.hpp"
#include "claims/sleec/obligations/samples.hpp"

namespace robochart::sleec {

/// An event in the script.
struct LinkedEvent {
    // NOLINTNEXTLINE(google-explicit-constructor): a channel with all its values
    LinkedEvent(const std::string& channel) : events{channel}, prefixes{cspm::build::name(channel)} {}
    LinkedEvent(std::vector<std::string> names, std::vector<cspm::ExprPtr> expressions)
        : events(std::move(names)), prefixes(std::move(expressions)) {}

    std::vector<std::string> events;  ///< "P::M::goToCall.3"; events of the script are equal or continue it with '.'.
                                      ///< Empty if the instantiation contains none of the values
    std::vector<cspm::ExprPtr> prefixes;  ///< the same as expressions
};

/// A measure in the script, as a channel with a direction and a value. A state is linked to the channel by which its
/// machine shows the truth of some facts (csp_emit/showing.hpp).
struct LinkedMeasure {
    std::string channel;
    std::vector<std::string> literals = {};  ///< for a scale: the script's constructors, least first
    std::size_t shown = 0;                   ///< the place of a state among the facts, from 0
    std::size_t facts = 0;                   ///< the number of facts that the channel of a state shows
};

/// The channels of a script for the names of a rule file. A name without a channel has no value. All events of the rule
/// must be linked. A measure that is not linked may have any value at any time.
struct Linking {
    std::vector<std::optional<LinkedEvent>> events;
    std::vector<std::optional<LinkedMeasure>> measures;
};

/// One case of the rule: the values of its measures, by class, and the obligation in this case.
struct Asked {
    Valuation values;
    std::size_t obligation = 0;
};

/// The treatment of a component that reads different values of a measure within one instant.
enum class Readings : std::uint8_t {
    one_value,  ///< triggers at this instant are ignored, because in SLEEC-TK a measure has one value per instant
    any,        ///< the last value before the trigger is used, or else the first after it
};

/// The script for one rule and one component.
class Watch {
public:
    /// `process` is the timed process of the component. Throws NotDecided if this method cannot follow the rule.
    Watch(const CheckedRules& rules, std::size_t rule, const Linking& linking, cspm::ExprPtr process,
          Readings readings = Readings::one_value);

    /// Returns the channels and processes; their names begin with "sleec_".
    [[nodiscard]] std::vector<cspm::DeclPtr> declarations() const;
    /// Returns an assertion that holds iff no obligation is broken.
    [[nodiscard]] cspm::DeclPtr obeyed_assertion() const;
    /// Returns an assertion that fails iff some run leads to one of these cases.
    [[nodiscard]] cspm::DeclPtr never_asked_assertion(const std::vector<std::size_t>& ways) const;
    /// True if the rule demands an event without limit.
    [[nodiscard]] bool has_demand_without_limit() const;
    /// Returns the component in parallel with the rule. If a second passes while a demand without limit is open, the
    /// event is `waiting` instead of `tock`. The component obeys the rule iff the rule is never broken and no run
    /// contains `waiting` infinitely often (endless.hpp).
    [[nodiscard]] cspm::ExprPtr waiting_process() const;
    /// Returns the component in parallel with the rule, with all their events.
    [[nodiscard]] cspm::ExprPtr checked_process() const { return parallel_process(); }
    static constexpr const char* waiting = "sleec_waiting";
    /// True if the rule uses a measure that the component reads; states are ignored.
    [[nodiscard]] bool reads_measures() const;

    [[nodiscard]] const std::vector<Obligation>& obligations() const { return obligations_; }
    [[nodiscard]] const std::vector<Asked>& ways() const { return ways_; }
    /// Returns the number of the case, if this is the event by which the process reports that it follows an obligation.
    [[nodiscard]] static std::optional<std::size_t> way_of(const std::string& event);

private:
    struct Followed {
        std::size_t measure = 0;
        std::vector<std::int64_t> constants;        ///< ascending; the constants that numbers are compared with
        std::vector<std::int64_t> representatives;  ///< one for each nonempty class
        std::vector<std::int64_t> classes;          ///< the numbers of the nonempty classes
    };

    void find_classes();
    void find_ways();
    [[nodiscard]] std::size_t number_obligation(const Obligation& obligation);
    [[nodiscard]] cspm::ExprPtr class_of(const Followed& followed, const cspm::ExprPtr& value) const;
    [[nodiscard]] cspm::ExprPtr start_call(std::size_t from, Valuation classes) const;
    [[nodiscard]] std::vector<cspm::DeclPtr> start_definitions() const;
    [[nodiscard]] std::vector<cspm::DeclPtr> idle_definitions() const;
    [[nodiscard]] std::vector<cspm::DeclPtr> open_definitions(std::size_t obligation) const;
    [[nodiscard]] cspm::ExprPtr on_event(std::size_t obligation, bool broken, std::size_t event) const;
    [[nodiscard]] cspm::ExprPtr on_tock(std::size_t obligation, bool broken) const;
    [[nodiscard]] cspm::ExprPtr violation_process() const;
    [[nodiscard]] cspm::ExprPtr compare_reading(std::size_t place, const cspm::ExprPtr& then) const;
    [[nodiscard]] std::vector<cspm::ExprPtr> arguments_after_reading(std::size_t place) const;
    [[nodiscard]] std::vector<cspm::DeclPtr> wrong_definitions() const;
    [[nodiscard]] cspm::ExprPtr class_of_reading(std::size_t place) const;
    [[nodiscard]] bool is_state(std::size_t place) const { return rules_.is_state(followed_[place].measure); }
    [[nodiscard]] const LinkedMeasure* channel_of(std::size_t place) const;
    [[nodiscard]] std::vector<std::string> state_channels() const;
    [[nodiscard]] cspm::ExprPtr show_states(const std::string& channel, const std::string& process,
                                            std::vector<cspm::ExprPtr> arguments, std::size_t first, bool follow) const;
    [[nodiscard]] cspm::ExprPtr any_event(const EventCases& events, const cspm::ExprPtr& then) const;
    [[nodiscard]] cspm::ExprPtr time_event(std::size_t obligation) const;
    [[nodiscard]] cspm::ExprPtr named_events() const;
    [[nodiscard]] std::vector<std::size_t> event_indices() const;
    [[nodiscard]] cspm::ExprPtr parallel_process() const;
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
