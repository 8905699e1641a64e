// SPDX-License-Identifier: Apache-2.0
// Creates the terms of calls and prefixes. Equal keys give the same term.
#include "checker/cspm/eval/process_terms.hpp"

#include <algorithm>

namespace robochart::cspm {

using process::Op;
using process::TermId;

TermId ProcessTerms::make_term(Op op, std::vector<TermId> children, std::uint32_t payload) {
    return terms_.intern_term({op, payload, std::move(children), {}});
}

TermId ProcessTerms::term_of(Value value, Span span) {
    if (value->kind != Kind::process) work_.fail("expected a process, found " + text_(value), span);
    return static_cast<TermId>(value->number);
}

// Returns the term of the operator with these children. A single child is returned unchanged.
TermId ProcessTerms::make_operator(Op op, std::vector<TermId> children, std::uint32_t payload) {
    return children.size() == 1 ? children[0] : make_term(op, std::move(children), payload);
}

process::Event ProcessTerms::tock_event(const TimedSection& timed) {
    return domains_.event_of(domains_.head_value(timed.tock), {});
}
process::SetId ProcessTerms::tock_set(const TimedSection& timed) {
    return terms_.intern_set({tock_event(timed)});
}

TermId ProcessTerms::make_stop(const TimedSection* timed) {
    if (timed == nullptr) return make_term(Op::stop);
    return make_prefix(PrefixKind::stopped, {store_.integer(tock_event(*timed))});
}

TermId ProcessTerms::make_skip(const TimedSection* timed) {
    if (timed == nullptr) return make_term(Op::skip);
    const TermId passing = make_prefix(PrefixKind::skipping, {store_.integer(tock_event(*timed))});
    return make_term(Op::external_choice, {passing, make_term(Op::skip)});
}

TermId ProcessTerms::make_wait(process::Event tock, std::int64_t ticks, TermId then) {
    if (ticks <= 0) return then;
    const Value target = store_.make(Kind::process, static_cast<std::int64_t>(then), {});
    return make_prefix(PrefixKind::waiting, {store_.integer(tock), store_.integer(ticks), target});
}

// Returns the term of a call. An argument that the definition never reads is replaced by a fixed value. So calls that
// differ only in such arguments are one process.
TermId ProcessTerms::make_call(Value function, const Values& arguments) {
    Values key{function};
    key.insert(key.end(), arguments.begin(), arguments.end());
    if (const Function* definition = function->function; definition != nullptr)
        for (std::size_t i = 0; i < definition->unread.size(); ++i)
            if (definition->unread[i]) key[i + 1] = store_.character(unread_character);
    const Value tuple = store_.make(Kind::tuple, 1, std::move(key));
    const auto [place, fresh] = call_index_.emplace(tuple, static_cast<std::uint32_t>(calls_.size()));
    if (fresh) calls_.push_back(tuple);
    return make_term(Op::call, {}, place->second);
}

Span ProcessTerms::place_of_call(std::uint32_t call) const {
    const Function* const definition = calls_[call]->items[0]->function;
    return definition == nullptr ? Span{} : definition->span;
}

TermId ProcessTerms::make_prefix(PrefixKind kind, Values key) {
    const Value tuple = store_.make(Kind::tuple, static_cast<std::int64_t>(kind), std::move(key));
    auto& index = prefix_index_[static_cast<std::size_t>(kind)];
    const auto [place, fresh] = index.emplace(tuple, static_cast<std::uint32_t>(prefixes_.size()));
    if (fresh) prefixes_.emplace_back(kind, tuple);
    return make_term(Op::prefix, {}, place->second);
}

TermId ProcessTerms::make_linked(TermId left, TermId right, const std::vector<process::EventPair>& ties, Span span) {
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
    const process::SetId set = terms_.intern_set(std::move(shared));
    const TermId a = make_term(Op::rename, {left}, payload(terms_.intern_renaming(std::move(from_left))));
    const TermId b = make_term(Op::rename, {right}, payload(terms_.intern_renaming(std::move(from_right))));
    return make_term(Op::hide, {make_term(Op::parallel, {a, b}, payload(set))}, payload(set));
}

}  // namespace robochart::cspm
