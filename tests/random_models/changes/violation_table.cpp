// SPDX-License-Identifier: Apache-2.0
// Contains the table of violations (violations.hpp), with one row for each way to violate a rule.
#include "tests/random_models/changes/violations.hpp"

namespace robochart::random_models {

#define IDLE_MACHINE "stm XS { event xe initial xi state xt { } transition xu { from xi to xt } }"
/// A machine that executes a statement with the operations of XI.
#define CALL_OF(statement) \
    "stm XS { requires XI initial xi state xs { entry " statement " } transition xt { from xi to xs } }"
/// A controller whose machine calls an operation with these members.
#define CALLING(members) "controller XC { operation xo() { initial xi final xf " members " } " CALL_OF("xo()") " }"

namespace {

constexpr std::string_view loose_controller = "controller XC { event xe sref xs = XS } " IDLE_MACHINE;

}  // namespace

const std::vector<Violation>& violations() {
    using enum Site;
    static const std::vector<Violation> rows = {
        // Nodes and transitions.
        {"STM3", machine, "initial xi transition xt { from xi to $state }"},
        {"IJ1", machine, "transition xt { from $state to $initial }"},
        {"IJ2", machine, "transition xt { from $initial to $state }"},
        {"FS1", machine, "transition xt { from $final to $state }"},
        {"FS2", machine, "final xf { entry skip }"},
        {"FS3", machine, "final xf { state xs {} }"},
        {"J1", machine, "junction xj transition xt { from $state to xj }"},
        {"J2", machine, "junction xj transition xt { from xj to $state }"},
        {"J3", machine, "event xe transition xt { from $junction to $state trigger xe }"},
        {"T1", machine, "transition xt { from $state to $inner }"},
        {"T1", machine, "transition xt { from $inner to $state }"},
        {"T2", machine, "event xe : nat transition xt { from $state to $state trigger xe!1 }"},
        {"T2", machine, "event xe : nat transition xt { from $state to $state trigger xe.1 }"},
        {"PJ1", machine, "probabilistic xp transition xt { from $state to xp } transition xu { from xp to $state }"},
        {"PJ2", machine,
         "probabilistic xp transition xt { from $state to xp } "
         "transition xu { from xp to $state probability 1 condition true }"},
        {"PT1", machine, "transition xt { from $state to $state probability 0.5 }"},
        {"PT2", machine,
         "probabilistic xp transition xt { from $state to xp } transition xu { from xp to $state probability 2 }"},
        {"S2", state, "entry skip entry skip"},
        {"S2", state, "during skip during skip"},
        {"S2", state, "exit skip exit skip"},
        {"STM4", machine,
         "state xs { initial xi junction xj transition xt { from xi to xj } transition xu { from xj to xj } }"},
        {"PARAM", operation, "transition xt { from $state to $state action $parameter = $parameter }"},

        // Components.
        {"STM1", machine, "provides XI", "interface XI { var xv : nat }"},
        {"STM6", machine, "xo()"},
        {"STM7", machine, "requires XI", "interface XI { clock xc }"},
        {"RP1", platform, "requires XI", "interface XI { var xv : nat }"},
        {"RP2", platform, "uses XI", "interface XI { clock xc }"},
        {"RP3", platform, "clock xc"},
        {"O1", operation, "provides XI", "interface XI { var xv : nat }"},
        {"I1", machine, "requires XI", "interface XI { event xe }"},
        {"I1", platform, "provides XI", "interface XI { event xe }"},
        {"I1", platform, "provides XI", "interface XI { clock xc }"},
        {"I2", machine, "uses XI", "interface XI { xo() }"},
        {"I", file, "interface XI { event xe xo() }"},
        {"C1", file, "controller XC { }"},
        {"C2", controller, "provides XI", "interface XI { var xv : nat }"},
        {"C3", machine, "requires XI", "interface XI { var xv : nat }"},
        {"C4", machine, "requires XI", "interface XI { xo(xp : nat) }"},
        {"C4w", operation, "requires XI", "interface XI { xo() }"},
        {"C7", controller, "xo()"},
        {"C8", controller, "opref xr = XO opref xq = XO", "operation XO() { }"},
        {"C9", controller, "clock xc"},
        {"C10", controller, "uses XI", "interface XI { clock xc }"},
        {"C11", controller, "requires XI", "interface XI { clock xc }"},
        {"M1", module, "robotic platform XR { }"},
        {"M", module, "stm XS { initial xi state xs { } transition xt { from xi to xs } }"},
        {"M2", controller, "requires XI", "interface XI { var xv : nat }"},
        {"M2", controller, "requires XI", "interface XI { xo() }"},
        {"DT", file, "datatype XD { }"},

        // Connections.
        {"Cn1", module, "connection $self on xe to $self on xe"},
        {"Cn3", controller, "connection XS on xe to XS on xe",
         "stm XS { event xe initial xi state xs { } transition xt { from xi to xs } }"},
        {"RC-T32", controller, "event xe : nat connection $self on xe to $part on xf", "", "event xf"},
        {"RC-T32", controller, "event xe : nat connection $part on xf to $self on xe", "", "event xf : boolean"},
        {"Cn10", controller, "connection $self on xe to $self on xf"},
        {"C6", controller, "event xe connection $self on xe to $part on xf connection $self on xe to $part on xg", "",
         "event xf event xg"},

        {"Cn4", controller, "event xe connection $self on xe to $part on xf", "", "_broadcast event xf"},
        {"Cn4", controller, "_broadcast event xe connection $part on xf to $self on xe", "", "event xf"},
        {"Cn8", controller, "event xe connection $self on xe to $part on xf", "", "event xf state xs { entry xf }"},
        {"Cn9", controller, "event xe connection $part on xf to $self on xe", "",
         "event xf state xs { } transition xt { from xs to xs trigger xf }"},
        {"Cn2", file, "module XM { robotic platform XR { event xe } cref xc = XC connection XR on xe to xc on xe }",
         loose_controller},
        {"Cn2", file, "module XM { robotic platform XR { event xe } cref xc = XC connection xc on xe to XR on xe }",
         loose_controller},
        {"M3", file,
         "module XM { robotic platform XR { event xe } cref xc = XC cref xd = XC connection XR on xe to xc on xe "
         "(_async) "
         "connection XR on xe to xd on xe (_async) }",
         loose_controller},
        {"Cn5", file,
         "module XM { robotic platform XR { event xe } cref xc = XC connection XR on xe to xc on xe (_async) [mult] }",
         "controller XC { event xe sref xs = XS connection XC on xe to xs on xe } " IDLE_MACHINE},
        {"Cn6", file,
         "module XM { robotic platform XR { event xe } cref xc = XC connection XR on xe to xc on xe (_async) }",
         "controller XC { event xe sref xs = XS connection XC on xe to xs on xe [mult] } " IDLE_MACHINE},
        {"Cn7", file,
         "module XM { robotic platform XR { event xe } cref xc = XC connection xc on xe to XR on xe (_async) }",
         "controller XC { event xe sref xs = XS connection XC on xe to xs on xe } " IDLE_MACHINE},

        // Requirements of operations on their callers.
        {"STM8", file, CALLING("requires XN transition xt { from xi to xf action xv = 1 }"),
         "interface XI { xo() } interface XN { var xv : nat }"},
        {"STM9", file, CALLING("event xe transition xt { from xi to xf action xe }"), "interface XI { xo() }"},
        {"STM10", file, CALLING("requires XN transition xt { from xi to xf action #xk }"),
         "interface XI { xo() } interface XN { clock xk }"},

        // Time.
        {"TT1", machine, "transition xt { from $state to $state <{ 1 } condition true }"},
        {"TE1", machine, "clock xc var xv : int transition xt { from $state to $state action xv = since(xc) }"},
        {"TE2", machine, "transition xt { from $state to $state condition since(xc) >= 1 }"},
        {"TE3", machine, "transition xt { from $state to $state condition sinceEntry(xs) >= 1 }"},
        {"TE3", machine, "transition xt { from $state to $state condition sinceEntry($final) >= 1 }"},
        {"TE4", machine, "clock xc transition xt { from $state to $state condition since(xc) + 1 > 2 }"},
        {"TE4", machine, "clock xc transition xt { from $state to $state condition since(xc) != 2 }"},
        {"CE2", machine, "clock xc transition xt { from $state to $state condition since(xc) > true }"},
        {"TE5", machine, "transition xt { from $state to $state condition sinceEntry($inner) >= 1 }"},
        {"TS1", machine, "transition xt { from $state to $state action #xc }"},
        {"TS1", machine, "transition xt { from $state to $state #xc }"},

        // Types.
        {"RC-T01", machine, "var xv : nat = true"},
        {"RC-T01", machine, "const xv : nat = 1 - 2"},
        {"RC-T02", machine, "var xv : nat transition xt { from $state to $state action xv = -1 }"},
        {"RC-T03", machine, "transition xt { from $state to $state action if 1 then skip end }"},
        {"RC-T04", machine, "transition xt { from $state to $state condition 1 }"},
        {"RC-T05", machine, "transition xt { from $state to $state action wait(true) }"},
        {"RC-T06", file, CALL_OF("xo()"), "interface XI { xo(xp : nat) }"},
        {"RC-T06", file, CALL_OF("xo(1, 2)"), "interface XI { xo(xp : nat) }"},
        {"RC-T07", file, CALL_OF("xo(true)"), "interface XI { xo(xp : nat) }"},
        {"RC-T08", machine, "event xe : boolean var xv : nat transition xt { from $state to $state trigger xe?xv }"},
        {"RC-T09", machine, "event xe : nat transition xt { from $state to $state action xe!true }"},
        {"Tg5", machine, "event xe transition xt { from $state to $state action xe!1 }"},
        {"Tg2", machine, "event xe : nat transition xt { from $state to $state action xe }"},
        {"RC-T10", machine, "var xv : XE = XE::XL", "enumeration XE { XL(nat) }"},
        {"RC-T12", machine, "var xv : XE = XE::XL(true)", "enumeration XE { XL(nat) }"},
        {"RC-T13", machine, "var xv : nat = xfun()", "function xfun(xp : nat) : nat { }"},
        {"RC-T13", machine, "var xv : nat = xfun(1, 1)", "function xfun(xp : nat) : nat { }"},
        {"RC-T35", machine, "var xv : nat = xfun", "function xfun() : nat { }"},
        {"RC-T14", machine, "var xv : nat = xfun(true)", "function xfun(xp : nat) : nat { }"},
        {"RC-T15", machine, "const xk : nat = 1 var xv : nat = xk(1)"},
        {"RC-T16", machine, "const xk : nat * nat = (| 1, 1 |) var xv : nat = xk[3]"},
        {"RC-T17", machine, "const xk : Seq(nat) = <1> var xv : nat = xk[1, 1]"},
        {"RC-T18", machine, "const xk : nat = 1 var xv : nat = xk[1]"},
        {"RC-T19", machine, "const xk : XD var xv : nat = xk.xg", "datatype XD { xf : nat }"},
        {"RC-T20", machine, "var xv : XD = XD(| xf = true |)", "datatype XD { xf : nat }"},
        {"RC-T22", machine, "var xv : nat = true as nat"},
        {"RC-T23", machine, "transition xt { from $state to $state condition 1 + true == 1 }"},
        {"RC-T24", machine, "transition xt { from $state to $state condition -true }"},
        {"RC-T25", machine, "transition xt { from $state to $state condition 1 == true }"},
        {"RC-T26", machine, "transition xt { from $state to $state condition {} == {1, true} }"},
        {"RC-T27", machine, "var xv : vector(nat, 0)"},
        {"RC-T29", machine, "event xe transition xt { from $state to $state trigger xe <{ true } }"},
        {"RC-T30", machine, "const xk : nat = 1 transition xt { from $state to $state action xk = 2 }"},

        // Names.
        {"RC-N01", machine, "var xv : Nothing"},
        {"RC-N01", machine, "transition xt { from $state to xs }"},
        {"RC-N01", machine, "transition xt { from $state to $state action xo() }"},
        {"RC-N01", machine, "transition xt { from $state to $state trigger xe }"},
        {"RC-N01", module, "cref xr = XC"},
        {"RC-N02", machine, "uses XD", "datatype XD { xf : nat }"},
        {"RC-N02", machine, "var xv : XI", "interface XI { var xw : nat }"},
    };
    return rows;
}

}  // namespace robochart::random_models
