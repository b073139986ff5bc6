// Enumerations, proofs and digits of models whose numbers of unknowns are known at run time: those of the model as a
// type.
#include <cmath>
#include <cstdint>
#include <sstream>
#include <type_traits>
#include <vector>

#include <equilibria/certify/refine_root.hpp>
#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/model_functions.hpp>
#include <equilibria/model/torus.hpp>

#include "support/catch.hpp"
#include "support/scratch_file.hpp"

using namespace equilibria;

namespace {

RuntimeArray<double> chain_parameters(int links) {
    RuntimeArray<double> p(2 * links + 2);
    for (int i = 0; i < links; ++i) p[i] = 1 + (i + 1) / 10.0, p[links + i] = 1 + (i + 1) * (i + 1) / 20.0;
    p[2 * links] = 1.7;
    p[2 * links + 1] = 1;
    return p;
}

/// x_1^2 = 2, .., x_n^2 = n + 1, and an angle with sin theta = p: not symmetric, with coordinates.
struct Roots {
    int n;
    int angles() const { return 1; }
    int coordinates() const { return n; }
    int parameters() const { return 1; }
    auto equations(const auto& theta, const auto& x, const auto& p) const {
        using S = std::remove_cvref_t<decltype(x[0] * p[0])>;
        std::vector<S> f{sin(theta[0]) - p[0]};
        for (int j = 0; j < x.size(); ++j) f.push_back(x[j] * x[j] - (j + 2.0));
        return f;
    }
};

}  // namespace

TEST_CASE("a chain at run time has the equilibria of the chain as a type, by the same paths") {
    using M = mechanisms::RotatingChain<3>;
    const auto p = chain_parameters(3);
    const auto set = enumerate(mechanisms::RuntimeRotatingChain{3}, p, {.seed = 5});
    const auto typed = enumerate<M>(parameters_from<M>(p), {.seed = 5});
    CHECK(set.clean());
    CHECK(set.morse());
    CHECK(set.paths.total == 64);
    CHECK(set.by_index() == typed.by_index());
    REQUIRE(set.roots.size() == typed.roots.size());
    for (std::size_t k = 0; k < set.roots.size(); ++k) {
        CHECK(set.roots[k].path == typed.roots[k].path);
        for (int u = 0; u < 3; ++u) CHECK(std::abs(set.roots[k].q[u] - typed.roots[k].q[u]) < 1e-10);
    }
    REQUIRE(set.equilibria.size() == typed.equilibria.size());
    for (std::size_t k = 0; k < set.equilibria.size(); ++k)
        CHECK(set.equilibria[k].energy == Approx(typed.equilibria[k].energy).epsilon(1e-12));
    std::ostringstream text, typed_text;
    text << set;
    typed_text << typed;
    CHECK(text.str() == typed_text.str());
}

TEST_CASE("any number of links: every root is proved to be there, and none is missing") {
    for (int links = 1; links <= 5; ++links) {
        const mechanisms::RuntimeRotatingChain model{links};
        const auto set = enumerate(model, chain_parameters(links), {.executor = threads(2)});
        CHECK(set.clean());
        const auto proof = prove(model, set, {.executor = threads(2)});
        CHECK(proof.complete);
        CHECK(proof.distinct == std::uint64_t{1} << (2 * links));
        CHECK(proof.index == set.real());
        CHECK(proof.contradictions == 0);
    }
}

TEST_CASE("the result does not depend on the number of threads") {
    const mechanisms::RuntimeRotatingChain model{4};
    const auto one = enumerate(model, chain_parameters(4)),
               two = enumerate(model, chain_parameters(4), {.executor = threads(2)});
    REQUIRE(one.roots.size() == two.roots.size());
    for (std::size_t k = 0; k < one.roots.size(); ++k) CHECK(one.roots[k].q == two.roots[k].q);
}

TEST_CASE("equations in an angle and coordinates") {
    const Roots model{3};
    const auto set = enumerate(model, {0.5});
    CHECK(set.paths.total == 16);
    CHECK(set.distinct() == 16);
    CHECK(set.real() == 16);
    CHECK_FALSE(set.morse_applies());
    for (const auto& e : set.equilibria) {
        CHECK(std::abs(std::sin(e.q[0]) - 0.5) < 1e-14);
        for (int j = 1; j <= 3; ++j) CHECK(std::abs(e.q[j] * e.q[j] - (j + 1)) < 1e-14);
        CHECK(std::isnan(e.energy));
    }
    CHECK(prove(model, set).complete);
    const auto refined = refine(
        model,
        {set.roots[0].q.begin()[0], set.roots[0].q.begin()[1], set.roots[0].q.begin()[2], set.roots[0].q.begin()[3]},
        set.parameters, 40);
    CHECK(refined.proved);
    CHECK(refined.digits == 40);
    CHECK_THROWS_WITH(refine(model, {0}, set.parameters, 40), "q = 1: must be a number for each unknown");
}

TEST_CASE("a checkpoint of a model at run time is gone on from, and belongs to its number of links") {
    const tests::ScratchFile file("run_time.ckpt");
    const auto run = [&](int links) {
        return enumerate(mechanisms::RuntimeRotatingChain{links}, chain_parameters(links), {.checkpoint = file.name()});
    };
    const auto first = run(3), again = run(3);
    REQUIRE(first.roots.size() == again.roots.size());
    for (std::size_t k = 0; k < first.roots.size(); ++k) CHECK(first.roots[k].q == again.roots[k].q);
    CHECK_THROWS_AS(run(2), CheckpointError);
}

TEST_CASE("what an enumeration at run time refuses") {
    const mechanisms::RuntimeRotatingChain model{2};
    CHECK_THROWS_WITH(enumerate(model, {1, 1, 1}), "parameters = 3: must be as many as model.parameters()");
    auto p = chain_parameters(2);
    p[1] = std::nan("");
    CHECK_THROWS_WITH(enumerate(model, p), Catch::Contains("parameters[1]"));
}
