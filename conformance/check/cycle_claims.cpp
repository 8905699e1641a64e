// SPDX-License-Identifier: Apache-2.0
// See cycle_claims.hpp.
#include "conformance/check/cycle_claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <unordered_map>

#include "checker/process/operational_semantics.hpp"
#include "checker/refine/search/budget.hpp"
#include "claims/monitor/account.hpp"
#include "conformance/model/component_in_cycles.hpp"
#include "conformance/model/provenance_text.hpp"

namespace robochart::conformance {

namespace {

using claims::CheckedClaim;
using claims::FactValue;
using claims::Monitor;
using claims::MonitorState;
using claims::Occurrence;

/// Thrown if a claim cannot be decided; the text contains the reason.
struct Undecided : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// ---------------------------------------------------------------- events

/// The channels of a claim for the registers and outputs of a component.
class ClaimChannels {
public:
    ClaimChannels(const CheckedClaim& claim, const Alphabet& alphabet) : claim_(claim), alphabet_(alphabet) {
        const Interface& interface = alphabet.interface();
        for (const Register& input : interface.inputs)
            inputs_.push_back(find(input_name(input), claims::ChannelKind::input));
        for (const Output& output : interface.outputs) outputs_.push_back(find_output(output.name));
    }

    /// Returns true if the claim can refer to the input.
    [[nodiscard]] bool knows(std::uint32_t input) const { return inputs_[input].has_value(); }
    [[nodiscard]] std::optional<Occurrence> raised(std::uint32_t input, std::uint32_t reading) const {
        if (!inputs_[input]) return std::nullopt;
        Occurrence result{*inputs_[input], {}};
        const Register& of = alphabet_.interface().inputs[input];
        if (!of.values.empty()) result.values.push_back(number(of.carrier, of.values.at(reading - 1)));
        return result;
    }

    [[nodiscard]] std::optional<Occurrence> written(process::Event write) const {
        const std::uint32_t output = alphabet_.cycle_role(write).index;
        if (!outputs_[output]) return std::nullopt;
        Occurrence result{*outputs_[output], {}};
        const std::vector<Carrier>& carriers = alphabet_.interface().outputs[output].arguments;
        const std::vector<std::string> texts = alphabet_.written_arguments(write);
        for (std::size_t i = 0; i < carriers.size(); ++i) result.values.push_back(value_of(carriers[i], texts.at(i)));
        return result;
    }

private:
    [[nodiscard]] std::optional<std::size_t> find(const std::string& name, claims::ChannelKind kind) const {
        const auto& channels = claim_.component.channels;
        for (std::size_t i = 0; i < channels.size(); ++i)
            if (channels[i].name == name && channels[i].kind == kind) return i;
        return std::nullopt;
    }
    [[nodiscard]] std::optional<std::size_t> find_output(const std::string& name) const {
        constexpr std::string_view call = "Call", out = ".out";
        if (name.ends_with(out)) return find(name.substr(0, name.size() - out.size()), claims::ChannelKind::output);
        if (name.ends_with(call)) return find(name.substr(0, name.size() - call.size()), claims::ChannelKind::call);
        return std::nullopt;
    }
    [[nodiscard]] claims::Fraction number(const Carrier& carrier, std::int64_t value) const {
        return carrier.kind == Carrier::Kind::real ? claims::Fraction(value, alphabet_.interface().scale)
                                                   : claims::Fraction(value);
    }
    [[nodiscard]] claims::Fraction value_of(const Carrier& carrier, const std::string& text) const {
        if (carrier.kind == Carrier::Kind::boolean) return claims::Fraction(text == "true" ? 1 : 0);
        if (carrier.kind == Carrier::Kind::enumeration) {
            const auto found = std::ranges::find(carrier.names, text);
            return claims::Fraction(found - carrier.names.begin());
        }
        const bool negative = text.starts_with("-");
        const bool digits =
            text.size() > (negative ? 1U : 0U) &&
            std::all_of(text.begin() + (negative ? 1 : 0), text.end(), [](char c) { return c >= '0' && c <= '9'; });
        constexpr std::size_t most_digits = 18;
        if (!digits || text.size() > most_digits) return claims::Fraction();  // no condition reads it
        return number(carrier, std::stoll(text));
    }

    const CheckedClaim& claim_;
    const Alphabet& alphabet_;
    std::vector<std::optional<std::size_t>> inputs_, outputs_;
};

// ---------------------------------------------------------------- states

/// Returns which facts of a claim are true in a state.
using FactsOf = std::function<std::vector<FactValue>(lts::StateView)>;

/// Returns a function for the facts of the model. A fact depends on the active states of the definitions that the model
/// executes in a state.
FactsOf facts_of_model(const CheckedClaim& claim, const ClaimedModel& claimed, const CycleSystem& system) {
    return [&](lts::StateView state) {
        std::vector<FactValue> result;
        const std::vector<std::string> names = definitions_in(system.describe_model(state));
        for (std::size_t fact = 0; fact < claim.facts.size(); ++fact) {
            const claims::Fact& of = claim.facts[fact];
            const std::string& element = claimed.system.machine(of.of).nodes[of.state->index].origin.element;
            bool machine = false, active = false;
            for (const std::string& name : names) {
                const auto known = claimed.provenance.definitions.find(name);
                if (known == claimed.provenance.definitions.end() || known->second.component != of.machine) continue;
                machine = true;
                active = active || std::ranges::find(known->second.active, element, &ir::Origin::element) !=
                                       known->second.active.end();
            }
            if (!machine) throw Undecided(fmt::format("the states of {} are not known", of.machine));
            result.push_back({fact, active});
        }
        return result;
    };
}

/// Returns the place of a state in the code, such as "Operating_Held".
std::string place_of(const ir::Node& node) {
    std::string result;
    for (std::size_t at = 0; at < node.path.size(); ++at) {
        const bool separator = node.path.compare(at, 2, "::") == 0;
        result += separator ? '_' : node.path[at];
        if (separator) ++at;
    }
    return result;
}

/// Evaluates facts for the code of a single machine. They depend on where the machine rests.
class PlacesOfCode {
public:
    PlacesOfCode(const CheckedClaim& claim, const ClaimedModel& claimed) {
        if (claim.facts.empty()) return;
        if (claim.component.machines.size() != 1)
            throw Undecided("the states of several machines in code are not read");
        const ir::Machine& machine = claimed.system.machine(claim.component.machines.front().machine);
        for (const ir::Node& node : machine.nodes) {
            if (node.kind != ir::NodeKind::state && node.kind != ir::NodeKind::final) continue;
            if (!nodes_.emplace(place_of(node), &node).second)
                throw Undecided(fmt::format("two states are called {} in code", place_of(node)));
        }
        for (const claims::Fact& fact : claim.facts) states_.push_back(&machine.nodes[fact.state->index]);
    }

    [[nodiscard]] std::vector<FactValue> facts_in(const std::string& state) const {
        std::vector<FactValue> result;
        if (states_.empty()) return result;
        const ir::Node* const node = node_in(state);
        for (std::size_t fact = 0; fact < states_.size(); ++fact) {
            const std::string& path = states_[fact]->path;
            result.push_back({fact, node->path == path || node->path.starts_with(path + "::")});
        }
        return result;
    }

private:
    [[nodiscard]] const ir::Node* node_in(const std::string& state) const {
        const ir::Node* found = nullptr;
        for (std::size_t begin = 0; begin < state.size();) {
            const std::size_t end = std::min(state.find(' ', begin), state.size());
            const std::string_view field = std::string_view(state).substr(begin, end - begin);
            begin = end + 1;
            const std::size_t equal = field.find('=');
            if (equal == std::string_view::npos ||
                (field.substr(0, equal) != "at" && field.substr(0, equal) != "state"))
                continue;
            const auto node = nodes_.find(std::string(field.substr(equal + 1)));
            if (node != nodes_.end()) found = node->second;
        }
        if (found == nullptr) throw Undecided(fmt::format("the code is in no state at the end of a cycle ({})", state));
        return found;
    }

    std::map<std::string, const ir::Node*> nodes_;
    std::vector<const ir::Node*> states_;
};

// ---------------------------------------------------------------- the search

/// A state of the monitor, with the inputs that have been read for the next cycle.
struct Followed {
    MonitorState monitor;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> read;  ///< registers with their readings, ascending
    bool begun = false;                                         ///< the inputs of this cycle have been observed
    std::uint32_t tocks = 0;

    friend auto operator<=>(const Followed&, const Followed&) = default;
};

class Sink final : public lts::SuccessorSink {
public:
    struct Move {
        lts::Event event, revealed;
        std::vector<lts::Word> target;
    };
    void add(lts::Event event, lts::StateView target, lts::Event revealed) override {
        moves.push_back({event, revealed, {target.begin(), target.end()}});
    }
    std::vector<Move> moves;
};

/// Searches the product of a system and a monitor in breadth-first order.
class Product {
public:
    Product(lts::TransitionSystem& system, const CheckedClaim& claim, const Alphabet& alphabet,
            std::uint32_t cycle_length, FactsOf facts)
        : system_(system),
          alphabet_(alphabet),
          claim_(claim),
          monitor_(claim),
          channels_(claim, alphabet),
          cycle_length_(cycle_length),
          facts_(std::move(facts)) {}

    CycleAnswer search(const refine::Limits& limits, std::optional<std::int64_t> unit) {
        refine::Budget budget(limits);
        CycleAnswer result;
        std::vector<lts::Word> first(system_.width());
        system_.initial(first);
        add(first, Followed{monitor_.begin(), {}, false, 0}, none, process::tau);
        for (std::size_t at = 0; at < nodes_.size(); ++at) {
            budget.states(nodes_.size());
            if (const auto event = broken_from(at)) {
                result.outcome = Outcome::differs;
                tell(result, at, *event, unit);
                return result;
            }
        }
        result.outcome = Outcome::conforms;
        return result;
    }
    [[nodiscard]] bool asked() const { return asked_; }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    struct Node {
        std::size_t state = 0, followed = 0;
        std::size_t from = none;
        process::Event event = process::tau;
    };

    std::size_t number(const std::vector<lts::Word>& state) {
        const auto [known, fresh] = states_.try_emplace(state, listed_.size());
        if (fresh) listed_.push_back(&known->first);
        return known->second;
    }
    void add(const std::vector<lts::Word>& state, Followed followed, std::size_t from, process::Event event) {
        if (followed.monitor.phase == claims::Phase::inside) asked_ = true;
        const std::size_t number_of_state = number(state);
        const auto [known, fresh] = followed_.try_emplace(std::move(followed), listed_followed_.size());
        if (fresh) listed_followed_.push_back(&known->first);
        if (!seen_.insert({number_of_state, known->second}).second) return;
        nodes_.push_back({number_of_state, known->second, from, event});
    }

    /// Adds the successors. Returns the event that violates the claim, if there is one.
    std::optional<process::Event> broken_from(std::size_t at) {
        const Node node = nodes_[at];
        Sink sink;
        system_.successors(*listed_[node.state], sink);
        for (const Sink::Move& move : sink.moves) {
            Followed next = *listed_followed_[node.followed];
            follow(next, move.event, *listed_[node.state]);
            if (next.monitor.verdict == claims::Verdict::broken) return move.event;
            add(move.target, std::move(next), at, move.event);
        }
        return std::nullopt;
    }

    void begin(Followed& followed) const {
        if (followed.begun) return;
        followed.begun = true;
        const std::vector<Occurrence> raised = raised_events(std::exchange(followed.read, {}));
        for (const Occurrence& event : monitor_.order_raised(followed.monitor, raised))
            monitor_.observe(followed.monitor, event);
    }

    /// Returns which events of the claim the inputs of a cycle raise. Omits inputs that a declared order drops.
    [[nodiscard]] std::vector<Occurrence> raised_events(
        const std::vector<std::pair<std::uint32_t, std::uint32_t>>& read) const {
        std::vector<bool> raised(alphabet_.interface().inputs.size());
        for (const auto& [input, reading] : read) raised[input] = true;
        drop_raised(raised, alphabet_.interface().drops);
        std::vector<Occurrence> result;
        for (const auto& [input, reading] : read)
            if (const auto occurrence = channels_.raised(input, reading); occurrence && raised[input])
                result.push_back(*occurrence);
        std::ranges::sort(result);
        return result;
    }
    [[nodiscard]] bool matters(std::uint32_t input) const {
        return channels_.knows(input) ||
               std::ranges::any_of(alphabet_.interface().drops, [&](const DroppedInput& drop) {
                   return drop.event == input || drop.dropped == input;
               });
    }

    void follow(Followed& followed, process::Event event, lts::StateView state) const {
        const CycleRole role = alphabet_.cycle_role(event);
        switch (role.kind) {
            case CycleRole::Kind::read:
                if (role.reading == 0) return;
                if (matters(role.index)) followed.read.emplace_back(role.index, role.reading);
                std::ranges::sort(followed.read);
                return;
            case CycleRole::Kind::write:
                begin(followed);
                if (const auto occurrence = channels_.written(event)) monitor_.observe(followed.monitor, *occurrence);
                return;
            case CycleRole::Kind::tock:
                begin(followed);
                if (claim_.body.condition && followed.monitor.phase == claims::Phase::inside)
                    monitor_.observe(followed.monitor, facts_(state));
                if (followed.monitor.verdict == claims::Verdict::open) monitor_.tock(followed.monitor);
                if (++followed.tocks < cycle_length_) return;
                followed.tocks = 0;
                followed.begun = false;
                return;
            case CycleRole::Kind::tick:
                begin(followed);
                monitor_.end(followed.monitor);
                return;
            case CycleRole::Kind::other:
                return;
        }
    }

    /// Stores in the result the run that leads to a node, followed by one more event.
    void tell(CycleAnswer& result, std::size_t at, process::Event last, std::optional<std::int64_t> unit) const {
        std::vector<process::Event> events{last};
        for (std::size_t node = at; nodes_[node].from != none; node = nodes_[node].from)
            events.push_back(nodes_[node].event);
        std::ranges::reverse(events);
        claims::Account account(claim_, unit);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> read;
        std::map<Occurrence, std::string> texts;
        bool begun = false;
        std::uint32_t tocks = 0;
        result.cycles.emplace_back();
        const auto begin_account = [&] {
            if (begun) return;
            begun = true;
            const std::vector<Occurrence> raised = raised_events(std::exchange(read, {}));
            for (const Occurrence& occurrence : monitor_.order_raised(account.state(), raised))
                account.observe(occurrence, texts.at(occurrence));
        };
        for (std::size_t i = 0; i < events.size(); ++i) {
            const process::Event event = events[i];
            const CycleRole role = alphabet_.cycle_role(event);
            const std::string text = alphabet_.describe_event(event);
            if (role.kind == CycleRole::Kind::read && role.reading != 0) {
                result.cycles.back().inputs.push_back(text);
                read.emplace_back(role.index, role.reading);
                if (auto occurrence = channels_.raised(role.index, role.reading)) texts[*occurrence] = text;
            } else if (role.kind == CycleRole::Kind::write) {
                begin_account();
                result.cycles.back().outputs.push_back(text);
                if (const auto occurrence = channels_.written(event)) account.observe(*occurrence, text);
            } else if (role.kind == CycleRole::Kind::tick) {
                begin_account();
                account.end();
            } else if (role.kind == CycleRole::Kind::tock) {
                begin_account();
                if (claim_.body.condition && i + 1 == events.size())
                    account.observe(facts_(*listed_[nodes_[at].state]));
                account.tock();
                if (++tocks < cycle_length_) continue;
                tocks = 0;
                begun = false;
                if (i + 1 < events.size()) result.cycles.emplace_back();
            }
        }
        result.reason = fmt::format("{}", fmt::join(account.reasons(), "; "));
    }

    lts::TransitionSystem& system_;
    const Alphabet& alphabet_;
    const CheckedClaim& claim_;
    Monitor monitor_;
    ClaimChannels channels_;
    std::uint32_t cycle_length_;
    FactsOf facts_;
    std::map<std::vector<lts::Word>, std::size_t> states_;
    std::vector<const std::vector<lts::Word>*> listed_;
    std::map<Followed, std::size_t> followed_;
    std::vector<const Followed*> listed_followed_;
    std::set<std::pair<std::size_t, std::size_t>> seen_;
    std::vector<Node> nodes_;
    bool asked_ = false;
};

/// Runs a search. The answer is inconclusive if the search reaches a limit or cannot decide.
template <class Search>
CycleAnswer answer(const Search& search) {
    CycleAnswer result;
    try {
        return search();
    } catch (const Undecided& undecided) {
        result.reason = undecided.what();
    } catch (const process::Interrupted& limit) {
        result.reason = limit.what();
    } catch (const claims::NotComputable& error) {
        result.reason = error.what();
    } catch (const std::length_error& limit) {
        result.reason = limit.what();
    }
    return result;
}

}  // namespace

bool reads_values(const CheckedClaim& claim) {
    const auto conditional = [](const claims::Events& events) {
        return std::ranges::any_of(events.any,
                                   [](const claims::EventMatch& match) { return match.condition.has_value(); });
    };
    return !claim.remembered.empty() || conditional(claim.scope.first) || conditional(claim.scope.last) ||
           conditional(claim.body.events) || conditional(claim.body.others) || conditional(claim.body.exceptions);
}

std::vector<CycleAnswers> decide_cycle_claims(const CycleClaims& claims, const ClaimedModel& claimed, ModelGraph& model,
                                              const Alphabet& alphabet, const rc_interface& code,
                                              std::uint32_t cycle_length, const refine::Limits& limits) {
    std::vector<CycleAnswers> result;
    for (const CheckedClaim& claim : claims.claims) {
        CycleAnswers& answers = result.emplace_back();
        answers.claim = claim.name;
        answers.wording = claim.wording;
        answers.span = claim.span;
        if (const auto refused = claims.refused.find(claim.name); refused != claims.refused.end()) {
            answers.model.reason = answers.code.reason = refused->second;
            continue;
        }
        if (reads_values(claim) && !claims.carriers) {
            answers.model.reason = answers.code.reason = "it compares values: `--concrete` decides it for the carriers";
            continue;
        }
        answers.model = answer([&] {
            const std::unique_ptr<CycleSystem> system = component_in_cycles(model, alphabet, cycle_length);
            return Product(*system, claim, alphabet, cycle_length, facts_of_model(claim, claimed, *system))
                .search(limits, claims.unit);
        });
        answers.code = answer([&] {
            const PlacesOfCode places(claim, claimed);
            CodeSystem system(code, alphabet, cycle_length);
            const auto facts = [&](lts::StateView state) { return places.facts_in(system.describe(state)); };
            Product product(system, claim, alphabet, cycle_length, facts);
            CycleAnswer found = product.search(limits, claims.unit);
            answers.asked = product.asked() || found.outcome != Outcome::conforms;
            return found;
        });
    }
    return result;
}

}  // namespace robochart::conformance
