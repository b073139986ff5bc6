// expect: equilibria: this kind of singularity has another number of active parameters
#include <equilibria/singularity/refine_singularity.hpp>

struct Cusp {
    static constexpr int n_angles = 1;
    enum Parameter { x, y, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto u = sin(theta[0]);
        return u * u * u * u + p[y] * u * u + p[x] * u;
    }
};

void locate() {
    using namespace equilibria;
#ifdef EQUILIBRIA_CONTROL
    refine_singularity<Cusp, SingularityKind::cusp, Cusp::x, Cusp::y>({0}, Parameters<Cusp>{});
#else
    refine_singularity<Cusp, SingularityKind::cusp, Cusp::x>({0}, Parameters<Cusp>{});
#endif
}
