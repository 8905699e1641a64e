#include "checker/cspm/eval/evaluator.hpp"

#include <algorithm>

#include "checker/cspm/types/deep_stack.hpp"
#include "checker/cspm/eval/evaluator_internal.hpp"

namespace robochart::cspm {

Evaluator::Evaluator(Program& program, ValueStore& store, process::EventTable& events, process::TermStore& terms)
    : program_(program), store_(store), events_(events), terms_(terms) {
    terms_.define(*this);
}

void Evaluator::fail(const std::string& message, Span span) const {
    constexpr std::size_t shown = 30;
    std::vector<std::string> stack;
    if (given_up_at_ != no_end) throw EvaluationError(message, span, {});  // may never be seen
    for (auto call = activations_.rbegin(); call != activations_.rend() && stack.size() < shown; ++call) {
        std::string line = call->function->name;
        if (call->arguments != nullptr && !call->arguments->empty()) {
            print_items(*call->arguments, "(", ", ", ")", line);
        }
        stack.push_back(std::move(line));
    }
    if (!span.known()) span = activations_.empty() ? prefix_place_ : activations_.back().function->span;
    for (auto call = activations_.rbegin(); call != activations_.rend() && !span.known(); ++call)
        span = call->called.known() ? call->called : call->function->span;
    throw EvaluationError(message, span, std::move(stack));
}

void Evaluator::not_supported(const std::string& what, Span span) const {
    fail(what + " is not supported", span);
}

// A question from outside. What was made for the moment goes when the outermost one is answered.
class Evaluator::Entry {
public:
    explicit Entry(Evaluator& evaluator) : evaluator_(evaluator), base_(evaluator.stack_base_) {
        if (evaluator_.entries_++ == 0) {
            evaluator_.steps_ = 0;
            ++evaluator_.entry_number_;
        }
        if (base_ == nullptr) evaluator_.stack_base_ = static_cast<const char*>(__builtin_frame_address(0));
        calls_ = evaluator_.activations_.size();
    }
    ~Entry() {
        evaluator_.stack_base_ = base_;
        evaluator_.activations_.resize(calls_);
        if (--evaluator_.entries_ == 0) evaluator_.store_.release();
    }
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;

private:
    Evaluator& evaluator_;
    const char* base_;
    std::size_t calls_ = 0;
};

void Evaluator::count_step(Span span) {
    if (++steps_ > max_steps) fail("evaluation takes too long (2000000000 steps): runaway recursion?", span);
    if ((steps_ & 255U) == 0 && poll_) poll_();
    if (steps_ > given_up_at_) throw GivenUp{};
    const char* here = static_cast<const char*>(__builtin_frame_address(0));
    if (static_cast<std::size_t>(stack_base_ - here) > deep_stack_bytes / 4 * 3) {
        fail("evaluation nests too deeply: runaway recursion?", span);
    }
}

std::string Evaluator::print(const Code& code, const Unit& unit) {
    std::string result;
    on_deep_stack([&] {
        const Entry entry(*this);
        Frame frame(static_cast<std::size_t>(unit.size), nullptr);
        result = text(share(eval(code, frame)));
    });
    return result;
}

process::TermId Evaluator::process(const Code& code, const Unit& unit) {
    process::TermId result{};
    on_deep_stack([&] {
        const Entry entry(*this);
        Frame frame(static_cast<std::size_t>(unit.size), nullptr);
        result = process(code, frame);
    });
    return result;
}

process::EventSet Evaluator::event_set(const Code& code, const Unit& unit) {
    process::EventSet result;
    on_deep_stack([&] {
        const Entry entry(*this);
        Frame frame(static_cast<std::size_t>(unit.size), nullptr);
        const Value value = share(eval(code, frame));
        if (is_set(value))
            result = event_set(value, code.span);
        else
            result = {event(value, code.span)};
    });
    return result;
}

std::vector<process::Event> Evaluator::trace(const Code& code, const Unit& unit) {
    std::vector<process::Event> result;
    on_deep_stack([&] {
        const Entry entry(*this);
        Frame frame(static_cast<std::size_t>(unit.size), nullptr);
        for (const Value each : sequence(share(eval(code, frame)), code.span)) result.push_back(event(each, code.span));
    });
    return result;
}

process::TermId Evaluator::tau_priority(process::TermId term, process::EventSet over) {
    const process::OrderId order = terms_.order({{}, std::move(over)});
    return make(process::Op::prioritise, {term}, static_cast<std::uint32_t>(order));
}

process::TermId Evaluator::unfold(std::uint32_t call) {
    process::TermId result{};
    on_deep_stack([&] {
        const Entry entry(*this);
        const Value key = calls_[call];
        const Value function = key->items[0];
        Values arguments(key->items.begin() + 1, key->items.end());
        if (function->kind == Kind::builtin) {  // loop(P) = P; loop(P)
            const process::TermId body = term(arguments.at(0), {});
            result = make(process::Op::sequential, {body, call_term(function, arguments)});
            return;
        }
        const Function& definition = *function->function;
        const Calling calling(*this, definition, arguments, definition.span);
        Frame frame;
        Values all(function->items.begin() + static_cast<std::ptrdiff_t>(definition.environment),
                   function->items.end());
        all.insert(all.end(), arguments.begin(), arguments.end());
        const FunctionClause& clause = choose(definition, function->items, all, frame, definition.span);
        result = process(*clause.body, frame);
    });
    return result;
}

std::vector<process::Branch> Evaluator::branches(std::uint32_t prefix) {
    std::vector<process::Branch> result;
    on_deep_stack([&] {
        const Entry entry(*this);
        const auto [kind, key] = prefixes_[prefix];
        const auto self = make(process::Op::prefix, {}, prefix);
        switch (kind) {
            case PrefixKind::script:
                result = script_branches(key);
                break;
            case PrefixKind::chosen:
                result = chosen_branches(key);
                break;
            case PrefixKind::waiting: {
                const auto tock = static_cast<process::Event>(key->items[0]->number);
                const process::TermId then = term(key->items[2], {});
                result = {{tock, waiting(tock, key->items[1]->number - 1, then)}};
                break;
            }
            case PrefixKind::stopped:  // STOP of a timed section: time passes
                result = {{static_cast<process::Event>(key->items[0]->number), self}};
                break;
            case PrefixKind::skipping:  // SKIP of a timed section: SKIP [] tock -> itself
                result = {{static_cast<process::Event>(key->items[0]->number),
                           make(process::Op::external_choice, {self, make(process::Op::skip)})}};
                break;
            case PrefixKind::buffer:
                result = buffer_branches(key);
                break;
        }
        // A prefix in a timed section lets time pass (semantics 3.10).
        if (kind == PrefixKind::script) {
            const Code& code = *program_.prefixes[static_cast<std::size_t>(key->items[0]->number)];
            if (code.timed != nullptr) result.push_back({tock(*code.timed), self});
        }
    });
    return result;
}

std::string Evaluator::describe_call(std::uint32_t call) const {
    const Value key = calls_[call];
    std::string result = text(key->items[0]);
    if (key->items.size() == 1) return result;
    print_items({key->items.begin() + 1, key->items.end()}, "(", ",", ")", result);
    return result;
}

}  // namespace robochart::cspm
