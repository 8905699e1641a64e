// SPDX-License-Identifier: Apache-2.0
#include "translate.hpp"

#include "checker/process/priority_order.hpp"

namespace robochart::refine {

using naive::Kind;
using naive::Letter;
using process::Op;
using process::TermId;

Translation::Translation(const naive::Script& script, bool compressing)
    : semantics_(scripted_.store, compressing ? &compressor_ : nullptr) {
    for (Letter l = 0; l < 6; ++l) event(l);
    for (std::size_t i = 0; i < script.definitions.size(); ++i)
        names_.push_back(scripted_.name("P" + std::to_string(i)));
    for (std::size_t i = 0; i < script.definitions.size(); ++i) scripted_.bind(names_[i], term(script.definitions[i]));
}

process::Event Translation::event(Letter letter) {
    if (letter == naive::tau) return process::tau;
    if (letter == naive::tick) return process::tick;
    return scripted_.event(std::string(1, static_cast<char>('a' + letter)));
}

process::EventSet Translation::events_of(const std::set<Letter>& letters) {
    process::EventSet events;
    for (Letter l : letters) events.push_back(event(l));
    return events;
}

std::uint32_t Translation::set_of(const std::set<Letter>& letters) {
    return static_cast<std::uint32_t>(scripted_.store.intern_set(events_of(letters)));
}

TermId Translation::term(const naive::Process& process) {
    std::vector<TermId> operands;
    for (const naive::Process& operand : process->operands) operands.push_back(term(operand));
    return process->kind < Kind::sequential ? leaf_or_choice(*process, std::move(operands))
                                            : composite(*process, std::move(operands));
}

TermId Translation::leaf_or_choice(const naive::Tree& tree, std::vector<TermId> operands) {
    switch (tree.kind) {
        case Kind::skip:
            return scripted_.skip();
        case Kind::div:
            return scripted_.op(Op::div);
        case Kind::omega:
            return scripted_.op(Op::omega);
        case Kind::run:
            return scripted_.op(Op::run, {}, set_of(tree.set));
        case Kind::chaos:
            return scripted_.op(Op::chaos, {}, set_of(tree.set));
        case Kind::call:
            return names_.at(static_cast<std::size_t>(tree.name));
        case Kind::external:
            return scripted_.op(Op::external_choice, std::move(operands));
        case Kind::internal:
            return scripted_.op(Op::internal_choice, std::move(operands));
        case Kind::prefix: {
            std::vector<process::Branch> branches;
            for (std::size_t i = 0; i < operands.size(); ++i) branches.push_back({event(tree.letters[i]), operands[i]});
            return scripted_.branches_of(std::move(branches));
        }
        default:
            return scripted_.stop();
    }
}

TermId Translation::composite(const naive::Tree& tree, std::vector<TermId> operands) {
    const std::uint32_t set = set_of(tree.set);
    const auto make = [&](Op op, std::uint32_t payload) { return scripted_.op(op, std::move(operands), payload); };
    switch (tree.kind) {
        case Kind::sequential:
            return make(Op::sequential, 0);
        case Kind::interrupt:
            return make(Op::interrupt, 0);
        case Kind::sliding:
            return make(Op::sliding, 0);
        case Kind::exception:
            return make(Op::exception, set);
        case Kind::sync_external:
            return make(Op::sync_choice, set);
        case Kind::sync_interrupt:
            return make(Op::sync_interrupt, set);
        case Kind::parallel:
            return make(Op::parallel, set);
        case Kind::hide:
            return make(Op::hide, set);
        case Kind::chase:
            return make(Op::chase, 0);
        case Kind::compress:
            return make(Op::compress, static_cast<std::uint32_t>(tree.name));
        case Kind::alphabetised: {
            std::vector<process::SetId> sets;
            for (const auto& alphabet : tree.sets) sets.push_back(process::SetId{set_of(alphabet)});
            return scripted_.op(Op::alphabetised, std::move(operands), 0, std::move(sets));
        }
        case Kind::rename: {
            process::Renaming renaming;
            for (const auto& [from, to] : tree.renaming) renaming.emplace_back(event(from), event(to));
            return make(Op::rename, static_cast<std::uint32_t>(scripted_.store.intern_renaming(renaming)));
        }
        case Kind::linked:
            return linked(tree, operands);
        case Kind::project: {
            std::set<Letter> others;
            for (Letter l = 0; l < 6; ++l)
                if (!tree.set.contains(l)) others.insert(l);
            return make(Op::hide, set_of(others));
        }
        case Kind::prioritise_order: {
            std::vector<process::EventPair> pairs;
            for (const auto& [high, low] : tree.renaming) pairs.emplace_back(event(high), event(low));
            const auto order = process::priority_order(events_of(tree.set), pairs, events_of(tree.sets[0]));
            return make(Op::prioritise_order, static_cast<std::uint32_t>(
                                                  scripted_.store.intern_renaming(std::get<process::Renaming>(order))));
        }
        default: {
            process::PriorityOrder order;
            for (const auto& level : tree.sets) order.push_back(events_of(level));
            return make(Op::prioritise, static_cast<std::uint32_t>(scripted_.store.intern_order(order)));
        }
    }
}

/// Renames both ends of a link to a new event. The two operands synchronise on this event, which is hidden.
TermId Translation::linked(const naive::Tree& tree, const std::vector<TermId>& operands) {
    process::Renaming left;
    process::Renaming right;
    process::EventSet links;
    for (const auto& [from, to] : tree.renaming) {
        links.push_back(scripted_.event("link" + std::to_string(from) + std::to_string(to)));
        left.emplace_back(event(from), links.back());
        right.emplace_back(event(to), links.back());
    }
    const auto renamed = [&](TermId operand, process::Renaming names) {
        return scripted_.op(Op::rename, {operand},
                            static_cast<std::uint32_t>(scripted_.store.intern_renaming(std::move(names))));
    };
    const auto set = static_cast<std::uint32_t>(scripted_.store.intern_set(links));
    const TermId both = scripted_.op(Op::parallel, {renamed(operands[0], left), renamed(operands[1], right)}, set);
    return scripted_.op(Op::hide, {both}, set);
}

}  // namespace robochart::refine
