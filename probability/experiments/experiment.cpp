// See experiment.hpp.
#include "probability/experiments/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "checker/prism/checks/check.hpp"
#include "checker/prism/experiment.hpp"
#include "checker/prism/explore/rules.hpp"
#include "checker/prism/session.hpp"

namespace robochart::probability {
namespace {

using prism::ExprPtr;
using prism::Op;

/// The messages of all errors.
std::string errors(const diagnostics::Diagnostics& diagnostics) {
    std::string text;
    for (const diagnostics::Diagnostic& each : diagnostics.sorted())
        if (each.rule->severity == diagnostics::Severity::error) text += (text.empty() ? "" : "; ") + each.message();
    return text;
}

std::string message(const prism::EvaluationError& error) {
    diagnostics::Diagnostics one;
    error.report(one);
    std::string text = errors(one);
    if (!error.state.empty()) text += ", in the state " + error.state;
    if (error.is(prism::rules::out_of_range)) text += "; --range and --prefs set the ranges of nat, int and real";
    return text;
}

/// Whether it asks for one number, without saying of which scheduler.
bool open_question(const prism::Expr& expr) {
    return (expr.op == Op::probability || expr.op == Op::reward) && expr.query->bound == nullptr &&
           expr.query->optimum == prism::Optimum::none;
}

ExprPtr with(const ExprPtr& expr, prism::Optimum optimum) {
    prism::Expr copy = *expr;
    auto query = std::make_shared<prism::Query>(*expr->query);
    query->optimum = optimum;
    copy.query = std::move(query);
    return prism::make_expr(std::move(copy));
}

/// The properties that answer a question: itself, or for its minimum and its maximum.
std::vector<prism::Property> properties_of(const Question& question, bool one_value) {
    if (!open_question(*question.property)) return {{{}, question.property}};
    if (one_value) return {{{}, with(question.property, prism::Optimum::minimum)}};
    return {{{}, with(question.property, prism::Optimum::minimum)},
            {{}, with(question.property, prism::Optimum::maximum)}};
}

/// A setting with the name that its constant has in PRISM, and its values.
struct Given {
    const Setting* setting = nullptr;
    bool of_model = false;
    prism::Series series;
};

class Experiment {
public:
    Experiment(Encoding& encoding, const Question& question, const Accuracy& accuracy, diagnostics::Budget& budget)
        : encoding_(encoding), question_(question), accuracy_(accuracy), budget_(budget) {}

    void operator()(const std::function<void(Row)>& found) {
        for (const Setting& each : question_.settings) read(each);
        for (const prism::Values& of_model : combinations(true)) run(of_model, found);
    }

private:
    void read(const Setting& setting) {
        Given given{&setting, true, {}};
        prism::Constant constant;
        if (setting.path.empty()) {
            const auto own = [&](const prism::Constant& each) { return each.name.text == setting.constant; };
            const auto in_model = std::find_if(question_.model_constants.begin(), question_.model_constants.end(), own);
            const auto in_property = std::find_if(question_.constants.begin(), question_.constants.end(), own);
            given.of_model = in_model != question_.model_constants.end();
            if (!given.of_model && in_property == question_.constants.end()) return;  // nothing uses it
            constant = given.of_model ? *in_model : *in_property;
        } else {
            constant = encoding_.constant(setting.path);
        }
        given.series.name = constant.name.text;
        // Names of paths are no names of PRISM's: the reader sees a plain one.
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

    [[nodiscard]] std::vector<prism::Values> combinations(bool of_model) const {
        std::vector<prism::Series> series;
        for (const Given& each : given_)
            if (each.of_model == of_model) series.push_back(each.series);
        try {
            return prism::combinations(series);
        } catch (const prism::BadValue& error) {
            throw Wrong(error.what());
        }
    }

    [[nodiscard]] Row row(const prism::Values& of_model, const prism::Values& of_property) const {
        Row result;
        for (const Given& each : given_) {
            const prism::Values& values = each.of_model ? of_model : of_property;
            result.constants.emplace_back(each.setting->name, values.find(each.series.name)->second.text());
        }
        return result;
    }

    void run(const prism::Values& of_model, const std::function<void(Row)>& found) {
        const auto begin = std::chrono::steady_clock::now();
        const auto seconds = [&] {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        };
        const std::vector<prism::Values> of_property = combinations(false);
        const auto fail = [&](const std::string& error) {
            for (const prism::Values& constants : of_property) {
                Row one = row(of_model, constants);
                one.error = error;
                found(std::move(one));
            }
        };
        try {
            const prism::StateSpace& space = encoding_.space(question_, of_model);
            decide(space, of_model, of_property, seconds(), found);
        } catch (const prism::EvaluationError& error) {
            fail(message(error));
        } catch (const Wrong& error) {
            fail(error.what());
        } catch (const diagnostics::LimitReached& limit) {
            budget_.check();  // the limits of the whole run pass
            for (const prism::Values& constants : of_property) {
                Row one = row(of_model, constants);
                one.results.emplace_back().reason = limit.what();
                found(std::move(one));
            }
        }
    }

    void decide(const prism::StateSpace& space, const prism::Values& of_model,
                const std::vector<prism::Values>& of_property, double exploring,
                const std::function<void(Row)>& found) {
        diagnostics::Diagnostics findings;
        prism::PropertyFile file;
        file.constants = question_.constants;
        const bool mdp = space.model().kind == prism::ModelKind::mdp;
        file.properties = mdp ? properties_of(question_, encoding_.one_value())
                              : std::vector<prism::Property>{{{}, question_.property}};
        const prism::CheckedProperties checked = prism::check_properties(space.model(), file, findings);
        if (!findings.ok()) throw Wrong(errors(findings));
        prism::Session session(space, checked, {accuracy_.relative, accuracy_.exact, &budget_});
        for (const prism::Values& constants : of_property) {
            const auto begin = std::chrono::steady_clock::now();
            Row one = row(of_model, constants);
            one.states = space.chain().states();
            one.transitions = space.transitions();
            try {
                for (std::size_t i = 0; i < checked.properties.size(); ++i)
                    one.results.push_back(session.check(i, constants));
            } catch (const prism::EvaluationError& error) {
                one.results.clear();
                one.error = message(error);
            }
            one.seconds = exploring + std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
            exploring = 0;  // counts once
            found(std::move(one));
        }
    }

    Encoding& encoding_;
    const Question& question_;
    const Accuracy& accuracy_;
    diagnostics::Budget& budget_;
    std::vector<Given> given_;
};

}  // namespace

void decide(Encoding& encoding, const Question& question, const Accuracy& accuracy, diagnostics::Budget& budget,
            const std::function<void(Row)>& found) {
    Experiment(encoding, question, accuracy, budget)(found);
}

}  // namespace robochart::probability
