// SPDX-License-Identifier: Apache-2.0
// See observers.hpp.
#include "prism/assertions/process/observers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "checker/cspm/syntax/build.hpp"
#include "prism/assertions/experiments/encoding.hpp"

namespace robochart::probability {
namespace {

namespace b = cspm::build;
using cspm::DeclKind;
using cspm::DeclPtr;

constexpr const char* process_name = "D__";
constexpr const char* parity_parameter = "observed_n__";
constexpr const char* value_parameter = "observed_x__";
constexpr const char* next_value_parameter = "observed_y__";

std::vector<std::string> parts_of(const std::string& path) {
    std::vector<std::string> result;
    std::size_t begin = 0;
    for (std::size_t at = path.find("::"); at != std::string::npos; at = path.find("::", begin)) {
        result.push_back(path.substr(begin, at - begin));
        begin = at + 2;
    }
    result.push_back(path.substr(begin));
    return result;
}

/// Returns the name that the event has in the script, without its component.
std::string name_in_script(const csp_emit::Provenance& provenance, const ObservedEvent& event) {
    const std::string direction = event.event.substr(event.event.find('.'));
    const std::string prefix = event.component + "::";
    for (const auto& [name, meaning] : provenance.events)
        if (name.starts_with(prefix) && name.ends_with(direction) &&
            name.find("::", prefix.size()) == std::string::npos && meaning.origin.span == event.origin.span)
            return name.substr(prefix.size());
    throw Wrong(fmt::format("the process of {} has no event {}", event.component, event.event));
}

class Observing {
public:
    Observing(const ObservedEvent& event, std::string channel, std::size_t number)
        : event_(event),
          channel_(std::move(channel)),
          known_(fmt::format("Observer{}__", number)),
          first_(fmt::format("FirstObserver{}__", number)) {}

    [[nodiscard]] std::vector<DeclPtr> add_to(const std::vector<DeclPtr>& decls, std::size_t depth = 0) {
        const std::vector<std::string> path = parts_of(event_.component);
        std::vector<DeclPtr> result = decls;
        for (DeclPtr& decl : result) {
            if (depth == path.size()) {
                if (decl->kind == DeclKind::function && decl->names.front() == process_name) observe_definition(decl);
            } else if (decl->kind == DeclKind::module && decl->names.front() == path[depth]) {
                cspm::Decl inner = *decl;
                inner.exports = add_to(decl->exports, depth + 1);
                inner.decls = add_to(decl->decls, depth + 1);
                decl = std::make_shared<const cspm::Decl>(std::move(inner));
            }
        }
        if (depth == path.size() && done_ && !declared_) declare_observer(result);
        return result;
    }

    [[nodiscard]] bool is_done() const { return done_; }

    void add_meaning(csp_emit::Provenance& provenance) const {
        csp_emit::DefinitionMeaning meaning;
        meaning.text = event_.event + " is observed";
        meaning.component = event_.name();
        meaning.parameters = {observed_parity};
        meaning.types = {ir::TypeId{}};
        meaning.kinds = {csp_emit::ParameterKind::variable};
        provenance.definitions[event_.component + "::" + first_] = meaning;
        meaning.parameters.emplace_back(observed_value);
        meaning.types.push_back(event_.type);
        meaning.kinds.push_back(csp_emit::ParameterKind::variable);
        provenance.definitions[event_.component + "::" + known_] = meaning;
    }

private:
    /// Returns the channel, for example "e.in", as an expression of the script.
    [[nodiscard]] cspm::ExprPtr channel_expression() const {
        const std::size_t dot = channel_.find('.');
        return b::dot({b::name(channel_.substr(0, dot)), b::name(channel_.substr(dot + 1))});
    }

    /// Puts the observer in parallel with the component in the component's definition.
    void observe_definition(DeclPtr& decl) {
        cspm::Decl made = *decl;
        const cspm::ExprPtr observer = b::call(first_, {b::number(0)});
        const cspm::ExprPtr end = b::productions({b::name("terminate")});
        if (event_.module) {
            const cspm::ExprPtr ending = b::sequential({decl->body, end_of_module()});
            made.body = b::hide(
                b::parallel(ending, b::productions({channel_expression(), b::name("terminate")}), observer), end);
        } else {
            made.body =
                b::exception(b::parallel(decl->body, b::productions({channel_expression()}), observer), end, b::skip());
        }
        decl = std::make_shared<const cspm::Decl>(std::move(made));
        done_ = true;
    }

    static cspm::ExprPtr end_of_module() { return b::prefix(b::name("terminate"), b::skip()); }
    [[nodiscard]] cspm::ExprPtr or_end(const cspm::ExprPtr& step) const {
        return event_.module ? b::choice({step, end_of_module()}) : step;
    }

    void declare_observer(std::vector<DeclPtr>& decls) {
        declared_ = true;
        const cspm::ExprPtr other = b::binary(cspm::ExprKind::minus, b::number(1), b::name(parity_parameter));
        if (event_.type.is_valid()) {
            const auto step = [&] {
                return or_end(b::prefix(channel_expression(), {b::input(next_value_parameter)},
                                        b::call(known_, {other, b::name(next_value_parameter)})));
            };
            decls.push_back(b::function_decl(first_, b::variables({parity_parameter}), step()));
            decls.push_back(b::function_decl(known_, b::variables({parity_parameter, value_parameter}), step()));
            return;
        }
        std::vector<cspm::Field> any;
        if (event_.valued) any.push_back(b::input(b::wildcard()));
        decls.push_back(b::function_decl(first_, b::variables({parity_parameter}),
                                         or_end(b::prefix(channel_expression(), any, b::call(first_, {other})))));
    }

    const ObservedEvent& event_;
    const std::string channel_;
    const std::string known_, first_;  ///< definitions: after the first event, and before it
    bool done_ = false, declared_ = false;
};

}  // namespace

void add_observers(csp_emit::Emission& emission, const std::vector<ObservedEvent>& events) {
    for (std::size_t i = 0; i < events.size(); ++i) {
        Observing observing(events[i], name_in_script(emission.provenance, events[i]), i);
        emission.script.decls = observing.add_to(emission.script.decls);
        if (!observing.is_done()) throw Wrong(fmt::format("{} has no separate process", events[i].component));
        observing.add_meaning(emission.provenance);
    }
}

}  // namespace robochart::probability
