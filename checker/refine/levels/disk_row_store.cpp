// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/levels/disk_row_store.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "checker/refine/levels/hashed_rows.hpp"
#include "checker/storage/sort_rows.hpp"

namespace robochart::refine {

using lts::StateIndex;
using lts::StateStore;
using lts::StateView;
using lts::Word;

namespace {

// The memory is divided into sixteen parts. Shares of the filter, the open level and the rows put aside:
constexpr std::uint64_t filter_part = 13, open_part = 2, aside_part = 1;
constexpr Level no_level = std::numeric_limits<Level>::max();

std::vector<Word> sorted_rows(const StateStore& store, StateIndex first, StateIndex end) {
    std::vector<Word> rows;
    rows.reserve((end - first) * store.width());
    for (StateIndex i = first; i < end; ++i) rows.insert(rows.end(), store[i].begin(), store[i].end());
    storage::sort_rows(rows, store.width());
    return rows;
}

}  // namespace

DiskRowStore::DiskRowStore(KeptWhere where, Bounds bounds)
    : RowStore(where.kind.width),
      kept_(where),
      bounds_(std::move(bounds)),
      filter_(bounds_.filter_bits, bounds_.most_bytes / 16 * filter_part),
      most_open_(StateStore::most_in(bounds_.most_bytes / 16 * open_part, width())),
      open_(new_store()),
      runs_(path_of("runs", where), where.kind),
      aside_(path_of("aside", where), where.kind, bounds_.most_bytes / 16 * aside_part),
      late_level_(no_level),
      late_(new_store()) {
    kept_.load_checkpoint(record(),
                          [this](Level level, StateView row) { aside_.add(row, StateStore::hash(row), level); });
    if (levels() > 0) fill_filter();
}

DiskRowStore::~DiskRowStore() {
    if (bounds_.report) bounds_.report(figures_);
}

/// For the open level, returns only a lower bound. Several runs may contain the same row, if it was found again after
/// it had been written, so their lengths cannot be added.
std::uint64_t DiskRowStore::rows(Level level) const {
    return level < levels() ? kept_.files().rows(level) : std::max<std::uint64_t>(open_->size(), runs_.longest_run());
}

RowStore::Found DiskRowStore::enter_row(StateView row, std::uint64_t hash) {
    ++met_;
    if (open_->find(row, hash) != lts::no_state) return Found::again;
    if (levels() > 0 && filter_.may_have(hash)) {
        aside_.add(row, hash, levels());  // a row that was put aside before keeps its earlier level
        return Found::unsure;
    }
    ++new_;
    add_to_open(row, hash);
    return Found::fresh;
}

void DiskRowStore::add_to_open(StateView row, std::uint64_t hash) {
    if (open_->size() >= most_open_) write_open();
    open_->insert(row, hash);
    assert(open_->size() <= most_open_);
}

std::uint64_t DiskRowStore::rows_sorted_at_once() const {
    return std::max<std::uint64_t>(most_open_ / 4, 64);
}

/// Writes the rows of the open level as runs. Sorts one piece after the other, because a row exists three times in
/// memory while it is sorted.
void DiskRowStore::write_open() {
    note_peak();
    const auto piece = static_cast<StateIndex>(rows_sorted_at_once());
    const auto end = static_cast<StateIndex>(open_->size());
    for (StateIndex first = 0; first < end; first += piece)
        runs_.add(sorted_rows(*open_, first, std::min(end, first + piece)));
    ++figures_.runs_written;
    renew_open();
}

/// Empties the store of the open level. If it was full, it will probably be full again, so its new table has the full
/// size at once.
void DiskRowStore::renew_open() {
    const bool full = open_->size() >= most_open_;
    open_ = new_store();
    if (full) open_->reserve(most_open_, {});
}

void DiskRowStore::empty_open() {
    if (open_->size() > 0) renew_open();
    runs_.clear();
}

void DiskRowStore::close_level() {
    note_peak();
    const bool in_one_piece = runs_.empty() && open_->size() <= rows_sorted_at_once();
    if (in_one_piece) {
        const std::vector<Word> rows = sorted_rows(*open_, 0, static_cast<StateIndex>(open_->size()));
        kept_.files().add_level(rows);
        add_to_filter(rows);
    } else {
        write_open();
        kept_.files().add_level([this](const storage::TakeRows& take) {
            runs_.merge([&](std::span<const Word> rows) {
                kept_.poll();
                take(rows);
                add_to_filter(rows);
            });
        });
    }
    empty_open();
    if (filter_.capacity() > 0 && filter_.size() == filter_.capacity()) fill_filter();
}

/// Adds rows to the filter. Rows that do not fit are added when the filter is refilled.
void DiskRowStore::add_to_filter(std::span<const Word> rows) {
    each_hashed(
        rows, width(), [this](std::uint64_t hash) { filter_.prefetch(hash); },
        [this](StateView, std::uint64_t hash) {
            if (filter_.size() < filter_.capacity()) filter_.add(hash);
        });
}

/// Fills the filter with the rows of the levels and the rows put aside. Rows put aside are included, because an unsure
/// row must stay unsure until it is settled; a filter of another size might reject it.
void DiskRowStore::fill_filter() {
    filter_.reset(kept_.files().rows());
    if (filter_.capacity() == 0) return;
    for (Level level = 0; level < levels(); ++level)
        kept_.files().each_block(level, [this](std::span<const Word> block) {
            kept_.poll();
            add_to_filter(block);
        });
    aside_.each_piece([this](const std::vector<Word>& rows) {
        kept_.poll();
        for (std::size_t at = 0; at < rows.size(); at += width() + 1) {
            const std::uint64_t hash = StateStore::hash(StateView(rows).subspan(at, width()));
            if (!filter_.may_have(hash) && filter_.size() < filter_.capacity()) filter_.add(hash);
        }
    });
}

/// Returns true if it is time to settle the rows put aside. If a row was taken for a duplicate by mistake, all work
/// since the last settling is lost. The expected total loss is minimal if this work, multiplied by the probability of a
/// mistake, equals the work of settling (Young, CACM 17(9), 1974). Rows put aside in files are settled when there are
/// as many of them as of all other rows. So they never need more space than the other rows.
bool DiskRowStore::wants_to_settle() const {
    if (late_->size() > 0) return true;
    if (aside_.empty()) return false;
    if (aside_.on_disk() && aside_.rows() >= kept_.files().rows()) return true;
    const auto settling = static_cast<double>(kept_.files().rows() + aside_.rows());
    // Adding a row to the filter takes longer than reading the row.
    const double lost = static_cast<double>(met_) * bounds_.reads_a_step + 6 * settling;
    const double in_error = filter_.capacity() == 0 ? 1.0 : std::min(1.0, static_cast<double>(new_) * filter_.error());
    return bounds_.reads_a_step > 0 && in_error * lost >= settling;
}

namespace {

/// Compares two rows of `width` words. Returns a negative number if `a` is less than `b`, 0 if both are equal, and
/// otherwise a positive number.
int compare_rows(const Word* a, const Word* b, std::size_t width) {
    for (std::size_t i = 0; i < width; ++i)
        if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
    return 0;
}

/// A sequence of ascending rows with their levels. It is compared with another ascending sequence.
class Sought {
public:
    Sought(std::vector<Word>& rows, std::size_t width) : rows_(rows), width_(width) {}
    /// Advances to the first row that is not less than `row`. Doubles its steps to find it (Bentley and Yao,
    /// Information Processing Letters 5(3), 1976). Returns false if there is no such row.
    bool seek_row(const Word* row) {
        if (at_ == end() || !is_before(at_, row)) return at_ != end();
        std::size_t step = stride();
        std::size_t low = at_;  // the row at this index is less than `row`
        while (end() - low > step && is_before(low + step, row)) {
            low += step;
            step *= 2;
        }
        std::size_t high = std::min(end(), low + step);
        while (high - low > stride()) {
            const std::size_t middle = low + (high - low) / stride() / 2 * stride();
            (is_before(middle, row) ? low : high) = middle;
        }
        assert(high > at_ && high % (width_ + 1) == 0);
        at_ = high;
        return at_ != end();
    }
    [[nodiscard]] const Word* row() const {
        assert(at_ < rows_.size());
        return &rows_[at_];
    }
    [[nodiscard]] Level current_level() const { return rows_[at_ + width_]; }
    void mark_found() { rows_[at_ + width_] = no_level; }

    /// Removes the marked rows from the sequence.
    void remove_marked() {
        std::size_t to = 0;
        for (std::size_t from = 0; from < end(); from += stride()) {
            if (rows_[from + width_] == no_level) continue;
            if (to != from) std::copy_n(&rows_[from], stride(), &rows_[to]);
            to += stride();
        }
        assert(to <= rows_.size());
        rows_.resize(to);
    }

private:
    [[nodiscard]] std::size_t stride() const { return width_ + 1; }
    [[nodiscard]] std::size_t end() const { return rows_.size(); }
    [[nodiscard]] bool is_before(std::size_t at, const Word* row) const {
        return compare_rows(&rows_[at], row, width_) < 0;
    }
    std::vector<Word>& rows_;
    std::size_t width_;
    std::size_t at_ = 0;
};

}  // namespace

/// Removes the rows that this level contains, except those that belong to an earlier level themselves. Does not read
/// blocks that cannot contain any of these rows.
void DiskRowStore::remove_those_in(Level level, bool polled, std::vector<Word>& rows) {
    Sought sought(rows, width());
    const auto wants = [&](StateView first, StateView next) {
        return sought.seek_row(first.data()) && (next.empty() || compare_rows(sought.row(), next.data(), width()) < 0);
    };
    bool any = false;
    kept_.files().each_block_if(level, wants, [&](StateView block) {
        if (polled) kept_.poll();
        for (std::size_t at = 0; at < block.size(); at += width()) {
            const Word* const row = &block[at];
            int order = compare_rows(sought.row(), row, width());
            if (order < 0) {
                if (!sought.seek_row(row)) return;
                order = compare_rows(sought.row(), row, width());
            }
            if (order > 0 || level > sought.current_level()) continue;
            sought.mark_found();
            any = true;
        }
    });
    if (any) sought.remove_marked();
}

/// Handles rows that no level contains. Rows of the open level are added to it; they are dropped if the search does not
/// continue. Rows of a closed level are called late. Only the late rows of the least such level are stored, because the
/// search rolls back to that level and finds the other rows again. Returns true if rows were added to the open level.
bool DiskRowStore::take_missing(std::span<const Word> rows, bool going_on) {
    bool joined = false;
    for (std::size_t at = 0; at < rows.size(); at += width() + 1) {
        ++figures_.in_error;
        const StateView row = rows.subspan(at, width());
        const Level level = rows[at + width()];
        if (level >= levels()) {
            if (!going_on) continue;
            add_to_open(row, StateStore::hash(row));
            joined = true;
            continue;
        }
        if (level > late_level_) continue;
        if (level < late_level_) late_ = new_store();
        late_level_ = level;
        late_->insert(row);
    }
    return joined;
}

/// Settles the rows put aside. Returns true if rows were added to the open level. If `going_on` is false, the search
/// has ended, and only this work is done.
bool DiskRowStore::settle_aside(bool going_on) {
    if (aside_.empty()) return false;
    ++figures_.settled;
    figures_.put_aside += aside_.rows();
    bool joined = false;
    aside_.each_piece([&](std::vector<Word>& rows) {
        for (Level level = levels(); level-- > 0 && !rows.empty();) remove_those_in(level, going_on, rows);
        joined = take_missing(rows, going_on) || joined;
    });
    forget_aside();
    return joined;
}

std::optional<Level> DiskRowStore::settle_unsure_rows() {
    const bool joined = settle_aside(true);
    met_ = 0;
    new_ = 0;
    if (late_->size() > 0) return late_level_;
    return joined ? std::optional(levels()) : std::nullopt;
}

void DiskRowStore::forget_aside() {
    note_peak();
    aside_.clear();
}

/// Rolls back and fills the filter again. The old filter would reject rows of later levels as duplicates when the
/// search finds them again.
void DiskRowStore::roll_back_to(Level level) {
    assert(late_->size() == 0 || level <= late_level_);  // `level` is the least level of all ranks
    forget_aside();
    if (level == levels()) return;  // settling has added the missing rows to the open level
    ++figures_.rolled_back;
    empty_open();
    runs_.add([&](const storage::TakeRows& take) {
        kept_.files().each_block(level, [&](std::span<const Word> block) {
            kept_.poll();
            take(block);
        });
    });
    kept_.files().forget_from(level);
    fill_filter();
    for (StateIndex i = 0; i < late_->size() && late_level_ == level; ++i)
        add_to_open((*late_)[i], StateStore::hash((*late_)[i]));
    late_ = new_store();  // rows of later levels will be found again
    late_level_ = no_level;
}

/// Passes on all rows put aside and all missing rows of closed levels. A run that continues from the checkpoint treats
/// them as unsure.
void DiskRowStore::give_unsure(const storage::TakeRows& take) const {
    aside_.each_piece([&](const std::vector<Word>& rows) { take(rows); });
    std::vector<Word> rows;
    for (StateIndex i = 0; i < late_->size(); ++i) {
        rows.insert(rows.end(), (*late_)[i].begin(), (*late_)[i].end());
        rows.push_back(late_level_);
    }
    storage::sort_rows(rows, width() + 1);
    take(rows);
}

/// Writes a checkpoint. First removes the runs: the checkpoint does not contain the open level, to which they belong,
/// and their disk space may be needed. If there is no space for the rows put aside, they are settled first. If there is
/// still too little space, levels are dropped.
void DiskRowStore::checkpoint() {
    const auto unsure = [this](const storage::TakeRows& take) { give_unsure(take); };
    empty_open();
    try {
        kept_.checkpoint(record(), unsure);
    } catch (const storage::CannotWrite&) {
        if (aside_.on_disk()) settle_aside(false);
        kept_.checkpoint_of_fewer(record(), unsure);
        throw;
    }
}

std::uint64_t DiskRowStore::bytes() const {
    return filter_.bytes() + kept_.files().bytes() + runs_.bytes() + open_->bytes() + aside_.bytes() + late_->bytes();
}

}  // namespace robochart::refine
