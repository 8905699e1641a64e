// Walking and rebuilding configurations.
#include "csp_emit/machine/control_state.hpp"

#include <algorithm>

namespace robochart::csp_emit {
namespace {

void add_key(const Activation& activation, std::string& out);

void add_key(const Item& item, std::string& out) {
    out += std::to_string(static_cast<int>(item.kind)) + ":";
    if (item.stmt != nullptr) out += std::to_string(item.stmt->point);
    out += ":" + std::to_string(item.node.index) + ":" + std::to_string(item.variable.index);
    for (const CellId cell : item.cells) out += "," + std::to_string(cell);
}

void add_key(const Thread& thread, std::string& out) {
    out += "[";
    if (thread.callee) add_key(*thread.callee, out);
    for (const Link* link = thread.rest.get(); link != nullptr; link = link->tail.get()) {
        add_key(link->head, out);
        out += ";";
    }
    out += "]";
}

void add_key(const Activation& activation, std::string& out) {
    out += std::to_string(activation.frame) + "@" + std::to_string(activation.at.index) + "(";
    for (const ir::NodeId node : activation.entered) out += std::to_string(node.index) + " ";
    out += ")";
    add_key(activation.control, out);
    for (const During& during : activation.durings) {
        out += "|" + std::to_string(during.node.index);
        add_key(during.thread, out);
    }
    if (activation.clocks_read > 0) out += "#" + std::to_string(activation.clocks_read);
}

/// Shared, so that deep calls of operations do not copy the way back for every level.
using PutActivation = std::shared_ptr<const std::function<Activation(Activation)>>;
using PutThread = std::shared_ptr<const std::function<Activation(Thread)>>;

PutActivation put_activation(std::function<Activation(Activation)> put) {
    return std::make_shared<const std::function<Activation(Activation)>>(std::move(put));
}
PutThread put_thread(std::function<Activation(Thread)> put) {
    return std::make_shared<const std::function<Activation(Thread)>>(std::move(put));
}

/// `during`: it runs inside a during action, so other threads and transitions may act between any two of its steps.
void collect(const Activation& activation, bool during, const PutActivation& put, View& view);

void collect(const Thread& thread, const Activation& owner, bool during, const PutThread& put, View& view) {
    if (thread.done()) return;
    const auto back = [put](Thread changed) { return (*put)(std::move(changed)); };
    if (!thread.callee) {
        view.places.push_back({&thread, &owner, during, back});
        return;
    }
    view.calls.push_back({&thread, &owner, during, back});
    const Thread* outer = &thread;
    collect(*thread.callee, during, put_activation([outer, put](Activation inner) {
        return (*put)({outer->rest, std::make_shared<const Activation>(std::move(inner))});
    }),
            view);
}

void collect(const Activation& activation, bool during, const PutActivation& put, View& view) {
    const Activation* self = &activation;
    view.spots.push_back({self, [put](Activation changed) { return (*put)(std::move(changed)); }});
    collect(activation.control, activation, during, put_thread([self, put](Thread thread) {
                Activation changed = *self;
                changed.control = std::move(thread);
                return (*put)(std::move(changed));
            }),
            view);
    for (std::size_t i = 0; i < activation.durings.size(); ++i) {
        collect(activation.durings[i].thread, activation, true, put_thread([self, put, i](Thread thread) {
                    Activation changed = *self;
                    if (thread.done())
                        changed.durings.erase(changed.durings.begin() + static_cast<std::ptrdiff_t>(i));
                    else
                        changed.durings[i].thread = std::move(thread);
                    return (*put)(std::move(changed));
                }),
                view);
    }
}

}  // namespace

Program push(Item head, Program tail) {
    return std::make_shared<const Link>(Link{std::move(head), std::move(tail)});
}

std::string key(const Activation& activation) {
    std::string result;
    add_key(activation, result);
    return result;
}

View view(const Activation& config) {
    View result;
    collect(config, false, put_activation([](Activation changed) { return changed; }), result);
    return result;
}

}  // namespace robochart::csp_emit
