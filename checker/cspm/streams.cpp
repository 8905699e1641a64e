// Infinite sequences: <n..>, comprehensions whose first generator runs over one, and what ^ puts before one. They are
// taken apart element by element, as far as is asked (FDR evaluates sequences lazily).
#include <algorithm>

#include "checker/cspm/evaluator_internal.hpp"

namespace robochart::cspm {
namespace {

/// Elements that are passed over before the search for one that fits is given up.
constexpr std::size_t most_skipped = 200'000;

}  // namespace

bool Evaluator::is_infinite(Value sequence) {
    return sequence->kind == Kind::sequence_from || sequence->kind == Kind::stream;
}

// A stream's items: what comes first, the sequence to go on with, and the variables of the comprehension, if any, that
// `number` tells.
Value Evaluator::stream(Values first, Value rest, const Code* comprehension, const Frame& frame) {
    Values items{store_.sequence(std::move(first)), rest};
    if (comprehension == nullptr) return store_.make(Kind::stream, -1, std::move(items));
    for (Value value : frame) items.push_back(value == nullptr ? store_.tuple({}) : share(value));
    const auto known = std::ranges::find(streams_, comprehension);
    const auto number = known - streams_.begin();
    if (known == streams_.end()) streams_.push_back(comprehension);
    return store_.make(Kind::stream, number, std::move(items));
}

Evaluator::Cut Evaluator::cut(Value sequence, Span span) {
    if (sequence->kind == Kind::sequence_from) {
        std::int64_t next = 0;
        if (__builtin_add_overflow(sequence->number, std::int64_t{1}, &next))
            fail("the number does not fit in 64 bits", span);
        return {store_.integer(sequence->number), store_.make(Kind::sequence_from, next, {})};
    }
    const Code* const comprehension =
        sequence->number < 0 ? nullptr : streams_.at(static_cast<std::size_t>(sequence->number));
    const Frame frame(sequence->items.begin() + 2, sequence->items.end());
    Values first = sequence->items[0]->items;
    Value rest = sequence->items[1];
    if (first.empty() && comprehension == nullptr) return cut(rest, span);
    for (std::size_t tried = 0; first.empty(); ++tried) {
        if (tried >= most_skipped) fail("none of 200000 elements makes another one of the sequence", span);
        const Cut next = cut(rest, span);
        rest = next.tail;
        Frame inside = frame;
        Value item = next.head;
        if (!match(comprehension->clauses[0].pattern, item, inside)) continue;
        for_each(*comprehension, comprehension->clauses, 1, inside, [&](Frame& each) {
            for (const Code* arg : comprehension->args) first.push_back(share(eval(*arg, each)));
        });
    }
    const Value head = first.front();
    first.erase(first.begin());
    return {head, stream(std::move(first), rest, comprehension, frame)};
}

bool Evaluator::element_of_infinite(Value element, Value sequence, Span span) {
    for (std::size_t tried = 0; tried < most_skipped; ++tried) {
        const Cut next = cut(sequence, span);
        if (next.head == element) return true;
        sequence = next.tail;
    }
    fail("not among the first 200000 elements of an infinite sequence", span);
}

}  // namespace robochart::cspm
