// SPDX-License-Identifier: Apache-2.0
// Defines claims as predicates on finite traces, in the words of docs/claims.md. The tests compare monitors with these
// definitions, which share nothing with them.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace robochart::claims::testing {

/// A trace, in which events are small numbers and time is `tock`.
using Trace = std::vector<int>;
using Set = std::set<int>;
constexpr int tock = -1;

/// A predicate that is true if the events of a trace break the body. The trace may begin at any instant.
using Bad = std::function<bool(const Trace&)>;

Bad never(Set events);
Bad only_after(Set events, Set others);
Bad only_within(Set events, Set others, int limit);
Bad leads_within(Set events, Set others, int limit, Set exceptions);
Bad leads_before(Set events, Set others, Set end);
Bad at_least(Set events, Set others, int limit, Set exceptions);
Bad at_most(Set events, int count);
Bad at_most_in(Set events, int count, int window);
Bad every(Set events, int limit);

/// True if an answer is missing at the end of the trace.
bool answer_missing(const Trace& trace, const Set& events, const Set& others, const Set& exceptions);

/// Return predicates that are true if the trace breaks the body in the scope.
Bad before(Set first, Bad body);
Bad after(Set first, Bad body);
Bad after_until(Set first, Set last, Bad body);
/// Returns a predicate that begins to count again at each event of `first`. The count includes this event.
Bad at_most_after_each(Set first, Set events, int count);
/// Returns a predicate that is true if the trace breaks the body while an event of `first` is at most `limit` time
/// units ago.
Bad for_after(Set first, int limit, Bad body);

}  // namespace robochart::claims::testing
