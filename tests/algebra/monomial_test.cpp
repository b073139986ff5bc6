// Codes of factors, packed: what is put in comes out, and products, degrees and the order agree with them.
#include <vector>

#include <equilibria/algebra/monomial.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("A monomial keeps the code of every unknown") {
    Monomial<9, 9> m;  // more than four words of 4 codes
    CHECK(m.is_one());
    for (int u = 0; u < 18; ++u) m.set_code(u, u % 2 == 0 ? 1000 - u : u - 1000);
    for (int u = 0; u < 18; ++u) CHECK(m.code(u) == (u % 2 == 0 ? 1000 - u : u - 1000));
    m.set_code(8, 0);
    CHECK(m.code(8) == 0);
    CHECK(m.code(7) == -993);
    CHECK(m.code(9) == -991);
    CHECK_FALSE(m.is_one());
}

TEST_CASE("A monomial's degrees are those of its factors in cosine, sine and coordinate") {
    using M = Monomial<2, 1>;
    M m = M::single(0, 3);  // cos 3 theta_1
    CHECK(m.degree() == 3);
    m.set_code(1, -2);  // sin 2 theta_2
    m.set_code(2, 4);   // x^4
    CHECK(m.degree(1) == 2);
    CHECK(m.degree() == 9);
    CHECK(M::is_angle(1));
    CHECK_FALSE(M::is_angle(2));
}

TEST_CASE("Monomials that do not overlap join") {
    using M = Monomial<8, 2>;
    for (int u = 0; u < 10; ++u)
        for (int v = 0; v < 10; ++v) {
            const M a = M::single(u, u < 8 ? -1 : 1), b = M::single(v, 2);
            CHECK(overlap(a, b) == (u == v));
            CHECK(next_overlap(a, b, 0) == (u == v ? u : 10));
            if (u == v) continue;
            CHECK(join(a, b).code(u) == a.code(u));
            CHECK(join(a, b).code(v) == 2);
            CHECK(join(a, b) == join(b, a));
        }
    CHECK_FALSE(overlap(M(), M()));
    const M a = join(M::single(1, 2), join(M::single(7, -3), M::single(9, 1)));
    std::vector<int> both;
    for (int u = next_overlap(a, a, 0); u < 10; u = next_overlap(a, a, u + 1)) both.push_back(u);
    CHECK(both == std::vector{1, 7, 9});
}

TEST_CASE("The order of monomials is strict and total") {
    using M = Monomial<8, 2>;
    M all[] = {M(), M::single(0, 1), M::single(0, -1), M::single(7, 2), M::single(8, 1), M::single(9, 1000)};
    for (const M& a : all)
        for (const M& b : all) CHECK((a < b) + (b < a) + (a == b) == 1);
}
