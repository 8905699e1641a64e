// One back end of one machine as a translation unit: a step that is not inlined, for an event known at run time only.
// MACHINE m1 to m4, ENUM its name in the generated header, GENERATED 1 or 0, TICKS 1: events above 1 are time passing.
#include <cstddef>
#include <cstdint>

#define TEXT_(x) #x
#define TEXT(x) TEXT_(x)
#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)

#include "actuator.hpp"

#if GENERATED
#include TEXT(HEADER)
namespace core = MACHINE::JOIN(NAME, _core);
#define BACK_END(what) JOIN(JOIN(MACHINE, _generated_), what)

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

[[gnu::noinline]] void BACK_END(step)(void* state, unsigned event) {
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

void BACK_END(begin)(void* state) {
    *static_cast<State*>(state) = State{};
    BACK_END(step)(state, 0);
}
#else
#include TEXT(JOIN(MACHINE, _switch.hpp))
namespace core = JOIN(by_hand_, MACHINE);
#define BACK_END(what) JOIN(JOIN(MACHINE, _switch_), what)
using State = core::State;

[[gnu::noinline]] void BACK_END(step)(void* state, unsigned event) {
    core::step(*static_cast<State*>(state), event);
}

void BACK_END(begin)(void* state) {
    State& s = *static_cast<State*>(state);
    s = State{};
    core::begin(s);
    BACK_END(step)(state, 0);
}
#endif

std::size_t BACK_END(size)() {
    return sizeof(State);
}
