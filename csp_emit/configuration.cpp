// Walking and rebuilding configurations.
#include "csp_emit/configuration.hpp"

#include <algorithm>

namespace robochart::csp_emit {
namespace {

std::string key(const Item& item) {
    std::string result = std::to_string(static_cast<int>(item.kind)) + ":";
    if (item.stmt != nullptr) result += std::to_string(item.stmt->point);
    result += ":" + std::to_string(item.node.index) + ":" + std::to_string(item.variable.index);
    for (const CellId cell : item.cells) result += "," + std::to_string(cell);
    return result;
}

std::string key(const Thread& thread) {
    std::string result = "[";
    if (thread.callee) result += key(*thread.callee);
    for (const Link* link = thread.rest.get(); link != nullptr; link = link->tail.get())
        result += key(link->head) + ";";
    return result + "]";
}

using PutActivation = std::function<Activation(Activation)>;
using PutThread = std::function<Activation(Thread)>;

/// `during`: it runs inside a during action, so other threads and transitions may act between any two of its steps.
void collect(const Activation& activation, bool during, const PutActivation& put, View& view);

void collect(const Thread& thread, const Activation& owner, bool during, const PutThread& put, View& view) {
    if (thread.done()) return;
    if (!thread.callee) {
        view.places.push_back({&thread, &owner, during, put});
        return;
    }
    view.calls.push_back({&thread, &owner, during, put});
    const Thread* outer = &thread;
    collect(
        *thread.callee, during,
        [outer, put](Activation inner) {
            return put({outer->rest, std::make_shared<const Activation>(std::move(inner))});
        },
        view);
}

void collect(const Activation& activation, bool during, const PutActivation& put, View& view) {
    const Activation* self = &activation;
    view.spots.push_back({self, put});
    collect(
        activation.control, activation, during,
        [self, put](Thread thread) {
            Activation changed = *self;
            changed.control = std::move(thread);
            return put(std::move(changed));
        },
        view);
    for (std::size_t i = 0; i < activation.durings.size(); ++i) {
        collect(
            activation.durings[i].thread, activation, true,
            [self, put, i](Thread thread) {
                Activation changed = *self;
                if (thread.done())
                    changed.durings.erase(changed.durings.begin() + static_cast<std::ptrdiff_t>(i));
                else
                    changed.durings[i].thread = std::move(thread);
                return put(std::move(changed));
            },
            view);
    }
}

}  // namespace

Program push(Item head, Program tail) {
    return std::make_shared<const Link>(Link{std::move(head), std::move(tail)});
}

std::string key(const Activation& activation) {
    std::string result = std::to_string(activation.frame) + "@" + std::to_string(activation.at.index) + "(";
    for (const ir::NodeId node : activation.entered) result += std::to_string(node.index) + " ";
    result += ")" + key(activation.control);
    for (const During& during : activation.durings)
        result += "|" + std::to_string(during.node.index) + key(during.thread);
    if (activation.clocks_read > 0) result += "#" + std::to_string(activation.clocks_read);
    return result;
}

View view(const Activation& config) {
    View result;
    collect(
        config, false, [](Activation changed) { return changed; }, result);
    return result;
}

}  // namespace robochart::csp_emit
