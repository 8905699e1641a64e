// SPDX-License-Identifier: Apache-2.0
// See claim_guard.hpp.
#include "app/rules/claim_guard.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/claims/event_order.hpp"
#include "app/command/run.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/spelling.hpp"
#include "claims/decide/letters.hpp"
#include "driver/model/project_claims.hpp"
#include "driver/settings/rules.hpp"
#include "simulation/scenario/rules.hpp"

namespace robochart::app {
namespace {

using claims::CheckedClaim;
using simulation::MeasureKind;

bool is_of(const claims::Channel& channel, const cpp_emit::Port& port, bool input) {
    using Kind = cpp_emit::Port::Kind;
    if (channel.name != port.name) return false;
    switch (channel.kind) {
        case claims::ChannelKind::input:
            return input && port.kind == Kind::event;
        case claims::ChannelKind::output:
            return !input && port.kind == Kind::event;
        case claims::ChannelKind::call:
            return !input && port.kind == Kind::call;
    }
    return false;
}

/// Returns an event or operation of the claim that the controller does not have; "" if it has all of them.
std::string missing_channel(const CheckedClaim& claim, const cpp_emit::DriveEmission& emission) {
    for (const std::size_t number : driver::channels_of(claim)) {
        const claims::Channel& channel = claim.component.channels[number];
        const bool input = channel.kind == claims::ChannelKind::input;
        const auto& ports = input ? emission.inputs : emission.outputs;
        if (std::ranges::none_of(ports, [&](const cpp_emit::Port& port) { return is_of(channel, port, input); }))
            return channel.name;
    }
    return "";
}

bool is_about(const CheckedClaim& claim, const std::string& component) {
    const std::string& path = claim.component.path;
    if (claim.component.part) return false;
    return path == component || path.ends_with("::" + component);
}

/// Returns the text of a value as in logs.
std::string value_text(const cpp_emit::Port& port, std::size_t argument, rc_value value) {
    switch (port.arguments[argument]) {
        case cpp_emit::Carried::real:
            return fmt::format("{}", value.real);
        case cpp_emit::Carried::boolean:
            return value.whole != 0 ? "true" : "false";
        case cpp_emit::Carried::whole:
            return fmt::format("{}", value.whole);
        case cpp_emit::Carried::enumeration:
            break;
    }
    const auto& literals = port.literals[argument];
    const bool named = value.whole >= 0 && static_cast<std::size_t>(value.whole) < literals.size();
    return named ? literals[static_cast<std::size_t>(value.whole)] : fmt::format("{}", value.whole);
}

}  // namespace

/// Follows the claims in one trial.
class ClaimGuard::Watch final : public simulation::Trace {
public:
    Watch(ClaimGuard& all, std::uint32_t trial, std::unique_ptr<simulation::Trace> other)
        : all_(all), trial_(trial), other_(std::move(other)), broken_(all.watched_.size(), 0) {
        const simulation::Scenario& scenario = all.scenario_;
        for (std::size_t kind = 0; kind < scenario.kind_count(); ++kind) first_.push_back(scenario.first_robot(kind));
        first_.push_back(scenario.all_robots());
    }
    ~Watch() override {
        all_.robots_ += robots_.size();
        for (const Robot& robot : robots_)
            for (const Followed& followed : robot.followed)
                if (!followed.run.is_broken() && !followed.run.unknown().empty()) {
                    const std::lock_guard lock(all_.mutex_);
                    all_.given_up_.emplace(followed.number, followed.run.unknown());
                }
    }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    void observe_cycle(std::size_t robot, std::uint64_t step, const rc_signal* inputs, const rc_actions& outputs,
                       rc_drive_result result) override {
        if (other_ != nullptr) other_->observe_cycle(robot, step, inputs, outputs, result);
        while (robots_.size() <= robot) add_robot(robots_.size());
        Robot& of = robots_[robot];
        if (of.ended) return;
        of.ended = result != RC_DRIVE_QUIESCENT;
        const cpp_emit::DriveEmission& emission = *all_.kinds_[of.kind].emission;
        for (Followed& followed : of.followed) {
            if (followed.run.is_broken()) continue;
            follow_cycle(followed.run, emission, inputs, outputs, result);
            if (followed.run.is_broken()) note(followed, robot);
        }
    }

    [[nodiscard]] const simulation::Objection* current_objection() const override {
        if (!objection_.cause.empty()) return &objection_;
        return other_ == nullptr ? nullptr : other_->current_objection();
    }
    [[nodiscard]] bool is_conclusive() const override {
        return (other_ == nullptr || other_->is_conclusive()) && std::ranges::none_of(robots_, [](const Robot& robot) {
                   return std::ranges::any_of(robot.followed, [](const Followed& followed) {
                       return !followed.run.is_broken() && !followed.run.unknown().empty();
                   });
               });
    }
    [[nodiscard]] double kept_share(std::size_t measure) const override {
        for (std::size_t i = 0; i < all_.watched_.size(); ++i) {
            const Watched& watched = all_.watched_[i];
            if (watched.measure != measure) continue;
            const auto robots = static_cast<double>(first_[watched.kind + 1] - first_[watched.kind]);
            return robots > 0 ? 1 - static_cast<double>(broken_[i]) / robots : 1;
        }
        return Trace::kept_share(measure);
    }

private:
    struct Followed {
        std::size_t number = 0;  ///< in watched_
        driver::FollowedClaim run;
    };
    struct Robot {
        std::size_t kind = 0;
        bool ended = false;
        std::vector<Followed> followed;
    };

    void add_robot(std::size_t number) {
        Robot& robot = robots_.emplace_back();
        robot.kind = static_cast<std::size_t>(std::ranges::upper_bound(first_, number) - first_.begin()) - 1;
        const driver::Project& project = *all_.kinds_[robot.kind].project;
        for (std::size_t i = 0; i < all_.watched_.size(); ++i)
            if (all_.watched_[i].kind == robot.kind)
                robot.followed.push_back({i, driver::FollowedClaim(*all_.watched_[i].claim, project.system,
                                                                   project.unit, all_.watched_[i].drops)});
    }

    void follow_cycle(driver::FollowedClaim& run, const cpp_emit::DriveEmission& emission, const rc_signal* inputs,
                      const rc_actions& outputs, rc_drive_result result) const {
        for (std::size_t i = 0; i < emission.inputs.size(); ++i) {
            const cpp_emit::Port& port = emission.inputs[i];
            if (inputs[i].present == 0 || port.kind != cpp_emit::Port::Kind::event) continue;
            std::vector<std::string> values;
            if (!port.arguments.empty()) values.push_back(value_text(port, 0, inputs[i].value));
            run.observe(port.name, true, values);
        }
        for (std::uint32_t a = 0; a < outputs.count; ++a) {
            const cpp_emit::Port& port = emission.outputs[outputs.action[a].output];
            if (port.kind == cpp_emit::Port::Kind::variable) continue;
            std::vector<std::string> values;
            for (std::size_t k = 0; k < port.arguments.size(); ++k)
                values.push_back(value_text(port, k, outputs.action[a].argument[k]));
            run.observe(port.name, false, values);
        }
        if (result == RC_DRIVE_TERMINATED) run.end();
        for (std::uint32_t t = 0; result == RC_DRIVE_QUIESCENT && t < all_.scenario_.units_per_step; ++t) run.tock();
    }

    void note(const Followed& followed, std::size_t robot) {
        const Watched& watched = all_.watched_[followed.number];
        ++broken_[followed.number];
        const std::string text = fmt::format("{}", fmt::join(followed.run.reasons(), "; "));
        if (watched.stops && objection_.cause.empty()) {
            objection_.cause = fmt::format("{} is broken: {}", watched.claim->name, text);
            objection_.place = all_.kinds_[watched.kind].project->sources.path_and_line(watched.claim->span);
        }
        const std::lock_guard lock(all_.mutex_);
        const auto known = all_.broken_.find(followed.number);
        if (known != all_.broken_.end() && known->second.trial <= trial_) return;
        all_.broken_[followed.number] = {trial_, robot, text};
    }

    ClaimGuard& all_;
    std::uint32_t trial_;
    std::unique_ptr<simulation::Trace> other_;
    std::vector<std::size_t> first_;   ///< the first robot of each kind, and the number of robots
    std::vector<std::size_t> broken_;  ///< for each claim, the number of robots that broke it
    std::vector<Robot> robots_;
    simulation::Objection objection_;
};

ClaimGuard::ClaimGuard(const simulation::Scenario& scenario, std::vector<FollowedKind> kinds,
                       std::vector<Watched> watched)
    : scenario_(scenario), kinds_(std::move(kinds)), watched_(std::move(watched)) {}

simulation::Guard::Maker ClaimGuard::make_observer(Maker other) {
    return [this, other = std::move(other)](std::uint32_t trial) {
        return std::make_unique<Watch>(*this, trial, other ? other(trial) : nullptr);
    };
}

std::string ClaimGuard::summary_lines() const {
    std::string text = fmt::format("  claims followed: {}; robots watched: {}; an input counts when it is raised\n",
                                   watched_.size(), robots_.load());
    for (const std::string& reason : left_out_) text += fmt::format("  not followed: {}\n", reason);
    for (const auto& [number, why] : given_up_)
        text += fmt::format("  {}: not followed to the end: {}\n", watched_[number].claim->name,
                            diagnostics::escape_for_display(why));
    for (const auto& [number, broken] : broken_)
        text += fmt::format("  {}: first broken in trial {} by robot {}: {}\n", watched_[number].claim->name,
                            broken.trial + 1, broken.robot, diagnostics::escape_for_display(broken.text));
    return text;
}

bool follows_claims(const simulation::Scenario& scenario, const Options& options) {
    return options.simulate.guarding_rules.ends_with(".claims") ||
           std::ranges::any_of(scenario.measures,
                               [](const simulation::Measure& measure) { return measure.kind == MeasureKind::kept; });
}

namespace {

/// Finds the claims of a scenario and of `--monitor`.
class Finder {
public:
    Finder(const simulation::Scenario& scenario, std::vector<FollowedKind> kinds, driver::Project& reports,
           const Options& options)
        : scenario_(scenario), kinds_(std::move(kinds)), reports_(reports), options_(options) {}

    std::unique_ptr<ClaimGuard> find() {
        for (std::size_t m = 0; m < scenario_.measures.size(); ++m)
            if (scenario_.measures[m].kind == MeasureKind::kept) add_measure(m, scenario_.measures[m]);
        const bool monitors = options_.simulate.guarding_rules.ends_with(".claims");
        if (monitors)
            for (std::size_t kind = 0; kind < scenario_.kind_count(); ++kind) add_file(kind);
        if (monitors && watched_.empty())
            refuse({}, fmt::format("--monitor {}: no claim of the file is about the controller{}",
                                   diagnostics::escape_for_display(options_.simulate.guarding_rules),
                                   left_out_.empty() ? "" : ": " + left_out_.front()));
        if (watched_.empty()) return nullptr;
        auto guard = std::make_unique<ClaimGuard>(scenario_, kinds_, std::move(watched_));
        for (std::string& reason : left_out_) guard->add_left_out(std::move(reason));
        return guard;
    }

private:
    void refuse(diagnostics::Span span, std::string text) {
        reports_.diagnostics.report(driver::rules::bad_option, span, {std::move(text)});
    }
    [[nodiscard]] const std::string& component(std::size_t kind) const {
        return scenario_.kind_at(kind).component.text;
    }
    [[nodiscard]] const std::vector<CheckedClaim>& claims(std::size_t kind) const {
        return kinds_[kind].project->claims->checked.claims;
    }
    [[nodiscard]] driver::FollowedClaim::Drops drops(const CheckedClaim& claim, std::size_t kind) const {
        return dropped_events(*kinds_[kind].project, claim.component.path);
    }
    /// Returns the reason why the claim cannot be followed; "" if it can.
    [[nodiscard]] std::string reason_against(const CheckedClaim& claim, std::size_t kind) const {
        if (const std::string why = claims::why_not_monitored(claim); !why.empty())
            return fmt::format("{}: {}", claim.name, why);
        const std::string missing = missing_channel(claim, *kinds_[kind].emission);
        if (missing.empty()) return "";
        return fmt::format("{}: the controller has no event and no operation `{}`", claim.name, missing);
    }

    /// Adds the claim of a measure, which is about the controller of one kind.
    void add_measure(std::size_t number, const simulation::Measure& measure) {
        std::vector<std::string> names;
        for (std::size_t kind = 0; kind < scenario_.kind_count(); ++kind) {
            if (measure.of && *measure.of != kind) continue;
            for (const CheckedClaim& claim : claims(kind)) {
                if (!is_about(claim, component(kind))) continue;
                names.push_back(claim.name);
                if (claim.name != measure.state.text) continue;
                const std::string against = reason_against(claim, kind);
                if (!against.empty())
                    reports_.diagnostics.report(simulation::rules::out_of_range, measure.state.span, {against});
                watched_.push_back({&claim, kind, false, number, drops(claim, kind)});
                return;
            }
        }
        const std::string meant = diagnostics::nearest_spelling(measure.state.text, names);
        reports_.diagnostics.report(simulation::rules::unknown_part, measure.state.span,
                                    {fmt::format("claim about {}{} named", component(measure.of.value_or(0)),
                                                 meant.empty() ? "" : fmt::format(" (did you mean '{}'?)", meant)),
                                     measure.state.text});
    }

    void add_file(std::size_t kind) {
        const driver::Project& project = *kinds_[kind].project;
        const auto normal = [](const std::string& path) {
            return std::filesystem::path(path).lexically_normal().string();
        };
        for (const CheckedClaim& claim : claims(kind)) {
            const std::string path(project.sources.path(claim.span.source));
            if (normal(path) != normal(options_.simulate.guarding_rules)) continue;
            std::string against = is_about(claim, component(kind))
                                      ? reason_against(claim, kind)
                                      : fmt::format("{} is about {}", claim.name, claim.component.path);
            if (against.empty())
                watched_.push_back({&claim, kind, true, std::nullopt, drops(claim, kind)});
            else
                left_out_.push_back(std::move(against));
        }
    }

    const simulation::Scenario& scenario_;
    std::vector<FollowedKind> kinds_;
    driver::Project& reports_;
    const Options& options_;
    std::vector<ClaimGuard::Watched> watched_;
    std::vector<std::string> left_out_;
};

}  // namespace

void refuse_followed_claims(const simulation::Scenario& scenario, driver::Project& project) {
    for (const simulation::Measure& measure : scenario.measures)
        if (measure.kind == MeasureKind::kept)
            project.diagnostics.report(simulation::rules::out_of_range, measure.state.span,
                                       {"claims of the model are followed by `simulate` and in sweeps, not here"});
}

std::unique_ptr<ClaimGuard> make_claim_guard(const simulation::Scenario& scenario, std::vector<FollowedKind> kinds,
                                             driver::Project& reports, const Options& options) {
    return Finder(scenario, std::move(kinds), reports, options).find();
}

}  // namespace robochart::app
