// SPDX-License-Identifier: Apache-2.0
#include "checker/storage/sorted_runs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>

#include "base/diagnostics/escape.hpp"

namespace robochart::storage {
namespace {

/// The maximal number of runs that are merged at once. Each of these runs needs a block in memory.
constexpr std::size_t most_runs = 64;

}  // namespace

/// Reads a run row by row. Keeps the code of a block and a few rows in memory.
class SortedRuns::Reader {
public:
    Reader(const RowFile& file, const Run& run, std::size_t width)
        : file_(&file), next_(run.first), end_(run.end), width_(width), decoder_({}, width) {
        read();
    }
    [[nodiscard]] const Word* row() const {
        assert(at_ + width_ <= rows_.size());
        return &rows_[at_];
    }
    [[nodiscard]] bool at_end() const { return at_ == rows_.size(); }
    void advance() {
        at_ += width_;
        if (at_ == rows_.size()) read();
    }
    [[nodiscard]] bool is_before(const Reader& other) const {
        return std::lexicographical_compare(row(), row() + width_, other.row(), other.row() + width_);
    }

private:
    void read() {
        constexpr std::size_t most = 128;
        rows_.clear();
        at_ = 0;
        if (left_ == 0) {
            if (next_ == end_) return;
            assert(next_ < end_);
            left_ = file_->blocks()[next_].rows;
            file_->read_code(next_++, code_);
            decoder_ = RowDecoder(code_, width_);
        }
        const std::size_t count = std::min(left_, most);
        if (!decoder_.decode(count, rows_))
            throw BadFile(
                fmt::format("{}: block {} has no rows", diagnostics::escape_for_display(file_->path()), next_ - 1));
        left_ -= count;
    }
    const RowFile* file_;
    std::size_t next_;
    std::size_t end_;
    std::size_t width_;
    std::string code_;
    RowDecoder decoder_;
    std::size_t left_ = 0;  ///< remaining rows of the current block
    std::size_t at_ = 0;
    std::vector<Word> rows_;
};

void SortedRuns::add(std::span<const Word> rows) {
    add([rows](const TakeRows& take) { take(rows); });
}

void SortedRuns::add(const std::function<void(const TakeRows&)>& give) {
    if (runs_.size() >= most_runs) merge_into_one();
    if (!file_) {
        ::unlink(path_.c_str());  // an earlier program may have been killed before it removed this name
        file_.emplace(RowFile::create(path_, kind_));
        ::unlink(path_.c_str());
    }
    Run run{file_->blocks().size(), 0, 0};
    const std::uint64_t before = file_->rows();
    try {
        give([&](std::span<const Word> rows) { file_->append(static_cast<std::uint32_t>(runs_.size()), rows); });
    } catch (...) {
        file_->remove_blocks_from(run.first);
        throw;
    }
    run.end = file_->blocks().size();
    run.rows = file_->rows() - before;
    assert(run.first <= run.end && (run.rows == 0) == (run.first == run.end));
    if (run.rows > 0) runs_.push_back(run);
}

/// Merges all runs into one, so that later merges fit into memory.
void SortedRuns::merge_into_one() {
    SortedRuns one(path_, kind_);
    one.add([this](const TakeRows& take) { merge(take); });
    *this = std::move(one);
}

std::uint64_t SortedRuns::longest_run() const {
    std::uint64_t longest = 0;
    for (const Run& run : runs_) longest = std::max(longest, run.rows);
    return longest;
}

std::uint64_t SortedRuns::rows() const {
    std::uint64_t sum = 0;
    for (const Run& run : runs_) sum += run.rows;
    return sum;
}

void SortedRuns::merge(const TakeRows& take) const {
    assert(runs_.empty() || file_.has_value());
    std::vector<Reader> readers;
    std::vector<Reader*> heap;  // a heap; the reader with the least row is first
    readers.reserve(runs_.size());
    for (const Run& run : runs_) heap.push_back(&readers.emplace_back(*file_, run, kind_.width));
    const auto later = [](const Reader* a, const Reader* b) { return b->is_before(*a); };
    std::make_heap(heap.begin(), heap.end(), later);
    const std::size_t width = kind_.width;
    const std::size_t full = RowFile::rows_of_block * width;
    std::vector<Word> rows;
    std::vector<Word> last;
    rows.reserve(full);
    while (!heap.empty()) {
        std::pop_heap(heap.begin(), heap.end(), later);
        Reader& first = *heap.back();
        if (last.empty() || !std::equal(last.begin(), last.end(), first.row())) {
            if (rows.size() == full) {
                take(rows);
                rows.clear();
            }
            // The rows are passed in ascending order: each run is ascending, and the reader with the least row is
            // always first.
            assert(last.empty() ||
                   std::lexicographical_compare(last.begin(), last.end(), first.row(), first.row() + width));
            last.assign(first.row(), first.row() + width);
            rows.insert(rows.end(), last.begin(), last.end());
        }
        first.advance();
        if (first.at_end())
            heap.pop_back();
        else
            std::push_heap(heap.begin(), heap.end(), later);
    }
    if (!rows.empty()) take(rows);
}

void SortedRuns::clear() {
    runs_.clear();
    file_.reset();
}

std::uint64_t SortedRuns::bytes() const {
    return file_ ? file_->bytes() : 0;
}

}  // namespace robochart::storage
