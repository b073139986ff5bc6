#include <functional>
#include <vector>

#include <equilibria/fem/beam.hpp>
#include <equilibria/fem/mesh.hpp>

namespace equilibria::fem {

template class ElementGroupOf<Beam<2>>;
template class ElementGroupOf<Beam<3>>;
template class ElementGroupOf<Beam<4>>;
template class ElementGroupOf<PlanarBeam<2>>;
template class ElementGroupOf<PlanarBeam<3>>;
template class ElementGroupOf<PlanarBeam<4>>;
template class ElementGroupOf<MixedBeam<2>>;
template class ElementGroupOf<MixedBeam<3>>;
template class ElementGroupOf<MixedBeam<4>>;
template class ElementGroupOf<PlanarMixedBeam<2>>;
template class ElementGroupOf<PlanarMixedBeam<3>>;
template class ElementGroupOf<PlanarMixedBeam<4>>;
template std::vector<int> add_beam<2>(Model&, const Section&, const std::function<SectionFrame(double)>&, int, int,
                                      int);
template std::vector<int> add_beam<3>(Model&, const Section&, const std::function<SectionFrame(double)>&, int, int,
                                      int);
template std::vector<int> add_beam<4>(Model&, const Section&, const std::function<SectionFrame(double)>&, int, int,
                                      int);
template std::vector<int> add_planar_beam<2>(Model&, const PlanarSection&,
                                             const std::function<PlanarSectionFrame(double)>&, int, int, int);
template std::vector<int> add_planar_beam<3>(Model&, const PlanarSection&,
                                             const std::function<PlanarSectionFrame(double)>&, int, int, int);
template std::vector<int> add_planar_beam<4>(Model&, const PlanarSection&,
                                             const std::function<PlanarSectionFrame(double)>&, int, int, int);

}  // namespace equilibria::fem
