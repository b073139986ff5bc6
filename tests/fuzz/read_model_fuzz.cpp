// Any bytes for a model: one whose formulas have values everywhere that they are polynomials, or an InvalidArgument.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <equilibria/io/read_model.hpp>
#include <equilibria/model/runtime_model.hpp>

using namespace equilibria;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const FormulaModel model = parse_model({reinterpret_cast<const char*>(data), size}, 1 << 16);
        visit(model, [&](const auto& m) {
            const RuntimeSizes sizes = sizes_of(m);
            LocalArray<double> q(sizes.unknowns), f(sizes.unknowns);
            for (int u = 0; u < sizes.unknowns; ++u) q[u] = 0.1 * (u + 1);
            const RuntimeModelPoint<double> at(q.begin(), sizes);
            equations_at(m, at.theta, at.x, model.values, f.begin());
            return 0;
        });
        if (model.kinetics) {
            const FormulaDynamics moving(model);
            const LocalArray<double> v(model.unknowns());
            const RuntimeModelPoint<double> at(v.begin(), sizes_of(moving));
            moving.dissipation(at.theta, at.x, v, model.values);
            moving.generalised_forces(0.5, at.theta, at.x, v, model.values);
        }
    } catch (const InvalidArgument& error) {
        const std::string_view what = error.what();
        if (what.find(": ") == what.npos || what.find(" = ") == what.npos) std::abort();
    }
    return 0;
}
