#include "checker/refine/levels/disk_row_store.hpp"

#include <algorithm>
#include <bit>

#include "checker/refine/levels/hashed_rows.hpp"
#include "checker/storage/sort_rows.hpp"

namespace robochart::refine {

using lts::StateIndex;
using lts::StateStore;
using lts::StateView;
using lts::Word;

namespace {

// Of the memory, in sixteenths: the filter, the open level, what is put aside.
constexpr std::uint64_t filter_part = 10, open_part = 3, aside_part = 3;

/// How many rows of this width a store in so many bytes has: each with its place in a table, 64 bytes for twelve, that
/// is two thirds full. Rows lie in chunks, each as large as those before together: one that would be used by less than
/// half is not begun. A few in any case, and no more than have numbers.
std::uint64_t rows_in(std::uint64_t bytes, std::size_t width) {
    constexpr std::uint64_t fewest = 64, most = std::uint64_t{1} << 31U, place = 8, first_chunk = 1024;
    const std::uint64_t rows = std::min(bytes / (width * sizeof(Word) + place), most);
    const std::uint64_t last_chunk = std::bit_floor(rows + first_chunk);
    const std::uint64_t before = last_chunk - first_chunk;
    return std::max(fewest, before > 0 && rows - before < last_chunk / 2 ? before : rows);
}

std::uint64_t bytes_of(const StateStore& store) {
    const std::uint64_t places = (store.size() + store.space()) * 5 / 4;
    return store.size() * store.width() * sizeof(Word) + places * 64 / 12;
}

std::vector<Word> sorted_rows(const StateStore& store, StateIndex first, StateIndex end) {
    std::vector<Word> rows;
    rows.reserve((end - first) * store.width());
    for (StateIndex i = first; i < end; ++i) rows.insert(rows.end(), store[i].begin(), store[i].end());
    storage::sort_rows(rows, store.width());
    return rows;
}

std::string path_of_runs(const KeptWhere& where) {
    return where.folder + "/runs-" + std::to_string(where.place.rank) + "-of-" + std::to_string(where.place.ranks);
}

}  // namespace

DiskRowStore::DiskRowStore(KeptWhere where, Bounds bounds)
    : RowStore(where.kind.width),
      kept_(where),
      bounds_(std::move(bounds)),
      filter_(bounds_.filter_bits, bounds_.most_bytes / 16 * filter_part),
      most_open_(rows_in(bounds_.most_bytes / 16 * open_part, width())),
      most_aside_(rows_in(bounds_.most_bytes / 16 * aside_part, width())),
      open_(new_store()),
      runs_(path_of_runs(where), where.kind),
      aside_(new_store()) {
    // Rows put aside of one level follow each other.
    for (const auto& [level, row] : kept_.load(record())) {
        if (aside_levels_.empty() || aside_levels_.back().first != level)
            aside_levels_.emplace_back(level, static_cast<StateIndex>(aside_->size()));
        aside_->insert(row);
    }
    if (levels() > 0) fill_filter();
}

DiskRowStore::~DiskRowStore() {
    if (bounds_.report) bounds_.report(figures_);
}

/// Of the open level at least so many: a row that was met again after it had been written is in several runs.
std::uint64_t DiskRowStore::rows(Level level) const {
    return level < levels() ? kept_.files().rows(level) : std::max<std::uint64_t>(open_->size(), runs_.longest());
}

RowStore::Found DiskRowStore::enter(StateView row, std::uint64_t hash) {
    ++met_;
    if (open_->find(row, hash) != lts::no_state) return Found::again;
    if (levels() > 0 && filter_.may_have(hash)) {
        put_aside(row, hash);
        return Found::unsure;
    }
    ++new_;
    add_to_open(row, hash);
    return Found::fresh;
}

void DiskRowStore::add_to_open(StateView row, std::uint64_t hash) {
    if (open_->size() >= most_open_) write_open();
    open_->insert(row, hash);
}

std::uint64_t DiskRowStore::rows_sorted_at_once() const {
    return std::max<std::uint64_t>(most_open_ / 4, 64);
}

/// Piece by piece, because what is sorted exists three times.
void DiskRowStore::write_open() {
    note_peak();
    const auto piece = static_cast<StateIndex>(rows_sorted_at_once());
    const auto end = static_cast<StateIndex>(open_->size());
    for (StateIndex first = 0; first < end; first += piece)
        runs_.add(sorted_rows(*open_, first, std::min(end, first + piece)));
    ++figures_.runs_written;
    open_ = new_store();
}

void DiskRowStore::empty_open() {
    open_ = new_store();
    runs_.clear();
}

/// It belongs to the level in which it was first put aside.
void DiskRowStore::put_aside(StateView row, std::uint64_t hash) {
    if (aside_->size() >= most_aside_ && aside_->find(row, hash) == lts::no_state) settle_aside();
    const auto [index, fresh] = aside_->insert(row, hash);
    if (fresh && (aside_levels_.empty() || aside_levels_.back().first != levels()))
        aside_levels_.emplace_back(levels(), index);
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

/// What finds no space comes in when the filter is filled anew.
void DiskRowStore::add_to_filter(std::span<const Word> rows) {
    each_hashed(
        rows, width(), [this](std::uint64_t hash) { filter_.prefetch(hash); },
        [this](StateView, std::uint64_t hash) {
            if (filter_.size() < filter_.capacity()) filter_.add(hash);
        });
}

/// It has the rows put aside as well, which a filter of another size might not have: what was unsure once stays so
/// until it is settled.
void DiskRowStore::fill_filter() {
    filter_.reset(kept_.files().rows() + aside_->size());
    if (filter_.capacity() == 0) return;
    for (Level level = 0; level < levels(); ++level)
        kept_.files().each_block(level, [this](std::span<const Word> block) {
            kept_.poll();
            add_to_filter(block);
        });
    for (StateIndex i = 0; i < aside_->size(); ++i) filter_.add(StateStore::hash((*aside_)[i]));
}

/// The more has been done since the last settling, the more is lost if a row has been taken for an old one meanwhile.
/// The least is lost in all if that, times its probability, is as much as a settling takes (Young, CACM 17(9), 1974).
bool DiskRowStore::wants_to_settle() const {
    if (!late_.empty()) return true;
    if (aside_->size() == 0) return false;
    const auto settling = static_cast<double>(kept_.files().rows());
    const double lost = static_cast<double>(met_) * bounds_.reads_a_step + 2 * settling;  // the filter is filled anew
    const double in_error = filter_.capacity() == 0 ? 1.0 : std::min(1.0, static_cast<double>(new_) * filter_.error());
    return bounds_.reads_a_step > 0 && in_error * lost >= settling;
}

Level DiskRowStore::level_of_aside(StateIndex index) const {
    const auto after = std::upper_bound(aside_levels_.begin(), aside_levels_.end(), index,
                                        [](StateIndex wanted, const auto& each) { return wanted < each.second; });
    return std::prev(after)->first;
}

/// Marks the rows put aside that their own level has, or one before it. Gives how many.
std::size_t DiskRowStore::mark_those_in(Level level, std::vector<bool>& found) {
    std::size_t more = 0;
    const auto mark = [&](StateView row, std::uint64_t hash) {
        const StateIndex index = aside_->find(row, hash);
        if (index == lts::no_state || found[index] || level > level_of_aside(index)) return;
        found[index] = true;
        ++more;
    };
    kept_.files().each_block(level, [&](std::span<const Word> block) {
        kept_.poll();
        each_hashed(
            block, width(), [this](std::uint64_t hash) { aside_->prefetch(hash); }, mark);
    });
    return more;
}

/// Whether some rows have joined the open level.
bool DiskRowStore::settle_aside() {
    met_ = 0;
    new_ = 0;
    if (aside_->size() == 0) return false;
    ++figures_.settled;
    std::vector<bool> found(aside_->size(), false);
    std::size_t open = aside_->size();
    for (Level level = levels(); level-- > 0 && open > 0;) open -= mark_those_in(level, found);
    bool joined = false;
    for (StateIndex i = 0; i < aside_->size() && open > 0; ++i) {
        if (found[i]) continue;
        ++figures_.in_error;
        const StateView row = (*aside_)[i];
        if (const Level level = level_of_aside(i); level < levels()) {
            late_.emplace_back(level, std::vector<Word>(row.begin(), row.end()));
        } else {
            add_to_open(row, StateStore::hash(row));
            joined = true;
        }
    }
    forget_aside();
    return joined;
}

std::optional<Level> DiskRowStore::settle() {
    const bool joined = settle_aside();
    if (!late_.empty()) return late_.front().first;
    return joined ? std::optional(levels()) : std::nullopt;
}

void DiskRowStore::forget_aside() {
    note_peak();
    aside_ = new_store();
    aside_levels_.clear();
}

/// The filter is filled anew: it would take the rows of later levels, when they are found again, for old ones.
void DiskRowStore::roll_back_to(Level level) {
    forget_aside();
    if (level == levels()) return;  // what was missing has joined it
    ++figures_.rolled_back;
    empty_open();
    runs_.add([&](const storage::TakeRows& take) { kept_.files().each_block(level, take); });
    kept_.files().forget_from(level);
    fill_filter();
    for (const auto& [own, row] : late_)
        if (own == level) add_to_open(row, StateStore::hash(row));
    late_.clear();  // the others are found again, in the levels that they belong to
}

/// Runs are of the open level, which is left out; what they take on the disk may be needed. Rows that closed levels
/// lack are unsure for another run.
void DiskRowStore::checkpoint() {
    empty_open();
    KeptLevels::Unsure unsure = late_;
    for (StateIndex i = 0; i < aside_->size(); ++i)
        unsure.emplace_back(level_of_aside(i), std::vector<Word>((*aside_)[i].begin(), (*aside_)[i].end()));
    kept_.checkpoint(record(), unsure);
}

std::uint64_t DiskRowStore::bytes() const {
    return filter_.bytes() + kept_.files().bytes() + runs_.bytes() + bytes_of(*open_) + bytes_of(*aside_);
}

}  // namespace robochart::refine
