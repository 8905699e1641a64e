// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/files/channels.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cpp_emit/code/cycles.hpp"
#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit {

namespace {

/// A running unit, with the expression for its frame.
struct Running {
    const Unit* unit = nullptr;
    std::string frame;
};

/// A site that sends, with the frame in which its thread runs. The frames of the operations that called it come before.
struct Place {
    std::vector<Running> calls;
    const SendSite* site = nullptr;
};

class ChannelWriter {
public:
    ChannelWriter(const Generation& generation, const Core& core, CodeWriter& out)
        : generation_(generation), core_(core), out_(out) {}

    void write_channel(const Part& part, const EventUse& use) {
        places_.clear();
        collect_places({{&generation_.component.units[part.root], part.frame_expression()}}, use.channel);
        const std::string who = part.name + " sends " + use.name;
        const std::string value =
            use.type ? fmt::format(", [[maybe_unused]] {}& value", cpp_type(generation_.system, *use.type)) : "";
        out_.gap();
        out_.doc(fmt::format("Places where {}.", who));
        out_.line(fmt::format("static constexpr std::uint32_t sites_{} = {};", use.channel, places_.size()));
        out_.gap();
        out_.open(fmt::format("[[nodiscard]] bool offers_{}([[maybe_unused]] std::uint32_t site{}) noexcept {{",
                              use.channel, value));
        switch_of([&](const Place& place) { write_offer(place, use); }, "return false;", "const auto& ");
        out_.close();
        out_.gap();
        out_.open(fmt::format("void accept_{}([[maybe_unused]] std::uint32_t site) noexcept {{", use.channel));
        switch_of([&](const Place& place) { write_acceptance(part, place); }, "return;", "auto& ");
        out_.close();
    }

private:
    /// Collects the sites of the last unit in `calls`. Then collects the sites of the operations that its threads run,
    /// through all nested calls.
    void collect_places(const std::vector<Running>& calls, const std::string& channel) {
        const Component& component = generation_.component;
        const Running& running = calls.back();
        const MachineCode& code = core_.machines[component.unit_places[running.unit->number]];
        for (const SendSite& site : code.sites)
            if (site.channel == channel) places_.push_back({calls, &site});
        for (const CallFrame& call : code.calls) {
            std::vector<Running> inside = calls;
            inside.push_back({&component.unit_at(call.operation), running.frame + "." + call.field});
            collect_places(inside, channel);
        }
    }

    /// Declares names for the frame of the site's unit, and for the frames of the operations whose variables it uses.
    void bind_frames(const Place& place, const std::string& reference) {
        const Running& running = place.calls.back();
        out_.line(fmt::format("{}f = {};", reference, running.frame));
        if (place.site->value.empty()) return;
        for (const Running& outer : place.calls) {
            const auto& lenders = running.unit->lenders;
            if (std::ranges::find(lenders, outer.unit->number) != lenders.end())
                out_.line(fmt::format("[[maybe_unused]] {}{} = {};", reference, lent_frame(*outer.unit), outer.frame));
        }
    }

    template <class Case>
    void switch_of(const Case& write_case, const char* otherwise, const char* binding) {
        if (places_.empty()) return out_.line(otherwise);
        out_.open("switch (site) {");
        for (std::size_t index = 0; index < places_.size(); ++index) {
            out_.open(fmt::format("case {}: {{", index));
            bind_frames(places_[index], binding);
            write_case(places_[index]);
            out_.close();
        }
        out_.line(fmt::format("default: {}", otherwise));
        out_.close();
    }

    void write_offer(const Place& place, const EventUse& use) {
        out_.line(fmt::format("if ({} != {}) return false;", place.site->thread, place.site->at));
        if (use.type && !place.site->value.empty()) out_.line(fmt::format("value = {};", place.site->value));
        const bool lists = use.type && has_lists(generation_.system, *use.type);
        out_.line(lists ? "return lists_fit();" : "return true;");
    }

    void write_acceptance(const Part& part, const Place& place) {
        out_.line(fmt::format("{} = {};", place.site->thread, place.site->next));
        if (core_.machines[part.root].layout.prompt) out_.line(fmt::format("prompt({});", part.frame_expression()));
        out_.line("return;");
    }

    const Generation& generation_;
    const Core& core_;
    CodeWriter& out_;
    std::vector<Place> places_;
};

/// Returns the expression for the frame of each part: "state_.stm0".
std::vector<std::string> each_part(const Generation& generation, const char* format) {
    std::vector<std::string> result;
    for (const Part& part : generation.component.parts)
        result.push_back(fmt::format(fmt::runtime(format), part.frame_expression()));
    return result;
}

}  // namespace

void write_channels(const Generation& generation, const Core& core, CodeWriter& out) {
    ChannelWriter writer(generation, core, out);
    for (const Part& part : generation.component.parts)
        for (const EventUse& use : part.events)
            if (!use.channel.empty()) writer.write_channel(part, use);
}

std::vector<Field> common_fields(const Generation& generation) {
    std::vector<Field> fields;
    for (const Buffer& buffer : generation.component.buffers) {
        const Extent extent = buffer.type ? cpp_extent(generation.system, generation.inst, *buffer.type) : Extent{0, 1};
        fields.push_back({buffer_type(generation, buffer), buffer.field, "{}", "connection of " + buffer.name,
                          extent.size + extent.alignment, extent.alignment, extent.varies});
    }
    for (const StoredVariable& variable : generation.component.variables)
        for (const PropagationHolder& holder : variable.holders)
            fields.push_back({"std::uint8_t", holder.field, "0",
                              fmt::format("writes of {} on their way to {}", variable.variable->name,
                                          generation.component.parts[holder.part].name),
                              1, 1});
    if (!generation.component.is_composed()) return fields;
    for (const StoredVariable& stored : generation.component.variables) {
        if (!stored.in_state() || stored.home != no_part) continue;
        const Extent extent = cpp_extent(generation.system, generation.inst, stored.variable->type);
        fields.push_back({cpp_type(generation.system, stored.variable->type), stored.field,
                          cpp_value(generation.system, generation.inst, stored.variable->type, stored.initial),
                          generation.place_text(stored.variable->origin), extent.size, extent.alignment,
                          extent.varies});
    }
    return fields;
}

FrameLayout composed_layout(const Generation& generation, const Core& core, std::vector<Field> more) {
    bool timed = false;
    for (const Part& part : generation.component.parts) {
        const FrameLayout& inner = core.machines[part.root].layout;
        more.push_back({generation.component.units[part.root].frame + "<Types>", part.tag, "", part.name, inner.size,
                        inner.alignment, inner.varies});
        timed = timed || inner.timed;
    }
    return arrange_fields(std::move(more), timed);
}

void write_composition(const Generation& generation, const Core& core, CodeWriter& out) {
    out.open_declaration("Everything that can happen in this cycle, in any machine.", "void run() noexcept {");
    for (const Part& part : generation.component.parts)
        if (core.machines[part.root].layout.prompt) out.line(fmt::format("prompt({});", part.frame_expression()));
    std::vector<std::string> rounds;
    for (const Part& part : generation.component.parts) {
        if (!core.machines[part.root].leads || generation.mutation.hits(Fault::order_ignored)) continue;
        rounds.push_back(fmt::format("lead({})", part.frame_expression()));
    }
    const std::vector<std::string> all = each_part(generation, "round({})");
    rounds.insert(rounds.end(), all.begin(), all.end());
    out.open(fmt::format("while ({}({})) {{", generation.round_test(), fmt::join(rounds, " || ")));
    out.close();
    out.close();
    out.open_declaration("All machines have ended: they terminate together.",
                         "[[nodiscard]] bool finished() const noexcept {");
    out.line(fmt::format("return {};", fmt::join(each_part(generation, "finished({})"), " && ")));
    out.close();
    if (!core.layout.timed) return;
    out.open_declaration("Time passes for all.", "void advance() noexcept {");
    for (const Part& part : generation.component.parts)
        if (core.machines[part.root].layout.timed) out.line(fmt::format("advance({});", part.frame_expression()));
    out.close();
}

}  // namespace robochart::cpp_emit
