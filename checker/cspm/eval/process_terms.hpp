// SPDX-License-Identifier: Apache-2.0
// Represents processes as terms. The function and its arguments identify a call. The place in the script and the used
// values identify a prefix. Both are evaluated only when the search needs them (evaluator.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "checker/cspm/eval/domains.hpp"

namespace robochart::cspm {

/// Replaces every argument that the definition never reads.
inline constexpr std::int64_t unread_character = '_';

enum class PrefixKind : std::uint8_t { script = 2, chosen = 3, waiting = 4, stopped = 5, skipping = 6, buffer = 7 };

/// Returns the number of a set, renaming or order for the payload of a term.
template <typename Id>
std::uint32_t payload(Id id) {
    return static_cast<std::uint32_t>(id);
}

/// Owns the keys of calls and prefixes.
class ProcessTerms {
public:
    ProcessTerms(ValueStore& store, process::EventTable& events, process::TermStore& terms, Domains& domains,
                 const Work& work, const Program& program)
        : store_(store), events_(events), terms_(terms), domains_(domains), work_(work), text_(program) {}

    process::TermId make_term(process::Op op, std::vector<process::TermId> children = {}, std::uint32_t payload = 0);
    /// Returns the term of the operator with these children. A single child is returned unchanged.
    process::TermId make_operator(process::Op op, std::vector<process::TermId> children, std::uint32_t payload = 0);
    /// Returns the process that the value denotes.
    process::TermId term_of(Value value, Span span);
    process::TermId make_call(Value function, const Values& arguments);
    process::TermId make_prefix(PrefixKind kind, Values key);
    /// Returns a linked parallel. Each of the `ties` consists of an event of the left and an event of the right
    /// process.
    process::TermId make_linked(process::TermId left, process::TermId right,
                                const std::vector<process::EventPair>& ties, Span span);

    // The following functions are for timed sections (semantics 3.10).
    process::Event tock_event(const TimedSection& timed);
    process::SetId tock_set(const TimedSection& timed);
    process::TermId make_stop(const TimedSection* timed);
    process::TermId make_skip(const TimedSection* timed);
    process::TermId make_wait(process::Event tock, std::int64_t ticks, process::TermId then);

    /// Returns the key of a call: a tuple of the function and its arguments.
    [[nodiscard]] Value call_key(std::uint32_t call) const { return calls_[call]; }
    /// Returns the place of the definition that the call calls. The place is unknown for built-in functions.
    [[nodiscard]] Span place_of_call(std::uint32_t call) const;
    [[nodiscard]] std::pair<PrefixKind, Value> prefix_key(std::uint32_t prefix) const { return prefixes_[prefix]; }

private:
    ValueStore& store_;
    process::EventTable& events_;
    process::TermStore& terms_;
    Domains& domains_;
    const Work& work_;
    ValueText text_;
    std::vector<Value> calls_;
    std::unordered_map<Value, std::uint32_t> call_index_;
    std::vector<std::pair<PrefixKind, Value>> prefixes_;
    std::unordered_map<Value, std::uint32_t> prefix_index_[8];
};

}  // namespace robochart::cspm
