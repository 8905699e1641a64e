// SPDX-License-Identifier: Apache-2.0
// See dispatch_equivalence.hpp. Raises other events together with the dispatched event, to check that dispatch ignores
// them.
#include "conformance/check/dispatch_equivalence.hpp"
#include "conformance/check/standstill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "checker/process/operational_semantics.hpp"
#include "checker/refine/search/budget.hpp"
#include "conformance/code/cycle_log.hpp"
#include "conformance/code/watchdog.hpp"

namespace robochart::conformance {

namespace {

using Bytes = std::vector<unsigned char>;
using Registers = std::vector<rc_register>;

const char* result_text(rc_result result) {
    constexpr std::array<const char*, 5> words{"at rest", "terminated", "does not end", "outside a precondition",
                                               "misses a deadline"};
    const auto place = static_cast<std::size_t>(result);
    return place < words.size() ? words[place] : "an unknown result";
}

/// A state and the calls that have been made from it.
struct Run {
    Bytes state;
    CycleLog log;
    rc_result result = RC_QUIESCENT;
};

/// The arguments of a call for the watchdog.
struct Call {
    const rc_interface* code;
    Run* run;
    std::uint32_t event;
    const rc_register* registers;
};

rc_result call_step(void* arguments) {
    const auto* call = static_cast<const Call*>(arguments);
    return call->code->step(call->run->state.data(), call->registers, &call->run->log);
}

rc_result call_dispatch(void* arguments) {
    const auto* call = static_cast<const Call*>(arguments);
    return call->code->dispatch(call->run->state.data(), call->event, call->registers, &call->run->log);
}

rc_result call_pass(void* arguments) {
    const auto* call = static_cast<const Call*>(arguments);
    return call->code->pass(call->run->state.data(), &call->run->log);
}

struct ApiComparison {
    std::uint64_t compared = 0;
    std::uint32_t image = 0;  ///< the image in which they differ
    std::optional<ApiDifference> difference;
};

class Comparison {
public:
    Comparison(const rc_interface& code, const ExploredCode& system, const Alphabet& alphabet,
               const refine::Limits& limits)
        : code_(code), system_(system), alphabet_(alphabet), budget_(limits) {
        // Reserves one more record: an output that the cycle does not make would be a difference of the event API.
        for (Run* run : {&cycle_, &dispatched_, &again_, &whole_}) run->log.reserve(system.most_writes() + 1);
    }

    ApiComparison run() {
        if (code_.dispatch == nullptr) return {};
        for (const std::uint32_t image : system_.started_images()) {
            found_.image = image;
            from_ = system_.image_bytes(image);
            if (!compare_in_state()) break;
        }
        return std::move(found_);
    }

private:
    /// Each of these functions returns false if the APIs differ.
    bool compare_in_state() {
        const std::vector<Register>& inputs = alphabet_.interface().inputs;
        event_ = code_.events;
        if (!compare_on_event(0)) return false;
        for (event_ = 0; event_ < code_.events; ++event_)
            for (std::uint32_t reading = 1; reading < inputs[event_].reading_count(); ++reading)
                if (!compare_on_event(reading) || !ignores_other_values(reading)) return false;
        return std::ranges::all_of(alphabet_.interface().drops,
                                   [this](const DroppedInput& drop) { return drops_after(drop); });
    }

    /// Checks that an event which the dispatched event drops has no effect before time passes.
    bool drops_after(const DroppedInput& drop) {
        event_ = drop.event;
        reading_ = 1;
        raise_all(1);
        cycle_.log.given = 0;
        run_from_state(call_step, cycle_, alone_);
        take_answers(dispatched_);
        run_from_state(call_dispatch, dispatched_, raised_);
        if (dispatched_.result != RC_QUIESCENT) return true;
        again_.state = dispatched_.state;
        again_.log.given = 0;
        event_ = drop.dropped;
        call_guarded(call_dispatch, again_, raised_);
        const bool dropped =
            again_.result == RC_QUIESCENT && again_.log.count == 0 && again_.state == dispatched_.state;
        return check_promise(dropped, again_, "an event before it in this cycle drops it");
    }

    /// Compares the APIs for each value of each other register, because dispatch must not read these registers.
    bool ignores_other_values(std::uint32_t reading) {
        const std::vector<Register>& inputs = alphabet_.interface().inputs;
        for (std::size_t other = 0; other < inputs.size(); ++other) {
            if (other == event_) continue;
            for (std::uint32_t value = 0; value + 2 < inputs[other].reading_count(); ++value) {
                raise_all(reading);
                raised_[other] = {1, value};
                if (!compare_answers()) return false;
            }
        }
        return true;
    }

    /// Raises only the register of the event for `step`, and all registers for `dispatch`.
    void raise_all(std::uint32_t reading) {
        const std::vector<Register>& inputs = alphabet_.interface().inputs;
        alone_.assign(inputs.size(), {0, 0});
        raised_.assign(inputs.size(), {0, 0});
        for (std::size_t i = 0; i < inputs.size(); ++i) raised_[i] = {1, inputs[i].reading_count() - 2};
        if (reading > 0) alone_[event_] = raised_[event_] = {1, reading - 1};
    }

    bool compare_on_event(std::uint32_t reading) {
        reading_ = reading;
        raise_all(reading);
        ++found_.compared;
        return compare_answers();
    }

    /// Compares the APIs for every answer to the choices that the model leaves open.
    bool compare_answers() {
        cycle_.log.given = 0;
        do {
            budget_.charge();
            if (!with_answers()) return false;
        } while (next_choices(cycle_.log));
        return true;
    }

    /// Compares with the answers in cycle_.log.
    bool with_answers() {
        run_from_state(call_step, cycle_, alone_);
        take_answers(dispatched_);
        run_from_state(call_dispatch, dispatched_, raised_);
        if (cycle_.result == RC_STEP_BOUND || dispatched_.result == RC_STEP_BOUND)
            return check_promise(cycle_.result == dispatched_.result, dispatched_, "only one of them ends");
        if (dispatched_.result == RC_QUIESCENT &&
            !check_promise(is_quiescent(), dispatched_, "it leaves something enabled"))
            return false;
        whole_ = dispatched_;
        if (whole_.result == RC_QUIESCENT) call_guarded(call_pass, whole_, raised_);
        return check_same_effect(whole_) && (event_ != code_.events || passes_alone());
    }

    /// Checks that no transition is enabled after a dispatch. To do this, tries again to take transitions without an
    /// event; nothing may change.
    bool is_quiescent() {
        again_.state = dispatched_.state;
        again_.log.given = 0;
        const std::uint32_t event = std::exchange(event_, code_.events);
        call_guarded(call_dispatch, again_, raised_);
        event_ = event;
        return again_.result == RC_QUIESCENT && again_.log.count == 0 && again_.state == dispatched_.state;
    }

    bool check_same_effect(const Run& other) {
        return check_promise(cycle_.result == other.result, other, "it ends differently") &&
               check_promise(cycle_.log.overflow == other.log.overflow && same_writes(cycle_.log, other.log), other,
                             "other outputs") &&
               check_promise(same_asked(other.log), other, "other choices") &&
               check_promise(cycle_.state == other.state, other, "another state");
    }

    /// Compares a call without an event with a cycle without inputs. If the machine has not begun, the cycle begins it
    /// or has no effect.
    bool passes_alone() {
        take_answers(whole_);
        whole_.state = from_;
        whole_.log.count = whole_.log.overflow = whole_.log.asked = 0;
        call_guarded(call_pass, whole_, raised_);
        passed_ = true;
        const bool before = found_.image == system_.reset_image() && !has_same_effect(whole_);
        const bool holds = before ? begins_late() : check_same_effect(whole_);
        passed_ = false;
        return holds;
    }

    bool begins_late() {
        if (!check_promise(whole_.log.count == 0, whole_, "outputs before the machine has begun")) return false;
        take_answers(again_);
        again_.state = whole_.state;
        call_guarded(call_dispatch, again_, raised_);
        const bool as_ever = again_.result == dispatched_.result && same_writes(again_.log, dispatched_.log) &&
                             again_.state == dispatched_.state;
        return check_promise(as_ever, again_, "it counts time that passes before the machine has begun");
    }

    [[nodiscard]] bool has_same_effect(const Run& other) const {
        return cycle_.result == other.result && same_writes(cycle_.log, other.log) && cycle_.state == other.state;
    }

    [[nodiscard]] bool same_asked(const rc_log& other) const {
        if (cycle_.log.asked != other.asked) return false;
        for (std::uint32_t k = 0; k < other.asked && k < ROBOCHART_MAX_CHOICES; ++k)
            if (cycle_.log.ways[k] != other.ways[k]) return false;
        return true;
    }

    void take_answers(Run& run) const {
        run.log.given = cycle_.log.given;
        std::copy_n(cycle_.log.choice, cycle_.log.given, run.log.choice);
    }

    void run_from_state(Guarded what, Run& run, const Registers& registers) {
        run.state = from_;
        call_guarded(what, run, registers);
    }

    void call_guarded(Guarded what, Run& run, const Registers& registers) {
        Call arguments{&code_, &run, event_, registers.data()};
        const Stepped stepped = call_watched(what, &arguments, endless_ ? Patience::short_ : Patience::seconds);
        endless_ = endless_ || stepped.endless;
        run.result = stepped.result;
    }

    bool check_promise(bool holds, const Run& other, const char* what) {
        if (holds) return true;
        ApiDifference difference;
        const std::vector<Register>& inputs = alphabet_.interface().inputs;
        if (event_ < inputs.size() && reading_ > 0)
            difference.event = alphabet_.describe_event(alphabet_.read_event(event_, reading_));
        difference.what = fmt::format("{}: {}", describe_call(difference.event), what);
        difference.cycle = behaviour_of(cycle_);
        difference.dispatched = behaviour_of(other);
        found_.difference = std::move(difference);
        return false;
    }

    [[nodiscard]] std::string describe_call(const std::string& event) const {
        if (passed_) return "`pass`";
        if (event.empty()) return "`begin` and `pass`";
        return fmt::format("`dispatch` of {}", event);
    }

    Behaviour behaviour_of(const Run& run) const {
        Behaviour behaviour;
        behaviour.ends = result_text(run.result);
        for (std::uint32_t r = 0; r < run.log.count; ++r) {
            const rc_record& record = run.log.record[r];
            const bool known = record.output < code_.outputs && record.count <= ROBOCHART_MAX_ARGUMENTS;
            behaviour.outputs.push_back(known ? alphabet_.describe_event(alphabet_.write_event(
                                                    record.output, {record.argument, record.argument + record.count}))
                                              : "an output without name");
        }
        std::array<char, 4096> text{};
        code_.print(run.state.data(), text.data(), text.size());
        text.back() = '\0';
        behaviour.state = text.data();
        return behaviour;
    }

    const rc_interface& code_;
    const ExploredCode& system_;
    const Alphabet& alphabet_;
    refine::Budget budget_;
    ApiComparison found_;
    Bytes from_;
    std::uint32_t event_ = 0;    ///< code_.events if there is no event
    std::uint32_t reading_ = 0;  ///< reading of the event; 0 if there is none
    bool passed_ = false;        ///< only `pass` is compared
    bool endless_ = false;
    Registers alone_, raised_;
    Run cycle_, dispatched_, again_, whole_;
};

/// Reports a difference of the APIs, with the cycles that lead to its state. The model allows these cycles.
void apis_differ(Result& result, const ApiComparison& found, const ExploredCode& code, const Alphabet& alphabet) {
    result.outcome = Outcome::differs;
    result.api_difference = found.difference;
    result.reason = fmt::format("the event API differs from the cycle: {}", found.difference->what);
    std::vector<process::Event> trace;
    for (const PassedCycle& passed : code.path_to_image(found.image)) {
        Cycle& cycle = result.cycles.emplace_back();
        for (std::uint32_t input = 0; input < passed.readings.size(); ++input) {
            trace.push_back(alphabet.read_event(input, passed.readings[input]));
            if (passed.readings[input] != 0) cycle.inputs.push_back(alphabet.describe_event(trace.back()));
        }
        for (const process::Event write : passed.result->writes) {
            trace.push_back(write);
            cycle.outputs.push_back(alphabet.describe_event(write));
        }
        trace.insert(trace.end(), code.cycle_length(), alphabet.tock());
        cycle.state = code.print_image(passed.result->next);
    }
    set_model_run(result, nullptr, trace);
}

}  // namespace

void compare_event_api(Result& result, const rc_interface& compiled, const ExploredCode& code, const Alphabet& alphabet,
                       const refine::Limits& limits) {
    if (result.outcome == Outcome::differs) return;
    try {
        const ApiComparison found = Comparison(compiled, code, alphabet, limits).run();
        result.dispatched = found.compared;
        if (found.difference) apis_differ(result, found, code, alphabet);
    } catch (const process::Interrupted& limit) {
        if (result.outcome != Outcome::conforms) return;
        result.outcome = Outcome::inconclusive;
        result.reason = fmt::format("the cycle conforms; the event API was not compared with it: {}", limit.what());
    }
}

}  // namespace robochart::conformance
