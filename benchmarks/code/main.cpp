// Runs the back ends. With CHECK, it compares their stores over 20,000 random events. Otherwise, it compares their time
// with that of the hand-written switch, on a random stream of 65,536 events and on a stream that repeats after 16
// events.
//
// Prints a line per machine and stream: nanoseconds per step of the switch, of the switch compiled a second time, and of
// the generated code.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

#ifdef CHECK
std::uint64_t reported = 0;
#else
#include "benchmarks/cpu_time.hpp"
volatile std::uint32_t actuator = 0;
#endif

#define DECLARE(name)                                         \
    void name##_run(void*, const std::uint8_t*, std::size_t); \
    void name##_begin(void*);                                 \
    std::size_t name##_size();
#define DECLARE_ALL(machine) DECLARE(machine##_switch) DECLARE(machine##_again) DECLARE(machine##_generated)
DECLARE_ALL(m1)
DECLARE_ALL(m2)
DECLARE_ALL(m3)
DECLARE_ALL(m4)

namespace {

struct BackEnd {
    void (*run)(void* state, const std::uint8_t* events, std::size_t count);
    void (*begin)(void*);
    std::size_t (*size)();
};

struct Machine {
    const char* name;
    unsigned events;
    BackEnd by_hand;
    BackEnd again;  ///< the switch compiled a second time, to show the noise
    BackEnd generated;
};

#define BACK_END(name) \
    { name##_run, name##_begin, name##_size }
#define MACHINE(name, events) \
    { #name, events, BACK_END(name##_switch), BACK_END(name##_again), BACK_END(name##_generated) }
constexpr Machine machines[] = {MACHINE(m1, 2), MACHINE(m2, 4), MACHINE(m3, 8), MACHINE(m4, 8)};

std::vector<std::uint8_t> random_events(unsigned events, std::size_t length) {
    std::vector<std::uint8_t> result(length);
    std::uint64_t x = 88172645463325252ULL;
    for (std::uint8_t& event : result) {
        x ^= x << 13U;
        x ^= x >> 7U;
        x ^= x << 17U;
        event = static_cast<std::uint8_t>((x >> 32U) % events);
    }
    return result;
}

using Memory = std::array<unsigned char, 256>;

#ifdef CHECK
std::uint64_t hash(const BackEnd& end, unsigned events) {
    alignas(16) Memory memory{};
    reported = 14695981039346656037ULL;
    end.begin(memory.data());
    const std::vector<std::uint8_t> stream = random_events(events, 20000);
    end.run(memory.data(), stream.data(), stream.size());
    return reported;
}

bool equal(const Machine& machine) {
    const bool same = hash(machine.by_hand, machine.events) == hash(machine.generated, machine.events);
    std::printf("%s: %s; sizeof(State) %zu by hand, %zu ours\n", machine.name, same ? "equal" : "DIFFERENT",
                machine.by_hand.size(), machine.generated.size());
    return same;
}
#else
constexpr std::size_t length = 65536;
constexpr int passes = 20;

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// Returns the nanoseconds per step, as the median of the passes over the stream without the first ones.
double time(const BackEnd& end, const std::vector<std::uint8_t>& events) {
    alignas(16) Memory memory{};
    end.begin(memory.data());
    std::vector<double> times;
    for (int i = -passes / 4; i < passes; ++i) {
        const double start = robochart::thread_cpu_seconds();
        end.run(memory.data(), events.data(), events.size());
        if (i >= 0) times.push_back((robochart::thread_cpu_seconds() - start) * 1e9 / static_cast<double>(length));
    }
    return median(times);
}

void compare(const Machine& machine, bool random) {
    std::vector<std::uint8_t> events = random_events(machine.events, length);
    for (std::size_t i = 16; i < length && !random; ++i) events[i] = events[i % 16];
    std::printf("%s %s %.3f %.3f %.3f\n", machine.name, random ? "rand" : "pat", time(machine.by_hand, events),
                time(machine.again, events), time(machine.generated, events));
}
#endif

}  // namespace

int main() {
#ifdef CHECK
    bool all = true;
    for (const Machine& machine : machines) all = equal(machine) && all;
    return all ? 0 : 1;
#else
    for (const Machine& machine : machines)
        for (const bool random : {true, false}) compare(machine, random);
#endif
}
