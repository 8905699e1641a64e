// Evaluates code to values and processes. Processes are built lazily: a call becomes a term named by its
// function and arguments, a prefix one named by its place in the script and the values it uses; both are
// looked into only when the search asks (process/term.hpp, Definitions).
//
// Values are what FDR's lazy evaluator makes of them: parts of tuples, sequences and maps that nobody asks for need not
// have a value. They are evaluated at once all the same, within a bound of work, and wait only where that fails
// (optimistic evaluation: Ennals and Peyton Jones, ICFP 2003).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "checker/cspm/eval/code.hpp"
#include "checker/cspm/eval/evaluation_error.hpp"
#include "checker/cspm/syntax/observed_call.hpp"
#include "checker/process/term.hpp"

namespace robochart::cspm {

class Evaluator final : public process::Definitions {
public:
    /// Elements of one set made explicit, at most.
    static constexpr std::size_t max_elements = 5'000'000;
    /// Steps between two questions of the search, at most.
    static constexpr std::uint64_t max_steps = 2'000'000'000;

    Evaluator(Program& program, ValueStore& store, process::EventTable& events, process::TermStore& terms);

    // Entry points; each may be called from outside only.
    /// Called now and then while values are worked out; may throw to stop that. Empty: none.
    void watch(std::function<void()> poll) {
        store_.watch(poll);
        poll_ = std::move(poll);
    }
    /// The observer of calls of some functions; set before anything is evaluated.
    void observe(CallObserver observer) { observer_ = std::move(observer); }
    [[nodiscard]] std::string print(const Code& code, const Unit& unit);
    [[nodiscard]] process::TermId process(const Code& code, const Unit& unit);
    [[nodiscard]] process::EventSet event_set(const Code& code, const Unit& unit);
    [[nodiscard]] std::vector<process::Event> trace(const Code& code, const Unit& unit);
    /// `term` with the events ranked as `:[tau priority]` has it.
    [[nodiscard]] process::TermId tau_priority(process::TermId term, process::EventSet over);

    process::TermId unfold(std::uint32_t call) override;
    std::vector<process::Branch> branches(std::uint32_t prefix) override;
    [[nodiscard]] std::string describe_call(std::uint32_t call) const override;

private:
    using Frame = Values;
    using Use = std::function<void(Frame&)>;
    struct Activation {
        const Function* function = nullptr;
        const Values* arguments = nullptr;
        Span called;  ///< where, if known: in generated scripts a place of the model
    };
    class Entry;
    class Calling;
    class Speculation;

    // eval.cpp: expressions
    Value eval(const Code& code, Frame& frame);
    Value eval_name(const Code& code, Frame& frame);
    Value eval_operator(const Code& code, Frame& frame);
    Value eval_arithmetic(const Code& code, Frame& frame);
    Value eval_comparison(const Code& code, Frame& frame);
    Value eval_collection(const Code& code, Frame& frame);
    Value eval_productions(const Code& code, Frame& frame);
    Value eval_range(const Code& code, Frame& frame);
    Value eval_range_of(const Code& code, Frame& frame);
    Value eval_map(const Code& code, Frame& frame);
    Value eval_sequence_comprehension(const Code& code, Frame& frame);
    Value eval_concat(const Code& code, Frame& frame);
    Value eval_let(const Code& code, Frame& frame);
    Value eval_lambda(const Code& code, Frame& frame);
    Value eval_apply(const Code& code, Frame& frame);
    Value force(Value& value);
    Value forced(Value value) { return force(value); }
    Value delay(const Code& code, Frame& frame);
    Value promise(const Code& code, Frame& frame);
    Value share(Value value);
    Values eval_all(const Code& code, Frame& frame);
    Values promise_all(const Code& code, Frame& frame);
    bool truth(const Code& code, Frame& frame);
    std::int64_t number(const Code& code, Frame& frame);
    void generate(const Code& code, const std::vector<ClauseCode>& clauses, std::size_t from, Value source,
                  Frame& frame, const Use& use);
    void for_each(const Code& code, const std::vector<ClauseCode>& clauses, std::size_t from, Frame& frame,
                  const Use& use);
    const GroupObject* open_let(const Code& code, Frame& frame);
    void count_step(Span span);

    // calls.cpp: functions, constants, groups
    Value call(Value function, Values arguments, Span span);
    Value run(const Function& function, const Values& environment, Values& arguments, Span span);
    void tell(const Function& function, const Values& arguments, Value result, Span span);
    const FunctionClause& choose(const Function& function, const Values& environment, Values& arguments, Frame& frame,
                                 Span span);
    void install(const Unit& unit, const Function& function, const Values& environment, Frame& frame);
    Value member(const GroupObject& group, int index, Span span);
    Value member_constant(const GroupObject& group, const Member& member);
    Value global(int index, Span span);
    Value global_constant(Global& global);
    Value component(const FunctionClause& whole, Value value, int slot, Span span);
    Value constant_body(const Function& function, const Values& environment, Span span);
    Value datatype_set(const Global& global);
    Value subtype_set(const Global& global);
    bool match(const MatchCode& pattern, Value& value, Frame& frame);
    bool match_stream(const std::vector<const MatchCode*>& parts, Value value, Frame& frame);
    bool match_sequence(const MatchCode& pattern, Value value, Frame& frame);
    bool match_dot(const MatchCode& pattern, Value value, Frame& frame);

    // process_shape.cpp
    bool makes_process(const Function& function);
    bool makes_process(const Code& code);
    bool makes_process(const Code& name, std::size_t groups);

    // sets.cpp
    const Values& elements(Value set, Span span);
    bool member_of(Value value, Value set, Span span);
    Value set_union(Value a, Value b, Span span);
    Value set_inter(Value a, Value b, Span span);
    Value set_diff(Value a, Value b, Span span);
    bool subset(Value a, Value b, Span span);
    bool same(Value a, Value b, Span span);
    bool equal_by_need(Value a, Value b, Span span);
    bool less_equal(Value a, Value b, Span span);
    Value explicit_set(Value set, Span span);
    /// How many elements; largest_size if more; none if there is no end of them.
    std::optional<std::uint64_t> size_of(Value set, Span span);
    bool has_size(Value set, std::size_t size);
    bool can_be_listed(Value set, Span span);
    Value united(const Values& sets, Span span);
    Value without_listed(std::int64_t from, const Values& taken, Span span);
    Value union_of_all(const Values& sets, Span span);
    Value subsets(Value set, Span span);
    Value maps(Value keys, Value values, Span span);
    static constexpr std::uint64_t largest_size = std::uint64_t{1} << 63U;
    static bool is_set(Value value);

    // streams.cpp
    struct Cut {
        Value head;
        Value tail;
    };
    /// Generators of a comprehension from one on.
    struct Comprehension {
        const Code* code;
        std::size_t clause;
    };
    static bool is_stream(Value sequence);
    static bool is_infinite(Value sequence);
    Value append(Value first, Value rest);
    Value stream(Value first, Value source, Comprehension of, const Frame& frame);
    Value comprehension_from(const Code& code, std::size_t clause, Frame& frame);
    /// The first element of a sequence and the sequence of the others; none if it has none.
    std::optional<Cut> next(Value sequence, Span span);
    /// The sequence with all its elements in `items`.
    Value written_out(Value sequence, Span span);
    Value share_stream(Value value);
    bool element_by_need(Value element, Value sequence, Span span);

    // dots.cpp
    Value head_value(int head);
    const Values& fields_of(int head);
    Values type_fields(Value type, Span span);
    Values rectangle(Value set, Span span);
    Value type_set(Value type, Span span);
    Value combine(Value base, Value more, Span span);
    Value add_field(Value base, Value field, Span span);
    bool complete(Value value);
    void check_field(Value field, Value allowed, Value whole, Span span);
    bool missing(Value whole, Value part, Values& out);
    Values missing_fields(Value value);
    Value extensions(Value value);
    Value one_field_extensions(Value value);
    Value productions(Value value);
    Value product_of(const Values& sets, Kind kind, Span span);
    Value all_events();
    process::Event event(Value value, Span span);
    const process::EventSet& event_set(Value set, Span span);

    // builtin_functions.cpp
    Value call_builtin(Value builtin, Values arguments, Span span);
    Value set_builtin(Builtin which, const Values& arguments, Span span);
    Value sequence_builtin(Builtin which, const Values& arguments, Span span);
    Value part_before(Value part, Value rest);
    Value map_builtin(Builtin which, const Values& arguments, Span span);
    Value process_builtin(Builtin which, Value builtin, const Values& arguments, Span span);
    process::RenamingId partial_order(const Values& arguments, Span span);
    process::TermId buffer(const Values& arguments, Span span);
    Value representatives(Value relation, Value set, Span span);
    Value relation_builtin(Builtin which, const Values& arguments, Span span);
    Value builtin_value(Builtin which, const TimedSection* timed);
    Values sequence(Value value, Span span);
    const Values& map_items(Value value, Span span);

    // processes.cpp
    process::TermId process(const Code& code, Frame& frame);
    process::TermId process_name(const Code& code, Frame& frame);
    process::TermId process_apply(const Code& code, Frame& frame);
    process::TermId process_operator(const Code& code, Frame& frame);
    process::TermId process_replicated(const Code& code, Frame& frame);
    process::TermId process_rename(const Code& code, Frame& frame);
    process::TermId process_linked(const Code& code, Frame& frame);
    process::TermId process_replicated_linked(const Code& code, Frame& frame);
    process::TermId link(process::TermId left, process::TermId right, const std::vector<process::EventPair>& ties,
                         Span span);
    std::vector<process::EventPair> ties(const Code& code, const std::vector<ClauseCode>& clauses, Frame& frame);
    void collect(const Code& code, ExprKind kind, Frame& frame, std::vector<process::TermId>& out);
    process::TermId term(Value value, Span span);
    process::TermId many(process::Op op, std::vector<process::TermId> children, std::uint32_t payload = 0);
    process::TermId call_term(Value function, const Values& arguments);
    process::SetId set_id(const Code& code, Frame& frame);
    process::SetId tock_set(const TimedSection& timed);
    process::Event tock(const TimedSection& timed);
    process::TermId stop(const TimedSection* timed);
    process::TermId skip(const TimedSection* timed);
    process::TermId waiting(process::Event tock, std::int64_t ticks, process::TermId then);
    std::int64_t duration(TimedSection& timed, Value event, Span span);
    process::TermId make(process::Op op, std::vector<process::TermId> children = {}, std::uint32_t payload = 0);

    // prefixes.cpp
    enum class PrefixKind : std::uint8_t { script = 2, chosen = 3, waiting = 4, stopped = 5, skipping = 6, buffer = 7 };
    process::TermId prefix(const Code& code, Frame& frame);
    process::TermId prefix_term(PrefixKind kind, Values key);
    void choose_fields(const Code& code, std::size_t field, Value base, Frame& frame,
                       std::vector<process::TermId>& out);
    void perform(const Code& code, std::size_t field, Value base, Frame& frame, std::vector<process::Branch>& out);
    using Reach = std::function<void(Value)>;
    void input(const Code& code, std::size_t field, Value base, Frame& frame, const Reach& reach);
    void input_parts(const Code& code, std::size_t field, std::size_t part, Value base, Frame& frame,
                     const Reach& reach);
    std::vector<process::Branch> script_branches(Value key);
    std::vector<process::Branch> chosen_branches(Value key);
    std::vector<process::Branch> buffer_branches(Value key);

    // print.cpp
    [[nodiscard]] std::string text(Value value) const;
    void print_items(const Values& items, const char* open, const char* separator, const char* close,
                     std::string& out) const;
    void print(Value value, std::string& out) const;

    [[noreturn]] void fail(const std::string& message, Span span) const;
    [[noreturn]] void not_supported(const std::string& what, Span span) const;

    static constexpr std::uint64_t no_end = ~std::uint64_t{0};

    Program& program_;
    ValueStore& store_;
    process::EventTable& events_;
    process::TermStore& terms_;

    std::vector<Comprehension> streams_;  // those that sequences come from which are not written out
    Span prefix_place_;  // of the prefix whose events are asked for: a fault's place where there is no nearer one
    std::vector<Value> calls_;  // tuples: function, arguments...
    std::unordered_map<Value, std::uint32_t> call_index_;
    std::vector<std::pair<PrefixKind, Value>> prefixes_;
    std::unordered_map<Value, std::uint32_t> prefix_index_[8];
    std::unordered_map<Value, process::Event> event_index_;
    std::unordered_map<Value, process::EventSet> event_sets_;
    std::unordered_map<Value, Value> explicit_;
    std::unordered_map<Value, Value> extensions_;
    std::unordered_map<Value, Value> one_field_extensions_;
    std::unordered_map<Value, Value> productions_;
    Value all_events_ = nullptr;
    Value chars_ = nullptr;

    std::vector<Activation> activations_;
    const char* stack_base_ = nullptr;
    std::uint64_t steps_ = 0;
    std::uint64_t promised_until_ = no_end;  // steps at which no more values are asked for early...
    std::uint64_t given_up_at_ = no_end;     // ...and at which those under way are given up
    std::uint64_t entry_number_ = 0;
    std::function<void()> poll_;
    CallObserver observer_;
    unsigned entries_ = 0;
    unsigned shapes_ = 0;
};

}  // namespace robochart::cspm
