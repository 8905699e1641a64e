// SPDX-License-Identifier: Apache-2.0
// See comparison.hpp.
#include "simulation/sweep/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/diagnostics/json_values.hpp"
#include "simulation/report/percent.hpp"

namespace robochart::simulation {

namespace {

using Fields = std::vector<std::string>;

/// Splits a line into fields (RFC 4180, without line breaks in fields).
Fields fields_of(std::string_view line) {
    Fields fields{""};
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
            fields.back() += line[++i];
        else if (line[i] == '"')
            quoted = !quoted;
        else if (line[i] == ',' && !quoted)
            fields.emplace_back();
        else if (line[i] != '\r')
            fields.back() += line[i];
    }
    return fields;
}

template <class Number>
std::optional<Number> parse_number(const std::string& text) {
    Number value{};
    const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (wrong != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// Reads the rows below a header line.
class TableReader {
public:
    explicit TableReader(const Scenario& scenario) : scenario_(scenario) {}

    std::optional<std::vector<TableRow>> read(std::string_view text, std::string& error) {
        std::vector<TableRow> rows;
        for (std::size_t line = 1; !text.empty(); ++line) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            const Fields fields = fields_of(text.substr(0, end));
            text.remove_prefix(std::min(end + 1, text.size()));
            if (line == 1) {
                error = read_heading(fields);
            } else if (fields.size() > 1 || !fields[0].empty()) {
                const auto row = row_of(fields);
                if (row)
                    rows.push_back(*row);
                else
                    error = fmt::format("line {} is not a row of this table", line);
            }
            if (!error.empty()) return std::nullopt;
        }
        if (rows.empty()) error = "it has no rows";
        return rows.empty() ? std::nullopt : std::optional(rows);
    }

private:
    /// Finds the columns. Returns an error message if one is missing, and otherwise "".
    std::string read_heading(const Fields& names) {
        const auto find = [&](const std::string& name) {
            return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
        };
        for (const Variation& variation : scenario_.variations) point_.push_back(find(name_of(variation)));
        trials_ = find("trials");
        successes_ = find("successes");
        claim_ = find("claim");
        const std::size_t none = names.size();
        for (std::size_t v = 0; v < point_.size(); ++v)
            if (point_[v] == none) return fmt::format("it has no column '{}'", name_of(scenario_.variations[v]));
        if (trials_ == none || successes_ == none) return "it has no columns 'trials' and 'successes'";
        return claim_ == none && scenario_.claims.size() > 1 ? "it has no column 'claim'" : "";
    }

    [[nodiscard]] std::optional<TableRow> row_of(const Fields& fields) const {
        const auto field = [&](std::size_t column) { return column < fields.size() ? fields[column] : ""; };
        TableRow row;
        for (const std::size_t column : point_) {
            const auto value = parse_number<double>(field(column));
            if (!value) return std::nullopt;
            row.point.push_back(*value);
        }
        const auto trials = parse_number<std::uint32_t>(field(trials_));
        const auto successes = parse_number<std::uint32_t>(field(successes_));
        if (!trials || !successes || *successes > *trials) return std::nullopt;
        row.sample = {*successes, *trials};
        row.claim = claim_of(field(claim_));
        return row;
    }

    /// Returns the index of the claim. If the text names none, returns the number of claims.
    [[nodiscard]] std::size_t claim_of(const std::string& text) const {
        const auto count = parse_number<std::size_t>(text);
        if (count && *count > 0) return *count - 1;
        if (text.empty() && scenario_.claims.size() == 1) return 0;
        const auto same = [&](const Claim& claim) { return claim.text == text; };
        return static_cast<std::size_t>(std::ranges::find_if(scenario_.claims, same) - scenario_.claims.begin());
    }

    const Scenario& scenario_;
    std::vector<std::size_t> point_;  ///< columns
    std::size_t trials_ = 0, successes_ = 0, claim_ = 0;
};

bool same_point(const Point& one, const Point& other) {
    return std::ranges::equal(one, other, [](double a, double b) {
        return std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)});
    });
}

std::string sample_text(statistics::Sample sample) {
    return fmt::format("{} of {}", sample.successes, sample.trials);
}

}  // namespace

std::optional<std::vector<TableRow>> read_table(std::string_view text, const Scenario& scenario, std::string& error) {
    return TableReader(scenario).read(text, error);
}

std::vector<Compared> compare_tables(const Scenario& scenario, const SweepResult& result,
                                     const std::vector<TableRow>& table) {
    std::vector<Compared> all;
    for (std::size_t c = 0; c < scenario.claims.size(); ++c) {
        std::vector<Compared> some;
        std::vector<double> chances;
        for (const PointResult& point : result.points) {
            if (point.claims.empty() || point.claims[c].verdict != ClaimVerdict::estimated) continue;
            const statistics::Sample here{point.claims[c].successes, point.claims[c].trial_count()};
            for (const TableRow& row : table) {
                if (row.claim != c || !same_point(row.point, point.point)) continue;
                chances.push_back(statistics::fisher_exact(here, row.sample));
                some.push_back({point.point, c, here, row.sample, chances.back(), 1});
            }
        }
        const std::vector<double> adjusted = statistics::holm_correction(chances);
        for (std::size_t i = 0; i < some.size(); ++i) some[i].adjusted = adjusted[i];
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

bool is_rejected(const Scenario& scenario, const Compared& compared) {
    return compared.adjusted <= 1 - scenario.claims[compared.claim].confidence;
}

std::string comparison_text(const Scenario& scenario, const std::vector<Compared>& all) {
    std::string out;
    for (std::size_t c = 0; c < scenario.claims.size(); ++c) {
        out += fmt::format("{}{}, by Fisher's exact test\n  ",
                           scenario.claims.size() > 1 ? fmt::format("{}: ", c + 1) : "", scenario.claims[c].text);
        for (const Variation& variation : scenario.variations) out += fmt::format("{:<9} ", name_of(variation));
        out += fmt::format("{:<13} {:<13} {:<9} {}\n", "here", "in the table", "chance", "jointly");
        for (const Compared& compared : all) {
            if (compared.claim != c) continue;
            out += "  ";
            for (std::size_t v = 0; v < compared.point.size(); ++v)
                out += fmt::format("{:<9} ", value_text(scenario.variations[v], compared.point[v]));
            out += fmt::format("{:<13} {:<13} {:<9.3g} {:.3g}{}\n", sample_text(compared.here),
                               sample_text(compared.there), compared.chance, compared.adjusted,
                               is_rejected(scenario, compared) ? "  DIFFERS" : "");
        }
    }
    return out;
}

diagnostics::Json comparison_json(const Scenario& scenario, const std::vector<Compared>& all) {
    return diagnostics::json_array(all, [&](const Compared& compared) -> diagnostics::Json {
        return {{"values", values_json(scenario, compared.point)},
                {"claim", compared.claim + 1},
                {"here", {compared.here.successes, compared.here.trials}},
                {"there", {compared.there.successes, compared.there.trials}},
                {"chance", compared.chance},
                {"adjusted", compared.adjusted},
                {"differs", is_rejected(scenario, compared)}};
    });
}

std::string comparison_summary(const Scenario& scenario, const std::vector<Compared>& all) {
    const auto count =
        std::ranges::count_if(all, [&](const Compared& compared) { return is_rejected(scenario, compared); });
    return count == 0 ? fmt::format("none of {} estimates differs from the table", all.size())
                      : fmt::format("{} of {} estimates differ from the table", count, all.size());
}

}  // namespace robochart::simulation
