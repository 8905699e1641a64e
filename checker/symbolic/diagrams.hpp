// SPDX-License-Identifier: Apache-2.0
// Represents sets of tuples by multi-valued decision diagrams (Kam, Villa, Brayton and Sangiovanni-Vincentelli,
// "Multi-valued decision diagrams", 1998). A node of level k represents a set of tuples of the variables 1 to k.
// Diagrams are quasi-reduced: the children of a node of level k have level k - 1. The only exceptions are `nothing` and
// `everything`, which represent the empty set and the full set at each level. Equal sets of one level are one node.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <vector>

#include "base/diagnostics/pollable.hpp"

namespace robochart::symbolic {

using Node = std::uint32_t;
using Level = std::uint32_t;
using Value = std::uint32_t;

inline constexpr Node nothing = 0;
inline constexpr Node everything = 1;

/// Thrown if the nodes in use need more memory than the limit allows.
class OutOfSpace : public std::runtime_error {
public:
    OutOfSpace() : std::runtime_error("decision diagrams have no more memory") {}
};

/// The memory that diagrams may use.
struct Space {
    std::size_t bytes = std::size_t{1} << 30U;  ///< for nodes, tables and results
    /// For tests: number of stored results of operations, a power of 2.
    std::size_t most_results = std::size_t{1} << 25U;
    std::size_t first_collection = std::size_t{1} << 24U;  ///< size of the nodes at the first collection
    /// For tests: whether garbage is collected before every new node.
    bool always_collect = false;
};

/// Creates nodes and computes with the sets that they represent. The creation of a node may start a garbage collection,
/// which frees all nodes that are not kept. Operations do not keep their results. So the caller must keep each node
/// that it needs after the next operation (keep_always, Kept).
class Diagrams {
public:
    struct Entry {
        Value value;
        Node child;
    };
    /// The operations whose results are stored.
    enum class Operation : std::uint32_t { none, unite, intersect, subtract, fire, saturate, disable, precede };

    /// `domains`: by level, the number of values of the variable. The first element is unused.
    Diagrams(std::vector<Value> domains, const Space& space, diagnostics::Pollable& budget);

    [[nodiscard]] Level levels() const { return static_cast<Level>(domains_.size() - 1); }
    [[nodiscard]] Value domain(Level level) const { return domains_[level]; }
    /// Returns the level of a node, which must not be `nothing` or `everything`.
    [[nodiscard]] Level level_of(Node node) const {
        assert(node > everything && records_[node].level != 0);
        return records_[node].level;
    }
    /// Returns the number of entries of a node of this level. `everything` has one entry for each value.
    [[nodiscard]] std::size_t entry_count(Level level, Node node) const {
        if (node <= everything) return node == nothing ? 0 : domains_[level];
        assert(records_[node].level == level);
        return records_[node].count;
    }
    /// Returns an entry of a node of this level. Entries are ascending by value, and no child is `nothing`.
    [[nodiscard]] Entry entry(Node node, std::size_t index) const {
        if (node == everything) return {static_cast<Value>(index), everything};
        assert(index < records_[node].count);
        return entries_[records_[node].first + index];
    }
    [[nodiscard]] Node child(Node node, Value value) const;
    /// Returns true if the set contains the tuple. `values` contains its values by level; the first element is unused.
    [[nodiscard]] bool contains(Node set, const std::vector<Value>& values) const;

    /// Returns the set that contains only the least tuple of this set, which must not be empty. The caller must keep
    /// the given set during the call.
    [[nodiscard]] Node least_tuple(Node set);

    /// Begins a node, for which the caller then pushes entries. Another node may be begun and ended before this node is
    /// ended. The garbage collection keeps entries that have been pushed.
    [[nodiscard]] std::size_t begin_node() const { return building_.size(); }
    void push(Value value, Node child) {
        if (child != nothing) building_.push_back({value, child});
    }
    /// Returns the child of the last entry that was pushed.
    [[nodiscard]] Node& last_child() { return building_.back().child; }
    /// Ends a node and returns it. `begun` is the result of begin_node for this node.
    [[nodiscard]] Node end_node(Level level, std::size_t begun);

    [[nodiscard]] Node unite(Level level, Node a, Node b);
    [[nodiscard]] Node intersect(Level level, Node a, Node b);
    /// Returns the tuples of `a` that are not in `b`.
    [[nodiscard]] Node subtract(Level level, Node a, Node b);
    /// Converts a set to a higher level. The result contains all tuples of this level whose lower variables form a
    /// tuple of `node`.
    [[nodiscard]] Node lift(Node node, Level level);

    /// The following functions read and write the cache of results of operations.
    [[nodiscard]] bool find_result(Operation operation, Level level, Node a, std::uint32_t b, Node c,
                                   Node& result) const;
    void store_result(Operation operation, Level level, Node a, std::uint32_t b, Node c, Node result);

    /// Keeps a node as long as the diagrams exist.
    Node keep_always(Node node) {
        always_.push_back(node);
        return node;
    }
    /// Sets a function that returns further nodes that the garbage collection must keep.
    void set_users(std::function<void(std::vector<Node>&)> list_used) { list_used_ = std::move(list_used); }

    /// Keeps a node during its lifetime. Objects must be destroyed in the reverse order of their creation.
    class Kept {
    public:
        Kept(Diagrams& diagrams, Node node) : diagrams_(diagrams), place_(diagrams.kept_.size()) {
            diagrams.kept_.push_back(node);
        }
        Kept(const Kept&) = delete;
        Kept& operator=(const Kept&) = delete;
        ~Kept() { diagrams_.kept_.resize(place_); }
        void set(Node node) { diagrams_.kept_[place_] = node; }
        [[nodiscard]] Node get() const { return diagrams_.kept_[place_]; }

    private:
        Diagrams& diagrams_;
        std::size_t place_;
    };

    /// Returns the number of tuples, or infinity if the number is too large for the type.
    [[nodiscard]] long double count_tuples(Node set) const;
    /// Returns the number of nodes of a set.
    [[nodiscard]] std::size_t count_nodes(Node set) const;
    /// Returns how many nodes have been created so far, including those that have been collected.
    [[nodiscard]] std::uint64_t made() const { return made_; }
    [[nodiscard]] std::uint64_t collections() const { return collections_; }

private:
    struct Record {
        std::size_t first = 0;
        Level level = 0;  // 0 if not in use, and for `nothing` and `everything`
        std::uint32_t count = 0;
    };
    struct Result {
        std::uint32_t key = 0;  // operation and level; 0 if the entry is empty
        Node a = 0;
        std::uint32_t b = 0;
        Node c = 0, result = 0;
    };

    [[nodiscard]] std::uint64_t hash_of(Level level, const Entry* entries, std::size_t count) const;
    [[nodiscard]] bool equals(Node node, Level level, const Entry* entries, std::size_t count) const;
    [[nodiscard]] Node& place_of(Level level, const Entry* entries, std::size_t count);
    [[nodiscard]] Node insert_node(Level level, std::size_t begun);
    void make_space();
    void collect();
    [[nodiscard]] std::vector<bool> mark() const;
    void rebuild_table(std::size_t size);
    void grow_results();
    [[nodiscard]] std::size_t node_bytes() const;
    [[nodiscard]] std::size_t all_bytes() const;
    [[nodiscard]] static std::uint32_t key_of(Operation operation, Level level) {
        static_assert(static_cast<std::uint32_t>(Operation::precede) < 8);
        return static_cast<std::uint32_t>(operation) | level << 3U;
    }

    const std::vector<Value> domains_;
    const Space space_;
    diagnostics::Pollable& budget_;
    std::vector<Record> records_;  // by node
    std::vector<Entry> entries_;
    std::vector<Node> free_;
    std::vector<Node> table_;  // hash table of nodes, at most half full; 0: empty place
    std::size_t used_ = 0;     // number of nodes in the table
    std::vector<Result> results_;
    std::vector<Entry> building_;
    std::vector<Node> kept_, always_;
    std::function<void(std::vector<Node>&)> list_used_;
    std::size_t next_collection_;
    std::uint64_t made_ = 0, collections_ = 0;
};

}  // namespace robochart::symbolic
