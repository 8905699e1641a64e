// SPDX-License-Identifier: Apache-2.0
// Computes with sets of values and with dotted values. Dotted values are channels and constructors with their fields,
// their extensions, and events.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "checker/cspm/eval/code.hpp"
#include "checker/cspm/eval/work.hpp"
#include "checker/process/term.hpp"

namespace robochart::cspm {

/// Computes with evaluated values. The types in declarations are an exception: it evaluates them on first use. Caches
/// the elements of sets, extensions, productions and events.
class Domains {
public:
    /// A function that evaluates a type expression of a declaration.
    using Evaluate = std::function<Value(const Code&, const Unit&)>;
    static constexpr std::uint64_t largest_size = std::uint64_t{1} << 63U;

    Domains(Program& program, ValueStore& store, process::EventTable& events, Work& work, Evaluate evaluate)
        : program_(program),
          store_(store),
          events_(events),
          work_(work),
          text_(program),
          evaluate_(std::move(evaluate)) {}

    // The following functions are in sets.cpp.
    const Values& elements(Value set, Span span);
    bool member_of(Value value, Value set, Span span);
    Value set_union(Value a, Value b, Span span);
    Value set_inter(Value a, Value b, Span span);
    Value set_diff(Value a, Value b, Span span);
    bool is_subset(Value a, Value b, Span span);
    /// Compares sets with different representations.
    bool are_equal_sets(Value a, Value b, Span span);
    Value explicit_set(Value set, Span span);
    /// Returns the number of elements, at most largest_size. Returns no value if the set is infinite.
    std::optional<std::uint64_t> size_of(Value set, Span span);
    bool has_size(Value set, std::size_t size);
    bool can_be_listed(Value set, Span span);
    Value union_of_all(const Values& sets, Span span);

    // The following functions are in dots.cpp.
    Value head_value(int head);
    /// Returns the set that a type expression denotes.
    Value type_set(Value type, Span span);
    /// Returns base.more: appends the fields of `more` to `base`, which lacks them.
    Value append_fields(Value base, Value more, Span span);
    /// Appends to `out` the fields that `whole` has after those of `part`; the rest of a nested field comes first.
    /// Returns false if `whole` does not begin with `part`.
    bool append_fields_after(Value whole, Value part, Values& out);
    Value extensions(Value value);
    Value one_field_extensions(Value value);
    Value productions(Value value);
    Value product_of(const Values& sets, Kind kind, Span span);
    Value subtype_set(const Global& global);
    /// Returns the number of events of all channels, or largest_size if there are more or infinitely many.
    std::uint64_t number_of_events();
    Value all_events();
    process::Event event_of(Value value, Span span);
    const process::EventSet& event_set(Value set, Span span);

private:
    Value make_union(const Values& sets, Span span);
    Value without_listed(std::int64_t from, const Values& taken, Span span);
    Value list_subsets(Value set, Span span);
    Value list_maps(Value keys, Value values, Span span);
    const Values& fields_of(int head);
    Values type_fields(Value type, Span span);
    Values rectangle(Value set, Span span);
    Value add_field(Value base, Value field, Span span);
    bool is_complete(Value value);
    void check_field(Value field, Value allowed, Value whole, Span span);
    Values missing_fields(Value value);
    Value datatype_set(const Global& global);

    Program& program_;
    ValueStore& store_;
    process::EventTable& events_;
    Work& work_;
    ValueText text_;
    Evaluate evaluate_;
    std::vector<Value> head_values_;  ///< by head
    std::unordered_map<Value, process::Event> event_index_;
    std::unordered_map<process::Event, Value> event_values_;  ///< values of events, found by name
    std::unordered_map<Value, process::EventSet> event_sets_;
    std::unordered_map<Value, Value> explicit_;
    std::unordered_map<Value, Value> extensions_;
    std::unordered_map<Value, Value> one_field_extensions_;
    std::unordered_map<Value, Value> productions_;
    Value all_events_ = nullptr;
};

}  // namespace robochart::cspm
