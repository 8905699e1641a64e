// SPDX-License-Identifier: Apache-2.0
#include "checker/machine/transfer.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>

#include "checker/lts/symmetric_system.hpp"
#include "checker/machine/reduced_system.hpp"
#include "checker/machine/supercombinator_system.hpp"

namespace robochart::machine {

using lts::BadBytes;
using lts::ByteReader;
using lts::ByteWriter;

namespace {

void write(const std::vector<std::uint32_t>& values, ByteWriter& out) {
    out.write_number(values.size());
    for (const std::uint32_t value : values) out.write_number(value);
}

EventSet read_events(ByteReader& in) {
    EventSet events(in.read_count());
    for (Event& event : events) event = in.read_word();
    if (std::ranges::adjacent_find(events, std::greater_equal<>()) != events.end())
        throw BadBytes("events are not in order");
    return events;
}

void write(const Component& component, ByteWriter& out) {
    out.write_number(component.size());
    for (Local state = 0; state < component.size(); ++state) {
        const Component::Edges edges = component.edges(state);
        out.write_number(edges.size());
        for (const Component::Edge& edge : edges)
            for (const std::uint32_t value : {component.alphabet()[edge.event], edge.revealed, edge.target})
                out.write_number(value);
    }
}

ComponentPtr read_component(ByteReader& in, TermId meaning) {
    std::vector<std::vector<Component::RawEdge>> rows(in.read_count());
    for (auto& row : rows) {
        row.resize(in.read_count());
        for (Component::RawEdge& edge : row) {
            edge.event = in.read_word();
            edge.revealed = in.read_word();
            edge.target = in.read_below(rows.size());
        }
        if (!std::ranges::is_sorted(row, [](const auto& a, const auto& b) { return a.event < b.event; }))
            throw BadBytes("edges are not in order");
    }
    return std::make_shared<const Component>(rows, std::vector<TermId>(rows.size(), meaning));
}

void write(const Region& region, ByteWriter& out) {
    out.write_number(region.participants.size());
    for (std::size_t who = 0; who < region.participants.size(); ++who) {
        out.write_number(region.participants[who].is_region ? 1 : 0);
        out.write_number(region.participants[who].index);
        write(region.alphabets[who], out);
    }
    write(region.alphabet, out);
    out.write_number(region.requirements.size());
    for (const Requirement& requirement : region.requirements)
        for (const std::uint32_t value : {requirement.participant, requirement.event}) out.write_number(value);
    out.write_number(region.assignments.size());
    for (const Assignment& assignment : region.assignments)
        for (const std::uint32_t value : {assignment.slot, assignment.value}) out.write_number(value);
    out.write_number(region.rules.size());
    for (const Rule& rule : region.rules)
        for (const std::uint32_t value :
             {rule.event, rule.revealed, rule.place, rule.level, rule.lead.participant, rule.lead.event,
              rule.first_requirement, rule.end_requirement, rule.first_assignment, rule.end_assignment})
            out.write_number(value);
}

/// Reads one region. Checks that its numbers and participants exist in a process with these components and inner
/// regions.
class RegionReader {
public:
    RegionReader(ByteReader& in, const Supercombinator& process) : in_(in), process_(process) {}

    Region read() {
        read_participants();
        region_.alphabet = read_events(in_);
        region_.requirements.resize(in_.read_count());
        for (Requirement& requirement : region_.requirements) requirement = read_requirement();
        region_.assignments.resize(in_.read_count());
        for (Assignment& assignment : region_.assignments) {
            assignment.slot = in_.read_below(process_.components.size());
            assignment.value = in_.read_below(process_.components[assignment.slot]->size() + std::uint64_t{1});
        }
        region_.rules.resize(in_.read_count());
        for (Rule& rule : region_.rules) rule = read_rule();
        index_rules();
        return std::move(region_);
    }

private:
    void read_participants() {
        region_.participants.resize(in_.read_count());
        for (Participant& participant : region_.participants) {
            participant.is_region = in_.read_below(2) == 1;
            participant.index =
                in_.read_below(participant.is_region ? process_.regions.size() : process_.components.size());
            region_.alphabets.push_back(read_events(in_));
            const EventSet& own = participant.is_region ? process_.regions[participant.index].alphabet
                                                        : process_.components[participant.index]->alphabet();
            if (region_.alphabets.back() != own) throw BadBytes("a participant has another alphabet");
        }
    }

    Requirement read_requirement() {
        Requirement result{};
        result.participant = in_.read_below(region_.participants.size());
        result.event = in_.read_below(region_.alphabets[result.participant].size());
        return result;
    }

    Rule read_rule() {
        Rule result{};
        result.event = in_.read_word();
        result.revealed = in_.read_word();
        result.place = in_.read_below(region_.alphabet.size());
        result.level = in_.read_word();
        result.lead = read_requirement();
        result.first_requirement = in_.read_below(region_.requirements.size() + 1);
        result.end_requirement = in_.read_below(region_.requirements.size() + 1);
        result.first_assignment = in_.read_below(region_.assignments.size() + 1);
        result.end_assignment = in_.read_below(region_.assignments.size() + 1);
        const bool ordered = result.first_requirement <= result.end_requirement &&
                             result.first_assignment <= result.end_assignment &&
                             region_.alphabet[result.place] == result.event;
        if (!ordered) throw BadBytes("a rule contradicts itself");
        return result;
    }

    /// Computes the data that are not transferred: by_event, first_rule.
    void index_rules() {
        region_.by_event.resize(region_.alphabet.size());
        region_.first_rule.resize(region_.participants.size());
        const auto lead = [](const Rule& rule) { return std::pair(rule.lead.participant, rule.lead.event); };
        std::uint32_t next = 0;
        for (std::uint32_t who = 0; who < region_.participants.size(); ++who)
            for (std::uint32_t event = 0; event <= region_.alphabets[who].size(); ++event) {
                region_.first_rule[who].push_back(next);
                for (; next < region_.rules.size() && lead(region_.rules[next]) == std::pair(who, event); ++next)
                    region_.by_event[region_.rules[next].place].push_back(next);
            }
        if (next != region_.rules.size()) throw BadBytes("rules are not in order");
    }

    ByteReader& in_;
    const Supercombinator& process_;
    Region region_;
};

/// Reads the field of a slot. Checks that it can hold all states of the component and "off".
Field read_field(ByteReader& in, const Supercombinator& process, std::size_t slot) {
    Field field{in.read_below(process.words), in.read_below(32), in.read_word()};
    const bool all_ones = std::has_single_bit(field.mask + std::uint64_t{1});
    const bool fits = field.shift + static_cast<std::uint32_t>(std::bit_width(field.mask)) <= 32;
    if (!all_ones || !fits || process.components[slot]->size() > field.mask + std::uint64_t{1})
        throw BadBytes("a field does not fit");
    if (process.initial[slot] > field.mask) throw BadBytes("an initial state does not fit");
    for (const Region& region : process.regions)
        for (const Assignment& assignment : region.assignments)
            if (assignment.slot == slot && assignment.value > field.mask) throw BadBytes("a state does not fit");
    return field;
}

/// Returns a slot with this field. If several slots have the same field, returns any of them.
std::uint32_t slot_of(const Field& field, const Supercombinator& process) {
    const auto same = [&](const Field& other) {
        return other.word == field.word && other.shift == field.shift && other.mask == field.mask;
    };
    return static_cast<std::uint32_t>(std::ranges::find_if(process.fields, same) - process.fields.begin());
}

void write(const lts::Symmetry& symmetry, const Supercombinator& process, ByteWriter& out) {
    out.write_number(symmetry.sets().size());
    for (const lts::ReplicaSet& set : symmetry.sets()) {
        out.write_number(set.size());
        for (const lts::Replica& replica : set) {
            out.write_number(replica.parts.size());
            for (const lts::ReplicaPart& part : replica.parts) {
                out.write_number(slot_of(part.field, process));
                write(*part.number, out);
                write(*part.value, out);
            }
            out.write_number(replica.exchange.size());
            for (const auto& [event, image] : replica.exchange) {
                out.write_number(event);
                out.write_number(image);
            }
        }
    }
}

std::shared_ptr<const std::vector<std::uint32_t>> read_values(ByteReader& in) {
    std::vector<std::uint32_t> values(in.read_count());
    for (std::uint32_t& value : values) value = in.read_word();
    return std::make_shared<const std::vector<std::uint32_t>>(std::move(values));
}

/// Reads a part of a replica: the states of one component of the process.
lts::ReplicaPart read_part(ByteReader& in, const Supercombinator& process) {
    const std::uint32_t slot = in.read_below(process.components.size());
    lts::ReplicaPart part{process.fields[slot], read_values(in), read_values(in)};
    const std::size_t values = process.components[slot]->size() + std::size_t{1};
    for (const auto* numbers : {&part.number, &part.value})
        if ((*numbers)->size() != values ||
            std::ranges::any_of(**numbers, [&](std::uint32_t number) { return number >= values; }))
            throw BadBytes("a replica has no such states");
    return part;
}

lts::Symmetry read_symmetry(ByteReader& in, const Supercombinator& process) {
    std::vector<lts::ReplicaSet> sets(in.read_count());
    for (lts::ReplicaSet& set : sets) {
        set.resize(in.read_count());
        for (lts::Replica& replica : set) {
            const std::size_t parts = in.read_count();
            for (std::size_t i = 0; i < parts; ++i) replica.parts.push_back(read_part(in, process));
            replica.exchange.resize(in.read_count());
            for (auto& [event, image] : replica.exchange) {
                event = in.read_word();
                image = in.read_word();
            }
        }
        const auto as_first = [&](const lts::Replica& replica) {
            return replica.parts.size() == set.front().parts.size();
        };
        if (set.size() < 2 || !std::ranges::all_of(set, as_first)) throw BadBytes("replicas are not alike");
    }
    return lts::Symmetry(std::move(sets));
}

}  // namespace

void write(const Supercombinator& process, ByteWriter& out) {
    out.write_number(process.components.size());
    for (const ComponentPtr& component : process.components) write(*component, out);
    out.write_number(process.regions.size());
    for (const Region& region : process.regions) write(region, out);
    for (const Local local : process.initial) out.write_number(local);
    out.write_number(process.words);
    for (const Field& field : process.fields)
        for (const std::uint32_t value : {field.word, field.shift, field.mask}) out.write_number(value);
    out.write_number(process.operands.size());
    for (const SlotRange& range : process.operands)
        for (const std::uint32_t value : {range.first, range.end}) out.write_number(value);
}

Supercombinator read_supercombinator(ByteReader& in, TermId meaning) {
    Supercombinator process;
    const std::size_t slots = in.read_count();
    for (std::size_t slot = 0; slot < slots; ++slot) process.components.push_back(read_component(in, meaning));
    const std::size_t regions = in.read_count();
    if (regions == 0) throw BadBytes("a process has no rules");
    for (std::size_t i = 0; i < regions; ++i) process.regions.push_back(RegionReader(in, process).read());
    for (std::size_t slot = 0; slot < slots; ++slot)
        process.initial.push_back(in.read_below(process.components[slot]->size() + std::uint64_t{1}));
    process.words = in.read_below(slots + 2);
    if (process.words == 0) throw BadBytes("a state has no words");
    for (std::size_t slot = 0; slot < slots; ++slot) process.fields.push_back(read_field(in, process, slot));
    process.operands.resize(in.read_count());
    for (SlotRange& range : process.operands) {
        range.first = in.read_below(slots + 1);
        range.end = in.read_below(slots + 1);
    }
    list_leading(process, diagnostics::unlimited);
    return process;
}

namespace {

/// Returns the compiled process of a system without symmetry. A reduced system gives the process that it reduces.
/// Returns null for all other systems.
const Supercombinator* process_of(const lts::TransitionSystem& system) {
    if (const auto* machine = dynamic_cast<const SupercombinatorSystem*>(&system)) return &machine->combined();
    const auto* smaller = dynamic_cast<const ReducedSystem*>(&system);
    return smaller != nullptr ? &smaller->combined() : nullptr;
}

constexpr std::array reduced_forms{lts::Followed::taus, lts::Followed::steps};

/// Returns 0 for a whole process. For a reduced form, returns its index plus one.
std::uint64_t form_of(const lts::TransitionSystem& system) {
    const auto* smaller = dynamic_cast<const ReducedSystem*>(&system);
    if (smaller == nullptr) return 0;
    return static_cast<std::uint64_t>(std::ranges::find(reduced_forms, smaller->followed()) - reduced_forms.begin()) +
           1;
}

}  // namespace

bool write(const lts::TransitionSystem& system, ByteWriter& out) {
    const auto* folded = dynamic_cast<const lts::SymmetricSystem*>(&system);
    const lts::TransitionSystem& inner = folded != nullptr ? folded->original_system() : system;
    const Supercombinator* process = process_of(inner);
    if (process == nullptr) return false;
    out.write_number(form_of(inner));
    write(*process, out);
    out.write_number(folded != nullptr ? 1 : 0);
    if (folded != nullptr) write(folded->symmetry(), *process, out);
    return true;
}

std::unique_ptr<lts::TransitionSystem> read_system(ByteReader& in, process::TermStore& terms) {
    const std::uint32_t form = in.read_below(reduced_forms.size() + 1);
    const auto process = std::make_shared<const Supercombinator>(read_supercombinator(in, TermId{0}));
    std::unique_ptr<lts::TransitionSystem> system = std::make_unique<SupercombinatorSystem>(process, terms);
    if (form != 0) system = system->make_reduced_system(reduced_forms[form - 1], diagnostics::unlimited);
    if (!system) throw BadBytes("a process has no reduced form");
    if (in.read_below(2) == 0) return system;
    return std::make_unique<lts::SymmetricSystem>(std::move(system), read_symmetry(in, *process));
}

}  // namespace robochart::machine
