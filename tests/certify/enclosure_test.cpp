#include <vector>

#include <equilibria/certify/enclosure.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

using M = models::ElasticPendulum;
using Box = Enclosure<double>;

Box draw(Generator& generator, double spread, double off) {
    Box y(n_unknowns<M>);
    const auto z = [&] {
        const double re = uniform(generator, -spread, spread);
        return Complex<double>(re, uniform(generator, -spread, spread));
    };
    y.unknowns[0].value = z();
    y.unknowns[0].sine = z();
    y.unknowns[1].value = z();
    for (auto& at : y.unknowns) at.off = off * uniform(generator);
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
    Box a(n_unknowns<M>), b(n_unknowns<M>);
    for (auto* box : {&a, &b}) {
        for (auto& at : box->unknowns) at = {Complex<double>(0.0), Complex<double>(0.0), 0.5};
    }
    b.unknowns[1].value.im = 1;
    CHECK_FALSE(disjoint(a, b));
    b.unknowns[1].value.im = 1 + 1e-12;
    CHECK(disjoint(a, b));
    CHECK_FALSE(a.excludes_real_points());
    CHECK(b.excludes_real_points());
}

TEST_CASE("an enclosure over doubles contains the one over more digits") {
    using S = Multiprecision<34>;
    Enclosure<S> sharp(n_unknowns<M>);
    const auto third = [](int k) { return Complex<S>(S(k) / S(3), S(k) / S(7)); };
    sharp.unknowns[0].value = third(1);
    sharp.unknowns[0].sine = third(2);
    sharp.unknowns[1].value = third(5);
    for (auto& at : sharp.unknowns) at.off = S(1e-30);
    const Box box = sharp.to<double>();
    const auto& fine = sharp.unknowns[1];
    const auto& rounded = box.unknowns[1];
    const Complex<S> d = fine.value - Complex<S>(S(rounded.value.re), S(rounded.value.im));
    CHECK(sqrt(norm2(d)) + fine.off <= S(rounded.off));
    CHECK(rounded.off < 1e-14);
}
