#include <cmath>
#include <sstream>

#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/enumeration.hpp"
#include "support/families.hpp"
#include "support/models.hpp"

using namespace tests;

namespace {

/// (x - a)^2 = -b^2: the roots a +- b i.
struct ConjugatePair {
    static constexpr int n_angles = 0, n_coordinates = 1;
    enum Parameter { a, b, n_parameters };
    constexpr auto equations(const auto&, const auto& x, const auto& p) const {
        return std::array{(x[0] - p[a]) * (x[0] - p[a]) + p[b] * p[b]};
    }
};
RootSet<ConjugatePair> candidates(double a, double b, std::initializer_list<std::complex<double>> roots) {
    RootSet<ConjugatePair> set;
    set.parameters = {{a, b}};
    for (const auto& z : roots) {
        Root<ConjugatePair> root;
        root.q[0] = z;
        root.path = set.roots.size();
        set.roots.push_back(root);
    }
    return set;
}

template <Model M>
void check_counts(const RootSet<M>& set, const Proof<M>& proof) {
    CHECK(proof.real + proof.non_real + proof.undecided + proof.duplicates == set.roots.size());
    for (const Certificate& c : proof.certificates) {
        CHECK(c.exists == (c.digits > 0));
        if (!c.exists) CHECK((c.reality == Reality::undecided && !c.index_proved && !c.distinct));
        if (c.index_proved) CHECK(c.reality == Reality::real);
    }
}

template <int N>
void check_complete(const RootSet<Chain<N>>& set) {
    const auto proof = prove(set);
    check_counts(set, proof);
    CHECK(proof.complete);
    CHECK(proof.distinct == set.paths.total);
    CHECK(proof.undecided == 0);
    CHECK(proof.contradictions == 0);
    CHECK(proof.real == set.real());
    CHECK(proof.index == set.real());
    CHECK(proof.by_index == set.by_index());
}

template <int N>
void check_chains(int random) {
    check_complete<N>(enumerate<Chain<N>>(benchmark_chain<N>()));
    Generator generator(static_cast<std::uint64_t>(N));
    for (int run = 0; run < random; ++run) check_complete<N>(enumerate<Chain<N>>(random_chain<N>(generator)));
}

}  // namespace

TEST_CASE("chains of 1 to 5 links are proved complete, with every index") {
    check_chains<1>(5 * thoroughness);
    check_chains<2>(5 * thoroughness);
    check_chains<3>(3 * thoroughness);
    check_chains<4>(thoroughness);
    check_chains<5>(thoroughness / 5);
}

TEST_CASE("3 + 1e-14 i is non-real, and not real") {
    const auto set = candidates(3, 1e-14, {{3, 1e-14}, {3, -1e-14}});
    const auto proof = prove(set);
    check_counts(set, proof);
    CHECK(proof.non_real == 2);
    CHECK(proof.real == 0);
    CHECK(proof.complete);
    for (const Certificate& c : proof.certificates) {
        CHECK(c.reality == Reality::non_real);
        CHECK(c.digits > 15);
    }
    // in doubles alone it is not decided
    const auto doubles = prove(set, {}, {.most_digits = 15});
    CHECK(doubles.undecided == 2);
    CHECK_FALSE(doubles.complete);
}

TEST_CASE("a double root is never proved") {
    const auto set = candidates(3, 0, {{3, 0}, {3, 1e-9}});
    const auto proof = prove(set);
    check_counts(set, proof);
    CHECK(proof.distinct == 0);
    CHECK(proof.undecided == 2);
    CHECK_FALSE(proof.complete);
}

TEST_CASE("the same root twice is a duplicate, a missing one makes the set incomplete") {
    const auto full = enumerate<Chain<3>>(benchmark_chain<3>());
    auto twice = full;
    twice.roots[5] = twice.roots[9];
    const auto proof = prove(twice);
    check_counts(twice, proof);
    CHECK(proof.duplicates == 1);
    CHECK(proof.distinct == 63);
    CHECK_FALSE(proof.complete);
    auto missing = full;
    missing.roots.erase(missing.roots.begin() + 20);
    CHECK(prove(missing).distinct == 63);
    CHECK_FALSE(prove(missing).complete);
}

TEST_CASE("Bernstein's bound proves completeness where it is reached, where none is, nothing, and the proof says so") {
    using M = models::CoupledAngles<3>;
    Parameters<M> p;
    Generator generator(3);
    for (double& value : p) value = uniform(generator, 0.3, 1.5);
    const auto set = enumerate<M>(p);
    const auto proof = prove(set);
    check_counts(set, proof);
    CHECK(proof.distinct == 20);
    CHECK(proof.complete);
    CHECK(proof.bound->value == 20);
    CHECK(proof.bound->theorem == "Bernstein's");
    // equal couplings of four oscillators: 14 roots of a mixed volume of 20
    const families::Oscillators oscillators{3, families::complete(4)};
    const auto q = families::equal_couplings(oscillators, 1);
    const auto proof_of_14 = prove(oscillators, enumerate(oscillators, q));
    CHECK(proof_of_14.distinct == 14);
    CHECK_FALSE(proof_of_14.complete);
    CHECK(proof_of_14.bound->value == 20);
    std::ostringstream out;
    out << proof_of_14;
    CHECK(out.str().find("allows more") != std::string::npos);
}

TEST_CASE("angles and coordinates") {
    using M = models::ElasticPendulum;
    const auto set = enumerate<M>({{3, 0.5}});
    const auto proof = prove(set);
    check_counts(set, proof);
    CHECK(proof.distinct == set.distinct());
    CHECK(proof.real == set.real());
    CHECK(proof.contradictions == 0);
}

TEST_CASE("a wrong index or a wrong reality in the set is a contradiction") {
    auto set = enumerate<Chain<2>>(benchmark_chain<2>());
    CHECK(prove(set).contradictions == 0);
    set.equilibria[3].index = 2 - set.equilibria[3].index;
    set.equilibria.pop_back();
    CHECK(prove(set).contradictions == (set.equilibria[3].index == 1 ? 1u : 2u));
}

TEST_CASE("on a fold nothing is proved of the double roots") {
    // r = 1.5, alpha = .4: the fold, computed independently: interval branch and bound, multiprecision
    const auto set = enumerate<mechanisms::TwoLinkChain>({{.4, 1.5, 2.4293853881739}});
    const auto proof = prove(set);
    CHECK_FALSE(proof.complete);
    CHECK(proof.contradictions == 0);
}

TEST_CASE("the threads change nothing, and options out of range are refused") {
    const auto set = enumerate<Chain<4>>(benchmark_chain<4>());
    const auto one = prove(set, {.executor = threads(1)}), two = prove(set, {.executor = threads(2)});
    REQUIRE(one.certificates.size() == two.certificates.size());
    for (std::size_t k = 0; k < one.certificates.size(); ++k)
        CHECK(one.certificates[k].radius == two.certificates[k].radius);
    CHECK_THROWS_WITH(threads(2000), "threads = 2000: must be 0 (all) to 1024");
    CHECK_THROWS_WITH(prove(set, {}, {.most_digits = 20}), "most_digits = 20: must be 15, 34 or 68");
}

TEST_CASE("mirror images that share a proof are proved alone as well, with the same certificate") {
    const auto set = enumerate<Chain<4>>(benchmark_chain<4>());
    auto alone = set;  // an image that is off by a bit is no image
    for (auto& root : alone.roots)
        for (auto& q : root.q) q = {std::nextafter(q.real(), 0.0), q.imag() + 1e-16};
    const auto together = prove(set), apart = prove(alone);
    REQUIRE(together.certificates.size() == apart.certificates.size());
    CHECK(together.complete);
    CHECK(apart.complete);
    CHECK(together.by_index == apart.by_index);
    for (std::size_t k = 0; k < apart.certificates.size(); ++k) {
        const Certificate &a = together.certificates[k], &b = apart.certificates[k];
        CHECK(a.path == b.path);
        CHECK(a.exists == b.exists);
        CHECK(a.distinct == b.distinct);
        CHECK(a.reality == b.reality);
        CHECK(a.index == b.index);
        CHECK(a.radius < b.radius + 1e-12);
    }
}

TEST_CASE("a root that is given twice is a duplicate beside its mirror image too") {
    auto set = enumerate<Chain<3>>(benchmark_chain<3>());
    const auto count = set.roots.size();
    for (const std::size_t k : {std::size_t{5}, std::size_t{20}, std::size_t{63}}) set.roots.push_back(set.roots[k]);
    const auto proof = prove(set);
    check_counts(set, proof);
    CHECK(proof.duplicates == 3);
    CHECK(proof.distinct == count);
}
