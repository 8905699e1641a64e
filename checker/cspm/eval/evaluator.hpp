// SPDX-License-Identifier: Apache-2.0
// Evaluates code to values. The results are those of FDR's lazy evaluator: an unneeded part of a tuple, sequence or map
// may have no value. Unlike FDR, this evaluator first tries to evaluate such a part at once, with limited work. The
// part stays unevaluated only if this attempt fails (optimistic evaluation: Ennals and Peyton Jones, ICFP 2003).
//
// Every class uses only the classes that this list names before it, except the last three. ValueStore owns the values.
// Work owns the call stack and the step counter. ProcessShape decides which expressions are obviously processes.
// Domains owns the elements of sets, the fields of dotted values and the events. ProcessTerms owns the terms of calls
// and prefixes. BuiltinFunctions computes with evaluated arguments. Evaluator evaluates expressions and calls, and
// matches patterns. ByNeed splits sequences and maps on demand. ProcessEvaluator evaluates processes. The last three
// classes call each other, because parts of a sequence may be unevaluated, a value may be a process, and a process
// contains values.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/cspm/eval/builtin_functions.hpp"
#include "checker/cspm/eval/by_need.hpp"
#include "checker/cspm/eval/code.hpp"
#include "checker/cspm/eval/domains.hpp"
#include "checker/cspm/eval/evaluation_error.hpp"
#include "checker/cspm/eval/process_shape.hpp"
#include "checker/cspm/eval/process_terms.hpp"
#include "checker/cspm/eval/value_text.hpp"
#include "checker/cspm/eval/work.hpp"
#include "checker/cspm/syntax/observed_call.hpp"
#include "checker/cspm/types/builtins.hpp"
#include "checker/process/term.hpp"

namespace robochart::cspm {

class ProcessEvaluator;

/// Evaluates expressions. Delays evaluation only if this can change the result. Has the entry points for a script.
class Evaluator {
public:
    Evaluator(Program& program, ValueStore& store, process::EventTable& events, process::TermStore& terms);
    ~Evaluator();
    Evaluator(const Evaluator&) = delete;
    Evaluator& operator=(const Evaluator&) = delete;

    // Entry points. Only code outside the evaluator may call them.
    /// Sets the budget that evaluations poll. The budget must outlive them.
    void set_budget(diagnostics::Pollable& budget) {
        store_.set_budget(budget);
        work_.set_budget(budget);
    }
    /// See Work::take_stopped.
    [[nodiscard]] std::optional<EvaluationError> take_stopped() { return work_.take_stopped(); }
    /// Sets the observer of calls of some functions. It must be called before anything is evaluated.
    void set_observer(CallObserver observer) { observer_ = std::move(observer); }
    /// Returns the place of the definition that is called by `call` (payload of process::Op::call). Unknown for
    /// built-in functions.
    [[nodiscard]] Span place_of_call(std::uint32_t call) const { return processes_.place_of_call(call); }
    [[nodiscard]] std::string print(const Code& code, const Unit& unit);
    [[nodiscard]] process::TermId process(const Code& code, const Unit& unit);
    [[nodiscard]] process::EventSet event_set(const Code& code, const Unit& unit);
    /// Returns all events of the script's channels. Returns no value if there are more than `most`.
    [[nodiscard]] std::optional<process::EventSet> all_events(std::uint64_t most);
    [[nodiscard]] std::vector<process::Event> trace(const Code& code, const Unit& unit);
    /// Returns `term` with taus prioritised over the events: the meaning of `:[tau priority]`.
    [[nodiscard]] process::TermId tau_priority(process::TermId term, process::EventSet over);

    /// The parts of the evaluator, for code that evaluates processes in another way (checker/cspm/packed).
    struct Parts {
        Program& program;
        ValueStore& store;
        process::TermStore& terms;
        Work& work;
        Domains& domains;
        ProcessTerms& processes;
        ProcessEvaluator& process_evaluator;
    };
    [[nodiscard]] Parts parts() { return {program_, store_, terms_, work_, domains_, processes_, *process_evaluator_}; }

    // The following functions are for ProcessEvaluator (process_evaluator.hpp). A frame contains the values of
    // variables by slot.
    using Frame = Values;
    using Use = std::function<void(Frame&)>;
    Value eval(const Code& code, Frame& frame);
    Value eval_name(const Code& code, Frame& frame);
    Value eval_apply(const Code& code, Frame& frame);
    /// Evaluates the value and replaces the thunk by the result.
    Value evaluate_in_place(Value& value);
    Value evaluated_value(Value value) { return evaluate_in_place(value); }
    /// Returns the sequence that the clauses of a comprehension from index `clause` on generate.
    Value comprehension_from(const Code& code, std::size_t clause, Frame& frame);
    /// Returns the value with all its parts evaluated.
    Value share_value(Value value);
    bool eval_boolean(const Code& code, Frame& frame);
    /// Calls `use` for everything that the clauses from index `from` on generate.
    void for_each(const Code& code, const std::vector<ClauseCode>& clauses, std::size_t from, Frame& frame,
                  const Use& use);
    const GroupObject* open_let(const Code& code, Frame& frame);
    Value call(Value function, Values arguments, Span span);
    /// Returns the clause whose patterns match the arguments. Sets its variables in `frame`.
    const FunctionClause& choose_clause(const Function& function, const Values& environment, Values& arguments,
                                        Frame& frame, Span span);
    bool match_pattern(const MatchCode& pattern, Value& value, Frame& frame);

private:
    // The following functions evaluate expressions (eval.cpp).
    Value eval_operator(const Code& code, Frame& frame);
    Value eval_arithmetic(const Code& code, Frame& frame);
    Value eval_comparison(const Code& code, Frame& frame);
    Value eval_collection(const Code& code, Frame& frame);
    Value eval_productions(const Code& code, Frame& frame);
    Value eval_range(const Code& code, Frame& frame);
    Value eval_map(const Code& code, Frame& frame);
    Value eval_sequence_comprehension(const Code& code, Frame& frame);
    Value eval_concat(const Code& code, Frame& frame);
    Value eval_let(const Code& code, Frame& frame);
    Value eval_lambda(const Code& code, Frame& frame);
    Value delay_argument(const Code& code, Frame& frame);
    Value promise_part(const Code& code, Frame& frame);
    Values eval_all(const Code& code, Frame& frame);
    Values promise_all(const Code& code, Frame& frame);
    std::int64_t eval_number(const Code& code, Frame& frame);
    void generate(const Code& code, const std::vector<ClauseCode>& clauses, std::size_t from, Value source,
                  Frame& frame, const Use& use);

    // The following functions evaluate functions, constants and groups (calls.cpp).
    Value run_function(const Function& function, const Values& environment, Values& arguments, Span span);
    void report_call(const Function& function, const Values& arguments, Value result, Span span);
    void fill_frame(const Unit& unit, const Function& function, const Values& environment, Frame& frame);
    Value member_value(const GroupObject& group, int index, Span span);
    Value member_constant(const GroupObject& group, const Member& member);
    Value global_value(int index, Span span);
    Value global_constant(Global& global);
    Value component_value(const FunctionClause& whole, Value value, int slot, Span span);
    Value constant_body(const Function& function, const Values& environment, Span span);
    bool match_stream(const std::vector<const MatchCode*>& parts, Value value, Frame& frame);
    bool match_sequence(const MatchCode& pattern, Value value, Frame& frame);
    bool match_dot(const MatchCode& pattern, Value value, Frame& frame);

    Program& program_;
    ValueStore& store_;
    process::TermStore& terms_;
    ValueText text_;
    Work work_;
    ProcessShape shape_;
    Domains domains_;
    ProcessTerms processes_;
    BuiltinFunctions builtins_;
    ByNeed by_need_;
    std::unique_ptr<ProcessEvaluator> process_evaluator_;

    CallObserver observer_;
};

}  // namespace robochart::cspm
