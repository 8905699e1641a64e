// SPDX-License-Identifier: Apache-2.0
// Times a cycle of the detector with three windows over 360 readings (models/scan_windows.rct). Only the last window
// contains a near reading, so each cycle evaluates all three. Prints nanoseconds of CPU time per cycle, and the size of
// the state.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <new>

#include "Detector_core.hpp"

namespace core = scan_windows::Detector_core;
using Types = robochart::Deployment;

static std::size_t allocations = 0;
void* operator new(std::size_t size) {
    ++allocations;
    if (void* const memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

struct Platform {
    std::size_t seen = 0;
    void send_seen(core::Side side) noexcept { seen += side == core::Side::starboard ? 1 : 0; }
};

int main() {
    constexpr int cycles = 1'000'000;
    core::Inputs<Types> inputs;
    for (int place = 1; place <= 360; ++place) inputs.scan.value.append(place == 300 ? 0.25 : 1 + place % 7);
    core::State<Types> state = core::init<Types>();
    Platform platform;
    const std::clock_t begin = std::clock();
    for (int cycle = 0; cycle < cycles; ++cycle) {
        inputs.scan.present = true;
        if (core::step(state, inputs, platform) != robochart::StepResult::quiescent) return 1;
    }
    const double time = 1e9 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (platform.seen != cycles) return 1;
    std::printf("%.0f ns per cycle, %zu bytes of state, %zu allocations\n", time / cycles, sizeof state,
                allocations);
}
