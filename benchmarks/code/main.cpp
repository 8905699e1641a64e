// Times the back ends: with CHECK compares what they store over 20,000 random events, else Google Benchmark with a
// random stream of 65,536 events and one that repeats after 16.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#ifdef CHECK
std::uint64_t told = 0;
#else
#include <benchmark/benchmark.h>
volatile std::uint32_t actuator = 0;
#endif

#define DECLARE(name)                  \
    void name##_step(void*, unsigned); \
    void name##_begin(void*);          \
    std::size_t name##_size();
#define BOTH(machine) DECLARE(machine##_generated) DECLARE(machine##_switch)
BOTH(m1)
BOTH(m2) BOTH(m3) BOTH(m4)

    namespace {
    struct BackEnd {
        const char* name;
        void (*step)(void*, unsigned);
        void (*begin)(void*);
        std::size_t (*size)();
        unsigned events;
    };
#define ROWS(machine, events)                                                                                        \
    {#machine "/switch", machine##_switch_step, machine##_switch_begin, machine##_switch_size, events}, {            \
#machine "/generated", machine##_generated_step, machine##_generated_begin, machine##_generated_size, events \
    }
    constexpr BackEnd back_ends[] = {ROWS(m1, 2), ROWS(m2, 4), ROWS(m3, 8), ROWS(m4, 8)};

    std::vector<std::uint8_t> stream(unsigned events, std::size_t length, std::uint64_t seed) {
        std::vector<std::uint8_t> result(length);
        std::uint64_t x = seed;
        for (std::uint8_t& event : result) {
            x ^= x << 13U;
            x ^= x >> 7U;
            x ^= x << 17U;
            event = static_cast<std::uint8_t>((x >> 32U) % events);
        }
        return result;
    }

    alignas(16) std::array<unsigned char, 256> memory;

#ifdef CHECK
    std::uint64_t hash(const BackEnd& end) {
        told = 14695981039346656037ULL;
        end.begin(memory.data());
        for (const std::uint8_t event : stream(end.events, 20000, 88172645463325252ULL)) end.step(memory.data(), event);
        return told;
    }
#else
    void run(benchmark::State & state, const BackEnd& end, std::size_t length) {
        // The pattern repeats after 16 events; both are as long in memory.
        const auto pattern = stream(end.events, length, 88172645463325252ULL);
        std::vector<std::uint8_t> events(65536);
        for (std::size_t i = 0; i < events.size(); ++i) events[i] = pattern[i % length];
        end.begin(memory.data());
        for (auto _ : state)
            for (const std::uint8_t event : events) end.step(memory.data(), event);
        state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                                static_cast<std::int64_t>(events.size()));
    }
#endif

}  // namespace

int main([[maybe_unused]] int argc, [[maybe_unused]] char** argv) {
#ifdef CHECK
    bool equal = true;
    for (std::size_t i = 0; i < std::size(back_ends); i += 2) {
        const bool same = hash(back_ends[i]) == hash(back_ends[i + 1]);
        std::printf("%s: %s; sizeof(State) %zu and %zu\n", back_ends[i].name, same ? "equal" : "DIFFERENT",
                    back_ends[i].size(), back_ends[i + 1].size());
        equal = equal && same;
    }
    return equal ? 0 : 1;
#else
    for (const BackEnd& end : back_ends) {
        benchmark::RegisterBenchmark((std::string(end.name) + "/rand").c_str(),
                                     [&end](auto& s) { run(s, end, 65536); });
        benchmark::RegisterBenchmark((std::string(end.name) + "/pat").c_str(), [&end](auto& s) { run(s, end, 16); });
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
#endif
}
