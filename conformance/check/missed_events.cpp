// SPDX-License-Identifier: Apache-2.0
// See missed_events.hpp. A cycle loses an event if the event's register makes no difference, for any readings of the
// other registers.
#include "conformance/check/missed_events.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

namespace robochart::conformance {

namespace {

class Finder {
public:
    Finder(const ExploredCode& code, const Alphabet& alphabet, const EventPlaces& places)
        : code_(code),
          alphabet_(alphabet),
          places_(places),
          inputs_(alphabet.interface().inputs.size()),
          events_(std::min(inputs_, places_.event_count())) {}

    std::vector<MissedEvent> find_missed() {
        for (const std::uint32_t image : code_.started_images()) check_image(image);
        std::vector<MissedEvent> result;
        for (std::uint32_t event = 0; event < events_; ++event) add_result(event, result);
        return result;
    }

private:
    /// The images that miss an event for one reason, and the states of the machine there.
    struct Missed {
        std::vector<std::uint32_t> images;
        std::set<std::uint32_t> known;
        std::vector<std::string> places;
    };

    Missed& missed_entry(std::uint32_t event, MissedWhile why) {
        return missed_[std::pair(event, why == MissedWhile::condition)];
    }

    void check_image(std::uint32_t image) {
        std::vector<bool> lost;  // computed on first use
        for (const cpp_emit::EventPlace* found : places_.find_places(code_.print_image(image))) {
            const cpp_emit::EventPlace& place = *found;
            if (lost.empty()) lost = code_.without_effect(image);
            for (std::uint32_t event = 0; event < events_; ++event)
                if (place.events[event] && lost[event]) note_place(event, place, image);
        }
    }

    void note_place(std::uint32_t event, const cpp_emit::EventPlace& place, std::uint32_t image) {
        Missed& all = missed_entry(event, place.busy ? MissedWhile::busy : MissedWhile::condition);
        if (all.known.insert(image).second) all.images.push_back(image);
        if (std::ranges::find(all.places, place.element) == all.places.end()) all.places.push_back(place.element);
    }

    /// Returns the images to which a cycle in this image may lead.
    const std::vector<std::uint32_t>& next_images(std::uint32_t image) {
        const auto known = behind_.find(image);
        if (known != behind_.end()) return known->second;
        return behind_.emplace(image, code_.next_images(image)).first->second;
    }

    void add_result(std::uint32_t event, std::vector<MissedEvent>& result) {
        const std::string text = alphabet_.describe_event(alphabet_.read_event(event, 1));
        MissedEvent found{text.substr(0, text.find(" = ")), {}, {}};
        Missed either;
        for (const MissedWhile why : {MissedWhile::busy, MissedWhile::condition}) {
            const Missed& all = missed_entry(event, why);
            if (all.images.empty()) continue;
            found.reasons.push_back({why, longest_run(all), all.places});
            for (const std::uint32_t image : all.images)
                if (either.known.insert(image).second) either.images.push_back(image);
        }
        if (found.reasons.empty()) return;
        found.cycles = longest_run(either);
        result.push_back(std::move(found));
    }

    /// Returns how many cycles in succession can begin in these images, or no value if there is no bound.
    std::optional<std::uint64_t> longest_run(const Missed& all) {
        struct Visit {
            std::uint32_t image = 0;
            std::size_t next = 0;
        };
        std::unordered_map<std::uint32_t, std::uint64_t> length;  // 0: on the path; never iterated
        std::uint64_t longest = 0;
        for (const std::uint32_t start : all.images) {
            if (length.count(start) != 0) continue;
            std::vector<Visit> path{{start}};
            length[start] = 0;
            while (!path.empty()) {
                Visit& visit = path.back();
                const std::vector<std::uint32_t>& next = next_images(visit.image);
                if (visit.next == next.size()) {
                    std::uint64_t most = 0;
                    for (const std::uint32_t image : next)
                        if (all.known.count(image) != 0) most = std::max(most, length.at(image));
                    length[visit.image] = most + 1;
                    longest = std::max(longest, most + 1);
                    path.pop_back();
                    continue;
                }
                const std::uint32_t image = next[visit.next++];
                if (all.known.count(image) == 0) continue;
                const auto [place, fresh] = length.emplace(image, 0);
                if (!fresh && place->second == 0) return std::nullopt;
                if (fresh) path.push_back({image});
            }
        }
        return longest;
    }

    const ExploredCode& code_;
    const Alphabet& alphabet_;
    PlacesInState places_;
    std::size_t inputs_;
    std::size_t events_;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> behind_;  ///< never iterated
    std::map<std::pair<std::uint32_t, bool>, Missed> missed_;
};

}  // namespace

std::vector<MissedEvent> missed_events(const ExploredCode& code, const Alphabet& alphabet, const EventPlaces& places) {
    return Finder(code, alphabet, places).find_missed();
}

}  // namespace robochart::conformance
