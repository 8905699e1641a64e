// SPDX-License-Identifier: Apache-2.0
#include "csp_emit/swarm/read_swarm.hpp"

#include <fmt/format.h>

#include <charconv>
#include <functional>
#include <utility>

#include "csp_emit/swarm/rules.hpp"

namespace robochart::csp_emit {
namespace {

using diagnostics::Span;

constexpr std::uint32_t most_robots = 8;
constexpr std::uint32_t most_cells = 64;  // limit on cells in each direction
constexpr int deepest_condition = 50;
constexpr std::size_t most_conditions = 1'000;  // limit for all claims together

class SwarmReader : public frontend::WordReader {
public:
    SwarmReader(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                diagnostics::Diagnostics& diagnostics, const SwarmSize& size)
        : WordReader(sources, source, swarm_rules::syntax, diagnostics), size_(size) {}

    Swarm read_swarm_file() {
        expect_word("swarm");
        swarm_.name = name("the name of the swarm");
        expect_word("for");
        swarm_.component = qualified_name("the component of each robot");
        expect_word("{");
        while (!has_failed() && !at_word("}")) read_item();
        expect_word("}");
        if (!has_failed() && !at_end()) fail_expecting("the end of the file");
        if (size_.robots > 0) swarm_.robots = size_.robots;
        if (size_.grid) swarm_.grid = size_.grid;
        if (!has_failed()) check_places();
        return std::move(swarm_);
    }

private:
    void read_item() {
        using Read = void (SwarmReader::*)();
        static const std::vector<std::pair<const char*, Read>> items{
            {"robots", &SwarmReader::read_robots},      {"grid", &SwarmReader::read_grid},
            {"headings", &SwarmReader::read_headings},  {"place", &SwarmReader::read_place},
            {"drive", &SwarmReader::read_drive},        {"feed", &SwarmReader::read_feed},
            {"connect", &SwarmReader::read_connection}, {"const", &SwarmReader::read_constant},
            {"range", &SwarmReader::read_range},        {"accept", &SwarmReader::read_claim}};
        for (const auto& [word, read] : items)
            if (take_word(word)) return (this->*read)();
        fail_expecting(
            "'robots', 'grid', 'headings', 'place', 'drive', 'feed', 'connect', 'const', 'range', 'accept' or '}'");
    }

    std::uint32_t read_whole(std::uint32_t least, std::uint32_t most) {
        const frontend::Token next = current_token();
        std::uint32_t value = 0;
        const char* const end = next.text.data() + next.text.size();
        const auto [rest, code] = std::from_chars(next.text.data(), end, value);
        const bool number = next.kind == frontend::TokenKind::integer && code == std::errc() && rest == end;
        if (!number || value < least || value > most) {
            fail_expecting(fmt::format("a number from {} to {}", least, most));
            return least;
        }
        advance_token();
        return value;
    }
    std::int64_t signed_whole() {
        constexpr std::uint32_t most = 1'000'000;
        const bool negative = take_word("-");
        const auto value = static_cast<std::int64_t>(read_whole(0, most));
        return negative ? -value : value;
    }

    void read_robots() { swarm_.robots = read_whole(1, most_robots); }
    void read_grid() {
        SwarmGrid grid;
        grid.width = read_whole(2, most_cells);
        expect_word("by");
        grid.height = read_whole(2, most_cells);
        swarm_.grid = grid;
    }
    void read_headings() {
        const Span place = current_token().span;
        swarm_.headings = read_whole(4, 8);
        if (!has_failed() && swarm_.headings != 4 && swarm_.headings != 8)
            report(swarm_rules::no_fit, place, {"cells have 4 or 8 neighbours"});
    }
    void read_place() {
        SwarmPlace place;
        expect_word("at");
        expect_word("(");
        place.x = signed_whole();
        expect_word(",");
        place.y = signed_whole();
        expect_word(")");
        expect_word("heading");
        if (!take_word("any")) {
            place.degrees = signed_whole();
            expect_word("deg");
        }
        swarm_.places.push_back(place);
    }
    void read_drive() {
        SwarmDrive drive;
        expect_word("by");
        if (take_word("forward")) {
            drive.motion = SwarmMotion::forward;
        } else if (take_word("turn")) {
            drive.motion = SwarmMotion::turn;
            expect_word("(");
            expect_word("deg");
            expect_word(")");
        } else if (!take_word("stop")) {
            fail_expecting("'forward', 'turn(deg)' or 'stop'");
        }
        expect_word("on");
        drive.operation = name("an operation of the component");
        swarm_.drives.push_back(std::move(drive));
    }
    std::uint32_t read_distance(std::uint32_t least) {
        expect_word("(");
        const std::uint32_t cells = read_whole(least, most_cells);
        expect_word(")");
        return cells;
    }
    void read_feed() {
        SwarmFeed feed;
        feed.event = name("an event of the component");
        expect_word("with");
        if (at_word("count") || at_word("near")) {
            feed.reading = at_word("count") ? SwarmReading::count : SwarmReading::near;
            advance_token();
            feed.distance = read_distance(0);
        } else if (take_word("turned")) {
            feed.reading = SwarmReading::turned;
        } else if (!take_word("any")) {
            fail_expecting("'count(CELLS)', 'near(CELLS)', 'turned' or 'any'");
        }
        if (take_word("on")) feed.on = name("an operation of the component");
        swarm_.feeds.push_back(std::move(feed));
    }
    void read_connection() {
        SwarmConnection connection;
        connection.from = name("an event that a robot sends");
        expect_word("to");
        connection.to = name("an event that others receive");
        if (take_word("within")) connection.distance = read_whole(1, most_cells);
        swarm_.connections.push_back(std::move(connection));
    }
    void read_constant() {
        SwarmConstant constant;
        constant.name = qualified_name("a constant of the component");
        expect_word("=");
        if (!take_word("robot")) constant.value = fmt::format("{}", signed_whole());
        swarm_.constants.push_back(std::move(constant));
    }
    void read_range() {
        SwarmRange range;
        range.type = name("a type, as with --range");
        expect_word("=");
        range.low = signed_whole();
        expect_word("to");
        range.high = signed_whole();
        swarm_.ranges.push_back(std::move(range));
    }

    void read_claim() {
        SwarmClaim claim;
        const Span from = current_token().span;
        if (take_word("deadlock")) {
            claim.question = SwarmQuestion::deadlock_free;
            expect_word("free");
        } else {
            if (take_word("always"))
                claim.question = SwarmQuestion::always;
            else if (take_word("possible"))
                claim.question = SwarmQuestion::possible;
            else if (take_word("recurrent"))
                claim.question = SwarmQuestion::recurrent;
            else
                fail_expecting("'deadlock free', 'always', 'possible' or 'recurrent'");
            claim.condition = parse_or(0);
        }
        if (has_failed()) return;
        claim.span = diagnostics::join_spans(from, last_span());
        claim.text = text_since(from);
        swarm_.claims.push_back(std::move(claim));
    }
    SwarmCondition parse_or(int depth) {
        return parse_chain(SwarmCondition::Kind::either, "or", &SwarmReader::parse_and, depth);
    }
    SwarmCondition parse_and(int depth) {
        return parse_chain(SwarmCondition::Kind::both, "and", &SwarmReader::parse_single, depth);
    }
    /// Parses operands of the same operator as parts of one condition, so that a long chain does not become a deep
    /// tree.
    SwarmCondition parse_chain(SwarmCondition::Kind kind, const char* word, SwarmCondition (SwarmReader::*part)(int),
                               int depth) {
        SwarmCondition first = (this->*part)(depth);
        if (has_failed() || !at_word(word)) return first;
        SwarmCondition all{kind, 0, {}};
        all.parts.push_back(std::move(first));
        while (!has_failed() && take_word(word)) all.parts.push_back((this->*part)(depth));
        return all;
    }
    SwarmCondition parse_single(int depth) {
        using Kind = SwarmCondition::Kind;
        if (depth > deepest_condition) {
            fail_expecting("a condition of fewer parentheses");
            return {};
        }
        if (take_word("not")) {
            SwarmCondition negation{Kind::negation, 0, {}};
            negation.parts.push_back(parse_single(depth + 1));
            return negation;
        }
        if (take_word("(")) {
            SwarmCondition inside = parse_or(depth + 1);
            expect_word(")");
            return inside;
        }
        if (++conditions_ > most_conditions) {
            fail_expecting(fmt::format("at most {} conditions in a swarm", most_conditions));
            return {};
        }
        if (take_word("apart")) return {Kind::apart, 0, {}};
        if (take_word("linked")) return {Kind::linked, read_distance(0), {}};
        if (take_word("away")) return {Kind::away, read_distance(1), {}};
        fail_expecting("'linked(CELLS)', 'apart', 'away(CELLS)', 'not' or '('");
        return {};
    }

    void check_places() {
        const bool placed = swarm_.grid.has_value();
        for (const SwarmClaim& claim : swarm_.claims)
            if (!placed && claim.question != SwarmQuestion::deadlock_free)
                report(swarm_rules::no_fit, claim.span, {"only robots on a grid have positions"});
    }

    SwarmSize size_;
    Swarm swarm_;
    std::size_t conditions_ = 0;
};

}  // namespace

Swarm read_swarm(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                 diagnostics::Diagnostics& diagnostics, const SwarmSize& size) {
    return SwarmReader(sources, source, diagnostics, size).read_swarm_file();
}

}  // namespace robochart::csp_emit
