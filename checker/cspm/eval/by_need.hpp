// SPDX-License-Identifier: Apache-2.0
// Evaluates sequences and maps only as far as needed. Contains streams, comparisons of values, and the built-ins that
// need only parts of their arguments.
#pragma once

#include <optional>
#include <vector>

#include "checker/cspm/eval/builtin_functions.hpp"
#include "checker/cspm/eval/domains.hpp"
#include "checker/cspm/eval/value_text.hpp"
#include "checker/cspm/eval/work.hpp"
#include "checker/cspm/types/builtins.hpp"

namespace robochart::cspm {

class Evaluator;

/// Evaluates sequences and maps by need. Owns the comprehensions that produce the elements of streams. A function that
/// fails calls `Work::fail` with the place that it got as an argument.
class ByNeed {
public:
    /// The first element of a sequence, and the sequence of the remaining elements.
    struct Cut {
        Value head;
        Value tail;
    };
    /// The clauses of a comprehension from index `clause` on.
    struct Comprehension {
        const Code* code;
        std::size_t clause;
    };

    /// The data that this class shares with the evaluator of values.
    struct Tables {
        const Program& program;
        ValueStore& store;
        Work& work;
        Domains& domains;
        BuiltinFunctions& builtins;
    };
    ByNeed(Evaluator& values, const Tables& tables)
        : values_(values),
          store_(tables.store),
          work_(tables.work),
          domains_(tables.domains),
          builtins_(tables.builtins),
          text_(tables.program) {}

    // The following functions are in streams.cpp.
    /// Returns `first ^ rest`, where `rest` may be unevaluated.
    Value append(Value first, Value rest);
    /// Returns a sequence that starts with `first`. The comprehension produces its other elements from the elements of
    /// `source`. `frame` contains the variables of the enclosing scope.
    Value make_stream(Value first, Value source, Comprehension of, const Values& frame);
    /// Splits a sequence after its first element. Returns no value if the sequence is empty.
    std::optional<Cut> split_first(Value sequence, Span span);
    /// Returns the sequence with all its elements stored in `items`.
    Value written_out(Value sequence, Span span);
    /// Returns a finite sequence with all its elements. Returns an infinite sequence as a stream. Only the elements of
    /// this stream may be unevaluated.
    Value share_stream(Value value);
    /// Compares tuples, sequences and maps part by part, up to the first difference.
    bool are_equal(Value a, Value b, Span span);
    /// Compares values by the orders of FDR: numbers and characters by value, sequences by prefix, sets by inclusion,
    /// maps and tuples by their parts.
    bool is_less_or_equal(Value a, Value b, Span span);
    bool is_less(Value a, Value b, Span span);

    // The following functions are in builtins_by_need.cpp.
    /// Calls any built-in. Evaluates its arguments only as far as the built-in needs them.
    Value call(Value builtin, Values arguments, Span span);
    /// Calls a built-in for maps. The keys of maps are always evaluated; their values may be unevaluated.
    Value map_builtin(Builtin which, const Values& arguments, Span span);
    /// Returns all elements of a sequence, evaluated.
    Values sequence(Value value, Span span);
    /// Returns the items k1, v1, k2, v2... of a map.
    const Values& map_items(Value value, Span span);

private:
    bool is_prefix(Value a, Value b, Span span);
    bool contains_element(Value element, Value sequence, Span span);
    Value sequence_builtin(Builtin which, const Values& arguments, Span span);
    Value part_before(Value part, Value rest);

    Evaluator& values_;
    ValueStore& store_;
    Work& work_;
    Domains& domains_;
    BuiltinFunctions& builtins_;
    ValueText text_;
    std::vector<Comprehension> streams_;  // streams refer to these by index
};

}  // namespace robochart::cspm
