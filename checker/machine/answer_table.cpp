// SPDX-License-Identifier: Apache-2.0
#include "checker/machine/answer_table.hpp"

#include <cassert>
#include <utility>

namespace robochart::machine {

void AnswerTable::store_answer(std::uint32_t query, std::uint64_t key, std::uint32_t answer) {
    Entry& entry = entries_[entry_index(query, key)];
    const bool fresh = entry.query == none;
    entry = {key, query, answer};
    if (!fresh || ++size_ <= entries_.size() / 4 * 3) return;
    std::vector<Entry> before(entries_.size() * 2);
    assert(size_ <= before.size() / 4 * 3);
    std::swap(before, entries_);
    for (const Entry& earlier : before)
        if (earlier.query != none) entries_[entry_index(earlier.query, earlier.key)] = earlier;
}

void AnswerTable::clear() {
    entries_.assign(least, {});
    entries_.shrink_to_fit();
    size_ = 0;
}

}  // namespace robochart::machine
