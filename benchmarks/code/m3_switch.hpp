// Machine M3 of the code benchmark as hand-written code: a switch on the state, with a nested switch on the event.
// Transitions of a composite state are tried after those of its children.
#pragma once

#include <cstdint>

#include "actuator.hpp"

namespace by_hand_m3 {

enum class At : std::uint8_t {
    T0_U0_V0, T0_U0_V1, T0_U0_V2, T0_U1, T0_U2, T1_U0_V0, T1_U0_V1, T1_U0_V2, T1_U1, T1_U2,
    T2_U0_V0, T2_U0_V1, T2_U1, T3,
};

struct State {
    std::uint32_t v = 0;
    At at = At::T0_U0_V0;
};

inline void begin(State&) {
    act(100);
    act(104);
    act(107);
}

inline void leave_T0_U0(State& s) {
    switch (s.at) {
        case At::T0_U0_V0:
            act(207);
            break;
        case At::T0_U0_V1:
            act(208);
            break;
        case At::T0_U0_V2:
            act(209);
            break;
        default: break;
    }
    act(204);
}

inline void leave_T0(State& s) {
    switch (s.at) {
        case At::T0_U0_V0:
        case At::T0_U0_V1:
        case At::T0_U0_V2:
            leave_T0_U0(s);
            break;
        case At::T0_U1:
            act(205);
            break;
        case At::T0_U2:
            act(206);
            break;
        default: break;
    }
    act(200);
}

inline void leave_T1_U0(State& s) {
    switch (s.at) {
        case At::T1_U0_V0:
            act(213);
            break;
        case At::T1_U0_V1:
            act(214);
            break;
        case At::T1_U0_V2:
            act(215);
            break;
        default: break;
    }
    act(210);
}

inline void leave_T1(State& s) {
    switch (s.at) {
        case At::T1_U0_V0:
        case At::T1_U0_V1:
        case At::T1_U0_V2:
            leave_T1_U0(s);
            break;
        case At::T1_U1:
            act(211);
            break;
        case At::T1_U2:
            act(212);
            break;
        default: break;
    }
    act(201);
}

inline void leave_T2_U0(State& s) {
    switch (s.at) {
        case At::T2_U0_V0:
            act(218);
            break;
        case At::T2_U0_V1:
            act(219);
            break;
        default: break;
    }
    act(216);
}

inline void leave_T2(State& s) {
    switch (s.at) {
        case At::T2_U0_V0:
        case At::T2_U0_V1:
            leave_T2_U0(s);
            break;
        case At::T2_U1:
            act(217);
            break;
        default: break;
    }
    act(202);
}

inline bool on_T0_U0(State& s, unsigned e) {
    switch (e) {
        case 0:
            if (s.v > 1) break;
            leave_T0_U0(s);
            act(308);
            act(105);
            s.at = At::T0_U1;
            return true;
        case 2:
            leave_T0_U0(s);
            act(309);
            act(106);
            s.at = At::T0_U2;
            return true;
        default: break;
    }
    return false;
}

inline bool on_T0(State& s, unsigned e) {
    switch (e) {
        case 3:
            if (s.v > 2) break;
            leave_T0(s);
            act(300);
            s.v = s.v >= 3 ? 0 : s.v + 1;
            act(102);
            act(116);
            act(118);
            s.at = At::T2_U0_V0;
            return true;
        case 5:
            leave_T0(s);
            act(301);
            act(103);
            s.at = At::T3;
            return true;
        default: break;
    }
    return false;
}

inline bool on_T1_U0(State& s, unsigned e) {
    switch (e) {
        case 3:
            leave_T1_U0(s);
            act(320);
            s.v = s.v >= 3 ? 0 : s.v + 1;
            act(111);
            s.at = At::T1_U1;
            return true;
        case 2:
            leave_T1_U0(s);
            act(321);
            act(112);
            s.at = At::T1_U2;
            return true;
        default: break;
    }
    return false;
}

inline bool on_T1(State& s, unsigned e) {
    switch (e) {
        case 7:
            leave_T1(s);
            act(302);
            act(103);
            s.at = At::T3;
            return true;
        case 3:
            leave_T1(s);
            act(303);
            act(100);
            act(104);
            act(107);
            s.at = At::T0_U0_V0;
            return true;
        default: break;
    }
    return false;
}

inline bool on_T2_U0(State& s, unsigned e) {
    switch (e) {
        case 1:
            leave_T2_U0(s);
            act(332);
            act(117);
            s.at = At::T2_U1;
            return true;
        case 0:
            leave_T2_U0(s);
            act(333);
            act(117);
            s.at = At::T2_U1;
            return true;
        default: break;
    }
    return false;
}

inline bool on_T2(State& s, unsigned e) {
    switch (e) {
        case 3:
            if (s.v > 2) break;
            leave_T2(s);
            act(304);
            act(100);
            act(104);
            act(107);
            s.at = At::T0_U0_V0;
            return true;
        case 5:
            leave_T2(s);
            act(305);
            s.v = s.v >= 3 ? 0 : s.v + 1;
            act(101);
            act(110);
            act(113);
            s.at = At::T1_U0_V0;
            return true;
        default: break;
    }
    return false;
}

inline bool step(State& s, unsigned e) {
    switch (s.at) {
        case At::T0_U0_V0:
            switch (e) {
                case 0:
                    act(207);
                    act(314);
                    act(109);
                    s.at = At::T0_U0_V2;
                    return true;
                case 1:
                    if (s.v > 1) break;
                    act(207);
                    act(315);
                    s.v = s.v >= 3 ? 0 : s.v + 1;
                    act(108);
                    s.at = At::T0_U0_V1;
                    return true;
                default: break;
            }
            return on_T0_U0(s, e) || on_T0(s, e);
        case At::T0_U0_V1:
            switch (e) {
                case 6:
                    act(208);
                    act(316);
                    act(109);
                    s.at = At::T0_U0_V2;
                    return true;
                case 7:
                    if (s.v > 2) break;
                    act(208);
                    act(317);
                    act(109);
                    s.at = At::T0_U0_V2;
                    return true;
                default: break;
            }
            return on_T0_U0(s, e) || on_T0(s, e);
        case At::T0_U0_V2:
            switch (e) {
                case 6:
                    act(209);
                    act(318);
                    act(108);
                    s.at = At::T0_U0_V1;
                    return true;
                case 4:
                    act(209);
                    act(319);
                    act(108);
                    s.at = At::T0_U0_V1;
                    return true;
                default: break;
            }
            return on_T0_U0(s, e) || on_T0(s, e);
        case At::T0_U1:
            switch (e) {
                case 6:
                    act(205);
                    act(310);
                    s.v = s.v >= 3 ? 0 : s.v + 1;
                    act(106);
                    s.at = At::T0_U2;
                    return true;
                case 5:
                    act(205);
                    act(311);
                    act(106);
                    s.at = At::T0_U2;
                    return true;
                default: break;
            }
            return on_T0(s, e);
        case At::T0_U2:
            switch (e) {
                case 7:
                    act(206);
                    act(312);
                    act(105);
                    s.at = At::T0_U1;
                    return true;
                case 1:
                    act(206);
                    act(313);
                    act(104);
                    act(107);
                    s.at = At::T0_U0_V0;
                    return true;
                default: break;
            }
            return on_T0(s, e);
        case At::T1_U0_V0:
            switch (e) {
                case 1:
                    act(213);
                    act(326);
                    act(115);
                    s.at = At::T1_U0_V2;
                    return true;
                case 0:
                    act(213);
                    act(327);
                    act(115);
                    s.at = At::T1_U0_V2;
                    return true;
                default: break;
            }
            return on_T1_U0(s, e) || on_T1(s, e);
        case At::T1_U0_V1:
            switch (e) {
                case 1:
                    act(214);
                    act(328);
                    act(113);
                    s.at = At::T1_U0_V0;
                    return true;
                case 2:
                    act(214);
                    act(329);
                    act(115);
                    s.at = At::T1_U0_V2;
                    return true;
                default: break;
            }
            return on_T1_U0(s, e) || on_T1(s, e);
        case At::T1_U0_V2:
            switch (e) {
                case 2:
                    if (s.v > 1) break;
                    act(215);
                    act(330);
                    s.v = s.v >= 3 ? 0 : s.v + 1;
                    act(114);
                    s.at = At::T1_U0_V1;
                    return true;
                case 0:
                    act(215);
                    act(331);
                    act(114);
                    s.at = At::T1_U0_V1;
                    return true;
                default: break;
            }
            return on_T1_U0(s, e) || on_T1(s, e);
        case At::T1_U1:
            switch (e) {
                case 2:
                    act(211);
                    act(322);
                    act(112);
                    s.at = At::T1_U2;
                    return true;
                case 5:
                    if (s.v > 2) break;
                    act(211);
                    act(323);
                    act(110);
                    act(113);
                    s.at = At::T1_U0_V0;
                    return true;
                default: break;
            }
            return on_T1(s, e);
        case At::T1_U2:
            switch (e) {
                case 3:
                    act(212);
                    act(324);
                    act(111);
                    s.at = At::T1_U1;
                    return true;
                case 5:
                    act(212);
                    act(325);
                    s.v = s.v >= 3 ? 0 : s.v + 1;
                    act(111);
                    s.at = At::T1_U1;
                    return true;
                default: break;
            }
            return on_T1(s, e);
        case At::T2_U0_V0:
            switch (e) {
                case 0:
                    if (s.v > 0) break;
                    act(218);
                    act(336);
                    act(119);
                    s.at = At::T2_U0_V1;
                    return true;
                case 2:
                    if (s.v > 2) break;
                    act(218);
                    act(337);
                    act(119);
                    s.at = At::T2_U0_V1;
                    return true;
                default: break;
            }
            return on_T2_U0(s, e) || on_T2(s, e);
        case At::T2_U0_V1:
            switch (e) {
                case 0:
                    if (s.v > 1) break;
                    act(219);
                    act(338);
                    act(118);
                    s.at = At::T2_U0_V0;
                    return true;
                case 1:
                    act(219);
                    act(339);
                    act(118);
                    s.at = At::T2_U0_V0;
                    return true;
                default: break;
            }
            return on_T2_U0(s, e) || on_T2(s, e);
        case At::T2_U1:
            switch (e) {
                case 5:
                    if (s.v > 2) break;
                    act(217);
                    act(334);
                    act(116);
                    act(118);
                    s.at = At::T2_U0_V0;
                    return true;
                case 4:
                    act(217);
                    act(335);
                    s.v = s.v >= 3 ? 0 : s.v + 1;
                    act(116);
                    act(118);
                    s.at = At::T2_U0_V0;
                    return true;
                default: break;
            }
            return on_T2(s, e);
        case At::T3:
            switch (e) {
                case 0:
                    act(203);
                    act(306);
                    act(100);
                    act(104);
                    act(107);
                    s.at = At::T0_U0_V0;
                    return true;
                case 5:
                    if (s.v > 2) break;
                    act(203);
                    act(307);
                    act(100);
                    act(104);
                    act(107);
                    s.at = At::T0_U0_V0;
                    return true;
                default: break;
            }
            return false;
    }
    return false;
}

}  // namespace by_hand_m3
