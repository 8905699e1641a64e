// SPDX-License-Identifier: Apache-2.0
// Implements Definitions for tests, with prefixes and named processes that are built by hand.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "checker/process/term.hpp"

namespace robochart::process {

/// Builds terms by operator names. Recursion uses named processes.
class Scripted final : public Definitions {
public:
    Scripted() { store.define(*this); }

    EventTable events;
    TermStore store{events};

    Event event(const std::string& name) { return events.intern(name); }
    SetId set(const std::vector<std::string>& names) {
        EventSet members;
        for (const std::string& name : names) members.push_back(event(name));
        return store.intern_set(members);
    }

    /// Declares a named process, whose body bind() defines.
    TermId name(const std::string& text) {
        names_.push_back(text);
        bodies_.push_back(TermId{0});
        return op(Op::call, {}, static_cast<std::uint32_t>(names_.size() - 1));
    }
    void bind(TermId named, TermId body) { bodies_[store[named].payload] = body; }

    TermId prefix(const std::string& event_name, TermId target) { return menu({{event_name, target}}); }
    /// Returns a prefix with several branches.
    TermId menu(const std::vector<std::pair<std::string, TermId>>& branches) {
        std::vector<Branch> list;
        for (const auto& [event_name, target] : branches) list.push_back({event(event_name), target});
        return branches_of(std::move(list));
    }
    TermId branches_of(std::vector<Branch> list) {
        prefixes_.push_back(std::move(list));
        return op(Op::prefix, {}, static_cast<std::uint32_t>(prefixes_.size() - 1));
    }

    /// Returns a process that performs the events in turn, repeatedly.
    TermId cycle(const std::string& named, const std::vector<std::string>& event_names) {
        const TermId again = name(named);
        TermId rest = again;
        for (auto event_name = event_names.rbegin(); event_name != event_names.rend(); ++event_name)
            rest = prefix(*event_name, rest);
        bind(again, rest);
        return again;
    }

    TermId op(Op kind, std::vector<TermId> children = {}, std::uint32_t payload = 0, std::vector<SetId> sets = {}) {
        return store.intern_term(Term{kind, payload, std::move(children), std::move(sets)});
    }
    TermId over(Op kind, std::vector<TermId> children, const std::vector<std::string>& names) {
        return op(kind, std::move(children), static_cast<std::uint32_t>(set(names)));
    }
    TermId stop() { return op(Op::stop); }
    TermId skip() { return op(Op::skip); }
    TermId rename(TermId child, const std::vector<std::pair<std::string, std::string>>& pairs) {
        Renaming renaming;
        for (const auto& [from, to] : pairs) renaming.emplace_back(event(from), event(to));
        return op(Op::rename, {child}, static_cast<std::uint32_t>(store.intern_renaming(renaming)));
    }
    TermId prioritise(TermId child, const std::vector<std::vector<std::string>>& levels) {
        PriorityOrder order;
        for (const auto& level : levels) order.push_back(store[set(level)]);
        return op(Op::prioritise, {child}, static_cast<std::uint32_t>(store.intern_order(order)));
    }

    TermId unfold(std::uint32_t call) override {
        ++unfoldings;
        return bodies_.at(call);
    }
    std::vector<Branch> branches(std::uint32_t prefix) override { return prefixes_.at(prefix); }
    [[nodiscard]] std::string describe_call(std::uint32_t call) const override { return names_.at(call); }

    int unfoldings = 0;

private:
    std::vector<std::string> names_;
    std::vector<TermId> bodies_;
    std::vector<std::vector<Branch>> prefixes_;
};

}  // namespace robochart::process
