// The operational semantics of process terms: the reference every other engine is measured against.
// Firing rules after Roscoe, Understanding Concurrent Systems (2010), chapter 9, with FDR's treatment of termination:
// tick is an event of the semantics, parallel operators terminate by synchronising it, and nothing follows it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>

#include "checker/process/compressor.hpp"
#include "checker/process/term.hpp"
#include "diagnostics/budget.hpp"

namespace robochart::process {

/// One transition of a term.
struct Transition {
    Event event;
    Event revealed;  ///< for tau, the event that hiding made invisible, or tau; else equal to `event`
    TermId target;
    friend bool operator==(const Transition&, const Transition&) = default;
};

/// A term that has no operational semantics: recursion that reaches no event, or an operator without rules.
class SemanticsError : public std::runtime_error {
public:
    explicit SemanticsError(const std::string& message, std::optional<TermId> at = std::nullopt)
        : std::runtime_error(message), term(at) {}
    std::optional<TermId> term;  ///< the one that is at fault, if that is known
};

/// Thrown by a poll that wants long work to stop.
using Interrupted = diagnostics::LimitReached;

/// Computes and keeps the transitions of the terms of one store.
class OperationalSemantics {
public:
    /// With a compressor, a compressed term is explored as a whole when it is first stepped, and behaves as the machine
    /// that the compressor makes of it; without one, and where the operand has too many states, it behaves as its
    /// operand. Use one object for one store: states of machines are terms that only the object knows that made them.
    explicit OperationalSemantics(TermStore& terms, Compressor* compressor = nullptr);
    ~OperationalSemantics();
    OperationalSemantics(const OperationalSemantics&) = delete;
    OperationalSemantics& operator=(const OperationalSemantics&) = delete;

    /// The transitions of a term, ordered by event and within one event by the operands' order; without repetitions.
    /// Valid until this object ends. Throws SemanticsError, and what the definitions throw.
    std::span<const Transition> successors(TermId term);
    [[nodiscard]] TermStore& terms() const;
    /// The compressed terms stepped so far whose operands have too many states.
    [[nodiscard]] const std::set<TermId>& left_out() const;
    /// Called now and then while a compressed operand is explored; may throw to stop it. Empty: none.
    void watch(std::function<void()> poll);
    /// Of the compressed operand that is explored now, the states known so far; 0 where none is.
    [[nodiscard]] std::size_t states_explored() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The state of a term as people read it: the definitions its active components are in, with arguments;
/// parallel components are joined by " ‖ ".
[[nodiscard]] std::string describe(const TermStore& terms, TermId term);

}  // namespace robochart::process
