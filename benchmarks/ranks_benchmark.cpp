// SPDX-License-Identifier: Apache-2.0
// Level searches with threads as ranks, more of them than cores (docs/scale.md): the processor time of each rank, level
// by level. The critical path is the sum over levels of the maximal processor time of a rank: the duration of a search
// in which every rank has its own core and messages take no time. The table also contains the prediction of a model
// from the widths of the levels. Messages, their bytes and memory are those of programs with one or several ranks each.
// Prints a table; exits with 1 if numbers of ranks lead to different numbers of states or transitions.
//
//   benchmark_ranks SCRIPT NUMBER TIMES RANKS...    searches all states of the process in the script's assertion with
//                                                   this number; the minimum over TIMES searches counts for each rank
//                                                   and level
//
// RANKS is a number of programs with one rank each, or PROGRAMSxTHREADS for programs with THREADS ranks each.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>

#include "base/diagnostics/render.hpp"
#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/refine/levels/level_search.hpp"
#include "checker/refine/levels/memory_row_store.hpp"
#include "checker/refine/levels/thread_exchange.hpp"
#include "checker/refine/verdict/monitors.hpp"

namespace {

using namespace robochart;

/// One level of a state space.
struct Width {
    double states = 0, transitions = 0;
};

struct Measured {
    std::uint64_t states = 0, transitions = 0;
    double critical = 0;  ///< seconds: sum over levels of the maximal time of a rank
    double total = 0;     ///< seconds: sum over all ranks
    std::uint64_t crossing = 0, bytes = 0, messages = 0, rounds = 0;
    std::uint64_t most_bytes = 0;              ///< rows and messages; maximum over programs
    std::vector<Width> widths;                 ///< measured with one rank
    std::vector<std::vector<double>> seconds;  ///< indices: rank, then level
};

/// Programs with this number of ranks each.
struct Count {
    unsigned programs = 1, threads = 1;
    [[nodiscard]] unsigned ranks() const { return programs * threads; }
    [[nodiscard]] std::string text() const {
        return threads == 1 ? std::to_string(programs) : fmt::format("{} x {}", programs, threads);
    }
};

/// The work of one rank.
struct RankFigures {
    std::vector<double> seconds;
    std::uint64_t crossing = 0, bytes = 0;
};

Measured measure(const lts::TransitionSystem& system, const Count& count) {
    const unsigned ranks = count.ranks();
    Measured result;
    std::vector<RankFigures> figures(ranks);
    std::vector<refine::Exchange::Traffic> traffic(count.programs);
    std::vector<std::unique_ptr<lts::TransitionSystem>> systems;
    for (unsigned rank = 0; rank < ranks; ++rank) systems.push_back(system.clone_for_thread());
    const refine::Limits limits;
    const auto search_as_rank = [&](refine::Exchange& exchange) {
        refine::StateMonitor monitor(false);
        refine::Budget budget(limits);
        lts::TransitionSystem& own = *systems[exchange.rank()];
        refine::MemoryRowStore store(own.width());
        refine::LevelSearch search(own, monitor, store, exchange, budget, false);
        search.first_violation();
        figures[exchange.rank()] = {search.level_seconds(), search.crossing_rows(), search.peak_bytes()};
        if (exchange.rank() != 0) return;
        result.rounds = exchange.traffic().rounds;
        result.states = search.states();
        result.transitions = search.transitions();
        if (ranks > 1) return;
        const auto& expanded = store.record().expanded;
        for (refine::Level level = 0; level < expanded.size(); ++level)
            result.widths.push_back(
                {static_cast<double>(store.rows(level)), static_cast<double>(expanded[level].transitions)});
    };
    refine::as_ranks(count.programs, [&](refine::Exchange& programs) {
        refine::as_ranks(programs, count.threads, search_as_rank);
        traffic[programs.rank()] = programs.traffic();
    });
    for (unsigned program = 0; program < count.programs; ++program) {
        result.bytes += traffic[program].bytes;
        result.messages += traffic[program].messages;
        std::uint64_t bytes = 0;
        for (unsigned thread = 0; thread < count.threads; ++thread) {
            RankFigures& rank = figures[program * count.threads + thread];
            result.crossing += rank.crossing;
            bytes += rank.bytes;
            result.seconds.push_back(std::move(rank.seconds));
        }
        result.most_bytes = std::max(result.most_bytes, bytes);
    }
    return result;
}

/// Takes the minimum for each rank and level, because other programs on the machine can only increase a time.
void take_least(Measured& least, const Measured& again) {
    for (std::size_t rank = 0; rank < least.seconds.size(); ++rank)
        for (std::size_t level = 0; level < least.seconds[rank].size(); ++level)
            least.seconds[rank][level] = std::min(least.seconds[rank][level], again.seconds[rank][level]);
}

void sum_up(Measured& measured) {
    for (std::size_t level = 0; level < measured.seconds.front().size(); ++level) {
        double largest = 0;
        for (const std::vector<double>& rank : measured.seconds) {
            largest = std::max(largest, rank[level]);
            measured.total += rank[level];
        }
        measured.critical += largest;
    }
}

/// Returns the expected maximum of `ranks` independent Poisson loads with this mean.
double largest_load(double mean, unsigned ranks) {
    if (ranks == 1) return mean;
    const double spread = std::sqrt(mean);
    const double low = std::max(0.0, std::floor(mean - 8 * spread));
    const double step = std::max(1.0, std::floor(spread / 50));
    double below = 0, value = low;
    const auto probability = [&](double k) { return std::exp(k * std::log(mean) - mean - std::lgamma(k + 1)); };
    double result = low;
    for (; value < mean + 10 * spread + 10; value += step) {
        below = std::min(1.0, below + step * probability(value));
        result += step * (1 - std::pow(below, ranks));
    }
    return result;
}

struct Network {
    const char* name;
    double latency;         ///< seconds
    double seconds_a_byte;  ///< for a rank's share; 0: messages take no time
};

/// Returns the predicted seconds of all levels: the rank with the most work, its messages, and the collective
/// operations.
double predicted(const std::vector<Width>& widths, unsigned ranks, double seconds_a_transition, double bytes_a_row,
                 const Network& network, double scale = 1) {
    double sum = 0;
    const double others = ranks - 1.0;
    for (const Width& level : widths) {
        if (level.states == 0) continue;
        const double width = level.states * scale, degree = level.transitions / level.states;
        const double load = largest_load(width / ranks, ranks) * degree;
        sum += load * seconds_a_transition;
        if (ranks == 1) continue;
        sum += load * others / ranks * bytes_a_row * network.seconds_a_byte;
        sum += (3 * std::ceil(std::log2(ranks)) + std::min(others, width * degree / ranks) * 0.3) * network.latency;
    }
    return sum;
}

void print_predictions(const Measured& alone, double a_transition, double bytes_a_row) {
    constexpr Network networks[] = {{"InfiniBand 100 Gb", 1.5e-6, 16 / 12e9}, {"25 GbE, TCP", 25e-6, 16 / 3e9}};
    std::cout << "\npredicted speed-up, 16 ranks a node, usual values of networks (not measured):\n\n"
                 "| levels | network | 16 | 64 | 256 | 1024 |\n| --- | --- | --- | --- | --- | --- |\n";
    for (const double scale : {1.0, 100.0})
        for (const Network& network : networks) {
            std::cout << fmt::format("| {} | {} |", scale == 1 ? "as they are" : "100 times as wide", network.name);
            const double one = predicted(alone.widths, 1, a_transition, bytes_a_row, network, scale);
            for (const unsigned ranks : {16U, 64U, 256U, 1024U})
                std::cout << fmt::format(
                    " {:.3g} |", one / predicted(alone.widths, ranks, a_transition, bytes_a_row, network, scale));
            std::cout << "\n";
        }
}

/// Measures all numbers of ranks in turn, so that a disturbance affects all of them.
std::vector<Measured> measure_all(unsigned times, const lts::TransitionSystem& system,
                                  const std::vector<Count>& counts) {
    std::vector<Measured> all;
    for (const Count& count : counts) all.push_back(measure(system, count));
    for (unsigned i = 1; i < times; ++i)
        for (std::size_t at = 0; at < counts.size(); ++at) take_least(all[at], measure(system, counts[at]));
    for (Measured& measured : all) sum_up(measured);
    return all;
}

int run(const std::string& path, std::size_t number, unsigned times, const std::vector<Count>& counts) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics found;
    cspm::Session session(cspm::read_file(sources, path, found));
    if (!found.ok()) {
        std::cerr << diagnostics::render_text(sources, found);
        return 2;
    }
    const auto assertions = session.assertions();
    if (number == 0 || number > assertions.size()) {
        std::cerr << "there is no such assertion\n";
        return 2;
    }
    const cspm::Assertion& assertion = assertions[number - 1]->assertion;
    const bool refinement = assertion.kind == cspm::AssertionKind::refinement;
    const auto system = session.system(refinement ? assertion.implementation : assertion.specification);
    if (!system->clone_for_thread()) {
        std::cerr << "the process stays a term\n";
        return 2;
    }
    const std::vector<Measured> all = measure_all(times, *system, counts);
    bool same = true;
    std::cout << "| ranks | states | transitions | levels | critical path s | speed-up | model | CPU of all / of one | "
                 "crossing | B a crossing row | messages | rounds | B a state | of one's share |\n"
                 "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (std::size_t at = 0; at < counts.size(); ++at) {
        const unsigned ranks = counts[at].ranks();
        const Measured& one = all.front();
        const Measured& now = all[at];
        same = same && now.states == one.states && now.transitions == one.transitions;
        const double a_transition = one.total / static_cast<double>(one.transitions);
        constexpr Network none{"none", 0, 0};
        const double model = one.widths.empty() ? 0
                                                : predicted(one.widths, 1, a_transition, 0, none) /
                                                      predicted(one.widths, ranks, a_transition, 0, none);
        const auto ratio = [](std::uint64_t a, std::uint64_t b) {
            return b == 0 ? 0 : static_cast<double>(a) / static_cast<double>(b);
        };
        std::cout << fmt::format(
            "| {} | {} | {} | {} | {:.3f} | {:.2f} | {:.2f} | {:.2f} | {:.3f} | {:.2f} | {} | {} | {:.1f} | {:.2f} |\n",
            counts[at].text(), now.states, now.transitions, one.widths.size() + 1, now.critical,
            one.critical / now.critical, model, now.total / one.total, ratio(now.crossing, now.transitions),
            ratio(now.bytes, now.crossing), now.messages, now.rounds,
            ratio(now.most_bytes * counts[at].programs, now.states),
            ratio(now.most_bytes * counts[at].programs, one.most_bytes));
    }
    if (!all.front().widths.empty())
        print_predictions(all.front(), all.front().total / static_cast<double>(all.front().transitions),
                          static_cast<double>(system->width() * sizeof(lts::Word)));
    return same ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 5) {
        std::cerr << "benchmark_ranks SCRIPT NUMBER TIMES RANKS...\n";
        return 4;
    }
    std::vector<Count> counts;
    for (int i = 4; i < argc; ++i) {
        const std::string words = argv[i];
        const std::size_t times = words.find('x');
        const auto number = [](const std::string& digits) { return static_cast<unsigned>(std::stoul(digits)); };
        counts.push_back({number(words), times == std::string::npos ? 1 : number(words.substr(times + 1))});
    }
    return run(argv[1], std::stoul(argv[2]), static_cast<unsigned>(std::stoul(argv[3])), counts);
}
