// SPDX-License-Identifier: Apache-2.0
// Tests that processes of whole scripts are equivalent to their reduced forms under branching bisimilarity with
// explicit divergence (docs/search.md, "Confluent taus"). ROBOCHART_REDUCED_SCRIPTS names a folder whose scripts are
// compared too. benchmarks/decide_components.py --keep FOLDER writes the scripts of a suite.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "tests/checker/cspm/support.hpp"
#include "tests/checker/lts/bisimilar.hpp"

namespace robochart::cspm::test {
namespace {

constexpr std::size_t most_states = 2'000'000;

struct Compared {
    std::size_t processes = 0, smaller = 0, too_large = 0, states = 0, reduced_states = 0;
};

/// Compares the process of each assertion with its reduced form. For a refinement, compares the specification.
void compare(Session& session, Compared& compared) {
    std::string last;
    for (const DeclPtr& assertion : session.assertions()) {
        const ExprPtr& process = assertion->assertion.specification;
        std::string name = print(process);
        if (name == last) continue;
        last = std::move(name);
        const auto whole = session.system(process);
        const auto reduced = whole->make_reduced_system(lts::Followed::taus, diagnostics::unlimited);
        ++compared.processes;
        if (!reduced) continue;
        try {
            const lts::Graph all = lts::graph_of(*whole, most_states);
            const lts::Graph reduced_graph = lts::graph_of(*reduced, most_states);
            EXPECT_TRUE(lts::are_bisimilar(all, reduced_graph, lts::Equivalence::branching_with_divergence)) << last;
            EXPECT_LE(reduced_graph.size(), all.size()) << last;
            compared.smaller += reduced_graph.size() < all.size() ? 1U : 0U;
            compared.states += all.size();
            compared.reduced_states += reduced_graph.size();
        } catch (const lts::TooLarge&) {
            ++compared.too_large;
        }
    }
}

TEST(ReducedScripts, KeepTimedPrioritiesAndInterrupts) {
    const Reading reading(R"(external prioritise
channel tock, a, b, c
channel h, k : {0..1}
P(i) = h!i -> k!i -> P(i)
Steps = h?i -> k?j -> STOP
Clock = a -> tock -> Clock [] tock -> Clock
assert (P(0) ||| P(1)) \ {|h, k|} :[deadlock free]
assert ((P(0) ||| P(1)) [|{|h|}|] Steps) \ {|h|} :[deadlock free]
assert prioritise(((P(0) ||| P(1)) \ {|h|}) ||| Clock, <{}, {tock}>) :[deadlock free]
assert (((P(0) ||| P(1)) \ {|h|}) /\ b -> STOP) ||| c -> STOP :[deadlock free]
assert (((P(0) \ {|h|}) [> b -> STOP) ||| P(1)) \ {|h|} :[deadlock free]
)");
    ASSERT_TRUE(reading.ok()) << reading.report();
    Session session(reading.script);
    Compared compared;
    compare(session, compared);
    EXPECT_EQ(compared.processes, 5U);
    EXPECT_GE(compared.smaller, 2U);
}

TEST(ReducedScripts, OfAFolderKeepAll) {
    const char* const folder = std::getenv("ROBOCHART_REDUCED_SCRIPTS");
    if (folder == nullptr) GTEST_SKIP() << "ROBOCHART_REDUCED_SCRIPTS names no folder";
    Compared compared;
    std::size_t scripts = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".csp") continue;
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics found;
        Session session(read_file(sources, entry.path().string(), found));
        ASSERT_TRUE(found.ok()) << entry.path();
        compare(session, compared);
        ++scripts;
    }
    std::cout << scripts << " scripts, " << compared.processes << " processes, " << compared.smaller
              << " with fewer states (" << compared.states << ", kept " << compared.reduced_states << "), "
              << compared.too_large << " too large to compare\n";
    EXPECT_GT(compared.processes, 0U);
    EXPECT_EQ(compared.too_large, 0U);
}

}  // namespace
}  // namespace robochart::cspm::test
