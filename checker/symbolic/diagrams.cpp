// SPDX-License-Identifier: Apache-2.0
#include "checker/symbolic/diagrams.hpp"

#include <algorithm>
#include <utility>

namespace robochart::symbolic {
namespace {

std::uint64_t mix(std::uint64_t value) {
    value ^= value >> 32U;
    value *= 0x9e3779b97f4a7c15U;
    value ^= value >> 29U;
    value *= 0xbf58476d1ce4e5b9U;
    return value ^ (value >> 32U);
}

constexpr std::size_t first_table = std::size_t{1} << 12U;

}  // namespace

Diagrams::Diagrams(std::vector<Value> domains, const Space& space, diagnostics::Pollable& budget)
    : domains_(std::move(domains)),
      space_(space),
      budget_(budget),
      records_(2),
      table_(first_table),
      results_(std::min(space.most_results, first_table)),
      next_collection_(space.first_collection) {
    assert(!domains_.empty() && !results_.empty());
}

Node Diagrams::child(Node node, Value value) const {
    if (node <= everything) return node;
    const Record& record = records_[node];
    assert(record.level != 0);
    const Entry* const first = entries_.data() + record.first;
    if (value < record.count && first[value].value == value) return first[value].child;
    const Entry* const last = first + record.count;
    const Entry* const found =
        std::lower_bound(first, last, value, [](const Entry& entry, Value wanted) { return entry.value < wanted; });
    return found != last && found->value == value ? found->child : nothing;
}

bool Diagrams::contains(Node set, const std::vector<Value>& values) const {
    assert(values.size() == domains_.size());
    for (Level level = levels(); level > 0 && set > everything; --level) set = child(set, values[level]);
    return set == everything;
}

Node Diagrams::least_tuple(Node set) {
    assert(set != nothing);
    std::vector<Value> values(levels() + std::size_t{1});
    for (Level level = levels(); level > 0 && set > everything; --level) {
        values[level] = entry(set, 0).value;
        set = entry(set, 0).child;
    }
    Node tuple = everything;
    for (Level level = 1; level <= levels(); ++level) {
        const std::size_t begun = begin_node();
        push(values[level], tuple);
        tuple = end_node(level, begun);
    }
    return tuple;
}

std::uint64_t Diagrams::hash_of(Level level, const Entry* entries, std::size_t count) const {
    std::uint64_t hash = level;
    for (std::size_t i = 0; i < count; ++i)
        hash = mix(hash ^ (std::uint64_t{entries[i].value} << 32U | entries[i].child)) + i;
    return hash;
}

bool Diagrams::equals(Node node, Level level, const Entry* entries, std::size_t count) const {
    const Record& record = records_[node];
    if (record.level != level || record.count != count) return false;
    return std::equal(entries, entries + count, entries_.data() + record.first,
                      [](const Entry& a, const Entry& b) { return a.value == b.value && a.child == b.child; });
}

/// Returns the place in the hash table that contains the node, or in which it must be inserted.
Node& Diagrams::place_of(Level level, const Entry* entries, std::size_t count) {
    const std::size_t mask = table_.size() - 1;
    std::size_t place = hash_of(level, entries, count) & mask;
    while (table_[place] != 0 && !equals(table_[place], level, entries, count)) place = (place + 1) & mask;
    return table_[place];
}

Node Diagrams::end_node(Level level, std::size_t begun) {
    budget_.poll();
    const std::size_t count = building_.size() - begun;
    const auto first = building_.begin() + static_cast<std::ptrdiff_t>(begun);
    assert(std::is_sorted(first, building_.end(), [](const Entry& a, const Entry& b) { return a.value < b.value; }));
    Node result = nothing;
    if (count == domains_[level] &&
        std::all_of(first, building_.end(), [](const Entry& entry) { return entry.child == everything; }))
        result = everything;
    else if (count > 0)
        result = insert_node(level, begun);
    building_.resize(begun);
    return result;
}

Node Diagrams::insert_node(Level level, std::size_t begun) {
    const std::size_t count = building_.size() - begun;
    if (const Node known = place_of(level, building_.data() + begun, count); known != 0) return known;
    make_space();
    Node node = 0;
    if (free_.empty()) {
        node = static_cast<Node>(records_.size());
        records_.emplace_back();
    } else {
        node = free_.back();
        free_.pop_back();
    }
    records_[node] = {entries_.size(), level, static_cast<std::uint32_t>(count)};
    const auto first = building_.begin() + static_cast<std::ptrdiff_t>(begun);
    entries_.insert(entries_.end(), first, building_.end());
    Node& place = place_of(level, entries_.data() + records_[node].first, count);
    assert(place == 0);
    place = node;
    ++used_;
    ++made_;
    return node;
}

/// Makes space for a new node by a garbage collection or by larger tables.
void Diagrams::make_space() {
    if (space_.always_collect || node_bytes() >= next_collection_) {
        collect();
        if (all_bytes() > space_.bytes) results_.resize(std::min(results_.size(), first_table));
        if (all_bytes() > space_.bytes - space_.bytes / 4) throw OutOfSpace();
        const std::size_t left = space_.bytes - all_bytes();
        next_collection_ = std::max(space_.first_collection, node_bytes() + std::min(node_bytes(), left / 2));
    }
    if (2 * (used_ + 1) > table_.size()) {
        rebuild_table(2 * table_.size());
        grow_results();
    }
    if (all_bytes() > space_.bytes) next_collection_ = 0;
}

std::size_t Diagrams::node_bytes() const {
    return records_.size() * sizeof(Record) + entries_.size() * sizeof(Entry);
}

std::size_t Diagrams::all_bytes() const {
    return node_bytes() + table_.size() * sizeof(Node) + results_.size() * sizeof(Result);
}

/// Enlarges the result cache. It has up to 16 entries for each node, and uses at most half of the memory.
void Diagrams::grow_results() {
    const std::size_t size = std::min(8 * table_.size(), space_.most_results);
    if (size <= results_.size() || size * sizeof(Result) > space_.bytes / 2) return;
    std::vector<Result> before(size);
    before.swap(results_);
    for (const Result& result : before)
        if (result.key != 0) {
            const std::uint64_t hash =
                mix(mix(std::uint64_t{result.key} << 32U | result.a) ^ (std::uint64_t{result.b} << 32U | result.c));
            results_[hash & (results_.size() - 1)] = result;
        }
}

void Diagrams::rebuild_table(std::size_t size) {
    table_.assign(size, 0);
    for (Node node = 2; node < records_.size(); ++node) {
        const Record& record = records_[node];
        if (record.level != 0) place_of(record.level, entries_.data() + record.first, record.count) = node;
    }
}

std::vector<bool> Diagrams::mark() const {
    std::vector<Node> open(kept_);
    open.insert(open.end(), always_.begin(), always_.end());
    for (const Entry& entry : building_) open.push_back(entry.child);
    if (list_used_) list_used_(open);
    std::vector<bool> marked(records_.size());
    std::erase_if(open, [](Node node) { return node <= everything; });
    while (!open.empty()) {
        const Node node = open.back();
        open.pop_back();
        if (marked[node]) continue;
        budget_.poll();
        marked[node] = true;
        const Record& record = records_[node];
        assert(record.level != 0);
        for (std::size_t i = 0; i < record.count; ++i) {
            const Node next = entries_[record.first + i].child;
            if (next > everything && !marked[next]) open.push_back(next);
        }
    }
    return marked;
}

/// Frees unused nodes by mark and sweep. The other nodes keep their numbers. The result cache is cleared, because its
/// entries may refer to nodes that have been freed.
void Diagrams::collect() {
    ++collections_;
    const std::vector<bool> marked = mark();
    std::vector<Entry> live;
    free_.clear();
    used_ = 0;
    for (Node node = static_cast<Node>(records_.size()); node-- > 2;) {
        Record& record = records_[node];
        if (!marked[node]) {
            record = {};
            free_.push_back(node);
            continue;
        }
        const auto first = entries_.begin() + static_cast<std::ptrdiff_t>(record.first);
        record.first = live.size();
        live.insert(live.end(), first, first + record.count);
        ++used_;
    }
    entries_ = std::move(live);
    rebuild_table(table_.size());
    std::ranges::fill(results_, Result{});
}

bool Diagrams::find_result(Operation operation, Level level, Node a, std::uint32_t b, Node c, Node& result) const {
    const std::uint32_t key = key_of(operation, level);
    const std::uint64_t hash = mix(mix(std::uint64_t{key} << 32U | a) ^ (std::uint64_t{b} << 32U | c));
    const Result& stored = results_[hash & (results_.size() - 1)];
    if (stored.key != key || stored.a != a || stored.b != b || stored.c != c) return false;
    result = stored.result;
    return true;
}

void Diagrams::store_result(Operation operation, Level level, Node a, std::uint32_t b, Node c, Node result) {
    const std::uint32_t key = key_of(operation, level);
    const std::uint64_t hash = mix(mix(std::uint64_t{key} << 32U | a) ^ (std::uint64_t{b} << 32U | c));
    results_[hash & (results_.size() - 1)] = {key, a, b, c, result};
}

Node Diagrams::unite(Level level, Node a, Node b) {
    if (a == b || b == nothing) return a;
    if (a == nothing) return b;
    if (a == everything || b == everything) return everything;
    if (a > b) std::swap(a, b);
    Node result = nothing;
    if (find_result(Operation::unite, level, a, b, 0, result)) return result;
    const std::size_t begun = begin_node();
    const std::size_t size_a = entry_count(level, a), size_b = entry_count(level, b);
    for (std::size_t i = 0, j = 0; i < size_a || j < size_b;) {
        if (j == size_b || (i < size_a && entry(a, i).value < entry(b, j).value)) {
            push(entry(a, i).value, entry(a, i).child);
            ++i;
        } else if (i == size_a || entry(b, j).value < entry(a, i).value) {
            push(entry(b, j).value, entry(b, j).child);
            ++j;
        } else {
            push(entry(a, i).value, unite(level - 1, entry(a, i).child, entry(b, j).child));
            ++i;
            ++j;
        }
    }
    result = end_node(level, begun);
    store_result(Operation::unite, level, a, b, 0, result);
    return result;
}

Node Diagrams::intersect(Level level, Node a, Node b) {
    if (a == b || b == everything) return a;
    if (a == everything) return b;
    if (a == nothing || b == nothing) return nothing;
    if (a > b) std::swap(a, b);
    Node result = nothing;
    if (find_result(Operation::intersect, level, a, b, 0, result)) return result;
    const std::size_t begun = begin_node();
    const std::size_t size_a = entry_count(level, a), size_b = entry_count(level, b);
    for (std::size_t i = 0, j = 0; i < size_a && j < size_b;) {
        const Value value_a = entry(a, i).value, value_b = entry(b, j).value;
        if (value_a == value_b) push(value_a, intersect(level - 1, entry(a, i).child, entry(b, j).child));
        if (value_a <= value_b) ++i;
        if (value_b <= value_a) ++j;
    }
    result = end_node(level, begun);
    store_result(Operation::intersect, level, a, b, 0, result);
    return result;
}

Node Diagrams::subtract(Level level, Node a, Node b) {
    if (a == b || a == nothing || b == everything) return nothing;
    if (b == nothing) return a;
    Node result = nothing;
    if (find_result(Operation::subtract, level, a, b, 0, result)) return result;
    const std::size_t begun = begin_node();
    for (std::size_t i = 0; i < entry_count(level, a); ++i) {
        const auto [value, rest] = entry(a, i);
        push(value, subtract(level - 1, rest, child(b, value)));
    }
    result = end_node(level, begun);
    store_result(Operation::subtract, level, a, b, 0, result);
    return result;
}

Node Diagrams::lift(Node node, Level level) {
    while (node > everything && level_of(node) < level) {
        const Level above = level_of(node) + 1;
        const std::size_t begun = begin_node();
        for (Value value = 0; value < domains_[above]; ++value) push(value, node);
        node = end_node(above, begun);
    }
    return node;
}

long double Diagrams::count_tuples(Node set) const {
    std::vector<long double> full{1};
    for (Level level = 1; level <= levels(); ++level) full.push_back(full.back() * domains_[level]);
    // The nodes by level. The numbers of tuples are computed for children first.
    std::vector<std::vector<Node>> by_level(levels() + std::size_t{1});
    std::vector<bool> found(records_.size());
    const auto add = [&](Node node) {
        if (node <= everything || found[node]) return;
        found[node] = true;
        by_level[level_of(node)].push_back(node);
    };
    add(set);
    for (Level level = levels(); level > 0; --level)
        for (std::size_t at = 0; at < by_level[level].size(); ++at)
            for (std::size_t i = 0; i < records_[by_level[level][at]].count; ++i)
                add(entry(by_level[level][at], i).child);
    std::vector<long double> counts(records_.size());
    const auto count_of = [&](Level level, Node node) {
        if (node == nothing) return 0.0L;
        return node == everything ? full[level] : counts[node];
    };
    for (Level level = 1; level <= levels(); ++level)
        for (const Node node : by_level[level]) {
            budget_.poll();
            for (std::size_t i = 0; i < records_[node].count; ++i)
                counts[node] += count_of(level - 1, entry(node, i).child);
        }
    return count_of(levels(), set);
}

std::size_t Diagrams::count_nodes(Node set) const {
    std::vector<bool> found(records_.size());
    std::vector<Node> open{set};
    std::size_t count = 0;
    while (!open.empty()) {
        const Node node = open.back();
        open.pop_back();
        if (node <= everything || found[node]) continue;
        budget_.poll();
        found[node] = true;
        ++count;
        for (std::size_t i = 0; i < records_[node].count; ++i) open.push_back(entry(node, i).child);
    }
    return count;
}

}  // namespace robochart::symbolic
