// Machine M1 of the code benchmark as hand-written code: a switch on the state, with a nested switch on the event.
// Transitions of a composite state are tried after those of its children.
#pragma once

#include <cstdint>

#include "actuator.hpp"

namespace by_hand_m1 {

enum class At : std::uint8_t {
    Moving, Stopped,
};

struct State {
    At at = At::Moving;
};

inline void begin(State&) {
}

inline bool step(State& s, unsigned e) {
    switch (s.at) {
        case At::Moving:
            switch (e) {
                case 0: act(1); s.at = At::Stopped; return true;
                default: break;
            }
            return false;
        case At::Stopped:
            switch (e) {
                case 1: act(2); s.at = At::Moving; return true;
                default: break;
            }
            return false;
    }
    return false;
}

}  // namespace by_hand_m1
