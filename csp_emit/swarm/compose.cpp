// SPDX-License-Identifier: Apache-2.0
#include "csp_emit/swarm/compose.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/spelling.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "csp_emit/swarm/conditions.hpp"
#include "csp_emit/swarm/rules.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {
namespace {

using frontend::Word;

/// An event or call that a component shows to its platform.
struct Port {
    std::string channel;  ///< "P::M::e.in", "P::M::opCall"
    MeaningKind kind = MeaningKind::step;
    std::vector<ir::TypeId> types;
};

/// Returns all ports of a component by the names of their channels in it: "e.in", "opCall", "set_x".
std::map<std::string, Port> ports_of(const Provenance& provenance, const std::string& path) {
    const std::string prefix = path + "::";
    std::map<std::string, Port> ports;
    for (const auto& [event, meaning] : provenance.events) {
        if (!event.starts_with(prefix)) continue;
        const std::string name = event.substr(prefix.size());
        if (name.find("::") != std::string::npos) continue;
        const bool port = meaning.kind == MeaningKind::trigger || meaning.kind == MeaningKind::output ||
                          meaning.kind == MeaningKind::call || meaning.kind == MeaningKind::assignment ||
                          meaning.kind == MeaningKind::external_write;
        if (port) ports[name] = {event, meaning.kind, meaning.types};
    }
    return ports;
}

/// Returns the component that a name in a swarm denotes: "P::M", or "M" if it is unique.
const ComponentProcesses* component_named(const Emission& emission, const std::string& name) {
    const ComponentProcesses* found = nullptr;
    for (const ComponentProcesses& component : emission.components) {
        if (component.path == name) return &component;
        if (!component.path.ends_with("::" + name)) continue;
        if (found != nullptr) return nullptr;
        found = &component;
    }
    return found;
}

/// Writes the text of the swarm's module.
class SwarmModule {
public:
    SwarmModule(const Emission& emission, const Swarm& swarm, Time time, const ir::System& system,
                const ir::Instantiation& instantiation, diagnostics::Diagnostics& diagnostics)
        : emission_(emission),
          swarm_(swarm),
          timed_(time == Time::timed),
          system_(system),
          instantiation_(instantiation),
          diagnostics_(diagnostics) {}

    /// Returns the module's text. If an element of the swarm does not match the component, reports this and returns "".
    std::string module_text() {
        component_ = component_named(emission_, swarm_.component.text);
        if (component_ == nullptr) {
            std::vector<std::string> known;
            for (const ComponentProcesses& component : emission_.components) known.push_back(component.path);
            report_unknown("the model", "component", swarm_.component, known);
            return "";
        }
        if (swarm_.grid && !timed_) {
            report_unfit(swarm_.name, "robots move only while time passes, so a grid has no untimed semantics");
            return "";
        }
        ports_ = ports_of(emission_.provenance, component_->path);
        bind_ports();
        if (!diagnostics_.ok()) return "";
        return write_module();
    }

    /// Describes how to find the robot that performs an event of the module.
    [[nodiscard]] CopiesMeaning meaning_of_copies() const {
        CopiesMeaning result{swarm_.robots, "robot", {}};
        const auto add = [&](const std::string& channel, const std::string& words) {
            result.channels["Swarm__::" + channel] = words;
        };
        add("acts", "acts");
        for (const auto& [operation, channel] : operations_) add(channel, "calls " + operation);
        for (std::size_t k = 0; k < swarm_.feeds.size(); ++k)
            add(fmt::format("feed_{}", k + 1), "reads " + swarm_.feeds[k].event.text);
        for (std::size_t k = 0; k < messages_.size(); ++k)
            add(messages_[k].channel, "sends " + swarm_.connections[k].from.text);
        if (!swarm_.grid) return result;
        add("go", "drives one cell");
        add("stay", "");
        return result;
    }

private:
    // ------------------------------------------------------------ bindings

    void report_unknown(const std::string& where, const std::string& what, const Word& word,
                        const std::vector<std::string>& known) {
        const std::string meant = diagnostics::nearest_spelling(word.text, known);
        diagnostics_.report(swarm_rules::unknown_name, word.span,
                            {where, what, word.text, meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant)});
    }
    void report_unfit(const Word& word, const std::string& why) {
        diagnostics_.report(swarm_rules::no_fit, word.span, {why});
    }

    /// Returns the port with this name whose channel ends in `ending`. If there is none, reports this and returns null.
    const Port* find_port(const Word& word, const std::string& ending, const char* what) {
        if (const auto found = ports_.find(word.text + ending); found != ports_.end()) return &found->second;
        std::vector<std::string> known;
        for (const auto& [name, port] : ports_)
            if (name.ends_with(ending)) known.push_back(name.substr(0, name.size() - ending.size()));
        report_unknown(swarm_.component.text, what, word, known);
        return nullptr;
    }
    /// Returns the channel for an operation, which all uses of the operation in the swarm share.
    std::string operation_channel(const Word& word) {
        const auto known = operations_.find(word.text);
        if (known != operations_.end()) return known->second;
        const Port* const call = find_port(word, "Call", "operation");
        if (call == nullptr) return "";
        const std::string channel = fmt::format("operation_{}", operations_.size() + 1);
        const bool turns = std::ranges::any_of(swarm_.drives, [&](const SwarmDrive& drive) {
            return drive.motion == SwarmMotion::turn && drive.operation.text == word.text;
        });
        channels_ += fmt::format("channel {} : Robots{}\n", channel, turns ? ".Headings" : "");
        const std::int64_t scale = turns ? scale_of(*call) : 1;
        if (scale == 0)
            report_unfit(
                word, fmt::format("'{}' needs exactly one number as its argument, the angle of the turn", word.text));
        add_renaming(*call, channel + ".i__" + (turns ? fmt::format(".steps(a__,{})", scale) : ""));
        operations_[word.text] = channel;
        own_.push_back(channel);
        return channel;
    }
    /// Returns the number that represents one degree in the only argument, or 0 if the call does not have exactly one
    /// number.
    [[nodiscard]] std::int64_t scale_of(const Port& call) const {
        if (call.types.size() != 1) return 0;
        const ir::TypeKind kind = system_.type(call.types.front()).kind;
        if (kind == ir::TypeKind::nat || kind == ir::TypeKind::integer) return 1;
        return kind == ir::TypeKind::real ? instantiation_.scale : 0;
    }
    /// Renames all events of the port to `target`, in which a__ is their value.
    void add_renaming(const Port& port, const std::string& target) {
        used_.insert(port.channel);
        renamings_ += port.types.empty()
                          ? fmt::format("\n[[ {} <- {} ]]", port.channel, target)
                          : fmt::format("\n[[ {0}.a__ <- {1} | a__ <- extensions({0}) ]]", port.channel, target);
    }

    void bind_ports() {
        for (const SwarmDrive& drive : swarm_.drives) {
            if (!swarm_.grid) report_unfit(drive.operation, "without a grid nothing drives");
            const std::string channel = operation_channel(drive.operation);
            if (!channel.empty() && !driven_.emplace(channel, drive.motion).second)
                report_unfit(drive.operation, fmt::format("'{}' drives twice", drive.operation.text));
        }
        for (const SwarmFeed& feed : swarm_.feeds) bind_ports(feed);
        for (const SwarmConnection& connection : swarm_.connections) bind_ports(connection);
        for (const SwarmConstant& constant : swarm_.constants)
            if (constant.value.empty()) set_robot_number(constant);
        bind_remaining();
    }

    bool check_unused(const Word& word, const Port& port) {
        if (!used_.contains(port.channel)) return true;
        report_unfit(word, fmt::format("'{}' is fed or connected twice", word.text));
        return false;
    }

    void bind_ports(const SwarmFeed& feed) {
        const Port* const event = find_port(feed.event, ".in", "event that it receives");
        if (event == nullptr || !check_unused(feed.event, *event)) return;
        const std::string channel = fmt::format("feed_{}", ++feeds_);
        const bool near = feed.reading == SwarmReading::count || feed.reading == SwarmReading::near;
        if (near)
            add_sensing(feed, *event, channel);
        else
            add_signal(feed, *event, channel);
        own_.push_back(channel);
        if (near && swarm_.grid) sensed_.push_back({channel, feed.distance});
        if (!feed.on) return;
        const std::string request = operation_channel(*feed.on);
        if (!request.empty()) answers_.push_back({request, channel});
    }
    void add_sensing(const SwarmFeed& feed, const Port& event, const std::string& channel) {
        channels_ += fmt::format("channel {} : Robots.Set(Robots)\n", channel);
        used_.insert(event.channel);
        std::string value;
        std::string condition;
        const ir::TypeKind kind = event.types.size() == 1 ? system_.type(event.types.front()).kind : ir::TypeKind::unit;
        if (feed.reading == SwarmReading::count) {
            if (kind != ir::TypeKind::nat && kind != ir::TypeKind::integer)
                return report_unfit(feed.event, fmt::format("'{}' carries no whole number", feed.event.text));
            const auto& carrier = kind == ir::TypeKind::nat ? instantiation_.nat : instantiation_.integer;
            if (carrier.empty() || carrier.back() + 1 < swarm_.robots)
                return report_unfit(
                    feed.event, fmt::format("{} robots hear up to {}, and the model calculates up to {}: give "
                                            "it more with `range`, or with --range",
                                            swarm_.robots, swarm_.robots - 1, carrier.empty() ? 0 : carrier.back()));
            value = ".card(s__)";
        } else if (kind == ir::TypeKind::boolean) {
            value = ".not empty(s__)";
        } else if (event.types.empty()) {
            condition = ", not empty(s__)";
        } else {
            return report_unfit(feed.event, fmt::format("'{}' carries a value that is not a boolean", feed.event.text));
        }
        if (value == ".not empty(s__)") value = ".(not empty(s__))";
        renamings_ += fmt::format("\n[[ {}{} <- {}.i__.s__ | s__ <- Set(others(i__)){} ]]", event.channel, value,
                                  channel, condition);
    }
    void add_signal(const SwarmFeed& feed, const Port& event, const std::string& channel) {
        channels_ += fmt::format("channel {} : Robots\n", channel);
        if (feed.reading == SwarmReading::turned) {
            if (!event.types.empty()) report_unfit(feed.event, fmt::format("'{}' carries a value", feed.event.text));
            if (!swarm_.grid) report_unfit(feed.event, "without a grid nothing turns");
            settled_.push_back(channel);
        } else {
            lazy_.push_back(channel);
        }
        add_renaming(event, channel + ".i__");
    }

    void bind_ports(const SwarmConnection& connection) {
        const Port* const from = find_port(connection.from, ".out", "event that it sends");
        const Port* const to = find_port(connection.to, ".in", "event that it receives");
        if (from == nullptr || to == nullptr || !check_unused(connection.from, *from) ||
            !check_unused(connection.to, *to))
            return;
        if (from->types.size() != to->types.size() || from->types.size() > 1 ||
            (!from->types.empty() && from->types.front().index != to->types.front().index))
            return report_unfit(connection.to, "the types of the sent and the received event differ");
        if (connection.distance > 0 && !swarm_.grid)
            return report_unfit(connection.from, "only robots on a grid have distances");
        used_.insert(from->channel);
        used_.insert(to->channel);
        const std::string channel = fmt::format("message_{}", messages_.size() + 1);
        const bool value = !from->types.empty();
        channels_ += fmt::format("channel {} : Robots.Set(Robots){}\n", channel,
                                 value ? fmt::format(".{{v__ | v__ <- extensions({})}}", from->channel) : "");
        const std::string values = value ? fmt::format(", v__ <- extensions({})", from->channel) : "";
        renamings_ += fmt::format("\n[[ {0}{1} <- {2}.i__.s__{1} | s__ <- Set(others(i__)){3} ]]", from->channel,
                                  value ? ".v__" : "", channel, values);
        renamings_ += fmt::format(
            "\n[[ {0}{1} <- {2}.j__.s__{1} | j__ <- others(i__), s__ <- Set(others(j__)), member(i__,s__){3} ]]",
            to->channel, value ? ".v__" : "", channel, values);
        messages_.push_back({channel, connection.distance});
    }

    /// Returns the constants that the component's process takes as parameters, by their names in the model.
    [[nodiscard]] std::vector<ir::NamedConstant> parameter_constants() const {
        std::set<std::string> arguments;
        for (const cspm::ExprPtr& argument : component_->compressed->args)
            if (argument->kind == cspm::ExprKind::name) arguments.insert(argument->text);
        std::vector<ir::NamedConstant> result = ir::named_constants(system_);
        std::erase_if(result, [&](const ir::NamedConstant& constant) { return !arguments.contains(constant.name); });
        return result;
    }
    /// Sets the constant to the robot's number in the arguments of the process.
    void set_robot_number(const SwarmConstant& constant) {
        const std::string& name = constant.name.text;
        const std::vector<ir::NamedConstant> all = parameter_constants();
        std::vector<ir::NamedConstant> meant;
        std::vector<std::string> known;
        for (const ir::NamedConstant& candidate : all) {
            if (ir::is_named_by(candidate.path, name)) meant.push_back(candidate);
            if (!candidate.has_value) known.push_back(candidate.path.substr(candidate.path.rfind(':') + 1));
        }
        if (meant.empty()) return report_unknown(swarm_.component.text, "constant that is open", constant.name, known);
        if (meant.size() > 1) {
            std::vector<std::string> paths;
            for (const ir::NamedConstant& candidate : meant) paths.push_back(candidate.path);
            return report_unfit(
                constant.name, fmt::format("'{}' may be any of {}: write a longer path", name, fmt::join(paths, ", ")));
        }
        if (meant.front().has_value)
            return report_unfit(constant.name, fmt::format("the model gives '{}' a value", name));
        const std::string value = own_number(meant.front().type);
        if (value.empty())
            return report_unfit(constant.name,
                                fmt::format("'{}' is of a type that has no numbers from 0 to {}: give it more "
                                            "values with `range`, or with --range",
                                            name, swarm_.robots - 1));
        numbered_[meant.front().name] = value;
    }
    /// Returns the number of robot i__ as a value of this type, or "" if the type does not have a value for each robot.
    [[nodiscard]] std::string own_number(ir::TypeId type) const {
        const auto has_all = [&](const std::vector<std::int64_t>& carrier, std::int64_t scale) {
            for (std::int64_t robot = 0; robot < swarm_.robots; ++robot)
                if (!std::ranges::binary_search(carrier, robot * scale)) return false;
            return true;
        };
        const ir::TypeKind kind = system_.type(type).kind;
        if (kind == ir::TypeKind::nat) return has_all(instantiation_.nat, 1) ? "i__" : "";
        if (kind == ir::TypeKind::integer) return has_all(instantiation_.integer, 1) ? "i__" : "";
        if (kind == ir::TypeKind::real && has_all(instantiation_.real, instantiation_.scale))
            return fmt::format("(i__ * {})", instantiation_.scale);
        if (kind == ir::TypeKind::given && instantiation_.given_size >= swarm_.robots) return "i__";
        return "";
    }

    /// Handles ports that are not bound. Their outputs and calls are possible at any time, and their inputs never
    /// arrive.
    void bind_remaining() {
        std::vector<std::string> never;
        for (const auto& [name, port] : ports_) {
            if (used_.contains(port.channel)) continue;
            if (port.kind == MeaningKind::trigger || port.kind == MeaningKind::external_write)
                never.push_back(port.channel);
            else
                add_renaming(port, "acts.i__");
        }
        if (!never.empty()) blocked_ = fmt::format("\n[| {{| {} |}} |] STOP", fmt::join(never, ", "));
    }

    // ------------------------------------------------------------ the text

    [[nodiscard]] std::string robot_process() const {
        std::vector<std::string> arguments;
        const cspm::Expr& call = *component_->compressed;
        std::string function;
        for (const cspm::ExprPtr& argument : call.args) {
            const auto numbered =
                argument->kind == cspm::ExprKind::name ? numbered_.find(argument->text) : numbered_.end();
            const std::string text = numbered != numbered_.end() ? numbered->second : cspm::print(argument);
            if (function.empty())
                function = text;
            else
                arguments.push_back(text);
        }
        return arguments.empty() ? function : fmt::format("{}({})", function, fmt::join(arguments, ", "));
    }

    static std::string productions_of(const std::vector<std::string>& channels) {
        return channels.empty() ? "{}" : fmt::format("{{| {} |}}", fmt::join(channels, ", "));
    }
    static std::vector<std::string> of_robot(const std::vector<std::string>& channels, const char* robot) {
        std::vector<std::string> result;
        for (const std::string& channel : channels) result.push_back(channel + "." + robot);
        return result;
    }

    std::string write_module() {
        std::string text = "module Swarm__\nexports\n";
        text += fmt::format("Robots = {{0..{}}}\nHeadings = {{0..{}}}\n", swarm_.robots - 1, swarm_.headings - 1);
        text +=
            "Pairs = {(i__,j__) | i__ <- Robots, j__ <- Robots, i__ < j__}\nothers(i__) = diff(Robots,{i__})\n"
            "channel acts : Robots\n";
        text +=
            "joined(a__,s__) =\n"
            "let more__ = union(a__, union({j__ | (i__,j__) <- s__, member(i__,a__)}, {i__ | (i__,j__) <- s__, "
            "member(j__,a__)}))\nwithin if more__ == a__ then a__ == Robots else joined(more__,s__)\n";
        text += channels_ + turns_text() + robots_text();
        for (std::size_t k = 0; k < swarm_.claims.size(); ++k)
            if (swarm_.claims[k].question != SwarmQuestion::deadlock_free)
                observations_.emplace_back(swarm_.claims[k].condition, fmt::format("observe_{}", k + 1));
        for (const Observation& observation : observations_) text += observation.channel_declaration();
        text += world_text();
        text += processes_text();
        return text + "endmodule\n";
    }

    /// Returns the heading that is nearest to an angle in units of 1/s__ of a degree.
    [[nodiscard]] std::string turns_text() const {
        if (!swarm_.grid) return "";
        return fmt::format(
            "steps(a__,s__) = let step__ = {0} * s__\nround__ = {1} * step__\n"
            "within (((a__ + step__ / 2) % round__ + round__) % round__) / step__\n",
            360 / swarm_.headings, swarm_.headings);
    }

    [[nodiscard]] std::string robots_text() const {
        std::vector<std::string> alphabet = of_robot(own_, "i__");
        alphabet.push_back("acts.i__");
        if (timed_) alphabet.push_back("tock");
        std::string events = productions_of(alphabet);
        for (const Sensed& message : messages_)
            events = fmt::format(
                "union({0}, union({{| {1}.i__ |}}, {{| {1}.j__.s__ | j__ <- others(i__), s__ <- Set(others(j__)), "
                "member(i__,s__) |}}))",
                events, message.channel);
        // in the timed semantics these events are not hidden, because the observer of activity needs them
        std::vector<std::string> own{"acts.i__"};
        for (const std::string& channel : lazy_) own.push_back(channel + ".i__");
        return fmt::format("Robot(i__) = dbisim((({}{}){}){})\nAllRobots = || i__ : Robots @ [ {} ] Robot(i__)\n",
                           robot_process(), blocked_, renamings_, timed_ ? std::string() : " \\ " + productions_of(own),
                           events);
    }

    // A part of the world with the events on which it synchronises.
    struct WorldPart {
        std::string process;
        std::string alphabet;
    };

    std::string world_text() {
        std::string text;
        std::vector<WorldPart> parts;
        if (swarm_.grid) {
            text += grid_text();
            parts.push_back({"Bodies", bodies_alphabet()});
            if (swarm_.robots > 1) parts.push_back({"AllPairs", pairs_alphabet()});
            parts.push_back({"Still", phase_alphabet()});
            if (observes_away())
                parts.push_back({fmt::format("Way({},{})", place_of(0).x, place_of(0).y), way_alphabet()});
        }
        for (std::size_t k = 0; k < answers_.size(); ++k) {
            const auto& [request, answer] = answers_[k];
            text += fmt::format(
                "Asked_{0}(i__) = {1} -> Answer_{0}(i__)\n"
                "Answer_{0}(i__) = {2} -> Asked_{0}(i__) [] {1} -> Answer_{0}(i__)\n",
                k + 1, request + ".i__" + input_pattern(request), answer_event(answer));
            parts.push_back(
                {fmt::format("(||| i__ : Robots @ Asked_{}(i__))", k + 1), productions_of({request, answer})});
        }
        // A single robot has no receivers, so its messages are blocked.
        if (swarm_.robots == 1)
            for (const Sensed& message : messages_) parts.push_back({"STOP", productions_of({message.channel})});
        if (parts.empty()) return text + "World = SKIP\nshared = {}\n";
        std::string together = parts.front().process;
        std::string alphabet = parts.front().alphabet;
        for (std::size_t k = 1; k < parts.size(); ++k) {
            together = fmt::format("({} [ {} || {} ] {})", together, alphabet, parts[k].alphabet, parts[k].process);
            alphabet = fmt::format("union({}, {})", alphabet, parts[k].alphabet);
        }
        return text + fmt::format(
                          "World = {}\nshared = diff({}, {})\n", together, alphabet,
                          productions_of(swarm_.grid ? with_observations({"go", "stay"}) : std::vector<std::string>{}));
    }
    [[nodiscard]] std::string input_pattern(const std::string& channel) const {
        const auto found = driven_.find(channel);
        return found != driven_.end() && found->second == SwarmMotion::turn ? "?h__" : "";
    }
    [[nodiscard]] std::string answer_event(const std::string& channel) const {
        const bool set = channels_.find("channel " + channel + " : Robots.Set(Robots)") != std::string::npos;
        return channel + ".i__" + (set ? "?s__" : "");
    }
    [[nodiscard]] std::vector<std::string> with_observations(std::vector<std::string> channels) const {
        for (const Observation& observation : observations_) channels.push_back(observation.channel());
        return channels;
    }

    [[nodiscard]] bool observes_away() const {
        return std::ranges::any_of(observations_, [](const Observation& observation) {
            return observation.has_atom(SwarmCondition::Kind::away);
        });
    }

    [[nodiscard]] std::vector<std::string> driving_channels() const {
        std::vector<std::string> result = settled_;
        for (const auto& [channel, motion] : driven_) result.push_back(channel);
        return result;
    }
    [[nodiscard]] std::string bodies_alphabet() const {
        std::vector<std::string> channels = driving_channels();
        channels.insert(channels.end(), {"go", "stay", "tock"});
        return productions_of(channels);
    }
    [[nodiscard]] std::string pairs_alphabet() const {
        std::vector<std::string> channels{"go"};
        for (const Sensed& sensed : sensed_) channels.push_back(sensed.channel);
        for (const Sensed& message : messages_)
            if (message.distance > 0) channels.push_back(message.channel);
        for (const Observation& observation : observations_)
            if (observation.asks_pairs()) channels.push_back(observation.channel());
        return productions_of(channels);
    }
    [[nodiscard]] std::vector<std::string> phase_channels() const {
        std::vector<std::string> channels = driving_channels();
        for (const Sensed& sensed : sensed_) channels.push_back(sensed.channel);
        for (const Sensed& message : messages_) channels.push_back(message.channel);
        return with_observations(channels);
    }
    [[nodiscard]] std::string phase_alphabet() const {
        std::vector<std::string> channels = phase_channels();
        channels.insert(channels.end(), {"go", "stay", "tock"});
        return productions_of(channels);
    }
    [[nodiscard]] std::string way_alphabet() const {
        std::vector<std::string> channels{"go.0"};
        for (const Observation& observation : observations_)
            if (observation.has_atom(SwarmCondition::Kind::away)) channels.push_back(observation.channel());
        return productions_of(channels);
    }

    [[nodiscard]] SwarmPlace place_of(std::size_t robot) const {
        SwarmPlace result;
        if (!swarm_.places.empty()) result = swarm_.places[std::min(robot, swarm_.places.size() - 1)];
        result.x = wrap_around(result.x, swarm_.grid->width);
        result.y = wrap_around(result.y, swarm_.grid->height);
        return result;
    }
    static std::int64_t wrap_around(std::int64_t value, std::int64_t size) { return ((value % size) + size) % size; }

    [[nodiscard]] std::string grid_text() const {
        const bool four = swarm_.headings == 4;
        std::string text = fmt::format("columns = {}\nrows = {}\n", swarm_.grid->width, swarm_.grid->height);
        text += fmt::format("along_x = <{}>\nalong_y = <{}>\n", four ? "1,0,-1,0" : "1,1,0,-1,-1,-1,0,1",
                            four ? "0,1,0,-1" : "0,1,1,1,0,-1,-1,-1");
        text +=
            "chosen(<x__>^s__,n__) = if n__ == 0 then x__ else chosen(s__,n__-1)\n"
            "column(x__) = (x__ + columns) % columns\nrow(y__) = (y__ + rows) % rows\n"
            "shorter(x__,m__) = if x__ + x__ > m__ then m__ - x__ else x__\n"
            "near(x__,y__,d__) = shorter(x__,columns) <= d__ and shorter(y__,rows) <= d__\n"
            "channel go : Robots.Headings\nchannel stay : Robots\n";
        return text + bodies_text() + pairs_text() + phases_text() + (observes_away() ? way_text() : "");
    }

    /// Returns the process of a robot's body. m__: 0 standing, 1 driving, 2 turning until the next time unit has
    /// passed.
    [[nodiscard]] std::string bodies_text() const {
        std::string text = "Body(i__,h__,m__) =\n";
        for (const auto& [channel, motion] : driven_) {
            if (motion == SwarmMotion::turn)
                text += fmt::format("{}.i__?a__ -> Body(i__,(h__ + a__) % {},2)\n[] ", channel, swarm_.headings);
            else
                text += fmt::format("{}.i__ -> Body(i__,h__,{})\n[] ", channel, motion == SwarmMotion::forward ? 1 : 0);
        }
        for (const std::string& channel : settled_)
            text += fmt::format("m__ != 2 & {}.i__ -> Body(i__,h__,m__)\n[] ", channel);
        text +=
            "m__ == 1 & go.i__.h__ -> Body(i__,h__,m__)\n[] m__ != 1 & stay.i__ -> Body(i__,h__,0)\n"
            "[] tock -> Body(i__,h__,m__)\n";
        for (std::uint32_t robot = 0; robot < swarm_.robots; ++robot) {
            const SwarmPlace at = place_of(robot);
            if (at.degrees)
                text += fmt::format("Start({0}) = Body({0},steps({1},1),0)\n", robot, *at.degrees);
            else
                text += fmt::format("Start({0}) = |~| h__ : Headings @ Body({0},h__,0)\n", robot);
        }
        const std::string alphabet = productions_of([&] {
            std::vector<std::string> channels = of_robot(driving_channels(), "i__");
            channels.insert(channels.end(), {"go.i__", "stay.i__", "tock"});
            return channels;
        }());
        return text + fmt::format("Bodies = || i__ : Robots @ [ {} ] Start(i__)\n", alphabet);
    }

    /// Returns the process for robots i__ < j__ that stores the position of j__ relative to i__.
    [[nodiscard]] std::string pairs_text() const {
        if (swarm_.robots == 1) return "";
        std::string text =
            "Pair(i__,j__,x__,y__) =\n"
            "go.i__?h__ -> Pair(i__,j__,column(x__-chosen(along_x,h__)),row(y__-chosen(along_y,h__)))\n"
            "[] go.j__?h__ -> Pair(i__,j__,column(x__+chosen(along_x,h__)),row(y__+chosen(along_y,h__)))\n";
        std::vector<std::string> alphabet{"go.i__", "go.j__"};
        for (const Sensed& sensed : sensed_)
            for (const auto& [robot, other] : {std::pair{"i__", "j__"}, std::pair{"j__", "i__"}}) {
                text += fmt::format(
                    "[] {0}.{1}?s__:{{s__ | s__ <- Set(others({1})), member({2},s__) == near(x__,y__,{3})}} -> "
                    "Pair(i__,j__,x__,y__)\n",
                    sensed.channel, robot, other, sensed.distance);
                alphabet.push_back(sensed.channel + "." + robot);
            }
        for (const Sensed& message : messages_) {
            if (message.distance == 0) continue;
            const bool carries =
                channels_.find("channel " + message.channel + " : Robots.Set(Robots).") != std::string::npos;
            const std::string value = carries ? "?v__" : "";
            for (const auto& [robot, other] : {std::pair{"i__", "j__"}, std::pair{"j__", "i__"}}) {
                text += fmt::format(
                    "[] {0}.{1}?s__:{{s__ | s__ <- Set(others({1})), not member({2},s__) or near(x__,y__,{3})}}{4} -> "
                    "Pair(i__,j__,x__,y__)\n",
                    message.channel, robot, other, message.distance, value);
                alphabet.push_back(message.channel + "." + robot);
            }
        }
        for (const Observation& observation : observations_) {
            if (!observation.asks_pairs()) continue;
            text += "[] " + observation.seen_by_pair() + " -> Pair(i__,j__,x__,y__)\n";
            alphabet.push_back(observation.channel());
        }
        text += fmt::format("pair_events(i__,j__) = {}\n", productions_of(alphabet));
        std::string together;
        std::string events;
        for (std::uint32_t i = 0; i < swarm_.robots; ++i)
            for (std::uint32_t j = i + 1; j < swarm_.robots; ++j) {
                const std::string one = fmt::format("Pair({},{},{},{})", i, j,
                                                    wrap_around(place_of(j).x - place_of(i).x, swarm_.grid->width),
                                                    wrap_around(place_of(j).y - place_of(i).y, swarm_.grid->height));
                const std::string own = fmt::format("pair_events({},{})", i, j);
                together = together.empty() ? one : fmt::format("({} [ {} || {} ] {})", together, events, own, one);
                events = events.empty() ? own : fmt::format("union({}, {})", events, own);
            }
        return text + fmt::format("AllPairs = {}\n", together);
    }

    /// Returns the process that lets all robots move after each tock. No other event happens in between.
    [[nodiscard]] std::string phases_text() const {
        const std::vector<std::string> channels = phase_channels();
        std::string text = "Still = tock -> Moving(0)";
        if (!channels.empty()) text += fmt::format(" [] ([] e__ : {} @ e__ -> Still)", productions_of(channels));
        return text +
               "\nMoving(i__) = if member(i__,Robots) then (go.i__?h__ -> Moving(i__+1) [] stay.i__ -> Moving(i__+1)) "
               "else Still\n";
    }

    /// Returns the process that stores the position of robot 0.
    [[nodiscard]] std::string way_text() const {
        std::string text =
            "Way(x__,y__) = go.0?h__ -> Way(column(x__+chosen(along_x,h__)),row(y__+chosen(along_y,h__)))\n";
        const SwarmPlace from = place_of(0);
        for (const Observation& observation : observations_)
            if (observation.has_atom(SwarmCondition::Kind::away))
                text += "[] " + observation.seen_on_way(from.x, from.y) + " -> Way(x__,y__)\n";
        return text;
    }

    [[nodiscard]] std::string processes_text() const {
        std::vector<std::string> hidden = own_;
        std::erase_if(hidden,
                      [&](const std::string& channel) { return std::ranges::find(lazy_, channel) != lazy_.end(); });
        for (const Sensed& message : messages_) hidden.push_back(message.channel);
        std::vector<std::string> moves;
        if (swarm_.grid) moves = {"go", "stay"};
        std::string text = "Together = AllRobots [| shared |] World\n";
        const auto without = [&](const std::string& allowed_channel) {
            std::vector<std::string> others;
            for (const Observation& observation : observations_)
                if (observation.channel() != allowed_channel) others.push_back(observation.channel());
            return others.empty() ? std::string("Together")
                                  : fmt::format("(Together [| {} |] STOP)", productions_of(others));
        };
        hidden.push_back("acts");
        if (!timed_)
            text +=
                fmt::format("Acting = ({} \\ {}) \\ {}\n", without(""), productions_of(hidden), productions_of(lazy_));
        if (timed_) text += activity_text(without(""), hidden, moves);
        hidden.insert(hidden.end(), moves.begin(), moves.end());
        if (timed_)
            text += fmt::format("Alone = prioritise({} \\ {}, <{{}}, {{tock}}>)\nPassing = Alone \\ {}\n", without(""),
                                productions_of(hidden), productions_of(lazy_));
        for (const Observation& observation : observations_) {
            text += fmt::format("Seen_{0} = prioritise({1} \\ {2}, <{{}}, {{tock}}>) \\ {3}\n", observation.channel(),
                                without(observation.channel()), productions_of(hidden), productions_of(lazy_));
            text += observation.define_meaning();
        }
        return text;
    }

    /// Returns the process that performs the event `active` if a robot has acted since the last tock.
    [[nodiscard]] std::string activity_text(const std::string& together, std::vector<std::string> done,
                                            const std::vector<std::string>& moves) const {
        std::vector<std::string> hidden = done;
        hidden.insert(hidden.end(), moves.begin(), moves.end());
        done.insert(done.end(), lazy_.begin(), lazy_.end());
        return fmt::format(
            "channel active\n"
            "Quiet = tock -> Quiet [] ([] e__ : {0} @ e__ -> Busy)\n"
            "Busy = tock -> Quiet [] active -> Busy [] ([] e__ : {0} @ e__ -> Busy)\n"
            "Watched = prioritise(({1} [| union({0}, {{tock}}) |] Quiet) \\ {2}, <{{}}, {{tock}}>) \\ {3}\n",
            productions_of(done), together, productions_of(hidden), productions_of(lazy_));
    }

    struct Sensed {
        std::string channel;
        std::uint32_t distance = 0;
    };

    const Emission& emission_;
    const Swarm& swarm_;
    bool timed_;
    const ir::System& system_;
    const ir::Instantiation& instantiation_;
    diagnostics::Diagnostics& diagnostics_;
    const ComponentProcesses* component_ = nullptr;
    std::map<std::string, Port> ports_;
    std::map<std::string, std::string> operations_;  // the channels of operations, by name
    std::map<std::string, SwarmMotion> driven_;      // the motions, by channel
    std::size_t feeds_ = 0;
    std::vector<std::string> own_;                              // channels between one robot and its world
    std::vector<std::string> settled_;                          // channels of own_ that report that no turn is in
                                                                // progress
    std::vector<std::string> lazy_;                             // channels of own_ that the environment decides
    std::vector<Sensed> sensed_;                                // on a grid: they carry the set of robots in range
    std::vector<std::pair<std::string, std::string>> answers_;  // requesting operation, answering event
    std::vector<Sensed> messages_;
    std::set<std::string> used_;                   // channels of the component that are renamed
    std::map<std::string, std::string> numbered_;  // arguments that are the robot's number, and their text
    std::vector<Observation> observations_;
    std::string channels_, renamings_, blocked_;
};

std::string assertion_text(const SwarmClaim& claim, std::size_t number, bool timed) {
    switch (claim.question) {
        case SwarmQuestion::deadlock_free:
            return timed ? "" : "assert Swarm__::Acting :[deadlock free [F]]\n";
        case SwarmQuestion::always:
            return fmt::format("assert STOP [T= Swarm__::Seen_observe_{0} |\\ Swarm__::fails_observe_{0}\n", number);
        case SwarmQuestion::possible:
            return fmt::format("assert not STOP [T= Swarm__::Seen_observe_{0} |\\ Swarm__::holds_observe_{0}\n",
                               number);
        case SwarmQuestion::recurrent:
            break;
    }
    return "";
}

/// Returns the title of a claim in reports.
std::string title_of(const Swarm& swarm, const SwarmClaim& claim) {
    const std::string where = swarm.grid ? fmt::format("{} by {}", swarm.grid->width, swarm.grid->height) : "no grid";
    return fmt::format("{}: {} [{} robot{}, {}]", swarm.name.text, claim.text, swarm.robots,
                       swarm.robots == 1 ? "" : "s", where);
}

/// Returns the premise of claims about all states: from every reachable state of the swarm some run leads to a state in
/// which time passes. Then every run can be extended to a run in which time passes infinitely often, so every state
/// belongs to a run that is possible in reality (non-Zeno: Henzinger, Nicollin, Sifakis and Yovine, Symbolic model
/// checking for real-time systems, 1994). If the environment makes decisions, the passing of time must not depend on
/// them. The claim `waits` states this.
std::shared_ptr<const Premise> time_can_pass(std::vector<cspm::DeclPtr> waits) {
    const cspm::ExprPtr tock = cspm::build::productions({cspm::build::name("tock")});
    return std::make_shared<const Premise>(
        Premise{std::move(waits), RecurrenceQuestion{cspm::build::name("Swarm__::Passing"), tock},
                "time can always pass", "time can stop", "from here on no time passes"});
}

bool has_premise(const SwarmClaim& claim) {
    return claim.question != SwarmQuestion::possible;
}

Obligation obligation_of(const Swarm& swarm, const SwarmClaim& claim, std::size_t number, Time time) {
    Obligation result;
    result.title = title_of(swarm, claim);
    result.name = claim.text;
    result.origin.span = claim.span;
    result.time = time;
    switch (claim.question) {
        case SwarmQuestion::deadlock_free:
            if (time == Time::untimed) break;
            result.reason = "from here on no robot does anything but let time pass";
            result.recurrence = RecurrenceQuestion{cspm::build::name("Swarm__::Watched"),
                                                   cspm::build::productions({cspm::build::name("Swarm__::active")})};
            break;
        case SwarmQuestion::always:
            result.kind = ir::PropertyKind::refines;
            result.reason = "here the condition does not hold";
            break;
        case SwarmQuestion::possible:
            result.kind = ir::PropertyKind::refines;
            result.reason = "no run leads to where this holds";
            break;
        case SwarmQuestion::recurrent:
            result.kind = ir::PropertyKind::refines;
            result.reason = "from here on it can never hold again";
            result.recurrence = RecurrenceQuestion{cspm::build::name(fmt::format("Swarm__::Seen_observe_{}", number)),
                                                   cspm::build::name(fmt::format("Swarm__::holds_observe_{}", number))};
            break;
    }
    return result;
}

/// Returns the assertion with the claim as a comment above it, as reports print it.
cspm::DeclPtr with_title(const cspm::DeclPtr& assertion, const std::string& title) {
    cspm::Decl result = *assertion;
    result.comment = diagnostics::escape_for_display(title);
    return std::make_shared<const cspm::Decl>(std::move(result));
}

}  // namespace

void make_swarm(Emission& emission, const Swarm& swarm, Time time, const ir::System& system,
                const ir::Instantiation& instantiation, diagnostics::SourceManager& sources,
                diagnostics::Diagnostics& diagnostics) {
    SwarmModule composed(emission, swarm, time, system, instantiation, diagnostics);
    const std::string module = composed.module_text();
    emission.script = emission.definitions;
    emission.obligations.clear();
    if (module.empty()) return;
    emission.provenance.copies = composed.meaning_of_copies();
    const auto read = [&](const std::string& name, const std::string& text, const std::string& title = "") {
        cspm::Script script = cspm::read(sources, sources.add(name, text), diagnostics);
        if (!title.empty())
            for (cspm::DeclPtr& decl : script.decls) decl = with_title(decl, title);
        emission.script.decls.insert(emission.script.decls.end(), script.decls.begin(), script.decls.end());
        return script.decls;
    };
    (void)read("the swarm's CSP", module);
    const bool premise = time == Time::timed && std::ranges::any_of(swarm.claims, has_premise);
    const bool waits =
        std::ranges::any_of(swarm.feeds, [](const SwarmFeed& feed) { return feed.reading == SwarmReading::any; });
    std::shared_ptr<const Premise> passing;
    if (premise)
        passing = time_can_pass(waits ? read("the swarm's time",
                                             "assert RUN({tock}) ||| CHAOS(diff(Events,{|tock|})) [F= Swarm__::Alone\n",
                                             "time can pass when the environment does nothing")
                                      : std::vector<cspm::DeclPtr>{});
    for (std::size_t k = 0; k < swarm.claims.size(); ++k) {
        Obligation one = obligation_of(swarm, swarm.claims[k], k + 1, time);
        if (swarm.claims[k].question != SwarmQuestion::deadlock_free) {
            emission.provenance.events[fmt::format("Swarm__::observe_{}", k + 1)].text =
                "where the robots are is looked at";
        }
        if (has_premise(swarm.claims[k])) one.premise = passing;
        const std::string text = assertion_text(swarm.claims[k], k + 1, time == Time::timed);
        if (!text.empty()) one.assertions = read("the swarm's claims", text, one.title);
        emission.obligations.push_back(std::move(one));
    }
}

}  // namespace robochart::csp_emit
