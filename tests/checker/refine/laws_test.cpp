// SPDX-License-Identifier: Apache-2.0
// Tests algebraic laws of CSP (Roscoe, TPC 1998 and UCS 2010) on random processes, in T, F and FD, and in both
// directions unless the law is an inequality. If a law fails, RapidCheck shrinks the numbers that generate the
// processes.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "checker/refine/verdict/check.hpp"
#include "tests/checker/processes/naive.hpp"
#include "tests/checker/processes/random_process.hpp"
#include "tests/checker/processes/translate.hpp"

namespace robochart::refine {
namespace {

using naive::Kind;
using naive::Letter;
using naive::Process;

Process make(Kind kind, std::vector<Process> operands, std::set<Letter> set = {}) {
    return std::make_shared<const naive::Tree>(naive::Tree{kind, std::move(operands), {}, std::move(set), {}, {}, 0});
}

Process rename(Process operand, std::vector<std::pair<Letter, Letter>> pairs) {
    return std::make_shared<const naive::Tree>(
        naive::Tree{Kind::rename, {std::move(operand)}, {}, {}, {}, std::move(pairs), 0});
}

/// Three random processes P, Q and R in one store.
class Laws {
public:
    Laws() : script_(random_script()), translation_(script_) { RC_LOG() << show(script_) << std::endl; }
    const Process& p() const { return script_.mains[0]; }
    const Process& q() const { return script_.mains[1]; }
    const Process& r() const { return script_.mains[2]; }

    void refined_by(const Process& specification, const Process& implementation) {
        for (const Model model : {Model::traces, Model::failures, Model::failures_divergences}) {
            process::TermSystem left = translation_.system(specification);
            process::TermSystem right = translation_.system(implementation);
            RC_ASSERT(refines(left, right, model, Limits{}).outcome == Outcome::holds);
        }
    }
    void equal(const Process& left, const Process& right) {
        refined_by(left, right);
        refined_by(right, left);
    }

private:
    static naive::Script random_script() {
        const auto numbers = *rc::gen::container<std::vector<unsigned>>(rc::gen::inRange<unsigned>(0, 2520));
        naive::Script script = naive::Decoder(numbers).script(3);
        for (const Process& main : script.mains) RC_PRE(naive::explore(script, main, 60).has_value());
        return script;
    }
    naive::Script script_;
    Translation translation_;
};

const Process skip = make(Kind::skip, {});
const Process stop = make(Kind::stop, {});

RC_GTEST_PROP(Laws, ExternalChoice, ()) {
    Laws l;
    l.equal(make(Kind::external, {l.p(), l.p()}), l.p());
    l.equal(make(Kind::external, {l.p(), l.q()}), make(Kind::external, {l.q(), l.p()}));
    l.equal(make(Kind::external, {l.p(), stop}), l.p());
    l.equal(make(Kind::external, {l.p(), make(Kind::external, {l.q(), l.r()})}),
            make(Kind::external, {l.p(), l.q(), l.r()}));
    l.equal(make(Kind::external, {l.p(), make(Kind::internal, {l.q(), l.r()})}),
            make(Kind::internal, {make(Kind::external, {l.p(), l.q()}), make(Kind::external, {l.p(), l.r()})}));
}

RC_GTEST_PROP(Laws, InternalChoice, ()) {
    Laws l;
    const Process either = make(Kind::internal, {l.p(), l.q()});
    l.equal(make(Kind::internal, {l.p(), l.p()}), l.p());
    l.equal(either, make(Kind::internal, {l.q(), l.p()}));
    l.refined_by(either, l.p());
    l.refined_by(either, make(Kind::external, {l.p(), l.q()}));
    l.refined_by(either, make(Kind::sliding, {l.p(), l.q()}));
}

RC_GTEST_PROP(Laws, SequentialComposition, ()) {
    Laws l;
    l.equal(make(Kind::sequential, {skip, l.p()}), l.p());
    l.equal(make(Kind::sequential, {l.p(), skip}), l.p());
    l.equal(make(Kind::sequential, {stop, l.p()}), stop);
    l.equal(make(Kind::sequential, {make(Kind::sequential, {l.p(), l.q()}), l.r()}),
            make(Kind::sequential, {l.p(), make(Kind::sequential, {l.q(), l.r()})}));
}

RC_GTEST_PROP(Laws, HidingAndRenaming, ()) {
    Laws l;
    const auto hide = [](const Process& p, const std::set<Letter>& set) { return make(Kind::hide, {p}, set); };
    l.equal(hide(l.p(), {}), l.p());
    l.equal(hide(hide(l.p(), {0}), {1}), hide(l.p(), {0, 1}));
    l.equal(hide(make(Kind::internal, {l.p(), l.q()}), {0}),
            make(Kind::internal, {hide(l.p(), {0}), hide(l.q(), {0})}));
    l.equal(rename(l.p(), {{0, 0}}), l.p());
    l.equal(rename(rename(l.p(), {{0, 1}, {1, 0}}), {{0, 1}, {1, 0}}), l.p());
    l.equal(hide(rename(l.p(), {{0, 1}}), {1}), hide(l.p(), {0, 1}));
    l.equal(rename(make(Kind::external, {l.p(), l.q()}), {{0, 1}, {0, 2}}),
            make(Kind::external, {rename(l.p(), {{0, 1}, {0, 2}}), rename(l.q(), {{0, 1}, {0, 2}})}));
}

RC_GTEST_PROP(Laws, Parallel, ()) {
    Laws l;
    const std::set<Letter> set{0, 1};
    l.equal(make(Kind::parallel, {l.p(), l.q()}, set), make(Kind::parallel, {l.q(), l.p()}, set));
    l.equal(
        make(Kind::parallel, {l.p(), make(Kind::internal, {l.q(), l.r()})}, set),
        make(Kind::internal, {make(Kind::parallel, {l.p(), l.q()}, set), make(Kind::parallel, {l.p(), l.r()}, set)}));
    l.equal(make(Kind::parallel, {l.p(), skip}, {}), l.p());  // synchronised termination
    const Process alone = make(Kind::run, {}, set);
    l.refined_by(make(Kind::internal, {l.p(), stop}), make(Kind::internal, {stop, l.p()}));
    l.equal(make(Kind::parallel, {make(Kind::parallel, {l.p(), l.q()}, set), alone}, set),
            make(Kind::parallel, {l.p(), make(Kind::parallel, {l.q(), alone}, set)}, set));
}

RC_GTEST_PROP(Laws, InterruptExceptionAndSliding, ()) {
    Laws l;
    l.equal(make(Kind::interrupt, {l.p(), stop}), l.p());
    l.equal(make(Kind::interrupt, {stop, l.p()}), l.p());
    l.equal(make(Kind::exception, {l.p(), l.q()}, {}), l.p());
    l.equal(make(Kind::sliding, {l.p(), l.q()}),
            make(Kind::internal, {make(Kind::external, {l.p(), l.q()}), l.q()}));  // UCS 2.4
    l.equal(make(Kind::sync_external, {l.p(), l.q()}, {}), make(Kind::external, {l.p(), l.q()}));
    l.equal(make(Kind::sync_interrupt, {l.p(), l.q()}, {}), make(Kind::interrupt, {l.p(), l.q()}));
}

// UCS 20.2: if no event of a lower level is ever offered, prioritise is the identity.
RC_GTEST_PROP(Laws, PrioritiseWithOneLevelIsTheIdentity, ()) {
    Laws l;
    const Process one_level =
        std::make_shared<const naive::Tree>(naive::Tree{Kind::prioritise, {l.p()}, {}, {}, {{0, 1, 2}}, {}, 0});
    l.equal(one_level, l.p());
    l.refined_by(l.p(), make(Kind::compress, {l.p()}));
}

// FDR manual, chase: it follows some of the taus and discards the others, so it only removes behaviours.
RC_GTEST_PROP(Laws, ChaseRefines, ()) {
    Laws laws;
    laws.refined_by(laws.p(), make(Kind::chase, {laws.p()}));
}

}  // namespace
}  // namespace robochart::refine
