// SPDX-License-Identifier: Apache-2.0
// See account.hpp.
#include "claims/monitor/account.hpp"

#include <fmt/format.h>

#include "base/durations/time_unit.hpp"

namespace robochart::claims {

Account::Account(const CheckedClaim& claim, durations::Unit unit)
    : claim_(claim), monitor_(claim), unit_(unit), state_(monitor_.begin()), current_{0, "the start"} {
    if (state_.phase == Phase::inside && claim.scope.kind != ScopeKind::whole && claim.scope.kind != ScopeKind::before)
        scope_ = current_;
    if (state_.left >= 0 || state_.due) trigger_ = current_;
}

void Account::observe(const Occurrence& event, const std::string& text) {
    if (state_.verdict != Verdict::open) return;
    const MonitorState before = state_;
    current_ = {now_, text};
    breaker_ = Breaker::event;
    monitor_.observe(state_, event);
    if (!is_broken()) note_changes(before, event);
    if (claim_.body.kind == BodyKind::only_within && Monitor::matches(claim_.body.others, event, before))
        trigger_ = current_;
    const bool delays = claim_.body.kind == BodyKind::at_least && Monitor::matches(claim_.body.others, event, before);
    if (delays && !is_broken()) trigger_ = current_;
    if (claim_.body.kind == BodyKind::at_most && state_.phase == Phase::inside &&
        Monitor::matches(claim_.body.events, event, before))
        counted_.push_back(current_);
}

/// Records what began or ended with the current event.
void Account::note_changes(const MonitorState& before, const Occurrence& observed) {
    const CheckedScope& scope = claim_.scope;
    const bool again = Monitor::matches(scope.first, observed, before) &&
                       (scope.kind == ScopeKind::after_each ||
                        (scope.kind == ScopeKind::after_until && Monitor::matches(scope.last, observed, before)));
    const bool begins = state_.phase == Phase::inside && (before.phase != Phase::inside || again);
    note_begun(before, begins);
}

void Account::note_begun(const MonitorState& before, bool begins) {
    if (begins) {
        scope_ = current_;
        trigger_.reset();
        counted_.clear();
    }
    const bool was_open = before.left >= 0 || before.due;
    const bool is_open = state_.left >= 0 || state_.due;
    if (claim_.body.kind == BodyKind::every) {
        if (begins || state_.left > before.left) trigger_ = current_;
    } else if (is_open && (!was_open || state_.left > before.left)) {
        trigger_ = current_;
    }
}

void Account::observe(const std::vector<FactValue>& values) {
    if (state_.verdict != Verdict::open) return;
    const MonitorState before = state_;
    current_ = {now_, change_text(before, values)};
    breaker_ = Breaker::event;
    monitor_.observe(state_, values);
    if (state_.stay < 0 || before.stay < 0) stay_ = state_.stay < 0 && !is_broken() ? std::nullopt : stay_;
    if (state_.stay >= 0 && before.stay < 0) stay_ = now_;
    if (!is_broken()) note_begun(before, state_.phase == Phase::inside && before.phase != Phase::inside);
}

/// Describes the facts that change: "in Held ends".
std::string Account::change_text(const MonitorState& before, const std::vector<FactValue>& values) const {
    std::string text;
    for (const FactValue& value : values) {
        if (before.facts.at(value.fact).value_or(false) == value.holds) continue;
        if (!text.empty()) text += ", ";
        text += fmt::format("{} {}", claim_.facts[value.fact].text, value.holds ? "begins" : "ends");
    }
    return text;
}

void Account::tock() {
    if (state_.verdict != Verdict::open) return;
    breaker_ = Breaker::time;
    monitor_.tock(state_);
    if (!is_broken()) ++now_;
}

void Account::end() {
    if (state_.verdict != Verdict::open) return;
    breaker_ = Breaker::end;
    monitor_.end(state_);
}

std::string Account::time_text(std::int64_t time) const {
    return durations::time_text(time, unit_);
}

std::string Account::units(std::int64_t count) const {
    return durations::units_text(count, unit_);
}

std::string Account::moment_text(const Moment& moment) const {
    return fmt::format("{} at {}", moment.text, time_text(moment.time));
}

std::string Account::breaker_text() const {
    switch (breaker_) {
        case Breaker::event:
            return fmt::format("{} comes at {}", current_.text, time_text(now_));
        case Breaker::time:
            return fmt::format("time passes beyond {}", time_text(now_));
        case Breaker::end:
            return fmt::format("the component ends at {}", time_text(now_));
    }
    return "";
}

/// Describes what the claim demands after the open trigger.
std::string Account::demand_text() const {
    const CheckedBody& body = claim_.body;
    const std::int64_t from = trigger_ ? trigger_->time : 0;
    const std::int64_t limit = from + body.units.value_or(0);
    if (body.kind == BodyKind::for_at_most)
        return fmt::format("`{}` holds since {}, and has to end {} later", body.condition_text,
                           time_text(stay_.value_or(0)), units(*body.units));
    if (body.kind == BodyKind::leads)
        return fmt::format("{} is owed since {}", body.others.text, trigger_ ? moment_text(*trigger_) : "the start");
    if (body.kind == BodyKind::every)
        return fmt::format("{} is owed until {}, {} after {}", body.events.text, time_text(limit), units(*body.units),
                           trigger_ ? moment_text(*trigger_) : "the start");
    return fmt::format("{} is owed until {}, {} after {}", body.others.text, time_text(limit), units(*body.units),
                       trigger_ ? moment_text(*trigger_) : "the start");
}

std::vector<std::string> Account::reasons_of_body() const {
    const CheckedBody& body = claim_.body;
    const std::string came = breaker_text();
    const std::string trigger = trigger_ ? moment_text(*trigger_) : "";
    switch (body.kind) {
        case BodyKind::never:
            return {fmt::format("{}, which the claim forbids", came)};
        case BodyKind::only_after:
            return {fmt::format("{}, and no {} came before", came, body.others.text)};
        case BodyKind::only_within:
            if (!trigger_) return {fmt::format("{}, and no {} came before", came, body.others.text)};
            return {fmt::format("the last {} was {}", body.others.text, trigger),
                    fmt::format("{}, {} later; the claim allows it for {}", came, units(now_ - trigger_->time),
                                units(*body.units))};
        case BodyKind::leads_within:
        case BodyKind::leads:
        case BodyKind::every:
            return {demand_text(), came};
        case BodyKind::leads_before:
            return {fmt::format("{} is owed since {}", body.others.text, trigger), fmt::format("{} before it", came)};
        case BodyKind::at_least:
            if (!trigger_) return {came};
            return {fmt::format("{}, {} after {}; the claim allows it from {} on", came, units(now_ - trigger_->time),
                                trigger, time_text(trigger_->time + body.units.value()))};
        case BodyKind::at_most: {
            std::vector<std::string> result;
            const auto window = static_cast<std::size_t>(body.count) + 1;
            if (body.units && counted_.size() >= window)
                result.push_back(
                    fmt::format("the first of {} was {}", window, moment_text(counted_[counted_.size() - window])));
            result.push_back(fmt::format("{}, one more than the {} that the claim allows{}", came, body.count,
                                         body.units ? fmt::format(" in {}", units(*body.units)) : ""));
            return result;
        }
        case BodyKind::always:
            return {fmt::format("at {}, when time passes, `{}` does not hold", time_text(now_), body.condition_text)};
        case BodyKind::for_at_least:
            return {fmt::format("`{}` holds since {}; it ends at {}, {} later; the claim demands {}",
                                body.condition_text, time_text(stay_.value_or(0)), time_text(now_),
                                units(now_ - stay_.value_or(0)), units(*body.units))};
        case BodyKind::for_at_most:
            return {fmt::format("`{}` holds since {}; the claim allows {}", body.condition_text,
                                time_text(stay_.value_or(0)), units(*body.units)),
                    came};
        case BodyKind::possible:
        case BodyKind::can_take:
            return {};
    }
    return {};
}

std::vector<std::string> Account::reasons() const {
    std::vector<std::string> result;
    if (scope_) result.push_back(fmt::format("the scope began with {}", moment_text(*scope_)));
    for (std::string& reason : reasons_of_body()) result.push_back(std::move(reason));
    return result;
}

std::vector<std::string> Account::reasons_of_standstill() const {
    return reasons_of_debt(fmt::format("time stops at {}", time_text(now_)));
}

std::vector<std::string> Account::reasons_of_waiting() const {
    return reasons_of_debt(fmt::format("from {} on time can pass for ever without it", time_text(now_)));
}

std::vector<std::string> Account::reasons_of_debt(std::string event) const {
    std::vector<std::string> result;
    if (scope_) result.push_back(fmt::format("the scope began with {}", moment_text(*scope_)));
    result.push_back(demand_text());
    result.push_back(std::move(event));
    return result;
}

}  // namespace robochart::claims
