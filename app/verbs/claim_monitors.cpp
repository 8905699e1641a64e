// SPDX-License-Identifier: Apache-2.0
// Implements `emit monitor MODEL.claims`, which writes claims as monitors in C++. The monitor of a claim
// (claims/monitor) is explored as for `check`, and its states are written as tables for cpp_emit/runtime/monitor.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/claims/event_order.hpp"
#include "app/command/findings.hpp"
#include "app/command/recording.hpp"
#include "app/command/rules.hpp"
#include "app/command/run.hpp"
#include "app/verbs/verbs.hpp"
#include "app/verbs/write_files.hpp"
#include "base/diagnostics/escape.hpp"
#include "claims/decide/automaton.hpp"
#include "claims/decide/letters.hpp"
#include "conformance/monitor/monitor.hpp"
#include "driver/model/instantiated_claims.hpp"
#include "driver/model/project_claims.hpp"
#include "driver/settings/rules.hpp"

namespace robochart::app {
namespace {

using claims::CheckedClaim;
using claims::Letter;

/// The tables of one claim, with all data to which they point. Column 0 represents an input that was not raised, and
/// leaves the state unchanged.
class ClaimTables {
public:
    /// Throws claims::NotDecided if the claim has no monitor of moderate size.
    ClaimTables(const CheckedClaim& claim, const driver::Project& project, std::uint32_t cycle)
        : claim_(claim), instantiation_(project.instantiation) {
        letters_ = claims::letters_of(claim, project.system, project.instantiation, {});
        const std::vector<claims::DroppedChannel> drops = add_drops(project);
        fill_states(drops.empty() && input_count() < 2
                        ? claims::make_automaton(claim, letters_, project.diagnostics.budget())
                        : claims::make_cycle_automaton(claim, letters_, drops, project.diagnostics.budget()));
        std::set<std::size_t> channels;
        for (const Letter& letter : letters_) channels.insert(letter.occurrence.channel);
        for (const std::size_t channel : channels) add_channel(channel, project.system);
        set_tables(cycle);
    }
    ClaimTables(const ClaimTables&) = delete;
    ClaimTables& operator=(const ClaimTables&) = delete;

    [[nodiscard]] const MonitorTables& tables() const { return tables_; }

private:
    struct Stored {
        std::deque<std::vector<std::int64_t>> numbers;
        std::vector<MonitorValues> values;
        std::vector<std::uint16_t> columns;
    };

    [[nodiscard]] bool has_letter(std::size_t channel) const {
        return std::ranges::any_of(letters_,
                                   [&](const Letter& letter) { return letter.occurrence.channel == channel; });
    }
    /// Returns the number of inputs that the claim names.
    [[nodiscard]] std::size_t input_count() const {
        std::set<std::size_t> inputs;
        for (const Letter& letter : letters_)
            if (claim_.component.channels[letter.occurrence.channel].kind == claims::ChannelKind::input)
                inputs.insert(letter.occurrence.channel);
        return inputs.size();
    }
    /// Returns the drops of the declared order that affect the events of the claim, and adds letters for their events.
    std::vector<claims::DroppedChannel> add_drops(const driver::Project& project) {
        std::vector<claims::DroppedChannel> result;
        const auto& channels = claim_.component.channels;
        const auto input = [&](const std::string& name) {
            const auto found = std::ranges::find_if(channels, [&](const claims::Channel& channel) {
                return channel.name == name && channel.kind == claims::ChannelKind::input;
            });
            return static_cast<std::size_t>(found - channels.begin());
        };
        for (const claims::CheckedOrder::Drop& drop : dropped_events(project, claim_.component.path))
            result.push_back({input(drop.event), input(drop.dropped)});
        if (std::ranges::none_of(result, [&](const auto& drop) { return has_letter(drop.dropped); })) return {};
        for (const claims::DroppedChannel& drop : result)
            for (const std::size_t channel : {drop.event, drop.dropped})
                if (!has_letter(channel)) letters_.push_back({{channel, {}}, {}, {}, {}, channels[channel].name});
        return result;
    }
    [[nodiscard]] std::size_t column_count() const { return letters_.size() + 3; }

    void fill_states(const claims::Automaton& automaton) {
        constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max() - 1;
        if (automaton.size() > most || column_count() > most)
            throw claims::NotDecided("the monitor has too many states for its tables");
        for (std::size_t state = 0; state < automaton.size(); ++state) {
            const auto add = [&](std::optional<std::size_t> next) {
                next_.push_back(next ? static_cast<std::uint16_t>(*next) : Monitor::dead);
            };
            add(state);
            for (const auto& next : automaton[state].by_letter) add(next);
            add(automaton[state].by_tock);
            add(automaton[state].may_end ? std::optional(state) : std::nullopt);
        }
        where_.assign(automaton.size(), nullptr);
    }

    /// Adds the values of an argument, in the order of the letters (the last argument varies fastest).
    void add_values(Stored& stored, const std::vector<const Letter*>& letters, std::size_t argument,
                    const ir::Type& type) const {
        const std::int64_t scale = type.kind == ir::TypeKind::real ? instantiation_.scale : 1;
        std::set<std::int64_t> found;
        bool any = true;
        for (const Letter* letter : letters) {
            if (argument >= letter->occurrence.values.size()) continue;
            any = false;
            const claims::Fraction& value = letter->occurrence.values[argument];
            found.insert(value.numerator() * (scale / value.denominator()));
        }
        if (any) found.insert(0);  // no condition reads the argument, so one value represents all
        std::vector<std::int64_t>& numbers = stored.numbers.emplace_back(found.begin(), found.end());
        const bool consecutive = numbers.back() - numbers.front() == std::ssize(numbers) - 1;
        stored.values.push_back({numbers.data(), static_cast<std::uint32_t>(numbers.size()), scale, consecutive, any});
    }

    void add_channel(std::size_t number, const ir::System& system) {
        const claims::Channel& channel = claim_.component.channels[number];
        const bool input = channel.kind == claims::ChannelKind::input;
        Stored& stored = stored_.emplace_back();
        std::vector<const Letter*> letters;
        if (input) stored.columns.push_back(0);
        for (std::size_t i = 0; i < letters_.size(); ++i) {
            if (letters_[i].occurrence.channel != number) continue;
            letters.push_back(&letters_[i]);
            stored.columns.push_back(static_cast<std::uint16_t>(i + 1));
        }
        for (std::size_t argument = 0; argument < channel.types.size(); ++argument)
            add_values(stored, letters, argument, system.type(channel.types[argument]));
        const MonitorChannel made{channel.name.c_str(), "", stored.values.data(),
                                  static_cast<std::uint32_t>(channel.types.size()), stored.columns.data()};
        (input ? inputs_ : outputs_).push_back(made);
    }

    void set_tables(std::uint32_t cycle) {
        name_ = fmt::format("claim {} of {}", claim_.name, claim_.component.path);
        const auto columns = static_cast<std::uint32_t>(column_count());
        tables_ = {name_.c_str(),
                   cycle,
                   static_cast<std::uint32_t>(where_.size()),
                   columns,
                   next_.data(),
                   static_cast<std::uint32_t>(inputs_.size()),
                   inputs_.data(),
                   static_cast<std::uint32_t>(outputs_.size()),
                   outputs_.data(),
                   static_cast<std::uint16_t>(columns - 2),
                   static_cast<std::uint16_t>(columns - 1),
                   where_.data()};
    }

    const CheckedClaim& claim_;
    const ir::Instantiation& instantiation_;
    std::vector<Letter> letters_;
    std::vector<std::uint16_t> next_;
    std::deque<Stored> stored_;
    std::vector<MonitorChannel> inputs_, outputs_;
    std::vector<const char*> where_;
    std::string name_;
    MonitorTables tables_{};
};

bool write_monitor(const CheckedClaim& claim, driver::Project& project, const Options& options, Report& report) {
    if (const std::string why = claims::why_not_monitored(claim); !why.empty()) {
        const auto edit = options.run->edit();
        report.remarks.push_back(fmt::format("{}{}: no monitor, because {}", project.label, claim.name, why));
        return true;
    }
    try {
        const ClaimTables made(claim, driver::project_of(project, claim), options.code.cycle);
        const std::string below = fmt::format("monitor/{}{}/", project.folder, claim.name);
        const std::string subject = fmt::format("\"{}\"", diagnostics::escape_for_display(claim.wording));
        const auto files = conformance::monitor_files(made.tables(), claim.name, subject);
        if (!write_all(below, files, report.monitor_files, options, project)) return false;
        const auto edit = options.run->edit();
        report.remarks.push_back(fmt::format("{}{}: {} states, {} columns", project.label, claim.name,
                                             made.tables().states, made.tables().columns));
        return true;
    } catch (const claims::NotDecided& error) {
        project.diagnostics.report(rules::no_monitor, claim.span, {claim.name, error.what()});
        return false;
    }
}

std::string normal(const std::string& path) {
    return std::filesystem::path(path).lexically_normal().string();
}

}  // namespace

bool write_claim_monitors(const Options& given, Report& report) {
    if (!given.load.component.empty() || given.output.phase != Phase::none)
        throw UsageError("--component and --print apply to models, not to claims");
    Options options = given;
    options.load.claims = driver::ClaimUse::read;
    std::set<std::string> inputs;
    for (const std::string& input : options.load.inputs) inputs.insert(normal(input));
    std::vector<driver::Part> parts = driver::load_parts(options, options.run->budget());
    record_projects(parts, options, options);
    bool written = true;
    for (driver::Part& part : parts) {
        driver::Project& project = *part.project;
        written = is_acceptable(project, options.load) && written;
        if (!is_acceptable(project, options.load)) {
            show_findings(project, options);
            continue;
        }
        for (const CheckedClaim& claim : project.claims->checked.claims)
            if (inputs.contains(normal(std::string(project.sources.path(claim.span.source)))))
                written = write_monitor(claim, project, options, report) && written;
        show_findings(project, options);
    }
    return written;
}

}  // namespace robochart::app
