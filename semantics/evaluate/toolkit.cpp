// SPDX-License-Identifier: Apache-2.0
// Computes the values of the toolkit functions. Sets and sequences are represented as in evaluate.hpp: sets are
// ascending, and functions and relations are sets of pairs.
#include "semantics/evaluate/toolkit.hpp"

#include <algorithm>
#include <functional>
#include <map>

#include "semantics/evaluate/evaluate_composed.hpp"

namespace robochart::ir {
namespace {

using Values = std::vector<Value>;
using Arguments = const Values&;
using CarrierList = const std::vector<Values>&;

Value truth_of(bool value) {
    return {value ? 1 : 0, {}};
}
Value make_pair_value(const Value& left, const Value& right) {
    return {0, {left, right}};
}
const Value& first_of(const Value& pair) {
    return pair.parts.at(0);
}
const Value& second_of(const Value& pair) {
    return pair.parts.at(1);
}

template <class Predicate>
Value filter_set(const Value& set, const Predicate& keep) {
    Value result;
    std::ranges::copy_if(set.parts, std::back_inserter(result.parts), keep);
    return result;
}
template <class Function>
Value map_set(const Value& set, const Function& function) {
    Values result;
    std::ranges::transform(set.parts, std::back_inserter(result), function);
    return set_of(std::move(result));
}

Value set_union(const Value& a, const Value& b) {
    Values all = a.parts;
    all.insert(all.end(), b.parts.begin(), b.parts.end());
    return set_of(std::move(all));
}
Value set_difference(const Value& a, const Value& b) {
    return filter_set(a, [&](const Value& x) { return !is_part(b, x); });
}
Value domain_of(const Value& relation) {
    return map_set(relation, first_of);
}
Value range_of(const Value& relation) {
    return map_set(relation, second_of);
}
Value identity_relation(const Values& carrier) {
    return map_set({0, carrier}, [](const Value& x) { return make_pair_value(x, x); });
}
Value inverse_relation(const Value& relation) {
    return map_set(relation, [](const Value& p) { return make_pair_value(second_of(p), first_of(p)); });
}
Value compose_relations(const Value& r, const Value& s) {
    Values result;
    for (const Value& p : r.parts)
        for (const Value& q : s.parts)
            if (second_of(p) == first_of(q)) result.push_back(make_pair_value(first_of(p), second_of(q)));
    return set_of(std::move(result));
}
Value transitive_closure(const Value& relation) {
    Value all = relation;
    for (;;) {
        const Value more = set_union(all, compose_relations(all, relation));
        if (more == all) return all;
        all = more;
    }
}
Value iterate_relation(std::int64_t times, const Value& relation, const Values& carrier) {
    if (times < 0) return iterate_relation(-times, inverse_relation(relation), carrier);
    Value result = identity_relation(carrier);
    for (std::int64_t i = 0; i < times; ++i) result = compose_relations(result, relation);
    return result;
}

bool is_injective(const Value& function) {
    return range_of(function).parts.size() == function.parts.size();
}
bool covers_carrier(const Value& set, const Values& carrier) {
    return std::ranges::all_of(carrier, [&](const Value& x) { return is_part(set, x); });
}
Value union_of_all(const Value& sets) {
    Value all;
    for (const Value& set : sets.parts) all = set_union(all, set);
    return all;
}
bool is_disjoint(const Value& family) {
    for (const Value& p : family.parts)
        for (const Value& q : family.parts)
            if (first_of(p) != first_of(q) && set_difference(second_of(p), second_of(q)) != second_of(p)) return false;
    return true;
}

Value slice_of(const Value& sequence, std::size_t from, std::size_t to) {
    return {0, Values(sequence.parts.begin() + static_cast<std::ptrdiff_t>(from),
                      sequence.parts.begin() + static_cast<std::ptrdiff_t>(to))};
}
Value append_sequences(const Value& a, const Value& b) {
    Value result = a;
    result.parts.insert(result.parts.end(), b.parts.begin(), b.parts.end());
    return result;
}
bool occurs_in(const Value& part, const Value& whole, bool at_start, bool at_end) {
    if (part.parts.size() > whole.parts.size()) return false;
    const std::size_t last = whole.parts.size() - part.parts.size();
    for (std::size_t at = at_end ? last : 0; at <= (at_start ? 0 : last); ++at)
        if (slice_of(whole, at, at + part.parts.size()) == part) return true;
    return false;
}
/// Returns the second components of the pairs, in the order of the first components.
Value squash_sequence(const Value& pairs) {
    Value result;
    for (const Value& p : pairs.parts) result.parts.push_back(second_of(p));
    return result;
}

bool is_nonempty(const Value& value) {
    return !value.parts.empty();
}

struct Entry {
    std::function<Value(Arguments, CarrierList)> value;
    std::vector<std::size_t> carriers = {};
    bool needs_nonempty = false;  ///< precondition: the first argument is not empty
};

using Table = std::map<std::string, Entry>;

void add_sets(Table& t) {
    const std::string p = "set_toolkit_";
    t[p + "notin"] = {[](Arguments a, CarrierList) { return truth_of(!is_part(a[1], a[0])); }};
    t[p + "subseteq"] = {[](Arguments a, CarrierList) { return truth_of(!is_nonempty(set_difference(a[0], a[1]))); }};
    t[p + "subset"] = {
        [](Arguments a, CarrierList) { return truth_of(!is_nonempty(set_difference(a[0], a[1])) && a[0] != a[1]); }};
    t[p + "union"] = {[](Arguments a, CarrierList) { return set_union(a[0], a[1]); }};
    t[p + "inter"] = {[](Arguments a, CarrierList) { return set_difference(a[0], set_difference(a[0], a[1])); }};
    t[p + "diff"] = {[](Arguments a, CarrierList) { return set_difference(a[0], a[1]); }};
    t[p + "symetric_diff"] = {
        [](Arguments a, CarrierList) { return set_union(set_difference(a[0], a[1]), set_difference(a[1], a[0])); }};
    t[p + "Union"] = {[](Arguments a, CarrierList) { return union_of_all(a[0]); }};
    t[p + "Inter"] = {[](Arguments a, CarrierList) {
                          return filter_set(first_of(a[0]), [&](const Value& x) {
                              return std::ranges::all_of(a[0].parts, [&](const Value& set) { return is_part(set, x); });
                          });
                      },
                      {},
                      true};
}

void add_relations(Table& t) {
    const std::string p = "relation_toolkit_";
    t[p + "first"] = {[](Arguments a, CarrierList) { return first_of(a[0]); }};
    t[p + "second"] = {[](Arguments a, CarrierList) { return second_of(a[0]); }};
    t[p + "maplet"] = {[](Arguments a, CarrierList) { return make_pair_value(a[0], a[1]); }};
    t[p + "dom"] = {[](Arguments a, CarrierList) { return domain_of(a[0]); }};
    t[p + "ran"] = {[](Arguments a, CarrierList) { return range_of(a[0]); }};
    t[p + "id"] = {[](Arguments, CarrierList c) { return identity_relation(c.at(0)); }, {0}};
    t[p + "relcomp"] = {[](Arguments a, CarrierList) { return compose_relations(a[0], a[1]); }};
    t[p + "funcomp"] = {[](Arguments a, CarrierList) { return compose_relations(a[1], a[0]); }};
    t[p + "dres"] = {[](Arguments a, CarrierList) {
        return filter_set(a[1], [&](const Value& q) { return is_part(a[0], first_of(q)); });
    }};
    t[p + "rres"] = {[](Arguments a, CarrierList) {
        return filter_set(a[0], [&](const Value& q) { return is_part(a[1], second_of(q)); });
    }};
    t[p + "dsub"] = {[](Arguments a, CarrierList) {
        return filter_set(a[1], [&](const Value& q) { return !is_part(a[0], first_of(q)); });
    }};
    t[p + "rsub"] = {[](Arguments a, CarrierList) {
        return filter_set(a[0], [&](const Value& q) { return !is_part(a[1], second_of(q)); });
    }};
    t[p + "rinv"] = {[](Arguments a, CarrierList) { return inverse_relation(a[0]); }};
    t[p + "rimage"] = {[](Arguments a, CarrierList) {
        return range_of(filter_set(a[0], [&](const Value& q) { return is_part(a[1], first_of(q)); }));
    }};
    t[p + "override"] = {[](Arguments a, CarrierList) {
        const Value replaced = domain_of(a[1]);
        return set_union(filter_set(a[0], [&](const Value& q) { return !is_part(replaced, first_of(q)); }), a[1]);
    }};
    t[p + "tr_closure"] = {[](Arguments a, CarrierList) { return transitive_closure(a[0]); }};
    t[p + "refl_tr_closure"] = {[](Arguments a, CarrierList) {
        return set_union(transitive_closure(a[0]), identity_relation(set_union(domain_of(a[0]), range_of(a[0])).parts));
    }};
}

void add_functions(Table& t) {
    const std::string p = "function_toolkit_";
    t[p + "isTotal"] = {[](Arguments a, CarrierList c) { return truth_of(covers_carrier(domain_of(a[0]), c.at(0))); },
                        {0}};
    t[p + "isInjection"] = {[](Arguments a, CarrierList) { return truth_of(is_injective(a[0])); }};
    t[p + "isTotalInjection"] = {[](Arguments a, CarrierList c) {
                                     return truth_of(covers_carrier(domain_of(a[0]), c.at(0)) && is_injective(a[0]));
                                 },
                                 {0}};
    t[p + "isSurjection"] = {
        [](Arguments a, CarrierList c) { return truth_of(covers_carrier(range_of(a[0]), c.at(0))); }, {1}};
    t[p + "isTotalSurjection"] = {
        [](Arguments a, CarrierList c) {
            return truth_of(covers_carrier(domain_of(a[0]), c.at(0)) && covers_carrier(range_of(a[0]), c.at(1)));
        },
        {0, 1}};
    t[p + "isBijection"] = {[](Arguments a, CarrierList c) {
                                return truth_of(covers_carrier(domain_of(a[0]), c.at(0)) &&
                                                covers_carrier(range_of(a[0]), c.at(1)) && is_injective(a[0]));
                            },
                            {0, 1}};
    t[p + "isFinite"] = {[](Arguments, CarrierList) { return truth_of(true); }};
    t[p + "isFiniteFunction"] = t[p + "isFinite"];
    t[p + "isFiniteInjection"] = t[p + "isInjection"];
    t[p + "disjoint"] = {[](Arguments a, CarrierList) { return truth_of(is_disjoint(a[0])); }};
    t[p + "partitions"] = {
        [](Arguments a, CarrierList) { return truth_of(is_disjoint(a[0]) && union_of_all(range_of(a[0])) == a[1]); }};
}

void add_numbers(Table& t) {
    const std::string p = "sequence_toolkit_";
    t[p + "range"] = {[](Arguments a, CarrierList) { return range_set(a[0].number, a[1].number, {}); }};
    t[p + "iter"] = {[](Arguments a, CarrierList c) { return iterate_relation(a[0].number, a[1], c.at(0)); }, {0}};
    t[p + "size"] = {[](Arguments a, CarrierList) { return Value{static_cast<std::int64_t>(a[0].parts.size()), {}}; }};
    t[p + "hasMin"] = {[](Arguments a, CarrierList) { return truth_of(is_nonempty(a[0])); }};
    t[p + "hasMax"] = t[p + "hasMin"];
    t[p + "min"] = {[](Arguments a, CarrierList) { return a[0].parts.front(); }, {}, true};
    t[p + "max"] = {[](Arguments a, CarrierList) { return a[0].parts.back(); }, {}, true};
}

void add_sequences(Table& t) {
    const std::string p = "sequence_toolkit_";
    t[p + "isNonEmpty"] = {[](Arguments a, CarrierList) { return truth_of(is_nonempty(a[0])); }};
    t[p + "isInjectiveSequence"] = {
        [](Arguments a, CarrierList) { return truth_of(set_of(a[0].parts).parts.size() == a[0].parts.size()); }};
    t[p + "concat"] = {[](Arguments a, CarrierList) { return append_sequences(a[0], a[1]); }};
    t[p + "reverse"] = {[](Arguments a, CarrierList) {
        return Value{0, Values(a[0].parts.rbegin(), a[0].parts.rend())};
    }};
    t[p + "head"] = {[](Arguments a, CarrierList) { return a[0].parts.front(); }, {}, true};
    t[p + "last"] = {[](Arguments a, CarrierList) { return a[0].parts.back(); }, {}, true};
    t[p + "tail"] = {[](Arguments a, CarrierList) { return slice_of(a[0], 1, a[0].parts.size()); }, {}, true};
    t[p + "front"] = {[](Arguments a, CarrierList) { return slice_of(a[0], 0, a[0].parts.size() - 1); }, {}, true};
    t[p + "squash"] = {[](Arguments a, CarrierList) { return squash_sequence(a[0]); }};
    t[p + "extract"] = {[](Arguments a, CarrierList) {
        Value result;
        for (const Value& place : a[0].parts)  // ascending
            if (place.number >= 1 && place.number <= static_cast<std::int64_t>(a[1].parts.size()))
                result.parts.push_back(a[1].parts[static_cast<std::size_t>(place.number - 1)]);
        return result;
    }};
    t[p + "filter"] = {
        [](Arguments a, CarrierList) { return filter_set(a[0], [&](const Value& x) { return is_part(a[1], x); }); }};
    t[p + "prefix"] = {[](Arguments a, CarrierList) { return truth_of(occurs_in(a[0], a[1], true, false)); }};
    t[p + "suffix"] = {[](Arguments a, CarrierList) { return truth_of(occurs_in(a[0], a[1], false, true)); }};
    t[p + "infix"] = {[](Arguments a, CarrierList) { return truth_of(occurs_in(a[0], a[1], false, false)); }};
    t[p + "dconcat"] = {[](Arguments a, CarrierList) {
        Value all;
        for (const Value& part : a[0].parts) all = append_sequences(all, part);
        return all;
    }};
}

const Table& toolkit_table() {
    static const Table entries = [] {
        Table t;
        add_sets(t);
        add_relations(t);
        add_functions(t);
        add_numbers(t);
        add_sequences(t);
        return t;
    }();
    return entries;
}

}  // namespace

std::vector<std::size_t> toolkit_carriers(const std::string& function) {
    const auto found = toolkit_table().find(function);
    return found == toolkit_table().end() ? std::vector<std::size_t>{} : found->second.carriers;
}

bool toolkit_precondition(const std::string& function) {
    const auto found = toolkit_table().find(function);
    return found != toolkit_table().end() && found->second.needs_nonempty;
}

Value toolkit_result(const std::string& function, const std::vector<Value>& arguments,
                     const std::vector<std::vector<Value>>& carriers, diagnostics::Span where) {
    const auto found = toolkit_table().find(function);
    if (found == toolkit_table().end()) throw EvaluationFault("the function " + function + " is not known", where);
    if (found->second.needs_nonempty && !is_nonempty(arguments.at(0)))
        throw EvaluationFault("the precondition of " + function + " does not hold", where);
    return found->second.value(arguments, carriers);
}

}  // namespace robochart::ir
