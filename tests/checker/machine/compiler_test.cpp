// SPDX-License-Identifier: Apache-2.0
// Compares compiled processes with their terms. The two are strongly bisimilar, for each operator alone and for random
// compositions. A process that cannot be compiled stays a term.
#include "checker/machine/compiler.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "checker/process/term_system.hpp"
#include "tests/checker/lts/bisimilar.hpp"
#include "tests/checker/process/scripted.hpp"
#include "tests/checker/processes/random_process.hpp"
#include "tests/checker/processes/translate.hpp"
#include "tests/rounds.hpp"

namespace robochart::machine {
namespace {

using process::Op;
using process::Scripted;

/// Random compositions with more states are skipped.
constexpr std::size_t too_many = robochart::tests::size_of_input(20'000);

lts::Graph graph_of(lts::TransitionSystem& system) {
    return lts::graph_of(system, too_many);
}

class Compiled : public testing::Test {
protected:
    /// Checks that the compiled process is bisimilar to the term. Returns its number of states.
    std::size_t states(TermId term) {
        const auto system = compiler.compile(term, diagnostics::unlimited);
        if (!system) {
            ADD_FAILURE() << "was not compiled";
            return 0;
        }
        process::TermSystem reference(semantics, term);
        const lts::Graph graph = graph_of(*system);
        EXPECT_TRUE(lts::are_bisimilar(graph, graph_of(reference)));
        return graph.size();
    }
    TermId twice(const char* event) { return s.prefix(event, s.prefix(event, s.skip())); }
    /// Returns two components that take two steps each and then terminate together. They have 3 * 3 states and the
    /// terminated state.
    TermId pair() { return s.over(Op::parallel, {twice("a"), twice("b")}, {}); }
    static constexpr std::size_t states_of_pair = 10;

    Scripted s;
    process::OperationalSemantics semantics{s.store};
    Compiler compiler{semantics};
    TermId stop = s.stop();
};

TEST_F(Compiled, ParallelHidingRenaming) {
    EXPECT_EQ(states(pair()), states_of_pair);
    EXPECT_EQ(states(s.over(Op::parallel, {twice("a"), twice("a")}, {"a"})), 4U);
    EXPECT_EQ(states(s.over(Op::hide, {pair()}, {"a"})), states_of_pair);
    EXPECT_EQ(states(s.rename(pair(), {{"a", "b"}, {"a", "c"}, {"b", "a"}})), states_of_pair);
    const TermId both = s.op(Op::alphabetised, {twice("a"), twice("b")}, 0, {s.set({"a"}), s.set({"b", "a"})});
    EXPECT_EQ(states(both), 3U) << "a needs the second side, which never does it: only b, b";
}

TEST_F(Compiled, OperatorsThatOneOperandOutlives) {
    // The pair terminates, then c happens. The initial state of c replaces the terminated state of the pair.
    EXPECT_EQ(states(s.op(Op::sequential, {pair(), s.prefix("c", stop)})), states_of_pair + 1);
    // The first b leaves the pair, which is then in one of three states of a.
    EXPECT_EQ(states(s.over(Op::exception, {pair(), s.prefix("c", stop)}, {"b"})), 5U);
    // c may interrupt in every state except the terminated one.
    EXPECT_EQ(states(s.op(Op::interrupt, {pair(), s.prefix("c", stop)})), states_of_pair + 1);
    // An event of the pair resolves the choice and the timeout. Only the initial state offers the alternative, so the
    // choice adds only the terminated state of c. The timeout also adds the initial and terminated states of c.
    EXPECT_EQ(states(s.op(Op::external_choice, {pair(), s.prefix("c", stop)})), states_of_pair + 1);
    EXPECT_EQ(states(s.op(Op::sliding, {pair(), s.prefix("c", stop)})), states_of_pair + 2);
    EXPECT_EQ(states(s.op(Op::internal_choice, {pair(), s.prefix("c", stop)})), states_of_pair + 3);
    EXPECT_EQ(states(s.menu({{"c", pair()}, {"c", s.prefix("d", stop)}})), states_of_pair + 3);
}

TEST_F(Compiled, RecursionThroughCompositions) {
    const TermId again = s.name("Again");
    s.bind(again, s.op(Op::sequential, {pair(), again}));
    EXPECT_EQ(states(again), states_of_pair - 1) << "the end of the pair is its beginning";
    const TermId round = s.name("Round");
    s.bind(round, s.over(Op::exception, {pair(), s.prefix("c", round)}, {"b"}));
    EXPECT_EQ(states(round), 4U);
    const TermId started = s.name("Started");
    s.bind(started, s.prefix("go", s.op(Op::sequential, {pair(), started})));
    EXPECT_EQ(states(started), states_of_pair);
}

// Machines with modes. An event that keeps or changes the mode resolves a choice, and then leads back to a node of the
// compiled process. Each mode is one state, for all transitions between the modes.
TEST_F(Compiled, ModesBeforeComponents) {
    const TermId off = s.name("Off");
    const TermId on = s.name("On");
    const auto choice = [&](std::vector<TermId> options) { return s.op(Op::external_choice, std::move(options)); };
    s.bind(off, choice({s.prefix("on", on), s.prefix("tick", off)}));
    s.bind(on, choice({s.prefix("start", pair()), s.prefix("tick", on), s.prefix("off", off)}));
    EXPECT_EQ(states(off), 2 + states_of_pair);
    // The pair itself can lead back to a mode by termination, by an exception, or from a timeout.
    const TermId idle = s.name("Idle");
    s.bind(idle, choice({s.prefix("start", s.op(Op::sequential, {pair(), idle})), s.prefix("tick", idle)}));
    EXPECT_EQ(states(idle), states_of_pair) << "the pair's end is the beginning";
    const TermId guarded = s.name("Guarded");
    s.bind(guarded,
           choice({s.prefix("start", s.over(Op::exception, {pair(), guarded}, {"b"})), s.prefix("tick", guarded)}));
    EXPECT_EQ(states(guarded), 4U) << "no b, and none, one or two a";
    const TermId timed = s.name("Timed");
    s.bind(timed,
           s.op(Op::sliding, {choice({s.prefix("start", pair()), s.prefix("tick", timed)}), s.prefix("late", timed)}));
    EXPECT_EQ(states(timed), 2 + states_of_pair);
}

// With infinitely or very many modes, the compiler gives up and returns null, so the whole process stays a term. If the
// process is one operand, the component of this operand covers it only up to its first event.
TEST_F(Compiled, ModesWithoutEnd) {
    TermId next = stop;
    for (int i = 0; i < 2'000; ++i) next = s.menu({{"up", next}, {"go", pair()}});
    EXPECT_EQ(compiler.compile(next, diagnostics::unlimited), nullptr);
    EXPECT_EQ(states(s.over(Op::parallel, {next, s.prefix("go", stop)}, {"up"})), 2 * states_of_pair)
        << "no up and no end: the other side never does either; before its go and after, the pair's start and its "
           "states";
}

TEST_F(Compiled, PrioritiesInsideAndOutside) {
    EXPECT_EQ(states(s.prioritise(pair(), {{"a"}, {"b"}})), 6U) << "a, a, b, b";
    const TermId inner = s.prioritise(pair(), {{"b"}, {"a"}});
    EXPECT_EQ(states(s.prioritise(s.over(Op::parallel, {inner, twice("c")}, {}), {{"c"}, {"a", "b"}})), 8U);
    EXPECT_EQ(states(s.op(Op::sequential, {s.over(Op::hide, {inner}, {"b"}), inner})), 11U)
        << "b, b, a, a and its end, which begins the same again; then its end is one more";
}

TEST_F(Compiled, RemovesEventsThatOtherComponentsBlock) {
    // A cell outputs its value, which is one of ten. No other component listens, so the values are equivalent.
    std::vector<TermId> cell;
    std::vector<std::pair<std::string, TermId>> writes;
    std::vector<std::string> reads;
    EventSet get_events;
    for (const char* value : {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"}) {
        cell.push_back(s.name(std::string("Cell") + value));
        writes.emplace_back(std::string("set") + value, cell.back());
        reads.push_back(std::string("get") + value);
        get_events.push_back(s.event(reads.back()));
    }
    for (std::size_t value = 0; value < cell.size(); ++value) {
        auto menu = writes;
        menu.emplace_back(reads[value], cell[value]);
        s.bind(cell[value], s.menu(menu));
    }
    const process::SetId get = s.store.intern_set(get_events);
    const TermId deaf = s.op(Op::parallel, {cell[0], twice("b")}, static_cast<std::uint32_t>(get));
    EXPECT_EQ(states(deaf), 3U) << "those of the listener that never listens";
    const TermId hears_one = s.op(Op::parallel, {cell[0], s.prefix("get7", stop)}, static_cast<std::uint32_t>(get));
    EXPECT_EQ(states(hears_one), 4U) << "whether it is 7, times whether it has been heard";
}

TEST_F(Compiled, KeepsBlockedEventsThatAPriorityDependsOn) {
    // Inside the region, b has priority over a. Outside, b is blocked. So neither of them occurs, and only c remains.
    const TermId inner = s.prioritise(s.op(Op::external_choice, {pair(), stop}), {{"b"}, {"a"}});
    EXPECT_EQ(states(s.over(Op::parallel, {inner, twice("c")}, {"b"})), 3U);
}

TEST_F(Compiled, KeepsHiddenNamesForCounterexamples) {
    const TermId hidden = s.over(Op::hide, {s.over(Op::parallel, {twice("a"), twice("a")}, {"a"})}, {"a"});
    const auto system = compiler.compile(hidden, diagnostics::unlimited);
    struct First final : lts::SuccessorSink {
        void add(Event event, lts::StateView, Event revealed) override { seen.emplace_back(event, revealed); }
        std::vector<std::pair<Event, Event>> seen;
    } first;
    std::vector<lts::Word> state(system->width());
    system->initial(state);
    system->successors(state, first);
    EXPECT_EQ(first.seen, (std::vector<std::pair<Event, Event>>{{process::tau, s.event("a")}}));
    EXPECT_EQ(system->describe(state), "a → … ‖ a → …");
}

TEST_F(Compiled, LeavesTermsThatAreNoCompositionsOrTooLarge) {
    EXPECT_EQ(compiler.compile(twice("a"), diagnostics::unlimited), nullptr);
    Compiler small(semantics, {.component_states = 2});
    EXPECT_EQ(small.compile(pair(), diagnostics::unlimited), nullptr);
    Compiler few(semantics, {.rules = 2});
    EXPECT_EQ(few.compile(pair(), diagnostics::unlimited), nullptr);
    const TermId endless = s.name("Endless");
    s.bind(endless, endless);
    EXPECT_EQ(compiler.compile(s.over(Op::parallel, {endless, twice("a")}, {}), diagnostics::unlimited), nullptr);
}

TEST_F(Compiled, StopsWhenItsBudgetSaysSo) {
    diagnostics::Budget interrupted;
    interrupted.interrupt();
    EXPECT_THROW(static_cast<void>(compiler.compile(pair(), interrupted)), process::Interrupted);
}

TEST_F(Compiled, ServesItsOwnSinks) {
    const auto system = compiler.compile(pair(), diagnostics::unlimited);
    struct Nested final : lts::SuccessorSink {
        void add(Event event, lts::StateView target, Event) override {
            events.push_back(event);
            if (depth++ < 3) system->successors(std::vector<lts::Word>(target.begin(), target.end()), *this);
        }
        lts::TransitionSystem* system = nullptr;
        int depth = 0;
        std::vector<Event> events;
    } nested;
    nested.system = system.get();
    std::vector<lts::Word> state(system->width());
    system->initial(state);
    system->successors(state, nested);
    EXPECT_EQ(nested.events.size(), 6U) << "two at the first state and after a, one after a, a and after a, a, b";
}

TEST_F(Compiled, GoesOnAfterASinkHasThrown) {
    const auto system = compiler.compile(s.prioritise(pair(), {{"a", "b"}}), diagnostics::unlimited);
    struct Throwing final : lts::SuccessorSink {
        void add(Event, lts::StateView, Event) override { throw lts::TooLarge(); }
    } throwing;
    std::vector<lts::Word> state(system->width());
    system->initial(state);
    EXPECT_THROW(system->successors(state, throwing), lts::TooLarge);
    EXPECT_EQ(graph_of(*system).size(), states_of_pair);
}

TEST_F(Compiled, PrioritiesOfRegionsThatRulesAroundAskFor) {
    // The two prioritised pairs each give b priority over a. The region around them synchronises them on a, and gives c
    // priority over all other events.
    const TermId inner = s.prioritise(s.op(Op::external_choice, {pair(), s.prefix("c", stop)}), {{"b", "c"}, {"a"}});
    const TermId meeting = s.over(Op::parallel, {inner, inner}, {"a"});
    states(meeting);
    states(s.prioritise(meeting, {{"c"}, {"b"}, {"a"}}));
    states(s.over(Op::parallel, {meeting, twice("a")}, {"a"}));
    states(
        s.prioritise(s.over(Op::parallel, {s.prioritise(meeting, {{"a"}, {"b"}}), twice("c")}, {"c"}), {{"b"}, {"c"}}));
}

TEST_F(Compiled, ServesCompressions) {
    MachineCompressor compressor;
    process::OperationalSemantics compressing(s.store, &compressor);
    Compiler with(compressing);
    compressor.set_compiler(with);
    const TermId hidden = s.over(Op::hide, {pair()}, {"a"});
    const TermId compressed = s.op(Op::compress, {hidden}, static_cast<std::uint32_t>(process::Compression::dbisim));
    process::TermSystem small(compressing, compressed);
    EXPECT_EQ(graph_of(small).size(), 4U) << "b, b and the end: the a's are inert";
    const auto whole = with.compile(s.over(Op::parallel, {compressed, twice("b")}, {"b"}), diagnostics::unlimited);
    ASSERT_NE(whole, nullptr);
    EXPECT_EQ(graph_of(*whole).size(), 4U);
}

// The compiler stores at most five states of an operand. dbisim may follow the hidden a's, which leaves the four states
// of b. sbisim needs all ten states.
TEST_F(Compiled, LeavesOutCompressionsOfTooManyStates) {
    MachineCompressor compressor;
    process::OperationalSemantics compressing(s.store, &compressor);
    Bounds bounds;
    bounds.compressed_states = 5;
    Compiler with(compressing, bounds);
    compressor.set_compiler(with);
    const TermId hidden = s.over(Op::hide, {pair()}, {"a"});
    const auto compressed = [&](process::Compression kind) {
        return s.op(Op::compress, {hidden}, static_cast<std::uint32_t>(kind));
    };
    const TermId branching = compressed(process::Compression::dbisim);
    const TermId strong = compressed(process::Compression::sbisim);
    const auto beside = [&](TermId operand) { return s.over(Op::parallel, {operand, twice("b")}, {"b"}); };

    const auto small = with.compile(beside(branching), diagnostics::unlimited);
    ASSERT_NE(small, nullptr);
    EXPECT_EQ(graph_of(*small).size(), 4U);
    EXPECT_TRUE(compressing.left_out().empty());

    const auto whole = with.compile(beside(strong), diagnostics::unlimited);
    ASSERT_NE(whole, nullptr);
    EXPECT_EQ(compressing.left_out(), std::set<TermId>{strong});
    process::TermSystem reference(semantics, beside(hidden));
    EXPECT_TRUE(lts::are_bisimilar(graph_of(*whole), graph_of(reference)));
    EXPECT_EQ(whole->combined().components.size(), 3U) << "the pair's two and the one beside it";

    const auto alone = with.compile(strong, diagnostics::unlimited);
    ASSERT_NE(alone, nullptr) << "no compression, but a pair to take apart";
    EXPECT_EQ(graph_of(*alone).size(), states_of_pair);
    process::TermSystem stepped(compressing, strong);
    EXPECT_EQ(graph_of(stepped).size(), states_of_pair);
}

/// Combines two random processes by one operator.
process::TermId joined(refine::Translation& translation, const refine::naive::Script& script, unsigned how) {
    Scripted& s = translation.scripted();
    const TermId p = translation.term(script.mains[0]);
    const TermId q = translation.term(script.mains[1]);
    const TermId both = s.over(Op::parallel, {p, q}, {"a"});
    switch (how) {
        case 0:
            return s.over(Op::parallel, {p, q, p}, {});
        case 1:
            return s.over(Op::hide, {s.over(Op::parallel, {p, q}, {"a", "b"})}, {"b"});
        case 2:
            return s.op(Op::sequential, {both, both});
        case 3:
            return s.over(Op::exception, {both, q}, {"a"});
        case 4:
            return s.op(Op::interrupt, {both, q});
        case 5:
            return s.op(Op::external_choice, {both, p, both});
        case 6:
            return s.op(Op::sliding, {both, both});
        case 7:
            return s.prioritise(s.over(Op::parallel, {s.prioritise(both, {{"b"}, {"c"}}), q}, {"c"}), {{"a"}, {"b"}});
        default:
            return s.menu({{"a", both}, {"b", s.op(Op::internal_choice, {both, q})}});
    }
}

RC_GTEST_PROP(CompiledProperty, RandomCompositionsDoWhatTheirTermsDo, ()) {
    const auto list = *rc::gen::container<std::vector<unsigned>>(rc::gen::inRange<unsigned>(0, 2520));
    const auto how = *rc::gen::inRange<unsigned>(0, 9);
    refine::Translation translation(refine::naive::Decoder(list).script(2));
    const TermId term = joined(translation, refine::naive::Decoder(list).script(2), how);
    try {
        process::TermSystem reference(translation.semantics(), term);
        const lts::Graph graph = graph_of(reference);
        Compiler compiler(translation.semantics());
        const auto system = compiler.compile(term, diagnostics::unlimited);
        if (system == nullptr) RC_DISCARD("left as a term: a bound of the compiler");
        RC_ASSERT(lts::are_bisimilar(graph_of(*system), graph));
    } catch (const lts::TooLarge&) {
        RC_DISCARD("too large");
    } catch (const process::SemanticsError&) {
        RC_DISCARD("no semantics");
    }
}

}  // namespace
}  // namespace robochart::machine
