// SPDX-License-Identifier: Apache-2.0
// The meaning of claims in the words of docs/claims.md, as predicates on finite traces: the reference of the monitors.
// Nothing here is shared with them.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace robochart::claims::testing {

/// Events are small numbers, time is `tock`.
using Trace = std::vector<int>;
using Set = std::set<int>;
constexpr int tock = -1;

/// True if the events of a trace, which begin at some instant, break the body.
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

/// The trace breaks the body in the scope.
Bad before(Set first, Bad body);
Bad after(Set first, Bad body);
Bad after_until(Set first, Set last, Bad body);
/// The count begins anew at each event of `first`, which counts itself.
Bad at_most_after_each(Set first, Set events, int count);
/// As long as an event of `first` is at most `limit` time units ago.
Bad for_after(Set first, int limit, Bad body);

}  // namespace robochart::claims::testing
