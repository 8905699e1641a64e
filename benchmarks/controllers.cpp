// SPDX-License-Identifier: Apache-2.0
// Measures the nanoseconds of one control cycle of the generated controllers, with events that are unknown at compile
// time.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>

#include "AggregationFSM.hpp"
#include "SwarmTaxisFSM.hpp"

namespace {

/// Returns a fixed stream of pseudo-random bits (xorshift64), so that every run has the same events.
std::array<std::uint8_t, 4096> stream() {
    std::array<std::uint8_t, 4096> bits{};
    std::uint64_t x = 88172645463325252ULL;
    for (std::uint8_t& byte : bits) {
        x ^= x << 13U;
        x ^= x >> 7U;
        x ^= x << 17U;
        byte = static_cast<std::uint8_t>(x >> 32U);
    }
    return bits;
}

void aggregation_cycle(benchmark::State& state) {
    const auto bits = stream();
    aggregation::AggregationFSM robot;
    std::size_t i = 0;
    for (auto _ : state) {
        const std::uint8_t now = bits[i++ % bits.size()];
        robot.seeWall = (now & 1U) != 0;
        robot.seeRobot = (now & 2U) != 0;
        benchmark::DoNotOptimize(robot.step());
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(aggregation_cycle);

/// An empty platform, because only the cycle is measured.
class Taxi : public swarm_taxis::SwarmTaxisFSM {
    void MoveForward() override {}
    void CheckIlluminationStatus() override {}
    void CalcCoherenceHeading() override {}
    void CalcAvoidanceHeading() override {}
    void StartTurning(double /*degree*/) override {}
};

void swarm_taxis_cycle(benchmark::State& state) {
    const auto bits = stream();
    Taxi robot;
    std::size_t i = 0;
    for (auto _ : state) {
        const std::uint8_t now = bits[i++ % bits.size()];
        robot.robotDetected = (now & 1U) != 0;
        robot.turned = (now & 2U) != 0;
        benchmark::DoNotOptimize(robot.step());
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(swarm_taxis_cycle);

}  // namespace
