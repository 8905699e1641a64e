// SPDX-License-Identifier: Apache-2.0
// Encodes findings as a sequence of 64-bit numbers. The length of each list comes before the list.
#include "checker/refine/verdict/findings.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

namespace robochart::refine {

namespace {

using process::Event;
using process::EventSet;

class Encoder {
public:
    explicit Encoder(const EventSet& named) : named_(named) {}

    void write_number(std::uint64_t value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }
    void event(Event event) {
        const auto place = std::ranges::lower_bound(named_, event);
        if (place == named_.end() || *place != event) throw std::logic_error("a finding with an event without a name");
        write_number(static_cast<std::uint64_t>(place - named_.begin()));
    }
    void state(const std::vector<lts::Word>& words) {
        for (const lts::Word word : words) write_number(word);
    }
    void run(const Run& run) {
        write_number(run.initial.empty() ? 0 : 1);
        state(run.initial);
        write_number(run.steps.size());
        for (const RunStep& step : run.steps) {
            event(step.event);
            event(step.revealed);
            state(step.state);
        }
    }
    [[nodiscard]] std::string take_bytes() { return std::move(bytes_); }

private:
    const EventSet& named_;
    std::string bytes_;
};

/// Thrown if the bytes are malformed.
struct Damaged {};

class Decoder {
public:
    Decoder(std::string_view bytes, const EventSet& named, std::size_t width)
        : bytes_(bytes), named_(named), width_(width) {}

    std::uint64_t read_number() {
        std::uint64_t value = 0;
        if (bytes_.size() < sizeof value) throw Damaged();
        std::memcpy(&value, bytes_.data(), sizeof value);
        bytes_.remove_prefix(sizeof value);
        return value;
    }
    std::uint64_t number_below(std::uint64_t end) {
        const std::uint64_t value = read_number();
        if (value >= end) throw Damaged();
        return value;
    }
    Event event() { return named_[number_below(named_.size())]; }
    std::vector<lts::Word> state() {
        std::vector<lts::Word> words(width_);
        for (lts::Word& word : words) word = static_cast<lts::Word>(number_below(std::uint64_t{1} << 32U));
        return words;
    }
    Run run() {
        Run result;
        if (number_below(2) == 1) result.initial = state();
        const std::uint64_t steps = number_below(bytes_.size());
        for (std::uint64_t i = 0; i < steps; ++i) {
            const Event happens = event();
            const Event revealed = event();
            result.steps.push_back({happens, revealed, state()});
        }
        return result;
    }
    void expect_end() const {
        if (!bytes_.empty()) throw Damaged();
    }

private:
    std::string_view bytes_;
    const EventSet& named_;
    std::size_t width_;
};

}  // namespace

std::string encode(const Findings& findings, const EventSet& named) {
    Encoder out(named);
    const Statistics& size = findings.statistics;
    out.write_number(static_cast<std::uint64_t>(size.decided_by));
    for (const std::uint64_t value :
         {size.states, size.transitions, size.depth, size.spec_nodes, size.chased, size.replicas, size.distinguished,
          size.diagram_nodes, std::bit_cast<std::uint64_t>(size.log10_states)})
        out.write_number(value);
    out.write_number(findings.violation ? 1 : 0);
    if (const auto& violation = findings.violation) {
        out.write_number(static_cast<std::uint64_t>(violation->kind));
        out.run(violation->run);
        out.run(violation->loop);
        out.write_number(violation->event ? 1 : 0);
        if (violation->event) out.event(*violation->event);
    }
    return out.take_bytes();
}

std::optional<Findings> decode(std::string_view bytes, const EventSet& named, std::size_t width) {
    Decoder in(bytes, named, width);
    try {
        Findings findings;
        Statistics& size = findings.statistics;
        constexpr auto ways = static_cast<std::uint64_t>(DecidedBy::diagrams) + 1;
        size.decided_by = static_cast<DecidedBy>(in.number_below(ways));
        for (std::uint64_t* value : {&size.states, &size.transitions, &size.depth, &size.spec_nodes, &size.chased,
                                     &size.replicas, &size.distinguished})
            *value = in.read_number();
        size.diagram_nodes = in.read_number();
        size.log10_states = std::bit_cast<double>(in.read_number());
        if (in.number_below(2) == 1) {
            Violation violation;
            constexpr auto kinds = static_cast<std::uint64_t>(ViolationKind::no_trace) + 1;
            violation.kind = static_cast<ViolationKind>(in.number_below(kinds));
            violation.run = in.run();
            violation.loop = in.run();
            if (in.number_below(2) == 1) violation.event = in.event();
            findings.violation = std::move(violation);
        }
        in.expect_end();
        return findings;
    } catch (const Damaged&) {
        return std::nullopt;
    }
}

}  // namespace robochart::refine
