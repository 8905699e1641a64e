// See machine_of_cycles.hpp.
#include "conformance/machine_of_cycles.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>
#include <unordered_map>

#include "checker/refine/budget.hpp"
#include "checker/refine/normal_form.hpp"

namespace robochart::conformance {

namespace {

using Node = refine::NormalForm::Node;
constexpr std::size_t most_symbols = 1U << 12U;
constexpr std::size_t most_steps = 1U << 22U;

std::vector<std::vector<std::uint32_t>> valuations(const Interface& interface) {
    std::vector<std::vector<std::uint32_t>> all{{}};
    for (const Register& input : interface.inputs) {
        std::vector<std::vector<std::uint32_t>> more;
        for (const auto& before : all)
            for (std::uint32_t r = 0; r < input.readings(); ++r) {
                more.push_back(before);
                more.back().push_back(r);
            }
        if (more.size() > most_symbols)
            throw std::length_error(fmt::format("the inputs have more than {} valuations together", most_symbols));
        all = std::move(more);
    }
    return all;
}

class Builder {
public:
    Builder(CyclicModel& model, const refine::Limits& limits)
        : model_(model), budget_(limits), form_(model.normal_form(), budget_) {}

    MachineOfCycles build() {
        MachineOfCycles machine;
        machine.inputs = valuations(model_.interface());
        number(form_.initial());
        for (std::size_t at = 0; at < nodes_.size(); ++at) {
            if ((at + 1) * machine.inputs.size() > most_steps)
                throw std::length_error(fmt::format("it has more than {} transitions", most_steps));
            std::vector<CycleStep>& steps = machine.steps.emplace_back();
            for (const auto& readings : machine.inputs) steps.push_back(cycle(nodes_[at], readings));
        }
        return minimal(machine);
    }

private:
    std::uint32_t number(Node node) {
        const auto [place, fresh] = numbers_.emplace(node, static_cast<std::uint32_t>(nodes_.size()));
        if (fresh) nodes_.push_back(node);
        return place->second;
    }

    CycleStep cycle(Node node, const std::vector<std::uint32_t>& readings) {
        for (std::uint32_t i = 0; i < readings.size(); ++i) {
            const auto next = form_.after(node, model_.alphabet().read(i, readings[i]));
            if (!next) throw std::length_error("the model cannot be run in cycles: it is not schedulable");
            node = *next;
        }
        CycleStep step;
        for (std::uint32_t tocks = 0; tocks < model_.cycle_length();) {
            const process::EventSet possible = form_.initials(node);
            if (possible.empty()) throw std::length_error("the model cannot be run in cycles: it is not schedulable");
            if (possible.size() > 1)
                throw std::length_error(fmt::format("the model leaves a choice, between {} and {}",
                                                    model_.alphabet().tell(possible[0]),
                                                    model_.alphabet().tell(possible[1])));
            const process::Event event = possible.front();
            if (event == process::tick) {
                step.target = MachineOfCycles::over;
                return step;
            }
            if (event == model_.alphabet().tock())
                ++tocks;
            else
                step.writes.push_back(event);
            node = *form_.after(node, event);
        }
        step.target = number(node);
        return step;
    }

    /// Moore 1956: states are told apart by longer and longer words. Numbered in the order of the search.
    MachineOfCycles minimal(const MachineOfCycles& machine) {
        std::vector<std::uint32_t> classes(machine.states(), 0);
        for (std::size_t count = 0;;) {
            std::map<std::vector<std::uint64_t>, std::uint32_t> known;
            std::vector<std::uint32_t> next;
            for (const auto& steps : machine.steps) {
                budget_.charge();
                std::vector<std::uint64_t> signature;
                for (const CycleStep& step : steps) {
                    signature.push_back(step.target == MachineOfCycles::over ? step.target : classes[step.target]);
                    signature.push_back(step.writes.size());
                    signature.insert(signature.end(), step.writes.begin(), step.writes.end());
                }
                next.push_back(
                    known.emplace(std::move(signature), static_cast<std::uint32_t>(known.size())).first->second);
            }
            classes = std::move(next);
            if (known.size() == count) break;
            count = known.size();
        }
        MachineOfCycles result;
        result.inputs = machine.inputs;
        for (std::size_t state = 0; state < machine.states(); ++state) {
            if (classes[state] != result.states()) continue;
            result.steps.push_back(machine.steps[state]);
            for (CycleStep& step : result.steps.back())
                if (step.target != MachineOfCycles::over) step.target = classes[step.target];
        }
        return result;
    }

    CyclicModel& model_;
    refine::Budget budget_;
    refine::NormalForm form_;
    std::unordered_map<Node, std::uint32_t> numbers_;
    std::vector<Node> nodes_;
};

}  // namespace

MachineOfCycles machine_of_cycles(CyclicModel& model, const refine::Limits& limits) {
    return Builder(model, limits).build();
}

}  // namespace robochart::conformance
