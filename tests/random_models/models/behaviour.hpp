// SPDX-License-Identifier: Apache-2.0
// Writes the machines and operations of random models: nodes, transitions, actions (private to the component).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/random_models/models/data.hpp"

namespace robochart::random_models {

/// An event of a component.
struct Port {
    std::string name;
    const DataType* type = nullptr;  ///< null if untyped
    bool receives = true;            ///< from the component's point of view; if false, it sends
    bool both_ways = false;          ///< whether it is connected by [mult]
    bool broadcast = false;
};

/// An operation that can be called.
struct Signature {
    std::string name;
    std::vector<const DataType*> parameters;
    std::string interface = {};  ///< the interface that declares it
};

/// A state that can be named in `sinceEntry`, with the transitions of the node that contains it.
struct Container {
    std::vector<std::string> states;
    std::vector<std::string> finals;
};

/// The names that actions of a machine or operation can use.
struct Surroundings {
    std::vector<Named> readable;
    std::vector<Named> writable;
    std::vector<Port> ports;
    std::vector<Signature> operations;
    std::vector<std::string> clocks;
    std::string chance = {};  ///< a constant that is a probability; "" if there is none
};

/// Collects indented lines.
class Lines {
public:
    explicit Lines(std::size_t depth = 0) : depth_(depth) {}
    void line(const std::string& text);
    void open(const std::string& head);
    void close();
    /// Adds the lines of another text with the current indentation.
    void embed(const std::string& text);
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::size_t depth_;
    std::string text_;
};

/// Writes statements, nodes and transitions.
class Behaviour {
public:
    Behaviour(Random& random, const Shape& shape, Names& names, Types& types, const Surroundings& around);

    /// Writes the nodes and transitions of a machine or operation. An operation has to end in a final state.
    void container(Lines& out, std::size_t depth, bool must_end);
    Expressions& expressions() { return expressions_; }

private:
    /// A transition that has not been written yet.
    struct Step {
        std::string from, to;
        std::string trigger, probability, condition, action;
        bool triggered = false;
    };
    struct Nodes {
        std::string initial;
        std::vector<std::string> states, junctions, finals;
        std::vector<std::string> probabilistic;
        std::vector<Step> steps;
    };

    // Statements (behaviour_statements.cpp).
    std::string action();
    std::string statement(std::size_t depth);
    std::string simple_statement();
    std::string assignment();
    std::string communication();
    std::string call();
    /// Returns the condition under which a communication on a broadcast event is accepted, `[| x = from | p |]`, or ""
    /// if it is always accepted.
    std::string filter(const Port& port, const std::string& peer);
    /// Returns the text of the variable that stores an input on the port, or "" if there is none. With reals in the
    /// shape, whole numbers are often received into variables of wider types.
    std::string stored_variable(const Port& port);
    /// Returns the text of the first variable with a suitable type, or "" if there is none.
    std::string first_variable(const std::function<bool(const DataType&)>& suits);
    std::string timed_statement();
    /// Returns a number of time units.
    std::string duration();
    /// Returns an assignable part of the variable, at any depth, with its type.
    Named part_of(Named whole);
    std::string conditional(std::size_t depth);
    std::string sequence(std::size_t depth);

    // Nodes (behaviour_nodes.cpp).
    Nodes plan(bool must_end);
    void plan_junctions(Nodes& nodes);
    std::vector<std::string> ways();
    std::vector<std::string> chances();
    void state(Lines& out, const std::string& name, std::size_t depth);
    void step(Lines& out, const Nodes& nodes, const Step& step);
    std::string target(const Nodes& nodes);
    std::string trigger();
    std::string condition(const Nodes& nodes);

    Random& random_;
    const Shape& shape_;
    Names& names_;
    Types& types_;
    const Surroundings& around_;
    Expressions expressions_;
    std::string inside_;  ///< the state whose nodes are being written, or "" for the machine
};

}  // namespace robochart::random_models
