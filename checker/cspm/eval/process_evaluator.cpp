// SPDX-License-Identifier: Apache-2.0
// Implements the two functions that a search calls. They return the body of a call and the branches of a prefix.
#include "checker/cspm/eval/process_evaluator.hpp"

#include <algorithm>

#include "checker/cspm/types/deep_stack.hpp"

namespace robochart::cspm {

process::TermId ProcessEvaluator::unfold(std::uint32_t call) {
    process::TermId result{};
    on_deep_stack([&] {
        const Work::Question question(work_);
        const Value key = processes_.call_key(call);
        const Value function = key->items[0];
        Values arguments(key->items.begin() + 1, key->items.end());
        if (function->kind == Kind::builtin) {  // loop(P) = P; loop(P)
            const process::TermId body = processes_.term_of(arguments.at(0), {});
            result = processes_.make_term(process::Op::sequential, {body, processes_.make_call(function, arguments)});
            return;
        }
        const Function& definition = *function->function;
        const Work::Calling calling(work_, definition, arguments, definition.span);
        Frame frame;
        Values all(function->items.begin() + static_cast<std::ptrdiff_t>(definition.environment),
                   function->items.end());
        all.insert(all.end(), arguments.begin(), arguments.end());
        const FunctionClause& clause = values_.choose_clause(definition, function->items, all, frame, definition.span);
        result = process(*clause.body, frame);
    });
    return result;
}

std::vector<process::Branch> ProcessEvaluator::branches(std::uint32_t prefix) {
    std::vector<process::Branch> result;
    on_deep_stack([&] {
        const Work::Question question(work_);
        const auto [kind, key] = processes_.prefix_key(prefix);
        const auto self = processes_.make_term(process::Op::prefix, {}, prefix);
        switch (kind) {
            case PrefixKind::script:
                result = script_branches(key);
                break;
            case PrefixKind::chosen:
                result = chosen_branches(key);
                break;
            case PrefixKind::waiting: {
                const auto tock = static_cast<process::Event>(key->items[0]->number);
                const process::TermId then = processes_.term_of(key->items[2], {});
                result = {{tock, processes_.make_wait(tock, key->items[1]->number - 1, then)}};
                break;
            }
            case PrefixKind::stopped:  // STOP in a timed section lets time pass
                result = {{static_cast<process::Event>(key->items[0]->number), self}};
                break;
            case PrefixKind::skipping:  // SKIP in a timed section is SKIP [] tock -> itself
                result = {{static_cast<process::Event>(key->items[0]->number),
                           processes_.make_term(process::Op::external_choice,
                                                {self, processes_.make_term(process::Op::skip)})}};
                break;
            case PrefixKind::buffer:
                result = buffer_branches(key);
                break;
        }
        // A prefix in a timed section lets time pass (semantics 3.10).
        if (kind == PrefixKind::script) {
            const Code& code = *program_.prefixes[static_cast<std::size_t>(key->items[0]->number)];
            if (code.timed != nullptr) result.push_back({processes_.tock_event(*code.timed), self});
        }
    });
    return result;
}

std::string ProcessEvaluator::describe_call(std::uint32_t call) const {
    const Value key = processes_.call_key(call);
    std::string result = text_(key->items[0]);
    if (key->items.size() == 1) return result;
    const Function* const definition = key->items[0]->function;
    for (std::size_t i = 1; i < key->items.size(); ++i) {
        result += i == 1 ? "(" : ",";
        const bool unread = definition != nullptr && i <= definition->unread.size() && definition->unread[i - 1];
        result += unread ? "_" : text_(key->items[i]);  // the value of this argument has no effect (process_terms.cpp)
    }
    return result + ")";
}

}  // namespace robochart::cspm
