// SPDX-License-Identifier: Apache-2.0
#include "checker/machine/skeleton.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <stdexcept>

#include "checker/machine/not_compiled.hpp"
#include "checker/process/operators.hpp"

namespace robochart::machine {
namespace {

using process::OpGroup;
using process::Term;

constexpr int deepest = 300;              // limit on nested operators; deeper operators belong to one component
constexpr int deepest_look = 100;         // limit on nested operators in the search for a parallel operator
constexpr int deepest_prefix = 3;         // limit on the events before a parallel operator
constexpr std::size_t most_branches = 8;  // only prefixes with at most this many branches are split
constexpr std::size_t most_nodes = 200'000;
constexpr std::size_t most_prefixes = 500;  // limit on how many prefixes are split
constexpr std::size_t longest_chain = 60;   // limit on nested prefixes that are split

/// Thrown if unfolding prefixes takes too long or never ends.
class UnfoldsOn : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class Builder {
public:
    /// `through_prefixes`: whether to search for parallel operators after prefixes.
    Builder(process::TermStore& terms, const std::set<TermId>& leaves, const std::set<TermId>& left_out,
            bool through_prefixes, diagnostics::Pollable& budget)
        : terms_(terms), leaves_(leaves), left_out_(left_out), through_prefixes_(through_prefixes), budget_(budget) {}

    Skeleton build(TermId term) {
        add_node(term, 0, {}, 0);
        result_.prefixes = prefixes_taken_;
        return std::move(result_);
    }
    /// Returns true if the term contains a parallel operator that runs now or after a few events.
    bool is_composite(TermId term, int depth = 0, int prefixes = 0);

private:
    TermId unfold_term(TermId term);
    bool looks_composite(const Term& term, int depth, int prefixes);
    /// The nodes around a node that have ended when the node runs:
    struct Tail {
        std::vector<NodeId> at_once;   ///< ... after any event
        std::vector<NodeId> by_event;  ///< ... after a visible event of the node, which resolves the enclosing choices
    };

    NodeId add_node(TermId term, NodeId region, const Tail& tail, int depth);
    NodeId add(Node::Kind kind, TermId term, NodeId region);
    void add_leaf(NodeId id);
    void add_operands(NodeId id, const Tail& tail, int depth);
    void add_child(NodeId id, TermId term, const Tail& tail, int depth);
    void add_gate(NodeId id);

    process::TermStore& terms_;
    const std::set<TermId>& leaves_;
    const std::set<TermId>& left_out_;
    bool through_prefixes_;
    diagnostics::Pollable& budget_;
    std::size_t prefixes_taken_ = 0;
    std::size_t chain_ = 0;  // number of prefixes around the current node
    Skeleton result_;
    std::map<std::pair<TermId, int>, bool> composite_;  // false also while the answer is being computed
};

/// Unfolds calls. Replaces compressions that are left out by their operands.
TermId Builder::unfold_term(TermId term) {
    for (term = terms_.unfold_calls(term, deepest_look); left_out_.contains(term);)
        term = terms_.unfold_calls(terms_[term].children.front(), deepest_look);
    return term;
}

bool Builder::is_composite(TermId id, int depth, int prefixes) {
    if (depth > deepest_look) return false;
    budget_.poll();
    id = unfold_term(id);
    if (leaves_.contains(id)) return false;
    const auto [known, fresh] = composite_.emplace(std::pair(id, prefixes), false);
    if (fresh) known->second = looks_composite(terms_[id], depth, prefixes);
    return known->second;
}

bool Builder::looks_composite(const Term& given, int depth, int prefixes) {
    const Term term = given;  // a copy, because the following calls may create terms
    const auto some_child = [&] {
        return std::ranges::any_of(term.children,
                                   [&](TermId child) { return is_composite(child, depth + 1, prefixes); });
    };
    switch (process::properties_of(term.op).group) {
        case OpGroup::parallel:
            return term.children.size() > 1;
        case OpGroup::unary:
            return term.op != Op::prioritise_order && some_child();
        case OpGroup::resolving:
        case OpGroup::internal_choice:
            return some_child();
        case OpGroup::prefix: {
            if (!through_prefixes_ || prefixes >= deepest_prefix) return false;
            const std::vector<process::Branch> branches = terms_.branches(term.payload);
            return branches.size() <= most_branches &&
                   std::ranges::any_of(branches, [&](const process::Branch& branch) {
                       return is_composite(branch.target, depth + 1, prefixes + 1);
                   });
        }
        case OpGroup::leaf:
        case OpGroup::synchronising:
        case OpGroup::compression:
            break;
    }
    return false;
}

NodeId Builder::add(Node::Kind kind, TermId term, NodeId region) {
    if (result_.nodes.size() >= most_nodes) throw NotCompiled("too many operators");
    Node node;
    node.kind = kind;
    node.op = terms_[term].op;
    node.term = term;
    node.region = region;
    node.first_slot = node.end_slot = static_cast<std::uint32_t>(result_.slots.size());
    result_.nodes.push_back(std::move(node));
    return static_cast<NodeId>(result_.nodes.size() - 1);
}

void Builder::add_leaf(NodeId id) {
    result_.slots.push_back(id);
    result_.nodes[id].end_slot = static_cast<std::uint32_t>(result_.slots.size());
}

NodeId Builder::add_node(TermId term, NodeId region, const Tail& tail, int depth) {
    budget_.poll();
    term = unfold_term(term);
    const auto same =
        std::ranges::find_if(tail.at_once, [&](NodeId around) { return result_.nodes[around].term == term; });
    if (same != tail.at_once.end()) {
        const NodeId around = *same;
        const NodeId id = add(Node::Kind::again, term, region);
        result_.nodes[id].again = around;
        return id;
    }
    const bool taken_apart = depth < deepest && is_composite(term);
    const NodeId id = add(taken_apart ? Node::Kind::operation : Node::Kind::leaf, term, region);
    if (taken_apart) {
        add_operands(id, tail, depth);
        assert(!result_.nodes[id].children.empty());
        result_.nodes[id].end_slot = static_cast<std::uint32_t>(result_.slots.size());
    } else {
        add_leaf(id);
    }
    return id;
}

void Builder::add_child(NodeId id, TermId term, const Tail& tail, int depth) {
    const bool opens_region = result_.nodes[id].op == Op::prioritise;
    const NodeId region = opens_region ? id : result_.nodes[id].region;
    const NodeId made = add_node(term, region, tail, depth + 1);
    assert(made > id);
    result_.nodes[id].children.push_back(made);
}

void Builder::add_gate(NodeId id) {
    const NodeId made = add(Node::Kind::gate, result_.nodes[id].term, result_.nodes[id].region);
    add_leaf(made);
    result_.nodes[id].children.push_back(made);
}

void Builder::add_operands(NodeId id, const Tail& tail, int depth) {
    const Term term = terms_[result_.nodes[id].term];
    // If an operand replaces this node, the node and some nodes around it end. Some end only by a visible event.
    Tail inside = tail;
    inside.at_once.push_back(id);
    inside.by_event.push_back(id);
    // An operand of a choice replaces the choice after a visible event.
    Tail chosen{{}, tail.by_event};
    chosen.by_event.push_back(id);
    switch (term.op) {
        // The first operand runs until the second one replaces it.
        case Op::sequential:
            add_child(id, term.children[0], {}, depth);
            add_child(id, term.children[1], inside, depth);
            break;
        case Op::exception:
            add_child(id, term.children[0], {}, depth);
            add_child(id, term.children[1], {inside.by_event, inside.by_event}, depth);
            break;
        case Op::sliding:
            add_gate(id);
            add_child(id, term.children[0], chosen, depth);
            add_child(id, term.children[1], inside, depth);
            break;
        case Op::external_choice:
            for (TermId child : term.children) add_child(id, child, chosen, depth);
            break;
        case Op::internal_choice:
            add_gate(id);
            for (TermId child : term.children) add_child(id, child, inside, depth);
            break;
        case Op::prefix: {
            add_gate(id);
            if (++prefixes_taken_ > most_prefixes || ++chain_ > longest_chain) throw UnfoldsOn("");
            const std::vector<process::Branch> branches = terms_.branches(term.payload);
            for (const process::Branch& branch : branches)
                add_child(id, branch.target, {inside.by_event, inside.by_event}, depth);
            --chain_;
            break;
        }
        default:
            for (TermId child : term.children) add_child(id, child, {}, depth);
    }
}

}  // namespace

std::optional<Skeleton> skeleton_of(process::TermStore& terms, TermId term, const std::set<TermId>& leaves,
                                    const std::set<TermId>& left_out, diagnostics::Pollable& budget) {
    for (const bool through_prefixes : {true, false}) {
        Builder builder(terms, leaves, left_out, through_prefixes, budget);
        if (!builder.is_composite(term)) return std::nullopt;
        try {
            return builder.build(term);
        } catch (const UnfoldsOn&) {
        }
    }
    throw std::logic_error("a skeleton without prefixes looks through them");
}

}  // namespace robochart::machine
