// SPDX-License-Identifier: Apache-2.0
// Collects the places in a model that hold data, and groups them into flow classes. Private to this component. Two
// places belong to one flow class if the model may copy a value from one to the other: by an assignment, a
// communication, a call, a connection, a register or a shared variable (docs/data.md, "Flow classes").
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// The number of a place: a variable, the value of an event, or a parameter of an operation.
using PlaceId = std::uint32_t;

/// A place that holds values.
struct Place {
    TypeId type;
    std::string name;               ///< its name in the model
    bool input = false;             ///< the value of an event that a component receives
    bool shared = false;            ///< a shared variable, a parameter of an operation with a body, or a register
    bool opaque = false;            ///< values are copied to a place of another type, or initialised outside machines
    bool internal = false;          ///< one component sends the values to another
    bool variable = false;          ///< false for events and for parameters of called operations
    std::uint32_t machine = no_id;  ///< the machine that has the place; no_id: a controller or a platform
};

/// All places of a system, divided into flow classes.
class Places {
public:
    explicit Places(const System& system);

    [[nodiscard]] PlaceId variable(MachineId machine, VariableId id) const {
        return machines_[machine.index].variables + id.index;
    }
    /// Returns the place of an event's value, or no_id if the event has none.
    [[nodiscard]] PlaceId event(MachineId machine, EventId id) const {
        return machines_[machine.index].events[id.index];
    }
    /// Returns the place of a parameter of an operation that the machine calls.
    [[nodiscard]] PlaceId parameter(MachineId machine, OperationId id, std::size_t position) const {
        return machines_[machine.index].operations[id.index] + static_cast<PlaceId>(position);
    }
    /// Returns the place of the value that the transition's trigger receives, or no_id if there is none.
    [[nodiscard]] PlaceId trigger(MachineId machine, const Transition& transition) const {
        return transition.trigger ? event(machine, transition.trigger->event) : no_id;
    }
    /// Returns the place of the variable if the expression is a variable, and `trigger` if it is the value that the
    /// trigger has received. Returns no_id for all other expressions.
    [[nodiscard]] PlaceId read_by(MachineId machine, PlaceId trigger, const Expr& expr) const {
        if (expr.kind == ExprKind::variable) return variable(machine, expr.variable);
        return expr.kind == ExprKind::trigger_value ? trigger : no_id;
    }
    [[nodiscard]] std::size_t size() const { return places_.size(); }
    [[nodiscard]] const Place& operator[](PlaceId place) const { return places_[place]; }

    void unite(PlaceId a, PlaceId b);
    /// Returns the least place of the flow class.
    [[nodiscard]] PlaceId class_of(PlaceId place) const;

    /// Calls the function for the type of each place, in the order of the places.
    static void visit_types(System& system, const std::function<void(TypeId&)>& visit);

private:
    struct MachinePlaces {
        PlaceId variables = 0;
        std::vector<PlaceId> events;      ///< by EventId; no_id: the event has no value
        std::vector<PlaceId> operations;  ///< by OperationId: the place of the first parameter
    };

    void number_places(const System& system);
    void unite_shared_names(const System& system);
    void unite_connections(const System& system);

    std::vector<Place> places_;
    std::vector<PlaceId> parents_;
    std::vector<MachinePlaces> machines_, controllers_, platforms_;
};

}  // namespace robochart::ir
