#include "checker/storage/sorted_runs.hpp"

#include <unistd.h>

#include <algorithm>

namespace robochart::storage {
namespace {

/// Each that is merged has a block in memory.
constexpr std::size_t most_runs = 64;

}  // namespace

/// Reads a run row by row.
class SortedRuns::Reader {
public:
    Reader(const RowFile& file, const Run& run, std::size_t width)
        : file_(&file), next_(run.first), end_(run.end), width_(width) {
        read();
    }
    [[nodiscard]] const Word* row() const { return &rows_[at_]; }
    [[nodiscard]] bool at_end() const { return at_ == rows_.size(); }
    void advance() {
        at_ += width_;
        if (at_ == rows_.size() && next_ != end_) read();
    }
    [[nodiscard]] bool before(const Reader& other) const {
        const Word* const mine = row();
        const Word* const others = other.row();
        for (std::size_t i = 0; i < width_; ++i)
            if (mine[i] != others[i]) return mine[i] < others[i];
        return false;
    }

private:
    void read() {
        rows_.clear();
        at_ = 0;
        if (next_ != end_) file_->read(next_++, rows_);
    }
    const RowFile* file_;
    std::size_t next_;
    std::size_t end_;
    std::size_t width_;
    std::size_t at_ = 0;
    std::vector<Word> rows_;
};

void SortedRuns::add(std::span<const Word> rows) {
    add([rows](const TakeRows& take) { take(rows); });
}

void SortedRuns::add(const std::function<void(const TakeRows&)>& give) {
    if (runs_.size() >= most_runs) unite();
    if (!file_) {
        ::unlink(path_.c_str());  // of a run that was killed before the next lines
        file_.emplace(RowFile::create(path_, kind_));
        ::unlink(path_.c_str());
    }
    Run run{file_->blocks().size(), 0, 0};
    const std::uint64_t before = file_->rows();
    try {
        give([&](std::span<const Word> rows) { file_->append(static_cast<std::uint32_t>(runs_.size()), rows); });
    } catch (...) {
        file_->cut(run.first);
        throw;
    }
    run.end = file_->blocks().size();
    run.rows = file_->rows() - before;
    if (run.rows > 0) runs_.push_back(run);
}

/// All become one, so that those that are merged fit into memory.
void SortedRuns::unite() {
    SortedRuns one(path_, kind_);
    one.add([this](const TakeRows& take) { merge(take); });
    *this = std::move(one);
}

std::uint64_t SortedRuns::longest() const {
    std::uint64_t longest = 0;
    for (const Run& run : runs_) longest = std::max(longest, run.rows);
    return longest;
}

void SortedRuns::merge(const TakeRows& take) const {
    std::vector<Reader> readers;
    std::vector<Reader*> heap;  // the one at i comes before those at 2i+1 and 2i+2
    readers.reserve(runs_.size());
    for (const Run& run : runs_) heap.push_back(&readers.emplace_back(*file_, run, kind_.width));
    const auto sink = [&heap](std::size_t i) {
        for (;;) {
            std::size_t least = i;
            for (std::size_t child = 2 * i + 1; child <= 2 * i + 2 && child < heap.size(); ++child)
                if (heap[child]->before(*heap[least])) least = child;
            if (least == i) return;
            std::swap(heap[i], heap[least]);
            i = least;
        }
    };
    for (std::size_t i = heap.size() / 2; i-- > 0;) sink(i);
    const std::size_t width = kind_.width;
    const std::size_t full = RowFile::rows_of_block * width;
    std::vector<Word> rows;
    std::vector<Word> last;
    rows.reserve(full);
    while (!heap.empty()) {
        Reader& first = *heap.front();
        if (last.empty() || !std::equal(last.begin(), last.end(), first.row())) {
            if (rows.size() == full) {
                take(rows);
                rows.clear();
            }
            last.assign(first.row(), first.row() + width);
            rows.insert(rows.end(), last.begin(), last.end());
        }
        first.advance();
        if (first.at_end()) {
            heap.front() = heap.back();
            heap.pop_back();
        }
        if (!heap.empty()) sink(0);
    }
    if (!rows.empty()) take(rows);
}

void SortedRuns::clear() {
    runs_.clear();
    file_.reset();
}

std::uint64_t SortedRuns::bytes() const {
    if (!file_) return 0;
    return file_->blocks().capacity() * (sizeof(RowFile::Block) + sizeof(RowFile::Check));
}

}  // namespace robochart::storage
