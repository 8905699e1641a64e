// SPDX-License-Identifier: Apache-2.0
// Checks whether recorded runs are runs of the model. A run must be in traces(NF_c(M)), which is checked cycle by
// cycle, for logs of any size (docs/traces.md; trace validation after Cirstea et al., "Validating traces of distributed
// programs against TLA+ specifications", 2024).
#pragma once

#include <deque>
#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "checker/refine/search/budget.hpp"
#include "checker/refine/verdict/normal_form.hpp"
#include "conformance/traces/log_projection.hpp"
#include "conformance/traces/logged_numbers.hpp"
#include "conformance/traces/trace_alphabet.hpp"
#include "conformance/traces/trace_text.hpp"

namespace robochart::conformance {

enum class RunVerdict {
    accepted,
    rejected,
    inconclusive,  ///< the run contains values outside the finite instantiation that may affect the verdict
};

/// One run of a log.
struct RunReport {
    std::string name;
    std::uint64_t line = 0;  ///< first line
    RunVerdict verdict = RunVerdict::accepted;
    std::uint64_t cycles = 0;    ///< number of complete cycles that were checked
    std::uint64_t replaced = 0;  ///< number of values outside the finite instantiation that the component only passes
                                 ///< on
    // The following members are for rejected and inconclusive runs.
    std::uint64_t at_line = 0;
    std::uint64_t cycle = 0;       ///< counted from 1
    std::string what;              ///< "StartTurning!0.5", "the end of the cycle"
    std::string reason;            ///< inconclusive
    bool related_numbers = false;  ///< inconclusive, because the model compares numbers with each other that are
                                   ///< outside the finite instantiation
    std::vector<std::string> cycle_so_far;  ///< preceding words of the cycle
    std::vector<std::string> before;        ///< preceding cycles, as logged
    std::vector<std::string> allowed;       ///< events that the model would have allowed, with places
    std::vector<std::string> elements;      ///< possible elements of the model at the beginning of the cycle
};

/// An error in a log that cannot be parsed. Nothing after the error is checked.
struct LogFault {
    TraceFault fault;
    std::uint64_t line = 0;
    std::string text;  ///< text of the line
};

struct LogReport {
    std::uint64_t runs = 0, accepted = 0, rejected = 0, inconclusive = 0;
    std::uint64_t cycles = 0;
    std::uint64_t replaced = 0;
    bool related_numbers = false;  ///< of some run
    LoggedNumbers numbers;         ///< at most one more of each kind than with_logged_numbers takes
    std::optional<LogFault> fault;
    TraceHeader header;
};

class TraceChecker {
public:
    /// `component` contains the names that logs may use for the component. `unit` is the declared length of a time
    /// unit.
    TraceChecker(CyclicModel&, std::vector<std::string> component, const refine::Limits&,
                 const diagnostics::SourceManager&, durations::Unit unit = {});
    /// For one log, whose numbers the model's instantiation contains.
    TraceChecker(CyclicModel&, std::vector<std::string> component, const refine::Limits&,
                 const diagnostics::SourceManager&, durations::Unit unit, const ExactNumbers& exact);
    ~TraceChecker();

    /// Reads one log to its end, or to the first line that cannot be parsed. `constants` contains the constants of the
    /// log's header with which the model was built. Any other constant is an error (RC-L04). Calls `tell` with every
    /// run that is not accepted. Throws process::Interrupted at a limit.
    LogReport check_log(std::istream&, const std::vector<std::string>& constants,
                        const std::function<void(const RunReport&)>& tell);

private:
    struct Form;
    class LogRun;
    /// Returns null if `late` and the states in which a cycle may begin are too many or cannot be computed.
    [[nodiscard]] Form* form_for(const Observation&, bool late);
    [[nodiscard]] std::vector<std::vector<lts::Word>> find_starts();

    CyclicModel* model_;
    std::vector<std::string> component_;
    const refine::Limits& limits_;
    durations::Unit unit_;
    const diagnostics::SourceManager* sources_;
    refine::Budget budget_;
    TraceAlphabet alphabet_;
    std::string rounding_;                                       ///< as in ExactNumbers
    std::optional<std::vector<std::vector<lts::Word>>> starts_;  ///< empty if they are not known
    std::deque<std::unique_ptr<Form>> forms_;
};

}  // namespace robochart::conformance
