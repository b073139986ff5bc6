// The table of kinds: a row for each, whose numbers agree with each other.
#include <set>
#include <string>

#include <equilibria/singularity/singularity_kind.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Kind = SingularityKind;

TEST_CASE("every kind has one row, a name of its own, and lies on curves of folds or of pitchforks") {
    std::set<Kind> kinds;
    std::set<std::string> names;
    for (const SingularityClass& row : singularity_classes) {
        CAPTURE(row.name);
        CHECK(kinds.insert(row.kind).second);
        CHECK(names.insert(row.name).second);
        CHECK(&class_of(row.kind) == &row);
        CHECK(std::string(to_string(row.kind)) == row.name);
        if (row.kind == Kind::undecided) continue;
        CHECK((curve_of(row.kind) == Kind::fold || curve_of(row.kind) == Kind::pitchfork));
        CHECK((row.corank == 1 || row.corank == 2));
        CHECK((row.parameters >= 1 && row.parameters <= 4));
    }
    // enumerators are numbered from 0, and beak_to_beak is the last one
    CHECK(kinds.size() == static_cast<std::size_t>(Kind::beak_to_beak) + 1);
}

TEST_CASE(
    "A_{k+1} and B_{k+1} take k parameters, and their first derivative that is not 0 is phi^(k+2) and phi^(2k+2)") {
    const Kind ordinary[] = {Kind::fold, Kind::cusp, Kind::swallowtail, Kind::butterfly};
    const Kind symmetric[] = {Kind::pitchfork, Kind::tricritical_pitchfork, Kind::tetracritical_pitchfork};
    for (int k = 1; k <= 4; ++k) {
        const auto& row = class_of(ordinary[k - 1]);
        CHECK(row.symbol == "A" + std::to_string(k + 1));
        CHECK(row.parameters == k);
        CHECK(row.order() == k);
        CHECK(row.deciding() == k + 2);
        CHECK(row.by_series());
    }
    for (int k = 1; k <= 3; ++k) {
        const auto& row = class_of(symmetric[k - 1]);
        CHECK(row.symbol == "B" + std::to_string(k + 1));
        CHECK(row.parameters == k);
        CHECK(row.order() == 2 * k - 1);
        CHECK(row.deciding() == 2 * k + 2);
        CHECK(row.by_series());
    }
    CHECK_FALSE(class_of(Kind::hyperbolic_umbilic).by_series());
    CHECK_FALSE(class_of(Kind::lips).by_series());
}
