// SPDX-License-Identifier: Apache-2.0
// Terms of calls and prefixes, numbered by their keys.
#include "checker/cspm/eval/process_terms.hpp"

#include <algorithm>

namespace robochart::cspm {

using process::Op;
using process::TermId;

TermId ProcessTerms::make(Op op, std::vector<TermId> children, std::uint32_t payload) {
    return terms_.make({op, payload, std::move(children), {}});
}

TermId ProcessTerms::term(Value value, Span span) {
    if (value->kind != Kind::process) work_.fail("expected a process, found " + text_(value), span);
    return static_cast<TermId>(value->number);
}

// The operator over the children; a single child is returned unchanged.
TermId ProcessTerms::many(Op op, std::vector<TermId> children, std::uint32_t payload) {
    return children.size() == 1 ? children[0] : make(op, std::move(children), payload);
}

process::Event ProcessTerms::tock(const TimedSection& timed) {
    return domains_.event(domains_.head_value(timed.tock), {});
}
process::SetId ProcessTerms::tock_set(const TimedSection& timed) {
    return terms_.set({tock(timed)});
}

TermId ProcessTerms::stop(const TimedSection* timed) {
    if (timed == nullptr) return make(Op::stop);
    return prefix(PrefixKind::stopped, {store_.integer(tock(*timed))});
}

TermId ProcessTerms::skip(const TimedSection* timed) {
    if (timed == nullptr) return make(Op::skip);
    const TermId passing = prefix(PrefixKind::skipping, {store_.integer(tock(*timed))});
    return make(Op::external_choice, {passing, make(Op::skip)});
}

TermId ProcessTerms::waiting(process::Event tock, std::int64_t ticks, TermId then) {
    if (ticks <= 0) return then;
    const Value target = store_.make(Kind::process, static_cast<std::int64_t>(then), {});
    return prefix(PrefixKind::waiting, {store_.integer(tock), store_.integer(ticks), target});
}

// Arguments that the definition does not read are ignored: calls that differ only in them are one process.
TermId ProcessTerms::call(Value function, const Values& arguments) {
    Values key{function};
    key.insert(key.end(), arguments.begin(), arguments.end());
    if (const Function* definition = function->function; definition != nullptr)
        for (std::size_t i = 0; i < definition->unread.size(); ++i)
            if (definition->unread[i]) key[i + 1] = store_.character(unread_character);
    const Value tuple = store_.make(Kind::tuple, 1, std::move(key));
    const auto [place, fresh] = call_index_.emplace(tuple, static_cast<std::uint32_t>(calls_.size()));
    if (fresh) calls_.push_back(tuple);
    return make(Op::call, {}, place->second);
}

Span ProcessTerms::place_of_call(std::uint32_t call) const {
    const Function* const definition = calls_[call]->items[0]->function;
    return definition == nullptr ? Span{} : definition->span;
}

TermId ProcessTerms::prefix(PrefixKind kind, Values key) {
    const Value tuple = store_.make(Kind::tuple, static_cast<std::int64_t>(kind), std::move(key));
    auto& index = prefix_index_[static_cast<std::size_t>(kind)];
    const auto [place, fresh] = index.emplace(tuple, static_cast<std::uint32_t>(prefixes_.size()));
    if (fresh) prefixes_.emplace_back(kind, tuple);
    return make(Op::prefix, {}, place->second);
}

TermId ProcessTerms::link(TermId left, TermId right, const std::vector<process::EventPair>& ties, Span span) {
    process::Renaming from_left;
    process::Renaming from_right;
    process::EventSet shared;
    for (const auto& [a, b] : ties) {
        const process::Event event = events_.intern(events_.name(a) + "<->" + events_.name(b));
        from_left.emplace_back(a, event);
        from_right.emplace_back(b, event);
        shared.push_back(event);
    }
    for (process::Renaming* side : {&from_left, &from_right}) {
        std::ranges::sort(*side);
        const auto twice = std::ranges::adjacent_find(*side, {}, &process::EventPair::first);
        if (twice != side->end()) work_.fail("the event " + events_.name(twice->first) + " is linked twice", span);
    }
    const process::SetId set = terms_.set(std::move(shared));
    const TermId a = make(Op::rename, {left}, payload(terms_.renaming(std::move(from_left))));
    const TermId b = make(Op::rename, {right}, payload(terms_.renaming(std::move(from_right))));
    return make(Op::hide, {make(Op::parallel, {a, b}, payload(set))}, payload(set));
}

}  // namespace robochart::cspm
