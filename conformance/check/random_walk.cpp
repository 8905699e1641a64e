// SPDX-License-Identifier: Apache-2.0
// See random_walk.hpp. Executes the code directly, and follows the model in NF_c(M), determinised on the fly.
#include "conformance/check/random_walk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <random>
#include <unordered_set>

#include "conformance/check/carrier_limited.hpp"
#include "conformance/check/follower.hpp"
#include "conformance/check/standstill.hpp"
#include "conformance/code/code_system.hpp"
#include "conformance/code/cycle_log.hpp"
#include "conformance/code/watchdog.hpp"

namespace robochart::conformance {

namespace {

using Node = Follower::Node;
/// The readings of one cycle, by register: 0 for absent, otherwise 1 + the index of the value.
using Readings = std::vector<std::uint32_t>;
using Bytes = std::vector<unsigned char>;

constexpr std::uint64_t most_states = 50'000'000;

struct Position {
    Bytes image;
    Node node = 0;
};

class Walker {
public:
    Walker(ModelGraph& model, const Alphabet& alphabet, const rc_interface& code, std::uint32_t cycle_length,
           const refine::Limits& limits)
        : alphabet_(alphabet),
          code_(code),
          cycle_length_(std::max(1U, cycle_length)),
          follower_(model, alphabet, cycle_length, limits) {}

    /// Tells the follower that the steps of the model are unknown where a value leaves its carrier. The system must be
    /// that of the model graph.
    void end_where_unknown(const CarrierLimited& model) {
        follower_.end_where([&model](lts::StateView state) { return model.is_unknown(state); });
    }

    [[nodiscard]] Position start_position() {
        Position position{Bytes(code_.state_size), follower_.initial_node()};
        code_.initial(position.image.data());
        return position;
    }

    /// Executes one cycle. Returns no value if code and model agree, or if the code has terminated. Appends the common
    /// events before the tocks to `agreed`.
    std::optional<Mismatch> run_cycle(Position& at, const Readings& readings, Cycle* reported = nullptr,
                                      std::vector<process::Event>* agreed = nullptr) {
        std::vector<rc_register> registers;
        for (const std::uint32_t reading : readings)
            registers.push_back({reading == 0 ? 0U : 1U, reading == 0 ? 0U : reading - 1});
        for (std::uint32_t i = 0; i < readings.size(); ++i) {
            const process::Event read = alphabet_.read_event(i, readings[i]);
            if (reported != nullptr && readings[i] != 0) reported->inputs.push_back(alphabet_.describe_event(read));
            if (auto mismatch = follower_.follow_event(at.node, read, true)) return mismatch;
            if (agreed != nullptr) agreed->push_back(read);
        }
        CycleLog log;
        const Bytes before = at.image;
        rc_result outcome = step_watched(code_, at.image.data(), registers.data(), &log).result;
        while (log.is_cut() && log.grow()) {
            at.image = before;
            outcome = step_watched(code_, at.image.data(), registers.data(), &log).result;
        }
        if (reported != nullptr) reported->state = print_state(at.image);
        for (std::uint32_t r = 0; r < log.count; ++r) {
            const rc_record& record = log.record[r];
            const process::Event write =
                alphabet_.write_event(record.output, {record.argument, record.argument + record.count});
            if (reported != nullptr) reported->outputs.push_back(alphabet_.describe_event(write));
            if (auto mismatch = follower_.follow_event(at.node, write, false)) return mismatch;
            if (agreed != nullptr) agreed->push_back(write);
        }
        return follower_.finish_cycle(at.node, outcome, log.overflow != 0);
    }

    [[nodiscard]] bool has_terminated() const { return follower_.has_terminated(); }
    [[nodiscard]] std::uint32_t cycle_length() const { return cycle_length_; }
    [[nodiscard]] std::size_t node_count() const { return follower_.node_count(); }
    [[nodiscard]] std::string print_state(const Bytes& image) const { return state_text(code_.print, image.data()); }

private:
    const Alphabet& alphabet_;
    const rc_interface& code_;
    std::uint32_t cycle_length_;
    Follower follower_;
};

/// A position at which a walk covered something new. Other walks continue from it.
struct Find {
    Position position;
    std::size_t from = 0;
    std::vector<Readings> way;  ///< readings since `from`
    std::uint32_t used = 0;
};

class Search {
public:
    Search(Walker& walker, const Alphabet& alphabet, const WalkOptions& options)
        : walker_(walker), alphabet_(alphabet), options_(options), random_(options.seed) {
        finds_.push_back({walker.start_position(), 0, {}, 0});
        remember_position(finds_.front().position);
    }

    Result run() {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(options_.seconds);
        while (cycles_ < options_.cycles && std::chrono::steady_clock::now() < end)
            if (auto mismatch = one_walk()) return result_of(std::move(*mismatch), " (found by guided walks)");
        Result result;
        result.reason = coverage_summary();
        count_coverage(result);
        return result;
    }

    std::optional<Result> difference_on(std::vector<Readings> way) {
        auto mismatch = find_difference(way);
        if (!mismatch) return std::nullopt;
        way_ = std::move(way);
        return result_of(std::move(*mismatch), "");
    }

    [[nodiscard]] std::string coverage_summary() const {
        std::string result = fmt::format(
            "no difference in {} guided walks of {} cycles together, which met {} states of the code and "
            "{} of the normal form",
            walks_, cycles_, images_.size(), walker_.node_count());
        if (left_ > 0)
            result += fmt::format("; {} of these walks ended where a value of the model leaves its carrier", left_);
        return result;
    }

private:
    std::uint32_t random_below(std::uint32_t bound) {
        return bound == 0 ? 0 : static_cast<std::uint32_t>(random_() % bound);
    }

    /// Chooses three positions at random and returns the one that was used least.
    std::size_t pick_find() {
        std::size_t best = random_below(static_cast<std::uint32_t>(finds_.size()));
        for (int n = 0; n < 2; ++n) {
            const std::size_t other = random_below(static_cast<std::uint32_t>(finds_.size()));
            if (finds_[other].used < finds_[best].used) best = other;
        }
        ++finds_[best].used;
        return best;
    }

    Readings random_readings(std::uint32_t percent) {
        Readings result;
        for (const Register& input : alphabet_.interface().inputs)
            result.push_back(random_below(100) < percent ? 1 + random_below(input.reading_count() - 1) : 0);
        return result;
    }

    std::optional<Mismatch> one_walk() {
        ++walks_;
        const std::size_t from = pick_find();
        Position at = finds_[from].position;
        std::vector<Readings> way;
        constexpr std::array<std::uint32_t, 5> shares{0, 10, 30, 60, 95};
        const std::uint32_t percent = shares[random_below(shares.size())];
        const std::uint32_t length = 1 + random_below(40);
        for (std::uint32_t c = 0; c < length && cycles_ < options_.cycles; ++c) {
            way.push_back(random_readings(percent));
            ++cycles_;
            auto mismatch = walker_.run_cycle(at, way.back());
            if (mismatch && mismatch->outcome == Outcome::inconclusive) {
                ++left_;
                return std::nullopt;
            }
            if (mismatch) {
                way_ = whole_way(from, way);
                return mismatch;
            }
            if (walker_.has_terminated()) return std::nullopt;
            if (remember_position(at) && finds_.size() < most_finds) finds_.push_back({at, from, way, 0});
        }
        return std::nullopt;
    }

    bool remember_position(const Position& at) {
        const bool image = images_.emplace(at.image.begin(), at.image.end()).second;
        return nodes_.insert(at.node).second || image;
    }

    std::vector<Readings> whole_way(std::size_t from, const std::vector<Readings>& last) const {
        std::vector<const std::vector<Readings>*> parts{&last};
        for (std::size_t at = from; at != 0; at = finds_[at].from) parts.push_back(&finds_[at].way);
        std::vector<Readings> way;
        for (auto part = parts.rbegin(); part != parts.rend(); ++part)
            way.insert(way.end(), (*part)->begin(), (*part)->end());
        return way;
    }

    // ------------------------------------------------------------ smaller witnesses

    /// Returns the mismatch if code and model differ on this path. The path is then truncated after that cycle.
    std::optional<Mismatch> find_difference(std::vector<Readings>& way) {
        Position at = walker_.start_position();
        for (std::size_t c = 0; c < way.size(); ++c) {
            if (auto mismatch = walker_.run_cycle(at, way[c])) {
                if (mismatch->outcome == Outcome::inconclusive) return std::nullopt;
                way.resize(c + 1);
                return mismatch;
            }
            if (walker_.has_terminated()) return std::nullopt;
        }
        return std::nullopt;
    }

    /// Removes cycles, then inputs, as long as the difference stays the same.
    void shrink_run(Mismatch& mismatch) {
        std::size_t tries = 2000;
        const auto attempt = [&](std::vector<Readings> smaller) {
            if (tries-- == 0) return false;
            auto found = find_difference(smaller);
            if (!found || found->outcome != mismatch.outcome) return false;
            way_ = std::move(smaller);
            mismatch = std::move(*found);
            return true;
        };
        for (std::size_t step = std::max<std::size_t>(1, way_.size() / 2); step > 0 && tries > 1; step /= 2)
            for (std::size_t c = 0; c + step <= way_.size() && tries > 1;) {
                std::vector<Readings> smaller = way_;
                smaller.erase(smaller.begin() + static_cast<std::ptrdiff_t>(c),
                              smaller.begin() + static_cast<std::ptrdiff_t>(c + step));
                if (!attempt(std::move(smaller))) c += step;
            }
        for (std::size_t c = 0; c < way_.size() && tries > 1; ++c)
            for (std::size_t i = 0; c < way_.size() && i < way_[c].size() && tries > 1; ++i) {
                std::vector<Readings> smaller = way_;
                if (smaller[c][i] == 0) continue;
                smaller[c][i] = 0;
                attempt(std::move(smaller));
            }
    }

    Result result_of(Mismatch mismatch, const char* how) {
        shrink_run(mismatch);
        Result result;
        result.outcome = mismatch.outcome;
        result.reason = mismatch.reason + how;
        result.expected = mismatch.expected;
        Position at = walker_.start_position();
        std::vector<process::Event> trace;
        for (const Readings& readings : way_) {
            Cycle& cycle = result.cycles.emplace_back();
            if (walker_.run_cycle(at, readings, &cycle, &trace)) break;
            trace.insert(trace.end(), walker_.cycle_length(), alphabet_.tock());
        }
        set_model_run(result, mismatch.rule, trace);
        count_coverage(result);
        return result;
    }

    void count_coverage(Result& result) const {
        result.code_states = images_.size();
        result.code_cycles = cycles_;
    }

    static constexpr std::size_t most_finds = 200'000;
    Walker& walker_;
    const Alphabet& alphabet_;
    const WalkOptions& options_;
    std::mt19937_64 random_;
    std::vector<Find> finds_;
    std::unordered_set<std::string> images_;  ///< never iterated
    std::unordered_set<Node> nodes_;          ///< never iterated
    std::vector<Readings> way_;               ///< path to the position of the difference
    std::uint64_t walks_ = 0;
    std::uint64_t cycles_ = 0;
    std::uint64_t left_ = 0;  ///< number of walks that ended where a value of the model leaves its carrier
};

}  // namespace

std::optional<Result> difference_on(ModelGraph& model, const Alphabet& alphabet, const rc_interface& code,
                                    std::uint32_t cycle_length, const refine::Limits& limits,
                                    std::vector<std::vector<std::uint32_t>> way) {
    Walker walker(model, alphabet, code, cycle_length, limits);
    const WalkOptions options;
    return Search(walker, alphabet, options).difference_on(std::move(way));
}

Result run_random_walks(lts::TransitionSystem& model, const Alphabet& alphabet, const rc_interface& code,
                        std::uint32_t cycle_length, const refine::Limits& limits, const WalkOptions& options) {
    refine::Limits bounds = limits;
    // A cycle of the model may take long, and the time limit of walks is checked only between cycles.
    bounds.deadline =
        std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                               std::chrono::duration<double>(2 * options.seconds + 1));
    bounds.max_states = most_states;  // the limit that ended the search; walks have their own limit of cycles
    CarrierLimited limited(model, alphabet.tock());
    ModelGraph graph(limited, alphabet);
    Walker walker(graph, alphabet, code, cycle_length, bounds);
    walker.end_where_unknown(limited);
    std::optional<Search> search;
    Result result;
    try {
        search.emplace(walker, alphabet, options);
        result = search->run();
    } catch (const process::Interrupted& limit) {
        result.reason = search ? fmt::format("{} ({})", search->coverage_summary(), limit.what()) : limit.what();
    }
    result.model_states = graph.size();
    return result;
}

}  // namespace robochart::conformance
