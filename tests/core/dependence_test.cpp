#include <cmath>
#include <vector>

#include <equilibria/core/dependence.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("numbers that carry what they depend on") {
    using On = std::vector<int>;
    const Dependence x = Dependence::variable(2), y = Dependence::variable(0), z = Dependence::variable(7);
    CHECK(Dependence(3.5).on().empty());
    CHECK(x.on() == On{2});
    CHECK((x + y).on() == On{0, 2});
    CHECK((x * y - 2 * z / 3.0).on() == On{0, 2, 7});
    CHECK((-x).on() == On{2});
    CHECK((1.0 / x).on() == On{2});
    // in form alone
    CHECK((x - x).on() == On{2});
    CHECK((0 * z).on() == On{7});
    CHECK(exp(sin(x) + cos(y)).on() == On{0, 2});
    CHECK(log(sqrt(z)).on() == On{7});
    CHECK(atan2(y, z).on() == On{0, 7});
    CHECK(pow(x, 3).on() == On{2});
    CHECK(pow(x, 0.5).on() == On{2});
    Dependence sum;
    for (const int k : {5, 1, 3, 1, 5, 9}) sum += Dependence::variable(k);
    CHECK(sum.on() == On{1, 3, 5, 9});
    sum -= Dependence::variable(9);
    sum *= y;
    sum /= z;
    CHECK(sum.on() == On{0, 1, 3, 5, 7, 9});
}
