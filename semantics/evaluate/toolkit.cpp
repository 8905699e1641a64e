// SPDX-License-Identifier: Apache-2.0
// Values of the toolkit functions. Sets and sequences are represented as in evaluate.hpp: sets ascending, functions and
// relations as sets of pairs.
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

Value truth(bool value) {
    return {value ? 1 : 0, {}};
}
Value pair(const Value& left, const Value& right) {
    return {0, {left, right}};
}
const Value& first(const Value& pair) {
    return pair.parts.at(0);
}
const Value& second(const Value& pair) {
    return pair.parts.at(1);
}

template <class Predicate>
Value filtered(const Value& set, const Predicate& keep) {
    Value result;
    std::ranges::copy_if(set.parts, std::back_inserter(result.parts), keep);
    return result;
}
template <class Function>
Value image(const Value& set, const Function& function) {
    Values result;
    std::ranges::transform(set.parts, std::back_inserter(result), function);
    return set_of(std::move(result));
}

Value joined(const Value& a, const Value& b) {
    Values all = a.parts;
    all.insert(all.end(), b.parts.begin(), b.parts.end());
    return set_of(std::move(all));
}
Value difference(const Value& a, const Value& b) {
    return filtered(a, [&](const Value& x) { return !is_part(b, x); });
}
Value domain(const Value& relation) {
    return image(relation, first);
}
Value range_of(const Value& relation) {
    return image(relation, second);
}
Value identity(const Values& carrier) {
    return image({0, carrier}, [](const Value& x) { return pair(x, x); });
}
Value inverse(const Value& relation) {
    return image(relation, [](const Value& p) { return pair(second(p), first(p)); });
}
Value composed(const Value& r, const Value& s) {
    Values result;
    for (const Value& p : r.parts)
        for (const Value& q : s.parts)
            if (second(p) == first(q)) result.push_back(pair(first(p), second(q)));
    return set_of(std::move(result));
}
Value closure(const Value& relation) {
    Value all = relation;
    for (;;) {
        const Value more = joined(all, composed(all, relation));
        if (more == all) return all;
        all = more;
    }
}
Value iterated(std::int64_t times, const Value& relation, const Values& carrier) {
    if (times < 0) return iterated(-times, inverse(relation), carrier);
    Value result = identity(carrier);
    for (std::int64_t i = 0; i < times; ++i) result = composed(result, relation);
    return result;
}

bool injective(const Value& function) {
    return range_of(function).parts.size() == function.parts.size();
}
bool covers(const Value& set, const Values& carrier) {
    return std::ranges::all_of(carrier, [&](const Value& x) { return is_part(set, x); });
}
Value united(const Value& sets) {
    Value all;
    for (const Value& set : sets.parts) all = joined(all, set);
    return all;
}
bool disjoint(const Value& family) {
    for (const Value& p : family.parts)
        for (const Value& q : family.parts)
            if (first(p) != first(q) && difference(second(p), second(q)) != second(p)) return false;
    return true;
}

Value slice(const Value& sequence, std::size_t from, std::size_t to) {
    return {0, Values(sequence.parts.begin() + static_cast<std::ptrdiff_t>(from),
                      sequence.parts.begin() + static_cast<std::ptrdiff_t>(to))};
}
Value appended(const Value& a, const Value& b) {
    Value result = a;
    result.parts.insert(result.parts.end(), b.parts.begin(), b.parts.end());
    return result;
}
bool occurs(const Value& part, const Value& whole, bool at_start, bool at_end) {
    if (part.parts.size() > whole.parts.size()) return false;
    const std::size_t last = whole.parts.size() - part.parts.size();
    for (std::size_t at = at_end ? last : 0; at <= (at_start ? 0 : last); ++at)
        if (slice(whole, at, at + part.parts.size()) == part) return true;
    return false;
}
/// The second components of the pairs, in the order of the first ones.
Value squashed(const Value& pairs) {
    Value result;
    for (const Value& p : pairs.parts) result.parts.push_back(second(p));
    return result;
}

bool nonempty(const Value& value) {
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
    t[p + "notin"] = {[](Arguments a, CarrierList) { return truth(!is_part(a[1], a[0])); }};
    t[p + "subseteq"] = {[](Arguments a, CarrierList) { return truth(!nonempty(difference(a[0], a[1]))); }};
    t[p + "subset"] = {
        [](Arguments a, CarrierList) { return truth(!nonempty(difference(a[0], a[1])) && a[0] != a[1]); }};
    t[p + "union"] = {[](Arguments a, CarrierList) { return joined(a[0], a[1]); }};
    t[p + "inter"] = {[](Arguments a, CarrierList) { return difference(a[0], difference(a[0], a[1])); }};
    t[p + "diff"] = {[](Arguments a, CarrierList) { return difference(a[0], a[1]); }};
    t[p + "symetric_diff"] = {
        [](Arguments a, CarrierList) { return joined(difference(a[0], a[1]), difference(a[1], a[0])); }};
    t[p + "Union"] = {[](Arguments a, CarrierList) { return united(a[0]); }};
    t[p + "Inter"] = {[](Arguments a, CarrierList) {
                          return filtered(first(a[0]), [&](const Value& x) {
                              return std::ranges::all_of(a[0].parts, [&](const Value& set) { return is_part(set, x); });
                          });
                      },
                      {},
                      true};
}

void add_relations(Table& t) {
    const std::string p = "relation_toolkit_";
    t[p + "first"] = {[](Arguments a, CarrierList) { return first(a[0]); }};
    t[p + "second"] = {[](Arguments a, CarrierList) { return second(a[0]); }};
    t[p + "maplet"] = {[](Arguments a, CarrierList) { return pair(a[0], a[1]); }};
    t[p + "dom"] = {[](Arguments a, CarrierList) { return domain(a[0]); }};
    t[p + "ran"] = {[](Arguments a, CarrierList) { return range_of(a[0]); }};
    t[p + "id"] = {[](Arguments, CarrierList c) { return identity(c.at(0)); }, {0}};
    t[p + "relcomp"] = {[](Arguments a, CarrierList) { return composed(a[0], a[1]); }};
    t[p + "funcomp"] = {[](Arguments a, CarrierList) { return composed(a[1], a[0]); }};
    t[p + "dres"] = {[](Arguments a, CarrierList) {
        return filtered(a[1], [&](const Value& q) { return is_part(a[0], first(q)); });
    }};
    t[p + "rres"] = {[](Arguments a, CarrierList) {
        return filtered(a[0], [&](const Value& q) { return is_part(a[1], second(q)); });
    }};
    t[p + "dsub"] = {[](Arguments a, CarrierList) {
        return filtered(a[1], [&](const Value& q) { return !is_part(a[0], first(q)); });
    }};
    t[p + "rsub"] = {[](Arguments a, CarrierList) {
        return filtered(a[0], [&](const Value& q) { return !is_part(a[1], second(q)); });
    }};
    t[p + "rinv"] = {[](Arguments a, CarrierList) { return inverse(a[0]); }};
    t[p + "rimage"] = {[](Arguments a, CarrierList) {
        return range_of(filtered(a[0], [&](const Value& q) { return is_part(a[1], first(q)); }));
    }};
    t[p + "override"] = {[](Arguments a, CarrierList) {
        const Value replaced = domain(a[1]);
        return joined(filtered(a[0], [&](const Value& q) { return !is_part(replaced, first(q)); }), a[1]);
    }};
    t[p + "tr_closure"] = {[](Arguments a, CarrierList) { return closure(a[0]); }};
    t[p + "refl_tr_closure"] = {[](Arguments a, CarrierList) {
        return joined(closure(a[0]), identity(joined(domain(a[0]), range_of(a[0])).parts));
    }};
}

void add_functions(Table& t) {
    const std::string p = "function_toolkit_";
    t[p + "isTotal"] = {[](Arguments a, CarrierList c) { return truth(covers(domain(a[0]), c.at(0))); }, {0}};
    t[p + "isInjection"] = {[](Arguments a, CarrierList) { return truth(injective(a[0])); }};
    t[p + "isTotalInjection"] = {
        [](Arguments a, CarrierList c) { return truth(covers(domain(a[0]), c.at(0)) && injective(a[0])); }, {0}};
    t[p + "isSurjection"] = {[](Arguments a, CarrierList c) { return truth(covers(range_of(a[0]), c.at(0))); }, {1}};
    t[p + "isTotalSurjection"] = {[](Arguments a, CarrierList c) {
                                      return truth(covers(domain(a[0]), c.at(0)) && covers(range_of(a[0]), c.at(1)));
                                  },
                                  {0, 1}};
    t[p + "isBijection"] = {
        [](Arguments a, CarrierList c) {
            return truth(covers(domain(a[0]), c.at(0)) && covers(range_of(a[0]), c.at(1)) && injective(a[0]));
        },
        {0, 1}};
    t[p + "isFinite"] = {[](Arguments, CarrierList) { return truth(true); }};
    t[p + "isFiniteFunction"] = t[p + "isFinite"];
    t[p + "isFiniteInjection"] = t[p + "isInjection"];
    t[p + "disjoint"] = {[](Arguments a, CarrierList) { return truth(disjoint(a[0])); }};
    t[p + "partitions"] = {
        [](Arguments a, CarrierList) { return truth(disjoint(a[0]) && united(range_of(a[0])) == a[1]); }};
}

void add_numbers(Table& t) {
    const std::string p = "sequence_toolkit_";
    t[p + "range"] = {[](Arguments a, CarrierList) { return range_set(a[0].number, a[1].number, {}); }};
    t[p + "iter"] = {[](Arguments a, CarrierList c) { return iterated(a[0].number, a[1], c.at(0)); }, {0}};
    t[p + "size"] = {[](Arguments a, CarrierList) { return Value{static_cast<std::int64_t>(a[0].parts.size()), {}}; }};
    t[p + "hasMin"] = {[](Arguments a, CarrierList) { return truth(nonempty(a[0])); }};
    t[p + "hasMax"] = t[p + "hasMin"];
    t[p + "min"] = {[](Arguments a, CarrierList) { return a[0].parts.front(); }, {}, true};
    t[p + "max"] = {[](Arguments a, CarrierList) { return a[0].parts.back(); }, {}, true};
}

void add_sequences(Table& t) {
    const std::string p = "sequence_toolkit_";
    t[p + "isNonEmpty"] = {[](Arguments a, CarrierList) { return truth(nonempty(a[0])); }};
    t[p + "isInjectiveSequence"] = {
        [](Arguments a, CarrierList) { return truth(set_of(a[0].parts).parts.size() == a[0].parts.size()); }};
    t[p + "concat"] = {[](Arguments a, CarrierList) { return appended(a[0], a[1]); }};
    t[p + "reverse"] = {[](Arguments a, CarrierList) {
        return Value{0, Values(a[0].parts.rbegin(), a[0].parts.rend())};
    }};
    t[p + "head"] = {[](Arguments a, CarrierList) { return a[0].parts.front(); }, {}, true};
    t[p + "last"] = {[](Arguments a, CarrierList) { return a[0].parts.back(); }, {}, true};
    t[p + "tail"] = {[](Arguments a, CarrierList) { return slice(a[0], 1, a[0].parts.size()); }, {}, true};
    t[p + "front"] = {[](Arguments a, CarrierList) { return slice(a[0], 0, a[0].parts.size() - 1); }, {}, true};
    t[p + "squash"] = {[](Arguments a, CarrierList) { return squashed(a[0]); }};
    t[p + "extract"] = {[](Arguments a, CarrierList) {
        return squashed(filtered(pairs_of(a[1]), [&](const Value& q) { return is_part(a[0], first(q)); }));
    }};
    t[p + "filter"] = {
        [](Arguments a, CarrierList) { return filtered(a[0], [&](const Value& x) { return is_part(a[1], x); }); }};
    t[p + "prefix"] = {[](Arguments a, CarrierList) { return truth(occurs(a[0], a[1], true, false)); }};
    t[p + "suffix"] = {[](Arguments a, CarrierList) { return truth(occurs(a[0], a[1], false, true)); }};
    t[p + "infix"] = {[](Arguments a, CarrierList) { return truth(occurs(a[0], a[1], false, false)); }};
    t[p + "dconcat"] = {[](Arguments a, CarrierList) {
        Value all;
        for (const Value& part : a[0].parts) all = appended(all, part);
        return all;
    }};
}

const Table& table() {
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
    const auto found = table().find(function);
    return found == table().end() ? std::vector<std::size_t>{} : found->second.carriers;
}

bool toolkit_precondition(const std::string& function) {
    const auto found = table().find(function);
    return found != table().end() && found->second.needs_nonempty;
}

Value toolkit_result(const std::string& function, const std::vector<Value>& arguments,
                     const std::vector<std::vector<Value>>& carriers, diagnostics::Span where) {
    const auto found = table().find(function);
    if (found == table().end()) throw EvaluationFault("the function " + function + " is not known", where);
    if (found->second.needs_nonempty && !nonempty(arguments.at(0)))
        throw EvaluationFault("the precondition of " + function + " does not hold", where);
    return found->second.value(arguments, carriers);
}

}  // namespace robochart::ir
