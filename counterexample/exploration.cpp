// SPDX-License-Identifier: Apache-2.0
// Explores the states of a process with Stepper. Data that several states share are stored only once.
#include "counterexample/exploration.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "counterexample/evaluation_failure.hpp"
#include "counterexample/structure.hpp"

namespace robochart::runs {
namespace {

/// A list without duplicates.
template <class Item>
class Table {
public:
    explicit Table(std::vector<Item>& items) : items_(items) {}

    std::size_t number_of(Item item) {
        const auto [found, added] = numbers_.try_emplace(std::move(item), items_.size());
        if (added) items_.push_back(found->first);
        return found->second;
    }

private:
    std::vector<Item>& items_;
    std::map<Item, std::size_t> numbers_;
};

class Explorer {
public:
    Explorer(StepReader& reader, process::TermId initial, const ExplorationLimits& limits, diagnostics::Budget& budget)
        : reader_(reader), limits_(limits), budget_(budget) {
        (void)number_of(initial);
    }

    Exploration explore_all() {
        try {
            while (result_.states.size() < found_.size() && !limit_reached()) {
                budget_.poll();
                result_.states.push_back(describe_state(found_[result_.states.size()]));
                transitions_ += result_.states.back().offers.size();
            }
        } catch (const diagnostics::LimitReached& limit) {
            result_.limit = limit.what();
        }
        forget_unexplored();
        return std::move(result_);
    }

private:
    std::size_t number_of(process::TermId term) {
        const auto [found, added] = numbers_.try_emplace(term, found_.size());
        if (added) found_.push_back(term);
        return found->second;
    }

    bool limit_reached() {
        if (result_.states.size() >= limits_.states)
            result_.limit = fmt::format("the limit of {} states was reached", limits_.states);
        else if (transitions_ >= limits_.transitions)
            result_.limit = fmt::format("the limit of {} offers was reached", limits_.transitions);
        return !result_.limit.empty();
    }

    Exploration::State describe_state(process::TermId term) {
        Exploration::State result;
        Stepper stepper(reader_, term);
        try {
            for (Machine& machine : stepper.current_machines())
                result.machines.push_back(machines_.number_of(std::move(machine)));
            for (const Offer& offer : stepper.current_offers())
                result.offers.push_back(
                    {labels_.number_of({offer.happening, offer.name, offer.hidden}), number_of(offer.step.target)});
            for (Absence& absence : stepper.explain_absences())
                result.absences.push_back(absences_.number_of(std::move(absence)));
            if (const auto& whole = stepper.current_structure()) result.structure = add_part(*whole);
        } catch (const cspm::EvaluationError& error) {
            const Context& context = reader_.context();
            result.error = placed_failure(error, context.system, context.sources);
        }
        if (!result.error.empty()) result.offers.clear();
        if (result.machines.empty()) result.process = process::describe(reader_.context().session.terms(), term);
        return result;
    }

    /// Adds a part with its operands. The recursion ends, because behaviour() limits the depth of a structure.
    std::size_t add_part(const process::Behaviour& whole) {
        Exploration::Part result{part_text(whole), {}, {}};
        for (const process::Behaviour& part : whole.parts) result.parts.push_back(add_part(part));
        if (whole.parts.empty()) result.offers = offers_text(whole, reader_.context().session.event_table());
        return parts_.number_of(std::move(result));
    }

    void forget_unexplored() {
        const std::size_t explored = result_.states.size();
        result_.left_out = found_.size() - explored;
        for (Exploration::State& state : result_.states)
            for (Exploration::Transition& transition : state.offers)
                if (*transition.target >= explored) transition.target.reset();
    }

    StepReader& reader_;
    const ExplorationLimits& limits_;
    diagnostics::Budget& budget_;
    Exploration result_;
    Table<Exploration::Label> labels_{result_.labels};
    Table<Machine> machines_{result_.machines};
    Table<Absence> absences_{result_.absences};
    Table<Exploration::Part> parts_{result_.parts};
    std::vector<process::TermId> found_;  ///< the states in the order in which they were found
    std::map<process::TermId, std::size_t> numbers_;
    std::size_t transitions_ = 0;
};

}  // namespace

Exploration explore_process(StepReader& reader, process::TermId initial, const ExplorationLimits& limits,
                            diagnostics::Budget& budget) {
    return Explorer(reader, initial, limits, budget).explore_all();
}

}  // namespace robochart::runs
