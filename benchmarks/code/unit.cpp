// SPDX-License-Identifier: Apache-2.0
// Compiles one back end of one machine as a translation unit: a step that is not inlined, for an event that is unknown
// at compile time. MACHINE is m1 to m4, NAME is its name in the generated HEADER. BACK_END is switch, again or
// generated; GENERATED is 1 for the last. If TICKS is 1, events above 1 are time units.
#include <cstddef>
#include <cstdint>

#define TEXT_(x) #x
#define TEXT(x) TEXT_(x)
#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define OF_BACK_END(what) JOIN(MACHINE, JOIN(_, JOIN(BACK_END, what)))

#include "actuator.hpp"

#if GENERATED
#include TEXT(HEADER)
namespace core = MACHINE::JOIN(NAME, _core);

struct Register {
    void act(std::int32_t value) noexcept { ::act(static_cast<std::uint32_t>(value)); }
};
/// Numbers as wide as those of the hand-written switch.
struct Types {
    using Real = float;
    using Nat = std::int32_t;
    using Int = std::int32_t;
    static constexpr std::size_t longest = 16;
};
using State = core::State<Types>;

[[gnu::noinline]] void OF_BACK_END(_step)(void* state, unsigned event) {
    Register platform;
    State& s = *static_cast<State*>(state);
#if TICKS
    if (event > 1) {
        core::pass(s, platform);
        return;
    }
#endif
    core::dispatch(s, static_cast<core::Event>(event), platform);
}

void OF_BACK_END(_begin)(void* state) {
    *static_cast<State*>(state) = State{};
    OF_BACK_END(_step)(state, 0);
}
#else
#include TEXT(JOIN(MACHINE, _switch.hpp))
namespace core = JOIN(by_hand_, MACHINE);
using State = core::State;

[[gnu::noinline]] void OF_BACK_END(_step)(void* state, unsigned event) {
    core::step(*static_cast<State*>(state), event);
}

void OF_BACK_END(_begin)(void* state) {
    State& s = *static_cast<State*>(state);
    s = State{};
    core::begin(s);
    OF_BACK_END(_step)(state, 0);
}
#endif

#ifdef LOOP
/// Runs all events. The function is in this unit and not in the driver, so that the call is direct.
void OF_BACK_END(_run)(void* state, const std::uint8_t* events, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) OF_BACK_END(_step)(state, events[i]);
}
#endif

std::size_t OF_BACK_END(_size)() {
    return sizeof(State);
}
