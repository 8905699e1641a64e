// Counterexamples in the words of the model: which transition fired, where it stands in the text, what changed,
// how much time passed. The checker knows only event names and process descriptions; csp_emit's Provenance says
// what they mean.
#pragma once

#include <string>
#include <vector>

#include "checker/refine/check.hpp"
#include "csp_emit/emit.hpp"
#include "diagnostics/source.hpp"
#include "semantics/instantiation.hpp"
#include "semantics/ir.hpp"

namespace robochart::app {

/// One line of the story.
struct StoryLine {
    std::int64_t time = 0;             ///< time units passed before it
    std::string text;                  ///< "S1 -> S2 on seeRobot"
    std::string place;                 ///< "aggregation.rct:71", "" if unknown
    std::vector<std::string> changes;  ///< "linearSpeed = 0"
};

struct Story {
    std::vector<StoryLine> lines;      ///< the run, internal steps without news left out
    std::vector<StoryLine> loop;       ///< divergence: what repeats
    std::string where;                 ///< "in S2 (linearSpeed = 0, since(T) = 3)"
    std::string why;                   ///< "seeWall is not allowed here; the specification allows: seeRobot"
};

class StoryTeller {
public:
    StoryTeller(const csp_emit::Provenance&, const ir::System&, const ir::Instantiation&, const diagnostics::SourceManager&,
                const process::EventTable&);

    [[nodiscard]] Story tell(const refine::Counterexample&) const;
    /// Why time cannot pass where the run ends: deadlines that have run out and calls that wait, with their places.
    [[nodiscard]] std::string why_time_stops(const refine::Counterexample&) const;
    /// An event in model terms, e.g. "call MoveClockwise(-0.75, -10.88)"; its CSP name if nothing is known.
    [[nodiscard]] std::string event(process::Event) const;

private:
    struct Place {
        std::string text;                            ///< "in S1"
        std::vector<std::pair<std::string, std::string>> values;
        std::vector<std::pair<const ir::Origin*, std::string>> deadlines;  ///< time left for each
    };
    [[nodiscard]] const csp_emit::EventMeaning* meaning(const std::string& name, std::string& arguments) const;
    [[nodiscard]] std::string described(const std::string& name) const;
    [[nodiscard]] std::string arguments(const csp_emit::EventMeaning&, const std::string& text) const;
    [[nodiscard]] std::string value(ir::TypeId, const std::string& text) const;
    [[nodiscard]] std::vector<Place> places(const std::string& description) const;
    [[nodiscard]] std::vector<std::string> changes(const std::string& before, const std::string& after) const;
    [[nodiscard]] std::string where(const std::string& description) const;
    [[nodiscard]] std::string why(const refine::Counterexample&) const;
    void add(std::vector<StoryLine>& lines, const refine::Step& step, const std::string& before, std::int64_t& time) const;

    const csp_emit::Provenance& provenance_;
    const ir::System& system_;
    const ir::Instantiation& instantiation_;
    const diagnostics::SourceManager& sources_;
    const process::EventTable& events_;
};

/// The story as indented text lines.
[[nodiscard]] std::string render(const Story&, std::string_view indent);

}  // namespace robochart::app
