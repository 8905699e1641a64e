// SPDX-License-Identifier: Apache-2.0
// Manages searches by levels that store their rows in files of a folder, either as checkpoints or because they do not
// fit into memory (docs/search.md, "Checkpoints", "Out of core"). The folder contains
//
//   lock               locked by a run as long as it uses the folder
//   questions          the assertions so far, in order, and the program that checked them
//   answers/           the results of the decided assertions
//   search-HEX/        the levels and checkpoints of a search of an assertion that is not decided
//
// Another run that checks the same assertions in the same order can continue from this folder.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/cache/cache.hpp"
#include "base/diagnostics/descriptor.hpp"
#include "checker/refine/verdict/level_strategy.hpp"

namespace robochart::refine {

struct KeptSettings {
    std::string folder;
    /// Whether to continue from the contents of the folder. If false, the folder must be empty or missing.
    bool resume = false;
    bool disk = false;  ///< whether rows that do not fit into memory are stored in files
    std::chrono::milliseconds every = std::chrono::minutes(10);  ///< time between checkpoints
    /// The identity of the program, which must not be empty. Programs with the same identity compile processes to the
    /// same rows.
    std::string program;
    /// Receives messages for the user: sentences without a full stop. The function may be empty.
    std::function<void(const std::string&)> say;
    // For tests; see DiskRowStore::Bounds.
    std::optional<std::uint64_t> most_bytes;
    unsigned filter_bits = RowKeeping{}.filter_bits;
    unsigned reads_a_step = RowKeeping{}.reads_a_step;
};

/// Manages the folder at the first rank. Another strategy executes the searches. All ranks must see the folder.
class KeptSearch final : public LevelStrategy {
public:
    /// `ranks` executes the searches and must outlive this object. Throws storage::BadFile in three cases: the folder
    /// is not empty and `resume` is not set; `resume` is set but this program cannot continue from the folder's
    /// contents; or the program has no identity. Throws storage::CannotWrite if the folder cannot be written.
    KeptSearch(KeptSettings settings, LevelStrategy& ranks);
    ~KeptSearch() override;

    /// Begins an assertion. Throws storage::BadFile if the folder was written for another assertion at this position.
    void begin_question(const std::string& text) override;
    /// Identifies the current assertion. Throws storage::BadFile if the folder was written for the same assertion about
    /// other processes.
    void identify_question(const std::optional<diagnostics::Digest>& digest) override;
    /// Ends the current assertion. If it is decided and its answer is in `answers`, its searches are removed.
    void end_question(bool decided) override;
    /// Removes all stored data if all assertions are decided.
    void all_asked() override;
    [[nodiscard]] diagnostics::Cache* answers() override { return answers_ ? &*answers_ : nullptr; }
    std::optional<Violation> search(lts::TransitionSystem& system, const LevelQuestion& question, Budget& budget,
                                    Statistics& statistics) override;

private:
    struct Asked {
        std::string digest;  ///< in hexadecimal
        std::string text;
    };
    void lock_folder();
    void look_at_folder() const;
    void remove_folder();
    void read_questions();
    [[noreturn]] void refuse_question(std::size_t place, const std::string& instead) const;
    void write_questions() const;
    [[nodiscard]] std::string path(const std::string& name) const { return settings_.folder + "/" + name; }
    void remove_searches();
    void remove_left_over() const;
    [[nodiscard]] RowKeeping rows_of(const LevelQuestion& question, std::size_t width, const Budget& budget);

    KeptSettings settings_;
    LevelStrategy& ranks_;
    diagnostics::Descriptor lock_;  ///< the lock of the folder
    std::optional<diagnostics::Cache> answers_;
    std::vector<Asked> earlier_;                   ///< the assertions for which the folder was written
    std::vector<Asked> asked_;                     ///< the assertions of this run so far
    std::optional<diagnostics::Digest> question_;  ///< the digest of the current assertion
    std::uint64_t searches_ = 0;                   ///< number of searches of the current assertion
    std::vector<std::string> folders_;             ///< folders of these searches
    std::vector<std::string> answered_;            ///< folders of decided assertions with unstored answers
    std::size_t decided_ = 0;                      ///< number of decided assertions in this run
};

}  // namespace robochart::refine
