// SPDX-License-Identifier: Apache-2.0
// Implements the firing rules on trees independently, with one short function for each rule, and explores the resulting
// graph.
#include <algorithm>
#include <deque>

#include "naive.hpp"

namespace robochart::refine::naive {
namespace {

struct Move {
    Letter letter;
    Process target;
};
using Moves = std::vector<Move>;

const Process omega = std::make_shared<const Tree>(Tree{Kind::omega, {}, {}, {}, {}, {}, 0});
const Process stop = std::make_shared<const Tree>();

Process replace_operand(const Process& process, std::size_t position, const Process& operand) {
    Tree tree = *process;
    tree.operands[position] = operand;
    return std::make_shared<const Tree>(std::move(tree));
}

class Rules {
public:
    explicit Rules(const Script& script) : script_(script) {}

    /// Returns the moves in the order in which chase chooses: taus first, then by letter, then by operand.
    Moves moves(const Process& p) const {
        Moves result = fire(p);
        const auto rank = [](Letter letter) {
            if (letter == tau) return -2;
            if (letter == tick) return -1;
            return static_cast<int>(letter);
        };
        std::ranges::stable_sort(result, [&](const Move& x, const Move& y) { return rank(x.letter) < rank(y.letter); });
        return result;
    }

private:
    Moves fire(const Process& p) const {
        switch (p->kind) {
            case Kind::stop:
            case Kind::omega:
                return {};
            case Kind::skip:
                return {{tick, omega}};
            case Kind::div:
                return {{tau, p}};
            case Kind::run:
                return offer_letters(p, p);
            case Kind::chaos:
                return chaos(p);
            case Kind::call:
                return moves(script_.definitions[static_cast<std::size_t>(p->name)]);
            case Kind::prefix:
                return prefix(p);
            case Kind::external:
                return external(p);
            case Kind::internal:
                return internal_moves(p);
            case Kind::sequential:
                return sequential(p);
            case Kind::interrupt:
                return interrupt(p, false);
            case Kind::sync_interrupt:
                return interrupt(p, true);
            case Kind::sliding:
                return sliding(p);
            case Kind::exception:
                return exception(p);
            case Kind::sync_external:
                return sync_external(p);
            case Kind::parallel:
                return parallel(p);
            case Kind::alphabetised:
                return alphabetised(p);
            case Kind::linked:
                return linked(p);
            case Kind::hide:
            case Kind::project:
                return hide(p);
            case Kind::rename:
                return rename(p);
            case Kind::prioritise:
                return prioritise(p, above);
            case Kind::prioritise_order:
                return prioritise(p, above_in_order);
            case Kind::chase:
                return chase(p);
            case Kind::compress:
                return moves(p->operands[0]);
        }
        return {};
    }
    static Moves offer_letters(const Process& p, const Process& target) {
        Moves result;
        for (Letter l : p->set) result.push_back({l, target});
        return result;
    }
    static Moves chaos(const Process& p) {
        Tree offering{Kind::prefix, {}, {}, {}, {}, {}, 0};
        for (Letter l : p->set) {
            offering.letters.push_back(l);
            offering.operands.push_back(p);
        }
        return {{tau, stop}, {tau, std::make_shared<const Tree>(offering)}};
    }
    static Moves prefix(const Process& p) {
        Moves result;
        for (std::size_t i = 0; i < p->letters.size(); ++i) result.push_back({p->letters[i], p->operands[i]});
        return result;
    }
    Moves external(const Process& p) const {
        Moves result;
        for (std::size_t i = 0; i < p->operands.size(); ++i)
            for (const Move& m : moves(p->operands[i]))
                result.push_back({m.letter, m.letter == tau ? replace_operand(p, i, m.target) : m.target});
        return result;
    }
    static Moves internal_moves(const Process& p) {
        Moves result;
        for (const Process& operand : p->operands) result.push_back({tau, operand});
        return result;
    }
    Moves sequential(const Process& p) const {
        Moves result;
        for (const Move& m : moves(p->operands[0])) {
            if (m.letter == tick)
                result.push_back({tau, p->operands[1]});
            else
                result.push_back({m.letter, replace_operand(p, 0, m.target)});
        }
        return result;
    }
    Moves interrupt(const Process& p, bool synchronising) const {
        const auto shared = [&](Letter l) { return synchronising && p->set.contains(l); };
        Moves result;
        const Moves left = moves(p->operands[0]);
        const Moves right = moves(p->operands[1]);
        for (const Move& m : left)
            if (!shared(m.letter))
                result.push_back({m.letter, m.letter == tick ? omega : replace_operand(p, 0, m.target)});
        for (const Move& m : right)
            if (!shared(m.letter))
                result.push_back({m.letter, m.letter == tau ? replace_operand(p, 1, m.target) : m.target});
        for (const Move& l : left)
            for (const Move& r : right)
                if (l.letter == r.letter && shared(l.letter))
                    result.push_back({l.letter, replace_operand(replace_operand(p, 0, l.target), 1, r.target)});
        return result;
    }
    Moves sliding(const Process& p) const {
        Moves result;
        for (const Move& m : moves(p->operands[0]))
            result.push_back({m.letter, m.letter == tau ? replace_operand(p, 0, m.target) : m.target});
        result.push_back({tau, p->operands[1]});
        return result;
    }
    Moves exception(const Process& p) const {
        Moves result;
        for (const Move& m : moves(p->operands[0])) {
            if (m.letter == tick)
                result.push_back(m);
            else if (p->set.contains(m.letter))
                result.push_back({m.letter, p->operands[1]});
            else
                result.push_back({m.letter, replace_operand(p, 0, m.target)});
        }
        return result;
    }
    /// Returns all ways in which the given operands perform the letter together.
    Moves together(const Process& p, const std::vector<std::size_t>& operands, Letter letter) const {
        std::vector<Process> partial{p};
        for (std::size_t i : operands) {
            std::vector<Process> extended;
            for (const Process& before : partial)
                for (const Move& m : moves(p->operands[i]))
                    if (m.letter == letter) extended.push_back(replace_operand(before, i, m.target));
            partial = extended;
        }
        Moves result;
        for (const Process& target : partial) result.push_back({letter, letter == tick ? omega : target});
        return result;
    }
    static std::vector<std::size_t> everyone(const Process& p) {
        std::vector<std::size_t> all;
        for (std::size_t i = 0; i < p->operands.size(); ++i) all.push_back(i);
        return all;
    }
    Moves sync_external(const Process& p) const {
        Moves result;
        for (std::size_t i = 0; i < p->operands.size(); ++i)
            for (const Move& m : moves(p->operands[i])) {
                if (m.letter == tau)
                    result.push_back({tau, replace_operand(p, i, m.target)});
                else if (!p->set.contains(m.letter))
                    result.push_back(m);
            }
        for (Letter l : p->set) append(result, together(p, everyone(p), l));
        return result;
    }
    Moves parallel(const Process& p) const {
        Moves result;
        for (std::size_t i = 0; i < p->operands.size(); ++i)
            for (const Move& m : moves(p->operands[i]))
                if (m.letter != tick && !p->set.contains(m.letter))
                    result.push_back({m.letter, replace_operand(p, i, m.target)});
        for (Letter l : p->set) append(result, together(p, everyone(p), l));
        append(result, together(p, everyone(p), tick));
        return result;
    }
    Moves alphabetised(const Process& p) const {
        Moves result = together(p, everyone(p), tick);
        std::set<Letter> all;
        for (std::size_t i = 0; i < p->operands.size(); ++i) {
            all.insert(p->sets[i].begin(), p->sets[i].end());
            for (const Move& m : moves(p->operands[i]))
                if (m.letter == tau) result.push_back({tau, replace_operand(p, i, m.target)});
        }
        for (Letter l : all) {
            std::vector<std::size_t> concerned;
            for (std::size_t i = 0; i < p->operands.size(); ++i)
                if (p->sets[i].contains(l)) concerned.push_back(i);
            append(result, together(p, concerned, l));
        }
        return result;
    }
    /// Returns the moves of two linked operands. A linked event of one operand occurs only together with its partner of
    /// the other operand, and is hidden. Other events are independent.
    Moves linked(const Process& p) const {
        const Moves left = moves(p->operands[0]);
        const Moves right = moves(p->operands[1]);
        Moves result = together(p, everyone(p), tick);
        const auto free = [&](Letter l, bool first) {
            return l != tick && std::ranges::none_of(p->renaming, [&](const auto& link) {
                       return l == (first ? link.first : link.second);
                   });
        };
        for (const Move& m : left)
            if (free(m.letter, true)) result.push_back({m.letter, replace_operand(p, 0, m.target)});
        for (const Move& m : right)
            if (free(m.letter, false)) result.push_back({m.letter, replace_operand(p, 1, m.target)});
        for (const auto& [one, other] : p->renaming)
            for (const Move& l : left)
                for (const Move& r : right)
                    if (l.letter == one && r.letter == other)
                        result.push_back({tau, replace_operand(replace_operand(p, 0, l.target), 1, r.target)});
        return result;
    }
    Moves hide(const Process& p) const {
        Moves result;
        for (const Move& m : moves(p->operands[0])) {
            const bool hidden = m.letter >= 0 && p->set.contains(m.letter) == (p->kind == Kind::hide);
            result.push_back({hidden ? tau : m.letter, m.letter == tick ? omega : replace_operand(p, 0, m.target)});
        }
        return result;
    }
    Moves rename(const Process& p) const {
        Moves result;
        for (const Move& m : moves(p->operands[0])) {
            bool mentioned = false;
            for (const auto& [from, to] : p->renaming)
                if (m.letter == from) {
                    mentioned = true;
                    result.push_back({to, replace_operand(p, 0, m.target)});
                }
            if (!mentioned) result.push_back({m.letter, m.letter == tick ? omega : replace_operand(p, 0, m.target)});
        }
        return result;
    }
    static bool above(const Process& p, Letter high, Letter low) {
        const auto level = [&](Letter l) {
            if (l == tau || l == tick) return 0;
            for (std::size_t i = 0; i < p->sets.size(); ++i)
                if (p->sets[i].contains(l)) return static_cast<int>(i);
            return -1;
        };
        return level(high) >= 0 && level(low) >= 0 && level(high) < level(low);
    }
    /// Returns whether prioritisepo puts `high` above `low`, by a chain of pairs. Tau and tick are above all events in
    /// the order except the maximal ones.
    static bool above_in_order(const Process& p, Letter high, Letter low) {
        std::set<Letter> lower{high};
        for (std::size_t round = 0; round <= p->renaming.size(); ++round)
            for (const auto& [more, less] : p->renaming)
                if (lower.contains(more)) lower.insert(less);
        if (high < 0) return p->set.contains(low) && !p->sets[0].contains(low);
        return low != high && lower.contains(low);
    }
    using Above = bool (*)(const Process&, Letter, Letter);
    Moves prioritise(const Process& p, Above higher) const {
        const Moves all = moves(p->operands[0]);
        Moves result;
        for (const Move& m : all) {
            const bool cut = std::ranges::any_of(all, [&](const Move& o) { return higher(p, o.letter, m.letter); });
            if (!cut) result.push_back({m.letter, m.letter == tick ? omega : replace_operand(p, 0, m.target)});
        }
        return result;
    }
    Moves chase(const Process& p) const;

    static void append(Moves& to, const Moves& more) { to.insert(to.end(), more.begin(), more.end()); }

    const Script& script_;
};

Moves Rules::chase(const Process& p) const {
    Process at = p->operands[0];
    std::set<std::string> passed;
    for (;;) {
        const Moves all = moves(at);
        const auto first = std::ranges::find_if(all, [](const Move& m) { return m.letter == tau; });
        if (first == all.end()) break;
        if (!passed.insert(show(at)).second) return {{tau, replace_operand(p, 0, at)}};
        at = first->target;
    }
    Moves result;
    for (const Move& m : moves(at))
        result.push_back({m.letter, m.letter == tick ? omega : replace_operand(p, 0, m.target)});
    return result;
}

}  // namespace

std::optional<Graph> explore(const Script& script, const Process& process, std::size_t limit) {
    constexpr std::size_t longest_state = 500;
    const Rules rules(script);
    Graph graph;
    std::map<std::string, int> numbers;
    std::deque<Process> work;
    const auto number = [&](const Process& state) {
        const auto [entry, fresh] = numbers.emplace(show(state), static_cast<int>(numbers.size()));
        if (fresh) work.push_back(state);
        return entry->second;
    };
    number(process);
    while (!work.empty()) {
        const Process state = work.front();
        work.pop_front();
        if (numbers.size() > limit || show(state).size() > longest_state) return std::nullopt;
        graph.edges.emplace_back();
        for (const Move& m : rules.moves(state)) {
            const int target = number(m.target);
            graph.edges.back().push_back({m.letter, target});
        }
    }
    return graph;
}

}  // namespace robochart::refine::naive
