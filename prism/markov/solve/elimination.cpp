// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/solve/elimination.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "prism/markov/solve/arithmetic.hpp"
#include "prism/markov/solve/residue.hpp"

namespace robochart::markov {
namespace {

template <class Value>
class Elimination {
public:
    /// Eliminates unknowns. The right sides are transformed together with the rows. With `keep_shares`, the data for
    /// later right sides are stored.
    Elimination(const System<Value>& system, const Policy& policy, std::vector<std::vector<Value>>& right_sides,
                bool keep_shares, const EliminationLimit& limit)
        : limit_(limit),
          keep_shares_(keep_shares),
          rows_(system.size()),
          incoming_(system.size()),
          incoming_count_(system.size(), 0),
          gone_(system.size(), false),
          place_(system.size(), nowhere),
          right_sides_(right_sides) {
        for (std::uint32_t unknown = 0; unknown < system.size(); ++unknown) read(system, unknown, policy[unknown]);
    }

    std::optional<Factors<Value>> run() {
        for (std::uint32_t unknown = 0; unknown < rows_.size(); ++unknown)
            queue_.emplace(elimination_cost(unknown), unknown);
        while (!queue_.empty()) {
            const auto [expected, unknown] = queue_.top();
            queue_.pop();
            if (gone_[unknown]) continue;
            if (const std::uint64_t now = elimination_cost(unknown); now > expected) {
                queue_.emplace(now, unknown);
                continue;
            }
            if (!remove(unknown)) return std::nullopt;
        }
        return Factors<Value>(std::move(rows_), std::move(order_), std::move(shares_));
    }

private:
    static constexpr std::uint32_t nowhere = 0xFFFFFFFF;

    using Entry = typename Factors<Value>::Entry;
    using Row = typename Factors<Value>::Row;

    void read(const System<Value>& system, std::uint32_t unknown, std::uint32_t choice) {
        Row& row = rows_[unknown];
        row.outside = system.outside[choice];
        for (std::uint64_t entry = system.first_entry[choice]; entry < system.first_entry[choice + 1]; ++entry)
            if (system.unknown[entry] != unknown)
                add(unknown, system.unknown[entry], system.numbers[system.number[entry]]);
        forget_places(row);
    }

    /// Adds an entry to the row whose positions are stored in `place_`.
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

    [[nodiscard]] std::uint64_t elimination_cost(std::uint32_t unknown) const {
        return (std::uint64_t{1} + rows_[unknown].entries.size()) * incoming_count_[unknown];
    }

    bool remove(std::uint32_t unknown) {
        Row& row = rows_[unknown];
        row.pivot = row.outside;
        for (const Entry& entry : row.entries) row.pivot += entry.factor;
        if (!positive(row.pivot)) return false;
        gone_[unknown] = true;
        order_.push_back(unknown);
        if (keep_shares_) shares_.emplace_back();
        for (const std::uint32_t from : incoming_[unknown])
            if (!gone_[from] && !replace(from, unknown)) return false;
        incoming_[unknown] = {};
        for (const Entry& entry : row.entries) --incoming_count_[entry.unknown];
        return true;
    }

    /// Replaces the eliminated unknown in the row of `from` by its own row.
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
        if (keep_shares_) shares_.back().push_back({from, share});
        for (std::vector<Value>& side : right_sides_) side[from] += share * side[eliminated];
        return true;
    }

    const EliminationLimit& limit_;
    const bool keep_shares_;
    std::vector<Row> rows_;
    std::vector<std::vector<std::uint32_t>> incoming_;  // by unknown: rows with an entry for it; some of these entries
                                                        // may have been removed
    std::vector<std::uint64_t> incoming_count_;         // number of entries that have not been removed
    std::vector<bool> gone_;
    std::vector<std::uint32_t> place_;  // by unknown: its index in the entries of one row
    std::vector<std::vector<Value>>& right_sides_;
    std::vector<std::uint32_t> order_;
    std::vector<std::vector<Entry>> shares_;
    using Cost = std::pair<std::uint64_t, std::uint32_t>;
    std::priority_queue<Cost, std::vector<Cost>, std::greater<>> queue_;
    std::uint64_t operations_ = 0;
    std::uint64_t entries_ = 0;
};

}  // namespace

template <class Value>
void Factors<Value>::solve(std::vector<Value>& side) const {
    for (std::size_t step = 0; step < order_.size(); ++step)
        for (const Entry& share : shares_[step]) side[share.unknown] += share.factor * side[order_[step]];
    substitute(side);
}

template <class Value>
void Factors<Value>::substitute(std::vector<Value>& side) const {
    for (auto unknown = order_.rbegin(); unknown != order_.rend(); ++unknown) {
        for (const Entry& entry : rows_[*unknown].entries) side[*unknown] += entry.factor * side[entry.unknown];
        side[*unknown] = side[*unknown] / rows_[*unknown].pivot;
    }
}

template <class Value>
std::uint64_t Factors<Value>::entries() const {
    std::uint64_t count = 0;
    for (const Row& row : rows_) count += row.entries.size();
    for (const std::vector<Entry>& shares : shares_) count += shares.size();
    return count;
}

template <class Value>
std::optional<Factors<Value>> factorize(const System<Value>& system, const Policy& policy,
                                        const EliminationLimit& limit) {
    std::vector<std::vector<Value>> none;
    return Elimination<Value>(system, policy, none, true, limit).run();
}

template <class Value>
std::optional<std::vector<std::vector<Value>>> eliminate(const System<Value>& system, const Policy& policy,
                                                         std::vector<std::vector<Value>> right_sides,
                                                         const EliminationLimit& limit) {
    const auto factors = Elimination<Value>(system, policy, right_sides, false, limit).run();
    if (!factors) return std::nullopt;
    for (std::vector<Value>& side : right_sides) {
        poll(limit.budget);
        factors->substitute(side);
    }
    return right_sides;
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

template class Factors<Residue<first_prime>>;
template class Factors<Residue<second_prime>>;
template class Factors<Residue<third_prime>>;
template std::optional<Factors<Residue<first_prime>>> factorize(const System<Residue<first_prime>>&, const Policy&,
                                                                const EliminationLimit&);
template std::optional<Factors<Residue<second_prime>>> factorize(const System<Residue<second_prime>>&, const Policy&,
                                                                 const EliminationLimit&);
template std::optional<Factors<Residue<third_prime>>> factorize(const System<Residue<third_prime>>&, const Policy&,
                                                                const EliminationLimit&);

}  // namespace robochart::markov
