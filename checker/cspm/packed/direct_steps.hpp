// SPDX-License-Identifier: Apache-2.0
// The steps of sequential processes from their bytes to the bytes of what follows, without terms in between.
//
// It knows calls, conditions, prefixes, choices, sequential composition, hiding and renaming, by the same rules as
// eval/processes.cpp, eval/prefixes.cpp and process/firing_rules.cpp, which decide what a process means. Whatever else
// it meets, and every error, it leaves to them: then it has no answer.
#pragma once

#include <array>
#include <deque>
#include <vector>

#include "checker/cspm/eval/evaluator.hpp"
#include "checker/cspm/eval/process_evaluator.hpp"
#include "checker/cspm/packed/term_codec.hpp"

namespace robochart::cspm {

/// The transitions of one term, with the bytes of their targets.
class PackedSteps {
public:
    struct Step {
        process::Event event;
        process::Event revealed;
        std::uint32_t begin, end;
    };
    void clear() {
        steps.clear();
        bytes.clear();
    }
    [[nodiscard]] std::span<const std::uint8_t> target(const Step& step) const {
        return std::span(bytes).subspan(step.begin, step.end - step.begin);
    }
    /// The step's target is what was written from `begin` on.
    void add(process::Event event, process::Event revealed, std::size_t begin) {
        steps.push_back({event, revealed, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(bytes.size())});
    }
    /// From the step `first` on: by event, in the order they are in; of equal ones the first.
    void put_in_order(std::size_t first);

    std::vector<Step> steps;
    Bytes bytes;
};

/// Finds steps; owns only what saves memory from being asked for again.
class DirectSteps {
public:
    DirectSteps(Evaluator& values, TermCodec& codec, PackedParts& parts);

    /// The steps of the term written in `row`, ordered by event; the events are the evaluator's. False: there is no
    /// answer, and what is in `out` means nothing.
    [[nodiscard]] bool find(std::span<const std::uint8_t> row, PackedSteps& out);

private:
    using Frame = Values;
    class Borrowed;
    class Nested;

    // rows
    void row(ByteReader& in);
    void row_call(ByteReader& in);
    void row_prefix(ByteReader& in);
    void row_choice(ByteReader& in);
    void row_internal(ByteReader& in);
    void row_sequential(ByteReader& in);
    void row_hide(ByteReader& in);
    void row_rename(ByteReader& in);

    // processes of the script
    void process(const Code& code, Frame& frame);
    void name(const Code& code, Frame& frame);
    void apply(const Code& code, Frame& frame);
    void enter(const Function& function, const Values& environment, Values& arguments);
    void value(Value process);
    void internal_choice(const Code& code, Frame& frame);
    void external_choice(const Code& code, Frame& frame);
    void sequential(const Code& code, Frame& frame);
    void hide(const Code& code, Frame& frame);
    void prefix(const Code& code, Frame& frame);
    void perform_all(const Code& code, Frame& frame);
    void perform(const Code& code, std::size_t field, Value base, Frame& frame);
    void input(const Code& code, std::size_t field, Value base, Frame& frame);
    void input_parts(const Code& code, std::size_t field, std::size_t part, Value base, Frame& frame);

    // what operators make of their operands' steps, from the step `first` on
    void refuse_taus(std::size_t first) const;
    void followed_by(std::size_t first, std::span<const std::uint8_t> next);
    void hidden(std::size_t first, process::SetId set);
    void renamed(std::size_t first, process::RenamingId renaming);
    std::size_t wrap(process::Op op, std::uint32_t part, const PackedSteps::Step& step);

    // bytes of processes of the script (direct_bytes.cpp)
    void write(const Code& code, Frame& frame);
    void write_name(const Code& code, Frame& frame);
    void write_apply(const Code& code, Frame& frame);
    void write_global_call(const Function& function, const Code& code, Frame& frame);
    void write_prefix(const Code& code, Frame& frame);
    void write_choice(const Code& code, Frame& frame);
    void write_value(Value process);
    void write_made(const Code& code, Frame& frame);

    [[nodiscard]] const Function* global_with(const Code& callee, std::size_t arguments) const;
    [[nodiscard]] Value captured(const Frame& frame, int slot);
    [[nodiscard]] Value combined(Value base, Value more, Span span);
    [[nodiscard]] process::Event event_of(Value value, Span span);

    Evaluator& values_;
    Evaluator::Parts tables_;
    TermCodec& codec_;
    PackedParts& parts_;
    PackedSteps* out_ = nullptr;

    std::deque<Frame> frames_;
    std::size_t borrowed_ = 0;
    unsigned nested_ = 0;
    unsigned unanswered_ = 0;  // rows in succession that had no answer; after some, most are not tried
    unsigned passed_ = 0;
    Value unread_;
    struct Dotted {
        Value base = nullptr;
        Value more = nullptr;
        Value result = nullptr;
    };
    std::array<Dotted, 1024> dotted_{};
    struct Named {
        Value value = nullptr;
        process::Event event = 0;
    };
    std::array<Named, 1024> events_{};
};

}  // namespace robochart::cspm
