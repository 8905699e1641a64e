// SPDX-License-Identifier: Apache-2.0
// Evaluates expressions that denote processes. The term of a call or prefix contains only its name and its values
// (process_terms.hpp). Its body is not evaluated before the search needs its transitions (process/term.hpp,
// Definitions). This makes recursive processes finite terms.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "checker/cspm/eval/evaluator.hpp"

namespace robochart::cspm {

/// Evaluates processes. The evaluator owns the values, and ProcessTerms owns the terms.
class ProcessEvaluator final : public process::Definitions {
public:
    /// The data that this class shares with the evaluator of values.
    struct Tables {
        Program& program;
        ValueStore& store;
        process::TermStore& terms;
        Work& work;
        Domains& domains;
        ProcessTerms& processes;
        ProcessShape& shape;
    };
    ProcessEvaluator(Evaluator& values, const Tables& tables)
        : values_(values),
          program_(tables.program),
          store_(tables.store),
          terms_(tables.terms),
          work_(tables.work),
          domains_(tables.domains),
          processes_(tables.processes),
          shape_(tables.shape),
          text_(tables.program) {
        terms_.define(*this);
    }

    process::TermId process(const Code& code, Values& frame);
    process::SetId set_id(const Code& code, Values& frame);

    process::TermId unfold(std::uint32_t call) override;
    std::vector<process::Branch> branches(std::uint32_t prefix) override;
    [[nodiscard]] std::string describe_call(std::uint32_t call) const override;

private:
    using Frame = Values;

    // The following functions are in processes.cpp.
    process::TermId process_name(const Code& code, Frame& frame);
    process::TermId process_apply(const Code& code, Frame& frame);
    process::TermId process_operator(const Code& code, Frame& frame);
    process::TermId process_replicated(const Code& code, Frame& frame);
    process::TermId process_rename(const Code& code, Frame& frame);
    process::TermId process_linked(const Code& code, Frame& frame);
    process::TermId process_replicated_linked(const Code& code, Frame& frame);
    std::vector<process::EventPair> linked_events(const Code& code, const std::vector<ClauseCode>& clauses,
                                                  Frame& frame);
    void collect_operands(const Code& code, ExprKind kind, Frame& frame, std::vector<process::TermId>& out);
    std::int64_t event_duration(TimedSection& timed, Value event, Span span);

    // The following functions are in prefixes.cpp.
    process::TermId process_prefix(const Code& code, Frame& frame);
    void choose_fields(const Code& code, std::size_t field, Value base, Frame& frame,
                       std::vector<process::TermId>& out);
    void perform_fields(const Code& code, std::size_t field, Value base, Frame& frame,
                        std::vector<process::Branch>& out);
    using Reach = std::function<void(Value)>;
    void input_field(const Code& code, std::size_t field, Value base, Frame& frame, const Reach& reach);
    void input_parts(const Code& code, std::size_t field, std::size_t part, Value base, Frame& frame,
                     const Reach& reach);
    std::vector<process::Branch> script_branches(Value key);
    std::vector<process::Branch> chosen_branches(Value key);
    std::vector<process::Branch> buffer_branches(Value key);

    Evaluator& values_;
    Program& program_;
    ValueStore& store_;
    process::TermStore& terms_;
    Work& work_;
    Domains& domains_;
    ProcessTerms& processes_;
    ProcessShape& shape_;
    ValueText text_;
};

}  // namespace robochart::cspm
