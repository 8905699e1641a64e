// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/earlier_answers.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "base/diagnostics/containers.hpp"
#include "checker/cspm/eval/evaluation_error.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/lts/graph.hpp"
#include "checker/machine/content.hpp"
#include "checker/machine/supercombinator_system.hpp"
#include "checker/process/operational_semantics.hpp"

namespace robochart::cspm {

namespace {

/// Specifications with more states than this are not explored completely.
constexpr std::size_t most_specification_states = 20'000;

struct GivesUp {};

/// Returns the graph of a system that is not compiled. Returns no value if the exploration finds too many states, takes
/// longer than `longest`, or fails.
std::optional<lts::Graph> explore_whole(lts::TransitionSystem& system, diagnostics::Pollable& budget,
                                        const std::optional<std::chrono::milliseconds>& longest) {
    const auto start = std::chrono::steady_clock::now();
    try {
        return lts::explore(system,
                            [&](std::size_t states) {
                                budget.poll();
                                const auto taken = std::chrono::steady_clock::now() - start;
                                if (states > most_specification_states || (longest && taken > *longest))
                                    throw GivesUp();
                            })
            .graph;
    } catch (const GivesUp&) {
    } catch (const EvaluationError&) {
    } catch (const process::SemanticsError&) {
    }
    return std::nullopt;
}

const machine::Supercombinator* compiled(const lts::TransitionSystem& system) {
    const auto* const found = dynamic_cast<const machine::SupercombinatorSystem*>(&system);
    return found == nullptr ? nullptr : &found->combined();
}

machine::EventPlaces make_event_places(process::EventSet events) {
    diagnostics::sort_unique(events);
    return machine::EventPlaces(std::move(events));
}

}  // namespace

std::optional<QuestionKey> key_of(const Question& question, diagnostics::Pollable& budget,
                                  const std::optional<std::chrono::milliseconds>& longest) {
    const machine::Supercombinator* const process = compiled(*question.process);
    if (process == nullptr) return std::nullopt;
    const machine::Supercombinator* specification = nullptr;
    std::optional<lts::Graph> graph;
    if (question.specification != nullptr) {
        specification = compiled(*question.specification);
        if (specification == nullptr) graph = explore_whole(*question.specification, budget, longest);
        if (specification == nullptr && !graph) return std::nullopt;
    }
    process::EventSet events;
    machine::add_events(*process, events);
    if (specification != nullptr) machine::add_events(*specification, events);
    if (graph) machine::add_events(*graph, events);
    const machine::EventPlaces named = make_event_places(std::move(events));

    diagnostics::Hasher hasher;
    for (const std::uint64_t part :
         {static_cast<std::uint64_t>(question.kind), static_cast<std::uint64_t>(question.model), question.max_states,
          std::uint64_t{question.reduction ? 1U : 0U}})
        hasher.add(part);
    for (const process::Event event : named.named_events()) hasher.add(question.process->events().name(event));
    machine::add_content(*process, named, hasher);
    std::string_view form_of_specification = "";
    if (specification != nullptr)
        form_of_specification = "compiled";
    else if (graph)
        form_of_specification = "graph";
    hasher.add(form_of_specification);
    if (specification != nullptr) machine::add_content(*specification, named, hasher);
    if (graph) machine::add_content(*graph, named, hasher);
    return QuestionKey{hasher.finish(), named.named_events()};
}

QuestionKey key_of_packed(const Question& question, const Script& script, const Decl& assertion,
                          const process::EventSet& events) {
    process::EventSet all = events;
    all.insert(all.end(), {process::tau, process::tick});
    const machine::EventPlaces named = make_event_places(std::move(all));
    diagnostics::Hasher hasher;
    hasher.add(std::string_view("packed states"));
    for (const std::uint64_t part :
         {static_cast<std::uint64_t>(question.kind), static_cast<std::uint64_t>(question.model), question.max_states,
          std::uint64_t{question.reduction ? 1U : 0U}, std::uint64_t{assertion.span.begin}})
        hasher.add(part);
    hasher.add(std::string_view(print(script)));
    hasher.add(std::string_view(print(assertion)));
    for (const process::Event event : named.named_events()) hasher.add(question.process->events().name(event));
    return {hasher.finish(), named.named_events()};
}

namespace {

/// Returns true if `named` contains all events of the findings. The events that a linked parallel creates for its links
/// are missing in `named`, because they belong to no channel.
bool all_named(const refine::Findings& findings, const process::EventSet& named) {
    if (!findings.violation) return true;
    const auto known = [&](process::Event event) { return std::ranges::binary_search(named, event); };
    for (const refine::Run* const run : {&findings.violation->run, &findings.violation->loop})
        for (const refine::RunStep& step : run->steps)
            if (!known(step.event) || !known(step.revealed)) return false;
    return true;
}

}  // namespace

refine::Verdict check_with_memory(const Question& question, const QuestionKey& key, const Memory& memory,
                                  const std::function<refine::Verdict(refine::Earlier)>& ask) {
    std::optional<refine::Findings> findings;
    if (const auto bytes = memory.cache->find(key.digest))
        findings = refine::decode(*bytes, key.named, question.process->width());
    if (findings) {
        try {
            return ask(&findings);
        } catch (const std::logic_error&) {
            // The stored violation is not one of this process, so a search is needed.
            findings.reset();
        }
    }
    refine::Verdict verdict = ask(&findings);
    const bool long_search = findings && (findings->statistics.states >= memory.fewest_states ||
                                          findings->statistics.decided_by == refine::DecidedBy::compressed_parts);
    if (long_search && all_named(*findings, key.named))
        memory.cache->store_entry(key.digest, refine::encode(*findings, key.named));
    return verdict;
}

refine::Verdict answer_of_width(const Question& question, const QuestionKey& key, const Memory& memory,
                                const std::function<refine::Verdict(refine::Earlier)>& ask) {
    diagnostics::Hasher hasher;
    hasher.add(key.digest);
    hasher.add(std::uint64_t{question.process->width()});
    const QuestionKey of_width{hasher.finish(), key.named};
    refine::Verdict verdict = check_with_memory(question, of_width, memory, ask);
    if (const auto bytes = memory.cache->find(of_width.digest)) memory.cache->store_entry(key.digest, *bytes);
    return verdict;
}

}  // namespace robochart::cspm
