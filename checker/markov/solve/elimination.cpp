#include "checker/markov/solve/elimination.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "checker/markov/solve/arithmetic.hpp"

namespace robochart::markov {
namespace {

template <class Value>
class Elimination {
public:
    Elimination(const System<Value>& system, const Policy& policy, std::vector<std::vector<Value>> right_sides,
                const EliminationLimit& limit)
        : limit_(limit),
          rows_(system.size()),
          incoming_(system.size()),
          incoming_count_(system.size(), 0),
          gone_(system.size(), false),
          place_(system.size(), nowhere),
          right_sides_(std::move(right_sides)) {
        for (std::uint32_t unknown = 0; unknown < system.size(); ++unknown) read(system, unknown, policy[unknown]);
    }

    std::optional<std::vector<std::vector<Value>>> run() {
        for (std::uint32_t unknown = 0; unknown < rows_.size(); ++unknown) queue_.emplace(cost(unknown), unknown);
        while (!queue_.empty()) {
            const auto [expected, unknown] = queue_.top();
            queue_.pop();
            if (gone_[unknown]) continue;
            if (const std::uint64_t now = cost(unknown); now > expected) {
                queue_.emplace(now, unknown);
                continue;
            }
            if (!remove(unknown)) return std::nullopt;
        }
        substitute();
        return std::move(right_sides_);
    }

private:
    static constexpr std::uint32_t nowhere = 0xFFFFFFFF;

    struct Entry {
        std::uint32_t unknown;
        Value factor;
    };
    struct Row {
        std::vector<Entry> entries;  // of other unknowns
        Value outside{};
        Value pivot{};  // 1 - its own factor, once eliminated
    };

    void read(const System<Value>& system, std::uint32_t unknown, std::uint32_t choice) {
        Row& row = rows_[unknown];
        row.outside = system.outside[choice];
        for (std::uint64_t entry = system.first_entry[choice]; entry < system.first_entry[choice + 1]; ++entry)
            if (system.unknown[entry] != unknown)
                add(unknown, system.unknown[entry], system.numbers[system.number[entry]]);
        forget_places(row);
    }

    /// To the row whose places are known.
    void add(std::uint32_t unknown, std::uint32_t to, const Value& factor) {
        Row& row = rows_[unknown];
        if (place_[to] == nowhere) {
            place_[to] = static_cast<std::uint32_t>(row.entries.size());
            row.entries.push_back({to, factor});
            incoming_[to].push_back(unknown);
            ++incoming_count_[to];
            ++entries_;
        } else {
            row.entries[place_[to]].factor += factor;
        }
    }

    void remember_places(const Row& row) {
        for (std::uint32_t at = 0; at < row.entries.size(); ++at) place_[row.entries[at].unknown] = at;
    }

    void forget_places(const Row& row) {
        for (const Entry& entry : row.entries) place_[entry.unknown] = nowhere;
    }

    [[nodiscard]] std::uint64_t cost(std::uint32_t unknown) const {
        return (std::uint64_t{1} + rows_[unknown].entries.size()) * incoming_count_[unknown];
    }

    bool remove(std::uint32_t unknown) {
        Row& row = rows_[unknown];
        row.pivot = row.outside;
        for (const Entry& entry : row.entries) row.pivot += entry.factor;
        if (!positive(row.pivot)) return false;
        gone_[unknown] = true;
        order_.push_back(unknown);
        for (const std::uint32_t from : incoming_[unknown])
            if (!gone_[from] && !replace(from, unknown)) return false;
        incoming_[unknown] = {};
        for (const Entry& entry : row.entries) --incoming_count_[entry.unknown];
        return true;
    }

    /// In the row of `from`, the eliminated unknown by its own row.
    bool replace(std::uint32_t from, std::uint32_t eliminated) {
        Row& row = rows_[from];
        const Row& by = rows_[eliminated];
        operations_ += row.entries.size() + by.entries.size();
        if (operations_ > limit_.operations || entries_ > limit_.entries) return false;
        poll(limit_.budget);
        const auto at = std::ranges::find(row.entries, eliminated, &Entry::unknown);
        const Value share = at->factor / by.pivot;
        *at = std::move(row.entries.back());
        row.entries.pop_back();
        --entries_;
        remember_places(row);
        for (const Entry& entry : by.entries)
            if (entry.unknown != from) add(from, entry.unknown, share * entry.factor);
        forget_places(row);
        row.outside += share * by.outside;
        for (std::vector<Value>& side : right_sides_) side[from] += share * side[eliminated];
        return true;
    }

    void substitute() {
        for (auto unknown = order_.rbegin(); unknown != order_.rend(); ++unknown) {
            poll(limit_.budget);
            for (std::vector<Value>& side : right_sides_) {
                for (const Entry& entry : rows_[*unknown].entries) side[*unknown] += entry.factor * side[entry.unknown];
                side[*unknown] = side[*unknown] / rows_[*unknown].pivot;
            }
        }
    }

    const EliminationLimit& limit_;
    std::vector<Row> rows_;
    std::vector<std::vector<std::uint32_t>> incoming_;  // unknowns with an entry of this one, some of them gone
    std::vector<std::uint64_t> incoming_count_;         // those not gone
    std::vector<bool> gone_;
    std::vector<std::uint32_t> place_;  // of each unknown in the entries of one row
    std::vector<std::vector<Value>> right_sides_;
    std::vector<std::uint32_t> order_;
    using Cost = std::pair<std::uint64_t, std::uint32_t>;
    std::priority_queue<Cost, std::vector<Cost>, std::greater<>> queue_;
    std::uint64_t operations_ = 0;
    std::uint64_t entries_ = 0;
};

}  // namespace

template <class Value>
std::optional<std::vector<std::vector<Value>>> eliminate(const System<Value>& system, const Policy& policy,
                                                         std::vector<std::vector<Value>> right_sides,
                                                         const EliminationLimit& limit) {
    return Elimination<Value>(system, policy, std::move(right_sides), limit).run();
}

template std::optional<std::vector<std::vector<double>>> eliminate(const System<double>&, const Policy&,
                                                                   std::vector<std::vector<double>>,
                                                                   const EliminationLimit&);
template std::optional<std::vector<std::vector<Interval>>> eliminate(const System<Interval>&, const Policy&,
                                                                     std::vector<std::vector<Interval>>,
                                                                     const EliminationLimit&);
template std::optional<std::vector<std::vector<Rational>>> eliminate(const System<Rational>&, const Policy&,
                                                                     std::vector<std::vector<Rational>>,
                                                                     const EliminationLimit&);

}  // namespace robochart::markov
