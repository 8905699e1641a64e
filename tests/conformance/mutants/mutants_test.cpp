// SPDX-License-Identifier: Apache-2.0
// Seeds faults of the generator in every construct that it writes (cpp_emit/plan/fault.hpp, which includes RoboTool's
// faults). Each mutant is killed, shown by the checker to be equivalent to the original, or a variant that the model
// allows for a reason listed here. ROBOCHART_MUTANTS=all tries all places and prints tables (tests/long.sh mutants). By
// default the test tries one place of each kind in most models, and three in models written for specific kinds. It
// omits kinds with three mutants that it has already killed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "tests/conformance/mutants/mutants.hpp"

namespace robochart::conformance {
namespace {

using cpp_emit::Fault;
using test::Fate;
using test::Mutant;

/// A variant that conforms but behaves differently from the original, because it resolves a choice of the model
/// differently.
struct Open {
    Fault fault;
    const char* model;  ///< the only model in which it may occur; null for any model
    const char* why;
};

constexpr Open open_choices[] = {
    {Fault::transitions_reversed, nullptr, "transitions of a state that are enabled together: the model takes any"},
    {Fault::outer_first, nullptr, "an inner and an outer transition enabled together: the model takes any"},
    {Fault::junction_reversed, nullptr,
     "outgoing transitions of a junction that are enabled together: the model takes any"},
    {Fault::way_exchanged, nullptr, "a probabilistic junction is a free choice of its ways"},
    {Fault::machines_reversed, nullptr, "machines act in any order within a cycle"},
    {Fault::statements_exchanged, "team",
     "a write reaches the other machines before or after what the writer does next"},
    {Fault::statements_exchanged, "wires",
     "a write reaches the other machines before or after what the writer does next"},
    {Fault::wrong_target, "choices", "one way of the probabilistic junction leads where the other does"},
    {Fault::wrong_output, "choices", "behind one way of the probabilistic junction is what is behind the other"},
};

/// Returns whether the fault only changes how a choice of the model is resolved. No test can kill such a fault.
bool decides_only(Fault fault) {
    return std::any_of(std::begin(open_choices), std::end(open_choices),
                       [&](const Open& open) { return open.fault == fault && open.model == nullptr; });
}

const char* reason_open(const std::string& model, const Mutant& mutant) {
    for (const Open& open : open_choices)
        if (open.fault == mutant.kind.fault && (open.model == nullptr || model.ends_with(open.model))) return open.why;
    return nullptr;
}

struct Count {
    std::size_t killed = 0, equivalent = 0, variants = 0;
    std::vector<std::size_t> cycles;  ///< lengths of the counterexamples of killed mutants

    [[nodiscard]] std::size_t mutants() const { return killed + equivalent + variants; }
    void add(const Mutant& mutant) {
        killed += mutant.fate == Fate::killed ? 1U : 0U;
        equivalent += mutant.fate == Fate::equivalent ? 1U : 0U;
        variants += mutant.fate == Fate::variant ? 1U : 0U;
        if (mutant.fate == Fate::killed && mutant.cycles > 0) cycles.push_back(mutant.cycles);
    }
};

class Mutants : public ::testing::Test {
protected:
    static bool all() {
        const char* const setting = std::getenv("ROBOCHART_MUTANTS");
        return setting != nullptr && std::string(setting) == "all";
    }

    void try_module(const std::string& folder, std::size_t sites) {
        test::Model model(folder);
        study_model(folder, test::Study(model, model.first_module()), sites);
    }
    void try_machine(const std::string& folder, const std::string& machine, std::size_t sites,
                     const ir::InstantiationOptions& options = {}) {
        test::Model model(folder, options);
        study_model(folder, test::Study(model, model.machine_named(machine)), sites);
    }
    /// Tries only faults of the event API, because these models contain little behaviour in a cycle.
    void try_events(const std::string& folder, const std::string& machine, cpp_emit::Strategy strategy) {
        test::Model model(folder);
        study_model(folder, test::Study(model, model.machine_named(machine), strategy), 3, true);
    }

    void study_model(const std::string& name, test::Study study, std::size_t sites, bool event_api_only = false) {
        const Result original = study.check_original();
        ASSERT_EQ(original.outcome, Outcome::conforms) << name << ": " << original.reason;
        for (const Mutant& mutant : study.mutants(all() ? 1000 : sites, event_api_only, often_killed())) {
            look_at(name, mutant);
            by_kind_[mutant.kind.fault].add(mutant);
            by_model_[name].add(mutant);
            whole_.add(mutant);
            if (mutant.fate == Fate::killed) ++by_[mutant.by];
        }
    }

    /// Returns the kinds that need no more models: by default, those with three killed mutants.
    [[nodiscard]] std::set<Fault> often_killed() const {
        std::set<Fault> kinds;
        if (all()) return kinds;
        for (const auto& [fault, count] : by_kind_)
            if (count.killed >= 3) kinds.insert(fault);
        return kinds;
    }

    void look_at(const std::string& name, const Mutant& mutant) const {
        EXPECT_NE(mutant.fate, Fate::undecided)
            << name << ": " << mutant.kind.name << " at " << mutant.site << ": " << mutant.reported;
        if (mutant.fate != Fate::variant) return;
        const char* const why = reason_open(name, mutant);
        EXPECT_NE(why, nullptr) << name << ": " << mutant.kind.name << " at " << mutant.site
                                << " conforms and does otherwise: " << mutant.reported;
        if (all() && why != nullptr)
            fmt::print("variant: {}, {} at {}: {}\n", name, mutant.kind.name, mutant.site, mutant.reported);
    }

    /// Fails if no mutant of some kind is killed, because the checker would then miss this kind.
    void expect_kills_of_every_kind() const {
        for (const cpp_emit::FaultKind& kind : cpp_emit::all_faults()) {
            if (cpp_emit::in_robosim(kind.fault)) continue;    // tested in check/robosim_test.cpp
            if (kind.fault == Fault::order_ignored) continue;  // no orders here; see cycle_claims_test.cpp
            const auto found = by_kind_.find(kind.fault);
            ASSERT_NE(found, by_kind_.end()) << kind.name << " is in no model";
            if (decides_only(kind.fault))
                EXPECT_EQ(found->second.killed, 0U) << kind.name;
            else
                EXPECT_GT(found->second.killed, 0U) << kind.name << " is killed nowhere";
        }
    }

    void print() const {
        fmt::print("{:24} {:>8} {:>8} {:>8} {:>8}  longest difference\n", "", "mutants", "killed", "same", "variant");
        const auto row = [](const std::string& name, const Count& count) {
            const std::size_t longest = count.cycles.empty() ? 0 : *std::ranges::max_element(count.cycles);
            fmt::print("{:24} {:8} {:8} {:8} {:8}  {}\n", name, count.mutants(), count.killed, count.equivalent,
                       count.variants, longest == 0 ? "-" : fmt::format("{} cycles", longest));
        };
        for (const cpp_emit::FaultKind& kind : cpp_emit::all_faults())
            if (by_kind_.contains(kind.fault)) row(kind.name, by_kind_.at(kind.fault));
        for (const auto& [model, count] : by_model_) row(model.substr(model.rfind('/') + 1), count);
        row("all", whole_);
        for (const auto& [by, count] : by_) fmt::print("killed by {:40} {:6}\n", by, count);
        for (const std::size_t most : {1U, 2U, 3U, 4U, 5U, 6U, 8U, 12U, 20U, 40U}) {
            const auto within = static_cast<std::size_t>(
                std::ranges::count_if(whole_.cycles, [&](std::size_t cycles) { return cycles <= most; }));
            fmt::print("shortest difference within {:2} cycles: {:5.1f} %\n", most,
                       100.0 * static_cast<double>(within) / static_cast<double>(whole_.cycles.size()));
            if (within == whole_.cycles.size()) break;
        }
    }

    std::map<Fault, Count> by_kind_;
    std::map<std::string, Count> by_model_;
    std::map<std::string, std::size_t> by_;
    Count whole_;
};

TEST_F(Mutants, AreKilledOrEquivalentOrAllowed) {
    const std::string models = "tests/conformance/models/";
    try_module("corpus/aggregation", 1);
    try_module(test::changed_copy("corpus/swarm_taxis/swarm_taxis.rct", "25", "3").path(), 1);
    for (const char* module : {"nested", "parcels", "team"}) try_module(models + module, 1);
    for (const char* module : {"helpers", "wires"}) try_module(models + module, 1);
    try_machine(models + "tower", "Tower", 1);
    try_machine(models + "timing", "Timing", 2);
    try_machine(models + "choices", "Choices", 1);
    // the machine uses the numbers that it reads as indexes into sequences of two elements
    ir::InstantiationOptions few;
    few.ranges = {{"nat", {0, 2}}, {"int", {-2, 2}}};
    try_machine(models + "words", "Words", 2, few);
    try_machine(models + "outside", "Outside", 1);
    try_machine(models + "blink", "Blink", 1);
    try_machine(models + "missed", "Missed", 1);
    using cpp_emit::Strategy;
    try_events(models + "reacts", "Reacts", Strategy::table);
    if (all()) try_events(models + "reacts", "Reacts", Strategy::nested_switch);
    try_events(models + "due", "Due", Strategy::automatic);
    if (HasFatalFailure()) return;
    expect_kills_of_every_kind();
    EXPECT_GE(whole_.mutants(), 250U);
    fmt::print("{} mutants of {} kinds: {} killed, {} equivalent, {} variants\n", whole_.mutants(), by_kind_.size(),
               whole_.killed, whole_.equivalent, whole_.variants);
    if (all()) print();
}

}  // namespace
}  // namespace robochart::conformance
