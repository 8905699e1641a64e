// SPDX-License-Identifier: Apache-2.0
// Emits what controllers and modules have in common: parts in parallel, synchronisation on connected events, and
// propagation of writes to shared variables (semantics 3.7, 3.9).
#pragma once

#include <map>
#include <set>

#include "csp_emit/base/component.hpp"
#include "csp_emit/base/names.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// One machine of a controller, or one controller of a module.
struct Part {
    std::string name;  ///< name of its CSPM module
    ComponentEmission emission;
    std::vector<std::string> events;     ///< all events of the part
    std::vector<std::string> variables;  ///< required variables, which have channels set_x and set_EXT_x
    std::vector<std::string> calls;      ///< operations whose calls remain events
    std::vector<std::string> arguments;  ///< values of its constants, in order; parameters of the composition
};

/// A variable that the composition declares or requires.
struct SharedVariable {
    std::string name;
    ir::TypeId type;
    bool required = false;  ///< other components can write the variable, through set_EXT_x of the composition
    bool visible = false;   ///< writes of the variable remain visible outside the composition
    cspm::ExprPtr pushed;   ///< initial value that is propagated to the parts at the start
};

/// An asynchronous connection between parts. It is a buffer with one place, in which a new value replaces the old one.
struct Buffer {
    std::size_t from = 0, to = 0;
    std::string from_event, to_event;
    ir::TypeId type;  ///< invalid if the event carries no value
};

struct Composition {
    const Project* project = nullptr;
    std::vector<Part> parts;
    std::vector<SharedVariable> variables;
    std::vector<ConstantParameter> constants;
    std::vector<Buffer> buffers;
    bool hides_termination = false;  ///< true for modules

    /// The new name of an event of a part.
    struct Target {
        std::string channel;   ///< "f", "stm0::x"
        bool swapped = false;  ///< `in` becomes `out` and vice versa
    };
    std::map<std::pair<std::size_t, std::string>, std::vector<Target>> targets;
    /// Connected events of two parts. They are synchronised, hidden, and named as in the first part.
    std::vector<std::tuple<std::size_t, std::size_t, std::string>> joined;
};

/// Records a connection. Each end is an event of a part. If there is no part, it is an event of the composition
/// itself.
void connect_ends(Composition&, std::optional<std::size_t> from, const std::string& from_event,
                  std::optional<std::size_t> to, const std::string& to_event);
/// True if some part is too large to be compressed separately. The composition is then large too.
[[nodiscard]] bool is_large(const Composition&);
/// Defines the memory, the buffers and the process variants.
void define_composition(const Composition&, std::vector<cspm::DeclPtr>& decls);

}  // namespace robochart::csp_emit
