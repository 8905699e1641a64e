// SPDX-License-Identifier: Apache-2.0
#include "checker/machine/answer_table.hpp"

#include <cassert>
#include <utility>

namespace robochart::machine {

void AnswerTable::store_answer(std::uint32_t asked, std::uint64_t key, std::uint32_t answer) {
    Entry& entry = entries_[entry_index(asked, key)];
    const bool fresh = entry.asked == none;
    entry = {key, asked, answer};
    if (!fresh || ++size_ <= entries_.size() / 4 * 3) return;
    std::vector<Entry> before(entries_.size() * 2);
    assert(size_ <= before.size() / 4 * 3);
    std::swap(before, entries_);
    for (const Entry& each : before)
        if (each.asked != none) entries_[entry_index(each.asked, each.key)] = each;
}

void AnswerTable::clear() {
    entries_.assign(least, {});
    entries_.shrink_to_fit();
    size_ = 0;
}

}  // namespace robochart::machine
