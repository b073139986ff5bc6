#include <vector>

#include <equilibria/certify/enclosure.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

using M = models::ElasticPendulum;
using Box = Enclosure<double>;

Box draw(Generator& generator, double spread, double off) {
    Box y{Sizes<M>()};
    const auto z = [&] {
        const double re = uniform(generator, -spread, spread);
        return Complex<double>(re, uniform(generator, -spread, spread));
    };
    y.center.c[0] = z();
    y.center.s[0] = z();
    y.center.x[0] = z();
    for (double& r : y.off) r = off * uniform(generator);
    return y;
}

}  // namespace

TEST_CASE("groups of enclosures, as comparing all pairs finds them") {
    Generator generator(1);
    for (const double off : {1e-12, 0.05, 0.3, 2.0}) {
        std::vector<Box> boxes;
        for (int k = 0; k < 200; ++k) boxes.push_back(draw(generator, 1, off));
        for (int k = 0; k < 5; ++k) boxes.push_back(boxes[static_cast<std::size_t>(7 * k)]);
        std::vector<std::size_t> slow(boxes.size());
        for (std::size_t k = 0; k < slow.size(); ++k) slow[k] = k;
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t a = 0; a < boxes.size(); ++a)
                for (std::size_t b = 0; b < a; ++b)
                    if (slow[a] != slow[b] && !disjoint(boxes[a], boxes[b])) {
                        slow[a] = slow[b] = std::min(slow[a], slow[b]);
                        changed = true;
                    }
        }
        CHECK(groups_of_enclosures(boxes) == slow);
    }
}

TEST_CASE("touching enclosures are not disjoint, separated ones are") {
    Box a{Sizes<M>()}, b = a;
    for (auto* box : {&a, &b}) {
        box->center.c[0] = box->center.s[0] = box->center.x[0] = Complex<double>(0.0);
        for (double& r : box->off) r = 0.5;
    }
    b.center.x[0].im = 1;
    CHECK_FALSE(disjoint(a, b));
    b.center.x[0].im = 1 + 1e-12;
    CHECK(disjoint(a, b));
    CHECK_FALSE(a.excludes_real_points());
    CHECK(b.excludes_real_points());
}

TEST_CASE("an enclosure over doubles contains the one over more digits") {
    using S = Multiprecision<34>;
    Enclosure<S> sharp{Sizes<M>()};
    const auto third = [](int k) { return Complex<S>(S(k) / S(3), S(k) / S(7)); };
    sharp.center.c[0] = third(1);
    sharp.center.s[0] = third(2);
    sharp.center.x[0] = third(5);
    for (S& r : sharp.off) r = S(1e-30);
    const Box box = sharp.to<double>();
    const Complex<S> d = sharp.center.x[0] - Complex<S>(S(box.center.x[0].re), S(box.center.x[0].im));
    CHECK(sqrt(norm2(d)) + sharp.off[1] <= S(box.off[1]));
    CHECK(box.off[1] < 1e-14);
}
