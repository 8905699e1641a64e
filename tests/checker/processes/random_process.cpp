// SPDX-License-Identifier: Apache-2.0
#include "random_process.hpp"

#include <utility>

namespace robochart::refine::naive {
namespace {

constexpr int definition_count = 2;

Process make(Kind kind, std::vector<Process> operands = {}, std::set<Letter> set = {}) {
    return std::make_shared<const Tree>(Tree{kind, std::move(operands), {}, std::move(set), {}, {}, 0});
}

}  // namespace

unsigned Decoder::take_below(unsigned below) {
    return next_ < numbers_.size() ? numbers_[next_++] % below : 0;
}

std::set<Letter> Decoder::set() {
    const unsigned bits = take_below(1U << letters_used);
    std::set<Letter> result;
    for (Letter l = 0; l < letters_used; ++l)
        if ((bits >> l & 1U) != 0) result.insert(l);
    return result;
}

Script Decoder::script(int mains) {
    Script script;
    definitions_ = definition_count;
    for (int i = 0; i < definition_count; ++i) script.definitions.push_back(sequential(3, false));
    for (int i = 0; i < mains; ++i) script.mains.push_back(composite(3));
    return script;
}

Process Decoder::sequential_leaf(bool guarded) {
    if (guarded && definitions_ > 0 && take_below(5) > 0) {
        Tree call{Kind::call, {}, {}, {}, {}, {}, static_cast<int>(take_below(definition_count))};
        return std::make_shared<const Tree>(call);
    }
    return static_leaf();
}

Process Decoder::static_leaf() {
    switch (take_below(9)) {
        case 0:
            return make(Kind::stop);
        case 1:
        case 2:
        case 3:
            return make(Kind::skip);
        case 4:
            return make(Kind::div);
        case 5:
        case 8:
            return make(Kind::run, {}, set());
        case 6:
            return make(Kind::chaos, {}, set());
        default:
            return make(Kind::stop);
    }
}

Process Decoder::prefix(int depth) {
    Tree tree{Kind::prefix, {}, {}, {}, {}, {}, 0};
    for (unsigned branches = 1 + take_below(2); branches > 0; --branches) {
        tree.letters.push_back(make_letter());
        tree.operands.push_back(sequential(depth - 1, true));
    }
    return std::make_shared<const Tree>(std::move(tree));
}

/// Returns one mode of a machine: some events keep the mode or lead to another one, and one event starts components.
Process Decoder::make_mode(int depth) {
    const auto lead = [&](Process to) {
        Tree tree{Kind::prefix, {std::move(to)}, {make_letter()}, {}, {}, {}, 0};
        return std::make_shared<const Tree>(std::move(tree));
    };
    Process stay = lead(sequential_leaf(true));
    Process start = lead(make(Kind::parallel, {closed(depth - 2), closed(depth - 2)}));
    return make(take_below(4) == 0 ? Kind::sliding : Kind::external, {std::move(start), std::move(stay)});
}

Process Decoder::closed(int depth) {
    const int calls = std::exchange(definitions_, 0);
    Process result = sequential(depth, false);
    definitions_ = calls;
    return result;
}

Process Decoder::sequential(int depth, bool guarded) {
    if (depth <= 0) return sequential_leaf(guarded);
    switch (take_below(20)) {
        case 0:
        case 1:
            return sequential_leaf(guarded);
        case 2:
            return make(Kind::external, {sequential(depth - 1, guarded), sequential(depth - 1, guarded)});
        case 3:
            return make(Kind::internal, {sequential(depth - 1, guarded), sequential(depth - 1, guarded)});
        case 4:
            return make(Kind::sequential, {closed(depth - 1), sequential(depth - 1, guarded)});
        case 5:
            return make(Kind::sliding, {sequential(depth - 1, guarded), sequential(depth - 1, guarded)});
        case 6:
            return make(Kind::interrupt, {closed(depth - 1), sequential(depth - 1, guarded)});
        case 7:
            return make(Kind::exception, {closed(depth - 1), sequential(depth - 1, true)}, set());
        case 8:
            return make(Kind::sync_external, {closed(depth - 1), closed(depth - 1)}, set());
        case 9:
            return make(Kind::sync_interrupt, {closed(depth - 1), closed(depth - 1)}, set());
        case 10:
            return compressed(closed(depth - 1));
        case 11:
        case 12:
            return make(Kind::parallel, {closed(depth - 1), closed(depth - 1)},
                        take_below(2) == 0 ? std::set<Letter>{} : set());
        case 13:
        case 14:
            return make_mode(depth);
        case 15:
            return make(take_below(2) == 0 ? Kind::hide : Kind::project, {closed(depth - 1)}, set());
        default:
            return prefix(depth);
    }
}

Process Decoder::with_levels(Kind kind, std::vector<Process> operands, unsigned sets) {
    Tree tree{kind, std::move(operands), {}, {}, {}, {}, 0};
    while (tree.sets.size() < sets) tree.sets.push_back(set());
    return std::make_shared<const Tree>(std::move(tree));
}

/// Returns a renaming, which may map several letters to one, and one letter to several.
Process Decoder::renamed(int depth) {
    Tree tree{Kind::rename, {composite(depth - 1)}, {}, {}, {}, {}, 0};
    for (unsigned pairs = 1 + take_below(3); pairs > 0; --pairs) {
        const Letter from = make_letter();
        tree.renaming.emplace_back(from, make_letter());
    }
    return std::make_shared<const Tree>(std::move(tree));
}

/// Links each letter at most once on each side, because FDR rejects other links.
Process Decoder::linked(int depth) {
    Tree tree{Kind::linked, {composite(depth - 1), composite(depth - 1)}, {}, {}, {}, {}, 0};
    tree.renaming.emplace_back(make_letter(), make_letter());
    const auto [from, to] = tree.renaming.front();
    if (take_below(2) == 1) tree.renaming.emplace_back((from + 1) % letters_used, (to + 2) % letters_used);
    return std::make_shared<const Tree>(std::move(tree));
}

/// Returns an acyclic order. Its maximal events are below no other event, as prioritisepo requires.
Process Decoder::make_ordered(int depth) {
    Tree tree{Kind::prioritise_order, {composite(depth - 1)}, {}, {0, 1, 2}, {}, {}, 0};
    const Letter first = make_letter();
    const auto ranked = [&](int rank) { return (first + rank) % letters_used; };
    std::set<Letter> maximal = set();
    for (const auto& [high, low] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
        if (take_below(2) == 0) continue;
        tree.renaming.emplace_back(ranked(high), ranked(low));
        maximal.erase(ranked(low));
    }
    tree.sets = {maximal};
    return std::make_shared<const Tree>(std::move(tree));
}

Process Decoder::compressed(Process operand) {
    constexpr int deter = 8;
    Tree tree{Kind::compress, {std::move(operand)}, {}, {}, {}, {}, static_cast<int>(take_below(9))};
    if (tree.name == deter) tree.name = deter + 1;  // FDR's deter is not supported, because it may change the meaning
    return std::make_shared<const Tree>(std::move(tree));
}

Process Decoder::composite(int depth) {
    if (depth <= 0) {
        Tree call{Kind::call, {}, {}, {}, {}, {}, static_cast<int>(take_below(definition_count))};
        return std::make_shared<const Tree>(call);
    }
    const auto part = [&] { return composite(depth - 1); };
    switch (take_below(26)) {
        case 0:
        case 1:
            return composite(0);
        case 2:
        case 3:
            return make(Kind::parallel, {part(), part()}, set());
        case 4:
            return make(Kind::parallel, {composite(0), composite(0), composite(0)}, set());
        case 5:
            return with_levels(Kind::alphabetised, {part(), part()});
        case 6:
        case 7:
            return make(Kind::hide, {part()}, set());
        case 8:
            return renamed(depth);
        case 9:
            return with_levels(Kind::prioritise, {part()}, 1 + take_below(3));
        case 10:
            return make(Kind::chase, {part()});
        case 11:
            return make(Kind::sequential, {part(), part()});
        case 12:
            return make(Kind::interrupt, {part(), part()});
        case 13:
            return make(Kind::exception, {part(), part()}, set());
        case 14:
            return make(Kind::sync_external, {part(), part()}, set());
        case 15:
            return make(Kind::sync_interrupt, {part(), part()}, set());
        case 16:
            return make(Kind::external, {part(), part()});
        case 17:
            return make(Kind::internal, {part(), part()});
        case 18:
            return make(Kind::sliding, {part(), part()});
        case 19:
            return linked(depth);
        case 20:
            return make_ordered(depth);
        case 21:
            return make(Kind::project, {part()}, set());
        default:
            return compressed(part());
    }
}

}  // namespace robochart::refine::naive
