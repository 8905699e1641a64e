// What controllers and modules share: parts side by side, connected events synchronised, writes of shared variables
// propagated (semantics 3.7, 3.9).
#pragma once

#include <map>
#include <set>

#include "csp_emit/base/component.hpp"
#include "csp_emit/base/names.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// One machine of a controller, or one controller of a module.
struct Part {
    std::string name;  ///< of its CSPM module
    ComponentEmission emission;
    std::vector<std::string> events;     ///< all of its events
    std::vector<std::string> variables;  ///< required: it has set_x and set_EXT_x
    std::vector<std::string> calls;      ///< operations that remain events
    std::vector<std::string> arguments;  ///< for its constants, in order: parameters of the composition
};

/// A variable that the composition declares or requires.
struct SharedVariable {
    std::string name;
    ir::TypeId type;
    bool required = false;  ///< written from outside: set_EXT_x of the composition
    bool visible = false;   ///< writes stay visible
    cspm::ExprPtr pushed;   ///< initial value that is propagated to the parts at the start
};

/// An asynchronous connection between parts: a buffer of one place that the newest value overwrites.
struct Buffer {
    std::size_t from = 0, to = 0;
    std::string from_event, to_event;
    ir::TypeId type;  ///< invalid: without value
};

struct Composition {
    const Project* project = nullptr;
    std::vector<Part> parts;
    std::vector<SharedVariable> variables;
    std::vector<ConstantParameter> constants;
    std::vector<Buffer> buffers;
    bool hides_termination = false;  ///< modules

    /// Renamings of each part's events, in order; targets by event.
    struct Target {
        std::string channel;   ///< "f", "stm0::x"
        bool swapped = false;  ///< in becomes out
    };
    std::map<std::pair<std::size_t, std::string>, std::vector<Target>> targets;
    /// Events of two parts that are connected: synchronised and hidden; named as the first part's.
    std::vector<std::tuple<std::size_t, std::size_t, std::string>> joined;
};

/// Records a connection: `(part or none, event)` at each end; none is the composition itself.
void connect(Composition&, std::optional<std::size_t> from, const std::string& from_event,
             std::optional<std::size_t> to, const std::string& to_event);
/// Whether a part is too large to be compressed on its own: then the whole is.
[[nodiscard]] bool large(const Composition&);
/// Memory, buffers and the process variants.
void define_composition(const Composition&, std::vector<cspm::DeclPtr>& decls);

}  // namespace robochart::csp_emit
