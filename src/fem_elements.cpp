#include <equilibria/fem/joints.hpp>
#include <equilibria/fem/loads.hpp>
#include <equilibria/fem/rigid_link.hpp>
#include <equilibria/fem/springs.hpp>
#include <equilibria/fem/truss.hpp>

namespace equilibria::fem {

template class ElementGroupOf<SphericalJoint>;
template class ElementGroupOf<PlanarHinge>;
template class ElementGroupOf<RevoluteJoint>;
template class ElementGroupOf<PrismaticJoint>;
template class ElementGroupOf<ForkSupport>;
template class ElementGroupOf<PrescribedDisplacement>;
template class ElementGroupOf<PrescribedRotation>;
template class ElementGroupOf<RotationDrive>;
template class ElementGroupOf<PlanarRotationDrive>;
template class ElementGroupOf<FollowerLoad>;
template class ElementGroupOf<CentralLoad<2>>;
template class ElementGroupOf<CentralLoad<3>>;
template class ElementGroupOf<PlanarPressure<2>>;
template class ElementGroupOf<PlanarPressure<3>>;
template class ElementGroupOf<PlanarPressure<4>>;
template class ElementGroupOf<RigidLink<2>>;
template class ElementGroupOf<RigidLink<3>>;
template class ElementGroupOf<RotationSpring>;
template class ElementGroupOf<PlanarRotationSpring>;
template class ElementGroupOf<RotationSprings<1>>;
template class ElementGroupOf<RotationSprings<2>>;
template class ElementGroupOf<PlanarGroundSpring>;
template class ElementGroupOf<PointSpring<2>>;
template class ElementGroupOf<PointSpring<3>>;
template class ElementGroupOf<Truss<2>>;
template class ElementGroupOf<Truss<3>>;
template class ElementGroupOf<StressedTruss<2>>;
template class ElementGroupOf<StressedTruss<3>>;

}  // namespace equilibria::fem
