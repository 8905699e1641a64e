// Implements machine M2 of the code benchmark by hand. For events 2 and 3, a time unit passes.
#pragma once

#include <cstdint>

#include "actuator.hpp"

namespace by_hand_m2 {

enum class At : std::uint8_t { Forward, Avoidance, Coherence };

struct State {
    std::uint32_t clock = 0;
    At at = At::Forward;
    bool seen = false;
    bool moving = false;
};

inline void enter_forward(State& s) {
    act(10);
    s.at = At::Forward;
    s.moving = true;
}

inline void begin(State& s) {
    enter_forward(s);
}

inline void step(State& s, unsigned e) {
    if (e > 1) {
        if (s.clock < 25) ++s.clock;
        return;
    }
    switch (s.at) {
        case At::Forward:
            if (e != 0) return;
            if (s.clock < 25) {
                act(1);
                s.seen = true;
                act(11);
                s.at = At::Avoidance;
            } else {
                act(2);
                s.seen = false;
                act(12);
                s.at = At::Coherence;
            }
            s.clock = 0;
            s.moving = false;
            return;
        case At::Avoidance:
            if (e != 1 || !s.seen) return;
            act(3);
            s.seen = false;
            enter_forward(s);
            return;
        case At::Coherence:
            if (e != 1 || s.moving) return;
            act(4);
            s.seen = true;
            enter_forward(s);
            return;
    }
}

}  // namespace by_hand_m2
