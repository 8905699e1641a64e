// SPDX-License-Identifier: Apache-2.0
// Represents the states of a process as bytes (term_codec.hpp). Only these bytes are stored
// permanently. Evaluating steps creates other data; to free them, the script is loaded again from time
// to time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/cspm/packed/direct_steps.hpp"
#include "checker/cspm/packed/loaded_script.hpp"

namespace robochart::cspm {

/// Owns a loaded script. The steps of a state depend only on its bytes and not on earlier calls. The search and the
/// script use the same event numbers. A set of processes has no packed form (NotPacked): its elements are ordered by
/// the creation of the processes, which depends on earlier calls.
class PackedProcesses {
public:
    struct Settings {
        bool whole_states = false;  ///< see Session
        /// How many values and terms may be stored in addition to those of the first state.
        std::size_t most_kept = 400'000;
        bool terms_alone = false;        ///< for tests: compute all steps with terms
        bool forget_each_state = false;  ///< for tests: load the script again for each state
    };
    /// `events`: the event table of the searches.
    PackedProcesses(Script script, process::EventTable& events, const Settings& settings);
    ~PackedProcesses();
    PackedProcesses(const PackedProcesses&) = delete;
    PackedProcesses& operator=(const PackedProcesses&) = delete;

    /// Adds a process and returns its number. The process is one side of the assertion.
    [[nodiscard]] std::size_t add(const ExprPtr& expr, const Decl& assertion);

    /// After this call, no set, renaming or order gets a new number, because this number would depend on the order of
    /// the search. If one without a number occurs, NotPacked is thrown. So rows are the same in every run.
    void fix_parts() { parts_.fix_numbers(); }

    // The following functions throw EvaluationError, and NotPacked if a state has no packed form.
    [[nodiscard]] Bytes initial(std::size_t side);
    /// Writes the steps of the state to `out`, ordered by event. Events have the numbers of the search. An error is
    /// reported at `span` if the definition that causes it is unknown.
    void steps(std::span<const std::uint8_t> state, Span span, PackedSteps& out);
    /// Returns the operands if the state is an external choice, and an empty list otherwise. `span` has the same
    /// meaning as in `steps`.
    [[nodiscard]] std::vector<Bytes> choice_operands(std::span<const std::uint8_t> state, Span span);
    [[nodiscard]] std::string describe(std::span<const std::uint8_t> state);

    [[nodiscard]] process::EventTable& events() const { return events_; }
    /// Sets the budget that evaluations poll. The budget must outlive them.
    void set_budget(diagnostics::Pollable& budget);
    /// Examines the first states of the process. Returns true if their steps can be computed without terms.
    [[nodiscard]] bool is_direct(std::size_t side);
    /// Returns how many times the script has been loaded.
    [[nodiscard]] std::size_t load_count() const { return loads_; }
    /// Returns the number of states whose steps were computed without terms.
    [[nodiscard]] std::uint64_t direct_answers() const { return direct_answers_; }

private:
    class NoCompressor;
    class SameEvents;
    struct Asked {
        ExprPtr expr;
        DeclPtr assertion;
    };

    void load_script();
    void make_codec();
    void load_if_needed();
    void refuse_sets_of_processes() const;
    void forget_if_large();
    [[nodiscard]] std::size_t kept_object_count() const;
    void steps_of_term(std::span<const std::uint8_t> state, PackedSteps& out);

    Script script_;
    std::vector<Asked> asked_;
    process::EventTable& events_;
    Settings settings_;
    PackedParts parts_;
    std::unique_ptr<NoCompressor> no_compressor_;
    std::unique_ptr<LoadedScript> loaded_;
    std::unique_ptr<TermCodec> codec_;
    std::unique_ptr<DirectSteps> direct_;
    std::vector<LoadedScript::Side> sides_;
    diagnostics::Pollable* budget_ = &diagnostics::unlimited;
    std::size_t kept_at_start_ = 0;
    std::size_t loads_ = 0;
    std::uint64_t direct_answers_ = 0;
};

}  // namespace robochart::cspm
