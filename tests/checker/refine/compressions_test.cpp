// SPDX-License-Identifier: Apache-2.0
// Tests that each compression preserves the models that it claims to preserve (lts/compressor.hpp). The naive checker
// compares the compressed machine of a random process with the process, in both directions, in T, F and FD.
// agreement_test.cpp tests compressions in contexts.
#include <gtest/gtest.h>

#include "checker/lts/graph.hpp"
#include "checker/process/bisimulation_compressor.hpp"
#include "tests/checker/processes/random_cases.hpp"
#include "tests/checker/processes/random_process.hpp"
#include "tests/checker/processes/translate.hpp"

namespace robochart::refine {
namespace {

using naive::Behaviour;
using naive::Semantics;
using process::Compression;

constexpr auto kinds = {Compression::normal,         Compression::sbisim,    Compression::dbisim,
                        Compression::wbisim,         Compression::diamond,   Compression::tau_loop_factor,
                        Compression::model_compress, Compression::explicate, Compression::lazyenumerate};

process::Machine machine_of(Translation& translation, const naive::Process& process) {
    process::TermSystem system = translation.system(process);
    const lts::Exploration explored = lts::explore(system, [](std::size_t) {});
    process::Machine machine;
    for (lts::StateIndex state = 0; state < explored.graph.size(); ++state) {
        machine.meaning.push_back(translation.term(process));
        auto& edges = machine.edges.emplace_back();
        for (const lts::Edge& edge : explored.graph.edges(state)) edges.push_back({edge.event, edge.target});
    }
    return machine;
}

naive::Graph graph_of(Translation& translation, const process::Machine& machine) {
    std::map<process::Event, naive::Letter> letters{{process::tau, naive::tau}, {process::tick, naive::tick}};
    for (naive::Letter letter = 0; letter < naive::letters_used; ++letter) letters[translation.event(letter)] = letter;
    naive::Graph graph;
    for (const auto& edges : machine.edges) {
        auto& row = graph.edges.emplace_back();
        for (const auto& edge : edges) row.push_back({letters.at(edge.event), static_cast<int>(edge.target)});
    }
    return graph;
}

TEST(Compressions, KeepTheModelsTheyClaim) {
    RandomCases cases(4);
    std::map<Compression, int> smaller;
    for (int round = 0; round < 60; ++round) {
        const RandomCases::Explored random_case = cases.next();
        Translation translation(random_case.test_case.script);
        const process::Machine explored = machine_of(translation, random_case.test_case.script.mains[1]);
        const Behaviour original(random_case.graphs.graphs[1], naive::letters_used);
        for (const Compression kind : kinds) {
            const process::Machine compressed =
                process::BisimulationCompressor().compress(explored, kind, diagnostics::unlimited);
            EXPECT_LE(compressed.edges.size(), explored.edges.size());
            if (compressed.edges.size() < explored.edges.size()) ++smaller[kind];
            const naive::Graph graph = graph_of(translation, compressed);
            const Behaviour result(graph, naive::letters_used);
            for (const Semantics semantics : {Semantics::T, Semantics::F, Semantics::FD}) {
                EXPECT_TRUE(naive::refines(original, result, semantics)) << show(random_case.test_case.script);
                EXPECT_TRUE(naive::refines(result, original, semantics)) << show(random_case.test_case.script);
            }
        }
    }
    for (const Compression kind : kinds) EXPECT_GT(smaller[kind], 10) << "compresses too rarely to be tested";
}

TEST(Compressions, DeterIsRefusedByName) {
    Translation translation(naive::Script{{}, {}}, true);
    const auto deter = translation.scripted().op(process::Op::compress, {translation.scripted().stop()},
                                                 static_cast<std::uint32_t>(Compression::deter));
    EXPECT_THROW((void)translation.semantics().successors(deter), process::SemanticsError);
}

}  // namespace
}  // namespace robochart::refine
