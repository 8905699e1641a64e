// SPDX-License-Identifier: Apache-2.0
// Process terms are trees of CSP operators over events. Equal terms are stored once and have equal ids (hash consing).
// The CSPM evaluator builds terms, the operational semantics executes them, and the compiler converts them to
// machines.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "checker/lts/event.hpp"

namespace robochart::process {

using lts::Event;
using lts::EventSet;
using lts::EventTable;
using lts::first_visible;
using lts::tau;
using lts::tick;

using EventPair = std::pair<Event, Event>;
using Renaming = std::vector<EventPair>;  ///< ascending (from, to); other events keep their name

enum class TermId : std::uint32_t {};
enum class SetId : std::uint32_t {};
enum class RenamingId : std::uint32_t {};
enum class OrderId : std::uint32_t {};

/// The operators of terms; `P`, `Q`, `n children` are a term's children in order.
enum class Op : std::uint8_t {
    stop,
    skip,
    div,
    omega,  ///< the state after tick, without transitions
    run,
    chaos,   ///< set
    call,    ///< payload: the number of the call for Definitions; unfolds without a tau
    prefix,  ///< payload: the number of the prefix for Definitions, which gives its branches
    external_choice,
    internal_choice,  ///< n children, n >= 2
    sequential,       ///< P ; Q
    interrupt,        ///< P /\ Q
    sliding,          ///< P [> Q
    exception,        ///< P [| set |> Q
    sync_choice,      ///< [+ set +], n children
    sync_interrupt,   ///< P /+ set +\ Q
    parallel,         ///< n children, all synchronise on `set` and on tick (interleaving: empty set)
    /// Each of the n children has an alphabet in `sets`. All children whose alphabet contains an event perform it
    /// together; all children perform tick together.
    alphabetised,
    hide,
    rename,            ///< one child; set / renaming
    prioritise,        ///< one child; order
    prioritise_order,  ///< one child; payload: the pairs (higher, lower) of priority_order, stored as a renaming
    chase,             ///< one child: its taus are followed immediately; if there are several, the first one
    /// One child; the payload is a Compression. The term has the same meaning as its child in all models that the
    /// compression preserves.
    compress,
    /// A state of a compressed machine, which only the semantics creates. Children: a term that it represents, the
    /// compressed term, and the first state (unless it is the first state itself).
    machine,
    chaos_offer,  ///< set: the state of chaos(set) that offers the whole set; created only by the firing rules
};

/// The compressions of FDR by name. docs/cspm.md describes how this program implements them.
enum class Compression : std::uint32_t {
    normal,
    sbisim,
    dbisim,
    wbisim,
    diamond,
    tau_loop_factor,
    model_compress,
    explicate,
    deter,
    lazyenumerate,
    // Scripts may name these compressions, but computing their transitions is an error. `sets` contains the watchdog's
    // alphabet and event.
    trace_watchdog,
    failure_watchdog
};

/// Priorities for `prioritise`: the sets of events by level; level 0 is the highest. Tau and tick have level 0. Events
/// without a level prevent no event, and no event prevents them. If a state can perform an event of level k > 0, the
/// event stays only if no tau, tick or event of a lower-numbered level is possible. An event that is listed twice has
/// its first level.
using PriorityOrder = std::vector<EventSet>;

/// An operator with its children; equal terms have one TermId.
struct Term {
    Op op = Op::stop;
    std::uint32_t payload = 0;  ///< call/prefix index, SetId, RenamingId, OrderId, Compression
    std::vector<TermId> children;
    std::vector<SetId> sets;  ///< alphabetised
    friend bool operator==(const Term&, const Term&) = default;
};

/// One event of a prefix and the term after it.
struct Branch {
    Event event;
    TermId target;
};

/// Gives the definitions of the names in terms. The CSPM evaluator implements it. The term store calls each
/// function at most once for each index and stores the result. So a result must never change. Throws
/// EvaluationError.
class Definitions {
public:
    virtual ~Definitions() = default;
    virtual TermId unfold(std::uint32_t call) = 0;
    virtual std::vector<Branch> branches(std::uint32_t prefix) = 0;
    /// Returns the text of the call for reports, such as "P(1,true)".
    [[nodiscard]] virtual std::string describe_call(std::uint32_t call) const = 0;
};

/// Owns terms, event sets, renamings and priority orders of one check.
class TermStore {
public:
    explicit TermStore(EventTable& events);
    TermStore(const TermStore&) = delete;
    TermStore& operator=(const TermStore&) = delete;

    TermId intern_term(const Term&);  ///< hash-consed; no simplification
    [[nodiscard]] const Term& operator[](TermId) const;
    [[nodiscard]] std::size_t size() const;

    SetId intern_set(EventSet);  ///< sorted and deduplicated here
    [[nodiscard]] const EventSet& operator[](SetId) const;
    [[nodiscard]] bool contains(SetId, Event) const;
    RenamingId intern_renaming(Renaming);
    [[nodiscard]] const Renaming& operator[](RenamingId) const;
    OrderId intern_order(PriorityOrder);
    [[nodiscard]] const PriorityOrder& operator[](OrderId) const;

    void define(Definitions& definitions) { definitions_ = &definitions; }
    TermId unfold(std::uint32_t call);  ///< memoised
    /// Unfolds calls: returns the first term that is not a call, or the last term after `most` unfoldings.
    TermId unfold_calls(TermId term, int most);
    const std::vector<Branch>& branches(std::uint32_t prefix);  ///< memoised
    /// Returns the branches if they have already been computed, otherwise null. Evaluates nothing.
    [[nodiscard]] const std::vector<Branch>* known_branches(std::uint32_t prefix) const;
    [[nodiscard]] const Definitions& definitions() const { return *definitions_; }
    [[nodiscard]] EventTable& events() { return events_; }
    [[nodiscard]] const EventTable& events() const { return events_; }

private:
    struct Impl;
    EventTable& events_;
    Definitions* definitions_ = nullptr;
    std::shared_ptr<Impl> impl_;
};

}  // namespace robochart::process
