// SPDX-License-Identifier: Apache-2.0
// The operational semantics of process terms. All other engines must give the same results. The firing rules follow
// Roscoe, Understanding Concurrent Systems (2010), chapter 9. Termination follows FDR: tick is an event of the
// semantics, the operands of a parallel operator must terminate together, and no event follows tick.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>

#include "base/diagnostics/budget.hpp"
#include "checker/process/compressor.hpp"
#include "checker/process/term.hpp"

namespace robochart::process {

/// One transition of a term.
struct Transition {
    Event event;
    Event revealed;  ///< for tau, the event that hiding made invisible, or tau; otherwise equal to `event`
    TermId target;
    friend bool operator==(const Transition&, const Transition&) = default;
};

/// Thrown for a term without an operational semantics: a recursion that reaches no event, or an operator without rules.
class SemanticsError : public std::runtime_error {
public:
    explicit SemanticsError(const std::string& message, std::optional<TermId> at = std::nullopt)
        : std::runtime_error(message), term(at) {}
    std::optional<TermId> term;  ///< the term that has no semantics, if it is known
};

/// Thrown by a budget to stop work that takes too long.
using Interrupted = diagnostics::LimitReached;

/// Computes and stores the transitions of the terms of one store.
class OperationalSemantics {
public:
    /// With a compressor, the operand of a compressed term is explored completely when the term's transitions are first
    /// needed. The term then behaves as the machine that the compressor returns. Without a compressor, or if there are
    /// too many states, it behaves as its operand. Use only one object for each store: states of machines are terms,
    /// and only the object that created such a term knows its transitions.
    explicit OperationalSemantics(TermStore& terms, Compressor* compressor = nullptr);
    ~OperationalSemantics();
    OperationalSemantics(const OperationalSemantics&) = delete;
    OperationalSemantics& operator=(const OperationalSemantics&) = delete;

    /// Returns the transitions of a term without duplicates, sorted by event and then by the order of operands. The
    /// result is valid during the lifetime of this object. Throws SemanticsError, and the exceptions of the
    /// definitions.
    std::span<const Transition> successors(TermId term);
    [[nodiscard]] TermStore& terms() const;
    /// Returns the first state of the machine that a compressed term runs as. Returns no value if the term is not
    /// compressed, if there is no compressor, if the compression was omitted, or if the term has no transitions. Throws
    /// as `successors`.
    std::optional<TermId> first_machine_state(TermId term);
    /// Returns the terms whose compression was omitted so far because their operands have too many states.
    [[nodiscard]] const std::set<TermId>& left_out() const;
    /// Sets the budget that the computation of transitions polls. The budget must outlive this object.
    void set_budget(diagnostics::Pollable& budget);
    /// Returns the number of known states of the compressed operand that is being explored, or 0 if none is being
    /// explored.
    [[nodiscard]] std::size_t states_explored() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Describes the state of a term for readers: the definitions of its active components, with arguments. " ‖ " joins
/// parallel components.
[[nodiscard]] std::string describe(const TermStore& terms, TermId term);

}  // namespace robochart::process
