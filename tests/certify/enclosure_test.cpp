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

TEST_CASE("the intervals of proofs in lanes are those of their enclosures, mirrored or not") {
    using Pack = Lanes<native_lanes>;
    const RuntimeSizes sizes(3, 0);
    Generator generator(5);
    const EnclosureForm form(3);
    for (int trial = 0; trial < 100; ++trial) {
        KrawczykResult<Pack> proof(sizes);
        const auto fill = [&](auto& numbers) {
            for (auto& z : numbers)
                for (int k = 0; k < native_lanes; ++k)
                    set_lane(z.re, k, uniform(generator, -3, 3)), set_lane(z.im, k, uniform(generator, -1, 1));
        };
        fill(proof.center.c), fill(proof.center.s), fill(proof.center.x);
        for (Pack& off : proof.off)
            for (int k = 0; k < native_lanes; ++k) set_lane(off, k, uniform(generator, 0, 0.9));
        EnclosureInterval own[native_lanes], mirrored[native_lanes];
        form.intervals(proof, false, own);
        form.intervals(proof, true, mirrored);
        const auto excluded = excludes_real_points(proof);
        for (int k = 0; k < native_lanes; ++k) {
            auto box = Box::of(proof, k);
            CHECK(mask_lane(excluded, k) == box.excludes_real_points());
            CHECK(form(box).low == Approx(own[k].low));
            CHECK(form(box).high == Approx(own[k].high));
            for (auto& at : box.unknowns) at.sine = -at.sine;
            CHECK(form(box).low == Approx(mirrored[k].low));
            CHECK(form(box).high == Approx(mirrored[k].high));
        }
    }
}

TEST_CASE("intervals that meet are told, those without an end meet none") {
    const EnclosureInterval a{0, 1}, b{1, 2}, c{3, 4}, d{3.5, 3.6}, e{}, f{5, 6};
    CHECK(meeting({a, c, e, b, f, d}) == std::vector<std::size_t>{0, 1, 3, 5});
    CHECK(meeting({a, c, f, e}).empty());
    CHECK(meeting({}).empty());
}
