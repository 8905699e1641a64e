// SPDX-License-Identifier: Apache-2.0
// See overtaken_events.hpp. Outputs show which event came first. Suppose that the event alone causes outputs A, and
// another event alone causes B. If both are raised and the outputs of the cycle begin with B and not with A, the other
// event came first. Suppose that the cycle without any input causes outputs N. If the cycle with the event alone causes
// N and then more outputs, transitions without trigger came first. Cycles that make no outputs, or pass probabilistic
// junctions, do not show the order.
#include "conformance/check/overtaken_events.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace robochart::conformance {

namespace {

using Writes = std::vector<process::Event>;

bool starts_with(const Writes& writes, const Writes& front) {
    return writes.size() >= front.size() && std::equal(front.begin(), front.end(), writes.begin());
}

class Overtaking {
public:
    Overtaking(const ExploredCode& code, const Alphabet& alphabet, const EventPlaces& places)
        : code_(code),
          alphabet_(alphabet),
          places_(places),
          inputs_(alphabet.interface().inputs.size()),
          events_(std::min(inputs_, places_.event_count())) {}

    std::vector<OvertakenEvent> find_overtaken() {
        for (const std::uint32_t image : code_.started_images())
            for (const cpp_emit::EventPlace* place : places_.find_places(code_.print_image(image)))
                check_place(image, *place);
        std::vector<OvertakenEvent> all;
        for (const auto& [event, found] : found_) all.push_back(make_result(event, found));
        return all;
    }

private:
    struct Found {
        std::set<std::size_t> by;
        bool due = false;
        std::vector<std::string> places;
    };

    void check_place(std::uint32_t image, const cpp_emit::EventPlace& place) {
        if (!looked_at_.emplace(code_.cycles_of(image), &place).second) return;
        for (std::size_t event = 0; event < events_; ++event)
            if (place.level[event] > 0 && place.level[event] != cpp_emit::EventPlace::no_level)
                check_place(image, place, event);
    }

    void check_place(std::uint32_t image, const cpp_emit::EventPlace& place, std::size_t event) {
        const Writes nothing = code_.writes(image, {});
        for (const std::uint32_t reading : extreme_readings(event)) {
            const Raised raised{event, reading};
            const Writes alone = code_.writes(image, {raised});
            if (alone.empty()) continue;
            if (!nothing.empty() && alone.size() > nothing.size() && starts_with(alone, nothing))
                note_place(event, place).due = true;
            for (std::size_t other = 0; other < events_; ++other)
                if (place.level[other] < place.level[event] && comes_first(image, other, raised, alone))
                    note_place(event, place).by.insert(other);
        }
    }

    [[nodiscard]] bool comes_first(std::uint32_t image, std::size_t other, const Raised& raised,
                                   const Writes& alone) const {
        return std::ranges::any_of(extreme_readings(other), [&](std::uint32_t reading) {
            const Writes others = code_.writes(image, {{other, reading}});
            const Writes both = code_.writes(image, {raised, {other, reading}});
            return !others.empty() && starts_with(both, others) && !starts_with(both, alone);
        });
    }

    Found& note_place(std::size_t event, const cpp_emit::EventPlace& place) {
        Found& found = found_[event];
        if (std::ranges::find(found.places, place.element) == found.places.end()) found.places.push_back(place.element);
        return found;
    }

    /// Returns the readings to try: the least and the greatest value represent all values.
    [[nodiscard]] std::set<std::uint32_t> extreme_readings(std::size_t event) const {
        return {1U, alphabet_.interface().inputs[event].reading_count() - 1};
    }

    [[nodiscard]] std::string event_name(std::size_t event) const {
        const std::string text = alphabet_.describe_event(alphabet_.read_event(static_cast<std::uint32_t>(event), 1));
        return text.substr(0, text.find(" = "));
    }

    [[nodiscard]] OvertakenEvent make_result(std::size_t event, const Found& found) const {
        OvertakenEvent result{event_name(event), {}, found.due, found.places};
        for (const std::size_t other : found.by) result.by.push_back(event_name(other));
        return result;
    }

    const ExploredCode& code_;
    const Alphabet& alphabet_;
    PlacesInState places_;
    std::size_t inputs_;
    std::size_t events_;
    std::set<std::pair<std::uint32_t, const cpp_emit::EventPlace*>> looked_at_;  ///< never iterated
    std::map<std::size_t, Found> found_;
};

}  // namespace

std::vector<OvertakenEvent> overtaken_events(const ExploredCode& code, const Alphabet& alphabet,
                                             const EventPlaces& places) {
    return Overtaking(code, alphabet, places).find_overtaken();
}

}  // namespace robochart::conformance
