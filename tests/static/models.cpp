// SPDX-License-Identifier: BSL-1.0
// Each policy of the library models the concept of its role. It is asked here and not at the end of its header, where
// every program that includes the header would pay for it: a twelfth of what compiling <ansatz/world.hpp> costs.

#include <ansatz/collision/broadphase/all_pairs.hpp>
#include <ansatz/collision/broadphase/binary_split.hpp>
#include <ansatz/collision/broadphase/bounding_boxes.hpp>
#include <ansatz/collision/broadphase/coherent.hpp>
#include <ansatz/collision/broadphase/octree.hpp>
#include <ansatz/collision/broadphase/sort_and_sweep.hpp>
#include <ansatz/collision/broadphase/uniform_grid.hpp>
#include <ansatz/collision/filter/layers.hpp>
#include <ansatz/collision/response/impulse.hpp>
#include <ansatz/collision/response/penalty.hpp>
#include <ansatz/collision/response/projection.hpp>
#include <ansatz/collision/response/soft_substeps.hpp>
#include <ansatz/motion/applied_forces.hpp>
#include <ansatz/motion/attraction.hpp>
#include <ansatz/motion/drag.hpp>
#include <ansatz/motion/frame_drag.hpp>
#include <ansatz/motion/gravity.hpp>
#include <ansatz/motion/integrators/explicit_euler.hpp>
#include <ansatz/motion/integrators/implicit_euler.hpp>
#include <ansatz/motion/integrators/runge_kutta4.hpp>
#include <ansatz/motion/integrators/semi_implicit_euler.hpp>
#include <ansatz/motion/integrators/velocity_verlet.hpp>
#include <ansatz/motion/integrators/verlet.hpp>
#include <ansatz/motion/quadratic_drag.hpp>
#include <ansatz/motion/rest.hpp>
#include <ansatz/motion/stop_below.hpp>
#include <ansatz/soft_bodies/area.hpp>
#include <ansatz/soft_bodies/bending.hpp>
#include <ansatz/soft_bodies/pressure.hpp>
#include <ansatz/soft_bodies/wind.hpp>
#include <ansatz/springs/springs.hpp>
#include <ansatz/water/buoyancy.hpp>
#include <ansatz/water/surface_contacts.hpp>

namespace ansatz {

static_assert(BroadphaseIn<AllPairs, Space<>> && BroadphaseIn<AllPairs, Space<float, 2>> &&
              !detail::needs_boxes<AllPairs>);
static_assert(BroadphaseIn<BinarySplit<>, Space<>> && BroadphaseIn<BinarySplit<SortAndSweep>, Space<float, 2>>);
static_assert(BroadphaseIn<BoundingBoxes, Space<>> && InsideIn<BoundingBoxes, Space<>> &&
              InsideIn<BoundingBoxes, Space<float, 2>>);
static_assert(BroadphaseIn<Coherent<>, Space<>> && BroadphaseIn<Coherent<SortAndSweep>, Space<float, 2>>);
static_assert(BroadphaseIn<Octree<>, Space<>> && BroadphaseIn<Octree<SortAndSweep>, Space<float, 2>>);
static_assert(BroadphaseIn<SortAndSweep, Space<>> && InsideIn<SortAndSweep, Space<>> &&
              InsideIn<SortAndSweep, Space<float, 2>>);
static_assert(BroadphaseIn<UniformGrid<>, Space<>> && BroadphaseIn<UniformGrid<SortAndSweep>, Space<float, 2>>);
static_assert(FilterIn<Layers, Space<>> && FilterIn<Layers, Space<float, 2>>);
static_assert(ResponseIn<Impulse<>, Space<>> && ResponseIn<Impulse<Friction>, Space<float, 2>>);
static_assert(DifferentiableCouplingIn<Penalty, Space<>> && DifferentiableCouplingIn<Penalty, Space<float, 2>>);
static_assert(ResponseIn<Penalty, Space<>> && ResponseIn<Penalty, Space<float, 2>>);
static_assert(ResponseIn<Projection, Space<>> && ResponseIn<Projection, Space<float, 2>>);
static_assert(ResponseIn<SoftSubsteps<>, Space<>> && ResponseIn<SoftSubsteps<Friction>, Space<float, 2>>);
static_assert(LawIn<AppliedForces, Space<>>);
static_assert(CouplingIn<Attraction, Space<>>);
static_assert(DifferentiableCouplingIn<Area, Space<>> && CurvedConstraintIn<AreaConstraint<Space<>>, Space<>> &&
              CurvedConstraintIn<AreaConstraint<Space<float, 2>>, Space<float, 2>>);
static_assert(DifferentiableCouplingIn<Bending, Space<>> && GatheredCouplingIn<Bending, Space<>> &&
              CurvedConstraintIn<HingeConstraint<Space<>>, Space<>>);
static_assert(DifferentiableCouplingIn<Pressure, Space<>> && GivesConstraints<Pressure, Space<float, 3>>);
static_assert(DifferentiableCouplingIn<Wind, Space<>> && GatheredCouplingIn<Wind, Space<>> &&
              !GivesConstraints<Wind, Space<>>);
static_assert(WideConstraintIn<PressureConstraint<Space<>>, Space<>> &&
              !ConstraintIn<PressureConstraint<Space<>>, Space<>>);
static_assert(EffectIn<Drag, Space<>>);
static_assert(EffectIn<FrameDrag, Space<>>);
static_assert(LawIn<Gravity, Space<>>);
static_assert(StagedIntegratorIn<ExplicitEuler, Space<>>);
static_assert(SolvingIntegratorIn<ImplicitEuler, Space<>>);
static_assert(StagedIntegratorIn<RungeKutta4, Space<>>);
static_assert(StagedIntegratorIn<SemiImplicitEuler, Space<>>);
static_assert(StagedIntegratorIn<VelocityVerlet, Space<>>);
static_assert(StagedIntegratorIn<Verlet, Space<>>);
static_assert(LawIn<QuadraticDrag, Space<>>);
static_assert(EffectIn<Rest, Space<>>);
static_assert(EffectIn<StopBelow, Space<>>);
static_assert(DifferentiableCouplingIn<Buoyancy, Space<>> && DifferentiableCouplingIn<Buoyancy, Space<float, 2>>);
static_assert(DifferentiableCouplingIn<SurfaceContacts, Space<>> &&
              DifferentiableCouplingIn<SurfaceContacts, Space<float, 2>>);
static_assert(CouplingIn<Springs<>, Space<>> && CouplingIn<Ropes<Breaking>, Space<float, 2>>);

} // namespace ansatz
