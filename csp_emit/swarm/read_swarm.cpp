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
constexpr std::uint32_t most_cells = 64;  // in each direction
constexpr int deepest_condition = 50;
constexpr std::size_t most_conditions = 1'000;  // limit for all claims together

class SwarmReader : public frontend::WordReader {
public:
    SwarmReader(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                diagnostics::Diagnostics& diagnostics, const SwarmSize& size)
        : WordReader(sources, source, swarm_rules::syntax, diagnostics), size_(size) {}

    Swarm read() {
        expect("swarm");
        swarm_.name = name("the name of the swarm");
        expect("for");
        swarm_.component = qualified_name("the component of each robot");
        expect("{");
        while (!failed() && !at("}")) item();
        expect("}");
        if (!failed() && !at_end()) fail("the end of the file");
        if (size_.robots > 0) swarm_.robots = size_.robots;
        if (size_.grid) swarm_.grid = size_.grid;
        if (!failed()) check();
        return std::move(swarm_);
    }

private:
    void item() {
        using Read = void (SwarmReader::*)();
        static const std::vector<std::pair<const char*, Read>> items{
            {"robots", &SwarmReader::robots},   {"grid", &SwarmReader::grid},      {"headings", &SwarmReader::headings},
            {"place", &SwarmReader::place},     {"drive", &SwarmReader::drive},    {"feed", &SwarmReader::feed},
            {"connect", &SwarmReader::connect}, {"const", &SwarmReader::constant}, {"range", &SwarmReader::range},
            {"accept", &SwarmReader::accept}};
        for (const auto& [word, read] : items)
            if (take(word)) return (this->*read)();
        fail("'robots', 'grid', 'headings', 'place', 'drive', 'feed', 'connect', 'const', 'range', 'accept' or '}'");
    }

    std::uint32_t whole(std::uint32_t least, std::uint32_t most) {
        const frontend::Token next = token();
        std::uint32_t value = 0;
        const char* const end = next.text.data() + next.text.size();
        const auto [rest, code] = std::from_chars(next.text.data(), end, value);
        const bool number = next.kind == frontend::TokenKind::integer && code == std::errc() && rest == end;
        if (!number || value < least || value > most) {
            fail(fmt::format("a number from {} to {}", least, most));
            return least;
        }
        advance();
        return value;
    }
    std::int64_t signed_whole() {
        constexpr std::uint32_t most = 1'000'000;
        const bool negative = take("-");
        const auto value = static_cast<std::int64_t>(whole(0, most));
        return negative ? -value : value;
    }

    void robots() { swarm_.robots = whole(1, most_robots); }
    void grid() {
        SwarmGrid grid;
        grid.width = whole(2, most_cells);
        expect("by");
        grid.height = whole(2, most_cells);
        swarm_.grid = grid;
    }
    void headings() {
        const Span place = token().span;
        swarm_.headings = whole(4, 8);
        if (!failed() && swarm_.headings != 4 && swarm_.headings != 8)
            report(swarm_rules::no_fit, place, {"cells have 4 or 8 neighbours"});
    }
    void place() {
        SwarmPlace place;
        expect("at");
        expect("(");
        place.x = signed_whole();
        expect(",");
        place.y = signed_whole();
        expect(")");
        expect("heading");
        if (!take("any")) {
            place.degrees = signed_whole();
            expect("deg");
        }
        swarm_.places.push_back(place);
    }
    void drive() {
        SwarmDrive drive;
        expect("by");
        if (take("forward")) {
            drive.motion = SwarmMotion::forward;
        } else if (take("turn")) {
            drive.motion = SwarmMotion::turn;
            expect("(");
            expect("deg");
            expect(")");
        } else if (!take("stop")) {
            fail("'forward', 'turn(deg)' or 'stop'");
        }
        expect("on");
        drive.operation = name("an operation of the component");
        swarm_.drives.push_back(std::move(drive));
    }
    std::uint32_t distance(std::uint32_t least) {
        expect("(");
        const std::uint32_t cells = whole(least, most_cells);
        expect(")");
        return cells;
    }
    void feed() {
        SwarmFeed feed;
        feed.event = name("an event of the component");
        expect("with");
        if (at("count") || at("near")) {
            feed.reading = at("count") ? SwarmReading::count : SwarmReading::near;
            advance();
            feed.distance = distance(0);
        } else if (take("turned")) {
            feed.reading = SwarmReading::turned;
        } else if (!take("any")) {
            fail("'count(CELLS)', 'near(CELLS)', 'turned' or 'any'");
        }
        if (take("on")) feed.on = name("an operation of the component");
        swarm_.feeds.push_back(std::move(feed));
    }
    void connect() {
        SwarmConnection connection;
        connection.from = name("an event that a robot sends");
        expect("to");
        connection.to = name("an event that others receive");
        if (take("within")) connection.distance = whole(1, most_cells);
        swarm_.connections.push_back(std::move(connection));
    }
    void constant() {
        SwarmConstant constant;
        constant.name = qualified_name("a constant of the component");
        expect("=");
        if (!take("robot")) constant.value = fmt::format("{}", signed_whole());
        swarm_.constants.push_back(std::move(constant));
    }
    void range() {
        SwarmRange range;
        range.type = name("a type, as with --range");
        expect("=");
        range.low = signed_whole();
        expect("to");
        range.high = signed_whole();
        swarm_.ranges.push_back(std::move(range));
    }

    void accept() {
        SwarmClaim claim;
        const Span from = token().span;
        if (take("deadlock")) {
            claim.question = SwarmQuestion::deadlock_free;
            expect("free");
        } else {
            if (take("always"))
                claim.question = SwarmQuestion::always;
            else if (take("possible"))
                claim.question = SwarmQuestion::possible;
            else if (take("recurrent"))
                claim.question = SwarmQuestion::recurrent;
            else
                fail("'deadlock free', 'always', 'possible' or 'recurrent'");
            claim.condition = either(0);
        }
        if (failed()) return;
        claim.span = diagnostics::join(from, last_span());
        claim.text = text_since(from);
        swarm_.claims.push_back(std::move(claim));
    }
    SwarmCondition either(int depth) { return chain(SwarmCondition::Kind::either, "or", &SwarmReader::both, depth); }
    SwarmCondition both(int depth) { return chain(SwarmCondition::Kind::both, "and", &SwarmReader::single, depth); }
    /// Operands of the same operator become parts of one condition, so a long chain does not make a deep tree.
    SwarmCondition chain(SwarmCondition::Kind kind, const char* word, SwarmCondition (SwarmReader::*part)(int),
                         int depth) {
        SwarmCondition first = (this->*part)(depth);
        if (failed() || !at(word)) return first;
        SwarmCondition all{kind, 0, {}};
        all.parts.push_back(std::move(first));
        while (!failed() && take(word)) all.parts.push_back((this->*part)(depth));
        return all;
    }
    SwarmCondition single(int depth) {
        using Kind = SwarmCondition::Kind;
        if (depth > deepest_condition) {
            fail("a condition of fewer parentheses");
            return {};
        }
        if (take("not")) {
            SwarmCondition negation{Kind::negation, 0, {}};
            negation.parts.push_back(single(depth + 1));
            return negation;
        }
        if (take("(")) {
            SwarmCondition inside = either(depth + 1);
            expect(")");
            return inside;
        }
        if (++conditions_ > most_conditions) {
            fail(fmt::format("at most {} conditions in a swarm", most_conditions));
            return {};
        }
        if (take("apart")) return {Kind::apart, 0, {}};
        if (take("linked")) return {Kind::linked, distance(0), {}};
        if (take("away")) return {Kind::away, distance(1), {}};
        fail("'linked(CELLS)', 'apart', 'away(CELLS)', 'not' or '('");
        return {};
    }

    void check() {
        const bool placed = swarm_.grid.has_value();
        for (const SwarmClaim& claim : swarm_.claims)
            if (!placed && claim.question != SwarmQuestion::deadlock_free)
                report(swarm_rules::no_fit, claim.span, {"where robots are is known on a grid alone"});
    }

    SwarmSize size_;
    Swarm swarm_;
    std::size_t conditions_ = 0;
};

}  // namespace

Swarm read_swarm(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                 diagnostics::Diagnostics& diagnostics, const SwarmSize& size) {
    return SwarmReader(sources, source, diagnostics, size).read();
}

}  // namespace robochart::csp_emit
