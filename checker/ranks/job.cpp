#include "checker/ranks/job.hpp"

#include <algorithm>

#include "checker/machine/transfer.hpp"

namespace robochart::ranks {

using lts::BadBytes;
using lts::ByteReader;
using lts::ByteWriter;
using refine::LevelQuestion;
using refine::NormalTable;

namespace {

constexpr std::uint64_t version = 2;

void write(const NormalTable& table, ByteWriter& out) {
    out.number(table.nodes.size());
    for (const NormalTable::Node& node : table.nodes) {
        out.number(node.diverges ? 1 : 0);
        out.number(node.arcs.size());
        for (const auto& [event, target] : node.arcs) {
            out.number(event);
            out.number(target);
        }
        out.number(node.acceptances.size());
        for (const process::EventSet& set : node.acceptances) {
            out.number(set.size());
            for (const process::Event event : set) out.number(event);
        }
    }
}

std::shared_ptr<const NormalTable> read_table(ByteReader& in) {
    auto table = std::make_shared<NormalTable>();
    table->nodes.resize(in.count());
    if (table->nodes.empty()) throw BadBytes("a normal form has no node");
    for (NormalTable::Node& node : table->nodes) {
        node.diverges = in.below(2) == 1;
        node.arcs.resize(in.count());
        for (auto& [event, target] : node.arcs) {
            event = in.word();
            target = in.below(table->nodes.size());
        }
        node.acceptances.resize(in.count());
        for (process::EventSet& set : node.acceptances) {
            set.resize(in.count());
            for (process::Event& event : set) event = in.word();
        }
        const bool ordered =
            std::ranges::is_sorted(node.arcs) &&
            std::ranges::all_of(node.acceptances, [](const auto& set) { return std::ranges::is_sorted(set); });
        if (!ordered) throw BadBytes("events are not in order");
    }
    return table;
}

}  // namespace

std::optional<std::string> encode(const lts::TransitionSystem& system, const LevelQuestion& question,
                                  const refine::Limits& limits, unsigned threads) {
    ByteWriter out;
    out.number(version);
    if (!machine::write(system, out)) return std::nullopt;
    out.number(static_cast<std::uint64_t>(question.kind));
    out.number(static_cast<std::uint64_t>(question.model));
    out.number(question.divergence ? 1 : 0);
    out.number(question.events_until);
    if (question.kind == LevelQuestion::Kind::refinement) write(*question.specification, out);
    out.number(limits.max_states);
    out.number(limits.memory_bytes);
    out.number(threads);
    return out.bytes();
}

Job decode(std::string_view bytes, process::TermStore& terms) {
    ByteReader in(bytes);
    if (in.number() != version) throw BadBytes("another version has sent the search");
    Job job;
    job.system = machine::read_system(in, terms);
    job.question.kind = LevelQuestion::Kind{static_cast<std::uint8_t>(in.below(4))};
    job.question.model = refine::Model{static_cast<int>(in.below(3))};
    job.question.divergence = in.below(2) == 1;
    job.question.events_until = in.number();
    if (job.question.kind == LevelQuestion::Kind::refinement) job.question.specification = read_table(in);
    job.max_states = in.number();
    job.memory_bytes = in.number();
    job.threads = in.word();
    if (job.threads == 0) throw BadBytes("a program has no threads");
    in.finish();
    return job;
}

}  // namespace robochart::ranks
