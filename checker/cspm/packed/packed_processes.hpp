// SPDX-License-Identifier: Apache-2.0
// The processes of a script with their states as bytes (term_codec.hpp). Nothing is kept of a state but its bytes:
// what is evaluated for its steps is forgotten now and then, all at once, by loading the script anew.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "checker/cspm/packed/direct_steps.hpp"
#include "checker/cspm/packed/loaded_script.hpp"

namespace robochart::cspm {

/// Owns a loaded script of its own. Steps depend on a state's bytes alone, not on what was asked before: events have
/// the numbers of the search, whose table and the script's are kept alike, and where the elements of a set would be in
/// the order in which processes were made, there are no packed states (NotPacked).
class PackedProcesses {
public:
    struct Settings {
        bool whole_states = false;  ///< see Session
        /// Values and terms that may be kept beside those that the start took.
        std::size_t most_kept = 400'000;
        bool terms_alone = false;        ///< for tests: no steps are found without terms
        bool forget_each_state = false;  ///< for tests: the script is loaded again for each state
    };
    /// `events`: those of the searches.
    PackedProcesses(Script script, process::EventTable& events, const Settings& settings);
    ~PackedProcesses();
    PackedProcesses(const PackedProcesses&) = delete;
    PackedProcesses& operator=(const PackedProcesses&) = delete;

    /// One more process, a side of an assertion; returns its number. Bytes of states are those of no other number.
    [[nodiscard]] std::size_t add(const ExprPtr& expr, const Decl& assertion);

    /// From now on rows are the same in every run: what would be numbered in the order of its appearance is refused.
    void fix_parts() { parts_.fix(); }

    // These throw EvaluationError, and NotPacked where a state has no bytes.
    [[nodiscard]] Bytes initial(std::size_t side);
    /// By event; events are those of the searches. `span`: where a fault is that no definition is to blame for.
    void steps(std::span<const std::uint8_t> state, Span span, PackedSteps& out);
    [[nodiscard]] std::string describe(std::span<const std::uint8_t> state);

    [[nodiscard]] process::EventTable& events() const { return events_; }
    void watch(std::function<void()> poll);
    /// Whether the steps of the first states are found without terms.
    [[nodiscard]] bool is_direct(std::size_t side);
    /// How often the script was loaded.
    [[nodiscard]] std::size_t loads() const { return loads_; }
    /// Steps found without terms.
    [[nodiscard]] std::uint64_t direct_answers() const { return direct_answers_; }

private:
    class NoCompressor;
    class SameEvents;
    struct Asked {
        ExprPtr expr;
        DeclPtr assertion;
    };

    void load();
    void make_codec();
    void load_if_needed();
    void refuse_sets_of_processes() const;
    void forget();
    [[nodiscard]] std::size_t kept() const;
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
    std::function<void()> poll_;
    std::size_t kept_at_start_ = 0;
    std::size_t loads_ = 0;
    std::uint64_t direct_answers_ = 0;
};

}  // namespace robochart::cspm
