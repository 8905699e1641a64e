// SPDX-License-Identifier: Apache-2.0
// Writes terms for certificates. Operators that are cases of another operator are written as that operator
// (coq/Terms.v), and operators with several operands are written as trees of operators with two operands: choices and
// parallel operators are associative (Roscoe, UCS, 2.1 and 3.4). The order in which this code numbers events, sets and
// definitions determines the text, so calls that number something are never arguments of the same call.
#include "checker/certify/term_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "checker/certify/process_text.hpp"
#include "checker/process/priority_order.hpp"

namespace robochart::certify {
namespace {

using process::Event;
using process::EventSet;
using process::Op;
using process::SetId;
using process::Term;
using process::TermId;

/// Thrown if a term cannot be written. The message is the reason.
struct NotWritten {
    std::string reason;
};

/// The numbers of the entries of a table in a file, by key, in the order of their first use.
template <class Key>
class Numbering {
public:
    std::size_t number_of(const Key& key) {
        const auto [at, added] = numbers_.emplace(key, keys_.size());
        if (added) keys_.push_back(key);
        return at->second;
    }
    [[nodiscard]] bool contains(const Key& key) const { return numbers_.contains(key); }
    [[nodiscard]] const std::vector<Key>& keys() const { return keys_; }

private:
    std::map<Key, std::size_t> numbers_;
    std::vector<Key> keys_;
};

/// A set of events: the events of `set`, or those outside of it.
struct EventsInOrOut {
    SetId set;
    bool outside;
    friend auto operator<=>(const EventsInOrOut&, const EventsInOrOut&) = default;
};

EventSet difference(const EventSet& left, const EventSet& right) {
    EventSet result;
    std::ranges::set_difference(left, right, std::back_inserter(result));
    return result;
}

EventSet intersection(const EventSet& left, const EventSet& right) {
    EventSet result;
    std::ranges::set_intersection(left, right, std::back_inserter(result));
    return result;
}

class TermWriter {
public:
    TermWriter(process::TermStore& terms, const HasFewStates& has_few_states, diagnostics::Pollable& budget)
        : terms_(terms), has_few_states_(has_few_states), budget_(budget) {
        (void)events_.number_of(process::tau);   // in every file, tau has the number 0
        (void)events_.number_of(process::tick);  // and tick the number 1
    }

    std::string write(TermId root) {
        const std::string main = static_text(root, 0);
        const std::vector<TermId> leaves = definitions_.keys();
        for (std::size_t next = 0; next < definitions_.keys().size(); ++next) {
            budget_.poll();
            if (next >= most_definitions)
                throw NotWritten{fmt::format("there are more than {} definitions", most_definitions)};
            add_definition(definitions_.keys()[next]);
        }
        if (has_inner_parallel_)
            for (const TermId leaf : leaves)
                if (!has_few_states_(leaf))
                    throw NotWritten{fmt::format("a component with parallel operators has more than {} states",
                                                 most_explicit_states)};
        add_renamed_events();
        return "robochart-verify term 1\n" + events_text() + sets_text() + renamings_text() + orders_text() +
               fmt::format("definitions {}\n{}main {}\nend\n", definitions_.keys().size(), definitions_text_, main);
    }

private:
    using OperandText = std::function<std::string(TermId)>;

    /// Follows calls and the compressions that preserve the meaning of their operand.
    TermId resolve(TermId id) {
        constexpr int most_unfolded = 1000;
        for (int i = 0; i < most_unfolded; ++i) {
            const Term& term = terms_[id];
            if (term.op == Op::call) {
                const std::uint32_t call = term.payload;
                const TermId body = terms_.unfold(call);
                texts_.emplace(body, call);
                id = body;
            } else if (term.op == Op::compress) {
                require_known_compression(term);
                id = term.children.front();
            } else {
                return id;
            }
        }
        throw NotWritten{"a recursion reaches no event"};
    }
    static void require_known_compression(const Term& term) {
        switch (process::Compression{term.payload}) {
            case process::Compression::deter:
            case process::Compression::trace_watchdog:
            case process::Compression::failure_watchdog:
                throw NotWritten{"a compression does not preserve the meaning of its operand"};
            default:
                return;
        }
    }

    /// Returns the text of an operator that stays, with its operands in place; other terms become definitions.
    std::string static_text(TermId unresolved, int depth) {
        constexpr int deepest = 1000;
        constexpr std::size_t most_operators = 100'000;
        if (depth > deepest || ++static_operators_ > most_operators)
            throw NotWritten{"there are too many parallel components"};
        const TermId id = resolve(unresolved);
        switch (terms_[id].op) {
            case Op::parallel:
            case Op::alphabetised:
            case Op::hide:
            case Op::rename:
            case Op::prioritise:
                return operator_text(id, [this, depth](TermId operand) { return static_text(operand, depth + 1); });
            default:
                return std::to_string(definitions_.number_of(id));
        }
    }
    std::string definition_number(TermId id) { return std::to_string(definitions_.number_of(resolve(id))); }

    void add_definition(TermId id) {
        const Op op = terms_[id].op;
        if (op == Op::parallel || op == Op::alphabetised) has_inner_parallel_ = true;
        definitions_text_ += operator_text(id, [this](TermId operand) { return definition_number(operand); });
        const auto call = texts_.find(id);
        if (call != texts_.end()) {
            constexpr std::size_t longest = 60;
            const std::string text = one_line(terms_.definitions().describe_call(call->second));
            if (text.size() <= longest) definitions_text_ += " #" + text;
        }
        definitions_text_ += '\n';
    }

    /// Returns the text of a term that is neither a call nor a compression.
    std::string operator_text(TermId id, const OperandText& operand) {
        const Term term = terms_[id];  // a copy, because the evaluation of operands adds terms
        const auto with_two = [&](const std::string& name) {
            const std::string first = operand(term.children[0]);
            return fmt::format("{} {} {}", name, first, operand(term.children[1]));
        };
        const auto with_one = [&](const char* name, const std::string& table_entry) {
            return fmt::format("{} {} {}", name, table_entry, operand(term.children[0]));
        };
        switch (term.op) {
            case Op::stop:
            case Op::omega:
                return "offer 0";
            case Op::skip:
                return "offer 1 1 " + stop_number();
            case Op::div:
                return "offer 1 0 " + std::to_string(definitions_.number_of(id));
            case Op::run:
                return offer_of_set(SetId{term.payload}, id);
            case Op::chaos:
                return chaos_text(term.payload);
            case Op::chaos_offer:
                return offer_of_set(SetId{term.payload}, terms_.intern_term(Term{Op::chaos, term.payload, {}, {}}));
            case Op::prefix:
                return prefix_text(term.payload, operand);
            case Op::internal_choice: {
                std::string text = fmt::format("offer {}", term.children.size());
                for (const TermId child : term.children) text += " 0 " + operand(child);
                return text;
            }
            case Op::external_choice:
                return joined("choice " + set_number({terms_.intern_set({}), false}), term.children, operand);
            case Op::sync_choice:
                return joined("choice " + set_number({SetId{term.payload}, false}), term.children, operand);
            case Op::sliding:
                return with_two("sliding");
            case Op::sequential:
                return with_two("sequence");
            case Op::interrupt:
                return with_two("interrupt " + set_number({terms_.intern_set({}), false}));
            case Op::sync_interrupt:
                return with_two("interrupt " + set_number({SetId{term.payload}, false}));
            case Op::exception:
                return with_two("throw " + set_number({SetId{term.payload}, false}));
            case Op::parallel: {
                const SetId set{term.payload};
                const std::string alone = set_number({set, true});
                return joined(fmt::format("parallel {} {} {}", alone, alone, set_number({set, false})), term.children,
                              operand);
            }
            case Op::alphabetised:
                return alphabetised_text(term, operand);
            case Op::hide:
                return with_one("hide", set_number({SetId{term.payload}, false}));
            case Op::rename:
                return with_one("rename", std::to_string(renamings_.number_of(process::RenamingId{term.payload})));
            case Op::prioritise:
                return with_one("prioritise", std::to_string(orders_.number_of(process::OrderId{term.payload})));
            case Op::prioritise_order:
                throw NotWritten{"it uses prioritisepo"};
            case Op::chase:
                throw NotWritten{"it uses chase"};
            case Op::call:
            case Op::compress:
            case Op::machine:
                break;
        }
        throw std::logic_error("a term that is not resolved");
    }

    std::string chaos_text(std::uint32_t set) {
        const std::string stop = stop_number();
        const TermId offering = terms_.intern_term(Term{Op::chaos_offer, set, {}, {}});
        return fmt::format("offer 2 0 {} 0 {}", stop, definition_number(offering));
    }
    std::string stop_number() { return definition_number(terms_.intern_term(Term{Op::stop, 0, {}, {}})); }

    std::string offer_of_set(SetId set, TermId target) {
        const EventSet events = terms_[set];
        std::string text = fmt::format("offer {}", events.size());
        for (const Event event : events) {
            const std::size_t number = events_.number_of(event);
            const std::string after = event == process::tick ? stop_number() : definition_number(target);
            text += fmt::format(" {} {}", number, after);
        }
        return text;
    }
    std::string prefix_text(std::uint32_t prefix, const OperandText& operand) {
        const std::vector<process::Branch> branches = terms_.branches(prefix);
        std::string text = fmt::format("offer {}", branches.size());
        for (const process::Branch& branch : branches) {
            const std::size_t number = events_.number_of(branch.event);
            text += fmt::format(" {} {}", number, operand(branch.target));
        }
        return text;
    }

    /// Joins operands by an operator with two operands, as a balanced tree.
    std::string joined(const std::string& name, const std::vector<TermId>& operands, const OperandText& operand) {
        if (operands.empty()) throw NotWritten{"an operator has no operands"};
        const std::function<std::string(std::size_t, std::size_t)> join = [&](std::size_t begin, std::size_t end) {
            if (end - begin == 1) return operand(operands[begin]);
            const std::size_t middle = begin + (end - begin) / 2;
            const std::string first = join(begin, middle);
            return fmt::format("{} {} {}", name, first, join(middle, end));
        };
        return join(0, operands.size());
    }

    /// Returns the alphabetised parallel as a balanced tree. The alphabet of a group is the union of its alphabets.
    std::string alphabetised_text(const Term& term, const OperandText& operand) {
        if (term.children.empty()) throw NotWritten{"an operator has no operands"};
        struct Group {
            std::string text;
            EventSet alphabet;
        };
        const auto set = [this](const EventSet& events) { return set_number({terms_.intern_set(events), false}); };
        const std::function<Group(std::size_t, std::size_t)> join = [&](std::size_t begin, std::size_t end) -> Group {
            if (end - begin == 1) return {operand(term.children[begin]), terms_[term.sets[begin]]};
            const std::size_t middle = begin + (end - begin) / 2;
            const Group left = join(begin, middle);
            const Group right = join(middle, end);
            Group both;
            std::ranges::set_union(left.alphabet, right.alphabet, std::back_inserter(both.alphabet));
            const std::string of_left = set(difference(left.alphabet, right.alphabet));
            const std::string of_right = set(difference(right.alphabet, left.alphabet));
            const std::string shared = set(intersection(left.alphabet, right.alphabet));
            both.text = fmt::format("parallel {} {} {} {} {}", of_left, of_right, shared, left.text, right.text);
            return both;
        };
        const Group all = join(0, term.children.size());
        if (term.children.size() > 1) return all.text;
        // One operand performs only events of its alphabet, beside a process that can only terminate.
        const std::string alone = set(all.alphabet);
        const std::string none = set({});
        return fmt::format("parallel {} {} {} {} {}", alone, none, none, all.text,
                           operand(terms_.intern_term(Term{Op::skip, 0, {}, {}})));
    }

    /// Numbers the events to which a renaming changes an event with a number.
    void add_renamed_events() {
        std::size_t before = 0;
        do {
            before = events_.keys().size();
            for (const process::RenamingId renaming : renamings_.keys())
                for (const auto& [from, to] : terms_[renaming])
                    if (events_.contains(from)) (void)events_.number_of(to);
        } while (events_.keys().size() != before);
    }

    std::string set_number(const EventsInOrOut& set) { return std::to_string(sets_.number_of(set)); }

    std::string events_text() {
        std::string text = fmt::format("events {}\n", events_.keys().size() - process::first_visible);
        for (const Event event : events_.keys())
            if (event >= process::first_visible) text += one_line(terms_.events().name(event)) + "\n";
        return text;
    }
    /// Writes only events with a number, because no term performs another event.
    std::string sets_text() {
        std::string text = fmt::format("sets {}\n", sets_.keys().size());
        for (const EventsInOrOut& set : sets_.keys()) {
            text += set.outside ? '-' : '+';
            for (const Event event : terms_[set.set])
                if (event >= process::first_visible && events_.contains(event))
                    text += fmt::format(" {}", events_.number_of(event));
            text += '\n';
        }
        return text;
    }
    std::string renamings_text() {
        std::string text = fmt::format("renamings {}\n", renamings_.keys().size());
        for (const process::RenamingId renaming : renamings_.keys()) {
            std::string line;
            for (const auto& [from, to] : terms_[renaming])
                if (events_.contains(from))
                    line += fmt::format(" {} {}", events_.number_of(from), events_.number_of(to));
            text += (line.empty() ? line : line.substr(1)) + "\n";
        }
        return text;
    }
    std::string orders_text() {
        std::string text = fmt::format("orders {}\n", orders_.keys().size());
        for (const process::OrderId order : orders_.keys()) {
            const std::vector<std::uint32_t> levels = process::levels_of(terms_[order]);
            std::string line;
            for (Event event = process::first_visible; event < levels.size(); ++event)
                if (levels[event] != process::no_level && events_.contains(event))
                    line += fmt::format(" {} {}", events_.number_of(event), levels[event]);
            text += (line.empty() ? line : line.substr(1)) + "\n";
        }
        return text;
    }

    process::TermStore& terms_;
    const HasFewStates& has_few_states_;
    diagnostics::Pollable& budget_;
    Numbering<Event> events_;
    Numbering<EventsInOrOut> sets_;
    Numbering<process::RenamingId> renamings_;
    Numbering<process::OrderId> orders_;
    Numbering<TermId> definitions_;
    std::map<TermId, std::uint32_t> texts_;  // by body: a call that unfolds to it
    std::string definitions_text_;
    std::size_t static_operators_ = 0;
    bool has_inner_parallel_ = false;
};

}  // namespace

TermText term_text(process::TermStore& terms, process::TermId term, const HasFewStates& has_few_states,
                   diagnostics::Pollable& budget) {
    try {
        return {TermWriter(terms, has_few_states, budget).write(term), ""};
    } catch (const NotWritten& cause) {
        return {std::nullopt, cause.reason};
    }
}

}  // namespace robochart::certify
