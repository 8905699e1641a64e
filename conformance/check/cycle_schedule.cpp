// SPDX-License-Identifier: Apache-2.0
// See cycle_schedule.hpp. A place is a state of M in a cycle, with the inputs that M has received in this
// cycle. Two places may have the same state of M. If the first has received only a subset of the second's
// inputs and has made at least its outputs, it can do everything that the second can. So only the first is
// stored. In a place that waits for inputs that it has not received, time may pass, because their registers may
// be empty.
#include "conformance/check/cycle_schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "checker/refine/search/budget.hpp"
#include "conformance/check/conformance_check.hpp"
#include "conformance/model/normal_form_system.hpp"
#include "conformance/model/rules.hpp"

namespace robochart::conformance {

namespace {

using Kind = ModelRole::Kind;
constexpr ModelState no_state = 0xffffffffU;
constexpr std::uint32_t nowhere = 0xffffffffU;

/// Indices of registers or of outputs, ascending.
using Numbers = std::vector<std::uint32_t>;

struct Place {
    ModelState model = 0;
    std::uint32_t left = 0;  ///< tocks until the end of the cycle; 0 before the first one
    std::uint32_t received = 0;
    std::uint32_t made = 0;  ///< the set of outputs made in this cycle, until one is made twice in a cycle
    std::uint32_t from = nowhere;
    ModelEdge edge;  ///< the edge that led here
};

class Schedule {
public:
    Schedule(ModelGraph& model, const Alphabet& alphabet, std::uint32_t cycle_length, const refine::Limits& limits)
        : model_(model),
          alphabet_(alphabet),
          cycle_length_(std::max(1U, cycle_length)),
          limits_(limits),
          budget_(limits) {
        model_.set_budget(budget_);
        (void)intern({});
    }
    ~Schedule() { model_.set_budget(diagnostics::unlimited); }
    Schedule(const Schedule&) = delete;
    Schedule& operator=(const Schedule&) = delete;

    Result run() {
        add({model_.initial(), 0, 0, 0, nowhere, {}});
        for (std::uint32_t at = 0; at < places_.size() && stuck_ == nowhere; ++at) expand(at);
        Result result;
        result.outcome = Outcome::conforms;
        if (stuck_ != nowhere) {
            not_schedulable(result, run_to(refine::ViolationKind::deadlock, stuck_));
        } else {
            find_loop(result, true);
            if (result.outcome == Outcome::conforms && cycle_length_ > 1) find_loop(result, false);
        }
        result.schedulability.states = places_.size();
        result.schedulability.transitions = transitions_;
        result.model_states = model_.size();
        result.register_cycles = aside(rules::output_made_twice, repeated_, "");
        result.deadlines =
            aside(rules::input_not_in_time, missed_, "time stops in the model, which waits for an input, at ");
        const bool decided = result.outcome == Outcome::conforms;
        if (decided && !result.register_cycles) result.register_cycles.emplace();
        if (decided && !result.deadlines) result.deadlines.emplace();
        return result;
    }

private:
    std::uint32_t intern(const Numbers& numbers) {
        const auto [place, fresh] = ids_.emplace(numbers, static_cast<std::uint32_t>(numbers_.size()));
        if (fresh) numbers_.push_back(numbers);
        return place->second;
    }

    [[nodiscard]] bool contains(std::uint32_t set, std::uint32_t number) const {
        return std::ranges::binary_search(numbers_[set], number);
    }

    std::uint32_t with(std::uint32_t set, std::uint32_t number) {
        Numbers more = numbers_[set];
        more.insert(std::ranges::upper_bound(more, number), number);
        return intern(more);
    }

    /// Removes inputs that M has received and cannot receive a second time before time passes.
    std::uint32_t narrowed(std::uint32_t received, ModelState model) {
        if (received == 0 || model == no_state) return 0;
        const std::vector<bool>& hears = model_.heard_inputs(model);
        Numbers left;
        for (const std::uint32_t input : numbers_[received])
            if (hears[input]) left.push_back(input);
        return intern(left);
    }

    void add(Place place) {
        ++transitions_;
        place.received = narrowed(place.received, place.model);
        std::vector<std::pair<std::uint32_t, std::uint32_t>>& known = known_[{place.model, place.left}];
        for (const auto& [received, made] : known)
            if (std::ranges::includes(numbers_[place.received], numbers_[received]) &&
                std::ranges::includes(numbers_[made], numbers_[place.made]))
                return;
        known.emplace_back(place.received, place.made);
        places_.push_back(place);
        budget_.states(places_.size());
    }

    void expand(std::uint32_t at) {
        budget_.charge();
        const Place here = places_[at];
        const bool acting = here.left == 0;
        if (here.model == no_state) {
            if (!acting) stuck_ = at;
            return;
        }
        bool urgent = false;
        const std::vector<ModelEdge>& edges = model_.edges(here.model);
        for (const ModelEdge& edge : edges) {
            Place next{edge.target, here.left, here.received, here.made, at, edge};
            switch (edge.role.kind) {
                case Kind::tau:
                case Kind::terminate:
                    urgent = true;
                    add(next);
                    break;
                case Kind::tick:
                    urgent = true;
                    next.model = no_state;
                    add(next);
                    break;
                case Kind::input:
                    if (!acting || contains(here.received, edge.role.index)) break;
                    next.received = with(here.received, edge.role.index);
                    add(next);
                    break;
                case Kind::output:
                    if (!acting) break;
                    urgent = true;
                    make(at, next);
                    break;
                case Kind::tock:
                case Kind::read:
                case Kind::hidden:
                case Kind::blocked:
                case Kind::foreign:
                    break;
            }
        }
        if (!urgent) let_time_pass(at);
    }

    void make(std::uint32_t at, Place next) {
        if (contains(next.made, next.edge.role.index)) {
            if (repeated_.place == nowhere) repeated_ = {at, next.edge};
        } else if (repeated_.place == nowhere) {
            next.made = with(next.made, next.edge.role.index);
        }
        add(next);
    }

    void let_time_pass(std::uint32_t at) {
        const Place here = places_[at];
        bool passes = false;
        bool awaits = false;
        for (const ModelEdge& edge : model_.edges(here.model)) {
            awaits = awaits || (edge.role.kind == Kind::input && here.left == 0 && model_.goes_on(edge.target));
            if (edge.role.kind != Kind::tock) continue;
            passes = true;
            add({edge.target, (here.left == 0 ? cycle_length_ : here.left) - 1, 0, 0, at, edge});
        }
        if (passes) return;
        if (!awaits)
            stuck_ = at;
        else if (missed_.place == nowhere)
            missed_ = {at, {}};
    }

    // ------------------------------------------------------------ endless loops

    [[nodiscard]] static bool takes_no_time(const ModelEdge& edge, bool acting) {
        const Kind kind = edge.role.kind;
        return kind == Kind::tau || kind == Kind::terminate || (acting && kind == Kind::output);
    }

    /// Finds a loop of M without inputs and tocks. Inputs that M has received before do not matter for the
    /// loop.
    void find_loop(Result& result, bool acting) {
        std::unordered_map<ModelState, std::uint32_t> first;  // a place of each state; never iterated
        std::vector<ModelState> starts;
        for (std::uint32_t at = 0; at < places_.size(); ++at)
            if (places_[at].model != no_state && (places_[at].left == 0) == acting &&
                first.emplace(places_[at].model, at).second)
                starts.push_back(places_[at].model);
        struct Visit {
            ModelState state;
            std::size_t next = 0;
        };
        std::unordered_map<ModelState, bool> open;  // whether the state is on the path; never iterated
        for (const ModelState start : starts) {
            if (open.count(start) != 0) continue;
            std::vector<Visit> path{{start}};
            open[start] = true;
            while (!path.empty()) {
                budget_.charge();
                const ModelState state = path.back().state;
                const std::vector<ModelEdge>& edges = model_.edges(state);
                if (path.back().next == edges.size()) {
                    open[state] = false;
                    path.pop_back();
                    continue;
                }
                const ModelEdge& edge = edges[path.back().next++];
                if (!takes_no_time(edge, acting)) continue;
                const auto [place, fresh] = open.emplace(edge.target, true);
                if (fresh) path.push_back({edge.target});
                if (fresh || !place->second) continue;
                std::vector<ModelEdge> loop;
                auto begin = std::ranges::find(path, edge.target, &Visit::state);
                for (auto visit = begin; visit != path.end(); ++visit)
                    loop.push_back(model_.edges(visit->state)[visit->next - 1]);
                refine::Counterexample found = run_to(refine::ViolationKind::divergence, first.at(edge.target));
                for (const ModelEdge& loop_edge : loop) add_steps(found.loop, loop_edge, loop_edge.target);
                return not_schedulable(result, found);
            }
        }
    }

    // ------------------------------------------------------------ runs

    [[nodiscard]] refine::Counterexample run_to(refine::ViolationKind kind, std::uint32_t place) const {
        refine::Counterexample run;
        run.kind = kind;
        run.steps = steps_to(place);
        run.initial = model_.describe(model_.initial());
        return run;
    }

    [[nodiscard]] std::string describe(ModelState state) const {
        return state == no_state ? "terminating" : model_.describe(state);
    }

    void add_steps(std::vector<refine::Step>& steps, const ModelEdge& edge, ModelState target) const {
        const Kind kind = edge.role.kind;
        if (kind == Kind::tock) {
            steps.push_back({edge.event, edge.event, describe(target)});
            return;
        }
        steps.push_back({process::tau, kind == Kind::tau ? edge.revealed : edge.event, describe(target)});
        if (kind == Kind::output) steps.push_back({edge.role.write, edge.role.write, describe(target)});
    }

    /// Returns a run of NF_c(M) to this place. Registers of inputs that M does not receive are empty.
    [[nodiscard]] std::vector<refine::Step> steps_to(std::uint32_t place) const {
        std::vector<std::uint32_t> way;
        for (std::uint32_t at = place; at != nowhere; at = places_[at].from) way.push_back(at);
        std::ranges::reverse(way);
        std::vector<refine::Step> steps;
        add_reads(steps, way, 0);
        for (std::size_t i = 1; i < way.size(); ++i) {
            const Place& next = places_[way[i]];
            add_steps(steps, next.edge, next.model);
            if (next.edge.role.kind == Kind::tock && next.left == 0) add_reads(steps, way, i);
        }
        return steps;
    }

    /// Adds the readings of the cycle that begins at this place of the path.
    void add_reads(std::vector<refine::Step>& steps, const std::vector<std::uint32_t>& way, std::size_t begin) const {
        std::vector<std::uint32_t> readings(alphabet_.interface().inputs.size(), 0);
        for (std::size_t i = begin + 1; i < way.size(); ++i) {
            const ModelRole& role = places_[way[i]].edge.role;
            if (role.kind == Kind::tock) break;
            if (role.kind == Kind::input) readings[role.index] = role.reading;
        }
        for (std::uint32_t input = 0; input < readings.size(); ++input) {
            const process::Event event = alphabet_.read_event(input, readings[input]);
            steps.push_back({event, event, describe(places_[way[begin]].model)});
        }
    }

    void not_schedulable(Result& result, const refine::Counterexample& found) {
        report_not_schedulable(result, found, model_, alphabet_, cycle_length_, limits_);
    }

    /// A place at which M makes an output for the second time in a cycle.
    struct Found {
        std::uint32_t place = nowhere;
        ModelEdge edge;
    };

    std::optional<Aside> aside(const diagnostics::Rule& rule, const Found& found, const std::string& words) const {
        if (found.place == nowhere) return std::nullopt;
        refine::Counterexample run = run_to(refine::ViolationKind::deadlock, found.place);
        std::string state = describe(places_[found.place].model);
        if (found.edge.role.kind == Kind::output)
            state = fmt::format("{} a second time in one cycle, at {}", alphabet_.describe_event(found.edge.role.write),
                                describe(places_[found.place].model));
        run.steps.push_back({mark(), mark(), state});
        return found_aside(rule, words + state, run, alphabet_, cycle_length_);
    }

    /// Returns the event at the end of such a run. It is only a mark; no process performs it.
    [[nodiscard]] process::Event mark() const { return alphabet_.events().intern("model.repeats"); }

    ModelGraph& model_;
    const Alphabet& alphabet_;
    std::uint32_t cycle_length_;
    const refine::Limits& limits_;
    refine::Budget budget_;
    std::vector<Place> places_;
    std::map<std::pair<ModelState, std::uint32_t>, std::vector<std::pair<std::uint32_t, std::uint32_t>>> known_;
    std::vector<Numbers> numbers_;
    std::map<Numbers, std::uint32_t> ids_;
    std::uint64_t transitions_ = 0;
    std::uint32_t stuck_ = nowhere;
    Found repeated_, missed_;
};

}  // namespace

Result schedulable_on_demand(ModelGraph& model, const Alphabet& alphabet, std::uint32_t cycle_length,
                             const refine::Limits& limits) {
    return Schedule(model, alphabet, cycle_length, limits).run();
}

}  // namespace robochart::conformance
