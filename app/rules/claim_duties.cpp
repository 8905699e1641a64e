// SPDX-License-Identifier: Apache-2.0
// See claim_duties.hpp.
#include "app/rules/claim_duties.hpp"

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
#include "driver/model/instantiated_claims.hpp"
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

}  // namespace

/// Follows the claims about one robot.
class ClaimDuties::Robot final : public Follower {
public:
    Robot(ClaimDuties& all, std::size_t kind) : all_(all), kind_(all.kinds_[kind]) {
        for (std::size_t i = 0; i < all.claims_.size(); ++i)
            if (all.claims_[i].kind == kind)
                runs_.push_back({i, driver::FollowedClaim(*all.claims_[i].claim, kind_.project->system,
                                                          kind_.project->unit, all.claims_[i].drops)});
    }

    [[nodiscard]] std::vector<BrokenDuty> observe_cycle(const rc_signal* inputs, const rc_actions& outputs,
                                                        rc_drive_result result) override {
        std::vector<BrokenDuty> broken;
        if (ended_) return broken;
        ended_ = result != RC_DRIVE_QUIESCENT;
        for (Run& run : runs_) {
            if (run.claim.is_broken()) continue;
            follow_cycle(run.claim, inputs, outputs, result);
            if (run.claim.is_broken()) broken.push_back(broken_duty(run));
        }
        return broken;
    }
    [[nodiscard]] bool is_conclusive() const override { return std::ranges::none_of(runs_, is_open); }
    void end() override {
        for (const Run& run : runs_)
            if (is_open(run)) all_.given_up_.emplace(run.number, run.claim.unknown());
    }

private:
    struct Run {
        std::size_t number = 0;  ///< of the claim
        driver::FollowedClaim claim;
    };

    static bool is_open(const Run& run) { return !run.claim.is_broken() && !run.claim.unknown().empty(); }

    void follow_cycle(driver::FollowedClaim& run, const rc_signal* inputs, const rc_actions& outputs,
                      rc_drive_result result) const {
        const cpp_emit::DriveEmission& emission = *kind_.emission;
        for (std::size_t i = 0; i < emission.inputs.size(); ++i) {
            const cpp_emit::Port& port = emission.inputs[i];
            if (inputs[i].present == 0 || port.kind != cpp_emit::Port::Kind::event) continue;
            run.observe(port.name, true, carried_texts(port, &inputs[i].value));
        }
        for (std::uint32_t a = 0; a < outputs.count; ++a) {
            const cpp_emit::Port& port = emission.outputs[outputs.action[a].output];
            if (port.kind == cpp_emit::Port::Kind::variable) continue;
            run.observe(port.name, false, carried_texts(port, outputs.action[a].argument));
        }
        if (result == RC_DRIVE_TERMINATED) run.end();
        for (std::uint32_t t = 0; result == RC_DRIVE_QUIESCENT && t < all_.scenario_.units_per_step; ++t) run.tock();
    }

    [[nodiscard]] BrokenDuty broken_duty(const Run& run) const {
        const WatchedClaim& followed = all_.claims_[run.number];
        BrokenDuty result;
        result.number = run.number;
        result.reasons = fmt::format("{}", fmt::join(run.claim.reasons(), "; "));
        if (followed.stops) result.cause = fmt::format("{} is broken: {}", followed.claim->name, result.reasons);
        result.place = kind_.project->sources.path_and_line(followed.claim->span);
        return result;
    }

    ClaimDuties& all_;
    const FollowedKind& kind_;
    bool ended_ = false;
    std::vector<Run> runs_;
};

ClaimDuties::ClaimDuties(const simulation::Scenario& scenario, std::vector<FollowedKind> kinds,
                         std::vector<WatchedClaim> claims, std::vector<std::string> left_out)
    : scenario_(scenario), kinds_(std::move(kinds)), claims_(std::move(claims)), left_out_(std::move(left_out)) {
    for (std::size_t kind = 0; kind < scenario.kind_count(); ++kind) first_.push_back(scenario.first_robot(kind));
    first_.push_back(scenario.all_robots());
}

std::unique_ptr<Follower> ClaimDuties::make_follower(std::size_t robot) {
    const auto kind = static_cast<std::size_t>(std::ranges::upper_bound(first_, robot) - first_.begin()) - 1;
    return std::make_unique<Robot>(*this, kind);
}

void ClaimDuties::note_broken(std::uint32_t trial, std::size_t robot, const BrokenDuty& broken) {
    const auto known = broken_.find(broken.number);
    if (known != broken_.end() && known->second.trial <= trial) return;
    broken_[broken.number] = {trial, robot, broken.reasons};
}

std::optional<double> ClaimDuties::kept_share(std::size_t measure,
                                              const std::map<std::size_t, std::size_t>& broken) const {
    for (std::size_t i = 0; i < claims_.size(); ++i) {
        const WatchedClaim& followed = claims_[i];
        if (followed.measure != measure) continue;
        const auto robots = static_cast<double>(first_[followed.kind + 1] - first_[followed.kind]);
        const auto found = broken.find(i);
        if (found == broken.end() || robots <= 0) return 1;
        return 1 - static_cast<double>(found->second) / robots;
    }
    return std::nullopt;
}

std::string ClaimDuties::summary_lines(std::uint64_t robots) const {
    std::string text = fmt::format("  claims followed: {}; robots watched: {}; an input counts when it is raised\n",
                                   claims_.size(), robots);
    for (const std::string& reason : left_out_) text += fmt::format("  not followed: {}\n", reason);
    for (const auto& [number, why] : given_up_)
        text += fmt::format("  {}: not followed to the end: {}\n", claims_[number].claim->name,
                            diagnostics::escape_for_display(why));
    for (const auto& [number, broken] : broken_)
        text += fmt::format("  {}: first broken in trial {} by robot {}: {}\n", claims_[number].claim->name,
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

    std::unique_ptr<ClaimDuties> find() {
        for (std::size_t m = 0; m < scenario_.measures.size(); ++m)
            if (scenario_.measures[m].kind == MeasureKind::kept) add_measure(m, scenario_.measures[m]);
        const bool monitors = options_.simulate.guarding_rules.ends_with(".claims");
        if (monitors)
            for (std::size_t kind = 0; kind < scenario_.kind_count(); ++kind) add_file(kind);
        if (monitors && followed_.empty())
            refuse({}, fmt::format("--monitor {}: no claim of the file is about the controller{}",
                                   diagnostics::escape_for_display(options_.simulate.guarding_rules),
                                   left_out_.empty() ? "" : ": " + left_out_.front()));
        if (followed_.empty()) return nullptr;
        return std::make_unique<ClaimDuties>(scenario_, kinds_, std::move(followed_), std::move(left_out_));
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
        if (missing.empty()) {
            const std::string other = driver::why_other_constants(*kinds_[kind].project, claim);
            return other.empty() ? "" : fmt::format("{}: {}", claim.name, other);
        }
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
                followed_.push_back({&claim, kind, false, number, drops(claim, kind)});
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
                followed_.push_back({&claim, kind, true, std::nullopt, drops(claim, kind)});
            else
                left_out_.push_back(std::move(against));
        }
    }

    const simulation::Scenario& scenario_;
    std::vector<FollowedKind> kinds_;
    driver::Project& reports_;
    const Options& options_;
    std::vector<WatchedClaim> followed_;
    std::vector<std::string> left_out_;
};

}  // namespace

void refuse_followed_claims(const simulation::Scenario& scenario, driver::Project& project) {
    for (const simulation::Measure& measure : scenario.measures)
        if (measure.kind == MeasureKind::kept)
            project.diagnostics.report(simulation::rules::out_of_range, measure.state.span,
                                       {"claims of the model are followed by `simulate` and in sweeps, not here"});
}

std::unique_ptr<ClaimDuties> find_claim_duties(const simulation::Scenario& scenario, std::vector<FollowedKind> kinds,
                                               driver::Project& reports, const Options& options) {
    return Finder(scenario, std::move(kinds), reports, options).find();
}

}  // namespace robochart::app
