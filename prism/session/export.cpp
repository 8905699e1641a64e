// SPDX-License-Identifier: Apache-2.0
// See export.hpp.
#include "prism/session/export.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <vector>

#include "base/diagnostics/escape.hpp"

namespace robochart::prism {
namespace {

std::string probability(const markov::Model& chain, std::uint64_t branch) {
    const std::uint32_t index = chain.number[branch];
    if (!chain.exact.empty()) return fmt::format("{}", chain.exact[index].convert_to<double>());
    return fmt::format("{}", Enclosure{chain.numbers[index].low, chain.numbers[index].high}.middle());
}

/// Calls `visit` with the state, the choice as an index in the state, the choice as an index in the model, and the
/// branch.
template <class Visit>
void for_each_branch(const markov::Model& chain, const Visit& visit) {
    for (std::size_t state = 0; state < chain.states(); ++state)
        for (std::uint32_t choice = chain.first_choice[state]; choice < chain.first_choice[state + 1]; ++choice)
            for (std::uint64_t i = chain.first_branch[choice]; i < chain.first_branch[choice + 1]; ++i)
                visit(state, choice - chain.first_choice[state], choice, i);
}

const std::string& action_of(const markov::Model& chain, std::uint32_t choice) {
    return chain.actions[chain.action[choice]];
}

}  // namespace

void export_transitions(const StateSpace& space, const TextSink& sink) {
    const markov::Model& chain = space.chain();
    const bool mdp = chain.kind == markov::Kind::mdp;
    sink(mdp ? fmt::format("{} {} {}\n", chain.states(), chain.choices(), chain.target.size())
             : fmt::format("{} {}\n", chain.states(), chain.target.size()));
    for_each_branch(chain, [&](std::size_t state, std::uint32_t number, std::uint32_t choice, std::uint64_t branch) {
        std::string line = fmt::format("{} ", state);
        if (mdp) line += fmt::format("{} ", number);
        line += fmt::format("{} {}", chain.target[branch], probability(chain, branch));
        if (mdp && !action_of(chain, choice).empty()) line += " " + action_of(chain, choice);
        sink(line + "\n");
    });
}

void export_states(const StateSpace& space, const TextSink& sink) {
    const auto& fields = space.layout().fields();
    std::string names;
    for (const Layout::Field& field : fields) names += (names.empty() ? "" : ",") + field.name;
    sink("(" + names + ")\n");
    std::vector<std::int32_t> values(fields.size());
    for (markov::State state = 0; state < space.chain().states(); ++state) {
        space.unpack(state, values.data());
        std::string line;
        for (std::size_t i = 0; i < fields.size(); ++i) {
            std::string value;
            if (fields[i].type == Type::boolean)
                value = values[i] != 0 ? "true" : "false";
            else
                value = fmt::format("{}", values[i]);
            line += (i == 0 ? "" : ",") + value;
        }
        sink(fmt::format("{}:({})\n", state, line));
    }
}

void export_labels(const StateSpace& space, const TextSink& sink) {
    std::string head = "0=\"init\" 1=\"deadlock\"";
    Code code = space.code({});
    markov::StateSet initial(space.chain().states());
    for (const markov::State state : space.chain().initial) initial[state] = true;
    std::vector<markov::StateSet> sets{initial, space.deadlocks()};
    for (const Definition& label : space.model().labels) {
        head += fmt::format(" {}=\"{}\"", sets.size(), label.name.text);
        const Code::Root root = code.compile(label.body);
        sets.push_back(space.states_satisfying(code, root));
    }
    sink(head + "\n");
    for (std::size_t state = 0; state < space.chain().states(); ++state) {
        std::string line;
        for (std::size_t i = 0; i < sets.size(); ++i)
            if (sets[i][state]) line += fmt::format(" {}", i);
        if (!line.empty()) sink(fmt::format("{}:{}\n", state, line));
    }
}

void export_graph(const StateSpace& space, const TextSink& sink) {
    const markov::Model& chain = space.chain();
    const bool mdp = chain.kind == markov::Kind::mdp;
    sink("digraph model {\n  node [shape=box];\n");
    for (markov::State state = 0; state < chain.states(); ++state)
        sink(fmt::format("  {} [label=\"{}\"];\n", state, diagnostics::label_text(space.state_text(state))));
    std::uint32_t last = ~0U;
    for_each_branch(chain, [&](std::size_t state, std::uint32_t number, std::uint32_t choice, std::uint64_t branch) {
        const std::string from = mdp ? fmt::format("c{}", choice) : fmt::format("{}", state);
        if (mdp && choice != last) {
            sink(fmt::format("  c{} [shape=point];\n  {} -> c{} [label=\"{}\", arrowhead=none];\n", choice, state,
                             choice, diagnostics::label_text(action_of(chain, choice))));
            last = choice;
        }
        (void)number;
        sink(fmt::format("  {} -> {} [label=\"{}\"];\n", from, chain.target[branch], probability(chain, branch)));
    });
    sink("}\n");
}

void export_strategy(const StateSpace& space, const std::vector<std::uint32_t>& choices,
                     const diagnostics::SourceManager& sources, const TextSink& sink) {
    const markov::Model& chain = space.chain();
    MoveReader reader(space);
    std::vector<markov::State> reached = chain.initial;
    markov::StateSet seen(chain.states());
    for (const markov::State state : reached) seen[state] = true;
    for (std::size_t next = 0; next < reached.size(); ++next) {
        const markov::State state = reached[next];
        const std::uint32_t choice = choices[state];
        if (chain.first_choice[state + 1] - chain.first_choice[state] > 1)
            sink(fmt::format("{}: {}\n", space.state_text(state), text_of(reader.list_moves(state, choice), sources)));
        for (std::uint64_t i = chain.first_branch[choice]; i < chain.first_branch[choice + 1]; ++i) {
            const markov::State target = chain.target[i];
            if (!seen[target]) reached.push_back(target);
            seen[target] = true;
        }
    }
}

void export_counterexample(const Counterexample& counterexample, const diagnostics::SourceManager& sources,
                           const TextSink& sink) {
    using diagnostics::label_text;
    std::map<std::string, std::size_t> numbers;
    const auto number = [&](const std::string& state) {
        return fmt::format("{}", numbers.emplace(state, numbers.size()).first->second);
    };
    std::set<std::string> nodes, edges, first, last;
    for (const ProbablePath& path : counterexample.paths) {
        std::string at = path.from;
        nodes.insert(fmt::format("  {} [label=\"{}\"];\n", number(at), label_text(at)));
        first.insert(fmt::format("  {} [style=bold];\n", number(at)));
        for (const ProbablePath::Step& step : path.steps) {
            nodes.insert(fmt::format("  {} [label=\"{}\"];\n", number(step.state), label_text(step.state)));
            edges.insert(fmt::format("  {} -> {} [label=\"{}\"];\n", number(at), number(step.state),
                                     label_text(text_of(step.by, sources))));
            at = step.state;
        }
        last.insert(fmt::format("  {} [peripheries=2];\n", number(at)));
    }
    sink("digraph counterexample {\n  node [shape=box];\n");
    for (const std::set<std::string>* lines : {&nodes, &edges, &first, &last})
        for (const std::string& line : *lines) sink(line);
    sink("}\n");
}

}  // namespace robochart::prism
