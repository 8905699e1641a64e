// SPDX-License-Identifier: Apache-2.0
// Implements the contracts of frontend/toolkits/library in a computable form. Sets and sequences are CSPM's. Relations
// and functions are sets of pairs. A function that depends on all values of a type takes these values as last arguments
// (semantics/evaluate/toolkit.hpp). The name of a precondition is `pre_` followed by the function's name, as for
// functions of the model (semantics 3.5).
#include "csp_emit/base/toolkits.hpp"

#include <map>
#include <set>

#include "checker/cspm/syntax/reader.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::csp_emit {
namespace {

const char* const sets_and_relations = R"(
set_toolkit_notin(x__,s__) = not member(x__,s__)
set_toolkit_subseteq(a__,b__) = empty(diff(a__,b__))
set_toolkit_subset(a__,b__) = empty(diff(a__,b__)) and a__ != b__
set_toolkit_union(a__,b__) = union(a__,b__)
set_toolkit_inter(a__,b__) = inter(a__,b__)
set_toolkit_diff(a__,b__) = diff(a__,b__)
set_toolkit_symetric_diff(a__,b__) = union(diff(a__,b__),diff(b__,a__))
set_toolkit_Union(s__) = Union(s__)
set_toolkit_Inter(s__) = Inter(s__)
pre_set_toolkit_Inter(s__) = not empty(s__)

relation_toolkit_first((x__,_)) = x__
relation_toolkit_second((_,y__)) = y__
relation_toolkit_maplet(x__,y__) = (x__,y__)
relation_toolkit_dom(q__) = {x__ | (x__,_) <- q__}
relation_toolkit_ran(q__) = {y__ | (_,y__) <- q__}
relation_toolkit_id(a__) = {(x__,x__) | x__ <- a__}
relation_toolkit_relcomp(q__,s__) = {(x__,z__) | (x__,y__) <- q__, (w__,z__) <- s__, y__ == w__}
relation_toolkit_funcomp(s__,q__) = relation_toolkit_relcomp(q__,s__)
relation_toolkit_dres(s__,q__) = {(x__,y__) | (x__,y__) <- q__, member(x__,s__)}
relation_toolkit_rres(q__,s__) = {(x__,y__) | (x__,y__) <- q__, member(y__,s__)}
relation_toolkit_dsub(s__,q__) = {(x__,y__) | (x__,y__) <- q__, not member(x__,s__)}
relation_toolkit_rsub(q__,s__) = {(x__,y__) | (x__,y__) <- q__, not member(y__,s__)}
relation_toolkit_rinv(q__) = {(y__,x__) | (x__,y__) <- q__}
relation_toolkit_rimage(q__,s__) = {y__ | (x__,y__) <- q__, member(x__,s__)}
relation_toolkit_override(q__,s__) = union(relation_toolkit_dsub(relation_toolkit_dom(s__),q__),s__)
relation_toolkit_tr_closure(q__) =
  let grown__(t__) = let more__ = union(t__,relation_toolkit_relcomp(t__,q__))
                     within if more__ == t__ then t__ else grown__(more__)
  within grown__(q__)
relation_toolkit_refl_tr_closure(q__) =
  union(relation_toolkit_tr_closure(q__),
        relation_toolkit_id(union(relation_toolkit_dom(q__),relation_toolkit_ran(q__))))

function_toolkit_isTotal(f__,a__) = empty(diff(a__,relation_toolkit_dom(f__)))
function_toolkit_isInjection(f__) = card(relation_toolkit_ran(f__)) == card(f__)
function_toolkit_isTotalInjection(f__,a__) = function_toolkit_isTotal(f__,a__) and function_toolkit_isInjection(f__)
function_toolkit_isSurjection(f__,b__) = empty(diff(b__,relation_toolkit_ran(f__)))
function_toolkit_isTotalSurjection(f__,a__,b__) =
  function_toolkit_isTotal(f__,a__) and function_toolkit_isSurjection(f__,b__)
function_toolkit_isBijection(f__,a__,b__) =
  function_toolkit_isTotalInjection(f__,a__) and function_toolkit_isSurjection(f__,b__)
function_toolkit_isFinite(_) = true
function_toolkit_isFiniteFunction(_) = true
function_toolkit_isFiniteInjection(f__) = function_toolkit_isInjection(f__)
function_toolkit_disjoint(f__) =
  empty({k__ | (k__,a__) <- f__, (l__,b__) <- f__, k__ != l__, not empty(inter(a__,b__))})
function_toolkit_partitions(f__,s__) =
  function_toolkit_disjoint(f__) and Union(relation_toolkit_ran(f__)) == s__
)";

const char* const sequences = R"(
sequence_toolkit_range(m__,n__) = <m__..n__>
sequence_toolkit_iter(k__,q__,a__) =
  if k__ == 0 then relation_toolkit_id(a__)
  else if k__ > 0 then relation_toolkit_relcomp(sequence_toolkit_iter(k__-1,q__,a__),q__)
  else sequence_toolkit_iter(-k__,relation_toolkit_rinv(q__),a__)
sequence_toolkit_size(s__) = card(s__)
sequence_toolkit_hasMin(s__) = not empty(s__)
sequence_toolkit_hasMax(s__) = not empty(s__)
sequence_toolkit_min(s__) = theOnly__({x__ | x__ <- s__, empty({y__ | y__ <- s__, y__ < x__})})
sequence_toolkit_max(s__) = theOnly__({x__ | x__ <- s__, empty({y__ | y__ <- s__, y__ > x__})})
pre_sequence_toolkit_min(s__) = not empty(s__)
pre_sequence_toolkit_max(s__) = not empty(s__)
sequence_toolkit_isNonEmpty(s__) = not null(s__)
sequence_toolkit_isInjectiveSequence(s__) = card(set(s__)) == length(s__)
sequence_toolkit_concat(s__,t__) = s__^t__
sequence_toolkit_reverse(s__) = if null(s__) then <> else sequence_toolkit_reverse(tail(s__))^<head(s__)>
sequence_toolkit_head(s__) = head(s__)
sequence_toolkit_last(s__) = access_(s__,length(s__))
sequence_toolkit_tail(s__) = tail(s__)
sequence_toolkit_front(s__) = <access_(s__,n__) | n__ <- <1..length(s__)-1>>
pre_sequence_toolkit_head(s__) = not null(s__)
pre_sequence_toolkit_last(s__) = not null(s__)
pre_sequence_toolkit_tail(s__) = not null(s__)
pre_sequence_toolkit_front(s__) = not null(s__)
sequence_toolkit_squash(f__) =
  if empty(f__) then <>
  else let least__ = sequence_toolkit_min(relation_toolkit_dom(f__))
       within <callFunc(f__,least__)>^sequence_toolkit_squash(relation_toolkit_dsub({least__},f__))
sequence_toolkit_extract(a__,s__) = <access_(s__,n__) | n__ <- <1..length(s__)>, member(n__,a__)>
sequence_toolkit_filter(s__,a__) = <x__ | x__ <- s__, member(x__,a__)>
sequence_toolkit_prefix(s__,t__) =
  null(s__) or (not null(t__) and head(s__) == head(t__) and sequence_toolkit_prefix(tail(s__),tail(t__)))
sequence_toolkit_suffix(s__,t__) = sequence_toolkit_prefix(sequence_toolkit_reverse(s__),sequence_toolkit_reverse(t__))
sequence_toolkit_infix(s__,t__) =
  sequence_toolkit_prefix(s__,t__) or (not null(t__) and sequence_toolkit_infix(s__,tail(t__)))
sequence_toolkit_dconcat(s__) = concat(s__)
)";

}  // namespace

std::string toolkit_text() {
    return std::string(sets_and_relations) + sequences;
}

}  // namespace robochart::csp_emit
