// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/eval/evaluator.hpp"

#include <algorithm>

#include "checker/cspm/eval/process_evaluator.hpp"
#include "checker/cspm/types/deep_stack.hpp"

namespace robochart::cspm {

Evaluator::Evaluator(Program& program, ValueStore& store, process::EventTable& events, process::TermStore& terms)
    : program_(program),
      store_(store),
      terms_(terms),
      text_(program),
      work_(program, store),
      shape_(program),
      domains_(program, store, events, work_,
               [this](const Code& type, const Unit& unit) {
                   Frame frame(static_cast<std::size_t>(unit.size), nullptr);
                   return share_value(eval(type, frame));
               }),
      processes_(store, events, terms, domains_, work_, program),
      builtins_(program, store, events, terms, work_, domains_, processes_),
      by_need_(*this, {program, store, work_, domains_, builtins_}),
      process_evaluator_(std::make_unique<ProcessEvaluator>(
          *this, ProcessEvaluator::Tables{program, store, terms, work_, domains_, processes_, shape_})) {
    store_.list_sets_by(
        [this](Value set) { return domains_.can_be_listed(set, {}) ? domains_.explicit_set(set, {}) : set; });
}

Evaluator::~Evaluator() {
    store_.list_sets_by({});
}

std::string Evaluator::print(const Code& code, const Unit& unit) {
    std::string result;
    on_deep_stack([&] {
        const Work::Question question(work_);
        Frame frame(static_cast<std::size_t>(unit.size), nullptr);
        result = text_.full_text(share_value(eval(code, frame)));
    });
    return result;
}

process::TermId Evaluator::process(const Code& code, const Unit& unit) {
    process::TermId result{};
    on_deep_stack([&] {
        const Work::Question question(work_);
        Frame frame(static_cast<std::size_t>(unit.size), nullptr);
        result = process_evaluator_->process(code, frame);
    });
    return result;
}

process::EventSet Evaluator::event_set(const Code& code, const Unit& unit) {
    process::EventSet result;
    on_deep_stack([&] {
        const Work::Question question(work_);
        Frame frame(static_cast<std::size_t>(unit.size), nullptr);
        const Value value = share_value(eval(code, frame));
        if (is_set(value))
            result = domains_.event_set(value, code.span);
        else
            result = {domains_.event_of(value, code.span)};
    });
    return result;
}

std::optional<process::EventSet> Evaluator::all_events(std::uint64_t most) {
    std::optional<process::EventSet> result;
    on_deep_stack([&] {
        const Work::Question question(work_);
        if (domains_.number_of_events() <= most) result = domains_.event_set(domains_.all_events(), {});
    });
    return result;
}

std::vector<process::Event> Evaluator::trace(const Code& code, const Unit& unit) {
    std::vector<process::Event> result;
    on_deep_stack([&] {
        const Work::Question question(work_);
        Frame frame(static_cast<std::size_t>(unit.size), nullptr);
        for (const Value event : by_need_.sequence(share_value(eval(code, frame)), code.span))
            result.push_back(domains_.event_of(event, code.span));
    });
    return result;
}

process::TermId Evaluator::tau_priority(process::TermId term, process::EventSet over) {
    const process::OrderId order = terms_.intern_order({{}, std::move(over)});
    return processes_.make_term(process::Op::prioritise, {term}, static_cast<std::uint32_t>(order));
}

}  // namespace robochart::cspm
