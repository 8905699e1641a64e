// SPDX-License-Identifier: Apache-2.0
// See experiment.hpp.
#include "prism/assertions/experiments/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "prism/assertions/experiments/path_words.hpp"
#include "prism/checks/check.hpp"
#include "prism/explore/constants.hpp"
#include "prism/explore/rules.hpp"
#include "prism/sampling/random_path.hpp"
#include "prism/sampling/unsampled.hpp"
#include "prism/session/experiment.hpp"
#include "prism/session/session.hpp"
#include "prism/session/simulation.hpp"

namespace robochart::probability {
namespace {

using prism::ExprPtr;
using prism::Op;

/// Returns the messages of all errors.
std::string error_messages(const diagnostics::Diagnostics& diagnostics) {
    std::string text;
    for (const diagnostics::Diagnostic& finding : diagnostics.sorted_findings())
        if (finding.rule->severity == diagnostics::Severity::error)
            text += (text.empty() ? "" : "; ") + finding.message();
    return text;
}

std::string error_message(const prism::EvaluationError& error) {
    diagnostics::Diagnostics one;
    error.report(one);
    std::string text = error_messages(one);
    if (!error.state.empty()) text += ", in the state " + error.state;
    if (error.is(prism::rules::out_of_range)) text += "; --range and --prefs set the ranges of nat, int and real";
    return text;
}

double approximate_value(const prism::Real& value) {
    return value.is_exact() ? value.value().convert_to<double>() : value.bounds().middle();
}

/// True if the question asks for a number without naming a scheduler.
bool open_question(const prism::Expr& expr) {
    return (expr.op == Op::probability || expr.op == Op::reward) && expr.query->bound == nullptr &&
           expr.query->optimum == prism::Optimum::none;
}

ExprPtr with_optimum(const ExprPtr& expr, prism::Optimum optimum) {
    prism::Expr copy = *expr;
    auto query = std::make_shared<prism::Query>(*expr->query);
    query->optimum = optimum;
    copy.query = std::move(query);
    return prism::make_expr(std::move(copy));
}

/// Returns the properties that answer a question: the question itself, or its minimum and its maximum.
std::vector<prism::Property> properties_of(const Question& question, bool one_value) {
    if (!open_question(*question.property)) return {{{}, question.property}};
    if (one_value) return {{{}, with_optimum(question.property, prism::Optimum::minimum)}};
    return {{{}, with_optimum(question.property, prism::Optimum::minimum)},
            {{}, with_optimum(question.property, prism::Optimum::maximum)}};
}

/// A setting with the PRISM name of its constant, and its values.
struct Given {
    const Setting* setting = nullptr;
    bool of_model = false;
    prism::Series series;
};

class Experiment {
public:
    Experiment(Encoding& encoding, const Question& question, const Deciding& how, diagnostics::Budget& budget)
        : encoding_(encoding), question_(question), how_(how), budget_(budget) {}

    void operator()(const std::function<void(Row)>& found) {
        for (const Setting& setting : question_.settings) read(setting);
        for (const prism::Values& of_model : value_combinations(true)) run_for_model(of_model, found);
    }

private:
    void read(const Setting& setting) {
        Given given{&setting, true, {}};
        prism::Constant constant;
        if (setting.path.empty()) {
            const auto own = [&](const prism::Constant& candidate) { return candidate.name.text == setting.constant; };
            const auto in_model = std::ranges::find_if(question_.model_constants, own);
            const auto in_property = std::ranges::find_if(question_.constants, own);
            given.of_model = in_model != question_.model_constants.end();
            if (!given.of_model && in_property == question_.constants.end()) return;  // the constant does not occur
            constant = given.of_model ? *in_model : *in_property;
        } else {
            constant = encoding_.prism_constant(setting.path);
        }
        given.series.name = constant.name.text;
        // Paths are not valid PRISM names, so the parser gets a simple one.
        constant.name.text = "c";
        for (const std::string& text : setting.values) {
            try {
                for (prism::Series& part : prism::read_series("c=" + text, {constant}))
                    for (prism::Value& value : part.values) given.series.values.push_back(std::move(value));
            } catch (const prism::BadValue& error) {
                throw Wrong(fmt::format("{}: {}", setting.name, error.what()));
            }
        }
        given_.push_back(std::move(given));
    }

    [[nodiscard]] std::vector<prism::Values> value_combinations(bool of_model) const {
        std::vector<prism::Series> series;
        for (const Given& given : given_)
            if (given.of_model == of_model) series.push_back(given.series);
        try {
            return prism::combinations(series);
        } catch (const prism::BadValue& error) {
            throw Wrong(error.what());
        }
    }

    [[nodiscard]] Row make_row(const prism::Values& of_model, const prism::Values& of_property) const {
        Row result;
        for (const Given& given : given_) {
            const prism::Values& values = given.of_model ? of_model : of_property;
            result.constants.emplace_back(given.setting->name, values.find(given.series.name)->second.text());
        }
        return result;
    }

    void run_for_model(const prism::Values& of_model, const std::function<void(Row)>& found) {
        const auto begin = std::chrono::steady_clock::now();
        const auto seconds = [&] {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        };
        const std::vector<prism::Values> of_property = value_combinations(false);
        const auto fail = [&](const std::string& error) {
            for (const prism::Values& constants : of_property) {
                Row one = make_row(of_model, constants);
                one.error = error;
                found(std::move(one));
            }
        };
        try {
            if (question_.path) {
                generate_paths(encoding_.unexplored_model(question_, of_model), of_model, of_property, found);
            } else if (!question_.simulation) {
                const prism::StateSpace& space = encoding_.explore_space(question_, of_model);
                decide_on_space(space, of_model, of_property, seconds(), found);
            } else {
                decide_by_paths(encoding_.unexplored_model(question_, of_model).instance, of_model, of_property, found);
            }
        } catch (const prism::EvaluationError& error) {
            fail(error_message(error));
        } catch (const Wrong& error) {
            fail(error.what());
        } catch (const diagnostics::LimitReached& limit) {
            budget_.check();  // passes the limits of the whole run on
            for (const prism::Values& constants : of_property) {
                Row one = make_row(of_model, constants);
                one.results.emplace_back().reason = limit.what();
                found(std::move(one));
            }
        }
    }

    void decide_on_space(const prism::StateSpace& space, const prism::Values& of_model,
                         const std::vector<prism::Values>& of_property, double exploring,
                         const std::function<void(Row)>& found) {
        const bool mdp = space.model().kind == prism::ModelKind::mdp;
        const prism::CheckedProperties checked =
            this->checked_properties(space.model(), mdp ? properties_of(question_, encoding_.one_value())
                                                        : std::vector<prism::Property>{{{}, question_.property}});
        prism::Session session(space, checked, {how_.relative, how_.exact, &budget_});
        for (const prism::Values& constants : of_property) {
            Row one = make_row(of_model, constants);
            one.states = space.chain().states();
            one.transitions = space.transitions();
            fill_row(one, checked.properties.size(), [&](std::size_t i) { return session.check(i, constants); });
            one.seconds += exploring;
            exploring = 0;  // counted once
            found(std::move(one));
        }
    }

    /// Answers the question by random paths. No states are explored.
    void decide_by_paths(const prism::Instance& instance, const prism::Values& of_model,
                         const std::vector<prism::Values>& of_property, const std::function<void(Row)>& found) {
        const prism::CheckedProperties checked = this->checked_properties(instance.model(), {{{}, question_.property}});
        diagnostics::Diagnostics findings;
        for (const prism::Values& constants : of_property) {
            Row one = make_row(of_model, constants);
            const prism::SamplingOptions options{sampling_method(constant_values(instance, checked, constants)),
                                                 how_.seed, how_.threads, &budget_};
            fill_row(one, 1, [&](std::size_t i) {
                return prism::simulate(instance, checked, i, constants, options, findings);
            });
            found(std::move(one));
        }
    }

    [[nodiscard]] prism::CheckedProperties checked_properties(const prism::CheckedModel& model,
                                                              std::vector<prism::Property> properties) const {
        diagnostics::Diagnostics findings;
        prism::PropertyFile file;
        file.constants = question_.constants;
        file.properties = std::move(properties);
        prism::CheckedProperties result = prism::check_properties(model, file, findings);
        if (!findings.ok()) throw Wrong(error_messages(findings));
        return result;
    }

    /// Returns the values of all constants.
    [[nodiscard]] static prism::Values constant_values(const prism::Instance& instance,
                                                       const prism::CheckedProperties& properties,
                                                       const prism::Values& constants) {
        prism::Values known = instance.constants();
        prism::evaluate_constants(properties.constants, constants, known);
        return known;
    }

    [[nodiscard]] prism::Method sampling_method(const prism::Values& numbers) const {
        std::string text = question_.simulation->method;
        for (const auto& [parameter, constant] : question_.simulation->parameters)
            text += fmt::format(",{}={}", parameter, approximate_value(numbers.find(constant)->second.real));
        try {
            return prism::read_method(text);
        } catch (const prism::BadMethod& error) {
            throw Wrong(fmt::format("`using sim with`: {}", error.what()));
        }
    }

    /// Generates a random path. If further attempts are requested, generates paths until one reaches a deadlock.
    void generate_paths(const Unexplored& model, const prism::Values& of_model,
                        const std::vector<prism::Values>& of_property, const std::function<void(Row)>& found) {
        const prism::CheckedProperties checked = this->checked_properties(model.instance.model(), {});
        for (const prism::Values& constants : of_property) {
            Row one = make_row(of_model, constants);
            generate_paths(model, constant_values(model.instance, checked, constants), one);
            found(std::move(one));
        }
    }

    void generate_paths(const Unexplored& model, const prism::Values& numbers, Row& one) const {
        constexpr std::uint64_t most_steps = 100'000;  // all steps are stored
        constexpr std::uint64_t usual_limit = 10'000;
        const Generation& generation = *question_.path;
        const bool to_deadlock = generation.steps.empty();
        std::uint64_t steps = generation.limit.empty() ? usual_limit : whole_constant(generation.limit, numbers);
        if (!to_deadlock) {
            const std::uint64_t requested = whole_constant(generation.steps, numbers);
            steps = generation.limit.empty() ? requested : std::min(requested, steps);
        }
        if (steps > most_steps) throw Wrong(fmt::format("a path has at most {} steps", most_steps));
        const std::uint64_t repeats = generation.repeats.empty() ? 0 : whole_constant(generation.repeats, numbers);
        try {
            prism::RandomPath path;
            for (std::uint64_t number = 0; number <= repeats && !(to_deadlock && path.deadlock); ++number)
                path = prism::random_path(model.instance, how_.seed, number, steps, &budget_);
            if (!to_deadlock || path.deadlock)
                one.path = in_words(path, model);
            else
                one.results.emplace_back().reason =
                    repeats == 0 ? fmt::format("a path of {} steps reaches no deadlock", steps)
                                 : fmt::format("none of {} paths of {} steps reaches a deadlock", repeats + 1, steps);
        } catch (const prism::Unsampled& why) {
            one.results.emplace_back().reason = why.what();
        }
    }

    /// Returns a number of steps or paths, which is the value of the constant with this name.
    static std::uint64_t whole_constant(const std::string& constant, const prism::Values& numbers) {
        const double value = approximate_value(numbers.find(constant)->second.real);
        constexpr double most = 1e15;
        if (value >= 0 && value <= most && value == std::floor(value)) return static_cast<std::uint64_t>(value);
        throw Wrong(fmt::format("{}: expected a whole number from 0 to {}", constant, most));
    }

    /// Stores the answers, or the evaluation error, and the time used.
    static void fill_row(Row& row, std::size_t count, const std::function<prism::Result(std::size_t)>& answer) {
        const auto begin = std::chrono::steady_clock::now();
        try {
            for (std::size_t i = 0; i < count; ++i) row.results.push_back(answer(i));
        } catch (const prism::EvaluationError& error) {
            row.results.clear();
            row.error = error_message(error);
        }
        row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }

    Encoding& encoding_;
    const Question& question_;
    const Deciding& how_;
    diagnostics::Budget& budget_;
    std::vector<Given> given_;
};

}  // namespace

void decide_question(Encoding& encoding, const Question& question, const Deciding& how, diagnostics::Budget& budget,
                     const std::function<void(Row)>& found) {
    Experiment(encoding, question, how, budget)(found);
}

}  // namespace robochart::probability
