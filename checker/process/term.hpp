// Process terms: hash-consed CSP operator trees over integer events. The CSPM evaluator builds them,
// the operational semantics steps them, the compiler turns them into machines. Equal terms have equal ids.
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
using Renaming = std::vector<EventPair>;  ///< ascending (from, to); events not named keep their name

enum class TermId : std::uint32_t {};
enum class SetId : std::uint32_t {};
enum class RenamingId : std::uint32_t {};
enum class OrderId : std::uint32_t {};

/// The operators of terms; `P`, `Q`, `n children` are a term's children in order.
enum class Op : std::uint8_t {
    stop,
    skip,
    div,
    omega,  ///< after tick: does nothing
    run,
    chaos,   ///< set
    call,    ///< payload: Definitions call; unfolds without a tau
    prefix,  ///< payload: Definitions prefix: its branches
    external_choice,
    internal_choice,  ///< n children, n >= 2
    sequential,       ///< P ; Q
    interrupt,        ///< P /\ Q
    sliding,          ///< P [> Q
    exception,        ///< P [| set |> Q
    sync_choice,      ///< [+ set +], n children
    sync_interrupt,   ///< P /+ set +\ Q
    parallel,         ///< n children, all synchronise on `set` and on tick (interleaving: empty set)
    alphabetised,     ///< n children, `sets` one alphabet each; event needs all whose alphabet has it; tick needs all
    hide,
    rename,            ///< one child; set / renaming
    prioritise,        ///< one child; order
    prioritise_order,  ///< one child; payload: the pairs (higher, lower) of priority_order, kept as a renaming
    chase,             ///< one child: every tau is followed at once, the first of several
    compress,     ///< one child; payload: Compression. Meaning: the child's, up to the models the compression keeps
    machine,      ///< a state of a compressed machine; one child: a term it stands for; made by the semantics only
    chaos_offer,  ///< set: the state of chaos(set) that offers the whole set; made by the firing rules only
};

/// The compressions of FDR by name; docs/cspm.md says what each is here.
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
    // Known by name alone: whoever asks what they do is refused. `sets` holds the watchdog's alphabet and event.
    trace_watchdog,
    failure_watchdog
};

/// Priorities for `prioritise`: level 0 first. Tau and tick rank with level 0. Events in no level are incomparable:
/// they neither cut nor are cut. A state's event of level k>0 is kept only if no tau, tick or event of a lower-numbered
/// level is possible. An event listed twice has its first level.
using PriorityOrder = std::vector<EventSet>;

/// An operator with its children; equal terms have one TermId.
struct Term {
    Op op = Op::stop;
    std::uint32_t payload = 0;  ///< call/prefix index, SetId, RenamingId, OrderId, Compression
    std::vector<TermId> children;
    std::vector<SetId> sets;  ///< alphabetised
    friend bool operator==(const Term&, const Term&) = default;
};

/// One event of a prefix and the term behind it.
struct Branch {
    Event event;
    TermId target;
};

/// What the terms' names mean; the CSPM evaluator implements it. Results are fixed: called at most once per index
/// by the term store, which keeps them. Errors of evaluation are thrown as EvaluationError.
class Definitions {
public:
    virtual ~Definitions() = default;
    virtual TermId unfold(std::uint32_t call) = 0;
    virtual std::vector<Branch> branches(std::uint32_t prefix) = 0;
    /// "P(1,true)" for reports.
    [[nodiscard]] virtual std::string describe_call(std::uint32_t call) const = 0;
};

/// Owns terms, event sets, renamings and priority orders of one check.
class TermStore {
public:
    explicit TermStore(EventTable& events);
    TermStore(const TermStore&) = delete;
    TermStore& operator=(const TermStore&) = delete;

    TermId make(const Term&);  ///< hash-consed; no simplification
    [[nodiscard]] const Term& operator[](TermId) const;
    [[nodiscard]] std::size_t size() const;

    SetId set(EventSet);  ///< sorted and deduplicated here
    [[nodiscard]] const EventSet& operator[](SetId) const;
    [[nodiscard]] bool contains(SetId, Event) const;
    RenamingId renaming(Renaming);
    [[nodiscard]] const Renaming& operator[](RenamingId) const;
    OrderId order(PriorityOrder);
    [[nodiscard]] const PriorityOrder& operator[](OrderId) const;

    void define(Definitions& definitions) { definitions_ = &definitions; }
    TermId unfold(std::uint32_t call);  ///< memoised
    /// What calls lead to: the first term that is none, or the last of so many unfoldings.
    TermId unfolded(TermId term, int most);
    const std::vector<Branch>& branches(std::uint32_t prefix);  ///< memoised
    /// The branches if they have been asked for already; evaluates nothing.
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
