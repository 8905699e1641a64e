// See state_space.hpp.
#include "checker/prism/explore/state_space.hpp"

#include <fmt/format.h>

#include <map>

#include "checker/prism/explore/constants.hpp"
#include "checker/prism/explore/explorer.hpp"
#include "checker/prism/explore/rules.hpp"

namespace robochart::prism {
namespace {

Values values_of(const std::vector<Constant>& constants, const Values& given) {
    Values known;
    evaluate_constants(constants, given, known);
    return known;
}

Code code_for(const CheckedModel& model, const Values& constants) {
    std::map<std::string, std::uint32_t, std::less<>> variables;
    std::vector<Type> types;
    for (const Variable& each : model.variables) {
        variables.emplace(each.name.text, static_cast<std::uint32_t>(types.size()));
        types.push_back(each.type);
    }
    return {std::move(variables), std::move(types), constants};
}

Layout layout_of(const CheckedModel& model, const Values& constants) {
    Code code = code_for(model, constants);
    return {model.variables, code};
}

}  // namespace

StateSpace::StateSpace(const CheckedModel& model, const Values& constants, const ExploreOptions& options,
                       diagnostics::Diagnostics& diagnostics)
    : model_(model),
      options_(options),
      diagnostics_(diagnostics),
      constants_(values_of(model.constants, constants)),
      layout_(layout_of(model, constants_)),
      store_(layout_.words()) {
    Code code = code_for(model, constants_);
    Explorer explorer(*this, code);
    explorer();
}

StateSpace::StateSpace(const CheckedModel& model, const Values& constants, GivenSpace given,
                       const ExploreOptions& options, diagnostics::Diagnostics& diagnostics)
    : model_(model),
      options_(options),
      diagnostics_(diagnostics),
      constants_(values_of(model.constants, constants)),
      layout_(layout_of(model, constants_)),
      store_(layout_.words()),
      given_(true),
      chain_(std::move(given.chain)),
      deadlocks_(std::move(given.deadlocks)) {
    const std::size_t fields = layout_.fields().size();
    rows_.resize(chain_.states() * layout_.words());
    for (std::size_t state = 0; state < chain_.states(); ++state)
        layout_.pack(given.values.data() + state * fields, rows_.data() + state * layout_.words());
    for (const bool each : deadlocks_) deadlock_count_ += each ? 1 : 0;
}

std::string StateSpace::text(markov::State state) const {
    std::vector<std::int32_t> values(layout_.fields().size());
    unpack(state, values.data());
    return layout_.text(values.data());
}

Code StateSpace::code(const Values& more) const {
    Values all = constants_;
    for (const auto& [name, value] : more) all.insert_or_assign(name, value);
    return code_for(model_, all);
}

markov::StateSet StateSpace::satisfying(const Code& code, Code::Root root) const {
    markov::StateSet result(chain_.states());
    std::vector<std::int32_t> values(layout_.fields().size());
    for (markov::State state = 0; state < result.size(); ++state) {
        if (options_.budget != nullptr) options_.budget->poll();
        unpack(state, values.data());
        try {
            result[state] = code.holds(root, values.data());
        } catch (EvaluationError& error) {
            error.state = layout_.text(values.data());
            throw;
        }
    }
    return result;
}

}  // namespace robochart::prism
