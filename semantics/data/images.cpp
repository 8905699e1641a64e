// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/images.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "semantics/data/inlining.hpp"
#include "semantics/data/windows.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::ir {
namespace {

/// Replaces the value that a condition reads by an expression. Recursion depth: the depth of the condition.
ExprPtr substituted(const ExprPtr& condition, const ExprPtr& value) {
    if (condition->kind == ExprKind::variable || condition->kind == ExprKind::trigger_value) return value;
    Expr result = *condition;
    for (ExprPtr& part : result.args) part = substituted(part, value);
    return std::make_shared<const Expr>(std::move(result));
}

/// The size of a computed sequence: a number, plus the size of the variable from which it is computed, if any.
struct Size {
    bool of_variable = false;
    std::int64_t more = 0;
};

std::optional<Size> size_of(const Expr& sequence) {
    if (sequence.kind == ExprKind::variable) return Size{true, 0};
    if (sequence.kind == ExprKind::sequence) return Size{false, static_cast<std::int64_t>(sequence.args.size())};
    if (sequence.kind == ExprKind::cast) return size_of(*sequence.args.at(0));
    if (sequence.kind == ExprKind::concat) {
        const auto left = size_of(*sequence.args.at(0)), right = size_of(*sequence.args.at(1));
        if (!left || !right || (left->of_variable && right->of_variable)) return std::nullopt;
        return Size{left->of_variable || right->of_variable, left->more + right->more};
    }
    const bool shorter = sequence.kind == ExprKind::toolkit &&
                         (sequence.text == "sequence_toolkit_tail" || sequence.text == "sequence_toolkit_front");
    auto size = shorter ? size_of(*sequence.args.at(0)) : std::nullopt;
    if (size) --size->more;
    return size;
}

using Images = std::vector<std::set<std::size_t>>;
using Answers = std::vector<int>;

class ImageSearch {
public:
    ImageSearch(const System& system, const Sampling& sampling, MachineId machine, const DividedFlow& source,
                const DividedFlow& target)
        : system_(system), sampling_(sampling), machine_(machine), source_(source), target_(target) {}

    [[nodiscard]] std::optional<Images> of_number(const ExprPtr& expr) const;
    [[nodiscard]] std::optional<Images> of_sequence(const Expr& expr) const;

private:
    using Conditions = std::vector<ExprPtr>;
    [[nodiscard]] static Conditions conditions_of(const DividedFlow& flow) {
        Conditions result;
        for (const Condition& condition : flow.uses->conditions) result.push_back(condition.body);
        return result;
    }
    [[nodiscard]] std::optional<Answers> answers(const Conditions& conditions, const Value& value) const;
    [[nodiscard]] std::vector<std::optional<Answers>> answers_of_classes(const DividedFlow& flow) const;
    /// Adds a pair of classes. Returns false if no class has these answers.
    [[nodiscard]] bool add(const std::optional<Answers>& from, const std::optional<Answers>& to, Images& images) const;

    const System& system_;
    const Sampling& sampling_;
    MachineId machine_;
    const DividedFlow& source_;
    const DividedFlow& target_;
    std::vector<std::optional<Answers>> sources_ = answers_of_classes(source_), targets_ = answers_of_classes(target_);
};

std::optional<Answers> ImageSearch::answers(const Conditions& conditions, const Value& value) const {
    Answers result;
    for (const ExprPtr& condition : conditions) {
        sampling_.instantiation().poll();
        const auto answer = sampling_.truth(machine_, *condition, value);
        if (!answer) return std::nullopt;
        result.push_back(*answer);
    }
    return result;
}

std::vector<std::optional<Answers>> ImageSearch::answers_of_classes(const DividedFlow& flow) const {
    std::vector<std::optional<Answers>> result;
    for (const Value& witness : flow.classes->witnesses) result.push_back(answers(conditions_of(flow), witness));
    return result;
}

bool ImageSearch::add(const std::optional<Answers>& from, const std::optional<Answers>& to, Images& images) const {
    if (!from || !to) return false;
    const auto target = std::ranges::find(targets_, to);
    if (target == targets_.end()) return false;
    bool found = false;
    for (std::size_t i = 0; i < sources_.size(); ++i) {
        if (sources_[i] != from) continue;
        images[i].insert(static_cast<std::size_t>(target - targets_.begin()));
        found = true;
    }
    return found;
}

std::optional<Images> ImageSearch::of_number(const ExprPtr& expr) const {
    const ExprPtr value = inline_calls(system_, expr);
    const Conditions before = conditions_of(source_);
    Conditions after;
    for (const ExprPtr& condition : conditions_of(target_)) after.push_back(substituted(condition, value));
    std::vector<Condition> all;
    for (const Conditions* conditions : {&before, &std::as_const(after)})
        for (const ExprPtr& condition : *conditions) all.push_back({condition.get(), machine_, condition});
    const auto values = values_for_answers(system_, sampling_, source_.type, all);
    if (!values) return std::nullopt;
    Images images(source_.classes->witnesses.size());
    for (const Value& member : *values)
        if (!add(answers(before, member), answers(after, member), images)) return std::nullopt;
    return images;
}

/// Returns the class for each size. Stops at a size beyond which no condition distinguishes sizes.
std::optional<Images> ImageSearch::of_sequence(const Expr& expr) const {
    const auto size = size_of(expr);
    const ClosedValue closed = [this](const Expr& part) { return sampling_.closed_value(machine_, part); };
    SequenceConditions sequences(system_, sampling_.instantiation().scale);
    for (const DividedFlow* flow : {&source_, &target_})
        for (const ExprPtr& condition : conditions_of(*flow))
            if (!sequences.add(*condition, closed)) return std::nullopt;
    const auto greatest = sequences.greatest_size();
    if (!size || !greatest) return std::nullopt;
    Images images(source_.classes->witnesses.size());
    const auto sequence_of = [](std::int64_t length, const Value& element) {
        Value result;
        result.parts.assign(static_cast<std::size_t>(length), element);
        return result;
    };
    const Value before = default_value(system_, sampling_.instantiation(), system_.type(source_.type).args.at(0));
    const Value after = default_value(system_, sampling_.instantiation(), system_.type(target_.type).args.at(0));
    for (std::int64_t length = 0; length <= *greatest + std::max<std::int64_t>(-size->more, 0) + 1; ++length) {
        const std::int64_t result = (size->of_variable ? length : 0) + size->more;
        if (result < 0) continue;  // undefined: the machine blocks
        if (!add(answers(conditions_of(source_), sequence_of(length, before)),
                 answers(conditions_of(target_), sequence_of(result, after)), images))
            return std::nullopt;
    }
    return images;
}

}  // namespace

std::optional<Images> images_of(const System& system, const Sampling& sampling, MachineId machine,
                                const DividedFlow& source, const DividedFlow& target, const ExprPtr& expr) {
    for (const DividedFlow* flow : {&source, &target}) {
        const bool elsewhere = std::ranges::any_of(
            flow->uses->conditions, [&](const Condition& condition) { return condition.machine != machine; });
        if (elsewhere || !flow->classes->all_values || flow->classes->nothing_tested) return std::nullopt;
    }
    const ImageSearch search(system, sampling, machine, source, target);
    const bool sequences = system.type(source.type).kind == TypeKind::sequence;
    if (sequences != (system.type(target.type).kind == TypeKind::sequence)) return std::nullopt;
    return sequences ? search.of_sequence(*expr) : search.of_number(expr);
}

}  // namespace robochart::ir
