#include "checker/refine/levels/disk_row_store.hpp"

#include <algorithm>

#include "checker/storage/sort_rows.hpp"

namespace robochart::refine {

using lts::StateIndex;
using lts::StateStore;
using lts::StateView;
using lts::Word;

namespace {

constexpr std::uint64_t rows_of_segment = std::uint64_t{1} << 16U;
constexpr std::size_t most_segments = 64;
constexpr std::uint64_t between_looks = 4096;

/// A row, its place in the table, which has four for five numbers, twelve in a line of 64 bytes.
std::uint64_t bytes_of(const StateStore& store) {
    const std::uint64_t places = (store.size() + store.space()) * 5 / 4;
    return store.size() * store.width() * sizeof(Word) + places * 64 / 12;
}

std::vector<Word> sorted_rows(const StateStore& store) {
    std::vector<Word> rows;
    rows.reserve(store.size() * store.width());
    for (StateIndex i = 0; i < store.size(); ++i) rows.insert(rows.end(), store[i].begin(), store[i].end());
    storage::sort_rows(rows, store.width());
    return rows;
}

}  // namespace

DiskRowStore::DiskRowStore(KeptWhere where, Bounds bounds)
    : RowStore(where.kind.width),
      kept_(std::move(where)),
      bounds_(std::move(bounds)),
      filter_(bounds_.filter_bits),
      open_(new_store()),
      aside_(new_store()),
      in_error_(width()) {
    const KeptLevels::Unsure unsure = kept_.load(record());
    if (levels() == 0) return;
    // Rows put aside of one level follow each other.
    for (const auto& [level, row] : unsure) {
        if (aside_levels_.empty() || aside_levels_.back().first != level)
            aside_levels_.emplace_back(level, static_cast<StateIndex>(aside_->size()));
        aside_->insert(row);
    }
    fill_filter();
    fill_window(0);
    look_until_ = levels();
}

DiskRowStore::~DiskRowStore() {
    if (bounds_.report) bounds_.report(figures_);
}

RowStore::Found DiskRowStore::enter(StateView row, std::uint64_t hash) {
    if (open_->find(row, hash) != lts::no_state) return Found::again;
    const StateIndex in_error = in_error_.size() > 0 ? in_error_.find(row, hash) : lts::no_state;
    const bool known_new = in_error != lts::no_state && waiting_[in_error];
    if (!known_new && filter_.may_have(hash)) {
        if (in_window(row, hash)) return Found::earlier;
        if (window_begin() > 0 || aside_->size() > 0) return put_aside(row, hash);
    }
    if (known_new) waiting_[in_error] = false;
    open_->insert(row, hash);
    if (open_->size() % between_looks == 0) make_space();
    return Found::fresh;
}

bool DiskRowStore::in_window(StateView row, std::uint64_t hash) const {
    return std::any_of(window_.rbegin(), window_.rend(),
                       [&](const Segment& each) { return each.rows->find(row, hash) != lts::no_state; });
}

/// It belongs to the level in which it was first put aside.
RowStore::Found DiskRowStore::put_aside(StateView row, std::uint64_t hash) {
    const auto [index, fresh] = aside_->insert(row, hash);
    if (fresh && (aside_levels_.empty() || aside_levels_.back().first != levels()))
        aside_levels_.emplace_back(levels(), index);
    return Found::unsure;
}

void DiskRowStore::close_level() {
    const std::shared_ptr<void> held = kept_.hold();
    const Level level = levels();
    kept_.files().add_level(sorted_rows(*open_));
    if (filter_.size() + open_->size() > filter_.capacity()) {
        fill_filter();
    } else {
        for (StateIndex i = 0; i < open_->size(); ++i) filter_.add(StateStore::hash((*open_)[i]));
    }
    add_to_window(level, std::exchange(open_, new_store()));
    make_space();
}

/// A small level joins those before it. Small segments would take long to look through.
void DiskRowStore::add_to_window(Level level, Store rows) {
    const auto has_space = [&](const Segment& last) {
        return last.rows->size() + rows->size() <= rows_of_segment || window_.size() >= most_segments;
    };
    if (window_.empty() || !has_space(window_.back())) {
        window_.push_back({level, std::move(rows)});
        return;
    }
    StateStore& last = *window_.back().rows;
    for (StateIndex i = 0; i < rows->size(); ++i) last.insert((*rows)[i]);
}

void DiskRowStore::make_space() {
    const std::uint64_t now = bytes();
    figures_.peak_bytes = std::max(figures_.peak_bytes, now);
    std::uint64_t left = now;
    while (left > bounds_.most_bytes && !window_.empty()) {
        left -= std::min(left, bytes_of(*window_.front().rows));
        window_.pop_front();
    }
}

/// A fifth more than there are, so that it is seldom filled anew. It has the rows put aside as well, which a filter of
/// another size might not have: what was unsure once stays so until it is settled.
void DiskRowStore::fill_filter() {
    const std::uint64_t rows = kept_.files().rows() + aside_->size();
    filter_.reset(std::max<std::uint64_t>(rows + rows / 5, between_looks));
    for (Level level = 0; level < levels(); ++level)
        kept_.files().each_block(level, [this](std::span<const Word> block) {
            kept_.poll();
            for (std::size_t at = 0; at < block.size(); at += width())
                filter_.add(StateStore::hash(block.subspan(at, width())));
        });
    for (StateIndex i = 0; i < aside_->size(); ++i) filter_.add(StateStore::hash((*aside_)[i]));
}

/// The last levels, from this one on at most, in half of the memory.
void DiskRowStore::fill_window(Level from) {
    window_.clear();
    const std::uint64_t space = bounds_.most_bytes - std::min(bounds_.most_bytes, bytes());
    const std::uint64_t row_bytes = width() * sizeof(Word) + 10;
    Level begin = levels();
    for (std::uint64_t taken = 0; begin > from; --begin) {
        taken += kept_.files().rows(begin - 1) * row_bytes;
        if (taken > space / 2) break;
    }
    for (Level level = begin; level < levels(); ++level) {
        Store rows = new_store();
        kept_.files().each_block(level, [&](std::span<const Word> block) {
            kept_.poll();
            for (std::size_t at = 0; at < block.size(); at += width()) rows->insert(block.subspan(at, width()));
        });
        add_to_window(level, std::move(rows));
    }
}

bool DiskRowStore::wants_to_settle() const {
    const std::uint64_t aside = aside_->size();
    return aside >= std::max(bounds_.fewest_unsure, size() / bounds_.unsure_part);
}

Level DiskRowStore::level_of_aside(StateIndex index) const {
    const auto after = std::upper_bound(aside_levels_.begin(), aside_levels_.end(), index,
                                        [](StateIndex wanted, const auto& each) { return wanted < each.second; });
    return std::prev(after)->first;
}

/// Marks the rows put aside that a level has. Gives how many.
std::size_t DiskRowStore::mark_those_in(Level level, std::vector<bool>& found) {
    std::size_t more = 0;
    kept_.files().each_block(level, [&](std::span<const Word> block) {
        kept_.poll();
        for (std::size_t at = 0; at < block.size(); at += width()) {
            const StateIndex index = aside_->find(block.subspan(at, width()));
            if (index == lts::no_state || found[index] || level >= level_of_aside(index)) continue;
            found[index] = true;
            ++more;
        }
    });
    return more;
}

/// A row that was put aside is in no level that was in memory then, nor in one that came later, so only those are
/// looked through that are not in memory now; in a run that goes on from another, once, all.
std::optional<Level> DiskRowStore::settle() {
    if (aside_->size() == 0) return late_.empty() ? std::nullopt : std::optional(late_.front().first);
    ++figures_.settled;
    std::vector<bool> found(aside_->size(), false);
    std::size_t open = aside_->size();
    for (Level level = std::max(window_begin(), look_until_); level-- > 0 && open > 0;)
        open -= mark_those_in(level, found);
    late_.clear();
    for (auto& [level, row] : unsure()) {
        if (found[aside_->find(row)]) continue;
        const auto [index, fresh] = in_error_.insert(row);
        waiting_.resize(in_error_.size());
        waiting_[index] = true;
        late_.emplace_back(level, std::move(row));
        ++figures_.in_error;
    }
    forget_aside();
    return late_.empty() ? std::nullopt : std::optional(late_.front().first);
}

void DiskRowStore::forget_aside() {
    aside_ = new_store();
    aside_levels_.clear();
    look_until_ = 0;
}

KeptLevels::Unsure DiskRowStore::unsure() const {
    KeptLevels::Unsure rows;
    for (StateIndex i = 0; i < aside_->size(); ++i)
        rows.emplace_back(level_of_aside(i), std::vector<Word>((*aside_)[i].begin(), (*aside_)[i].end()));
    return rows;
}

/// The filter is filled anew: it would take the rows of later levels, when they are found again, for old ones.
void DiskRowStore::roll_back_to(Level level) {
    ++figures_.rolled_back;
    forget_aside();
    if (level < levels()) {
        const Level begin = window_begin();
        window_.clear();
        open_ = new_store();
        kept_.files().each_block(level, [this](std::span<const Word> block) {
            for (std::size_t at = 0; at < block.size(); at += width()) open_->insert(block.subspan(at, width()));
        });
        kept_.files().forget_from(level);
        fill_filter();
        fill_window(std::min(begin, level));
    }
    for (const auto& [own, row] : late_) {
        if (own != level) continue;
        waiting_[in_error_.find(row)] = false;
        open_->insert(row);
    }
    late_.clear();
}

/// What was found missing is still unsure for another run until the search has gone back.
void DiskRowStore::checkpoint() {
    const std::shared_ptr<void> held = kept_.hold();
    KeptLevels::Unsure rows = unsure();
    rows.insert(rows.end(), late_.begin(), late_.end());
    kept_.checkpoint(record(), rows);
}

std::uint64_t DiskRowStore::bytes() const {
    std::uint64_t bytes = filter_.bytes() + kept_.files().bytes() + bytes_of(*open_) + bytes_of(*aside_);
    for (const Segment& each : window_) bytes += bytes_of(*each.rows);
    return bytes;
}

}  // namespace robochart::refine
