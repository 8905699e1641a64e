// SPDX-License-Identifier: Apache-2.0
#include "checker/ranks/job.hpp"

#include <algorithm>
#include <cstdint>

#include "checker/machine/transfer.hpp"

namespace robochart::ranks {

using lts::BadBytes;
using lts::ByteReader;
using lts::ByteWriter;
using refine::LevelQuestion;
using refine::NormalTable;
using refine::RowKeeping;

namespace {

constexpr std::uint64_t version = 4;

void write(std::string_view text, ByteWriter& out) {
    out.write_number(text.size());
    for (const char byte : text) out.write_number(static_cast<unsigned char>(byte));
}

std::string read_text(ByteReader& in) {
    std::string text(in.read_count(), '\0');
    for (char& byte : text) byte = static_cast<char>(in.read_below(256));
    return text;
}

void write(const RowKeeping& rows, ByteWriter& out) {
    write(rows.folder, out);
    write(rows.run, out);
    for (const std::uint8_t byte : rows.search) out.write_number(byte);
    for (const std::uint64_t part :
         {rows.from.number, std::uint64_t{rows.from.ranks}, rows.from.greatest,
          static_cast<std::uint64_t>(rows.every.count()), std::uint64_t{rows.disk ? 1U : 0U}, rows.most_bytes,
          std::uint64_t{rows.filter_bits}, std::uint64_t{rows.reads_a_step}})
        out.write_number(part);
}

std::chrono::milliseconds read_time(ByteReader& in) {
    constexpr std::uint64_t most_milliseconds = std::uint64_t{1} << 42U;  // the clock can represent this duration
    const std::uint64_t time = in.read_number();
    if (time > most_milliseconds) throw BadBytes("a time is too long");
    return std::chrono::milliseconds(time);
}

/// Writes how much time remains, because the clocks of two machines may show different times.
void write_deadline(const refine::Limits& limits, ByteWriter& out) {
    out.write_number(limits.deadline ? 1 : 0);
    if (!limits.deadline) return;
    const auto left = *limits.deadline - std::chrono::steady_clock::now();
    const auto milliseconds = std::chrono::ceil<std::chrono::milliseconds>(left).count();
    out.write_number(static_cast<std::uint64_t>(std::max<std::int64_t>(milliseconds, 0)));
}

RowKeeping read_rows(ByteReader& in) {
    RowKeeping rows;
    rows.folder = read_text(in);
    rows.run = read_text(in);
    for (std::uint8_t& byte : rows.search) byte = static_cast<std::uint8_t>(in.read_below(256));
    rows.from.number = in.read_number();
    rows.from.ranks = in.read_word();
    rows.from.greatest = in.read_number();
    rows.every = read_time(in);
    rows.disk = in.read_below(2) == 1;
    rows.most_bytes = in.read_number();
    rows.filter_bits = in.read_below(33);
    rows.reads_a_step = in.read_word();
    return rows;
}

void write(const NormalTable& table, ByteWriter& out) {
    out.write_number(table.nodes.size());
    for (const NormalTable::Node& node : table.nodes) {
        out.write_number(node.diverges ? 1 : 0);
        out.write_number(node.arcs.size());
        for (const auto& [event, target] : node.arcs) {
            out.write_number(event);
            out.write_number(target);
        }
        out.write_number(node.acceptances.size());
        for (const process::EventSet& set : node.acceptances) {
            out.write_number(set.size());
            for (const process::Event event : set) out.write_number(event);
        }
    }
}

std::shared_ptr<const NormalTable> read_table(ByteReader& in) {
    auto table = std::make_shared<NormalTable>();
    table->nodes.resize(in.read_count());
    if (table->nodes.empty()) throw BadBytes("a normal form has no node");
    for (NormalTable::Node& node : table->nodes) {
        node.diverges = in.read_below(2) == 1;
        node.arcs.resize(in.read_count());
        for (auto& [event, target] : node.arcs) {
            event = in.read_word();
            target = in.read_below(table->nodes.size());
        }
        node.acceptances.resize(in.read_count());
        for (process::EventSet& set : node.acceptances) {
            set.resize(in.read_count());
            for (process::Event& event : set) event = in.read_word();
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
                                  const refine::Limits& limits, unsigned threads, std::string_view program) {
    ByteWriter out;
    write(program, out);
    out.write_number(version);
    if (!machine::write(system, out)) return std::nullopt;
    out.write_number(static_cast<std::uint64_t>(question.kind));
    out.write_number(static_cast<std::uint64_t>(question.model));
    out.write_number(question.divergence ? 1 : 0);
    out.write_number(question.events_until);
    if (question.kind == LevelQuestion::Kind::refinement) write(*question.specification, out);
    write(question.rows, out);
    out.write_number(limits.max_states);
    out.write_number(limits.memory_bytes);
    out.write_number(threads);
    write_deadline(limits, out);
    return out.bytes();
}

std::string sender_of(std::string_view bytes) {
    ByteReader in(bytes);
    return read_text(in);
}

Job decode(std::string_view bytes, process::TermStore& terms) {
    ByteReader in(bytes);
    (void)read_text(in);
    if (in.read_number() != version) throw BadBytes("another version has sent the search");
    Job job;
    job.system = machine::read_system(in, terms);
    job.question.kind = LevelQuestion::Kind{static_cast<std::uint8_t>(in.read_below(4))};
    job.question.model = refine::Model{static_cast<int>(in.read_below(3))};
    job.question.divergence = in.read_below(2) == 1;
    job.question.events_until = in.read_number();
    if (job.question.kind == LevelQuestion::Kind::refinement) job.question.specification = read_table(in);
    job.question.rows = read_rows(in);
    job.max_states = in.read_number();
    job.memory_bytes = in.read_number();
    job.threads = in.read_word();
    if (job.threads == 0) throw BadBytes("a program has no threads");
    if (in.read_below(2) == 1) job.deadline = std::chrono::steady_clock::now() + read_time(in);
    in.expect_end();
    return job;
}

}  // namespace robochart::ranks
