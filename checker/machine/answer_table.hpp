// SPDX-License-Identifier: Apache-2.0
// Caches the results of confluence proofs. A key consists of a query (Confluence::Tracked) and the states of the
// components that it reads. The table uses open addressing with linear probing (Knuth, The Art of Computer Programming
// 3, section 6.4). A search makes several queries for each state, and a look-up usually reads only one cache line.
#pragma once

#include <cassert>
#include <cstdint>
#include <optional>
#include <vector>

namespace robochart::machine {

class AnswerTable {
public:
    AnswerTable() : entries_(least) {}

    /// Returns the stored answer, or no value if none is stored. `query` must not be `none`.
    [[nodiscard]] std::optional<std::uint32_t> find(std::uint32_t query, std::uint64_t key) const {
        const Entry& entry = entries_[entry_index(query, key)];
        if (entry.query == none) return std::nullopt;
        return entry.answer;
    }
    /// Stores an answer, and replaces an earlier answer for the same key.
    void store_answer(std::uint32_t query, std::uint64_t key, std::uint32_t answer);
    [[nodiscard]] std::size_t size() const { return size_; }
    void clear();

    static constexpr std::uint32_t none = UINT32_MAX;

private:
    struct Entry {
        std::uint64_t key = 0;
        std::uint32_t query = none;  ///< `none` if the entry is free
        std::uint32_t answer = 0;
    };
    static constexpr std::size_t least = 1024;  ///< minimal number of entries; this number is always a power of two

    /// Returns the index of the entry for the key, or of a free entry. A quarter of the table is always free.
    [[nodiscard]] std::size_t entry_index(std::uint32_t query, std::uint64_t key) const {
        const std::size_t mask = entries_.size() - 1;
        assert(query != none && (entries_.size() & mask) == 0 && size_ < entries_.size());
        std::size_t at = hash(query, key) & mask;
        while (entries_[at].query != none && (entries_[at].key != key || entries_[at].query != query))
            at = (at + 1) & mask;
        return at;
    }
    [[nodiscard]] static std::uint64_t hash(std::uint32_t query, std::uint64_t key) {
        const std::uint64_t mixed = (key ^ query * 0x9E3779B97F4A7C15ULL) * 0xBF58476D1CE4E5B9ULL;
        return mixed ^ mixed >> 32U;
    }

    std::vector<Entry> entries_;
    std::size_t size_ = 0;
};

}  // namespace robochart::machine
