#include "app/story.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace robochart::app {
namespace {

/// Splits at `separator` outside brackets and quotes.
std::vector<std::string> split(std::string_view text, std::string_view separator) {
    std::vector<std::string> parts;
    int depth = 0;
    std::size_t start = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '(' || c == '{' || c == '<') ++depth;
        if (c == ')' || c == '}' || c == '>') --depth;
        if (depth == 0 && text.substr(i, separator.size()) == separator) {
            parts.emplace_back(text.substr(start, i - start));
            i += separator.size() - 1;
            start = i + 1;
        }
    }
    parts.emplace_back(text.substr(start));
    return parts;
}

std::string_view trim(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

/// `number` in units of 1/scale as a decimal: -1088 at scale 100 is "-10.88".
std::string decimal(std::int64_t number, std::int64_t scale) {
    if (number % scale == 0) return fmt::format("{}", number / scale);
    const std::uint64_t magnitude = number < 0 ? 0U - static_cast<std::uint64_t>(number) : static_cast<std::uint64_t>(number);
    const auto unit = static_cast<std::uint64_t>(scale);
    std::string digits = fmt::format("{:0{}}", magnitude % unit, fmt::formatted_size("{}", unit) - 1);
    while (digits.back() == '0') digits.pop_back();
    return fmt::format("{}{}.{}", number < 0 ? "-" : "", magnitude / unit, digits);
}

}  // namespace

StoryTeller::StoryTeller(const csp_emit::Provenance& provenance, const ir::System& system, const ir::Instantiation& instantiation,
                         const diagnostics::SourceManager& sources, const process::EventTable& events)
    : provenance_(provenance), system_(system), instantiation_(instantiation), sources_(sources), events_(events) {}

const csp_emit::EventMeaning* StoryTeller::meaning(const std::string& name, std::string& arguments) const {
    std::string prefix = name;
    while (true) {
        if (const auto found = provenance_.events.find(prefix); found != provenance_.events.end()) {
            arguments = name.substr(std::min(name.size(), prefix.size() + 1));
            return &found->second;
        }
        const auto dot = prefix.rfind('.');
        if (dot == std::string::npos) return nullptr;
        prefix.resize(dot);
    }
}

std::string StoryTeller::value(ir::TypeId type, const std::string& text) const {
    if (!type.valid()) return text;
    const ir::Type& t = system_.type(type);
    std::int64_t number = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = code == std::errc() && end == text.data() + text.size();
    if (t.kind == ir::TypeKind::real && whole) return decimal(number, instantiation_.scale);
    if (t.kind == ir::TypeKind::enumeration) return text.substr(text.rfind('_') + 1);
    return text;
}

std::string StoryTeller::arguments(const csp_emit::EventMeaning& event, const std::string& text) const {
    if (text.empty()) return "";
    const std::vector<std::string> parts = split(text, ".");
    std::vector<std::string> shown;
    for (std::size_t i = 0; i < parts.size(); ++i)
        shown.push_back(value(i < event.types.size() ? event.types[i] : ir::TypeId{}, parts[i]));
    const std::string joined = fmt::format("{}", fmt::join(shown, ", "));
    const bool stored = event.kind == csp_emit::MeaningKind::assignment || event.kind == csp_emit::MeaningKind::external_write;
    if (stored) return fmt::format(" = {}", joined);
    return event.kind == csp_emit::MeaningKind::call ? fmt::format("({})", joined) : fmt::format(" with {}", joined);
}

std::string StoryTeller::described(const std::string& name) const {
    std::string rest;
    const csp_emit::EventMeaning* found = meaning(name, rest);
    if (found == nullptr) return name;
    if (found->kind == csp_emit::MeaningKind::refusal) return found->text + " " + (rest == "tock" ? "the passing of time" : described(rest));
    return found->text + arguments(*found, rest);
}

std::string StoryTeller::event(process::Event event) const { return described(events_.name(event)); }

std::vector<StoryTeller::Place> StoryTeller::places(const std::string& description) const {
    std::vector<Place> result;
    for (const std::string& part : split(description, "‖")) {
        const std::string_view call = trim(part);
        const auto bracket = call.find('(');
        const std::string name(call.substr(0, bracket));
        const auto found = provenance_.definitions.find(name);
        if (found == provenance_.definitions.end()) continue;
        Place place{found->second.text, {}, {}};
        if (bracket != std::string_view::npos && call.back() == ')') {
            const auto values = split(call.substr(bracket + 1, call.size() - bracket - 2), ",");
            for (std::size_t i = 0; i < values.size() && i < found->second.parameters.size(); ++i) {
                const ir::TypeId type = i < found->second.types.size() ? found->second.types[i] : ir::TypeId{};
                if (i < found->second.deadlines.size() && found->second.deadlines[i].span.known())
                    place.deadlines.emplace_back(&found->second.deadlines[i], trim(values[i]));
                if (!found->second.parameters[i].empty())
                    place.values.emplace_back(found->second.parameters[i], value(type, std::string(trim(values[i]))));
            }
        }
        result.push_back(std::move(place));
    }
    return result;
}

std::vector<std::string> StoryTeller::changes(const std::string& before, const std::string& after) const {
    std::vector<std::pair<std::string, std::string>> old;
    for (Place& place : places(before)) old.insert(old.end(), place.values.begin(), place.values.end());
    std::vector<std::string> result;
    for (const Place& place : places(after)) {
        for (const auto& now : place.values) {
            const bool clock = now.first.starts_with("since(");
            const bool unread = now.second == "'_'" || now.second == "_";  // nothing reads the value any more
            if (!clock && !unread && std::find(old.begin(), old.end(), now) == old.end() &&
                std::any_of(old.begin(), old.end(), [&](const auto& was) { return was.first == now.first; }))
                result.push_back(fmt::format("{} = {}", now.first, now.second));
        }
    }
    return result;
}

std::string StoryTeller::where(const std::string& description) const {
    std::vector<std::string> shown;
    for (const Place& place : places(description)) {
        std::vector<std::string> values;
        for (const auto& [name, text] : place.values) values.push_back(fmt::format("{} = {}", name, text));
        shown.push_back(values.empty() ? place.text : fmt::format("{} ({})", place.text, fmt::join(values, ", ")));
    }
    return fmt::format("{}", fmt::join(shown, "; "));
}

void StoryTeller::add(std::vector<StoryLine>& lines, const refine::Step& step, const std::string& before, std::int64_t& time) const {
    const std::string& name = events_.name(step.revealed == process::tau ? step.event : step.revealed);
    std::string rest;
    const csp_emit::EventMeaning* found = meaning(name, rest);
    if (name == "tock") {
        ++time;
        return;
    }
    const bool silent = step.event == process::tau;
    const std::vector<std::string> changed = changes(before, step.state);
    const bool news = found != nullptr && found->kind != csp_emit::MeaningKind::step && found->kind != csp_emit::MeaningKind::entered;
    if (silent && !news && changed.empty()) return;
    StoryLine line;
    line.time = time;
    line.text = step.event == process::tick ? "terminates" : described(name);
    if (silent && found == nullptr) line.text = "an internal step";
    if (found != nullptr) line.place = sources_.place(found->origin.span);
    line.changes = changed;
    lines.push_back(std::move(line));
}

std::string StoryTeller::why_time_stops(const refine::Counterexample& c) const {
    std::vector<std::string> causes;
    const auto add = [&](const std::string& cause, diagnostics::Span span) {
        const std::string at = sources_.place(span);
        causes.push_back(at.empty() ? cause : fmt::format("{} ({})", cause, at));
    };
    for (const Place& place : places(c.steps.empty() ? c.initial : c.steps.back().state))
        for (const auto& [deadline, left] : place.deadlines)
            if (left == "0" || left.starts_with("-")) add(fmt::format("the deadline of {} has run out", deadline->element), deadline->span);
    for (const process::Event offered : c.offered) {
        std::string rest;
        const csp_emit::EventMeaning* found = meaning(events_.name(offered), rest);
        if (found == nullptr || found->kind != csp_emit::MeaningKind::call) continue;
        add(fmt::format("{} waits for the environment, which may refuse it", event(offered)), found->origin.span);
    }
    const bool ended = std::find(c.offered.begin(), c.offered.end(), process::tick) != c.offered.end();
    if (causes.empty() && ended) causes.emplace_back("it has terminated");
    if (causes.empty()) return "";
    return fmt::format("time cannot pass: {}", fmt::join(causes, ", and "));
}

std::string StoryTeller::why(const refine::Counterexample& c) const {
    const auto names = [this](const process::EventSet& set) {
        std::vector<std::string> shown;
        for (std::size_t i = 0; i < set.size() && i < 12; ++i) shown.push_back(event(set[i]));
        if (set.size() > 12) shown.push_back(fmt::format("{} more", set.size() - 12));
        return shown.empty() ? std::string("nothing") : fmt::format("{}", fmt::join(shown, ", "));
    };
    switch (c.kind) {
        case refine::ViolationKind::trace:
            return fmt::format("{} is not allowed here; allowed: {}", c.event ? event(*c.event) : "the last step",
                               c.required.empty() ? "nothing" : names(c.required.front()));
        case refine::ViolationKind::refusal: {
            std::string text = fmt::format("it offers {}, and must offer at least ", names(c.offered));
            for (std::size_t i = 0; i < c.required.size(); ++i) text += (i == 0 ? "" : ", or ") + names(c.required[i]);
            return text;
        }
        case refine::ViolationKind::divergence: return "it can go on internally for ever without offering anything";
        case refine::ViolationKind::deadlock: return "nothing is possible any more";
        case refine::ViolationKind::nondeterminism:
            return fmt::format("{} may be accepted and may be refused after the same events", c.event ? event(*c.event) : "an event");
        case refine::ViolationKind::no_trace: return "the trace cannot go on";
    }
    return "";
}

Story StoryTeller::tell(const refine::Counterexample& c) const {
    Story story;
    std::int64_t time = 0;
    std::string before = c.initial;
    for (const refine::Step& step : c.steps) {
        add(story.lines, step, before, time);
        before = step.state;
    }
    story.where = where(before);
    for (const refine::Step& step : c.loop) {
        add(story.loop, step, before, time);
        before = step.state;
    }
    if (time > 0) {
        const std::int64_t last = story.lines.empty() ? 0 : story.lines.back().time;
        if (time > last && story.loop.empty()) story.lines.push_back({time, time - last == 1 ? "1 time unit passes" : fmt::format("{} time units pass", time - last), "", {}});
    }
    story.why = why(c);
    return story;
}

std::string render(const Story& story, std::string_view indent) {
    std::string text;
    const auto write = [&](const std::vector<StoryLine>& lines) {
        std::size_t width = 0;
        for (const StoryLine& line : lines) width = std::max(width, line.text.size());
        for (const StoryLine& line : lines) {
            text += fmt::format("{}t={:<4} {:<{}}", indent, line.time, line.text, std::min<std::size_t>(width, 60));
            if (!line.changes.empty()) text += fmt::format("   [{}]", fmt::join(line.changes, ", "));
            if (!line.place.empty()) text += fmt::format("   {}", line.place);
            text += '\n';
        }
    };
    write(story.lines);
    if (!story.loop.empty()) {
        text += fmt::format("{}then for ever:\n", indent);
        write(story.loop);
    }
    if (!story.where.empty()) text += fmt::format("{}now {}\n", indent, story.where);
    text += fmt::format("{}why {}\n", indent, story.why);
    return text;
}

}  // namespace robochart::app
