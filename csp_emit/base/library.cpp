// SPDX-License-Identifier: Apache-2.0
// Stores the library as text, which the project's CSPM reader parses. Its parameters end in `__`, because a parameter
// with the name of a channel or constructor of the model would become a constructor pattern.

#include <algorithm>

#include "checker/cspm/syntax/reader.hpp"
#include "csp_emit/base/library.hpp"
#include "csp_emit/base/toolkits.hpp"
#include "csp_emit/base/user_names.hpp"

namespace robochart::csp_emit {
namespace {

const char* const common = R"(
datatype InOut = in | out

transparent sbisim, dbisim, diamond
external prioritise

-- offered for ever after termination, to tell termination from deadlock
channel r__

-- sequences of at most n__ elements
LSeq(s__,0) = {<>}
LSeq(s__,n__) = let shorter__ = LSeq(s__,n__-1) within union(shorter__,{<x__>^y__ | x__ <- s__, y__ <- shorter__})
-- relations and total functions as sets of pairs
Relation(a__,b__) = Set({(x__,y__) | x__ <- a__, y__ <- b__})
Function(a__,b__) = let all__(<>) = {{}}
                        all__(<x__>^xs__) = {union({(x__,y__)},f__) | f__ <- all__(xs__), y__ <- b__}
                    within all__(seq(a__))
funcToSet(f__,s__) = {(x__,f__(x__)) | x__ <- s__}
theOnly__(s__) = if card(s__) == 1 then head(seq(s__)) else error("not one value but several, or none")
callFunc(f__,x__) = theOnly__({y__ | (a__,y__) <- f__, a__ == x__})
-- a sequence as the set of its places with their elements
pairs_(s__) = {(n__,access_(s__,n__)) | n__ <- {1..length(s__)}}
-- element n__ of a sequence, counted from 1, and the sequence with another one there
access_(<x__>^y__,n__) = if n__ == 1 then x__ else access_(y__,n__-1)
update_(<x__>^y__,e__,n__) = if n__ == 1 then <e__>^y__ else <x__>^update_(y__,e__,n__-1)
no_zero_div(x__) = if x__ == 0 then 1 else x__
)";

const char* const timed_part = R"(
-- one tock is one time unit; tock' serves the check for deadlock
channel tock, tock'

OneStep(_) = 0
-- nothing, and time stops
USTOP = STOP

Timed(OneStep) {
  TSKIP = SKIP
  WAIT_INTERVAL(s__) = |~| x__ : s__ @ WAIT(x__)
  -- a deadline to start, a deadline to finish, a deadline for one event
  StartBy(p__,d__) = p__ [] (WAIT(d__) ; USTOP)
  EndBy(p__,d__) = p__ /\ (WAIT(d__) ; USTOP)
  Deadline(p__,d__) = EndBy(p__,d__)
  EDeadline(e__,d__) = e__ -> SKIP [] (WAIT(d__) ; USTOP)
}

-- p__ in this time unit, q__ in the next
TimeOut_1(p__,q__) = (USTOP [+ {tock} +] p__) [] (tock -> q__)
wait(n__) = if n__ > 0 then tock -> wait(n__-1) else SKIP
SHARE_WAIT(n__) = wait(n__)
SHARE_WAIT_INTERVAL(s__) = |~| x__ : s__ @ wait(x__)
SKIP_ANYTIME = SKIP |~| tock -> SKIP_ANYTIME

-- clocks count up to a limit
clock_step(c__,max__) = if c__ < max__ then c__+1 else c__
clock_type_plus(x__,y__,t__) = if member(x__+y__,t__) then x__+y__ else x__
clock_type_max(s__) = let largest__(<>,m__) = m__
                          largest__(<x__>^y__,m__) = largest__(y__,if x__ > m__ then x__ else m__)
                      within largest__(seq(s__),0)
)";

// Baxter, Ribeiro, Cavalcanti, Sound reasoning in tock-CSP (Acta Informatica 2022): refusals are observed only before
// each tock and at the end of a trace. Mestel, Roscoe, Reducing complex CSP models to traces via priority (2016): an
// event `ref.e` over which e has priority is possible in exactly the stable states that refuse e.
const char* const tick_tock_part = R"(
external prioritisepo

-- the tick-tock model over the events sigma__ as a model of traces: TT(p__) refines TT(q__) in traces where p__
-- refines q__ in tick-tock. RT: the same for refusal testing, what is refused is seen everywhere
module model_shifting(sigma__)
  channel tick
  observed = union(sigma__,{tock, tick})
  order = {(e__,ref.e__) | e__ <- observed}
  refusals(p__) = prioritisepo(p__ ||| RUN({|ref|}),union(observed,{|ref|}),order,observed)
  events_first = ([] e__ : observed @ e__ -> events_first) [] ref?_ -> then_time
  then_time = ref?_ -> then_time [] tock -> events_first
  ended(p__) = prioritise(p__,<{}, {tock}>) ; tick -> SKIP
exports
  channel ref : union(sigma__,{tock, tick})
  RT(p__) = refusals(ended(p__))
  TT(p__) = refusals(ended(p__)) [| union(observed,{|ref|}) |] events_first
endmodule
)";

// Definitions that only CSP blocks use. They are emitted if a block mentions one of them.
const char* const further_common = R"(
-- injective sequences of at most n__ elements
ILSeq(s__,0) = {<>}
ILSeq(s__,n__) = let shorter__ = ILSeq(s__,n__-1)
                 within union(shorter__,{<x__>^y__ | x__ <- s__, y__ <- shorter__, not elem(x__,y__)})
-- the greatest number of a set, at least 0; the least, of numbers that are not above it
calc_type_max(s__) = calc_type_seq_max(seq(s__),0)
calc_type_seq_max(<>,m__) = m__
calc_type_seq_max(<x__>^y__,m__) = calc_type_seq_max(y__,if x__ > m__ then x__ else m__)
calc_type_min(s__) = calc_type_seq_min(seq(s__),calc_type_max(s__))
calc_type_seq_min(<>,m__) = m__
calc_type_seq_min(<x__>^y__,m__) = calc_type_seq_min(y__,if x__ < m__ then x__ else m__)
)";

const char* const further_timed = R"(
-- p__ for d__ time units, then it is cut off; q__ if nothing has happened after d__ time units
Timed(OneStep) {
  TimedInterrupt(p__,d__) = timed_priority(p__ /+Events+\ RT__(d__))
  TimeOut(p__,d__,q__) = (p__ /+Events+\ ((TimedInterrupt(Some__,d__) ; STOP) ; RUN(Events))) [] (WAIT(d__) ; q__)
}
TimedInterrupt_1(p__) = (USTOP [+ {tock} +] p__) /\ (tock -> TSKIP)
TimedInterruptSeq(e__,d__,q__) =
  let from__(n__) = if n__ < d__ then TimeOut_1(e__ -> SKIP,from__(n__+1)) else q__
  within from__(0)
-- anything may happen, also that time stops
TCHAOS(s__) = CHAOS(s__) /\ (USTOP |~| tock -> TCHAOS(s__))
-- every event for d__ time units
RT__(d__) = if d__ > 0 then RUN(diff(Events,{tock})) /\ tock -> RT__(d__-1) else SKIP
Some__ = [] x__ : Events @ x__ -> SKIP
DoClockReset(s__) = ||| c__ : s__ @ c__ -> SKIP
)";

/// Returns the functions that select component i of an n-tuple: `tuple3_2((x1__,x2__,x3__)) = x2__`.
std::string tuple_parts() {
    std::string result;
    for (int n = 2; n <= 5; ++n)
        for (int i = 1; i <= n; ++i) {
            std::string parts;
            for (int k = 1; k <= n; ++k) parts += (k > 1 ? ",x" : "x") + std::to_string(k) + "__";
            result += "tuple" + std::to_string(n) + "_" + std::to_string(i) + "((" + parts + ")) = x" +
                      std::to_string(i) + "__\n";
        }
    return result;
}

bool blocks_name(const ir::System& system, std::initializer_list<const char*> names) {
    return std::ranges::any_of(system.csp_blocks, [&](const ir::CspBlock& block) {
        return std::ranges::any_of(names, [&](const char* name) { return block.text.find(name) != std::string::npos; });
    });
}

/// Returns the definitions of RoboTool's library that CSP blocks name and generated scripts do not need.
std::string further_text(const ir::System& system, Time time) {
    std::string result;
    if (blocks_name(system, {"ILSeq", "calc_type_"})) result += further_common;
    if (blocks_name(system, {"tuple"})) result += tuple_parts();
    if (time == Time::timed &&
        blocks_name(system, {"TimedInterrupt", "TimeOut", "TCHAOS", "RT__", "Some__", "DoClockReset"}))
        result += further_timed;
    return result;
}

bool uses_tick_tock(const ir::System& system) {
    return std::ranges::any_of(system.properties,
                               [](const auto& property) { return property.model == ir::PropertyModel::tick_tock; }) ||
           std::ranges::any_of(system.csp_blocks, [](const auto& block) {
               return block.text.find("model_shifting") != std::string::npos;
           });
}

}  // namespace

std::string library_text(Time time) {
    return time == Time::timed ? std::string(common) + timed_part : std::string(common);
}

const std::set<std::string>& library_names() {
    static const std::set<std::string> names = [] {
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics diagnostics;
        const auto source = sources.add("<libraries>", library_text(Time::timed) + further_common + further_timed +
                                                           tuple_parts() + tick_tock_part + toolkit_text());
        const auto decls = cspm::read(sources, source, diagnostics).decls;
        std::set<std::string> result = user_names(decls).all;
        for (const cspm::DeclPtr& decl : decls)
            if (decl->kind == cspm::DeclKind::transparent || decl->kind == cspm::DeclKind::external)
                result.insert(decl->names.begin(), decl->names.end());
        return result;
    }();
    return names;
}

std::string library_text(const ir::System& system, Time time) {
    std::string text = library_text(time) + further_text(system, time);
    if (time == Time::timed && uses_tick_tock(system)) text += tick_tock_part;
    return text;
}

}  // namespace robochart::csp_emit
