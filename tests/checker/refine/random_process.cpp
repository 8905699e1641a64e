#include "random_process.hpp"

#include <utility>

namespace robochart::refine::naive {
namespace {

constexpr int definition_count = 2;

Process make(Kind kind, std::vector<Process> operands = {}, std::set<Letter> set = {}) {
    return std::make_shared<const Tree>(Tree{kind, std::move(operands), {}, std::move(set), {}, {}, 0});
}

}  // namespace

unsigned Decoder::take(unsigned below) {
    return next_ < numbers_.size() ? numbers_[next_++] % below : 0;
}

std::set<Letter> Decoder::set() {
    const unsigned bits = take(1U << letters_used);
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
    if (guarded && definitions_ > 0 && take(3) > 0) {
        Tree call{Kind::call, {}, {}, {}, {}, {}, static_cast<int>(take(definition_count))};
        return std::make_shared<const Tree>(call);
    }
    return static_leaf();
}

Process Decoder::static_leaf() {
    switch (take(8)) {
        case 0:
            return make(Kind::stop);
        case 1:
        case 2:
        case 3:
            return make(Kind::skip);
        case 4:
            return make(Kind::div);
        case 5:
            return make(Kind::run, {}, set());
        case 6:
            return make(Kind::chaos, {}, set());
        default:
            return make(Kind::stop);
    }
}

Process Decoder::prefix(int depth) {
    Tree tree{Kind::prefix, {}, {}, {}, {}, {}, 0};
    for (unsigned branches = 1 + take(2); branches > 0; --branches) {
        tree.letters.push_back(letter());
        tree.operands.push_back(sequential(depth - 1, true));
    }
    return std::make_shared<const Tree>(std::move(tree));
}

Process Decoder::closed(int depth) {
    const int calls = std::exchange(definitions_, 0);
    Process result = sequential(depth, false);
    definitions_ = calls;
    return result;
}

Process Decoder::sequential(int depth, bool guarded) {
    if (depth <= 0) return sequential_leaf(guarded);
    switch (take(14)) {
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
        default:
            return prefix(depth);
    }
}

Process Decoder::with_levels(Kind kind, std::vector<Process> operands) {
    Tree tree{kind, std::move(operands), {}, {}, {}, {}, 0};
    tree.sets = {set(), set()};
    return std::make_shared<const Tree>(std::move(tree));
}

Process Decoder::composite(int depth) {
    if (depth <= 0) {
        Tree call{Kind::call, {}, {}, {}, {}, {}, static_cast<int>(take(definition_count))};
        return std::make_shared<const Tree>(call);
    }
    const auto part = [&] { return composite(depth - 1); };
    switch (take(23)) {
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
        case 8: {
            Tree tree{Kind::rename, {part()}, {}, {}, {}, {}, 0};
            for (unsigned pairs = 1 + take(3); pairs > 0; --pairs) {
                const Letter from = letter();
                tree.renaming.emplace_back(from, letter());
            }
            return std::make_shared<const Tree>(std::move(tree));
        }
        case 9:
            return with_levels(Kind::prioritise, {part()});
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
        default: {
            Tree tree{Kind::compress, {part()}, {}, {}, {}, {}, 0};
            tree.name = static_cast<int>(take(8));  // any but deter and lazyenumerate
            return std::make_shared<const Tree>(std::move(tree));
        }
    }
}

}  // namespace robochart::refine::naive
