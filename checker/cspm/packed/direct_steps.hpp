// SPDX-License-Identifier: Apache-2.0
// Computes the steps of sequential processes from the bytes of a term, without building terms.
//
// Supports calls, conditions, prefixes, choices, sequential composition, hiding and renaming. Its rules copy those of
// eval/processes.cpp, eval/prefixes.cpp and process/firing_rules.cpp, which define the meaning of processes. For all
// other operators, and after any error, the caller must compute the steps with terms.
#pragma once

#include <array>
#include <deque>
#include <vector>

#include "checker/cspm/eval/evaluator.hpp"
#include "checker/cspm/eval/process_evaluator.hpp"
#include "checker/cspm/packed/term_codec.hpp"

namespace robochart::cspm {

/// The transitions of one term, with the bytes of their target terms.
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
    /// Adds a step. The bytes from `begin` to the end are its target.
    void add(process::Event event, process::Event revealed, std::size_t begin) {
        steps.push_back({event, revealed, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(bytes.size())});
    }
    /// Sorts the steps from index `first` on by event, and removes duplicates. The sort is stable.
    void put_in_order(std::size_t first);

    std::vector<Step> steps;
    Bytes bytes;
};

/// Computes steps. Its buffers are used again for the next call, so most calls allocate no memory.
class DirectSteps {
public:
    DirectSteps(Evaluator& values, TermCodec& codec, PackedParts& parts);

    /// Writes the steps of the term that `row` encodes to `out`, ordered by event. Events have the numbers of the
    /// evaluator. If it returns false, `out` is undefined and the caller must compute the steps with terms.
    [[nodiscard]] bool find(std::span<const std::uint8_t> row, PackedSteps& out);

private:
    using Frame = Values;
    class Borrowed;
    class Nested;

    // The following functions compute steps of encoded terms.
    void steps_of_row(ByteReader& in);
    void row_call(ByteReader& in);
    void row_prefix(ByteReader& in);
    void row_choice(ByteReader& in);
    void row_internal(ByteReader& in);
    void row_sequential(ByteReader& in);
    void row_hide(ByteReader& in);
    void row_rename(ByteReader& in);

    // The following functions compute steps of process expressions.
    void steps_of_process(const Code& code, Frame& frame);
    void steps_of_name(const Code& code, Frame& frame);
    void steps_of_apply(const Code& code, Frame& frame);
    void steps_of_function(const Function& function, const Values& environment, Values& arguments);
    void steps_of_value(Value process);
    void steps_of_internal_choice(const Code& code, Frame& frame);
    void steps_of_external_choice(const Code& code, Frame& frame);
    void steps_of_sequential(const Code& code, Frame& frame);
    void steps_of_hide(const Code& code, Frame& frame);
    void steps_of_prefix(const Code& code, Frame& frame);
    void perform_all_offers(const Code& code, Frame& frame);
    void perform_fields(const Code& code, std::size_t field, Value base, Frame& frame);
    void input_field(const Code& code, std::size_t field, Value base, Frame& frame);
    void input_parts(const Code& code, std::size_t field, std::size_t part, Value base, Frame& frame);

    // The following functions apply an operator to the steps from index `first` on.
    void refuse_taus(std::size_t first) const;
    void append_next_process(std::size_t first, std::span<const std::uint8_t> next);
    void hide_events(std::size_t first, process::SetId set);
    void rename_events(std::size_t first, process::RenamingId renaming);
    std::size_t wrap_target(process::Op op, std::uint32_t part, const PackedSteps::Step& step);

    // The following functions write the bytes of process expressions (direct_bytes.cpp).
    void write_process(const Code& code, Frame& frame);
    void write_name(const Code& code, Frame& frame);
    void write_apply(const Code& code, Frame& frame);
    void write_global_call(const Function& function, const Code& code, Frame& frame);
    void write_prefix(const Code& code, Frame& frame);
    void write_choice(const Code& code, Frame& frame);
    void write_value(Value process);
    void write_made(const Code& code, Frame& frame);

    [[nodiscard]] const Function* global_with(const Code& callee, std::size_t arguments) const;
    [[nodiscard]] Value captured_value(const Frame& frame, int slot);
    [[nodiscard]] Value combine_dot(Value base, Value more, Span span);
    [[nodiscard]] process::Event event_of(Value value, Span span);

    Evaluator& values_;
    Evaluator::Parts tables_;
    TermCodec& codec_;
    PackedParts& parts_;
    PackedSteps* out_ = nullptr;

    std::deque<Frame> frames_;
    std::size_t borrowed_ = 0;
    unsigned nested_ = 0;
    unsigned unanswered_ = 0;  // number of failed calls since the last success; from 32 on, most calls fail at once
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
