// Searches by levels whose rows are kept in files of a folder: as checkpoints, or because memory does not hold them
// (docs/search.md, "Checkpoints", "Out of core"). The folder has
//
//   lock               that a run has locked as long as it uses the folder
//   questions          the questions asked so far, in order, and which program asked them
//   answers/           what has been found about those that are decided
//   search-HEX/        the levels and checkpoints of a search of a question that is not decided
//
// Another run that asks the same questions in the same order goes on from there.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "checker/refine/verdict/level_strategy.hpp"
#include "diagnostics/cache/cache.hpp"
#include "diagnostics/descriptor.hpp"

namespace robochart::refine {

struct KeptSettings {
    std::string folder;
    bool resume = false;  ///< goes on from what is in the folder; else there is nothing in it, or it is not there
    bool disk = false;    ///< rows that memory does not hold stay in files
    std::chrono::milliseconds every = std::chrono::minutes(10);  ///< between checkpoints
    /// Its identity, not empty: programs of the same identity compile processes to the same rows.
    std::string program;
    /// Takes what the user should know, a sentence without its end; may be empty.
    std::function<void(const std::string&)> say;
    // For tests: see DiskRowStore::Bounds.
    std::optional<std::uint64_t> most_bytes;
    unsigned filter_bits = RowKeeping{}.filter_bits;
    unsigned reads_a_step = RowKeeping{}.reads_a_step;
};

/// The folder's side of it, at the first rank; the searches are another strategy's, whose ranks all see the folder.
class KeptSearch final : public LevelStrategy {
public:
    /// `ranks` does the searches, and outlives this. Throws storage::BadFile where the folder has anything in it,
    /// without `resume`; or with it, nothing that this program can go on from; and where the program has no identity.
    /// Throws storage::CannotWrite.
    KeptSearch(KeptSettings settings, LevelStrategy& ranks);
    ~KeptSearch() override;

    /// Throws storage::BadFile where the folder was written for another question at this place.
    void begin_question(const std::string& text) override;
    /// Throws storage::BadFile where it was written for this question about other processes.
    void identify_question(const std::optional<diagnostics::Digest>& digest) override;
    /// The searches of a question that is decided are removed where its answer is among `answers`.
    void end_question(bool decided) override;
    /// If all have been decided, nothing of what was kept is left.
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
    diagnostics::Descriptor lock_;  ///< of the folder
    std::optional<diagnostics::Cache> answers_;
    std::vector<Asked> earlier_;                   ///< those that the folder was written for
    std::vector<Asked> asked_;                     ///< by this run
    std::optional<diagnostics::Digest> question_;  ///< that is being decided
    std::uint64_t searches_ = 0;                   ///< of it
    std::vector<std::string> folders_;             ///< of these
    std::vector<std::string> answered_;            ///< of questions that are decided, whose answers were not kept
    std::size_t decided_ = 0;                      ///< questions of this run
};

}  // namespace robochart::refine
